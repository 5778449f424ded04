//! The robots at one instant: placed link shapes, their velocities, and how hard they would strike.

use std::sync::Arc;

use super::pinch::Pinches;
use crate::cell::binding::{FrameBinding, MotionBinding, Reader, RobotBinding};
use crate::cell::workcell::{Kinematics, Link, Robot};
use crate::cell::{Binding, Workcell};
use crate::geometry::kinematics::{Neighbourhood, Twist};
use crate::geometry::{Inertia, Pose, Solid, Vec3};
use crate::hazard::criterion::pressure::LinkContact;
use crate::hazard::{Contact, Strike};
use crate::standards::BodyRegion;

/// Links that are at rest by their speeds do not move by more, m.
const JUMP_M: f64 = 0.01;

/// The robots after one communication step.
#[derive(Clone, Debug)]
pub struct RobotFrame {
    /// Link shapes in world coordinates, in the order of [`Workcell::links`].
    pub links: Vec<Solid>,
    /// Velocity of each shape.
    twists: Vec<Twist>,
    /// Upper bound on the speed of any point of each shape, m/s.
    pub speed_bounds: Vec<f64>,
    /// Largest entry of `speed_bounds`, m/s.
    pub fastest: f64,
    /// Whether any contact at all could be above its limit: by the speed bounds, whatever is touched.
    pub may_harm: bool,
    /// By how much any point of each shape may be faster than by its velocity, m/s; nothing where none is.
    faster_m_s: Option<Arc<[f64]>>,
    /// Index of each shape's robot.
    robot_of: Vec<usize>,
    /// Index of the joint whose moving side carries each shape, or of the frame.
    joint_of: Vec<usize>,
    /// Index of each shape's strike.
    strike_of: Vec<usize>,
    /// Effective mass and force ratios of links that strike alike.
    strikes: Vec<Strike>,
    /// Programme phase of each robot, where the cell names one.
    phases: Vec<Option<i64>>,
    /// What tells how heavy each robot is at a point, where its inertias are known.
    weights: Vec<Option<Weight>>,
    /// The FMU's outputs behind all this.
    outputs: Vec<f64>,
    /// Where each link may clamp an arm, once it was asked for.
    pub(super) pinches: Pinches,
}

/// A robot whose inertias are known, in one pose.
#[derive(Clone, Debug)]
struct Weight {
    kinematics: Arc<Kinematics>,
    /// Of all joints, rad or m.
    positions: Vec<f64>,
    payload_kg: f64,
}

impl Weight {
    fn new(robot: &Robot, binding: &RobotBinding, outputs: &[f64]) -> Option<Self> {
        let kinematics = robot.kinematics.as_ref().filter(|kinematics| kinematics.masses.is_some())?;
        let MotionBinding::Joints { positions, speeds } = &binding.motion else { return None };
        let (positions, _) = joints(kinematics, positions, speeds, outputs);
        Some(Self { kinematics: Arc::clone(kinematics), positions, payload_kg: binding.payload.read(outputs) })
    }
}

impl RobotFrame {
    /// The robots for one row of FMU outputs, with what is derived from them ([`Binding::rows`]).
    #[must_use]
    pub fn new(cell: &Workcell, binding: &Binding, outputs: &[f64]) -> Self {
        let placed: Vec<Vec<(Pose, Twist)>> =
            cell.robots.iter().zip(&binding.robots).map(|(r, b)| place(r, b, outputs)).collect();
        let of = |l: &Link| placed[l.robot][l.joint];
        let links: Vec<Solid> = cell.links.iter().map(|l| l.shape.placed(of(l).0)).collect();
        let twists: Vec<Twist> = cell.links.iter().map(|l| of(l).1).collect();
        let speed_bounds: Vec<f64> = links.iter().zip(&twists).map(|(s, t)| speed_bound(s, t)).collect();
        let fastest = speed_bounds.iter().copied().fold(0.0, f64::max);
        let strike = |link: &Link| {
            let (robot, b) = (&cell.robots[link.robot], &binding.robots[link.robot]);
            Strike::new(robot.moving_mass_kg, b.payload.read(outputs), cell.criteria, link.contact)
        };
        #[expect(clippy::cast_possible_truncation, reason = "an FMI integer")]
        let phase = |b: &RobotBinding| b.phase.as_ref().map(|r| r.read(outputs) as i64);
        // Links of a robot that touch alike strike alike.
        let mut strikes: Vec<Strike> = Vec::with_capacity(cell.robots.len());
        let mut kinds: Vec<(usize, LinkContact)> = Vec::with_capacity(cell.robots.len());
        let mut strike_of = Vec::with_capacity(cell.links.len());
        for link in &cell.links {
            let kind = (link.robot, link.contact);
            strike_of.push(kinds.iter().position(|known| *known == kind).unwrap_or_else(|| {
                kinds.push(kind);
                strikes.push(strike(link));
                kinds.len() - 1
            }));
        }
        let harms = |(link, bound): (usize, &f64)| strikes[strike_of[link]].may_harm(*bound);
        Self {
            may_harm: speed_bounds.iter().enumerate().any(harms),
            pinches: Pinches::default(),
            links,
            twists,
            speed_bounds,
            fastest,
            faster_m_s: None,
            robot_of: cell.links.iter().map(|l| l.robot).collect(),
            joint_of: cell.links.iter().map(|l| l.joint).collect(),
            strike_of,
            strikes,
            phases: binding.robots.iter().map(phase).collect(),
            weights: cell.robots.iter().zip(&binding.robots).map(|(r, b)| Weight::new(r, b, outputs)).collect(),
            outputs: outputs.to_vec(),
        }
    }

