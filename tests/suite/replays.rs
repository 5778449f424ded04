//! What a report shows of a hazard is that hazard: at the instant of the contact the link is where the contact is, as fast as
//! recorded, the sensors report what is recorded, arms through light curtains included, and the person's arms are those that
//! contacts were looked for with.

use crate::common::{examples, fmi_hazard};
use crate::sample;
use fmi_hazard::geometry::Vec3;
use fmi_hazard::geometry::distance::point_segment;
use fmi_hazard::human::arm::ArmModel;
use fmi_hazard::record::hazard::Hazard;
use fmi_hazard::record::recorded::Recorded;
use fmi_hazard::report::page::Replay;
use fmi_hazard::scan::prepare::prepare;
use fmi_hazard::scan::{StateChoice, replay};
use fmi_hazard::standards::BodyRegion;

/// The arms of a replay are those of the collision model, and what is hit touches the robot when it is hit.
fn touches_as_drawn(hazard: &Hazard, contact: usize, drawn: &Replay) {
    let gap = drawn.distance_m.0[contact];
    assert!(gap.abs() < 1e-3, "{}: {gap} m from what is hit", hazard.id);
    assert!(drawn.distance_m.0.iter().all(|gap| *gap >= 0.0));
    let model = ArmModel::default();
    let joints = |frame: usize, side: usize| {
        let at = &drawn.arms.0[18 * frame + 9 * side..][..9];
        [0, 3, 6].map(|joint| Vec3::new(at[joint], at[joint + 1], at[joint + 2]))
    };
    for frame in 0..drawn.frames {
        for side in 0..2 {
            let [shoulder, elbow, wrist] = joints(frame, side);
            assert!(((elbow - shoulder).length() - model.upper_arm_m).abs() < 1e-9);
            assert!(((wrist - elbow).length() - model.forearm_m).abs() < 1e-9);
            // Before it is raised, it hangs.
            assert!(frame > 0 || wrist.z < elbow.z && elbow.z < shoulder.z);
        }
    }
    let Some(arm) = &hazard.arm else { return };
    let found = [arm.shoulder_m, arm.elbow_m, arm.wrist_m].map(Vec3::from_array);
    let [shoulder, elbow, wrist] = joints(contact, usize::from(arm.side == "right"));
    for (drawn, found) in [shoulder, elbow, wrist].iter().zip(&found) {
        assert!((*drawn - *found).length() < 1e-9, "{}: {drawn} is not {found}", hazard.id);
    }
    // The limb that is hit is within its radius of the link; the point of the contact is on its surface, that of a hand on the
    // link. An elbow, of which both limbs have a part, counts as upper arm.
    let (link, body) = (Vec3::from_array(hazard.contact_point_m), Vec3::from_array(hazard.body_point_m));
    let upper = (shoulder, elbow, model.upper_arm_radius_m);
    let limbs = match hazard.body_region {
        BodyRegion::UpperArm => vec![upper, (elbow, wrist, model.forearm_radius_m)],
        BodyRegion::LowerArm => vec![(elbow, wrist, model.forearm_radius_m)],
        _ => vec![(wrist, wrist, model.hand_radius_m)],
    };
    let hand = hazard.body_region == BodyRegion::Hand;
    let is_hit = |(a, b, radius): (Vec3, Vec3, f64)| {
        // Seen from the contact on the person, the axis of the limb lies behind the contact on the robot.
        let axis = if hand { body } else { body + (link - body).normalize() * radius };
        (hand || point_segment(axis, a, b).distance < 1e-9) && point_segment(link, a, b).distance <= radius + 1e-9
    };
    assert!(limbs.into_iter().any(is_hit), "{}: {link} on the robot, {body} on the person", hazard.id);
}

#[test]
fn the_robot_is_where_the_contact_is() {
    if !sample::is_turn(0, 4) {
        return;
    }
    let dir = examples();
    let dir = dir.path();
    let slow = ("active = false", "active = false\ndelay_ms = 100");
    let mut approaching = 0;
    let cells = [
        ("light-curtain", 3, true, ("", "")),
        ("light-curtain", 3, true, slow),
        ("head-collision", 5, false, ("", "")),
        ("two-scanners", 5, false, ("", "")),
    ];
    // One with a curtain, one without.
    for (example, actions, through, change) in sample::some(cells, 2) {
        let text = std::fs::read_to_string(dir.join(example).join("cell.toml")).unwrap();
        assert!(text.contains(change.0));
        let text = if change.0.is_empty() { text } else { text.replacen(change.0, change.1, 1) };
        let path = dir.join(example).join("short.toml");
        std::fs::write(&path, format!("{text}\n[search]\nactions = {actions}\n")).unwrap();
        let cell = path.to_str().unwrap();
        let scan = ["scan", "--no-advice", cell, "--strategy", "exhaustive", "--out", "out"];
        assert_eq!(fmi_hazard(dir).args(scan).output().unwrap().status.code(), Some(1), "{example}");
        let hazards = Recorded::read(&dir.join("out")).unwrap().hazards;
        assert_eq!(hazards.iter().any(|hazard| hazard.through_curtain.is_some()), through, "{example}");
        let prepared = prepare(&path, None).unwrap();
        let mut simulation = prepared.simulation(StateChoice::Auto, false).unwrap();
        for hazard in &hazards {
            let watched = replay::watch(&mut simulation, &prepared, hazard).unwrap();
            let contact = replay::contact_frame(&prepared, hazard, &watched);
            let instant = &watched.instants[contact];
            touches_as_drawn(hazard, contact, &replay::record(&prepared, hazard, &watched, String::new()));
            let point = Vec3::from_array(hazard.contact_point_m);
            let links = prepared.cell.links.iter().enumerate().filter(|(_, link)| link.name == hazard.robot_link);
            let at = links.map(|(link, _)| (instant.frame.links[link].point_distance(point).distance.abs(), link));
            let (distance, link) = at.min_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
            assert!(distance < 1e-9, "{example} {}: {distance} m beside the link", hazard.id);
            let velocity = instant.frame.velocity(link, point);
            if hazard.arm.is_some() {
                // How fast the robot's point is for who walks by: an arm may come from any side.
                let walked = instant.position - watched.instants[contact - 1].position;
                let approach = (velocity - walked / prepared.cell.step_s).length();
                assert!((hazard.approach_m_s - approach).abs() < 1e-6, "{example} {}: {approach} m/s", hazard.id);
                approaching += usize::from(approach > 0.5);
            }
            let speed = velocity.length();
            assert!((speed - hazard.speed_m_s).abs() < 1e-9, "{example} {}: {speed}", hazard.id);
            let recorded: Vec<bool> = hazard.sensors.iter().map(|sensor| sensor.person_detected).collect();
            assert_eq!(instant.readings, recorded, "{example} {}", hazard.id);
            assert!((instant.position.x - hazard.person_xy_m[0]).abs() < 1e-9);
            assert!((instant.position.y - hazard.person_xy_m[1]).abs() < 1e-9);
        }
        std::fs::remove_dir_all(dir.join("out")).unwrap();
    }
    assert!(approaching > 0, "no limb of an arm that the robot comes towards");
}
