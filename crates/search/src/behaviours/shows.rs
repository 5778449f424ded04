//! For how long a reading has to be held until states that show the same now, and are not the same, show it: timers run out, ramps end.
//!
//! States are taken at many moments, right after readings changed and later, two each time: one a step later, or with a step less of one
//! reading and one more of another before. Of two timers that began a step apart one runs out first.

use super::{Begins, Hold, Machine, OutputClass};
use crate::rng::Rng;

/// Moments at which readings begin to change, and pairs of states after that.
const MOMENTS: usize = 20;
const PAIRS: usize = 5;
/// Changes before states are taken, and steps of the shortest stays.
const MOST_CHANGES: usize = 4;
const SHORT: usize = 10;

/// What was seen.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Shows {
    /// The most steps after which states that were alike so far showed something else, by the reading that showed it first.
    pub steps: Vec<usize>,
    /// How many states were looked at, each with each reading held.
    pub states: usize,
    /// For so many steps.
    pub ahead: usize,
}

/// Looks `ahead` so many steps from states within so many steps of the start; nothing where steps could not be finished.
///
/// # Errors
/// What the machine reports.
pub(crate) fn shows<M: Machine>(
    machine: &mut M,
    rng: &mut Rng,
    (within, ahead): (usize, usize),
) -> Result<Option<Shows>, M::Error> {
    let others = machine.others();
    let mut all: Vec<(ShowsKey, Vec<OutputClass>)> = Vec::new();
    for moment in 0..MOMENTS {
        let quiet = within * moment / MOMENTS + rng.below(within / MOMENTS + 1);
        for pair in 0..PAIRS {
            let legs = legs(&others, rng, (quiet.max(1), ahead));
            let other = changed(&legs, rng, pair % 2 == 0);
            for legs in [legs, other] {
                let Some(one) = looked(machine, &others, (&legs, ahead))? else { return Ok(None) };
                all.push(one);
            }
        }
    }
    all.sort();
    let first_unlike = |pair: &[(ShowsKey, Vec<OutputClass>)]| {
        let [((coming, one_now), one), ((its, other_now), other)] = pair else { return None };
        let is_alike = coming == its && machine.alike(*one_now, *other_now);
        let unlike = one.iter().zip(other).position(|(one, other)| !machine.alike(*one, *other))?;
        is_alike.then(|| (coming[unlike % coming.len()], unlike / coming.len() + 1))
    };
    let mut steps = vec![0; machine.readings()];
    for (reading, after) in all.windows(2).filter_map(first_unlike) {
        steps[reading] = after.max(steps[reading]);
    }
    Ok(Some(Shows { steps, states: all.len(), ahead }))
}

/// Which readings may come next, and what is shown.
type ShowsKey = (Vec<usize>, OutputClass);

/// Readings, each held for some steps: some changes after so many quiet ones.
fn legs(others: &[Vec<usize>], rng: &mut Rng, (quiet, ahead): (usize, usize)) -> Vec<(usize, usize)> {
    let mut legs = vec![(0, quiet)];
    for _ in 0..=rng.below(MOST_CHANGES) {
        let present = legs.last().map_or(0, |(reading, _)| *reading);
        let most = [SHORT, ahead / 5, ahead / 2][rng.below(3)];
        let stay = 1 + rng.below(most.max(1));
        legs.push((drawn(&others[present], rng).unwrap_or(present), stay));
    }
    legs
}

/// The same a step later, or with a step less of one leg and one more of another.
fn changed(legs: &[(usize, usize)], rng: &mut Rng, later: bool) -> Vec<(usize, usize)> {
    let mut other = legs.to_vec();
    let (from, to) = (rng.below(legs.len()), rng.below(legs.len()));
    if later || from == to || legs[from].1 == 1 {
        other[legs.len() - 1].1 += 1;
    } else {
        other[from].1 -= 1;
        other[to].1 += 1;
    }
    other
}

