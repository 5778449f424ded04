//! The state self-test: what an FMU's promises about its state are worth, found by trying.
//!
//! The FMI texts do not promise that a restored FMU behaves like the uninterrupted one, and `fmi2Reset` is often wrong
//! in practice. So before a search relies on either, the *future* after coming back is compared, over a whole episode
//! with moving inputs, holding two states at once and returning to the first (a state that shares a buffer, or that
//! forgets a hidden clock, passes simpler tests).

use std::fmt;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::activity::Activity;
use super::plant::{Plant, PlantError};
use super::port::{Port, PortKind};
use super::system::{System, SystemSetup};
use crate::fmi::Slave;

/// How two runs that should agree compare.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", tag = "result")]
pub enum Agreement {
    /// Every bit of every output.
    Exact,
    /// Different; the largest relative difference `|a - b| / max(1, |a|)`.
    Differs {
        /// Largest relative difference.
        largest: f64,
    },
    /// The FMU returned an error.
    Failed {
        /// What it said.
        reason: String,
    },
    /// The FMU does not offer this.
    NotOffered,
}

impl fmt::Display for Agreement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Exact => f.write_str("exact"),
            Self::Differs { largest } => write!(f, "WRONG, differs by up to {largest:.2e}"),
            Self::Failed { reason } => write!(f, "FAILED: {reason}"),
            Self::NotOffered => f.write_str("not offered"),
        }
    }
}

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
}

impl Stage {
    const ALL: [Self; 7] = [
        Self::FirstRun,
        Self::Deterministic,
        Self::SecondInstance,
        Self::Restore,
        Self::StateSize,
        Self::Serialize,
        Self::Reset,
    ];

    /// A number for it, from 1.
    pub(super) fn number(self) -> u32 {
        Self::ALL.iter().zip(1..).find(|(stage, _)| **stage == self).map_or(0, |(_, number)| number)
    }

    /// The stage with this number.
    pub(super) fn numbered(number: u32) -> Option<Self> {
        Self::ALL.get(usize::try_from(number).ok()?.checked_sub(1)?).copied()
    }
}

/// The outcome of the self-test.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SelfTest {
    /// Steps of one run.
    pub steps: usize,
    /// Communication step, s.
    pub step_s: f64,
    /// Inputs moved and outputs compared.
    pub inputs: usize,
    /// Outputs compared.
    pub outputs: usize,
    /// Two fresh instances, one after the other, same inputs.
    pub deterministic: Agreement,
    /// A second instance beside a living first one.
    pub second_instance: Agreement,
    /// Restoring a state against the uninterrupted run: two states held, both returned to, the first one twice.
    pub restore: Agreement,
    /// The same with copies of the FMU's process as states, for FMUs in workers.
    pub fork: Agreement,
    /// Two fresh processes, for FMUs in workers.
    pub fresh_process: Agreement,
    /// `fmi2Reset` against a fresh instance.
    pub reset: Agreement,
    /// A serialised state brought back in another instance.
    pub serialize: Agreement,
    /// Bytes of a serialised state.
    pub bytes_per_state: Option<usize>,
    /// Largest change of any output over the run: zero means that nothing moves.
    pub output_range: f64,
}

impl SelfTest {
    /// Whether results can be replayed at all.
    #[must_use]
    pub fn repeatable(&self) -> bool {
        self.deterministic == Agreement::Exact || self.fresh_process == Agreement::Exact
    }

    /// The way of bringing states back that this FMU deserves. `fork_pays` where its actions cost more than a copy of its
    /// process.
    #[must_use]
    pub fn rung(&self, fork_pays: bool) -> Rung {
        match (&self.restore, &self.fork, &self.deterministic) {
            (Agreement::Exact, _, Agreement::Exact) => Rung::SavedStates,
            (_, Agreement::Exact, Agreement::Exact) if fork_pays => Rung::Copies,
            (_, _, Agreement::Exact) => Rung::Instances,
            // One instance in a process: its copies do, and so do fresh processes.
            (_, Agreement::Exact, _) => Rung::Copies,
            _ => Rung::Processes,
        }
    }

