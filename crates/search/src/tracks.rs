//! Everything that something may do whose inputs are one of a few *readings* at each step, where what reads so is a thing that
//! moves: between two readings it takes as many steps as the way between them does.
//!
//! A *track* is a state, the present reading, how it was come to, and for how many steps it has lasted. What moves may be
//! wherever it gets in that time from where the reading before it ends; that is for others to know. Here only steps are
//! counted: a reading lasts at least as long as the shortest way through it to the next one. Tracks of the same state that
//! came to the same reading the same way are one: the one that has lasted longest may be wherever the others may.
//!
//! How often the reading changes may be limited. Where the limit is never met, there is none.

use std::collections::BTreeMap;

/// What moves through readings, and what is stepped with them.
pub trait Watch {
    /// Everything that what comes depends on, but for readings.
    type State: Clone + Ord;
    /// What went wrong.
    type Error;

    /// How a run begins: by its number, the ways to come to readings at the very start.
    fn begins(&self) -> Vec<usize>;

    /// The state at the start.
    ///
    /// # Errors
    /// What makes all of it pointless.
    fn start(&mut self) -> Result<Self::State, Self::Error>;

    /// The state after a step that begins with the reading which `way` leads to; `None` if it could not be finished.
    ///
    /// # Errors
    /// What makes all of it pointless.
    fn step(&mut self, state: &Self::State, way: usize) -> Result<Option<Self::State>, Self::Error>;

    /// Other readings that may follow one that was come to in this way: the way there, and for how many steps the present one
    /// has lasted at least, where 0 is for its first instant.
    fn next(&self, way: usize) -> &[(usize, usize)];

    /// Whether the reading changes on a way; else something is done where it stays the same.
    fn changes(&self, _way: usize) -> bool {
        true
    }

    /// Ways that may be come to at the very sample at which this one was, and on which the reading does not change.
    fn at_once(&self, _way: usize) -> &[usize] {
        &[]
    }

    /// The state with which a way is come to before a step of this number; `None` if that cannot be.
    fn enters(&mut self, state: &Self::State, _way: usize, _step: usize) -> Option<Self::State> {
        Some(state.clone())
    }

    /// What else the state before a step of this number may be, by what others do then than whatever moves.
    fn others(&mut self, _state: &Self::State, _step: usize) -> Vec<Self::State> {
        Vec::new()
    }
}

/// What is known of a track besides its state and its way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Lasting {
    /// Steps since the reading began, 0 for the first instant: the most that there is.
    pub steps: usize,
    /// Changes of the reading before: the fewest that there are.
    pub changes: usize,
    /// Steps since the reading first changed, 0 for the first instant after that: the most that there are. 0 where it never did.
    pub since_first: usize,
}

/// A step that may be taken.
#[derive(Debug)]
pub struct PossibleStep<'a, S> {
    /// Number of the step, from 1.
    pub step: usize,
    /// The state after it.
    pub state: &'a S,
    /// How the reading that it begins with was come to.
    pub way: usize,
    /// For how long that had lasted when it began.
    pub lasting: Lasting,
}

/// What came out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct TrackSearch {
    /// Steps of different tracks.
    pub taken: u64,
    /// Those that could not be finished.
    pub unfinished: u64,
    /// Changes that the limit left out.
    pub left_out: u64,
    /// Whether it was told to end early.
    pub ended: bool,
}

