//! One flaw is one cause, or a few; two flaws in one cell are never one. Which hazards are of which flaw is known from cells
//! that have only one of the two.

use std::collections::BTreeSet;
use std::path::Path;

use crate::common::examples;
use crate::common::guarded::{bar, every_sequence, guarded};
use crate::sample;
use fmi_hazard::record::model::ScanReport;
use fmi_hazard::scan::prepare::prepare;

/// Every sequence of a cell file in `dir`.
fn all(dir: &Path, text: &str) -> ScanReport {
    let path = dir.join("pair.toml");
    std::fs::write(&path, text).unwrap();
    let prepared = prepare(&path, None).unwrap();
    every_sequence(&prepared, false)
}

/// That each hazard is of one cause, and what the causes say of themselves is what their hazards say.
fn consistent(report: &ScanReport) {
    let listed: Vec<&String> = report.causes.iter().flat_map(|cause| &cause.hazards).collect();
    let ids: BTreeSet<&String> = report.hazards.iter().map(|hazard| &hazard.id).collect();
    assert!(listed.len() == ids.len() && listed.into_iter().collect::<BTreeSet<_>>() == ids);
    let causes: BTreeSet<&String> = report.causes.iter().map(|cause| &cause.id).collect();
    assert_eq!(causes.len(), report.causes.len(), "ids of causes");
    for cause in &report.causes {
        let of = |id: &String| report.hazards.iter().find(|hazard| hazard.id == *id).unwrap();
        let worst = of(&cause.worst);
        assert_eq!((cause.ratio, cause.force_n), (worst.ratio, worst.force_n));
        assert!(cause.hazards.iter().all(|id| of(id).ratio <= cause.ratio));
        assert_eq!(cause.lines.iter().map(|line| line.hazards.len()).sum::<usize>(), cause.hazards.len());
        let sum: u128 =
            cause.hazards.iter().map(|id| of(id).sequences.as_ref().unwrap().parse::<u128>().unwrap()).sum();
        assert_eq!(cause.sequences.as_ref().unwrap().parse::<u128>().unwrap(), sum);
        assert!(cause.sentence.ends_with('.') && cause.sentence.contains(&format!("{:.2} m/s", worst.speed_m_s)));
    }
}

/// Two flaws alone and together: hazards of one are never in a cause with hazards of the other, and both have one.
fn two_flaws(name: &str, dir: &Path, [one, other, both]: [String; 3]) {
    let ids = |report: &ScanReport| report.hazards.iter().map(|hazard| hazard.id.clone()).collect::<BTreeSet<_>>();
    let [first, second] = [&one, &other].map(|text| ids(&all(dir, text)));
    let report = all(dir, &both);
    consistent(&report);
    let of = |cause: &fmi_hazard::record::cause::Cause| {
        let any = |mine: &BTreeSet<String>, others: &BTreeSet<String>| {
            cause.hazards.iter().any(|id| mine.contains(id) && !others.contains(id))
        };
        [any(&first, &second), any(&second, &first)]
    };
    let told: Vec<_> = report.causes.iter().map(|cause| (&cause.sentence, cause.hazards.len(), of(cause))).collect();
    // Of each flaw at most four.
    assert!(report.causes.len() <= 8, "{name}: {told:#?}");
    assert!(!first.is_empty() && !second.is_empty(), "{name}: {} {}", first.len(), second.len());
    assert!(report.causes.iter().all(|cause| of(cause) != [true, true]), "{name}: {told:#?}");
    for flaw in 0..2 {
        assert!(report.causes.iter().any(|cause| of(cause)[flaw]), "{name}, flaw {flaw}: {told:#?}");
    }
}

/// A mat from y = -1.3 on, to the right of `from`.
fn mat(from: f64) -> String {
    format!(
        "[[sensor]]\nname = \"mat\"\nkind = \"mat\"\nvariable = \"clear\"\nactive = false\n\
         zone = {{ polygon_m = [[{from}, -1.3], [3, -1.3], [3, 3], [{from}, 3]] }}\n"
    )
}

/// A wall along y = -1 with openings around some places.
fn wall(openings: &[f64]) -> String {
    let mut ends = vec![-3.0];
    for x in openings {
        ends.extend([x - 0.35, x + 0.35]);
    }
    ends.push(3.0);
    let panel = |(number, pair): (usize, &[f64])| {
        let (middle, size) = (0.5 * (pair[0] + pair[1]), pair[1] - pair[0]);
        format!("[[obstacle]]\nname = \"panel {number}\"\ncentre_m = [{middle}, -1, 1]\nsize_m = [{size}, 0.02, 2]\n")
    };
    ends.chunks(2).enumerate().map(panel).collect()
}

/// A cell of the FMU whose bar turns steadily, and whose controller has a mat that may be muted, and may be slow.
fn cell(parts: &[String], parameters: &str, actions: u32) -> String {
    format!(
        "schema = 1\nname = \"guarded\"\nfmu = \"guarded.fmu\"\n{}[pose]\nx = \"person.x\"\ny = \"person.y\"\n\
         [parameters]\n{parameters}\n[human]\nstart = {{ xy_m = [0, -1.6], heading_deg = 90 }}\n\
         [search]\nactions = {actions}\nreach_tolerance_m = 0.05\n",
        parts.concat()
    )
}

/// The bar moves at up to 1.5 m/s, and the mat reaches far enough for the usual reaction.
const FAST: &str = "\"drive.speed\" = 1.8\n";

