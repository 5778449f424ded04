//! What a person does besides walking, bending and reaching, where the cell file asks for it.

use fmi_hazard::human::{Action, Posture, Walk};
use fmi_hazard::scan::StateChoice;
use fmi_hazard::scan::prepare::{Prepared, prepare};
use fmi_hazard::search::{End, Environment as _};

use crate::common::anywhere::cell;
use crate::common::guarded::guarded;
use crate::common::pair::Pair;
use crate::common::{examples, fmi_hazard, scan_json, write};
use crate::sample;

/// What a sequence ends with: by the index of the action, and what the sensors then read.
fn ends(prepared: &Prepared, actions: &[Action]) -> (Option<(usize, Vec<bool>)>, bool) {
    let mut simulation = prepared.simulation(StateChoice::Auto, false).unwrap();
    simulation.reset().unwrap();
    for (number, action) in actions.iter().enumerate() {
        match simulation.take(*action).unwrap().end {
            Some(End::Unsafe) => {
                let found = simulation.take_findings().pop().unwrap();
                return (Some((number, found.sensors)), true);
            }
            Some(end) => assert_eq!(end, End::Horizon),
            None => {}
        }
    }
    let watched = simulation.watch(actions, &[]).unwrap();
    (None, watched.instants.iter().any(|instant| instant.readings.contains(&true)))
}

/// The cell `under-curtain` with the curtain's lower edge at some height: who crawls gets below it unseen where there is room, stands
/// up behind it and is hit; who walks is seen, and so is who crawls where there is none.
#[test]
fn who_crawls_below_a_light_curtain_is_not_seen() {
    let dir = examples();
    let prepared = |low_m: f64, also: &str| {
        let human = format!("[human]\nalso = {also}\nstart = {{ xy_m = [0.1, -0.8], heading_deg = 90 }}");
        let curtain = "name = \"curtain\"\nkind = \"light_curtain\"\nvariable = \"plc.curtain_clear\"\nactive = false";
        let zone = format!("zone = {{ line_m = [[-0.5, 0], [0.5, 0]], heights_m = [{low_m}, 1.8] }}");
        let text = format!("extends = \"cell.toml\"\nname = \"low\"\n{human}\n[[sensor]]\n{curtain}\n{zone}\n");
        prepare(&write(&dir.path().join("under-curtain"), "low.toml", &text), None).unwrap()
    };
    let go = |posture| vec![Action::new(Walk::Forward, posture); 5];
    let then = [Action::new(Walk::Forward, Posture::Forward), Action::new(Walk::Stop, Posture::Forward)];
    let walk = |posture| [go(posture), then.to_vec()].concat();
    let high = prepared(0.75, "[\"crawl\", \"crouch\"]");
    let (hit, _) = ends(&high, &walk(Posture::Crawling));
    let (number, sensors) = hit.expect("a hit behind the curtain");
    assert!(number >= 4 && sensors == [false], "{number} {sensors:?}");
    for posture in [Posture::Upright, Posture::Forward, Posture::Crouching] {
        assert_eq!(ends(&high, &walk(posture)), (None, true), "{posture:?}");
    }
    for low_m in [0.0, 0.3, 0.6] {
        assert_eq!(ends(&prepared(low_m, "[\"crawl\"]"), &walk(Posture::Crawling)), (None, true), "{low_m} m");
    }
    assert_eq!((high.cell.repertoire.count(), prepared(0.75, "[]").cell.repertoire.count()), (48, 36));
}

/// What the cause of who gets below a curtain begins with.
const BELOW: &str = "The person gets below curtain, and no sensor reports them: ";

/// All that could be changed but the curtain.
const FIXED: &str = "[explain]\nrobot = { \"KR 16-2\" = { fixed = true } }\n\
                     obstacle = { \"fence front left\" = { fixed = true }, \"fence front right\" = { fixed = true }, \
                     \"fence left side\" = { fixed = true }, \"fence right side\" = { fixed = true } }\n\
                     [explain.parameters]\n\"plc.t_react\" = { fixed = true }\n\"ctrl.t_ramp\" = { fixed = true }\n\
                     \"ctrl.speed_scale\" = { fixed = true }\n\"ctrl.phase0\" = { fixed = true }\n";

/// The example: every sequence of a shorter scan that begins nearer, what is told of it, and its repaired twin.
fn found_told_and_mended(y: f64, search: &str) {
    let dir = examples();
    let near =
        format!("[human]\nstart = {{ xy_m = [0.1, {y}], heading_deg = 90 }}\nalso = [\"crawl\"]\n[search]\n{search}");
    let pair = Pair::scanned(dir.path(), "under-curtain", &near, 42);
    assert!(pair.causes().iter().any(|sentence| sentence.starts_with(BELOW)), "{}", pair.told);
    assert!(pair.hazards().len() > 5, "{}", pair.told);
    // What helps is told.
    let told = pair.worst_explained(dir.path());
    assert!(told.contains("curtain reaching down to the floor"), "{told}");
}

