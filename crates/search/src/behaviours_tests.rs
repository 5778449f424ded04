//! Against all histories, one by one, of a drive that slows down while it is told to; and with memories that do not show at once.

use std::collections::{BTreeMap, BTreeSet};
use std::convert::Infallible;

use super::decided::{DecisionLimits, held_for};
use super::stays::{Stays, Transitions};
use super::walks::{Style, Walked, walk};
use super::*;
use crate::rng::Rng;
use crate::tracks::{Watch, explore};

/// What a drive remembers besides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Memory {
    Nothing,
    /// From this many times on it is told in vain.
    Count(u32),
    /// From so many steps on.
    Clock(u32),
    /// If it was told twice within so many steps, the third time.
    Hurry(u32),
    /// If it was told for longer than so many steps at once, the next time.
    Long(u32),
    /// If it was told at this phase, the next time.
    Phase(u32),
}

/// A drive goes round in `PERIOD` steps at full speed, and is told to stop by reading 1.
#[derive(Clone)]
struct Drive(Memory);

const PERIOD: u32 = 30;
const FULL: u32 = 4;
const REACTION: u32 = 2;

#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct State {
    at: u32,
    speed: u32,
    told_for: u32,
    // The rest is memory.
    times: u32,
    steps: u32,
    since_told: u32,
    marked: bool,
    in_vain: bool,
}

impl Drive {
    fn after(&self, before: &State, reading: usize) -> State {
        let mut state = before.clone();
        let told = reading == 1;
        let is_edge = told && state.told_for == 0;
        if self.0 != Memory::Nothing {
            state.steps = (state.steps + 1).min(100_000);
            state.times += u32::from(is_edge);
            match self.0 {
                Memory::Hurry(within) if is_edge => {
                    state.in_vain = state.marked && state.since_told < within;
                    state.marked = state.since_told < within;
                }
                Memory::Long(_) | Memory::Phase(_) if is_edge => state.in_vain = state.marked,
                _ => {}
            }
            match self.0 {
                Memory::Count(most) => state.in_vain = state.times >= most,
                Memory::Clock(until) => state.in_vain = state.steps >= until,
                Memory::Long(most) if told => state.marked = state.told_for >= most,
                Memory::Phase(phase) if is_edge => state.marked = state.at == phase,
                _ => {}
            }
            state.since_told = if is_edge { 0 } else { (state.since_told + 1).min(1000) };
        }
        state.told_for = if told { (state.told_for + 1).min(1000) } else { 0 };
        let slows = state.told_for > REACTION && !state.in_vain;
        state.speed = if slows { state.speed.saturating_sub(1) } else { (state.speed + 1).min(FULL) };
        state.at = (state.at + state.speed) % (PERIOD * FULL);
        if self.0 == Memory::Nothing {
            state.told_for = state.told_for.min(REACTION + 1);
        }
        state
    }

    const START: State =
        State { at: 0, speed: FULL, told_for: 0, times: 0, steps: 0, since_told: 1000, marked: false, in_vain: false };
}

impl Machine for Drive {
    type State = State;
    type Error = Infallible;

    fn readings(&self) -> usize {
        2
    }

    fn alike(&self, one: OutputClass, other: OutputClass) -> bool {
        one == other
    }

    fn switches(&self, _: OutputClass, _: [OutputClass; 3]) -> bool {
        false
    }

    fn begin(&mut self) -> Result<(State, OutputClass), Infallible> {
        Ok((Self::START, shown(&Self::START)))
    }

