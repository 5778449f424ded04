//! Whether the speeds that the FMU tells are those at which it moves.
//!
//! Forces follow from speeds. A cell file that names the wrong variable, or takes degrees for radians, makes them wrong
//! without a sign; so at every step of every run the way that a joint or frame has come is compared with its told speeds.
//!
//! **What a step explains.** Over a step from row `k - 1` to row `k` something moves at `d = (q_k - q_(k-1)) / h` in the mean.
//! If the told speeds are true, `d` lies between the least and the greatest speed within the step. Only those at its
//! ends are known, and some controllers tell them a step late, so it has to lie between the least and the greatest of rows
//! `k - 2` to `k + 1`, or outside by a quarter of their difference (a speed that has its peak within the step, between
//! equal accelerations before and behind it, is told too low by no more), 2 %, and what roughly rounded outputs give:
//! 0.02 rad/s or 0.01 m/s over 20 ms. Steps of less than that are taken together up to it. Roundings do not add up, so
//! over most of an action a tenth of that must do: a robot that creeps is compared, too.
//!
//! The last step of an action is compared when the next is known. Where none follows, it has to be within what a robot can
//! do at all ([`HARDEST`]): it may still not have been put somewhere else.

mod observation;
mod signal;

use self::signal::{Value, length, signals};
use crate::cell::binding::{HARDEST, jumps};
use crate::cell::{Binding, Workcell};

pub use observation::{Disagreement, Motion, SignalObservation};
pub use signal::{MovingPart, Signal};

/// Time over which roughly rounded outputs are told from a motion, s.
const SPAN_S: f64 = 0.02;

/// Part of a speed that says nothing.
const RELATIVE: f64 = 0.02;

/// Robots faster than this are not built, m/s: tool centres of six-axis robots reach 2 to 8 m/s by their data sheets,
/// those of the fastest SCARA and delta robots about 12 m/s.
pub const IMPLAUSIBLE_M_S: f64 = 12.0;

/// What is compared, and how.
#[derive(Clone, Debug)]
pub struct Comparison {
    signals: Vec<Signal>,
    columns: usize,
    step_s: f64,
    /// Steps that are taken together.
    span: usize,
    /// The same for robots that creep.
    long: usize,
    /// Steps of a run before which outputs may be no pose of the robot.
    unsettled: usize,
}

/// Told speeds around a step, by component: least and greatest.
struct Around {
    low: Value,
    high: Value,
}

impl Around {
    fn new(speeds: &[Value]) -> Self {
        let fold = |c: usize, of: fn(f64, f64) -> f64| speeds.iter().map(|v| v[c]).reduce(of).unwrap_or_default();
        Self { low: std::array::from_fn(|c| fold(c, f64::min)), high: std::array::from_fn(|c| fold(c, f64::max)) }
    }

    /// By how much a mean speed is beyond what these explain, given what roundings make of it.
    fn beyond(&self, mean: &Value, rough: f64) -> f64 {
        let fastest = length(&self.low).max(length(&self.high)).max(length(mean));
        let beyond = |c: usize| {
            let allowed = (self.high[c] - self.low[c]) / 4.0 + RELATIVE * fastest + rough;
            (self.low[c] - mean[c]).max(mean[c] - self.high[c]) - allowed
        };
        (0..3).map(beyond).fold(0.0, f64::max)
    }
}

/// Rows that are looked at.
struct Rows {
    /// Those before it do not count.
    first: usize,
    last: usize,
    /// Number of the first.
    from: usize,
    /// Speeds that are told, by signal and row.
    told: Vec<Vec<Value>>,
    /// Mean speeds of the motion, by signal and step.
    ways: Vec<Vec<Value>>,
}

impl Rows {
    /// Mean speed of the motion over so many steps up to row `end`, step by step: what turns on is not lost over them.
    #[expect(clippy::cast_precision_loss, reason = "thousands")]
    fn mean(&self, signal: usize, (end, steps): (usize, usize)) -> Value {
        let ways = &self.ways[signal][end - steps..end];
        std::array::from_fn(|c| ways.iter().map(|way| way[c]).sum::<f64>() / steps as f64)
    }