    /// The same with every link as large as everything that is no farther than so from it, m.
    #[must_use]
    pub fn grown(&self, by_m: &[f64]) -> Self {
        self.with_links(self.links.iter().zip(by_m).map(|(link, by_m)| link.grown(*by_m)).collect())
    }

    /// The same where all points of a link may be faster by so much, m/s: what stands for robots that are nearly there and move nearly so.
    #[must_use]
    pub fn standing_for(&self, by_m: &[f64], faster_m_s: Arc<[f64]>) -> Self {
        Self { faster_m_s: Some(faster_m_s), ..self.clone() }.grown(by_m)
    }

    fn faster_m_s(&self, link: usize) -> f64 {
        self.faster_m_s.as_ref().map_or(0.0, |faster| faster[link])
    }

    /// No point of a link is farther from where it is in `other` than so, m.
    #[must_use]
    pub fn moved_from(&self, other: &Self, link: usize) -> f64 {
        self.links[link].moved_from(&other.links[link])
    }

    /// By how much any point of a link may be faster than the point of `other` in the same place, if that may also be slower than it is;
    /// m/s.
    #[must_use]
    pub fn faster_than(&self, other: &Self, link: usize) -> f64 {
        let (centre, radius) = self.links[link].bounding_sphere();
        let [mine, its] = [self, other].map(|frame| frame.twists[link]);
        let [at_mine, at_its] = [mine, its].map(|twist| twist.velocity_at(centre));
        let scale = radius * radius;
        let square = at_its.length_squared() + its.angular.length_squared() * scale;
        let product = at_mine.dot(at_its) + mine.angular.dot(its.angular) * scale;
        let share = if square > 0.0 { (product / square).clamp(0.0, 1.0) } else { 0.0 };
        (at_mine - at_its * share).length() + (mine.angular - its.angular * share).length() * radius
    }

    /// Whether a link strikes as hard as in `other` when it is as fast.
    #[must_use]
    pub fn strikes_as(&self, other: &Self, link: usize) -> bool {
        self.strike(link) == other.strike(link)
    }

    /// The same robots, moving as they do, with other shapes.
    pub(super) fn with_links(&self, links: Vec<Solid>) -> Self {
        let bounds = links.iter().zip(&self.twists).enumerate();
        let speed_bounds: Vec<f64> = bounds.map(|(link, (s, t))| speed_bound(s, t) + self.faster_m_s(link)).collect();
        let fastest = speed_bounds.iter().copied().fold(0.0, f64::max);
        let pinches = Pinches::default();
        Self { fastest, links, speed_bounds, pinches, ..self.clone() }
    }

    /// How far from where it is here or at the end of the step to `next` each link is between them at most, m, of which the nearer
    /// one counts: half of the way that it goes at the faster of its speeds at both, or half of the way between both if that is more.
    /// Of a capsule the core is meant: nothing is farther beyond that than before.
    #[must_use]
    pub fn swept_m(&self, next: &Self, step_s: f64) -> Vec<f64> {
        let speeds = (0..self.links.len()).map(|link| self.core_speed_bound(link).max(next.core_speed_bound(link)));
        let links = self.links.iter().zip(&next.links).zip(speeds);
        links.map(|((from, to), speed)| 0.5 * to.moved_from(from).max(speed * step_s)).collect()
    }

    /// Upper bound on the speed of any point of a link's core, m/s: of a capsule its axis, of others all of it.
    fn core_speed_bound(&self, link: usize) -> f64 {
        if self.links[link].is_capsule() { self.certain_speed(link) } else { self.speed_bounds[link] }
    }

