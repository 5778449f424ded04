//! A net of behaviours, for machines that hardly ever come back to the same: ramps and cycles that are no multiples of a step, filters.
//!
//! Where a reading changes, states are taken for one that are no farther apart than a width, now and while any one reading is held. While
//! it stays, the machine is followed as it is: merging at every step would hold up whatever moves by less than a width in a step. Only
//! what has come a long way since may go on as another does that is no farther away, and what comes back to the same as before does.
//!
//! What is found stands for what there is but for some widths, if differences do not grow from change to change. [`covers`](super::covers) tries out how far
//! anything is from what is found.

use std::collections::{BTreeMap, VecDeque};
use std::ops::ControlFlow;

use super::{Begins, BehaviourSearchEnd, Behaviours, Extent, Hold, Machine, NONE, Number, OutputClass};

/// A machine of which can be told how far apart two things are that it shows.
pub trait Measured: Machine {
    /// The state at the start, and what it shows.
    ///
    /// # Errors
    /// When it cannot be begun.
    fn begin_rows(&mut self) -> Result<(Self::State, Vec<f64>), Self::Error>;

    /// [`Machine::hold_each`] with what is shown in full, a row for each step.
    ///
    /// # Errors
    /// When the machine cannot go on at all.
    fn rows_each(&mut self, holds: &[Hold<'_, Self::State>]) -> Result<Option<AllRows<Self::State>>, Self::Error>;

    /// Numbers in a row.
    fn columns(&self) -> usize;

    /// What tells a row apart from others, in widths of the net: two are as far apart as the most by which any of these differs.
    fn traits(&self, row: &[f64]) -> Vec<f32>;

    /// Some of these that differ most.
    fn place(&self, traits: &[f32]) -> [f32; 3];

    /// The number of a row, or of another that is a part of a width from it.
    fn number(&mut self, row: &[f64], traits: &[f32]) -> OutputClass;

    /// Of those numbers that count and are no farther away than so the one that says most nearly what the machine does, and how nearly, in
    /// widths.
    fn nearest(&self, traits: &[f32], widths: f32, counts: &dyn Fn(OutputClass) -> bool) -> Option<(OutputClass, f32)>;

    /// By how much what is shown is off from what a row says, in the machine's own measures, and how fast it is by what is shown; nothing
    /// if they cannot be compared.
    fn off(&self, row: &[f64], shown: OutputClass) -> Option<(f64, [f64; 2])>;
}

/// Rows, one after the other, and the state after the last, of several holds.
pub type AllRows<S> = Vec<(Vec<f64>, S)>;

/// No farther apart than this is the same, in widths.
const SAME: f32 = 1e-4;
/// Whatever has come so far since it began may go on as something else does, in widths.
const FAR: f32 = 10.0;
/// So many runs are gone on with at once.
const AT_ONCE: usize = 48;
/// Nothing is looked for farther away, in widths.
pub(super) const FARTHEST: f32 = 5.0;

/// Somewhere in a run: a reading is held.
struct Open<S> {
    number: Number,
    reading: usize,
    state: S,
    now: Instant,
    /// What is shown in the next steps, all but one of those that are looked ahead, and the state after the last of them; nothing at its
    /// beginning.
    ahead: VecDeque<Instant>,
    tip: Option<S>,
    age: usize,
    /// How far it has come, in widths.
    way: f32,
    /// What the one before shows and does.
    before: Option<Traits>,
}

/// Which readings may come next, and then the traits of what is shown now, and after some steps while each of these is held, one after the
/// other.
type Traits = Box<[f32]>;

/// A row and its traits.
struct Instant {
    row: Vec<f64>,
    traits: Vec<f32>,
}

/// Finds a net of behaviours.
///
/// # Errors
/// What the machine reports.
pub fn find<M: Measured>(
    machine: &mut M,
    extent: Extent<'_>,
    tell: &mut dyn FnMut(usize) -> ControlFlow<()>,
) -> Result<Behaviours, M::Error> {
    let mut search = Search::new(machine, extent);
    let ended = search.run(tell)?;
    Ok(Behaviours { ended, ..search.found })
}

struct Search<'a, M: Measured> {
    machine: &'a mut M,
    extent: Extent<'a>,
    /// After how many steps what is shown is compared, by reading.
    compared: Vec<[usize; 3]>,
    found: Behaviours,
    /// States that others are taken for, and what they show and do; by place.
    known: Vec<(Number, Traits)>,
    places: BTreeMap<[i64; 3], Vec<u32>>,
    /// By number, in which run it is, and how old that was.
    runs: Vec<(u32, u32)>,
    /// Of each run, its reading, and how old it is, or for ever where it stays as it is.
    ages: Vec<(usize, u32)>,
}

/// What a machine answers to several holds.
type Answers<'a, S> = dyn Iterator<Item = (Vec<f64>, S)> + 'a;

impl<'a, M: Measured> Search<'a, M> {
    fn new(machine: &'a mut M, extent: Extent<'a>) -> Self {
        let found = Behaviours::none(machine.others());
        // Two at least to tell a state from the one after it.
        let compared = extent.held.iter().map(|held| [1, (held / 3).max(2), *held.max(&3)]).collect();
        Self {
            machine,
            extent,
            compared,
            found,
            known: Vec::new(),
            places: BTreeMap::new(),
            runs: vec![(0, 0)],
            ages: vec![(0, 0)],
        }
    }

