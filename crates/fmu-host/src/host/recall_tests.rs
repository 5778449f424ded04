//! Recall on a small integrator whose outputs are known, with and without saved states.

use super::*;
use crate::host::plant::Fingerprint;

/// `x += u` per step; fails when `x` exceeds a limit; optionally forgets to restore.
#[derive(Default)]
struct Integrator {
    x: f64,
    limit: Option<f64>,
    drifts: bool,
    restarts: u32,
    /// Serialises only its whole part.
    rounds: bool,
    /// How saving fails above 5: refused, or with the process.
    cannot_save: Option<bool>,
    /// How restoring fails: refused, or with the process.
    cannot_restore: Option<bool>,
    /// Restoring waits for the next steps, until that went wrong once.
    puts_off: bool,
    put_off: Option<(u32, f64)>,
    fingerprints: u32,
    /// The process in which states are held.
    process: u32,
}

impl Plant for Integrator {
    type Checkpoint = (u32, f64);
    fn input_count(&self) -> usize {
        1
    }
    fn output_count(&self) -> usize {
        1
    }
    fn restart(&mut self) -> Result<Vec<f64>, PlantError> {
        self.x = 0.0;
        self.restarts += 1;
        Ok(vec![0.0])
    }
    fn advance(&mut self, steps: usize, inputs: &[f64]) -> Result<Vec<f64>, PlantError> {
        if let Some(state) = self.put_off.take() {
            self.restore(&state).map_err(|error| {
                self.puts_off = false;
                PlantError { restoring: !error.lost, ..error }
            })?;
        }
        let mut out = Vec::new();
        for u in inputs.iter().take(steps) {
            self.x += u + if self.drifts { f64::from(self.restarts) } else { 0.0 };
            if self.limit.is_some_and(|l| self.x > l) {
                return Err(PlantError::of("over the limit"));
            }
            out.push(self.x);
        }
        Ok(out)
    }
    fn save(&mut self) -> Result<(u32, f64), PlantError> {
        match self.cannot_save {
            Some(lost) if self.x > 5.0 => {
                self.x = f64::NAN;
                self.process += u32::from(lost);
                Err(PlantError { lost, ..PlantError::of("cannot save") })
            }
            _ => Ok((self.process, self.x)),
        }
    }
    fn holds(&self, checkpoint: &(u32, f64)) -> bool {
        checkpoint.0 == self.process
    }
    fn fingerprint(&mut self) -> Result<Option<Fingerprint>, PlantError> {
        self.fingerprints += 1;
        let x = if self.rounds { self.x.floor() } else { self.x };
        let mut digest = [0; 32];
        digest[..8].copy_from_slice(&x.to_le_bytes());
        Ok(Some(Fingerprint { digest, bytes: 8 }))
    }
    fn restore(&mut self, checkpoint: &(u32, f64)) -> Result<(), PlantError> {
        assert!(self.holds(checkpoint), "restored what is lost");
        if let Some(lost) = self.cannot_restore {
            self.x = f64::NAN;
            self.process += u32::from(lost);
            return Err(PlantError { lost, ..PlantError::of("cannot restore") });
        }
        self.x = checkpoint.1;
        Ok(())
    }
    fn restore_soon(&mut self, checkpoint: &(u32, f64)) -> Result<(), PlantError> {
        if self.puts_off {
            self.put_off = Some(*checkpoint);
            return Ok(());
        }
        self.restore(checkpoint)
    }
}

const STATES: Policy = Policy::States { max_checkpoints: 100 };

fn to(advanced: Advanced) -> NodeId {
    match advanced {
        Advanced::To(node) => node,
        Advanced::Fault(fault) => panic!("{fault}"),
    }
}

