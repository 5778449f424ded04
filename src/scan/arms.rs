//! Both arms of the person in a replay. The search looks at all arm poses of an instant at once, so between instants
//! there is no motion of an arm; what is drawn is made so that a reader understands it: arms hang, and the one that
//! touches is raised from there to the pose that touches.

use crate::geometry::Vec3;
use crate::human::Side;
use crate::human::arm::ArmModel;
use crate::record::hazard::Arm;
use crate::sim::simulation::Instant;

/// How long before the contact the arm that touches begins to be raised, s.
const RAISED_WITHIN_S: f64 = 0.4;

/// How far the forearm of a hanging arm points forwards, rad.
const FORWARDS_RAD: f64 = 0.17;

/// Shoulder, elbow and wrist, world, m.
pub(super) type Joints = [Vec3; 3];

/// The arms at each instant, left and right; `touching` is the one that touches at the instant `contact`.
pub(super) fn arms(instants: &[Instant], contact: usize, touching: Option<&Arm>, step_s: f64) -> Vec<[Joints; 2]> {
    let model = ArmModel::default();
    #[expect(clippy::cast_precision_loss, reason = "a few steps")]
    let raised = |frame: usize| {
        let left_s = contact.saturating_sub(frame) as f64 * step_s;
        let part = (1.0 - left_s / RAISED_WITHIN_S).clamp(0.0, 1.0);
        // Begins and ends softly.
        part * part * (3.0 - 2.0 * part)
    };
    let (ahead, down) = libm::sincos(FORWARDS_RAD);
    let at = |(frame, instant): (usize, &Instant)| {
        Side::BOTH.map(|side| {
            let pose = instant.body.shoulder(side);
            let shoulder = pose.translation;
            let mut forwards = (pose.rotation * Vec3::X).with_z(0.0);
            forwards = forwards.try_normalize().unwrap_or(Vec3::ZERO);
            let hanging = [-Vec3::Z, (forwards * ahead - Vec3::Z * down).normalize()];
            let found = touching.filter(|arm| arm.side == name(side)).map(|arm| {
                let [shoulder, elbow, wrist] = [arm.shoulder_m, arm.elbow_m, arm.wrist_m].map(Vec3::from_array);
                [elbow - shoulder, wrist - elbow]
            });
            let [upper, fore] = match found {
                None => hanging,
                Some([upper, fore]) => {
                    let part = raised(frame);
                    [between(hanging[0], upper, part), between(hanging[1], fore, part)]
                }
            };
            let elbow = shoulder + upper * model.upper_arm_m;
            [shoulder, elbow, elbow + fore * model.forearm_m]
        })
    };
    instants.iter().enumerate().map(at).collect()
}

/// Name of a side, as in a hazard.
const fn name(side: Side) -> &'static str {
    match side {
        Side::Left => "left",
        Side::Right => "right",
    }
}

/// The direction that is so far on the way from one to another, along a great circle.
fn between(from: Vec3, to: Vec3, part: f64) -> Vec3 {
    let (Some(from), Some(to)) = (from.try_normalize(), to.try_normalize()) else { return from };
    let angle = libm::acos(from.dot(to).clamp(-1.0, 1.0));
    let across = libm::sin(angle);
    if across < 1e-6 {
        // Straight up from hanging: forwards is as good a way as any.
        return if part < 1.0 { from } else { to };
    }
    from * (libm::sin((1.0 - part) * angle) / across) + to * (libm::sin(part * angle) / across)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_way_round_a_quarter_turn_is_an_eighth() {
        let half = between(Vec3::X, Vec3::Y * 3.0, 0.5);
        assert!((half - Vec3::new(1.0, 1.0, 0.0) / libm::sqrt(2.0)).length() < 1e-12, "{half}");
        assert!((between(Vec3::X, Vec3::Y, 0.0) - Vec3::X).length() < 1e-12);
        assert!((between(Vec3::X, Vec3::Y * 0.3, 1.0) - Vec3::Y).length() < 1e-12);
        assert_eq!(between(-Vec3::Z, Vec3::Z, 1.0), Vec3::Z);
    }
}
