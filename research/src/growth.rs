//! How the number of different hazards of a search grows with its iterations, beside the complete list if it is known.

use std::collections::BTreeMap;

use serde::Serialize;

/// The complete list of a cell's hazards: for each id the share of all hazardous sequences that begin with it.
pub(crate) type Truth = BTreeMap<String, f64>;

/// Iterations after which is counted: 10 and its doubles, and the budget.
#[must_use]
pub(crate) fn checkpoints(budget: u32) -> Vec<u32> {
    let doubles = std::iter::successors(Some(10_u32), |i| i.checked_mul(2)).take_while(|i| *i < budget);
    doubles.chain([budget]).collect()
}

/// What it took to find every hazard of the complete list.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub(crate) struct Cost {
    /// Iterations.
    pub iterations: u32,
    /// Actions taken in the simulation.
    pub actions: u64,
    /// Steps of the FMU, each transition once.
    pub fmu_steps: u64,
}

/// One run.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub(crate) struct Growth {
    /// Different hazards at each checkpoint.
    pub groups: Vec<usize>,
    /// Part of the complete list that was found, at each checkpoint; empty if the list is not known.
    pub recall: Vec<f64>,
    /// The same by weight: part of all hazardous sequences that begin with a hazard found.
    pub weighted_recall: Vec<f64>,
    /// What it took to find all, if that came about.
    pub all: Option<Cost>,
    /// Hazards that the complete list does not have: an error of this tool.
    pub unknown: Vec<String>,
    #[serde(skip)]
    pub(super) found: usize,
    #[serde(skip)]
    pub(super) listed: usize,
    #[serde(skip)]
    pub(super) weight: f64,
}

impl Growth {
    /// Takes in a hazard that was not met before.
    pub(crate) fn met(&mut self, id: String, truth: Option<&Truth>) {
        self.found += 1;
        match truth.map(|truth| truth.get(&id)) {
            None => {}
            Some(Some(weight)) => {
                self.listed += 1;
                self.weight += weight;
            }
            Some(None) => self.unknown.push(id),
        }
    }

    /// The end of an iteration: `now` is what was spent so far.
    pub(crate) fn after(&mut self, now: Cost, checkpoints: &[u32], truth: Option<&Truth>) {
        if self.all.is_none() && truth.is_some_and(|truth| self.listed == truth.len()) {
            self.all = Some(now);
        }
        if !checkpoints.contains(&now.iterations) {
            return;
        }
        self.groups.push(self.found);
        if let Some(truth) = truth {
            // Of nothing, everything is found.
            let part = if truth.is_empty() { 1.0 } else { self.listed as f64 / truth.len() as f64 };
            self.recall.push(part);
            self.weighted_recall.push(if truth.is_empty() { 1.0 } else { self.weight });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counted_at_10_and_its_doubles_and_at_the_end() {
        assert_eq!(checkpoints(6), [6]);
        assert_eq!(checkpoints(40), [10, 20, 40]);
        assert_eq!(checkpoints(100), [10, 20, 40, 80, 100]);
    }

    #[test]
    fn recall_by_hand() {
        let truth = Truth::from([("a".to_owned(), 0.75), ("b".to_owned(), 0.25)]);
        let at = |iterations| Cost { iterations, actions: 8 * u64::from(iterations), fmu_steps: 5 };
        let run = |truth: Option<&Truth>, last: &str| {
            let mut growth = Growth::default();
            for i in 1..=20 {
                match i {
                    3 => growth.met("a".to_owned(), truth),
                    11 => growth.met(last.to_owned(), truth),
                    _ => {}
                }
                growth.after(at(i), &checkpoints(20), truth);
            }
            growth
        };
        let all = run(Some(&truth), "b");
        assert_eq!((&all.groups, &all.recall, &all.weighted_recall), (&vec![1, 2], &vec![0.5, 1.0], &vec![0.75, 1.0]));
        assert_eq!((all.all, all.unknown.len()), (Some(at(11)), 0));
        let wrong = run(Some(&truth), "not on the list");
        assert_eq!((wrong.all, &wrong.recall, &wrong.groups), (None, &vec![0.5, 0.5], &vec![1, 2]));
        assert_eq!(wrong.unknown, ["not on the list"]);
        let without = run(None, "b");
        assert!(without.recall.is_empty() && without.all.is_none() && without.groups == [1, 2]);
    }
}