    /// At most this many states may be kept within a budget.
    #[must_use]
    pub fn most_states(&self, budget_bytes: usize) -> usize {
        // Without serialisation the size is unknown; 64 KiB is above what small FMUs need.
        let size = self.bytes_per_state.unwrap_or(64 * 1024).max(256);
        (budget_bytes / size).max(16)
    }

    /// Why states are brought back as they are.
    #[must_use]
    pub fn because(&self, rung: Rung) -> String {
        let saving = match &self.restore {
            Agreement::Exact => "restored exactly",
            Agreement::NotOffered => "the FMU cannot save its state",
            Agreement::Differs { .. } | Agreement::Failed { .. } => {
                "the FMU says it can save its state, but does not do it exactly"
            }
        };
        let single = if self.deterministic == Agreement::Exact { "" } else { ", and runs once in a process" };
        format!("{rung} ({saving}{single})")
    }
}

/// A way of bringing states back. The results are the same, only the speed differs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Rung {
    /// States saved by the FMU.
    SavedStates,
    /// Copies of the FMU's process.
    Copies,
    /// A fresh instance and the same inputs again.
    Instances,
    /// A fresh process and the same inputs again.
    Processes,
}

impl fmt::Display for Rung {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::SavedStates => "saved FMU states",
            Self::Copies => "copies of the FMU's process",
            Self::Instances => "fresh instance and replay",
            Self::Processes => "fresh process and replay",
        })
    }
}

