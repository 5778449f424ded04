//! Stops that restart by themselves, from anywhere: a door, a curtain and a strip of mat in the opening of a wall, by FMUs of both versions.
//! Whoever passes is hit, and where the states run out before that is seen, nothing clean is said. Latched in the FMU or by the host, the
//! same cells hold.

use std::cmp::Ordering;
use std::ops::ControlFlow;

use crate::common::{test_fmus, write};
use crate::sample;
use fmi_hazard::obligations::{Need, Standing};
use fmi_hazard::record::model::Verdict;
use fmi_hazard::record::reachability::ReachabilityResult;
use fmi_hazard::scan::StateChoice;
use fmi_hazard::scan::prepare::prepare;
use fmi_hazard::scan::reachability::{AnalysisLimits, Until, analyse};
use fmi_hazard::sim::answers::Answers;
use tempfile::TempDir;

/// What watches the opening of the wall.
pub const WATCHES: [&str; 3] = [
    "kind = \"interlocked_door\"\nzone = { line_m = [[-0.4, -0.55], [0.4, -0.55]], heights_m = [0, 2.2] }\n",
    "kind = \"light_curtain\"\nzone = { line_m = [[-0.4, -0.55], [0.4, -0.55]], heights_m = [0, 2.2] }\n",
    "kind = \"mat\"\nzone = { polygon_m = [[-0.9, -0.75], [0.9, -0.75], [0.9, -0.5], [-0.9, -0.5]] }\n",
];

/// How long after the start of the FMU: the way in from the opening, with some more.
pub const UNTIL_S: f64 = 0.42;

/// A slide at shin height behind it, which harms legs and stands 0.1 s after a demand.
pub fn cell(watches: &str, latched_by: &str) -> String {
    let variable = if watches.contains("mat") { "plc.curtain_clear" } else { "plc.door_clear" };
    let wall =
        |x: f64| format!("[[obstacle]]\nname = \"wall\"\ncentre_m = [{x}, -0.55, 1.1]\nsize_m = [2, 0.05, 2.2]\n");
    let sensor = format!("[[sensor]]\nname = \"watch\"\n{watches}variable = \"{variable}\"\nactive = false\n");
    let (by_host, by_plc) = (latched_by == "host", latched_by == "PLC");
    format!(
        "schema = 1\nname = \"restarts\"\nfmu = \"gantry.fmu\"\n[[robot]]\nname = \"slide\"\nbase = {{ xyz_m = [-0.2, 0, 0.3] }}\n\
         moving_mass_kg = 200\npayload_kg = 0\n[[robot.joint]]\nname = \"axis\"\naxis = [1, 0, 0]\n\
         position = {{ variable = \"axis.position[1]\" }}\nspeed = {{ variable = \"axis.velocity[1]\" }}\n\
         [[robot.link]]\nname = \"beam\"\njoint = \"axis\"\ncapsule = {{ from_m = [0, -0.2, 0], to_m = [0, 0.2, 0], radius_m = 0.05 }}\n\
         {sensor}{}{}{}[human]\nbend_forward_deg = 0\nbend_lateral_deg = 0\nstart = {{ xy_m = [0, -1.1], heading_deg = 90 }}\n\
         floor_m = [[-0.2, -1.2], [0.2, -1.2], [0.2, 0], [-0.2, 0]]\n[search]\nactions = 5\n[inputs]\n\"plc.reset\" = false\n\
         [parameters]\n\"axis.stroke[1]\" = 0.4\n\"axis.speed[1]\" = 0.9\n\"plc.ramp_ms\" = 60\n\"plc.latched\" = {by_plc}\n",
        if by_host { "latched = true\n" } else { "" },
        wall(-1.4),
        wall(1.4).replace("wall", "other wall"),
    )
}

/// A folder with this as `gantry.fmu`.
pub fn folder(fmu: &str) -> TempDir {
    let dir = TempDir::new().unwrap();
    std::fs::copy(test_fmus().join(fmu), dir.path().join("gantry.fmu")).unwrap();
    dir
}

pub fn look(dir: &TempDir, text: &str, most_states: usize) -> ReachabilityResult {
    look_with(dir, text, most_states, StateChoice::Auto)
}

fn look_with(dir: &TempDir, text: &str, most_states: usize, state: StateChoice) -> ReachabilityResult {
    let path = write(dir.path(), "cell.toml", text);
    let answers = Answers::default();
    let until = Until::Seconds(UNTIL_S);
    let effort = AnalysisLimits { until, workers: 2, most_states, presses: 1, state, answers: &answers };
    analyse(&prepare(&path, None).unwrap(), effort, &mut |_| ControlFlow::Continue(())).unwrap().found
}

