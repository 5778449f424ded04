//! The state self-test: what an FMU's promises about its state are worth, found by trying.
//!
//! The FMI texts do not promise that a restored FMU behaves like the uninterrupted one, and `fmi2Reset` is often wrong
//! in practice. So before a search relies on either, the *future* after coming back is compared, over a whole episode
//! with moving inputs, holding several states at once and returning to each (a state that shares a buffer, or that
//! forgets a hidden clock, passes simpler tests).
//!
//! Inputs are held for stretches of several lengths, and states are saved in the middle of one and right after a change:
//! an integrator that restarts when an input changes hides there what its state lacks. All outputs count, also those that
//! a cell does not bind. Each stage can run in a process of its own, so that what one of them does to the memory is not
//! taken for another one's.
//!
//! What an FMU does wrong in all runs of the same steps alike shows in none of that. So at last the motion in half steps is
//! compared, and that of the other of with Event Mode and without.

mod agreement;
mod facts;
mod motion;

pub use fmu_self_test::{Agreement, Apart, Motion, SelfTest, StateRestore, Untried};
use serde::{Deserialize, Serialize};

use super::activity::Activity;
use super::plant::{Plant, PlantError};
use super::port::{Port, PortKind};
use super::system::{System, SystemSetup};
use crate::fmi::Slave;
pub(super) use agreement::{Columns, agreement};
pub(super) use facts::Facts;

/// A part of the self-test. Each may crash on an FMU that is badly made.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Stage {
    /// The first plain run.
    FirstRun,
    /// Two fresh instances, one after the other.
    Deterministic,
    /// A second instance beside the first.
    SecondInstance,
    /// Saved states on one instance.
    Restore,
    /// How large a serialised state is.
    StateSize,
    /// A serialised state in another instance.
    Serialize,
    /// `fmi2Reset`.
    Reset,
    /// The first run in half steps.
    HalfSteps,
    /// The first run with Event Mode, if it was made without, or without.
    EventMode,
}

impl Stage {
    /// Those after the first run, in their order.
    pub(super) const LATER: [Self; 6] =
        [Self::Deterministic, Self::SecondInstance, Self::Restore, Self::StateSize, Self::Serialize, Self::Reset];

    /// Those that compare motions, after all others: only of an FMU that repeats its runs they say something.
    pub(super) const MOTION: [Self; 2] = [Self::HalfSteps, Self::EventMode];
}

/// One that knows nothing but the first run.
pub(super) fn begun(setup: &SystemSetup, steps: usize, reference: &[f64], facts: &Facts) -> SelfTest {
    let rows = setup.columns();
    let range = |c: usize| {
        let column = reference.iter().skip(c).step_by(rows);
        let (low, high) = column.fold((f64::MAX, f64::MIN), |(l, h), &v| (l.min(v), h.max(v)));
        high - low
    };
    SelfTest {
        steps,
        step_s: setup.step_s,
        inputs: setup.inputs.len(),
        outputs: rows,
        deterministic: Agreement::NotOffered,
        second_instance: Agreement::NotOffered,
        restore: Agreement::NotOffered,
        fork: Agreement::NotOffered,
        fresh_process: Agreement::NotOffered,
        reset: Agreement::NotOffered,
        serialize: Agreement::NotOffered,
        half_steps: facts.against_half_steps.clone().map_or_else(Motion::default, |why| Motion::NotTried { why }),
        event_mode: facts.against_other_mode.clone().map_or_else(Motion::default, |why| Motion::NotTried { why }),
        uses_event_mode: facts.event_mode.contains(&true),
        remarks: facts.remarks.clone(),
        bytes_per_state: None,
        output_range: (0..setup.outputs.len()).map(range).fold(0.0, f64::max),
    }
}

/// Notes what a stage found.
pub(super) fn note(result: &mut SelfTest, stage: Stage, found: Found) {
    match (stage, found) {
        (Stage::FirstRun | Stage::Deterministic, Found::Agreement(found)) => result.deterministic = found,
        (Stage::SecondInstance, Found::Agreement(found)) => result.second_instance = found,
        (Stage::Restore, Found::Agreement(found)) => result.restore = found,
        (Stage::StateSize | Stage::Serialize, Found::Agreement(found)) => result.serialize = found,
        (Stage::Reset, Found::Agreement(found)) => result.reset = found,
        (Stage::HalfSteps, Found::Motion(found)) => result.half_steps = found,
        (Stage::EventMode, Found::Motion(found)) => result.event_mode = found,
        (_, Found::Bytes(bytes)) => result.bytes_per_state = Some(bytes),
        (Stage::HalfSteps | Stage::EventMode, Found::Agreement(_)) | (_, Found::Motion(_)) => {}
    }
}

