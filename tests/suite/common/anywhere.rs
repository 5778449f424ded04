//! Small cells with the bar of `guarded`, and looks at them from anywhere.

use std::ops::ControlFlow;
use std::path::Path;

use super::guarded::bar;
use super::write;
use fmi_hazard::record::reachability::ReachabilityResult;
use fmi_hazard::scan::StateChoice;
use fmi_hazard::scan::prepare::prepare;
use fmi_hazard::scan::reachability::{AnalysisLimits, AnalysisResult, EventSink, Until, analyse};
use fmi_hazard::sim::answers::Answers;

/// A short bar that turns fast enough to hurt, at a height, with these parts around it.
pub fn cell(z: f64, parts: &str) -> String {
    let bar = bar("bar", 0.0, z).replace("to_m = [0.8,", "to_m = [0.35,");
    format!(
        "schema = 1\nname = \"anywhere\"\nfmu = \"guarded.fmu\"\n{bar}{parts}\n[human]\nstart = {{ xy_m = [0, -3], \
         heading_deg = 90 }}\n[search]\nactions = 2\n[parameters]\n\"drive.speed\" = 5\n\"ssm.distance\" = 0.0\n"
    )
}

/// A mat over a rectangle, from low x and y to high, m.
pub fn mat(name: &str, variable: &str, [x0, y0, x1, y1]: [f64; 4]) -> String {
    format!(
        "[[sensor]]\nname = \"{name}\"\nkind = \"mat\"\nvariable = \"{variable}\"\nactive = false\nzone = {{ polygon_m = \
         [[{x0}, {y0}], [{x1}, {y0}], [{x1}, {y1}], [{x0}, {y1}]] }}\n"
    )
}

/// Two bars, each with a mat of its own around it; the mats' signals go to these controllers.
pub fn two_bars(wired: [&str; 2]) -> String {
    let places = [("a", -2.3), ("b", 2.3)];
    let robot = |(unit, x): (&str, f64)| {
        bar(unit, x, 0.45)
            .replace("to_m = [0.8,", "to_m = [0.35,")
            .replace("variable = \"", &format!("variable = \"{unit}:"))
    };
    let unit = |(unit, _): (&str, f64)| format!("[[unit]]\nname = \"{unit}\"\nfmu = \"guarded.fmu\"\n");
    let mat = |((unit, x), wired): ((&str, f64), &str)| {
        mat(&format!("mat {unit}"), &format!("{wired}:clear"), [x - 2.1, -2.1, x + 2.1, 2.1])
    };
    let (units, bars) = (places.map(unit).concat(), places.map(robot).concat());
    let mats = places.into_iter().zip(wired).map(mat).collect::<Vec<_>>().concat();
    format!(
        "schema = 1\nname = \"two\"\n{units}{mats}{bars}[human]\nstart = {{ xy_m = [0, -3], heading_deg = 90 }}\n[search]\n\
         actions = 2\n[parameters]\n\"a:drive.speed\" = 5\n\"b:drive.speed\" = 5\n"
    )
}

/// What is found from anywhere until then, on so many threads.
pub fn look(dir: &Path, text: &str, until_s: f64, workers: usize) -> ReachabilityResult {
    look_at(&write(dir, "cell.toml", text), until_s, workers)
}

/// The same of a cell file.
pub fn look_at(path: &Path, until_s: f64, workers: usize) -> ReachabilityResult {
    look_with((path, until_s, workers), &Answers::default(), &mut |_| ControlFlow::Continue(())).found
}

/// The same with what is known and kept, and who may end it.
pub fn look_with(
    (path, until_s, workers): (&Path, f64, usize),
    answers: &Answers,
    tell: &mut EventSink<'_>,
) -> AnalysisResult {
    let until = Until::Seconds(until_s);
    let effort = AnalysisLimits { until, workers, most_states: 100_000, presses: 1, state: StateChoice::Auto, answers };
    analyse(&prepare(path, None).unwrap(), effort, tell).unwrap()
}
