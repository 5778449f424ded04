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
//! do at all ([`HARDEST`](crate::cell::binding::HARDEST)): it may still not have been put somewhere else.
//!
//! **Every figure is a greatest, a first or a set**, so that it does not matter how often a step is looked at, nor in which
//! order: the same states give the same figures, however they are brought back.

use std::collections::BTreeSet;

use super::robot::RobotFrame;
use crate::cell::binding::{Derived, HARDEST, MotionBinding, Reader, jumps};
use crate::cell::{Binding, Workcell};
use crate::geometry::kinematics::Motion as JointMotion;

/// Time over which roughly rounded outputs are told from a motion, s.
const SPAN_S: f64 = 0.02;

/// What roundings may make of a speed over [`SPAN_S`]: rad/s, m/s.
const ROUGH: [f64; 2] = [0.02, 0.01];

/// Part of a speed that says nothing.
const RELATIVE: f64 = 0.02;

/// Robots faster than this are not built, m/s: tool centres of six-axis robots reach 2 to 8 m/s by their data sheets,
/// those of the fastest SCARA and delta robots about 12 m/s.
pub const IMPLAUSIBLE_M_S: f64 = 12.0;

/// A speed up to so much above the limit in a URDF is not told.
const ABOVE_LIMIT: f64 = 1.05;

/// What moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// A joint, by its place in the cell file.
    Joint(usize),
    /// The origin of a frame, likewise.
    Velocity(usize),
    /// How a frame turns, likewise.
    AngularVelocity(usize),
}

/// Something that moves, and what is told of its speed.
#[derive(Clone, Debug)]
pub struct Signal {
    /// Index of the robot.
    pub robot: usize,
    /// Which part of it.
    pub part: Part,
    /// Whether speeds are in rad/s, else in m/s.
    pub turns: bool,
    /// Its mean speed over a step, by component.
    way: Vec<Derived>,
    /// Its speed by the FMU, by component; nothing if it is differentiated.
    told: Option<Vec<Reader>>,
    /// Outputs that tell the speed, by their columns.
    pub variables: Vec<usize>,
    /// The fastest that it may be, by its URDF.
    pub limit: Option<f64>,
}

/// Three components at most, and how many count.
type Value = [f64; 3];

fn length(value: &Value) -> f64 {
    value.iter().map(|v| v * v).sum::<f64>().sqrt()
}

impl Signal {
    fn new(robot: usize, part: Part, way: Vec<Derived>, speeds: &[Reader], turns: bool) -> Option<Self> {
        let columns: Option<Vec<Vec<usize>>> = speeds.iter().map(Reader::given).collect();
        let told = columns.is_some().then(|| speeds.to_vec());
        let mut variables = columns.unwrap_or_default().concat();
        variables.dedup();
        (!speeds.is_empty()).then_some(Self { robot, part, turns, way, told, variables, limit: None })
    }

    /// Whether the FMU tells its speed.
    #[must_use]
    pub const fn is_told(&self) -> bool {
        self.told.is_some()
    }

    fn mean(&self, now: &[f64], before: &[f64], seconds: f64) -> Value {
        let mut all = Vec::with_capacity(3);
        self.way.iter().for_each(|way| way.append(now, before, seconds, &mut all));
        std::array::from_fn(|c| all.get(c).copied().unwrap_or_default())
    }

    fn speed(&self, row: &[f64]) -> Value {
        let read = |c: usize| self.told.as_ref().and_then(|told| told.get(c)).map_or(0.0, |reader| reader.read(row));
        std::array::from_fn(read)
    }

    fn rough(&self) -> f64 {
        ROUGH[usize::from(!self.turns)]
    }
}

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

/// A step at which the speed that is told is not that of the motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disagreement {
    /// By how much it is beyond what the step explains, rad/s or m/s.
    pub beyond: f64,
    /// Number of the step from the person's beginning, from 1.
    pub step: usize,
    /// The speed of the motion; a length if it has components.
    pub motion: f64,
    /// The speed that is told.
    pub told: f64,
}

