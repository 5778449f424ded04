//! What moves in a cell, and what is told of its speed.

use crate::cell::binding::{Derived, MotionBinding, Orientation, Reader};
use crate::cell::workcell::Driven;
use crate::cell::{Binding, Workcell};
use crate::geometry::kinematics::Motion as JointMotion;

/// What roundings may make of a speed over 20 ms: rad/s, m/s.
const ROUGH: [f64; 2] = [0.02, 0.01];

/// What moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MovingPart {
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
    pub part: MovingPart,
    /// Whether speeds are in rad/s, else in m/s.
    pub turns: bool,
    /// Its mean speed over a step, by component.
    pub(super) way: Vec<Derived>,
    /// Its speed by the FMU, by component; nothing if it is differentiated.
    pub(super) told: Option<Vec<Reader>>,
    /// Outputs that tell the speed, by their columns.
    pub variables: Vec<usize>,
    /// The fastest that it may be, by its URDF.
    pub limit: Option<f64>,
}

/// Three components; those that a signal does not have are 0.
pub(super) type Value = [f64; 3];

pub(super) fn length(value: &Value) -> f64 {
    value.iter().map(|v| v * v).sum::<f64>().sqrt()
}

impl Signal {
    /// Nothing for what has no speed.
    pub(super) fn new(
        robot: usize,
        part: MovingPart,
        way: Vec<Derived>,
        speeds: &[Reader],
        turns: bool,
    ) -> Option<Self> {
        let columns: Option<Vec<Vec<usize>>> = speeds.iter().map(Reader::given).collect();
        let told = columns.is_some().then(|| speeds.to_vec());
        let mut variables = columns.unwrap_or_default().concat();
        variables.dedup();
        (!speeds.is_empty()).then_some(Self { robot, part, turns, way, told, variables, limit: None })
    }

    /// Whether the FMU tells its speed.
    #[must_use]
    pub(crate) const fn is_told(&self) -> bool {
        self.told.is_some()
    }

    /// Its mean speed from one row to a later one.
    pub(super) fn mean(&self, now: &[f64], before: &[f64], seconds: f64) -> Value {
        let mut all = Vec::with_capacity(3);
        self.way.iter().for_each(|way| way.append(now, before, seconds, &mut all));
        std::array::from_fn(|c| all.get(c).copied().unwrap_or_default())
    }

    /// Its speed as it is told.
    pub(super) fn speed(&self, row: &[f64]) -> Value {
        let read = |c: usize| self.told.as_ref().and_then(|told| told.get(c)).map_or(0.0, |reader| reader.read(row));
        std::array::from_fn(read)
    }

    /// What roundings may make of its speed over 20 ms.
    pub(super) fn rough(&self) -> f64 {
        ROUGH[usize::from(!self.turns)]
    }
}

/// All that moves in a cell.
pub(super) fn signals(cell: &Workcell, binding: &Binding) -> Vec<Signal> {
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
                    let of = |(at, driven): (usize, &Driven)| (driven.named == joint).then_some((at, driven.factor));
                    let moved: Vec<(usize, f64)> = kinematics.driven.iter().enumerate().filter_map(of).collect();
                    let Some((first, _)) = moved.first() else { continue };
                    let turns = kinematics.tree.joints[*first].motion == JointMotion::Revolute;
                    let limits = moved.iter().filter(|(_, factor)| *factor != 0.0);
                    let limits = limits.filter_map(|(at, factor)| Some(kinematics.fastest[*at]? / factor.abs()));
                    let limit = limits.reduce(f64::min);
                    let signal = Signal::new(
                        robot,
                        MovingPart::Joint(joint),
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
                    all.extend(Signal::new(robot, MovingPart::Velocity(number), way, &frame.velocity, false));
                    if frame.orientation != Orientation::Unknown {
                        let way = vec![Derived::Turning { of: frame.orientation.clone() }];
                        let part = MovingPart::AngularVelocity(number);
                        all.extend(Signal::new(robot, part, way, &frame.angular_velocity, true));
                    }
                }
            }
        }
    }
    all
}