#[test]
fn nobody_is_certified_who_passes_what_restarts_by_itself() {
    let cases = ["gantry.fmu", "gantry-fmi3.fmu"].into_iter().flat_map(|fmu| WATCHES.map(|watches| (fmu, watches)));
    for (fmu, watches) in sample::some(cases, 6) {
        let dir = folder(fmu);
        let found = |latched_by, most_states| look(&dir, &cell(watches, latched_by), most_states);
        let passed = found("nobody", 300_000);
        assert_eq!(passed.verdict, Verdict::HazardsFound, "{fmu} {watches}: {:?}", passed.reasons);
        // The same with fewer states than passing takes: who keeps being reported is all that is followed.
        let few = found("nobody", 600);
        let changes = few.obligations.open().any(|one| one.need == Need::Changes);
        assert!(!few.verdict.is_clean() && changes, "{fmu} {watches}: {:?}", few.verdict);
        // Nor is anything known of behaviours where states are not saved: walks that are tried before show that they are hit.
        let tried = look_with(&dir, &cell(watches, "nobody"), 600, StateChoice::Replay);
        assert_eq!(tried.verdict, Verdict::HazardsFound, "{fmu} {watches}: {:?}", tried.reasons);
        for latched_by in ["host", "PLC"] {
            let clean = found(latched_by, 300_000);
            assert!(clean.verdict.is_clean() && !clean.any_time, "{fmu} {watches} {latched_by}: {:?}", clean.reasons);
        }
    }
}

/// The same, with a mat behind the opening that the FMU is told of by some input, if any: with a slide that comes back to the same places whenever it was stopped, or
/// with one that hardly ever does.
fn coming_back(watches: &str, mat: Option<&str>, to_the_same: bool) -> String {
    let text = cell(watches, "nobody");
    let text = if to_the_same {
        text.replace("\"axis.speed[1]\" = 0.9", "\"axis.speed[1]\" = 0.8")
            .replace("\"plc.ramp_ms\" = 60", "\"plc.ramp_ms\" = 40")
    } else {
        text
    };
    let Some(variable) = mat else { return text };
    let zone = "polygon_m = [[-0.9, -0.76], [0.9, -0.76], [0.9, 0.5], [-0.9, 0.5]]";
    let mat = format!(
        "[[sensor]]\nname = \"mat\"\nkind = \"mat\"\nzone = {{ {zone} }}\nvariable = \"{variable}\"\nactive = false\n[human]\n"
    );
    text.replace("[human]\n", &mat)
}

/// With fewer states than histories take, behaviours stand for them, or a net of these: whoever passes is hit; with a mat behind the opening, by the
/// same input or by another that is answered alike, nobody is, for who accepts that nothing is remembered that does not show in time, and for nobody else.
#[test]
fn where_histories_are_too_many_behaviours_stand_for_them() {
    let cases = ["gantry.fmu", "gantry-fmi3.fmu"]
        .into_iter()
        .flat_map(|fmu| [(fmu, true, "memory_shows"), (fmu, false, "nearly_alike")]);
    for (fmu, to_the_same, name) in sample::some(cases, 2) {
        let dir = folder(fmu);
        let variable = if fmu == "gantry.fmu" { "plc.door_clear" } else { "plc.curtain_clear" };
        let coming_back = |with_mat: bool| coming_back(WATCHES[0], with_mat.then_some(variable), to_the_same);
        let passed = look(&dir, &coming_back(false), 600);
        assert_eq!(passed.verdict, Verdict::HazardsFound, "{fmu}: {:?}", passed.reasons);
        // They wait for longer than was looked at: what is said of when holds for one that was confirmed.
        let hits = passed.hazards.iter().filter(|hazard| hazard.confirmed).filter_map(|hazard| hazard.time_s);
        let first = hits.min_by(f64::total_cmp).unwrap();
        assert_eq!(passed.until_hit_s().total_cmp(&first.max(UNTIL_S)), Ordering::Equal, "{first}");
        let held = look(&dir, &coming_back(true), 600);
        let open: Vec<_> = held.obligations.open().collect();
        assert!(held.hazards.is_empty() && open.iter().all(|one| one.need == Need::Changes), "{fmu}: {open:?}");
        let lines: Vec<String> = open
            .iter()
            .map(|one| {
                let Standing::Open { accept: Some(lines), .. } = &one.standing else { panic!("{one:?}") };
                lines.replace("by = \"\"", "by = \"us\"").replace("because = \"\"", "because = \"so\"")
            })
            .collect();
        assert!(lines[0].contains(name), "{lines:?}");
        // That what comes by two inputs is answered alike is accepted by a name of its own.
        if fmu == "gantry.fmu" {
            assert_eq!(lines.len(), 1, "{lines:?}");
        } else {
            assert!(lines.len() == 2 && lines[1].contains("readings_alike"), "{lines:?}");
            for one in &lines {
                let half = look(&dir, &format!("{}{one}", coming_back(true)), 600);
                assert!(!half.verdict.is_clean() && half.obligations.open().count() == 1, "{one}: {:?}", half.reasons);
            }
        }
        let lines = lines.concat();
        let accepted = look(&dir, &format!("{}{lines}", coming_back(true)), 600);
        assert!(accepted.verdict.is_clean() && accepted.any_time, "{fmu}: {:?}", accepted.reasons);
        // Who says that it takes longer does not accept this.
        let later = lines.replace("within_s = ", "within_s = 3");
        assert!(!look(&dir, &format!("{}{later}", coming_back(true)), 600).verdict.is_clean(), "{later}");
    }
}