/// Runs the self-test for `steps` communication steps, without the stages in `skip`; `announce` hears each stage before
/// it begins, so that a crash can be told apart.
///
/// # Errors
/// Only when a first plain run is not possible at all; everything after that is a finding in the result.
pub fn selftest(
    slaves: &[Slave],
    setup: &SystemSetup,
    steps: usize,
    skip: &[Stage],
    activity: Activity,
    announce: &mut dyn FnMut(Stage),
) -> Result<SelfTest, PlantError> {
    let mut wanted = |stage: Stage| {
        let wanted = !skip.contains(&stage);
        if wanted {
            announce(stage);
        }
        wanted
    };
    wanted(Stage::FirstRun);
    let moving = |seed: usize| (0..steps).flat_map(|i| input_row(setup, i, steps, seed)).collect::<Vec<f64>>();
    let (main, other) = (moving(0), moving(1));
    let built = System::new(slaves, setup.clone());
    built.map_err(|e| PlantError::of(e.to_string()))?;
    #[expect(clippy::expect_used, reason = "the same setup was built in the line before")]
    let fresh = || System::new(slaves, setup.clone()).expect("the connections form no loop").watched(activity);
    let width = setup.inputs.len();

    let reference = first_run(slaves, || {
        let mut plant = fresh();
        let mut run = plant.restart()?;
        run.extend(plant.advance(steps, &main)?);
        Ok(run)
    })?;
    let rows = setup.outputs.len();
    let compare = |run: Result<Vec<f64>, PlantError>| agreement(&reference, run);
    let whole = |plant: &mut System| {
        let mut run = plant.restart()?;
        run.extend(plant.advance(steps, &main)?);
        Ok(run)
    };

    let deterministic = if wanted(Stage::Deterministic) { compare(whole(&mut fresh())) } else { Agreement::NotOffered };
    let second_instance = if wanted(Stage::SecondInstance) {
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
    } else {
        Agreement::NotOffered
    };
    let offers_states = slaves.iter().all(|slave| slave.capabilities().can_get_and_set_state);
    let restore = if offers_states && wanted(Stage::Restore) {
        restore_test(fresh(), &reference, &main, &other, steps, width, rows)
    } else {
        Agreement::NotOffered
    };
    let serialises = offers_states && slaves.iter().all(|slave| slave.capabilities().can_serialize_state);
    let size = (serialises && wanted(Stage::StateSize)).then(|| state_size(fresh()));
    let serialize = match &size {
        Some(Err(error)) => Agreement::Failed { reason: error.message.clone() },
        Some(Ok(_)) if wanted(Stage::Serialize) => serialize_test(&fresh, &reference, &main, steps, width, rows),
        _ => Agreement::NotOffered,
    };
    let bytes_per_state = size.and_then(Result::ok);
    let reset = if wanted(Stage::Reset) {
        compare((|| {
            let mut plant = fresh();
            plant.restart()?;
            plant.advance(steps, &other)?;
            let mut run = plant.reset()?;
            run.extend(plant.advance(steps, &main)?);
            Ok(run)
        })())
    } else {
        Agreement::NotOffered
    };
    let output_range = (0..rows)
        .map(|c| {
            let column = reference.iter().skip(c).step_by(rows);
            let (low, high) = column.fold((f64::MAX, f64::MIN), |(l, h), &v| (l.min(v), h.max(v)));
            high - low
        })
        .fold(0.0, f64::max);
    Ok(SelfTest {
        steps,
        step_s: setup.step_s,
        inputs: width,
        outputs: rows,
        deterministic,
        second_instance,
        restore,
        fork: Agreement::NotOffered,
        fresh_process: Agreement::NotOffered,
        reset,
        serialize,
        bytes_per_state,
        output_range,
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

/// Two states held at once; other branches in between; the first state returned to twice.
pub(super) fn restore_test(
    mut plant: impl Plant,
    reference: &[f64],
    main: &[f64],
    other: &[f64],
    steps: usize,
    width: usize,
    rows: usize,
) -> Agreement {
    let k = steps / 4;
    let outcome = (|| {
        let mut run = plant.restart()?;
        let at_start = plant.save()?;
        run.extend(plant.advance(k, &main[..k * width])?);
        let at_k = plant.save()?;
        run.extend(plant.advance(steps - k, &main[k * width..])?);
        let mut all = vec![agreement(reference, Ok(run))];
        let after = |n: usize| &reference[(1 + n) * rows..];
        plant.restore(&at_k)?;
        plant.advance(steps - k, &other[k * width..])?;
        plant.restore(&at_k)?;
        all.push(agreement(after(k), plant.advance(steps - k, &main[k * width..])));
        plant.restore(&at_start)?;
        all.push(agreement(after(0), plant.advance(steps, main)));
        plant.restore(&at_start)?;
        plant.advance(steps, other)?;
        plant.restore(&at_k)?;
        all.push(agreement(after(k), plant.advance(steps - k, &main[k * width..])));
        plant.restore(&at_start)?;
        all.push(agreement(after(0), plant.advance(steps, main)));
        Ok::<_, PlantError>(all)
    })();
    match outcome {
        Ok(all) => all.into_iter().find(|a| *a != Agreement::Exact).unwrap_or(Agreement::Exact),
        Err(e) => Agreement::Failed { reason: e.message },
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
    rows: usize,
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
    agreement(&reference[(1 + k) * rows..], outcome)
}

pub(super) fn agreement(reference: &[f64], run: Result<Vec<f64>, PlantError>) -> Agreement {
    match run {
        Err(e) => Agreement::Failed { reason: e.message },
        Ok(run) if run.len() != reference.len() => Agreement::Failed { reason: "runs of different length".to_owned() },
        Ok(run) => {
            let same = run.iter().zip(reference).all(|(a, b)| a.to_bits() == b.to_bits());
            let difference = |(a, b): (&f64, &f64)| (a - b).abs() / b.abs().max(1.0);
            match same {
                true => Agreement::Exact,
                false => Agreement::Differs { largest: run.iter().zip(reference).map(difference).fold(0.0, f64::max) },
            }
        }
    }
}

/// Inputs that move: reals sway about their start, Booleans flip in a pattern without a short period.
///
/// In the main run (`seed` 0) Booleans stay at their start for the first three fifths, so that a cell which latches a
/// protective stop still moves where states are saved; the other branch stops it early.
pub(super) fn input_row(setup: &SystemSetup, step: usize, steps: usize, seed: usize) -> Vec<f64> {
    let quiet = seed == 0 && step * 5 < steps * 3;
    let sway = |column: usize| {
        // A triangle wave in -1..1 with a period that differs by column and seed.
        let period = 11 + 3 * column + 5 * seed;
        #[expect(clippy::cast_precision_loss, reason = "small numbers")]
        let phase = (step % period) as f64 / period as f64;
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