/// Whether a stage makes sense after what was found before it.
pub(super) fn wants(result: &SelfTest, stage: Stage, skip: &[Stage]) -> bool {
    !skip.contains(&stage) && (stage != Stage::Serialize || result.bytes_per_state.is_some())
}

/// Whether a stage that compares motions makes sense after what was found before it; notes it if not. `remembered` if the
/// first run need not be made again for it, in the same process.
pub(super) fn wants_motion(result: &mut SelfTest, stage: Stage, skip: &[Stage], remembered: bool) -> bool {
    let repeats = result.repeatable() && (remembered || result.deterministic == Agreement::Exact);
    let noted = if stage == Stage::HalfSteps { &mut result.half_steps } else { &mut result.event_mode };
    if skip.contains(&stage) || *noted != Motion::default() {
        return false;
    }
    if !repeats {
        *noted = Motion::NotTried { why: Untried::NotRepeated };
    }
    repeats
}

/// What a stage finds.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) enum Found {
    /// How runs compare.
    Agreement(Agreement),
    /// Bytes of a serialised state.
    Bytes(usize),
    /// How motions compare.
    Motion(Motion),
}

impl Found {
    /// What it is for a stage that it fails.
    pub(super) fn failed(stage: Stage, error: PlantError) -> Self {
        match stage {
            Stage::HalfSteps | Stage::EventMode => Self::Motion(Motion::from(error)),
            _ => Self::Agreement(Agreement::from(error)),
        }
    }
}

/// Runs the self-test for `steps` communication steps, without the stages in `skip`, all in this process.
///
/// # Errors
/// Only when a first plain run is not possible at all; everything after that is a finding in the result.
pub fn selftest(
    slaves: &[Slave],
    setup: &SystemSetup,
    steps: usize,
    skip: &[Stage],
    activity: Activity,
) -> Result<SelfTest, PlantError> {
    let reference = reference(slaves, setup, steps, activity)?;
    let mut result = begun(setup, steps, &reference, &Facts::of(slaves, setup));
    for later in Stage::LATER {
        if wants(&result, later, skip) {
            note(&mut result, later, stage(slaves, setup, steps, later, &reference, activity));
        }
    }
    for later in Stage::MOTION {
        if wants_motion(&mut result, later, skip, true) {
            note(&mut result, later, stage(slaves, setup, steps, later, &reference, activity));
        }
    }
    Ok(result)
}

/// The main inputs of so many steps, or those of the other branch.
pub(super) fn moving(setup: &SystemSetup, steps: usize, seed: usize) -> Vec<f64> {
    (0..steps).flat_map(|step| input_row(setup, step, steps, seed)).collect()
}

/// The first plain run: what all others are compared with.
pub(super) fn reference(
    slaves: &[Slave],
    setup: &SystemSetup,
    steps: usize,
    activity: Activity,
) -> Result<Vec<f64>, PlantError> {
    let main = moving(setup, steps, 0);
    first_run(slaves, || {
        let plant = System::new(slaves, setup.clone()).map_err(|e| PlantError::of(e.to_string()))?;
        whole(&mut plant.watched(activity), steps, &main)
    })
}

fn whole(plant: &mut impl Plant, steps: usize, inputs: &[f64]) -> Result<Vec<f64>, PlantError> {
    let mut run = plant.restart()?;
    run.extend(plant.advance(steps, inputs)?);
    Ok(run)
}