    fn run(&mut self, tell: &mut dyn FnMut(usize) -> ControlFlow<()>) -> Result<BehaviourSearchEnd, M::Error> {
        let (state, now) = self.machine.begin_rows()?;
        let now = self.instant(now);
        let shown = self.machine.number(&now.row, &now.traits);
        let first = self.found.add(shown, None);
        let mut open = VecDeque::new();
        let mut holds = Vec::new();
        let coming = self.found.coming(0).1.to_vec();
        coming.iter().for_each(|reading| self.look_ahead(&state, *reading, &mut holds));
        let Some(held) = self.machine.rows_each(&holds)? else { return Ok(BehaviourSearchEnd::Unfinished) };
        let mut held = held.into_iter();
        let ahead: Vec<_> = coming.iter().filter_map(|_| self.ahead(&mut held)).collect();
        let rows = ahead.iter().flat_map(|ahead| &ahead.rows);
        let traits = std::iter::once(&now).chain(rows).flat_map(|instant| &instant.traits).copied();
        let traits = std::iter::once(self.among(0)).chain(traits).collect();
        self.know(first, &now, traits);
        for (reading, ahead) in coming.into_iter().zip(ahead) {
            open.push_back(self.begin_run(first, reading, ahead));
        }
        while !open.is_empty() {
            if tell(self.found.count()).is_break() {
                return Ok(BehaviourSearchEnd::Asked);
            }
            // The oldest runs first: later ones go on as these do.
            open.make_contiguous().sort_by_key(|one: &Open<M::State>| self.runs[one.number as usize].0);
            let some: Vec<Open<M::State>> = open.drain(..AT_ONCE.min(open.len())).collect();
            let Some(held) = self.machine.rows_each(&self.holds(&some))? else {
                return Ok(BehaviourSearchEnd::Unfinished);
            };
            let mut held = held.into_iter();
            for one in some {
                if self.found.depth(one.number) == self.extent.steps {
                    return Ok(BehaviourSearchEnd::Steps);
                }
                self.step(one, &mut held, &mut open);
                if self.found.count() > self.extent.most {
                    return Ok(BehaviourSearchEnd::Most);
                }
            }
        }
        Ok(BehaviourSearchEnd::Closed)
    }

