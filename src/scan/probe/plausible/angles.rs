//! Angles of joints that no robot has: in another unit, by the range of a run, or beyond the limits of the URDF.

use std::f64::consts::{PI, TAU};

use super::Instant;
use crate::cell::binding::Reader;
use crate::cell::workcell::{Driven, Kinematics};
use crate::geometry::kinematics::Motion as JointMotion;

/// Joints that turn no farther from 0 than this, as it is told in degrees, turn so far in radians, more likely.
const FEW_DEG: f64 = 7.0;
/// A joint that turns by more than this and back, as it is told in radians, does so in degrees, more likely; and one that is so fast, rad/s.
const MANY_RAD: f64 = 2.0 * TAU;
const FAST_RAD_S: f64 = 12.0;

/// What is odd about the joints of a robot, if anything is.
pub(super) fn odd(robot: &str, joints: &[Turned]) -> Option<String> {
    let beyond = || Some(format!("robot `{robot}`: {}", joints.iter().find_map(Turned::beyond)?));
    in_degrees(robot, joints).or_else(|| in_radians(robot, joints)).or_else(beyond)
}

/// How a joint turned in a run.
pub(super) struct Turned {
    name: String,
    /// Least and greatest angle that the FMU tells, rad.
    told: [f64; 2],
    /// The same from the joint's zero on.
    range: [f64; 2],
    /// Whether it turned to and fro.
    returns: bool,
    /// How fast it was at most, from instant to instant, rad/s.
    fastest: f64,
    /// Whether the cell, or the FMU, has it in degrees.
    in_degrees: bool,
    /// What its URDF allows, rad.
    limits: Option<[f64; 2]>,
}

impl Turned {
    /// Of a joint that turns and is read from one output.
    pub(super) fn new(
        name: &str,
        position: &Reader,
        (joint, kinematics): (usize, &Kinematics),
        instants: &[Instant],
    ) -> Option<Self> {
        let (factor, added) = position.of_one()?;
        let drives = |driven: &Driven| driven.named == joint && (driven.factor - 1.0).abs() < 1e-12;
        let at = kinematics.driven.iter().position(drives)?;
        if kinematics.tree.joints[at].motion != JointMotion::Revolute {
            return None;
        }
        let angle = |instant: &Instant| (instant.time_s, position.read(instant.frame.outputs()) - added);
        let angles: Vec<(f64, f64)> = instants.iter().map(angle).collect();
        let zero = added + kinematics.driven[at].offset;
        Some(Self { limits: kinematics.ranges[at], ..Self::of(name, factor, zero, &angles)? })
    }

    /// Of angles at some times, which stand for `factor` of what the FMU tells and are counted from a `zero`.
    fn of(name: &str, factor: f64, zero: f64, angles: &[(f64, f64)]) -> Option<Self> {
        let widest = |[low, high]: [f64; 2], (_, angle): &(f64, f64)| [low.min(*angle), high.max(*angle)];
        let told = angles.iter().fold([f64::INFINITY, f64::NEG_INFINITY], widest);
        let ways: Vec<(f64, f64)> = angles.windows(2).map(|two| (two[1].0 - two[0].0, two[1].1 - two[0].1)).collect();
        told[0].is_finite().then(|| Self {
            name: name.to_owned(),
            told,
            range: told.map(|angle| angle + zero),
            returns: ways.iter().any(|way| way.1 > 0.0) && ways.iter().any(|way| way.1 < 0.0),
            fastest: ways.iter().map(|(seconds, way)| (way / seconds).abs()).fold(0.0, f64::max),
            in_degrees: (factor.abs() - PI / 180.0).abs() < 1e-6,
            limits: None,
        })
    }

    fn width(&self) -> f64 {
        self.told[1] - self.told[0]
    }

    /// Where it is beyond what its URDF allows.
    fn beyond(&self) -> Option<String> {
        let limits @ [low, high] = self.limits?;
        let slack = 0.01 * (high - low) + 0.01;
        let zero = self.range[0] - self.told[0];
        let is_beyond = |factor: f64| {
            let [least, greatest] = self.told.map(|angle| angle * factor + zero);
            least < low - slack || greatest > high + slack
        };
        if !is_beyond(1.0) {
            return None;
        }
        let far = !self.in_degrees && self.width() > 3.0 * (high - low) && !is_beyond(PI / 180.0);
        let cause = if far { "; in degrees it would be within" } else { "" };
        let (unit, by) = if self.in_degrees { ("deg", 180.0 / PI) } else { ("rad", 1.0) };
        let told = |[from, to]: [f64; 2]| format!("{:.2} to {:.2} {unit}", from * by, to * by);
        Some(format!(
            "joint `{}` goes from {}, and its URDF allows {}{cause}. Look at its unit, its zero and its variable",
            self.name,
            told(self.range),
            told(limits)
        ))
    }
}

