//! Hazards from anywhere are confirmed only where people get to by the rules of a scan from the start: rooms and mats with gaps that are a
//! little too narrow, and wide enough. What the floor is like there: `sim/anywhere/outside_tests.rs`.

use std::path::Path;

use crate::common::anywhere::{cell, look, mat};
use crate::common::guarded::guarded;
use crate::common::test_fmus;
use fmi_hazard::record::model::Verdict;
use fmi_hazard::record::reachability::{HarmfulPose, ReachabilityResult};

/// By legs alone, by a bar that is slow enough to be stopped in time.
fn by_legs(text: &str) -> String {
    let straight = text.replace("[human]\n", "[human]\nbend_forward_deg = 0\nbend_lateral_deg = 0\n");
    straight.replace("\"drive.speed\" = 5", "\"drive.speed\" = 3")
}

/// With people where this says.
fn with(text: &str, human: &str) -> String {
    let other = text.replace("start = { xy_m = [0, -3], heading_deg = 90 }\n", human);
    assert!(other != text);
    other
}

/// A fence around the bar, 0.7 m from its middle, with such a gap in front.
fn fence(gap_m: f64) -> String {
    let (h, g) = (0.7, 0.5 * gap_m);
    let wall = |name: &str, [x, y]: [f64; 2], [width, depth]: [f64; 2]| {
        format!("[[obstacle]]\nname = \"{name}\"\ncentre_m = [{x}, {y}, 1.1]\nsize_m = [{width}, {depth}, 2.2]\n")
    };
    [
        wall("back", [0.0, h], [2.0 * h, 0.02]),
        wall("left", [-h, 0.0], [0.02, 2.0 * h]),
        wall("right", [h, 0.0], [0.02, 2.0 * h]),
        wall("front left", [-0.5 * (h + g), -h], [h - g, 0.02]),
        wall("front right", [0.5 * (h + g), -h], [h - g, 0.02]),
    ]
    .concat()
}

fn is_shown(found: &ReachabilityResult) -> bool {
    found.hazards.iter().any(|place| place.confirmed)
}

/// Nothing is shown of it, and that is said.
fn is_open(found: &ReachabilityResult) -> bool {
    !is_shown(found)
        && found.verdict == Verdict::Inconclusive
        && !found.hazards.is_empty()
        && found.reasons.iter().any(|reason| reason.contains("begins where people get to"))
}

/// A strip of floor through the gap, that ends; people come from before the fence. The gap is narrower than a person by 1 cm, and wider by
/// 1.5 cm; by FMUs of both kinds.
#[test]
fn who_does_not_fit_through_a_gap_is_not_shown_to_be_hit_behind_it() {
    let strip = "start = { xy_m = [0, -1.1], heading_deg = 90 }\n\
                 floor_m = [[-0.17, -1.3], [0.17, -1.3], [0.17, -0.3], [-0.17, -0.3]]\n";
    let dir = guarded();
    std::fs::copy(test_fmus().join("guarded-fmi3.fmu"), dir.path().join("guarded-fmi3.fmu")).unwrap();
    let looked = |gap_m: f64, fmu: &str| {
        let text = with(&by_legs(&cell(0.45, &fence(gap_m))), strip).replace("guarded.fmu", fmu);
        look(dir.path(), &text, 0.1, 2)
    };
    for fmu in ["guarded.fmu", "guarded-fmi3.fmu"] {
        let (narrow, wide) = (looked(0.27, fmu), looked(0.295, fmu));
        assert!(is_open(&narrow), "{fmu}: {narrow:#?}");
        assert_eq!(wide.verdict, Verdict::HazardsFound, "{fmu}: {wide:#?}");
        assert!(wide.hazards.iter().any(|place| place.confirmed && place.xy_m[1] > -0.7), "{fmu}: {wide:#?}");
    }
}

/// The floor goes on to all sides; in a room that is shut somebody is hit who starts there.
#[test]
fn in_a_room_nobody_is_shown_to_be_hit_who_does_not_get_in() {
    let dir = guarded();
    let room = |gap_m: f64, human: &str| look(dir.path(), &with(&by_legs(&cell(0.45, &fence(gap_m))), human), 0.06, 2);
    let outside = "start = { xy_m = [0, -1.5], heading_deg = 90 }\n";
    assert!(is_open(&room(0.27, outside)));
    assert!(is_shown(&room(0.0, "start = { xy_m = [0.5, 0.5], heading_deg = 0 }\n")));
    // From a region before the fence, through a gap that is wide enough.
    let region = "start_region_m = [[-0.2, -1.4], [0.2, -1.4], [0.2, -1.0], [-0.2, -1.0]]\n";
    assert!(is_shown(&room(0.295, &format!("{outside}{region}"))));
}

/// Feet are 0.18 m apart. In a gap of 0.12 m between mats people stand unseen who look across it, and none of them gets there: who walks to
/// and fro at 45 degrees needs 0.127 m.
#[test]
fn who_cannot_get_between_mats_unseen_is_not_shown_to_be_hit_there() {
    let strip = "start = { xy_m = [0, -1.6], heading_deg = 90 }\n\
                 floor_m = [[-0.2, -1.8], [0.2, -1.8], [0.2, 0], [-0.2, 0]]\n";
    let looked = |dir: &Path, gap_m: f64| {
        let (h, g) = (1.3, 0.5 * gap_m);
        let mats = [mat("left", "clear", [-h, -h, -g, h]), mat("right", "clear", [g, -h, h, h])].concat();
        look(dir, &with(&by_legs(&cell(0.45, &mats)), strip), 0.2, 2)
    };
    let dir = guarded();
    let (narrow, wide) = (looked(dir.path(), 0.12), looked(dir.path(), 0.22));
    assert!(is_open(&narrow), "{narrow:#?}");
    let unseen = |place: &HarmfulPose| place.confirmed && !place.walks_in && place.xy_m[1] > -1.2;
    assert!(wide.hazards.iter().any(unseen), "{wide:#?}");
}