/// What was seen of a [`Signal`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Seen {
    /// The largest disagreement.
    pub worst: Option<Disagreement>,
    /// Numbers of the steps at which the two disagree.
    pub steps: BTreeSet<usize>,
    /// Whether it was told to be slower than it is, and whether faster.
    pub slower_faster: [bool; 2],
    /// The fastest by its motion, and as told, with the number of the step.
    pub fastest: [(f64, usize); 2],
    /// Least and greatest motion in parts of what is told, where they disagree and what is told hardly changes.
    pub ratio: Option<[f64; 2]>,
    /// Signals whose motion the told speed is where the two disagree, and those whose it is not.
    others: [BTreeSet<usize>; 2],
    /// Whether it was somewhere else at first: outputs after initialisation that are no pose of the robot.
    pub jumped: bool,
}

/// What was seen of everything that moves.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Motion {
    seen: Vec<Seen>,
    /// The greatest speed of a link that no robot has: index of the link, m/s, number of the step.
    pub implausible: Option<(usize, f64, usize)>,
    /// Whether anything changed its place.
    pub moved: bool,
    /// Number of the last step that was looked at.
    pub last: usize,
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

    /// Looks at rows of outputs, one a step, of which the first has the number `from` (0 is the person's beginning) and those
    /// from index `new` on have not been looked at with what goes before them.
    pub fn look(&self, rows: &[f64], from: usize, new: usize, motion: &mut Motion) {
        let rows: Vec<&[f64]> = rows.chunks(self.columns.max(1)).collect();
        motion.seen.resize(self.signals.len(), Seen::default());
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
        motion.moved |= length(&mean) > rough;
        let known = end < rows.last;
        let creeps = known && end >= rows.first + self.long && step.is_multiple_of((self.long / 8).max(1));
        let long = (end, self.long);
        motion.moved |= creeps && length(&rows.mean(number, long)) > signal.rough() / 10.0;
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

    fn disagreement(&self, number: usize, rows: &Rows, way: (usize, usize), rough: f64, seen: &mut Seen) {
        let (mean, own) = (rows.mean(number, way), rows.around(number, way));
        let beyond = rows.beyond(number, number, way, rough);
        let fastest = own.iter().map(length).fold(0.0, f64::max);
        let slowest = own.iter().map(length).fold(f64::INFINITY, f64::min);
        seen.slower_faster[0] |= length(&mean) > fastest + rough;
        seen.slower_faster[1] |= length(&mean) < slowest - rough;
        let one = matches!(self.signals[number].part, Part::Joint(_));
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

impl Motion {
    /// Looks at the robots after the steps from number `from` on for links faster than any robot's.
    pub fn look_at_links(&mut self, frames: &[RobotFrame], from: usize) {
        for (i, frame) in frames.iter().enumerate().filter(|(_, frame)| frame.fastest > IMPLAUSIBLE_M_S) {
            for link in 0..frame.links.len() {
                let (speed, step) = (frame.certain_speed(link), from + i);
                let known = self.implausible.map_or((IMPLAUSIBLE_M_S, usize::MAX, 0), |(l, s, at)| (s, at, l));
                let first = speed >= known.0 && (step, link) < (known.1, known.2);
                if speed > known.0 || (first && self.implausible.is_some()) {
                    self.implausible = Some((link, speed, step));
                }
            }
        }
    }

    /// What was seen of each signal.
    #[must_use]
    pub fn seen(&self) -> &[Seen] {
        &self.seen
    }

    /// Whether some told speed is not that of the motion.
    #[must_use]
    pub fn disagrees(&self) -> bool {
        self.seen.iter().any(|seen| seen.worst.is_some())
    }

    /// Whether outputs were no pose of the robot at first.
    #[must_use]
    pub fn jumped(&self) -> bool {
        self.seen.iter().any(|seen| seen.jumped)
    }

    /// Adds what was seen in other runs of the same cell.
    pub fn merge(&mut self, other: &Self) {
        let count = self.seen.len().max(other.seen.len());
        self.seen.resize(count, Seen::default());
        self.seen.iter_mut().zip(&other.seen).for_each(|(seen, other)| seen.merge(other));
        let further = |a: &(usize, f64, usize), b: &(usize, f64, usize)| {
            a.1.total_cmp(&b.1).then_with(|| (b.2, b.0).cmp(&(a.2, a.0)))
        };
        self.implausible = self.implausible.into_iter().chain(other.implausible).max_by(further);
        self.moved |= other.moved;
        self.last = self.last.max(other.last);
    }
}

impl Seen {
    /// Signals whose motion the told speed is wherever it disagrees with its own.
    pub fn of_others(&self) -> impl Iterator<Item = usize> {
        self.others[0].difference(&self.others[1]).copied()
    }

    /// Whether it is told never to move.
    #[must_use]
    pub fn told_still(&self) -> bool {
        self.fastest[1].0 <= 0.0
    }

    /// The speed above the limit, and the number of the step.
    #[must_use]
    pub fn above(&self, limit: f64) -> Option<(f64, usize)> {
        let fastest = if self.fastest[1].0 > self.fastest[0].0 { self.fastest[1] } else { self.fastest[0] };
        Some(fastest).filter(|(speed, _)| *speed > ABOVE_LIMIT * limit)
    }

    fn merge(&mut self, other: &Self) {
        if let Some(theirs) = other.worst
            && self.worst.is_none_or(|own| (theirs.beyond, own.step) > (own.beyond, theirs.step))
        {
            self.worst = Some(theirs);
        }
        self.steps.extend(&other.steps);
        for (own, theirs) in self.slower_faster.iter_mut().zip(other.slower_faster) {
            *own |= theirs;
        }
        for (own, theirs) in self.fastest.iter_mut().zip(other.fastest) {
            if theirs.0 > own.0 || (theirs.0 >= own.0 && theirs.1 < own.1) {
                *own = theirs;
            }
        }
        let both = self.ratio.into_iter().chain(other.ratio);
        self.ratio = both.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])]);
        for (own, theirs) in self.others.iter_mut().zip(&other.others) {
            own.extend(theirs);
        }
        self.jumped |= other.jumped;
    }
}

