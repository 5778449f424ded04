//! Links that are hulls of 100, 400 and 6,400 corners, as meshes of real robots are, by formula: corners on a capsule. Such a hull holds a
//! capsule that is a little thinner and is held by the other, so it is met by at least the sequences that meet the one, and at most by those
//! that meet the other.

use std::f64::consts::PI;
use std::fmt::Write as _;
use std::path::Path;

use crate::common::examples;
use crate::common::guarded::every_sequence;
use crate::sample;
use fmi_hazard::geometry::Vec3;
use fmi_hazard::record::model::ScanReport;
use fmi_hazard::scan::prepare::prepare;

/// Corners on a capsule, in rings of so many, half as many rings.
fn corners([a, b]: [Vec3; 2], radius_m: f64, ring: u32) -> Vec<Vec3> {
    let axis = if a == b { Vec3::new(0.0, 0.0, 1.0) } else { (b - a).normalize_or_zero() };
    let beside = if axis.x.abs() < 0.9 { Vec3::new(1.0, 0.0, 0.0) } else { Vec3::new(0.0, 1.0, 0.0) };
    let across = axis.cross(beside).normalize_or_zero();
    let up = axis.cross(across);
    let mut corners = vec![a - axis * radius_m, b + axis * radius_m];
    for latitude in 0..ring / 2 {
        let (sin, cos) = libm::sincos(PI * (f64::from(latitude) + 0.5) / f64::from(ring / 2));
        let middle = if cos >= 0.0 { b } else { a };
        corners.extend((0..ring).map(|k| {
            let (y, x) = libm::sincos(2.0 * PI * f64::from(k) / f64::from(ring));
            middle + (axis * cos + (across * x + up * y) * sin) * radius_m
        }));
    }
    corners
}

/// The radius of a capsule that such a hull holds.
fn within(radius_m: f64, ring: u32) -> f64 {
    radius_m * libm::cos(PI / f64::from(ring)) * libm::cos(PI / f64::from(ring / 2 * 2))
}

/// The cell with each capsule as `shape` has it, of its ends and its radius, m.
fn shaped(text: &str, shape: impl Fn([Vec3; 2], f64) -> String) -> String {
    let mut links = 0;
    let mut line = |line: &str| {
        let Some(capsule) = line.strip_prefix("capsule = ") else { return line.to_owned() };
        links += 1;
        let table: toml::Table = toml::from_str(&format!("c = {capsule}")).unwrap();
        let number = |value: &toml::Value| value.to_string().parse::<f64>().unwrap();
        let point = |key: &str| {
            let xyz: Vec<f64> = table["c"][key].as_array().unwrap().iter().map(number).collect();
            Vec3::new(xyz[0], xyz[1], xyz[2])
        };
        shape([point("from_m"), point("to_m")], number(&table["c"]["radius_m"]))
    };
    let lines: Vec<String> = text.lines().map(&mut line).collect();
    assert_eq!(links, 8);
    lines.join("\n") + "\n[search]\nactions = 7\n"
}

fn written(points: &[Vec3]) -> String {
    let mut text = String::from("hull_m = [");
    points.iter().for_each(|p| write!(text, "[{}, {}, {}], ", p.x, p.y, p.z).unwrap());
    text + "]"
}

fn searched(folder: &Path, text: &str) -> (u128, ScanReport) {
    let file = folder.join("shaped.toml");
    std::fs::write(&file, text).unwrap();
    let report = every_sequence(&prepare(&file, None).unwrap(), false);
    (report.certificate.as_ref().unwrap().hazardous.parse().unwrap(), report)
}

#[test]
fn a_hull_of_many_corners_is_met_as_often_as_the_capsules_within_and_around_it() {
    let dir = examples();
    let folder = dir.path().join("sensor-mat");
    let cell = std::fs::read_to_string(folder.join("cell.toml")).unwrap();
    let capsule = |ends: [Vec3; 2], radius_m: f64| {
        let [from, to] = ends.map(|p| [p.x, p.y, p.z]);
        format!("capsule = {{ from_m = {from:?}, to_m = {to:?}, radius_m = {radius_m:?} }}")
    };
    for ring in sample::some([14, 28, 113], 3) {
        let (least, _) = searched(&folder, &shaped(&cell, |ends, radius_m| capsule(ends, within(radius_m, ring))));
        let (most, around) = searched(&folder, &shaped(&cell, capsule));
        let hulls = shaped(&cell, |ends, radius_m| written(&corners(ends, radius_m, ring)));
        let (met, hull) = searched(&folder, &hulls);
        assert!(0 < least && least <= met && met <= most, "rings of {ring}: {least} {met} {most}");
        assert!(hull.hazards.iter().all(|hazard| hazard.confirmed == Some(true)));
        // How fast it is follows from how much is looked at.
        let [hull, around] = [&hull, &around].map(|report| report.coverage.arm_boxes);
        assert!(hull <= 3 * around, "rings of {ring}: {hull} boxes, {around} with capsules");
        println!("rings of {ring}: {least} {met} {most}, boxes {hull} {around}");
    }
}