#[test]
fn a_curtain_with_room_below_is_found_told_and_mended() {
    if !sample::is_turn(2, 6) {
        return;
    }
    found_told_and_mended(-0.2, &format!("actions = 4\nreach_tolerance_m = 0.05\n{FIXED}"));
}

#[test]
#[ignore = "a minute: six actions from farther away, and all changes tried; the same without `from_farther_away` has four"]
fn a_curtain_with_room_below_is_found_told_and_mended_from_farther_away() {
    found_told_and_mended(-0.3, "actions = 6\n");
}

/// Mistakes are told with the way out, and a scan from anywhere says what it leaves out.
#[test]
fn what_people_do_besides_is_told() {
    let dir = guarded();
    // Beside a bar that is too slow to hurt anybody.
    let slow = cell(0.45, "")
        .replace("\"drive.speed\" = 5", "\"drive.speed\" = 0.1")
        .replace("xy_m = [0, -3]", "xy_m = [0, -0.7]");
    let text = |also: &str| slow.replace("heading_deg = 90 }\n", &format!("heading_deg = 90 }}\n{also}\n"));
    for (also, problem) in [
        ("also = [\"crawl\", \"crawl\"]", "`also` names something twice"),
        ("run_m_s = 3.2", "`run_m_s` says how fast nobody runs"),
        ("also = [\"run\"]\nrun_m_s = 3", "run_m_s is 3"),
        ("also = [\"fly\"]", "unknown variant `fly`, expected one of `kneel`"),
    ] {
        let file = write(dir.path(), "wrong.toml", &text(also));
        let error = prepare(&file, None).err().unwrap().to_string();
        assert!(error.contains(problem), "{also}: {error}");
    }
    write(dir.path(), "cell.toml", &text("also = [\"step_back\", \"run\"]\nrun_m_s = 4.8"));
    let mut scan = fmi_hazard(dir.path());
    let ran = scan
        .args(["scan", "cell.toml", "--from", "both", "--until", "1s", "--no-advice", "--out", "out"])
        .output()
        .unwrap();
    let told = String::from_utf8_lossy(&ran.stdout);
    let told = told.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(told.contains("no steps back, no running"), "{told}");
    let report = scan_json(&dir.path().join("out/anywhere"));
    assert_eq!(report["settings"]["also"], serde_json::json!(["step_back", "run"]));
    assert_eq!(report["settings"]["run_m_s"], 4.8);
    // That nobody is hit from the start does not make up for what is not known of others.
    let from_start = scan_json(&dir.path().join("out"));
    assert_eq!((&report["verdict"], &from_start["verdict"]), (&"inconclusive".into(), &"none_found".into()));
    assert_eq!(ran.status.code(), Some(4), "{told}");
}

/// Below a curtain with room for legs and hands, but not for the whole body, a hand may be before the body is in the curtain: that is not
/// looked at, and the scan is not called complete. It is where there is no such room, and where nobody is low.
#[test]
fn hands_below_a_curtain_are_not_called_excluded() {
    let dir = guarded();
    for (low_m, also, complete) in [(0.3, "[\"crawl\"]", false), (0.3, "[]", true), (0.0, "[\"crawl\"]", true)] {
        let curtain = format!(
            "[[sensor]]\nname = \"curtain\"\nkind = \"light_curtain\"\nvariable = \"clear\"\nactive = false\n\
             zone = {{ line_m = [[-1, -2], [1, -2]], heights_m = [{low_m}, 1.8] }}\n"
        );
        let text = cell(1.0, &curtain)
            .replace("xy_m = [0, -3]", "xy_m = [0, -2.3]")
            .replace("heading_deg = 90 }\n", &format!("heading_deg = 90 }}\nalso = {also}\n"));
        write(dir.path(), "cell.toml", &text);
        let mut scan = fmi_hazard(dir.path());
        scan.args(["scan", "cell.toml", "--strategy", "exhaustive", "--no-advice", "--out", "out"]);
        let ran = scan.output().unwrap();
        let report = scan_json(&dir.path().join("out"));
        let told = String::from_utf8_lossy(&ran.stdout);
        assert_eq!(report["verdict"] == "none_found", complete, "{low_m} {also}: {told}");
        assert_eq!(told.contains("may have a hand below curtain"), !complete, "{told}");
        std::fs::remove_dir_all(dir.path().join("out")).unwrap();
    }
}