/// One of the later stages, against the first run.
pub(super) fn stage(
    slaves: &[Slave],
    setup: &SystemSetup,
    steps: usize,
    stage: Stage,
    reference: &[f64],
    activity: Activity,
) -> Found {
    let built = System::new(slaves, setup.clone());
    if let Err(e) = built {
        return Found::failed(stage, PlantError::of(e.to_string()));
    }
    #[expect(clippy::expect_used, reason = "the same setup was built in the line before")]
    let fresh = || System::new(slaves, setup.clone()).expect("the connections form no loop").watched(activity);
    let (main, other) = (moving(setup, steps, 0), moving(setup, steps, 1));
    let again = motion::ReferenceRun { slaves, setup, steps, inputs: &main, activity };
    let (width, columns) = (setup.inputs.len(), Columns::of(setup));
    let compare = |run: Result<Vec<f64>, PlantError>| agreement(reference, run, &columns);
    let offers_states = slaves.iter().all(|slave| slave.capabilities().can_get_and_set_state);
    let serialises = offers_states && slaves.iter().all(|slave| slave.capabilities().can_serialize_state);
    let offered = match stage {
        Stage::Restore => offers_states,
        Stage::StateSize | Stage::Serialize => serialises,
        _ => true,
    };
    if !offered {
        return Found::Agreement(Agreement::NotOffered);
    }
    Found::Agreement(match stage {
        Stage::HalfSteps => return Found::Motion(again.in_half_steps(reference)),
        Stage::EventMode => return Found::Motion(again.in_the_other_mode(reference)),
        Stage::FirstRun | Stage::Deterministic => {
            // This process may not have made the first run, so here are two of its own.
            // The first instance is gone before the second one is made.
            let first = whole(&mut fresh(), steps, &main);
            match first {
                Ok(first) => agreement(&first, whole(&mut fresh(), steps, &main), &columns),
                Err(error) => Agreement::from(error),
            }
        }
        Stage::SecondInstance => {
            // The first one lives, stands somewhere in the middle, and is driven on with other inputs in between.
            let mut first = fresh();
            let half = steps / 2;
            compare((|| {
                first.restart()?;
                first.advance(half, &other[..half * width])?;
                let mut second = fresh();
                let mut run = second.restart()?;
                run.extend(second.advance(half, &main[..half * width])?);
                first.advance(steps - half, &other[half * width..])?;
                run.extend(second.advance(steps - half, &main[half * width..])?);
                Ok(run)
            })())
        }
        Stage::Restore => restore_test(fresh(), reference, (&main, &other), steps, width, &columns),
        Stage::StateSize => match state_size(fresh()) {
            Ok(bytes) => return Found::Bytes(bytes),
            Err(error) => Agreement::from(error),
        },
        Stage::Serialize => serialize_test(&fresh, reference, &main, steps, width, &columns),
        Stage::Reset => compare((|| {
            let mut plant = fresh();
            plant.restart()?;
            plant.advance(steps, &other)?;
            let mut run = plant.reset()?;
            run.extend(plant.advance(steps, &main)?);
            Ok(run)
        })()),
    })
}

/// A first plain run. An FMU that has an Event Mode and fails without it is tried once more with it, and keeps it if
/// that is better: this is decided here, before anything is searched, so that all later runs are alike.
fn first_run(slaves: &[Slave], run: impl Fn() -> Result<Vec<f64>, PlantError>) -> Result<Vec<f64>, PlantError> {
    let error = match run() {
        Ok(rows) => return Ok(rows),
        Err(error) => error,
    };
    let may_prefer = |slave: &&Slave| slave.capabilities().has_event_mode && !slave.prefers_event_mode();
    let others: Vec<&Slave> = slaves.iter().filter(may_prefer).collect();
    if error.fatal || others.is_empty() {
        return Err(error);
    }
    others.iter().for_each(|slave| slave.prefer_event_mode(true));
    run().map_err(|_| {
        others.iter().for_each(|slave| slave.prefer_event_mode(false));
        error
    })
}

/// Most states that are held at once, besides the start.
const HELD_STATES: usize = 7;

/// Steps after which states are saved: right after inputs changed, and in the middle of a stretch in which they are held.
fn saved_after(steps: usize) -> Vec<usize> {
    let mut found: Vec<usize> = Vec::new();
    let mut begins = 0;
    for (number, length) in STRETCHES.iter().cycle().enumerate() {
        if begins >= steps {
            break;
        }
        let places = if number == 0 { vec![length / 2] } else { vec![begins + 1, begins + length / 2] };
        found.extend(places.into_iter().filter(|place| (1..steps).contains(place)));
        begins += length;
    }
    found.dedup();
    // The last stretches count as much as the first ones.
    if found.len() > HELD_STATES {
        let late = found.split_off(found.len() - 2);
        found.truncate(HELD_STATES - late.len());
        found.extend(late);
    }
    found
}