    fn hold_each(&mut self, holds: &[Hold<'_, State>]) -> Result<AllHeld<State>, Infallible> {
        let mut ended: Vec<Held<State>> = Vec::new();
        for Hold { from, reading, steps, last } in holds {
            let mut state = match from {
                Begins::At(state) => (*state).clone(),
                Begins::After(number) => ended[*number].1.clone(),
            };
            let mut all = Vec::new();
            for _ in 0..*steps {
                state = self.after(&state, *reading);
                all.push(shown(&state));
            }
            all.drain(..if *last { all.len() - 1 } else { 0 });
            ended.push((all, state));
        }
        Ok(Some(ended))
    }
}

/// Where it is and how fast.
const fn shown(state: &State) -> OutputClass {
    state.at * (FULL + 1) + state.speed
}

const EXTENT: Extent<'static> = Extent { held: &[12; 2], steps: usize::MAX, most: 100_000 };

fn found(memory: Memory, extent: Extent<'_>) -> Behaviours {
    find(&mut Drive(memory), extent, &mut |_| ControlFlow::Continue(())).unwrap()
}

/// Every history of so many steps, as exact states: each shows what its behaviour does. There are no more behaviours than there are states
/// of the drive, and no fewer than it shows different things.
#[test]
fn every_history_does_what_its_behaviour_says() {
    let behaviours = found(Memory::Nothing, EXTENT);
    assert_eq!(behaviours.ended, BehaviourSearchEnd::Closed);
    let mut layer = BTreeMap::from([(Drive::START, BTreeSet::from([0]))]);
    let mut all: BTreeSet<State> = BTreeSet::new();
    for _ in 0..400 {
        let mut next: BTreeMap<State, BTreeSet<Number>> = BTreeMap::new();
        for (state, numbers) in layer {
            for reading in 0..2 {
                let after = Drive(Memory::Nothing).after(&state, reading);
                for number in &numbers {
                    let number = behaviours.next(*number, reading).unwrap();
                    assert_eq!(behaviours.shown(number), shown(&after));
                    next.entry(after.clone()).or_default().insert(number);
                }
            }
        }
        // One state is one behaviour, however it was come to.
        assert!(next.values().all(|numbers| numbers.len() == 1));
        all.extend(next.keys().cloned());
        layer = next;
    }
    // Some states differ in what never shows: how long a drive that stands has been told to.
    let differ: BTreeSet<OutputClass> = all.iter().map(shown).collect();
    assert!(
        differ.len() < behaviours.count() && behaviours.count() <= all.len(),
        "{} {}",
        behaviours.count(),
        all.len()
    );
    let number = u32::try_from(behaviours.count() / 2).unwrap();
    let mut state = Drive::START;
    for reading in behaviours.way_to(number) {
        state = Drive(Memory::Nothing).after(&state, reading);
    }
    assert_eq!(shown(&state), behaviours.shown(number));
}

/// Behaviours up to some step are those that so many steps lead to.
#[test]
fn a_search_may_end_before_all_are_found() {
    let all = found(Memory::Nothing, EXTENT);
    let some = found(Memory::Nothing, Extent { steps: 5, ..EXTENT });
    assert_eq!(some.ended, BehaviourSearchEnd::Steps);
    let near = (0..u32::try_from(all.count()).unwrap()).filter(|number| all.depth(*number) <= 5).count();
    assert_eq!(some.count(), near);
    assert_eq!(found(Memory::Nothing, Extent { most: 50, ..EXTENT }).ended, BehaviourSearchEnd::Most);
    let asked = find(&mut Drive(Memory::Nothing), EXTENT, &mut |_| ControlFlow::Break(())).unwrap();
    assert_eq!(asked.ended, BehaviourSearchEnd::Asked);
}

/// The first style of which a walk shows that the machine does something else.
fn caught(memory: Memory, extent: Extent<'_>, walks: usize, steps: usize) -> Option<Style> {
    let behaviours = found(memory, extent);
    if behaviours.ended != BehaviourSearchEnd::Closed {
        return Some(Style::EveryStep);
    }
    let mut rng = Rng::new(5);
    let each = (0..walks).flat_map(|number| Style::ALL.map(|style| (style, number)));
    let mut caught = each.filter(|(style, number)| {
        let readings = style.drawn(&mut rng, &any(2), *number, (longest(extent.held), steps));
        matches!(walk(&mut Drive(memory), &behaviours, &readings).unwrap(), Walked::Unlike { .. })
    });
    caught.next().map(|(style, _)| style)
}

/// Memories that do not show while one reading is held. What takes longer to show than walks are long is not found.
#[test]
fn walks_find_memories_that_behaviours_do_not_have() {
    assert_eq!(caught(Memory::Nothing, EXTENT, 20, 400), None);
    for memory in [
        Memory::Count(4),
        Memory::Count(20),
        Memory::Count(150),
        Memory::Clock(50),
        Memory::Clock(350),
        Memory::Hurry(3),
        Memory::Hurry(10),
        Memory::Long(11),
        Memory::Long(100),
        Memory::Phase(0),
        Memory::Phase(77),
    ] {
        assert!(caught(memory, EXTENT, 20, 400).is_some(), "{memory:?}");
    }
    assert_eq!(caught(Memory::Count(5_000), EXTENT, 5, 400), None);
}

/// A corridor of one unwatched cell, three watched ones, and one behind; who walks in it takes a cell a step.
struct Corridor;

/// Where a way comes from, where it leads, and whether nobody was ever seen.
const WAYS: [(usize, &[(usize, usize)]); 4] = [
    // Unseen in front, until one comes into the watched part.
    (0, &[(1, 0)]),
    // Watched, from the front: out again at once, or behind after three cells.
    (1, &[(2, 0), (3, 2)]),
    // In front again.
    (0, &[(1, 0)]),
    // Behind.
    (0, &[(1, 0)]),
];

impl Transitions for Corridor {
    fn begins(&self) -> Vec<usize> {
        vec![0]
    }