    /// Told speeds of these steps, and of a row before and behind.
    fn around(&self, signal: usize, (end, steps): (usize, usize)) -> &[Value] {
        let from = (end - steps).saturating_sub(1).max(self.first);
        &self.told[signal][from..=(end + 1).min(self.last)]
    }

    /// By how much the motion of `moving` is beyond what the speed that is told of `signal` explains.
    fn beyond(&self, signal: usize, moving: usize, way: (usize, usize), rough: f64) -> f64 {
        Around::new(self.around(signal, way)).beyond(&self.mean(moving, way), rough)
    }
}

impl Comparison {
    /// Of a cell, from the person's beginning on.
    #[must_use]
    pub fn new(cell: &Workcell, binding: &Binding) -> Self {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most a second of small steps")]
        let span = (SPAN_S / cell.step_s).round().clamp(1.0, 1e6) as usize;
        Self {
            signals: signals(cell, binding),
            columns: binding.outputs.len(),
            step_s: cell.step_s,
            span,
            long: cell.steps_per_action.saturating_sub(2).max(span),
            unsettled: binding.settled_steps().saturating_sub(cell.lead_in_steps()),
        }
    }

    /// What moves.
    #[must_use]
    pub fn signals(&self) -> &[Signal] {
        &self.signals
    }

    /// Steps of a run before which outputs may be no pose of the robot.
    #[must_use]
    pub const fn unsettled(&self) -> usize {
        self.unsettled
    }

    /// Rows that a step is looked at with, itself and one behind it among them.
    #[must_use]
    pub const fn rows(&self) -> usize {
        self.span + 3
    }

    /// Looks at rows of outputs, one a step, of which the first has the number `from` (0 is the person's beginning) and those
    /// from index `new` on have not been looked at with what goes before them.
    pub fn look(&self, rows: &[f64], from: usize, new: usize, motion: &mut Motion) {
        let rows: Vec<&[f64]> = rows.chunks(self.columns.max(1)).collect();
        motion.seen.resize(self.signals.len(), SignalObservation::default());
        let Some(last) = rows.len().checked_sub(1) else { return };
        motion.last = motion.last.max(from + last);
        let told = |signal: &Signal| rows.iter().map(|row| signal.speed(row)).collect();
        let way = |signal: &Signal| rows.windows(2).map(|two| signal.mean(two[1], two[0], self.step_s)).collect();
        let rows = Rows {
            first: self.unsettled.saturating_sub(from),
            last,
            from,
            told: self.signals.iter().map(told).collect(),
            ways: self.signals.iter().map(way).collect(),
        };
        for number in 0..self.signals.len() {
            if from == 0 {
                motion.seen[number].jumped |= self.jumped(&rows.ways[number]);
            }
            for end in new.saturating_sub(1).max(rows.first + 1)..=last {
                self.step(number, &rows, end, motion);
            }
        }
    }

    /// Looks at the step that ends at row `end`.
    fn step(&self, number: usize, rows: &Rows, end: usize, motion: &mut Motion) {
        let (signal, seen) = (&self.signals[number], &mut motion.seen[number]);
        let (way, rough) = self.short(number, rows, end);
        let step = rows.from + end;
        let faster = |known: &mut (f64, usize), speed: f64| {
            if speed > known.0 || (speed >= known.0 && step < known.1) {
                *known = (speed, step);
            }
        };
        let mean = rows.mean(number, way);
        faster(&mut seen.fastest[0], length(&mean));
        let mut moves = length(&mean) > rough;
        let known = end < rows.last;
        let creeps = known && end >= rows.first + self.long && step.is_multiple_of((self.long / 8).max(1));
        let long = (end, self.long);
        moves |= creeps && length(&rows.mean(number, long)) > signal.rough() / 10.0;
        if moves {
            motion.moved.insert(signal.robot);
        }
        if !signal.is_told() {
            return;
        }
        faster(&mut seen.fastest[1], length(&rows.told[number][end]));
        // What a robot can do at all, where it is not known how the told speed goes on.
        let reach = if known { 0.0 } else { HARDEST * self.seconds(way.1) };
        if rows.beyond(number, number, way, rough + reach) > 0.0 {
            self.disagreement(number, rows, way, rough + reach, seen);
        } else if creeps && self.long > self.span && rows.beyond(number, number, long, signal.rough() / 10.0) > 0.0 {
            // What is seen in a short step is told there, and once.
            let short = |end: usize| {
                let (way, rough) = self.short(number, rows, end);
                rows.beyond(number, number, way, rough) > 0.0
            };
            if !(end - self.long + 1..end).any(short) {
                self.disagreement(number, rows, long, signal.rough() / 10.0, seen);
            }
        }
    }