/// Angles that are told in radians and are degrees, more likely.
fn in_degrees(robot: &str, joints: &[Turned]) -> Option<String> {
    let far = |joint: &&Turned| {
        let is_far = joint.width() > MANY_RAD && (joint.returns || joint.fastest > FAST_RAD_S);
        !joint.in_degrees && is_far
    };
    let joint = joints.iter().filter(far).max_by(|a, b| a.width().total_cmp(&b.width()))?;
    Some(format!(
        "joint `{}` of robot `{robot}` goes from {:.2} to {:.2} rad, {:.1} turns: these are degrees, more likely. Look at its `unit`, and at what the FMU \
         says of it",
        joint.name,
        joint.told[0],
        joint.told[1],
        joint.width() / TAU
    ))
}

/// Angles that are told in degrees and are radians, more likely.
fn in_radians(robot: &str, joints: &[Turned]) -> Option<String> {
    let deg = |rad: f64| rad.to_degrees();
    let small = |joint: &Turned| joint.told.iter().all(|angle| deg(*angle).abs() < FEW_DEG);
    let turning: Vec<&Turned> = joints.iter().filter(|joint| joint.width() > 0.0).collect();
    if turning.is_empty() || !turning.iter().all(|joint| joint.in_degrees && small(joint)) {
        return None;
    }
    let joint = turning.into_iter().max_by(|a, b| a.width().total_cmp(&b.width()))?;
    // What hardly moves as radians stands still in either unit.
    (deg(joint.width()) > 0.2).then(|| {
        format!(
            "no joint of robot `{robot}` is farther than {FEW_DEG} deg from 0, and `{}` goes from {:.2} to {:.2} deg: these are radians, more \
             likely. Look at its `unit`, and at what the FMU says of it",
            joint.name,
            deg(joint.told[0]),
            deg(joint.told[1])
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A joint that swings so far to and fro, or turns on so fast, as an FMU tells it, read with this factor.
    fn joint(swings: f64, turns_s: f64, factor: f64) -> Turned {
        let at = |n: u32| {
            let time = 0.04 * f64::from(n);
            (time, factor * (swings * libm::sin(2.0 * time) + turns_s * time))
        };
        Turned::of("j", factor, 0.0, &(0..250).map(at).collect::<Vec<_>>()).unwrap()
    }

    const DEG: f64 = PI / 180.0;

    #[test]
    fn degrees_that_are_taken_for_radians_are_told() {
        for joints in
            [vec![joint(90.0, 0.0, 1.0)], vec![joint(8.0, 0.0, 1.0)], vec![joint(0.1, 0.0, 1.0), joint(0.0, 20.0, 1.0)]]
        {
            let told = in_degrees("arm", &joints).unwrap();
            assert!(told.contains("these are degrees, more likely"), "{told}");
        }
        // A turntable, an arm, and what is told in degrees.
        for joints in [vec![joint(0.0, 6.0, 1.0)], vec![joint(2.9, 0.0, 1.0)], vec![joint(90.0, 0.0, DEG)]] {
            assert_eq!(in_degrees("arm", &joints), None);
        }
    }

    #[test]
    fn radians_that_are_taken_for_degrees_are_told() {
        for joints in [
            vec![joint(1.5, 0.0, DEG)],
            vec![joint(3.1, 0.0, DEG), joint(0.2, 0.0, DEG)],
            vec![joint(0.3, 0.0, DEG), joint(0.0, 0.5, DEG)],
        ] {
            let told = in_radians("arm", &joints).unwrap();
            assert!(told.contains("these are radians, more likely"), "{told}");
        }
        // One joint that turns on, an arm that stands still, and what is told in radians.
        for joints in
            [vec![joint(1.5, 0.0, DEG), joint(0.0, 10.0, DEG)], vec![joint(0.05, 0.0, DEG)], vec![joint(0.1, 0.0, 1.0)]]
        {
            assert_eq!(in_radians("arm", &joints), None);
        }
    }

    #[test]
    fn angles_beyond_the_limits_of_a_urdf_are_told() {
        let limited = |joint: Turned, limit: f64| Turned { limits: Some([-limit, limit]), ..joint };
        let told = limited(joint(90.0, 0.0, 1.0), 2.9).beyond().unwrap();
        assert!(told.contains("its URDF allows -2.90 to 2.90 rad; in degrees it would be within"), "{told}");
        let told = limited(joint(3.2, 0.0, 1.0), 2.9).beyond().unwrap();
        assert!(told.contains("2.90 rad. Look at"), "{told}");
        let told = limited(joint(170.0, 0.0, DEG), 2.0).beyond().unwrap();
        assert!(told.contains("its URDF allows -114.59 to 114.59 deg."), "{told}");
        assert_eq!(limited(joint(2.8, 0.0, 1.0), 2.9).beyond(), None);
    }
}