/// States held at once; other branches in between; each returned to twice, and the first one once more at the end.
pub(super) fn restore_test(
    mut plant: impl Plant,
    reference: &[f64],
    (main, other): (&[f64], &[f64]),
    steps: usize,
    width: usize,
    columns: &Columns,
) -> Agreement {
    let rows = columns.names.len();
    let after = |n: usize| &reference[(1 + n) * rows..];
    let outcome = (|| {
        let mut run = plant.restart()?;
        let at_start = plant.save()?;
        let (mut held, mut at) = (Vec::new(), 0);
        for k in saved_after(steps) {
            run.extend(plant.advance(k - at, &main[at * width..k * width])?);
            held.push((k, plant.save()?));
            at = k;
        }
        run.extend(plant.advance(steps - at, &main[at * width..])?);
        let mut all = vec![agreement(reference, Ok(run), columns)];
        for (k, state) in &held {
            let k = *k;
            plant.restore(state)?;
            all.push(agreement(after(k), plant.advance(steps - k, &main[k * width..]), columns));
            plant.restore(state)?;
            plant.advance(steps - k, &other[k * width..])?;
            plant.restore(state)?;
            all.push(agreement(after(k), plant.advance(steps - k, &main[k * width..]), columns));
        }
        plant.restore(&at_start)?;
        all.push(agreement(after(0), plant.advance(steps, main), columns));
        plant.restore(&at_start)?;
        plant.advance(steps, other)?;
        if let Some((k, state)) = held.first() {
            plant.restore(state)?;
            all.push(agreement(after(*k), plant.advance(steps - k, &main[k * width..]), columns));
        }
        plant.restore(&at_start)?;
        all.push(agreement(after(0), plant.advance(steps, main), columns));
        Ok::<_, PlantError>(all)
    })();
    match outcome {
        Ok(all) => all.into_iter().find(|a| *a != Agreement::Exact).unwrap_or(Agreement::Exact),
        Err(error) => Agreement::from(error),
    }
}

/// Bytes of a serialised state.
fn state_size(mut plant: System) -> Result<usize, PlantError> {
    plant.restart()?;
    let state = plant.save()?;
    Ok(plant.serialize(&state)?.size())
}

fn serialize_test(
    fresh: &dyn Fn() -> System,
    reference: &[f64],
    main: &[f64],
    steps: usize,
    width: usize,
    columns: &Columns,
) -> Agreement {
    let k = steps / 4;
    let outcome = (|| {
        let mut first = fresh();
        first.restart()?;
        first.advance(k, &main[..k * width])?;
        let state = first.save()?;
        let bytes = first.serialize(&state)?;
        // The first instance is gone before the bytes are used: a pointer in them shows itself.
        drop(state);
        drop(first);
        let mut second = fresh();
        second.restart()?;
        let state = second.deserialize(&bytes)?;
        second.restore(&state)?;
        second.advance(steps - k, &main[k * width..])
    })();
    agreement(&reference[(1 + k) * columns.names.len()..], outcome, columns)
}

/// Steps for which Real inputs are held, one stretch after the other; then from the first again.
const STRETCHES: [usize; 6] = [3, 17, 5, 11, 7, 13];

/// The number of the stretch that a step belongs to.
fn stretch(step: usize) -> usize {
    let round = STRETCHES.iter().sum::<usize>();
    let mut left = step % round;
    let within = STRETCHES.iter().take_while(|length| {
        let passed = left >= **length;
        left -= if passed { **length } else { 0 };
        passed
    });
    step / round * STRETCHES.len() + within.count()
}

/// Inputs that move: reals sway about their start and are held between, Booleans flip in a pattern without a short period.
///
/// In the main run (`seed` 0) Booleans stay at their start for the first three fifths, so that a cell which latches a
/// protective stop still moves where states are saved; the other branch stops it early.
pub(super) fn input_row(setup: &SystemSetup, step: usize, steps: usize, seed: usize) -> Vec<f64> {
    let quiet = seed == 0 && step * 5 < steps * 3;
    let sway = |column: usize| {
        // Between -1 and 1 in sixteenths, by an odd factor that differs by column and seed: never twice the same.
        let sixteenths = (stretch(step) * (5 + 2 * column + 6 * seed)) % 16;
        #[expect(clippy::cast_precision_loss, reason = "small numbers")]
        let phase = sixteenths as f64 / 16.0;
        1.0 - 4.0 * (phase - 0.5).abs()
    };
    let value = |(column, (port, start)): (usize, (&Port, &f64))| match port.kind {
        PortKind::Real => start + 0.1 * start.abs().max(1.0) * sway(column),
        PortKind::Integer => *start,
        PortKind::Boolean if !quiet && (step / (4 + seed) + column) % 3 == 1 => 1.0 - start,
        PortKind::Boolean => *start,
    };
    setup.inputs.iter().map(|p| &p.port).zip(&setup.initial_inputs).enumerate().map(value).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn states_are_saved_right_after_a_change_and_in_the_middle_of_a_stretch() {
        assert_eq!([0, 2, 3, 19, 20, 55, 56, 58, 59].map(stretch), [0, 0, 1, 1, 2, 5, 6, 6, 7]);
        let saved = saved_after(80);
        assert!(saved.len() == HELD_STATES && saved.is_sorted(), "{saved:?}");
        // The second stretch is steps 3 to 19: the state after its first step, and after its ninth.
        assert!(saved.contains(&4) && saved.contains(&11), "{saved:?}");
        for steps in 2..100 {
            assert!(saved_after(steps).iter().all(|k| (1..steps).contains(k)), "{steps}");
        }
    }
}