    fn ways(&self) -> usize {
        WAYS.len()
    }

    fn reading(&self, way: usize) -> usize {
        WAYS[way].0
    }

    fn next(&self, way: usize) -> &[(usize, usize)] {
        WAYS[way].1
    }

    fn is_unchanged(&self, way: usize) -> bool {
        way == 0
    }
}

/// The same with every history of its own, and what behaviour that leads to.
struct Every<'a>(&'a Behaviours);

impl Watch for Every<'_> {
    type State = (State, Number);
    type Error = Infallible;

    fn begins(&self) -> Vec<usize> {
        Corridor.begins()
    }

    fn start(&mut self) -> Result<(State, Number), Infallible> {
        Ok((Drive::START, 0))
    }

    fn step(&mut self, (state, number): &(State, Number), way: usize) -> Result<Option<(State, Number)>, Infallible> {
        let reading = WAYS[way].0;
        Ok(Some((Drive(Memory::Nothing).after(state, reading), self.0.next(*number, reading).unwrap())))
    }

    fn next(&self, way: usize) -> &[(usize, usize)] {
        WAYS[way].1
    }
}

/// Whatever tracks come to within so many steps has stayed no longer than told; and where stays end soon, some stay as long.
#[test]
fn stays_are_at_least_those_of_every_history() {
    const MOST: u32 = 40;
    let behaviours = found(Memory::Nothing, EXTENT);
    let stays = Stays::find(&behaviours, &Corridor, MOST);
    let (mut looked_at, mut as_long) = (0, 0);
    explore(&mut Every(&behaviours), 60, 60, &mut |_, taken| {
        // A step later, as the state is the one after it.
        let stay = stays.of(taken.state.1, taken.way).unwrap();
        let lasting = taken.lasting;
        let [steps, since_first] = [lasting.steps + 1, lasting.since_first + lasting.changes.min(1)]
            .map(|steps| u32::try_from(steps).unwrap().min(MOST));
        assert!(steps <= stay.steps && since_first <= stay.since_first, "{taken:?} {stay:?}");
        looked_at += 1;
        as_long += usize::from(steps == stay.steps);
        true
    })
    .unwrap();
    assert!(looked_at > 10_000 && 4 * as_long > looked_at, "{as_long} of {looked_at}");
}

/// A drive that a curtain (reading 2) stops only once a mat (readings 1 and 2) has muted it for so many steps.
struct Muted;

const MUTES: u32 = 40;

impl Machine for Muted {
    type State = (u32, u32);
    type Error = Infallible;

    fn readings(&self) -> usize {
        3
    }

    fn alike(&self, one: OutputClass, other: OutputClass) -> bool {
        one == other
    }

    fn switches(&self, _: OutputClass, _: [OutputClass; 3]) -> bool {
        false
    }

    fn begin(&mut self) -> Result<((u32, u32), OutputClass), Infallible> {
        Ok(((0, 0), 0))
    }

    fn hold_each(&mut self, holds: &[Hold<'_, (u32, u32)>]) -> Result<AllHeld<(u32, u32)>, Infallible> {
        let mut ended: Vec<Held<(u32, u32)>> = Vec::new();
        for hold in holds {
            let (mut at, mut muted) = match hold.from {
                Begins::At(state) => *state,
                Begins::After(number) => ended[number].1,
            };
            let mut all = Vec::new();
            for _ in 0..hold.steps {
                muted = if hold.reading == 0 { 0 } else { MUTES.min(muted + 1) };
                at = if hold.reading == 2 && muted == MUTES { at } else { (at + 1) % PERIOD };
                all.push(at);
            }
            all.drain(..if hold.last { all.len() - 1 } else { 0 });
            ended.push((all, (at, muted)));
        }
        Ok(Some(ended))
    }
}

/// Where each reading is held as long as it takes to show what it alone shows, behaviours are the same as where all are held as long.
#[test]
fn only_what_shows_late_is_held_for_long() {
    let question = DecisionLimits { step_s: 0.02, steps: 400, most: 100_000, times_held: 1 };
    let (shows, held) = held_for(&mut Muted, question, &mut Rng::new(1)).unwrap().unwrap();
    assert!(held[2] >= 40 && held[..2] == [25; 2], "{shows:?} {held:?}");
    let count = |held: &[usize]| {
        let extent = Extent { held, steps: usize::MAX, most: 100_000 };
        let found = find(&mut Muted, extent, &mut |_| ControlFlow::Continue(())).unwrap();
        assert_eq!(found.ended, BehaviourSearchEnd::Closed);
        found.count()
    };
    assert!(count(&held) == count(&[60; 3]) && count(&[25; 3]) < count(&held), "{held:?}");
}