#[test]
fn a_hole_in_the_mat_and_a_mat_that_is_not_heeded() {
    if !sample::is_turn(5, 6) {
        return;
    }
    let dir = guarded();
    let muted = format!("{FAST}\"muting.enabled\" = true\n\"muting.hold_time\" = 20.0\n");
    let low = || bar("bar", 0.0, 0.45);
    let texts =
        [cell(&[low(), mat(0.2)], FAST, 4), cell(&[low(), mat(-3.0)], &muted, 4), cell(&[low(), mat(0.2)], &muted, 4)];
    two_flaws("hole and muting", dir.path(), texts);
}

#[test]
fn a_hole_in_the_mat_and_a_controller_that_is_too_slow() {
    if !sample::is_turn(3, 6) {
        return;
    }
    let dir = guarded();
    let slow = format!("{FAST}\"plc.t_react\" = 0.45\n");
    let low = || bar("bar", 0.0, 0.45);
    let texts =
        [cell(&[low(), mat(0.2)], FAST, 4), cell(&[low(), mat(-3.0)], &slow, 4), cell(&[low(), mat(0.2)], &slow, 4)];
    two_flaws("hole and slow controller", dir.path(), texts);
}

/// Two bars of one robot behind a wall, which come by both of its openings when people do.
fn two_bars() -> String {
    let other = "[[robot.link]]\nname = \"other bar\"\njoint = \"axis\"\n\
                 capsule = { from_m = [0, 0, 0], to_m = [1.73, 2.38, 0], radius_m = 0.05 }\n";
    let far = bar("bar", 0.0, 0.45).replace("xyz_m = [0, 0,", "xyz_m = [0, 2.05,");
    far.replace("to_m = [0.8, 0, 0]", "to_m = [2.95, 0, 0]").replace("-125", "-150") + other
}

/// The same with openings of the wall, which people can reach in time.
fn behind_a_wall(openings: &[f64], parts: &str, parameters: &str, actions: u32) -> String {
    let parameters = format!("\"drive.speed\" = 0.5\n{parameters}");
    let parts = [two_bars(), wall(openings), parts.to_owned()];
    cell(&parts, &parameters, actions).replace("xy_m = [0, -1.6]", "xy_m = [0, -1.3]")
}

fn two_openings(actions: u32) {
    let dir = guarded();
    let with = |openings: &[f64]| behind_a_wall(openings, "", "", actions);
    two_flaws("two openings", dir.path(), [with(&[-1.3]), with(&[1.3]), with(&[-1.3, 1.3])]);
}

/// Five actions are just enough to get to an opening and to be hit.
#[test]
fn two_openings_of_a_fence() {
    if !sample::is_turn(0, 6) {
        return;
    }
    two_openings(5);
}

#[test]
#[ignore = "half a minute: seven actions; `two_openings_of_a_fence` has five"]
fn two_openings_of_a_fence_and_more_time() {
    two_openings(7);
}

#[test]
fn a_controller_that_is_too_slow_behind_one_opening_and_no_mat_behind_the_other() {
    if !sample::is_turn(1, 6) {
        return;
    }
    slow_and_without_a_mat(5);
}

#[test]
#[ignore = "half a minute: seven actions; the same without `and_more_time` has five"]
fn a_controller_that_is_too_slow_behind_one_opening_and_no_mat_behind_the_other_and_more_time() {
    slow_and_without_a_mat(7);
}

fn slow_and_without_a_mat(actions: u32) {
    let dir = guarded();
    let mat = "[[sensor]]\nname = \"mat\"\nkind = \"mat\"\nvariable = \"clear\"\nactive = false\n\
               zone = { polygon_m = [[-2, -1], [-0.6, -1], [-0.6, 1], [-2, 1]] }\n";
    let with = |openings: &[f64], parts: &str| behind_a_wall(openings, parts, "\"plc.t_react\" = 0.45\n", actions);
    let texts = [with(&[-1.3], mat), with(&[1.3], mat), with(&[-1.3, 1.3], mat)];
    two_flaws("slow controller and missing mat", dir.path(), texts);
}

#[test]
fn two_robots_of_which_nothing_keeps_people_away() {
    if !sample::is_turn(2, 6) {
        return;
    }
    let dir = guarded();
    // Alone, the other one is far away: links are named after their robots where there are several.
    let with = |left: f64, right: f64| cell(&[bar("left", left, 0.45), bar("right", right, 0.45)], FAST, 4);
    two_flaws("two robots", dir.path(), [with(-0.5, 60.0), with(-60.0, 0.5), with(-0.5, 0.5)]);
}

#[test]
fn a_field_with_a_hole_and_a_robot_that_only_slows_down() {
    if !sample::is_turn(10, 12) {
        return;
    }
    let dir = examples();
    let dir = dir.path().join("head-collision");
    let fixed = std::fs::read_to_string(dir.join("fixed.toml")).unwrap();
    let with = |left: f64, reduced: f64| {
        fixed
            .replace(
                "[[-4, -2.3], [4, -2.3], [4, 3], [-4, 3]]",
                &format!("[[{left}, -2.3], [4, -2.3], [4, 3], [{left}, 3]]"),
            )
            .replace("\"plc.v_reduced\" = 0.0", &format!("\"plc.v_reduced\" = {reduced:?}"))
            .replace("xy_m = [0.2, -2.45]", "xy_m = [0.4, -1.2]")
            + "\n[search]\nactions = 5\nreach_tolerance_m = 0.05\n"
    };
    two_flaws("hole and slow", &dir, [with(0.3, 0.0), with(-4.0, 0.25), with(0.3, 0.25)]);
}
