//! Readings that a machine answers alike: of two stops that do the same it does not matter which one is asked for. Fewer readings are fewer
//! behaviours, and nothing is taken for nearly the same because the one was asked for and then the other.

use super::{Begins, Hold, Machine, OutputClass};
use crate::rng::Rng;

/// States after which all readings are tried.
pub const STATES: usize = 60;
/// Changes before each of them, and steps of the shortest stays.
const MOST_CHANGES: usize = 6;
const SHORT: usize = 4;

/// By reading, the first that is answered as it is from all of some states within so many steps of the start: now, and while any reading is
/// held for `ahead` steps after it. Nothing where steps could not be finished, or `goes_on` says that it is enough.
///
/// # Errors
/// What the machine reports.
pub fn answered_alike<M: Machine>(
    machine: &mut M,
    rng: &mut Rng,
    (within, ahead): (usize, usize),
    goes_on: &mut dyn FnMut() -> bool,
) -> Result<Option<Vec<usize>>, M::Error> {
    let readings = machine.readings();
    let mut alike = vec![0; readings];
    for _ in 0..STATES {
        let (start, _) = machine.begin()?;
        let mut way = vec![(0, 1 + rng.below(within))];
        for _ in 0..rng.below(MOST_CHANGES + 1) {
            let most = [SHORT, ahead / 2][rng.below(2)];
            way.push((rng.below(readings), 1 + rng.below(most)));
        }
        let mut holds = Vec::new();
        for (number, (reading, steps)) in way.into_iter().enumerate() {
            let from = if number == 0 { Begins::At(&start) } else { Begins::After(number - 1) };
            holds.push(Hold { from, reading, steps, last: true });
        }
        let Some((_, state)) = machine.hold_each(&holds)?.and_then(|mut held| held.pop()) else { return Ok(None) };
        let stays = 1 + rng.below(SHORT);
        let mut answers = Vec::new();
        for reading in 0..readings {
            if !goes_on() {
                return Ok(None);
            }
            let mut holds = vec![Hold { from: Begins::At(&state), reading, steps: stays, last: false }];
            let after = |reading| Hold { from: Begins::After(0), reading, steps: ahead, last: false };
            holds.extend((0..readings).map(after));
            let Some(held) = machine.hold_each(&holds)? else { return Ok(None) };
            answers.push(held.into_iter().flat_map(|(shown, _)| shown).collect::<Vec<OutputClass>>());
        }
        let is_alike = |one: usize, other: usize| {
            answers[one].iter().zip(&answers[other]).all(|(one, other)| machine.look_alike(*one, *other))
        };
        let mut told: Vec<usize> = Vec::with_capacity(readings);
        for reading in 0..readings {
            // Who was told apart once stays so.
            let known = (0..reading)
                .find(|other| told[*other] == *other && alike[*other] == alike[reading] && is_alike(*other, reading));
            told.push(known.unwrap_or(reading));
        }
        alike = told;
    }
    Ok(Some(alike))
}