#[test]
fn branches_do_not_disturb_each_other_on_any_rung() {
    for policy in [STATES, Policy::States { max_checkpoints: 1 }, Policy::States { max_checkpoints: 0 }, Policy::Replay]
    {
        let mut recall = Recall::new(Integrator::default(), policy).unwrap();
        let a = to(recall.advance(NodeId::ROOT, 2, &[1.0, 2.0]).unwrap());
        let b = to(recall.advance(NodeId::ROOT, 2, &[5.0, 5.0]).unwrap());
        let ab = to(recall.advance(a, 1, &[10.0]).unwrap());
        let again = to(recall.advance(a, 1, &[10.0]).unwrap());
        assert_eq!(ab, again);
        assert_eq!(&**recall.outputs(a), &[1.0, 3.0]);
        assert_eq!(&**recall.outputs(b), &[5.0, 10.0]);
        assert_eq!(&**recall.outputs(ab), &[13.0]);
        assert_eq!(recall.states(), 4);
    }
}

#[test]
fn a_known_transition_costs_no_step_with_states_and_every_step_with_replay() {
    let count = |policy| {
        let mut recall = Recall::new(Integrator::default(), policy).unwrap();
        for _ in 0..3 {
            let a = to(recall.advance(NodeId::ROOT, 2, &[1.0, 2.0]).unwrap());
            to(recall.advance(a, 2, &[1.0, 2.0]).unwrap());
        }
        (recall.steps(), recall.effort().steps)
    };
    assert_eq!(count(STATES), (4, 4));
    assert_eq!(count(Policy::Replay), (4, 12));
}

#[test]
fn a_fault_is_remembered_and_the_search_can_go_on() {
    for policy in [STATES, Policy::Replay] {
        let mut recall = Recall::new(Integrator { limit: Some(3.0), ..Integrator::default() }, policy).unwrap();
        for _ in 0..2 {
            assert!(matches!(recall.advance(NodeId::ROOT, 1, &[4.0]).unwrap(), Advanced::Fault(_)));
        }
        let a = to(recall.advance(NodeId::ROOT, 1, &[3.0]).unwrap());
        assert_eq!(&**recall.outputs(a), &[3.0]);
    }
}

#[test]
fn an_fmu_that_does_not_repeat_itself_is_caught_by_replay() {
    let mut recall = Recall::new(Integrator { drifts: true, ..Integrator::default() }, Policy::Replay).unwrap();
    to(recall.advance(NodeId::ROOT, 1, &[1.0]).unwrap());
    let error = recall.advance(NodeId::ROOT, 1, &[1.0]).unwrap_err();
    assert!(error.fatal && error.message.contains("different outputs"), "{error}");
}

#[test]
fn equal_states_are_stepped_once_under_every_history() {
    let mut recall = Recall::new(Integrator::default(), STATES).unwrap();
    assert!(recall.merge_equal_states().unwrap());
    let a = to(recall.advance(NodeId::ROOT, 2, &[1.0, 2.0]).unwrap());
    let b = to(recall.advance(NodeId::ROOT, 2, &[2.0, 1.0]).unwrap());
    assert_eq!((recall.same(a), recall.same(b)), (a, a));
    // Each history keeps its own trace, and its own past.
    assert_eq!((&**recall.outputs(a), &**recall.outputs(b)), (&[1.0, 3.0][..], &[2.0, 3.0][..]));
    assert_eq!(recall.merges(), Merges { merged: 1, tried_out: 1 });
    let ahead = to(recall.advance(a, 1, &[4.0]).unwrap());
    let steps = recall.effort().steps;
    let same = to(recall.advance(b, 1, &[4.0]).unwrap());
    assert_eq!(recall.effort().steps, steps, "the step from the equal state is known");
    assert_eq!((recall.same(same), recall.parent(same), &**recall.outputs(same)), (ahead, b, &[7.0][..]));
    // Equal values at another depth are another state: time is part of it.
    let later = to(recall.advance(b, 1, &[0.0]).unwrap());
    assert_eq!((recall.depth(recall.same(later)), recall.merges().merged), (2, 1));
    recall.release_before(1);
    let on = to(recall.advance(b, 1, &[5.0]).unwrap());
    assert_eq!(&**recall.outputs(on), &[8.0]);
    recall.release_before(2);
    let on = to(recall.advance(b, 1, &[6.0]).unwrap());
    assert_eq!(&**recall.outputs(on), &[9.0], "by replay");
}

