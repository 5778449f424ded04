//! Whether an FMU moves alike in other communication steps, and with its Event Mode and without.
//!
//! What an FMU drops at an event, or what depends on the communication step, is the same in every run of the same steps: no
//! comparison of such runs shows it. These compare other runs, and so by how much and not bit by bit.

use fmu_self_test::{Apart, Motion, Untried};

use super::agreement::Columns;
use super::whole;
use crate::fmi::Slave;
use crate::host::activity::Activity;
use crate::host::in_process::{NO_NUMBER, REFUSED};
use crate::host::plant::PlantError;
use crate::host::port::PortKind;
use crate::host::system::{System, SystemSetup};

/// Motions are the same that are no farther apart, as a share of what an output ranges over, or of the rows of one that counts or
/// is true or false: solvers step otherwise.
const ALIKE: f64 = 0.02;

/// A number that ranges over less does not move: of its largest value, or of its unit where that is more.
const STILL: f64 = 1e-4;

/// There is nothing to compare.
impl From<PlantError> for Motion {
    fn from(error: PlantError) -> Self {
        Self::Failed { reason: error.message }
    }
}

/// Of a reference and a run with a row after each half of its steps; the first `bound` columns are bound.
fn compared(reference: &[f64], halves: &[f64], columns: &Columns, bound: usize) -> Motion {
    let width = columns.names.len().max(1);
    if halves.len() + width != 2 * reference.len() {
        return Motion::from(PlantError::of("runs of different length"));
    }
    let column =
        |rows: &[f64], column: usize| -> Vec<f64> { rows.iter().skip(column).step_by(width).copied().collect() };
    let apart = |at: usize| {
        let share = apart(columns.kind(at), &column(reference, at), &column(halves, at))?;
        Some(Apart { output: columns.names.get(at)?.clone(), share })
    };
    // Of several alike the first one.
    let most = |places: std::ops::Range<usize>| {
        places.filter_map(apart).reduce(|most, other| if other.share > most.share { other } else { most })
    };
    match most(0..bound.min(width)) {
        None => Motion::NotTried { why: Untried::NothingMoved },
        Some(most) if most.share > ALIKE => Motion::Differs { most },
        Some(bound_most) => {
            Motion::Same { most: bound_most, unbound: most(bound..width).filter(|apart| apart.share > ALIKE) }
        }
    }
}

/// How far a column is apart from that of a run with a value after each half of its steps; nothing for one that does not move.
fn apart(kind: PortKind, reference: &[f64], halves: &[f64]) -> Option<f64> {
    let is_value = |v: &f64| v.is_finite() && *v != NO_NUMBER && *v != REFUSED;
    let all = || reference.iter().chain(halves).copied().filter(is_value);
    let (low, high) = all().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
    let size = low.abs().max(high.abs()).max(1.0);
    // Divided first: the difference of two large numbers may be none.
    let range = high / size - low / size;
    let real = kind == PortKind::Real;
    if !range.is_finite() || range <= if real { STILL } else { 0.0 } {
        return None;
    }
    let near = if real { 1 } else { 2 };
    let off = reference.iter().enumerate().filter(|(_, value)| is_value(value)).map(|(row, value)| {
        let from = (2 * row).saturating_sub(near);
        let around = &halves[from..(2 * row + near + 1).min(halves.len())];
        // Of a number after the last step nothing is known half a step later.
        if !around.iter().all(is_value) || real && row + 1 == reference.len() {
            return 0.0;
        }
        if !real {
            return if around.contains(value) { 0.0 } else { 1.0 };
        }
        let (low, high) = around.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(*v), h.max(*v)));
        ((low / size - value / size).max(value / size - high / size) / range).max(0.0)
    });
    #[expect(clippy::cast_precision_loss, reason = "rows of a run")]
    let rows = reference.len().max(1) as f64;
    Some(if real { off.fold(0.0, f64::max) } else { off.sum::<f64>() / rows })
}

/// A run with a row after each step, as if it had one after each half too: between the two, where it is a number.
fn with_halves(rows: &[f64], columns: &Columns) -> Vec<f64> {
    let width = columns.names.len().max(1);
    let mut halves = Vec::with_capacity(2 * rows.len());
    for (number, row) in rows.chunks(width).enumerate() {
        if let Some(before) = number.checked_sub(1).map(|n| &rows[n * width..(n + 1) * width]) {
            let between = |(column, (a, b)): (usize, (&f64, &f64))| match columns.kind(column) {
                PortKind::Real => a / 2.0 + b / 2.0,
                PortKind::Integer | PortKind::Boolean => *b,
            };
            halves.extend(before.iter().zip(row).enumerate().map(between));
        }
        halves.extend(row);
    }
    halves
}

