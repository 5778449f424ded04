//! The shortest and calmest sequence that still gives a hazard, by trying: for searches that did not look at all.
//!
//! Delta debugging (Zeller and Hildebrandt, 2002) over the actions: leave parts out, then replace single actions by
//! calmer ones, as long as the same hazard (its identity, not just any) comes out; until nothing helps any more.

use std::collections::BTreeSet;

use crate::hazard::group::calmness;
use crate::hazard::{Finding, Identity};
use crate::host::{Plant, PlantError};
use crate::human::{Action, Posture, Presses, Walk, Who};
use crate::search::Environment as _;
use crate::sim::Simulation;

/// Sequences tried for one hazard at most.
const TRIES: usize = 400;

/// A finding of the same `identity` that is as short and calm as trying makes it, beginning with `finding`; as long as
/// `go_on`, asked before each try.
///
/// # Errors
/// When the simulation cannot go on at all.
pub(crate) fn minimise<P: Plant>(
    simulation: &mut Simulation<P>,
    finding: &Finding,
    identity: &Identity,
    links: &[String],
    go_on: impl Fn(&Simulation<P>) -> bool,
) -> Result<Finding, PlantError> {
    let mut best = finding.clone();
    let mut tried: BTreeSet<Vec<Action>> = BTreeSet::new();
    'again: loop {
        for candidate in candidates(&best.actions) {
            if tried.len() >= TRIES || !go_on(simulation) {
                return Ok(best);
            }
            if calmness(&candidate) >= calmness(&best.actions) || tried.contains(&candidate) {
                continue;
            }
            let found = run(simulation, &candidate)?;
            tried.insert(candidate);
            let same = found.into_iter().find(|f| Identity::of(f, links) == *identity);
            if let Some(found) = same.filter(|f| calmness(&f.actions) < calmness(&best.actions)) {
                best = found;
                continue 'again;
            }
        }
        return Ok(best);
    }
}

/// What is unsafe in a sequence.
fn run<P: Plant>(simulation: &mut Simulation<P>, actions: &[Action]) -> Result<Vec<Finding>, PlantError> {
    simulation.reset()?;
    let _ = (simulation.take_findings(), simulation.take_behind());
    for action in actions {
        if simulation.take(*action)?.end.is_some() && !simulation.goes_on() {
            break;
        }
    }
    let findings = simulation.take_findings().into_iter().chain(simulation.take_behind());
    let taken = simulation.taken().to_vec();
    Ok(findings.filter(|f| taken.starts_with(&f.actions)).collect())
}

/// What may be shorter or calmer, the most daring first.
fn candidates(actions: &[Action]) -> Vec<Vec<Action>> {
    let mut all = Vec::new();
    for part in (1..actions.len()).rev() {
        for from in 0..=actions.len() - part {
            let mut without = actions.to_vec();
            without.drain(from..from + part);
            all.push(without);
        }
    }
    let replace = |at: usize, by: Action| {
        let mut replaced = actions.to_vec();
        replaced[at] = by;
        replaced
    };
    for (at, action) in actions.iter().enumerate() {
        let people = if action.is_of_two() { &Who::ALL[..] } else { &Who::ALL[..1] };
        for &who in people {
            let does = action.of(who);
            for walk in [Walk::Stop, Walk::Forward, does.walk()] {
                for posture in [Posture::Upright, Posture::Forward, Posture::Left, Posture::Right, does.posture()] {
                    let moves = action.with(who, Action::new(walk, posture)).pressing(Presses::NONE);
                    all.push(replace(at, moves));
                    if !action.presses().is_none() {
                        all.push(replace(at, moves.pressing(action.presses())));
                    }
                }
            }
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::human::Repertoire;

    #[test]
    fn candidates_leave_out_neighbours_and_calm_every_action() {
        let [a, b, c] = [7, 19, 35].map(|i| Repertoire::usual(0).action(i));
        let all = candidates(&[a, b, c]);
        for shorter in [vec![a], vec![c], vec![a, b], vec![a, c], vec![b, c]] {
            assert!(all.contains(&shorter), "{shorter:?}");
        }
        assert!(all.contains(&vec![a, Action::REST, c]));
        assert!(all.contains(&vec![a, b, Action::new(c.walk(), Posture::Upright)]));
        assert!(all.iter().all(|candidate| !candidate.is_empty()));
    }
}
