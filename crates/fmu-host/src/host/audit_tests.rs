//! Audits of a small integrator that lies in one way or another.

use super::*;
use crate::host::plant::Fingerprint;
use crate::host::recall::{Advanced, Policy};

/// `x += u` per step; once `x` was above 2 it counts double, which is a flag.
#[derive(Clone, Default)]
struct Flagged {
    x: f64,
    flag: bool,
    /// A restore keeps the flag.
    forgets: bool,
    /// The fingerprint lacks the flag.
    thin: bool,
    /// With the flag, each run is another one.
    noisy: bool,
    restarts: u32,
}

impl Plant for Flagged {
    type Checkpoint = (f64, bool);
    fn input_count(&self) -> usize {
        1
    }
    fn output_count(&self) -> usize {
        1
    }
    fn restart(&mut self) -> Result<Vec<f64>, PlantError> {
        (self.x, self.flag) = (0.0, false);
        self.restarts += 1;
        Ok(vec![0.0])
    }
    fn advance(&mut self, steps: usize, inputs: &[f64]) -> Result<Vec<f64>, PlantError> {
        let step = |u: &f64| {
            self.x += u * if self.flag { 2.0 } else { 1.0 };
            self.flag |= self.x > 2.0;
            self.x + if self.noisy && self.flag { f64::from(self.restarts) } else { 0.0 }
        };
        Ok(inputs.iter().take(steps).map(step).collect())
    }
    fn save(&mut self) -> Result<(f64, bool), PlantError> {
        Ok((self.x, self.flag))
    }
    fn fingerprint(&mut self) -> Result<Option<Fingerprint>, PlantError> {
        let mut digest = [0; 32];
        digest[..8].copy_from_slice(&self.x.to_le_bytes());
        digest[8] = u8::from(self.flag && !self.thin);
        Ok(Some(Fingerprint { digest, bytes: 9 }))
    }
    fn restore(&mut self, saved: &(f64, bool)) -> Result<(), PlantError> {
        let kept = self.flag && self.forgets;
        (self.x, self.flag) = (saved.0, saved.1 || kept);
        Ok(())
    }
}

const ALL: Scope = Scope { since: 0, runs: usize::MAX, steps: u64::MAX, instance: 1 };
const INPUTS: [f64; 4] = [-1.0, 0.0, 1.0, 2.0];

/// All sequences of so many inputs, with states that are merged or not.
fn searched(plant: Flagged, depth: usize, merge: bool) -> Result<Recall<Flagged>, PlantError> {
    let mut recall = Recall::new(plant, Policy::States { max_checkpoints: 10_000 })?;
    assert!(!merge || recall.merge_equal_states()?);
    let mut level = vec![NodeId::ROOT];
    for d in 0..depth {
        let mut next = Vec::new();
        for node in level {
            for input in INPUTS {
                let Advanced::To(child) = recall.advance(node, 1, &[input])? else { panic!("no fault") };
                next.push(recall.same(child));
            }
        }
        next.sort_unstable();
        next.dedup();
        level = next;
        // As a search does: traces are forgotten.
        recall.release_before(d + 1);
    }
    Ok(recall)
}

fn audited(plant: &Flagged, recall: &Recall<Flagged>, scope: Scope) -> Audit {
    audit(&mut plant.clone(), recall, scope, &mut |_, _| true).unwrap()
}

#[test]
fn an_honest_plant_passes_whole_or_in_part() {
    for merge in [false, true] {
        let plant = Flagged::default();
        let recall = searched(plant.clone(), 4, merge).unwrap();
        let whole = audited(&plant, &recall, ALL);
        assert!(whole.compared == whole.transitions && whole.difference.is_none(), "{merge} {whole:?}");
        assert_eq!(whole.merges_compared, whole.merges);
        if merge {
            assert!(whole.merges > 3 && whole.transitions < 340, "{whole:?}");
        } else {
            assert_eq!((whole.transitions, whole.merges), (4 + 16 + 64 + 256, 0));
            // Each run costs an instance and four steps.
            let part = audited(&plant, &recall, Scope { steps: 50, ..ALL });
            assert!(part.compared >= 10 && part.compared <= 40 && part.transitions == 340, "{part:?}");
        }
    }
}

#[test]
fn a_state_that_lacks_something_is_caught() {
    let plant = Flagged { forgets: true, ..Flagged::default() };
    let recall = searched(plant.clone(), 3, false).unwrap();
    let difference = audited(&plant, &recall, ALL).difference.unwrap();
    assert_eq!(difference.unlike, Unlike::State);
    assert_eq!(repeated(&mut plant.clone(), &difference.history), Ok(Some(difference.gave)));
}

/// Once 3 was reached the flag is kept: of two actions only those from 2 come out wrong, and they are the last ones.
#[test]
fn the_last_action_of_a_history_counts() {
    let plant = Flagged { forgets: true, ..Flagged::default() };
    let recall = searched(plant.clone(), 2, false).unwrap();
    let difference = audited(&plant, &recall, ALL).difference.unwrap();
    assert_eq!((difference.unlike, difference.action), (Unlike::State, 2));
    assert_eq!((difference.history.0, difference.history.1[0]), (2, 2.0));
}

/// 3 - 2 with the flag and 1 + 0 without it have equal bytes, and go on alike by 0, which is what is tried out; by 1 they do not.
#[test]
fn two_histories_that_were_merged_have_to_go_on_alike() {
    let plant = Flagged { thin: true, ..Flagged::default() };
    let mut recall = Recall::new(plant.clone(), Policy::States { max_checkpoints: 10 }).unwrap();
    assert!(recall.merge_equal_states().unwrap());
    let mut to = |from: NodeId, input: f64| {
        let Advanced::To(node) = recall.advance(from, 1, &[input]).unwrap() else { panic!("no fault") };
        node
    };
    let (high, low) = (to(NodeId::ROOT, 3.0), to(NodeId::ROOT, 1.0));
    let (first, other) = (to(high, -1.0), to(low, 0.0));
    to(other, 1.0);
    assert_eq!(recall.same(other), first);
    let found = audited(&plant, &recall, ALL);
    let difference = found.difference.unwrap();
    assert_eq!((found.merges, difference.unlike, difference.action), (1, Unlike::Merge, 3));
    assert_eq!(difference.history, (3, vec![1.0, 0.0, 1.0]));
}

#[test]
fn bytes_that_lack_something_are_caught_where_they_are_tried_out() {
    let error = searched(Flagged { thin: true, ..Flagged::default() }, 4, true).map(drop).unwrap_err();
    assert_eq!(error.unlike, Some(Unlike::Merge));
}

#[test]
fn noise_is_told_from_a_lie() {
    let plant = Flagged { noisy: true, ..Flagged::default() };
    let recall = searched(plant.clone(), 3, false).unwrap();
    let difference = audited(&plant, &recall, ALL).difference.unwrap();
    assert_eq!((difference.unlike, repeated(&mut plant.clone(), &difference.history)), (Unlike::Plain, Ok(None)));
}

#[test]
fn an_audit_can_be_stopped() {
    let plant = Flagged::default();
    let recall = searched(plant.clone(), 3, false).unwrap();
    let mut told = 0;
    let stopped = audit(&mut plant.clone(), &recall, ALL, &mut |done, of| {
        told = of;
        done < 3
    });
    let stopped = stopped.unwrap();
    assert!(stopped.stopped && stopped.compared < stopped.transitions && told == 64, "{stopped:?}");
}