/// Takes `steps` steps on every track whose reading changes at most `changes` times, and tells of each; ends early where `tell`
/// says `false`.
///
/// # Errors
/// What the states' steps report.
pub fn explore<W: Watch>(
    watch: &mut W,
    steps: usize,
    changes: usize,
    tell: &mut dyn FnMut(&mut W, &PossibleStep<'_, W::State>) -> bool,
) -> Result<TrackSearch, W::Error> {
    let mut outcome = TrackSearch::default();
    let start = watch.start()?;
    let mut layer = Layer::default();
    for way in watch.begins() {
        let first = Lasting { steps: 0, changes: 0, since_first: 0 };
        layer.arrive(watch, (&start, way), first, 1);
    }
    for step in 1..=steps {
        let mut next = Layer::default();
        for ((state, way), lasting) in layer.with_others(watch, step) {
            outcome.taken += 1;
            let Some(state) = watch.step(&state, way)? else {
                outcome.unfinished += 1;
                continue;
            };
            if !tell(watch, &PossibleStep { step, state: &state, way, lasting }) {
                outcome.ended = true;
                return Ok(outcome);
            }
            let since_first = if lasting.changes == 0 { 0 } else { lasting.since_first + 1 };
            next.keep((state.clone(), way), Lasting { steps: lasting.steps + 1, since_first, ..lasting });
            let follow: Vec<usize> =
                watch.next(way).iter().filter(|(_, least)| *least <= lasting.steps).map(|(other, _)| *other).collect();
            for other in follow {
                let changed = usize::from(watch.changes(other));
                if lasting.changes + changed > changes {
                    outcome.left_out += 1;
                    continue;
                }
                let lasting = Lasting { steps: 0, changes: lasting.changes + changed, since_first };
                next.arrive(watch, (&state, other), lasting, step + 1);
            }
        }
        layer = next;
    }
    Ok(outcome)
}

/// Tracks before a step.
struct Layer<S>(BTreeMap<(S, usize), Lasting>);

impl<S> Default for Layer<S> {
    fn default() -> Self {
        Self(BTreeMap::new())
    }
}

impl<S: Clone + Ord> Layer<S> {
    /// A track; of two that are one, what holds for both.
    fn keep(&mut self, track: (S, usize), lasting: Lasting) {
        let known = self.0.entry(track).or_insert(lasting);
        known.steps = known.steps.max(lasting.steps);
        known.changes = known.changes.min(lasting.changes);
        known.since_first = known.since_first.max(lasting.since_first);
    }

    /// A track that comes to a way at the sample before a step, if it may, and to what may be done there at once.
    fn arrive<W: Watch<State = S>>(&mut self, watch: &mut W, (state, way): (&S, usize), lasting: Lasting, step: usize) {
        let Some(state) = watch.enters(state, way, step) else { return };
        for other in watch.at_once(way).to_vec() {
            self.arrive(watch, (&state, other), lasting, step);
        }
        self.keep((state, way), lasting);
    }

    /// All of them, with what others may do before the step.
    fn with_others<W: Watch<State = S>>(self, watch: &mut W, step: usize) -> BTreeMap<(S, usize), Lasting> {
        let mut all = Self::default();
        for ((state, way), lasting) in self.0 {
            for other in watch.others(&state, step) {
                all.keep((other, way), lasting);
            }
            all.keep((state, way), lasting);
        }
        all.0
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    /// A corridor of cells, each with a reading; something walks along it, a cell a step at most, and a machine counts: for
    /// ever, or as long as nothing was read (latched).
    struct Corridor {
        /// Reading of each cell.
        cells: Vec<usize>,
        latched: bool,
        /// Ways: the first come from nowhere, the others from one reading to another.
        ways: Vec<(Option<usize>, usize)>,
        next: Vec<Vec<(usize, usize)>>,
    }

    impl Corridor {
        fn new(cells: &[usize], latched: bool) -> Self {
            let readings: BTreeSet<usize> = cells.iter().copied().collect();
            let of = |from: Option<usize>| {
                let others = readings.iter().copied().filter(move |to| from.is_none_or(|from| *to != from));
                others.map(move |to| (from, to))
            };
            let first: Vec<_> = std::iter::once((None, 0)).collect();
            let ways: Vec<_> = first.into_iter().chain(readings.iter().flat_map(|from| of(Some(*from)))).collect();
            let mut corridor = Self { cells: cells.to_vec(), latched, next: Vec::new(), ways };
            corridor.next = (0..corridor.ways.len()).map(|way| corridor.ways_on(way)).collect();
            corridor
        }

        /// Cells of a reading that lie beside one of another, or all of it.
        fn entered(&self, (from, to): (Option<usize>, usize)) -> Vec<usize> {
            let beside = |cell: usize| {
                [cell.wrapping_sub(1), cell + 1].iter().any(|other| self.cells.get(*other).copied() == from)
            };
            (0..self.cells.len()).filter(|cell| self.cells[*cell] == to && (from.is_none() || beside(*cell))).collect()
        }

        /// Steps from where a way comes in to a cell of the same reading, within it.
        fn far(&self, way: usize, cell: usize) -> Option<usize> {
            let joined = |a: usize, b: usize| (a.min(b)..=a.max(b)).all(|c| self.cells[c] == self.ways[way].1);
            self.entered(self.ways[way])
                .into_iter()
                .filter(|from| joined(*from, cell))
                .map(|from| from.abs_diff(cell))
                .min()
        }

        fn ways_on(&self, way: usize) -> Vec<(usize, usize)> {
            let to = self.ways[way].1;
            (0..self.ways.len())
                .filter(|other| self.ways[*other].0 == Some(to))
                .filter_map(|other| {
                    let leaves = self.entered((Some(self.ways[other].1), to));
                    Some((other, leaves.into_iter().filter_map(|cell| self.far(way, cell)).min()?))
                })
                .collect()
        }
    }

    impl Watch for Corridor {
        /// What the machine has counted, and whether it goes on.
        type State = (usize, bool);
        type Error = ();

        fn begins(&self) -> Vec<usize> {
            vec![0]
        }

        fn start(&mut self) -> Result<Self::State, ()> {
            Ok((0, true))
        }

        fn step(&mut self, (count, on): &Self::State, way: usize) -> Result<Option<Self::State>, ()> {
            let on = self.ways[way].1 == 0 && (*on || !self.latched);
            Ok(Some((count + usize::from(on), on)))
        }

        fn next(&self, way: usize) -> &[(usize, usize)] {
            &self.next[way]
        }
    }

    /// By plain enumeration of all walks: after each step, what the machine has counted and where the walker may be.
    fn brute(corridor: &mut Corridor, steps: usize) -> BTreeSet<(usize, usize, usize)> {
        let mut all = BTreeSet::new();
        let first = (0..corridor.cells.len()).filter(|cell| corridor.cells[*cell] == 0);
        let mut layer: BTreeSet<_> = first.map(|cell| ((0, true), cell)).collect();
        for step in 1..=steps {
            let mut next = BTreeSet::new();
            for (state, cell) in layer {
                let way = corridor.ways.iter().position(|(_, to)| *to == corridor.cells[cell]).unwrap();
                let state = corridor.step(&state, way).unwrap().unwrap();
                for other in [cell.wrapping_sub(1), cell, cell + 1] {
                    if other < corridor.cells.len() {
                        next.insert((state, other));
                        all.insert((step, state.0, other));
                    }
                }
            }
            layer = next;
        }
        all
    }

    /// The same by tracks: where the walker was at the beginning of a step, and a step on.
    fn by_tracks(
        corridor: &mut Corridor,
        steps: usize,
        changes: usize,
    ) -> (BTreeSet<(usize, usize, usize)>, TrackSearch) {
        let mut all = BTreeSet::new();
        let outcome = explore(corridor, steps, changes, &mut |corridor, taken| {
            for cell in 0..corridor.cells.len() {
                if corridor.far(taken.way, cell).is_some_and(|far| far <= taken.lasting.steps) {
                    for other in [cell.wrapping_sub(1), cell, cell + 1] {
                        if other < corridor.cells.len() {
                            all.insert((taken.step, taken.state.0, other));
                        }
                    }
                }
            }
            true
        });
        (all, outcome.unwrap())
    }

    #[test]
    fn tracks_hold_whatever_walks_do_and_nothing_else_where_there_is_one_entry() {
        let mut met = 0;
        for latched in [false, true] {
            for cells in
                [&[0, 0, 1, 1, 1, 1, 1, 1][..], &[0, 1, 1, 1, 0, 0], &[1, 1, 1, 0, 2, 2, 2, 2], &[0, 1, 2, 1, 0]]
            {
                let mut corridor = Corridor::new(cells, latched);
                let walks = brute(&mut corridor, 9);
                let (tracks, outcome) = by_tracks(&mut corridor, 9, usize::MAX);
                assert!(walks.is_subset(&tracks), "{cells:?} {latched}");
                assert_eq!((outcome.left_out, outcome.unfinished, outcome.ended), (0, 0, false));
                // From one side alone, tracks know as much as walks do.
                if cells.windows(2).filter(|pair| pair[0] != pair[1]).count() == 1 {
                    assert_eq!(walks, tracks, "{cells:?} {latched}");
                }
                met += walks.len();
                // With a limit less, and it is told that something was left out.
                let (fewer, outcome) = by_tracks(&mut corridor, 9, 1);
                assert!(fewer.is_subset(&tracks) && outcome.left_out > 0);
            }
        }
        assert!(met > 500, "{met}");
    }

    /// A reading of three cells takes two steps to pass: tracks that leave it at once would count too much.
    #[test]
    fn a_reading_lasts_as_long_as_the_way_through_it() {
        let mut corridor = Corridor::new(&[0, 1, 1, 1, 2], false);
        let mut first = BTreeMap::new();
        explore(&mut corridor, 9, usize::MAX, &mut |corridor, taken| {
            first.entry(corridor.ways[taken.way].1).or_insert(taken.step);
            true
        })
        .unwrap();
        assert_eq!(first, BTreeMap::from([(0, 1), (1, 2), (2, 5)]));
    }

    /// Since the first change: 0 at first, and on with every step, whatever the reading does meanwhile.
    #[test]
    fn steps_since_the_first_change_go_on_whatever_follows() {
        let mut corridor = Corridor::new(&[0, 1, 2], true);
        explore(&mut corridor, 9, usize::MAX, &mut |corridor, taken| {
            let (from, _) = corridor.ways[taken.way];
            let Lasting { steps, changes, since_first } = taken.lasting;
            assert_eq!(from.is_none(), changes == 0);
            // Latched: what was counted is the steps before the first change; a step that begins changed is not counted.
            assert_eq!(if changes == 0 { 0 } else { taken.step - 1 - taken.state.0 }, since_first);
            assert!(steps <= since_first || changes == 0);
            true
        })
        .unwrap();
    }

    /// Something that comes in from outside, or begins inside, beside a button that it may press once, at the very sample at which it
    /// comes there.
    struct Button {
        begins_inside: bool,
    }

    impl Button {
        const OUTSIDE: usize = 0;
        const INSIDE: usize = 1;
        const PRESSED: usize = 2;
    }

    impl Watch for Button {
        /// The step that began with the press; 0 before that.
        type State = usize;
        type Error = ();

        fn begins(&self) -> Vec<usize> {
            vec![if self.begins_inside { Self::INSIDE } else { Self::OUTSIDE }]
        }

        fn start(&mut self) -> Result<usize, ()> {
            Ok(0)
        }

        fn step(&mut self, pressed: &usize, _: usize) -> Result<Option<usize>, ()> {
            Ok(Some(*pressed))
        }

        fn next(&self, way: usize) -> &[(usize, usize)] {
            if way == Self::OUTSIDE { &[(Self::INSIDE, 0)] } else { &[] }
        }

        fn changes(&self, way: usize) -> bool {
            way != Self::PRESSED
        }

        fn at_once(&self, way: usize) -> &[usize] {
            if way == Self::INSIDE { &[Self::PRESSED] } else { &[] }
        }

        fn enters(&mut self, pressed: &usize, way: usize, step: usize) -> Option<usize> {
            Some(if way == Self::PRESSED { step } else { *pressed })
        }
    }

    /// In three steps. Who comes in is inside at the second step or the third, and each of them may begin with a press; who begins inside
    /// may press at the first.
    #[test]
    fn a_button_may_be_pressed_at_the_very_sample_of_coming_to_it() {
        for (begins_inside, by_hand) in
            [(false, BTreeSet::from([(2, 2), (3, 2), (3, 3)])), (true, BTreeSet::from([(1, 1), (2, 1), (3, 1)]))]
        {
            let mut pressed = BTreeSet::new();
            let outcome = explore(&mut Button { begins_inside }, 3, 1, &mut |_, taken| {
                pressed.extend((taken.way == Button::PRESSED).then_some((taken.step, *taken.state)));
                true
            });
            assert_eq!((pressed, outcome.unwrap().left_out), (by_hand, 0), "{begins_inside}");
        }
    }

    #[test]
    fn it_ends_when_it_is_told_to() {
        let mut told = 0;
        let outcome = explore(&mut Corridor::new(&[0, 1], false), 100, 9, &mut |_, _| {
            told += 1;
            told < 7
        });
        assert_eq!((outcome.unwrap().ended, told), (true, 7));
    }
}