    /// Whether links are much farther from where they were in `before`, a step earlier, than their speeds take them: that was no
    /// pose of the robots.
    #[must_use]
    pub fn jumps_from(&self, before: &Self, step_s: f64) -> bool {
        let swept = before.swept_m(self, step_s);
        let speeds = self.speed_bounds.iter().zip(&before.speed_bounds).map(|(a, b)| a.max(*b));
        swept.iter().zip(speeds).any(|(swept, speed)| *swept > speed * step_s + JUMP_M)
    }

    /// Velocity of the point of shape `link` at world position `point`, m/s, as fast as it may be.
    #[must_use]
    pub fn velocity(&self, link: usize, point: Vec3) -> Vec3 {
        let velocity = self.twists[link].velocity_at(point);
        match self.faster_m_s(link) {
            0.0 => velocity,
            faster => velocity + velocity.try_normalize().unwrap_or(Vec3::X) * faster,
        }
    }

    /// A speed that some point of shape `link` has, m/s: the greatest of those of a capsule's core, or that of the middle of
    /// another shape.
    #[must_use]
    pub(crate) fn certain_speed(&self, link: usize) -> f64 {
        match &self.links[link] {
            Solid::Capsule(c) => self.velocity(link, c.a).length().max(self.velocity(link, c.b).length()),
            solid @ (Solid::Hull(_) | Solid::Mesh(_)) => self.velocity(link, solid.bounding_sphere().0).length(),
        }
    }

    /// Upper bound on the speed that decides a contact of shape `link` with an arm of a person who walks at `human`, m/s: at any
    /// of its points.
    #[must_use]
    pub(crate) fn deciding_speed_bound(&self, link: usize, human: Vec3) -> f64 {
        let relative = || speed_bound(&self.links[link], &self.twists[link].seen_from(human)) + self.faster_m_s(link);
        self.strike(link).deciding_speed_bound(self.speed_bounds[link], relative)
    }

    /// The same at these points.
    #[must_use]
    pub(crate) fn deciding_speed_bound_near(&self, link: usize, points: &Neighbourhood<'_>, human: Vec3) -> f64 {
        let bound = self.speed_bound_near(link, points);
        let relative = || {
            let near = self.twists[link].seen_from(human).speed_bound(points) + self.faster_m_s(link);
            near.min(self.deciding_speed_bound(link, human))
        };
        self.strike(link).deciding_speed_bound(bound, relative)
    }

    /// Upper bound on the speed of these points of shape `link`, m/s.
    #[must_use]
    pub(crate) fn speed_bound_near(&self, link: usize, points: &Neighbourhood<'_>) -> f64 {
        (self.twists[link].speed_bound(points) + self.faster_m_s(link)).min(self.speed_bounds[link])
    }

    /// How hard the robot of shape `link` strikes.
    #[must_use]
    pub fn strike(&self, link: usize) -> &Strike {
        &self.strikes[self.strike_of[link]]
    }

    /// `F_coll / F_max` for a contact of `region` with a point of shape `link` that moves at `speed_m_s`.
    #[must_use]
    pub fn ratio(&self, region: BodyRegion, link: usize, speed_m_s: f64) -> f64 {
        self.strike(link).ratio(region, speed_m_s)
    }

    /// Whether two shapes are carried by the same part of a robot.
    #[must_use]
    pub(crate) fn same_body(&self, one: usize, other: usize) -> bool {
        (self.robot_of[one], self.joint_of[one]) == (self.robot_of[other], self.joint_of[other])
    }

    /// Mass, kg, that whoever pushes at the point of shape `link` at world position `point` along `direction` has to move, by
    /// the inertias of the links and the payload in this pose; infinite where the robot cannot give way there. None where the
    /// inertias are not known, or without a direction. Worked out when asked for.
    #[must_use]
    pub fn reflected_mass_kg(&self, link: usize, point: Vec3, direction: Vec3) -> Option<f64> {
        let Weight { kinematics, positions, payload_kg } = self.weights[self.robot_of[link]].as_ref()?;
        let direction = direction.try_normalize()?;
        let (carrier, centre) = kinematics.payload_at;
        let payload = (*payload_kg > 0.0).then(|| (carrier, Inertia::point(*payload_kg, centre)));
        let placed = kinematics.tree.place(positions);
        let masses = kinematics.masses.as_ref()?;
        Some(masses.reflected_mass_kg(&placed, payload, self.joint_of[link], point, direction))
    }

    /// A contact with one of the links, with the reflected mass there: where the body is hit along the contact's normal, where an
    /// arm is along the velocity of the robot's point.
    #[must_use]
    pub(crate) fn weighed(&self, mut contact: Contact) -> Contact {
        let direction = contact.normal().unwrap_or_else(|| self.velocity(contact.link, contact.on_robot));
        contact.reflected_mass_kg = self.reflected_mass_kg(contact.link, contact.on_robot, direction);
        contact
    }

