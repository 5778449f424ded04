//! What a report shows of a hazard is that hazard: at the instant of the contact the link is where the contact is, as fast as
//! recorded, and the sensors report what is recorded, arms through light curtains included.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod common;

use common::{examples, fmi_hazard};
use fmi_hazard::geometry::Vec3;
use fmi_hazard::report::recorded::Recorded;
use fmi_hazard::scan::prepare::prepare;
use fmi_hazard::scan::{StateChoice, film};

#[test]
fn the_robot_is_where_the_contact_is() {
    let dir = examples();
    let dir = dir.path();
    let slow = ("active = false", "active = false\ndelay_ms = 100");
    for (example, actions, through, change) in [
        ("light-curtain", 3, true, ("", "")),
        ("light-curtain", 3, true, slow),
        ("head-collision", 5, false, ("", "")),
        ("two-scanners", 5, false, ("", "")),
    ] {
        let text = std::fs::read_to_string(dir.join(example).join("cell.toml")).unwrap();
        assert!(text.contains(change.0));
        let text = if change.0.is_empty() { text } else { text.replacen(change.0, change.1, 1) };
        let path = dir.join(example).join("short.toml");
        std::fs::write(&path, format!("{text}\n[search]\nactions = {actions}\n")).unwrap();
        let cell = path.to_str().unwrap();
        let scan = ["scan", cell, "--strategy", "exhaustive", "--out", "out"];
        assert_eq!(fmi_hazard(dir).args(scan).output().unwrap().status.code(), Some(1), "{example}");
        let hazards = Recorded::read(&dir.join("out")).unwrap().hazards;
        assert_eq!(hazards.iter().any(|hazard| hazard.through_curtain.is_some()), through, "{example}");
        let prepared = prepare(&path, None).unwrap();
        let mut simulation = prepared.simulation(StateChoice::Auto, false).unwrap();
        for hazard in &hazards {
            let watched = film::watch(&mut simulation, &prepared, hazard).unwrap();
            let instant = &watched.instants[film::contact_frame(&prepared, hazard, &watched)];
            let point = Vec3::from_array(hazard.contact_point_m);
            let links = prepared.cell.links.iter().enumerate().filter(|(_, link)| link.name == hazard.robot_link);
            let at = links.map(|(link, _)| (instant.frame.links[link].point_distance(point).distance.abs(), link));
            let (distance, link) = at.min_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
            assert!(distance < 1e-9, "{example} {}: {distance} m beside the link", hazard.id);
            let speed = instant.frame.velocity(link, point).length();
            assert!((speed - hazard.speed_m_s).abs() < 1e-9, "{example} {}: {speed}", hazard.id);
            let recorded: Vec<bool> = hazard.sensors.iter().map(|sensor| sensor.person_detected).collect();
            assert_eq!(instant.readings, recorded, "{example} {}", hazard.id);
            assert!((instant.position.x - hazard.person_xy_m[0]).abs() < 1e-9);
            assert!((instant.position.y - hazard.person_xy_m[1]).abs() < 1e-9);
        }
        std::fs::remove_dir_all(dir.join("out")).unwrap();
    }
}