/// What is shown after some legs, and what while each reading is held that may come then; nothing where steps could not be finished.
fn looked<M: Machine>(
    machine: &mut M,
    others: &[Vec<usize>],
    (legs, ahead): (&[(usize, usize)], usize),
) -> Result<Option<(ShowsKey, Vec<OutputClass>)>, M::Error> {
    let (start, _) = machine.begin()?;
    let present = legs.last().map_or(0, |(reading, _)| *reading);
    let mut coming = others[present].clone();
    coming.push(present);
    coming.sort_unstable();
    let from = |number: usize| number.checked_sub(1).map_or(Begins::At(&start), Begins::After);
    let hold = |(number, (reading, steps)): (usize, &(usize, usize))| Hold {
        from: from(number),
        reading: *reading,
        steps: *steps,
        last: true,
    };
    let mut holds: Vec<_> = legs.iter().enumerate().map(hold).collect();
    let after = |reading: &usize| Hold { from: from(legs.len()), reading: *reading, steps: ahead, last: false };
    holds.extend(coming.iter().map(after));
    let Some(held) = machine.hold_each(&holds)? else { return Ok(None) };
    let now = held[legs.len() - 1].0.last().copied().unwrap_or_default();
    let runs: Vec<&[OutputClass]> = held[legs.len()..].iter().map(|(shown, _)| &shown[..]).collect();
    // Step by step, so that what differs first is met first.
    let told = (0..ahead).flat_map(|step| runs.iter().map(move |run| run[step])).collect();
    Ok(Some(((coming, now), told)))
}

/// One of some readings.
fn drawn(others: &[usize], rng: &mut Rng) -> Option<usize> {
    (!others.is_empty()).then(|| others[rng.below(others.len())])
}

/// Histories of which it is seen where they end, how often readings change in each, and how many are asked for at once.
const HISTORIES: usize = 1_000;
const CHANGES: usize = 6;
const AT_ONCE: usize = 20;

/// Where histories of many changes end when the first reading is held for so many steps after them, of those after which something still
/// moves: how many, and how many that were different. Where nearly all are, there are more behaviours than can be counted. Nothing where
/// steps could not be finished.
///
/// # Errors
/// What the machine reports.
pub(crate) fn ends<M: Machine>(
    machine: &mut M,
    rng: &mut Rng,
    (within, ahead): (usize, usize),
) -> Result<Option<(usize, usize)>, M::Error> {
    let others = machine.others();
    let mut all: Vec<OutputClass> = Vec::new();
    for _ in 0..HISTORIES / AT_ONCE {
        let (start, _) = machine.begin()?;
        let (mut holds, mut last) = (Vec::new(), Vec::new());
        for _ in 0..AT_ONCE {
            let quiet = 1 + rng.below(within);
            holds.push(Hold { from: Begins::At(&start), reading: 0, steps: quiet, last: true });
            let mut reading = 0;
            for change in 0..CHANGES {
                let back = others[reading].contains(&0) && change % 2 == 1;
                reading = if back { 0 } else { drawn(&others[reading], rng).unwrap_or(reading) };
                let from = Begins::After(holds.len() - 1);
                holds.push(Hold { from, reading, steps: 1 + rng.below(ahead / 3), last: true });
            }
            for steps in [ahead - 1, 1] {
                holds.push(Hold { from: Begins::After(holds.len() - 1), reading: 0, steps, last: true });
            }
            last.push(holds.len() - 1);
        }
        let Some(held) = machine.hold_each(&holds)? else { return Ok(None) };
        let moving = last.iter().filter_map(|number| {
            let [before, end] = [number - 1, *number].map(|number| held[number].0.last());
            end.filter(|_| before != end).copied()
        });
        all.extend(moving);
    }
    let count = all.len();
    all.sort_unstable();
    all.dedup();
    Ok(Some((count, all.len())))
}