    /// The number of the robot of shape `link`.
    #[must_use]
    pub(crate) fn robot(&self, link: usize) -> usize {
        self.robot_of[link]
    }

    /// Programme phase of the robot of shape `link`.
    #[must_use]
    pub fn phase(&self, link: usize) -> Option<i64> {
        self.phases[self.robot_of[link]]
    }

    /// The FMU's outputs, in the order of the binding, then what is derived from them.
    #[must_use]
    pub fn outputs(&self) -> &[f64] {
        &self.outputs
    }

    /// Whether any contact at all with one of some links could be above its limit, if these are faster by so much, m/s.
    #[must_use]
    pub fn may_harm_by(&self, counts: &[bool], faster_m_s: f64) -> bool {
        let mut links = self.speed_bounds.iter().enumerate();
        links.any(|(link, bound)| counts[link] && self.strike(link).may_harm(*bound + faster_m_s))
    }

    /// Upper bound on the speed of any point of some links, m/s.
    #[must_use]
    pub fn fastest_of(&self, counts: &[bool]) -> f64 {
        let bounds = self.speed_bounds.iter().zip(counts).filter(|(_, counts)| **counts);
        bounds.map(|(bound, _)| *bound).fold(0.0, f64::max)
    }

    /// Whether the FMU's outputs are the same to the last bit.
    #[must_use]
    pub fn same_outputs(&self, other: &Self) -> bool {
        self.outputs.iter().zip(&other.outputs).all(|(a, b)| a.to_bits() == b.to_bits())
    }
}

/// Whether a robot is, moves and strikes the same by two rows of FMU outputs.
#[must_use]
pub fn moves_alike(robot: &Robot, binding: &RobotBinding, a: &[f64], b: &[f64]) -> bool {
    let carries = |outputs: &[f64]| binding.payload.read(outputs).to_bits();
    carries(a) == carries(b) && place(robot, binding, a) == place(robot, binding, b)
}

/// Pose and velocity of each moving part of a robot, world.
fn place(robot: &Robot, binding: &RobotBinding, outputs: &[f64]) -> Vec<(Pose, Twist)> {
    match (&binding.motion, &robot.kinematics) {
        (MotionBinding::Joints { positions, speeds }, Some(kinematics)) => {
            let (positions, speeds) = joints(kinematics, positions, speeds, outputs);
            let placed = kinematics.tree.place(&positions);
            let twists = placed.twists(&speeds);
            placed.world_from_link.into_iter().zip(twists).collect()
        }
        (MotionBinding::Frames(frames), _) => frames.iter().map(|f| frame(robot.world_from_base, f, outputs)).collect(),
        (MotionBinding::Joints { .. }, None) => Vec::new(),
    }
}

/// Positions and speeds of all joints.
pub(super) fn joints(
    kinematics: &Kinematics,
    positions: &[Reader],
    speeds: &[Reader],
    outputs: &[f64],
) -> (Vec<f64>, Vec<f64>) {
    let read = |readers: &[Reader]| -> Vec<f64> { readers.iter().map(|r| r.read(outputs)).collect() };
    kinematics.all(&read(positions), &read(speeds))
}

/// One part from what the FMU says of it in the robot's base frame.
fn frame(world_from_base: Pose, binding: &FrameBinding, outputs: &[f64]) -> (Pose, Twist) {
    let vector = |readers: &[Reader; 3]| {
        let [x, y, z] = readers.each_ref().map(|r| r.read(outputs));
        Vec3::new(x, y, z)
    };
    let turned = binding.orientation.read(outputs);
    let pose = world_from_base * Pose::from_parts(vector(&binding.position), turned);
    let angular = world_from_base.rotation * vector(&binding.angular_velocity);
    let velocity = world_from_base.rotation * vector(&binding.velocity);
    (pose, Twist { angular, linear_at_origin: velocity - angular.cross(pose.translation) })
}

/// Speed is a convex function of the point, so over a capsule its core ends bound the core, and the radius adds
/// `|omega| r`; over a hull or mesh the bounding sphere does.
fn speed_bound(solid: &Solid, twist: &Twist) -> f64 {
    let (speed, radius) = match solid {
        Solid::Capsule(c) => (twist.velocity_at(c.a).length().max(twist.velocity_at(c.b).length()), c.radius),
        Solid::Hull(_) | Solid::Mesh(_) => {
            let (centre, radius) = solid.bounding_sphere();
            (twist.velocity_at(centre).length(), radius)
        }
    };
    speed + twist.angular.length() * radius
}