/// What a first run is compared with: the FMUs, their setup, the number of its steps and its inputs.
#[derive(Clone, Copy)]
pub(super) struct ReferenceRun<'a> {
    pub slaves: &'a [Slave],
    pub setup: &'a SystemSetup,
    pub steps: usize,
    pub inputs: &'a [f64],
    pub activity: Activity,
}

impl ReferenceRun<'_> {
    /// The first run against the same inputs in half steps.
    pub(super) fn in_half_steps(&self, reference: &[f64]) -> Motion {
        if let Some(why) = against_half_steps(self.slaves, self.setup) {
            return Motion::NotTried { why };
        }
        let half = SystemSetup {
            step_s: self.setup.step_s / 2.0,
            lead_in_steps: 2 * self.setup.lead_in_steps,
            ..self.setup.clone()
        };
        let width = self.setup.inputs.len();
        let inputs: Vec<f64> = match width {
            0 => Vec::new(),
            _ => self.inputs.chunks(width).flat_map(|row| row.repeat(2)).collect(),
        };
        match self.again(&half, 2 * self.steps, &inputs) {
            Ok(halves) => compared(reference, &halves, &Columns::of(self.setup), self.setup.outputs.len()),
            Err(error) if !error.lost && !error.not_started && error.time_s == Some(0.0) => {
                Motion::NotTried { why: Untried::Refused { reason: error.message } }
            }
            Err(error) => Motion::from(error),
        }
    }

    /// The first run against the same one with Event Mode, if that was not used, or without.
    pub(super) fn in_the_other_mode(&self, reference: &[f64]) -> Motion {
        if let Some(why) = against_other_mode(self.slaves) {
            return Motion::NotTried { why };
        }
        let used: Vec<bool> = self.slaves.iter().map(Slave::prefers_event_mode).collect();
        let has = |slave: &Slave| slave.capabilities().has_event_mode;
        self.slaves.iter().filter(|slave| has(slave)).for_each(|s| s.prefer_event_mode(!s.prefers_event_mode()));
        let run = self.again(self.setup, self.steps, self.inputs);
        self.slaves.iter().zip(used).for_each(|(slave, used)| slave.prefer_event_mode(used));
        let columns = Columns::of(self.setup);
        match run {
            Ok(rows) => compared(reference, &with_halves(&rows, &columns), &columns, self.setup.outputs.len()),
            Err(error) => Motion::from(error),
        }
    }

    fn again(&self, setup: &SystemSetup, steps: usize, inputs: &[f64]) -> Result<Vec<f64>, PlantError> {
        let plant = System::new(self.slaves, setup.clone()).map_err(|e| PlantError::of(e.to_string()))?;
        whole(&mut plant.watched(self.activity), steps, inputs)
    }
}

/// Why half steps would say nothing, if they would.
pub(super) fn against_half_steps(slaves: &[Slave], setup: &SystemSetup) -> Option<Untried> {
    let [slave] = slaves else { return Some(Untried::Coupled) };
    if !setup.connections.is_empty() {
        return Some(Untried::Coupled);
    }
    if slave.needs_event_mode() {
        return Some(Untried::Clocks);
    }
    let half = setup.step_s / 2.0;
    let capabilities = slave.capabilities();
    let whole = |own: f64| {
        let count = half / own;
        count > 0.5 && (count - count.round()).abs() < 1e-6
    };
    let named = slave.step_size().filter(|_| !capabilities.can_handle_variable_step);
    let own = capabilities.fixed_internal_step.or(named).filter(|own| *own > 0.0);
    own.filter(|own| !whole(*own)).map(|step_s| Untried::OwnSteps { step_s })
}