    /// Steps that are taken together at row `end`, and what roundings make of a speed over them.
    fn short(&self, number: usize, rows: &Rows, end: usize) -> ((usize, usize), f64) {
        let span = self.span.min(end - rows.first);
        ((end, span), self.signals[number].rough() * self.seconds(self.span) / self.seconds(span))
    }

    fn disagreement(&self, number: usize, rows: &Rows, way: (usize, usize), rough: f64, seen: &mut SignalObservation) {
        let (mean, own) = (rows.mean(number, way), rows.around(number, way));
        let beyond = rows.beyond(number, number, way, rough);
        let fastest = own.iter().map(length).fold(0.0, f64::max);
        let slowest = own.iter().map(length).fold(f64::INFINITY, f64::min);
        seen.slower_faster[0] |= length(&mean) > fastest + rough;
        seen.slower_faster[1] |= length(&mean) < slowest - rough;
        let one = matches!(self.signals[number].part, MovingPart::Joint(_));
        let shown = |value: &Value| if one { value[0] } else { length(value) };
        let step = rows.from + way.0;
        seen.steps.insert(step);
        if seen.worst.is_none_or(|worst| beyond > worst.beyond || (beyond >= worst.beyond && step < worst.step)) {
            let told = shown(&rows.told[number][way.0]);
            seen.worst = Some(Disagreement { beyond, step, motion: shown(&mean), told });
        }
        let around = Around::new(own);
        let c = (0..3).max_by(|a, b| around.high[*a].abs().total_cmp(&around.high[*b].abs())).unwrap_or(0);
        let middle = (around.high[c] + around.low[c]) / 2.0;
        if around.high[c] - around.low[c] < 0.1 * middle.abs() && middle.abs() > rough {
            let ratio = mean[c] / middle;
            let [low, high] = seen.ratio.unwrap_or([ratio; 2]);
            seen.ratio = Some([low.min(ratio), high.max(ratio)]);
        }
        let kind = |signal: &Signal| (signal.turns, std::mem::discriminant(&signal.part));
        for (other, signal) in self.signals.iter().enumerate() {
            if other == number || kind(signal) != kind(&self.signals[number]) {
                continue;
            }
            if rows.beyond(number, other, way, rough) > 0.0 {
                seen.others[1].insert(other);
            } else if length(&rows.mean(other, way)) > 5.0 * rough {
                seen.others[0].insert(other);
            }
        }
    }

    /// Whether the first rows of a run are no pose of the robot.
    fn jumped(&self, ways: &[Value]) -> bool {
        let Some([next, after]) = ways.get(self.unsettled..self.unsettled + 2) else { return false };
        let jumped = |way: &Value| (0..3).any(|c| jumps(way[c], [next[c], after[c]], self.step_s));
        ways[..self.unsettled].iter().any(jumped)
    }

    #[expect(clippy::cast_precision_loss, reason = "thousands")]
    fn seconds(&self, steps: usize) -> f64 {
        steps as f64 * self.step_s
    }

    /// Time of a step from the person's beginning, s.
    #[must_use]
    pub fn time_s(&self, step: usize) -> f64 {
        self.seconds(step)
    }
}

#[cfg(test)]
#[path = "motion_tests.rs"]
mod tests;