#[test]
fn a_serialised_state_that_leaves_something_out_is_caught() {
    let mut recall = Recall::new(Integrator { rounds: true, ..Integrator::default() }, STATES).unwrap();
    assert!(recall.merge_equal_states().unwrap());
    to(recall.advance(NodeId::ROOT, 1, &[1.25]).unwrap());
    let error = recall.advance(NodeId::ROOT, 1, &[1.5]).unwrap_err();
    assert!(error.fatal && error.message.contains("--merge history"), "{error}");
}

#[test]
fn a_state_that_cannot_be_saved_costs_no_action() {
    for lost in [false, true] {
        for merge in [false, true] {
            let mut recall =
                Recall::new(Integrator { cannot_save: Some(lost), ..Integrator::default() }, STATES).unwrap();
            if merge {
                assert!(recall.merge_equal_states().unwrap());
            }
            let low = to(recall.advance(NodeId::ROOT, 1, &[2.0]).unwrap());
            let high = to(recall.advance(low, 1, &[4.0]).unwrap());
            assert_eq!(&**recall.outputs(high), &[6.0], "{lost} {merge}");
            let low_again = to(recall.advance(low, 1, &[-1.0]).unwrap());
            assert_eq!(&**recall.outputs(low_again), &[1.0]);
            let higher = to(recall.advance(high, 1, &[1.0]).unwrap());
            assert_eq!(&**recall.outputs(higher), &[7.0]);
        }
    }
}

#[test]
fn a_state_that_cannot_be_restored_costs_no_action() {
    for (lost, puts_off) in [(false, false), (false, true), (true, false), (true, true)] {
        let plant = Integrator { cannot_restore: Some(lost), puts_off, ..Integrator::default() };
        let mut recall = Recall::new(plant, STATES).unwrap();
        let a = to(recall.advance(NodeId::ROOT, 1, &[2.0]).unwrap());
        for u in [1.0, 4.0, 5.0, 6.0, 7.0] {
            let on = to(recall.advance(a, 1, &[u]).unwrap());
            assert_eq!(&**recall.outputs(on), &[2.0 + u], "{lost} {puts_off}");
        }
        assert_eq!(recall.effort().restores, if puts_off { 1 } else { 0 }, "said to be done, and done by replay");
    }
}

#[test]
fn where_everything_ends_nothing_is_asked_of_states() {
    let mut recall = Recall::new(Integrator::default(), STATES).unwrap();
    recall.ends_at(2);
    assert!(recall.merge_equal_states().unwrap());
    let a = to(recall.advance(NodeId::ROOT, 1, &[1.0]).unwrap());
    let asked = recall.plant().fingerprints;
    let (b, c) = (to(recall.advance(a, 2, &[2.0, 1.0]).unwrap()), to(recall.advance(a, 2, &[1.0, 2.0]).unwrap()));
    assert_eq!((recall.plant().fingerprints, recall.merges().merged), (asked, 0));
    assert_eq!((recall.same(b), recall.same(c), &**recall.outputs(c)), (b, c, &[2.0, 4.0][..]));
    // Whoever steps on all the same gets what is right.
    let on = to(recall.advance(b, 1, &[5.0]).unwrap());
    assert_eq!(&**recall.outputs(on), &[9.0]);
    // Equal outputs have one number, others another.
    let d = to(recall.advance(NodeId::ROOT, 2, &[2.0, 2.0]).unwrap());
    assert!(recall.trace(d) == recall.trace(c) && recall.trace(d) != recall.trace(b));
}