    /// What is asked of some states in runs.
    fn holds<'b>(&self, some: &'b [Open<M::State>]) -> Vec<Hold<'b, M::State>> {
        let mut holds = Vec::new();
        for Open { reading, state, tip, .. } in some {
            let (reading, from) = (*reading, Begins::At(state));
            holds.push(Hold { from, reading, steps: 1, last: true });
            holds.push(match tip {
                Some(tip) => Hold { from: Begins::At(tip), reading, steps: 1, last: false },
                None => Hold { from: Begins::At(state), reading, steps: self.compared[reading][2], last: false },
            });
            self.found.others[reading].iter().for_each(|other| self.look_ahead(state, *other, &mut holds));
        }
        holds
    }

    /// What is asked of a state and a reading: how it goes on from there.
    fn look_ahead<'b>(&self, state: &'b M::State, reading: usize, holds: &mut Vec<Hold<'b, M::State>>) {
        let mut before = 0;
        for steps in self.compared[reading] {
            let from = if before == 0 { Begins::At(state) } else { Begins::After(holds.len() - 1) };
            holds.push(Hold { from, reading, steps: steps - before, last: true });
            before = steps;
        }
    }

    /// Takes in what was asked of a state in a run.
    fn step(&mut self, mut one: Open<M::State>, held: &mut Answers<'_, M::State>, open: &mut VecDeque<Open<M::State>>) {
        let (Some((_, state)), Some((rows, tip))) = (held.next(), held.next()) else { return };
        one.ahead.extend(rows.chunks(self.machine.columns()).map(|row| self.instant(row.to_vec())));
        let others: Vec<(usize, Ahead<M::State>)> =
            self.found.others[one.reading].iter().filter_map(|other| Some((*other, self.ahead(held)?))).collect();
        let mut traits = vec![self.among(one.reading)];
        traits.extend(&one.now.traits);
        for reading in self.found.coming(one.reading).1 {
            match others.iter().find(|(other, _)| other == reading) {
                Some((_, ahead)) => ahead.rows.iter().for_each(|instant| traits.extend(&instant.traits)),
                None => self.compared[*reading].iter().for_each(|step| traits.extend(&one.ahead[step - 1].traits)),
            }
        }
        let traits: Traits = traits.into();
        let near = self.nearest(&one.now, &traits);
        match near {
            Some((known, _)) => {
                for (other, _) in &others {
                    self.found.merged += 1;
                    self.found.follow(one.number, *other, self.found.next(known, *other).unwrap_or(NONE));
                }
            }
            None => {
                self.know(one.number, &one.now, traits.clone());
                for (other, ahead) in others {
                    open.push_back(self.begin_run(one.number, other, ahead));
                }
            }
        }
        if one.before.as_ref().is_some_and(|before| apart(before, &traits, SAME).is_some()) {
            // It stays as it is.
            self.found.follow(one.number, one.reading, one.number);
            self.ages[self.runs[one.number as usize].0 as usize].1 = u32::MAX;
            return;
        }
        let next = near.and_then(|(known, apart)| Some((self.found.next(known, one.reading)?, apart)));
        let goes_on = |(next, apart): &(Number, f32)| *apart <= SAME || FAR * apart <= one.way && self.lasts(*next);
        if let Some((next, _)) = next.filter(goes_on) {
            self.found.merged += 1;
            self.found.follow(one.number, one.reading, next);
            return;
        }
        open.extend(self.go_on(one, traits, (state, tip)));
    }

    /// Whether a run is known for as long as is looked ahead after that.
    fn lasts(&self, number: Number) -> bool {
        let (run, age) = self.runs[number as usize];
        let (reading, lasted) = self.ages[run as usize];
        (lasted - age) as usize >= self.extent.held[reading]
    }

    /// A run a step later.
    fn go_on(
        &mut self,
        mut one: Open<M::State>,
        traits: Traits,
        (state, tip): (M::State, M::State),
    ) -> Option<Open<M::State>> {
        let now = one.ahead.pop_front()?;
        let way = one.way + apart(&one.now.traits, &now.traits, 1.0).unwrap_or(1.0);
        let shown = self.machine.number(&now.row, &now.traits);
        let number = self.found.add(shown, Some((one.number, one.reading)));
        let (run, age) = self.runs[one.number as usize];
        self.runs.push((run, age + 1));
        self.ages[run as usize].1 = age + 1;
        Some(Open { number, state, now, tip: Some(tip), age: one.age + 1, way, before: Some(traits), ..one })
    }

    /// A run that begins with a reading after a state.
    fn begin_run(&mut self, from: Number, reading: usize, ahead: Ahead<M::State>) -> Open<M::State> {
        let Ahead { rows: [now, ..], state } = ahead;
        let shown = self.machine.number(&now.row, &now.traits);
        let number = self.found.add(shown, Some((from, reading)));
        #[expect(clippy::cast_possible_truncation, reason = "fewer than are allowed")]
        self.runs.push((self.ages.len() as u32, 0));
        self.ages.push((reading, 0));
        Open { number, reading, state, now, ahead: VecDeque::new(), tip: None, age: 0, way: 0.0, before: None }
    }

    /// Which readings may come next after one, as a trait.
    #[expect(clippy::cast_precision_loss, reason = "a few readings")]
    fn among(&self, reading: usize) -> f32 {
        FARTHEST * self.found.coming(reading).0 as f32
    }

    fn instant(&self, row: Vec<f64>) -> Instant {
        let traits = self.machine.traits(&row);
        Instant { row, traits }
    }

    fn ahead(&self, held: &mut Answers<'_, M::State>) -> Option<Ahead<M::State>> {
        let ((first, state), (second, _), (third, _)) = (held.next()?, held.next()?, held.next()?);
        Some(Ahead { rows: [first, second, third].map(|row| self.instant(row)), state })
    }

    fn know(&mut self, number: Number, now: &Instant, traits: Traits) {
        let place = cell(self.machine.place(&now.traits), 1.0);
        #[expect(clippy::cast_possible_truncation, reason = "fewer than are allowed")]
        self.places.entry(place).or_default().push(self.known.len() as u32);
        self.known.push((number, traits));
    }

    /// The nearest that is known, no farther away than a width.
    fn nearest(&self, now: &Instant, traits: &Traits) -> Option<(Number, f32)> {
        let mut nearest: Option<(Number, f32)> = None;
        let [x, y, z] = cell(self.machine.place(&now.traits), 1.0);
        for (x, y) in (x - 1..=x + 1).flat_map(|x| (y - 1..=y + 1).map(move |y| (x, y))) {
            for known in self.places.range([x, y, z - 1]..=[x, y, z + 1]).flat_map(|(_, known)| known) {
                let (number, its) = &self.known[*known as usize];
                let most = nearest.map_or(1.0, |(_, apart)| apart);
                if let Some(apart) = apart(its, traits, most)
                    && nearest.is_none_or(|(known, least)| apart < least || (apart <= least && *number < known))
                {
                    nearest = Some((*number, apart));
                }
            }
        }
        nearest
    }
}

/// What a state does while a reading is held.
struct Ahead<S> {
    /// What is shown after each number of steps that is compared.
    rows: [Instant; 3],
    /// The state after the first.
    state: S,
}

/// How far apart traits are, if that is no more than so.
#[must_use]
pub fn apart(one: &[f32], other: &[f32], most: f32) -> Option<f32> {
    let mut farthest = 0.0_f32;
    for (one, other) in one.chunks(16).zip(other.chunks(16)) {
        for (one, other) in one.iter().zip(other) {
            farthest = farthest.max((one - other).abs());
        }
        if farthest > most {
            return None;
        }
    }
    Some(farthest)
}

/// The cell of this size that a place is in.
#[must_use]
#[expect(clippy::cast_possible_truncation, reason = "some thousand widths")]
pub fn cell(place: [f32; 3], size: f32) -> [i64; 3] {
    place.map(|at| (at / size).floor() as i64)
}

#[cfg(test)]
#[path = "net_tests.rs"]
mod tests;