/// All that moves in a cell.
fn signals(cell: &Workcell, binding: &Binding) -> Vec<Signal> {
    let rate = |of: &Reader, turns: bool| Derived::Rate { of: of.clone(), turns };
    let mut all = Vec::new();
    for (robot, (told, bound)) in cell.robots.iter().zip(&binding.robots).enumerate() {
        match &bound.motion {
            MotionBinding::Joints { positions, speeds } => {
                for (joint, (position, speed)) in positions.iter().zip(speeds).enumerate() {
                    // One that is held is read from nothing.
                    if position.given().is_some_and(|columns| columns.is_empty()) {
                        continue;
                    }
                    let Some(kinematics) = &told.kinematics else { continue };
                    let of = |(at, driven): (usize, &crate::cell::validate::Driven)| {
                        (driven.named == joint).then_some((at, driven.factor))
                    };
                    let moved: Vec<(usize, f64)> = kinematics.driven.iter().enumerate().filter_map(of).collect();
                    let Some((first, _)) = moved.first() else { continue };
                    let turns = kinematics.tree.joints[*first].motion == JointMotion::Revolute;
                    let limits = moved.iter().filter(|(_, factor)| *factor != 0.0);
                    let limits = limits.filter_map(|(at, factor)| Some(kinematics.fastest[*at]? / factor.abs()));
                    let limit = limits.reduce(f64::min);
                    let signal = Signal::new(
                        robot,
                        Part::Joint(joint),
                        vec![rate(position, turns)],
                        std::slice::from_ref(speed),
                        turns,
                    );
                    all.extend(signal.map(|signal| Signal { limit, ..signal }));
                }
            }
            MotionBinding::Frames(frames) => {
                for (number, frame) in frames.iter().enumerate() {
                    let way = frame.position.iter().map(|of| rate(of, false)).collect();
                    all.extend(Signal::new(robot, Part::Velocity(number), way, &frame.velocity, false));
                    if frame.orientation != crate::cell::binding::Orientation::Unknown {
                        let way = vec![Derived::Turning { of: frame.orientation.clone() }];
                        let part = Part::AngularVelocity(number);
                        all.extend(Signal::new(robot, part, way, &frame.angular_velocity, true));
                    }
                }
            }
        }
    }
    all
}