/// Why the other of with Event Mode and without would say nothing, if it would.
pub(super) fn against_other_mode(slaves: &[Slave]) -> Option<Untried> {
    if !slaves.iter().any(|slave| slave.capabilities().has_event_mode) {
        return Some(Untried::NoEventMode);
    }
    slaves.iter().any(Slave::needs_event_mode).then_some(Untried::Clocks)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn columns() -> Columns {
        let kinds = vec![PortKind::Real, PortKind::Boolean, PortKind::Real];
        Columns { names: ["q", "clear", "seen"].map(str::to_owned).to_vec(), kinds }
    }

    /// Rows of q, clear and seen after each of 200 half steps of a second: q goes from 0 to 1 with something less, clear is true
    /// from this half step on, and seen, which is not bound, is q or another one.
    fn halves(less: impl Fn(u32) -> f64, clear_from: u32, seen: f64) -> Vec<f64> {
        let row = |n: u32| {
            let q = f64::from(n) / 200.0;
            [q - less(n), f64::from(u8::from(n >= clear_from)), q + seen * q]
        };
        (0..=200).flat_map(row).collect()
    }

    fn wholes(halves: &[f64]) -> Vec<f64> {
        halves.chunks(3).step_by(2).flatten().copied().collect()
    }

    fn of(run: &[f64]) -> Motion {
        compared(&wholes(&halves(|_| 0.0, 80, 0.0)), run, &columns(), 2)
    }

    fn share(motion: &Motion) -> (bool, &str, f64) {
        match motion {
            Motion::Same { most, .. } => (true, &most.output, most.share),
            Motion::Differs { most } => (false, &most.output, most.share),
            other => panic!("{other:?}"),
        }
    }

    /// By hand: a step is a hundredth of the way, half of one is no difference, so 0.05 less of 1.05 is 0.045 of 1.05 apart.
    #[test]
    fn a_motion_is_apart_by_what_no_half_step_makes_up_for() {
        let apart = of(&halves(|_| 0.05, 80, 0.0));
        let (same, output, by) = share(&apart);
        assert!(!same && output == "q" && (by - 0.045 / 1.05).abs() < 1e-12, "{apart}");
        assert_eq!(share(&of(&halves(|_| 0.0, 80, 0.0))), (true, "q", 0.0));
        assert!(share(&of(&halves(|_| 0.005, 80, 0.0))).0, "half a step late");
        // Once, and not in the mean of the run: a tenth in one step of a hundred.
        let once = of(&halves(|n| if (99..=101).contains(&n) { 0.1 } else { 0.0 }, 80, 0.0));
        assert!(!share(&once).0, "{once}");
        // One flank is a step late, another five: four of its 101 rows are not near.
        assert_eq!(share(&of(&halves(|_| 0.0, 82, 0.0))), (true, "q", 0.0));
        let late = of(&halves(|_| 0.0, 90, 0.0));
        let (same, output, by) = share(&late);
        assert!(!same && output == "clear" && (by - 4.0 / 101.0).abs() < 1e-12, "{late}");
    }

    #[test]
    fn what_is_not_bound_is_told_and_decides_nothing() {
        let Motion::Same { unbound: Some(apart), .. } = of(&halves(|_| 0.0, 80, 0.5)) else { panic!("it is bound") };
        assert!(apart.output == "seen" && apart.share > 0.3, "{apart}");
        assert!(matches!(of(&halves(|_| 0.0, 80, 0.01)), Motion::Same { unbound: None, .. }));
    }

    #[test]
    fn what_does_not_move_or_is_no_number_says_nothing() {
        let still = |at: f64, noise: f64| {
            let rows = |sign: f64| -> Vec<f64> {
                (0..=20).flat_map(|n| [at + sign * f64::from(n % 3) * noise, 0.0, 0.0]).collect()
            };
            compared(&wholes(&rows(1.0)), &rows(-1.0), &columns(), 2)
        };
        let nothing = Motion::NotTried { why: Untried::NothingMoved };
        // Noise of a joint that is held, in rad; and of one that stands at 2 m in mm.
        assert_eq!((still(0.0, 1e-5), still(2000.0, 0.04)), (nothing.clone(), nothing));
        assert!(matches!(still(0.0, 1e-3), Motion::Differs { .. }));
        let mut unread = halves(|_| 0.0, 80, 0.5);
        unread.chunks_mut(3).for_each(|row| row[2] = NO_NUMBER);
        assert!(matches!(of(&unread), Motion::Same { unbound: None, .. }));
        assert!(matches!(of(&unread[3..]), Motion::Failed { .. }), "a row is missing");
    }

    /// A run of the same steps is laid between its rows: half a step is no difference there either, and a flank a step late is none.
    #[test]
    fn runs_of_the_same_steps_are_compared_alike() {
        let other = |less: f64, clear_from: u32| {
            let run = wholes(&halves(|_| less, clear_from, 0.0));
            of(&with_halves(&run, &columns()))
        };
        assert_eq!(share(&other(0.0, 82)), (true, "q", 0.0));
        let (same, output, by) = {
            let apart = other(0.05, 80);
            let (a, b, c) = share(&apart);
            (a, b.to_owned(), c)
        };
        assert!(!same && output == "q" && (by - 0.045 / 1.05).abs() < 1e-12, "{by}");
    }
}
