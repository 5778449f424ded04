//! What is told of speeds that are not those of the motion, and of motions that no robot makes.

use crate::cell::{Binding, Workcell};
use crate::record::speeds::SpeedRecord;
use crate::sim::motion::{Comparison, Disagreement, IMPLAUSIBLE_M_S, Motion, MovingPart, Signal, SignalObservation};

/// What is told of the motion of a cell's robots.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Speeds {
    /// Speeds that are not those of the motion.
    pub records: Vec<SpeedRecord>,
    /// Of each, the index of the robot, and which part of it.
    places: Vec<(usize, MovingPart)>,
    /// What else is odd.
    pub warnings: Vec<String>,
}

impl Speeds {
    /// What follows from what was seen.
    #[must_use]
    pub fn new(cell: &Workcell, binding: &Binding, motion: &Motion) -> Self {
        let comparison = Comparison::new(cell, binding);
        let (mut records, mut places, mut warnings) = (Vec::new(), Vec::new(), Vec::new());
        let all = Names { cell, binding, comparison: &comparison };
        for (signal, seen) in comparison.signals().iter().zip(motion.seen()) {
            if let Some(worst) = &seen.worst {
                records.push(all.record(signal, seen, worst, motion.last));
                places.push((signal.robot, signal.part));
            }
            if let Some((limit, (speed, step))) = signal.limit.and_then(|limit| Some((limit, seen.above(limit)?))) {
                let unit = unit(signal);
                warnings.push(format!(
                    "{} moves at {speed:.2} {unit} at {:.2} s; its URDF allows {limit:.2} {unit}",
                    all.name(signal),
                    comparison.time_s(step)
                ));
            }
        }
        if motion.jumped() {
            let steps = comparison.unsettled();
            let first = if steps == 1 { "its first step".to_owned() } else { format!("its first {steps} steps") };
            warnings.push(format!(
                "the outputs after initialisation are not the robot's pose: the robot is elsewhere after {first}. That jump \
                 is not taken for a motion; a speed that would be differentiated over it is taken from the step after it"
            ));
        }
        if let Some((link, speed, step)) = motion.implausible {
            warnings.push(format!(
                "`{}` moves at {speed:.1} m/s at {:.2} s. No robot is faster than about {IMPLAUSIBLE_M_S} m/s: look at the \
                 units of angles, positions and speeds in the cell file",
                cell.links[link].name,
                comparison.time_s(step)
            ));
        }
        Self { records, places, warnings }
    }

    /// Why nothing can be certified with these speeds.
    #[must_use]
    pub(crate) fn refusal(&self) -> Option<String> {
        let first = self.records.first()?;
        let more = match self.records.len() {
            1 => String::new(),
            n => format!(" and {} more", n - 1),
        };
        Some(format!(
            "the speed that the FMU tells of {}{more} is not that of its motion: forces that follow from it are wrong",
            first.whose()
        ))
    }

    /// All of it in sentences.
    #[must_use]
    pub fn sentences(&self) -> Vec<String> {
        self.records.iter().map(SpeedRecord::sentence).chain(self.warnings.iter().cloned()).collect()
    }

    /// Where the cell file names the speed of that number: a range of its bytes.
    #[must_use]
    pub(crate) fn named_at(&self, number: usize, cell: &Workcell) -> Option<std::ops::Range<usize>> {
        let (robot, part) = *self.places.get(number)?;
        let robot = cell.file().robots.get(robot)?.get_ref();
        match part {
            MovingPart::Joint(joint) => Some(robot.joints.get(joint)?.speed.as_ref()?.variable.span()),
            MovingPart::Velocity(frame) => Some(robot.frames.get(frame)?.velocity.as_ref()?[0].span()),
            MovingPart::AngularVelocity(frame) => Some(robot.frames.get(frame)?.angular_velocity.as_ref()?[0].span()),
        }
    }
}

const fn unit(signal: &Signal) -> &'static str {
    if signal.turns { "rad/s" } else { "m/s" }
}

/// What things are called.
struct Names<'a> {
    cell: &'a Workcell,
    binding: &'a Binding,
    comparison: &'a Comparison,
}

impl Names<'_> {
    fn part(&self, signal: &Signal) -> String {
        let robot = self.cell.file().robots[signal.robot].get_ref();
        match signal.part {
            MovingPart::Joint(joint) => format!("joint `{}`", robot.joints[joint].name.get_ref()),
            MovingPart::Velocity(frame) => format!("frame `{}`", robot.frames[frame].name.get_ref()),
            MovingPart::AngularVelocity(frame) => {
                format!("the turning of frame `{}`", robot.frames[frame].name.get_ref())
            }
        }
    }

    fn name(&self, signal: &Signal) -> String {
        format!("{} of robot `{}`", self.part(signal), self.cell.robots[signal.robot].name)
    }

    fn variables(&self, signal: &Signal) -> Vec<String> {
        let name = |column: &usize| self.binding.outputs[*column].port.name.clone();
        signal.variables.iter().map(name).collect()
    }

    fn record(&self, signal: &Signal, seen: &SignalObservation, worst: &Disagreement, steps: usize) -> SpeedRecord {
        SpeedRecord {
            robot: self.cell.robots[signal.robot].name.clone(),
            part: self.part(signal),
            variables: self.variables(signal),
            unit: unit(signal),
            time_s: self.comparison.time_s(worst.step),
            motion: worst.motion,
            told: worst.told,
            slower_than_it_is: seen.slower_faster[0],
            steps: seen.steps.len(),
            of_steps: steps,
            cause: self.cause(signal, seen, steps),
        }
    }

    fn cause(&self, signal: &Signal, seen: &SignalObservation, steps: usize) -> Option<String> {
        let names: Vec<String> = self.variables(signal).iter().map(|name| format!("`{name}`")).collect();
        let named = names.join(" with ");
        if seen.reported_zero() {
            return Some(format!("What is told is always 0: {named} may be another variable than was meant"));
        }
        let about = |factor: f64| seen.ratio.is_some_and(|ratio| ratio.iter().all(|r| (r / factor - 1.0).abs() < 0.05));
        let times = |factor: f64| [factor, -factor, 1.0 / factor, -1.0 / factor].into_iter().any(about);
        if about(-1.0) {
            return Some(format!(
                "{named} has the opposite sign: `sign = -1` belongs to the speed if it belongs to the position, and not \
                 otherwise"
            ));
        }
        if times(1f64.to_degrees()) {
            return Some(
                "The two differ 57.3 times: one of them is in degrees and taken as radians, or the other way round. Look at \
                 the `unit` of both"
                    .to_owned(),
            );
        }
        if times(1000.0) {
            return Some(
                "The two differ 1000 times: one is in mm and taken as m. Look at the `unit` of both".to_owned(),
            );
        }
        // One that is told by the same variable is the one that was meant there.
        let all = self.comparison.signals();
        let others: Vec<&Signal> = seen.of_others().map(|other| &all[other]).collect();
        let same = others.iter().find(|other| other.variables == signal.variables);
        if let Some(other) = same.or(others.first()) {
            return Some(format!("{named} is how {} moves: another variable was meant", self.part(other)));
        }
        if seen.steps.len() <= 2 && steps > 10 {
            return Some(
                "There it is put somewhere else: a jump of the model, of which the speed says nothing".to_owned(),
            );
        }
        let [low, high] = seen.ratio?;
        let constant = low * high > 0.0 && (high - low).abs() < 0.1 * low.abs();
        constant.then(|| {
            format!("The motion is {:.2} times what {named} says, everywhere where they differ", (low + high) / 2.0)
        })
    }
}
