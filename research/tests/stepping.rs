//! `fmi-hazard-research step`: another program that takes the actions of a recorded hazard meets that hazard, and saved states are what they
//! were; as an environment of Gymnasium too. Needs the Python environment that `tools/test` makes.

#![expect(clippy::unwrap_used, reason = "a test fails where something is wrong")]

use std::ops::ControlFlow;
use std::path::Path;
use std::process::Command as Process;

use assert_cmd::Command;
use fmi_hazard::scan::prepare::prepare;
use fmi_hazard::scan::{Method, ScanOptions, StateChoice, StrategyName, scan};
use serde_json::{Value, json};
use tempfile::TempDir;

/// The hazards of a quick search in the cell of the conversation.
fn recorded(dir: &Path) -> Value {
    let prepared = prepare(&dir.join("heavy-workpiece/cell.toml"), None).unwrap();
    let options = ScanOptions {
        method: Method::Strategy(StrategyName::Hybrid),
        seed: 1,
        iterations: 60,
        stop_at_first: false,
        posture_sweep: true,
        state: StateChoice::Auto,
    };
    serde_json::to_value(scan(&prepared, options, &mut |_| ControlFlow::Continue(())).unwrap().report).unwrap()
}

#[test]
fn the_actions_of_a_hazard_lead_to_it_and_states_come_back() {
    let dir = TempDir::new().unwrap();
    fmi_hazard::examples::export(dir.path()).unwrap();
    let recorded = recorded(dir.path());
    let hazard = &recorded["hazards"][0];
    let described = say(dir.path(), &[json!({ "do": "describe" })]).remove(0);
    let names: Vec<&str> = described["actions"].as_array().unwrap().iter().map(|name| name.as_str().unwrap()).collect();
    assert_eq!(names.len(), 36);
    let number = |action: &Value| names.iter().position(|name| *name == action.as_str().unwrap()).unwrap();
    let way: Vec<usize> = hazard["actions"].as_array().unwrap().iter().map(number).collect();
    let step = |action: &usize| json!({ "do": "step", "action": action });
    let (last, before) = way.split_last().unwrap();
    let mut questions = vec![json!({ "do": "reset" })];
    questions.extend(before.iter().map(step));
    // Saved before the last action; taken; brought back after a reset; taken again.
    questions.extend([json!({ "do": "save" }), step(last), step(last), json!({ "do": "reset" })]);
    questions.extend([json!({ "do": "restore", "state": 1 }), step(last)]);
    let mut answers = say(dir.path(), &questions);
    let again = answers.pop().unwrap();
    let back = answers.pop().unwrap();
    let reset = answers.pop().unwrap();
    let (over, met, saved) = (answers.pop().unwrap(), answers.pop().unwrap(), answers.pop().unwrap());
    assert_eq!((&met["end"], &met["hazard"]["id"]), (&json!("unsafe"), &hazard["id"]), "{met}");
    assert_eq!(met["hazard"]["actions"], hazard["actions"]);
    let near = |a: &Value, b: &Value| (a.as_f64().unwrap() - b.as_f64().unwrap()).abs() < 1e-9;
    assert!(near(&met["hazard"]["ratio"], &hazard["ratio"]), "{met}");
    // The paper's rewards: none on the way, and none is higher than that of harm.
    assert!(
        near(&met["reward"], &json!(0.0)) && answers[1..].iter().all(|answer| near(&answer["reward"], &json!(0.0)))
    );
    assert_eq!(again, met);
    assert!(over["error"].as_str().unwrap().contains("the episode is over"), "{over}");
    assert_eq!((&saved, &answers[0]), (&json!({ "state": 1 }), &reset));
    let before = answers.last().unwrap();
    assert_eq!((&back["observation"], &before["end"]), (&before["observation"], &Value::Null));
    // Where they start, and who is hit is where the record says.
    let [x, y] = [0, 1].map(|axis| reset["observation"]["xy_m"][axis].as_f64().unwrap());
    assert!((x - 1.6).abs() < 1e-9 && (y + 1.2).abs() < 1e-9, "{reset}");
    let wrong =
        say(dir.path(), &[json!({ "do": "step", "action": 36 }), json!({ "do": "sing" }), json!({ "do": "reset" })]);
    assert!(wrong[..2].iter().all(|answer| answer["error"].is_string()) && wrong[2] == reset, "{wrong:?}");
}

/// The answers to some questions, in one conversation.
fn say(dir: &Path, questions: &[Value]) -> Vec<Value> {
    let text: String = questions.iter().map(|question| format!("{question}\n")).collect();
    let mut command = Command::new(env!("CARGO_BIN_EXE_fmi-hazard-research"));
    command.current_dir(dir).args(["step", "heavy-workpiece/cell.toml"]);
    let output = command.write_stdin(text).output().unwrap();
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let said = String::from_utf8(output.stdout).unwrap();
    let answers: Vec<Value> = said.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(answers.len(), questions.len(), "{said}");
    answers
}

/// By the checker of Gymnasium, and by what it says of itself.
#[test]
fn a_cell_is_an_environment_of_gymnasium_whose_states_come_back() {
    let dir = TempDir::new().unwrap();
    fmi_hazard::examples::export(dir.path()).unwrap();
    let tests = Path::new(env!("CARGO_MANIFEST_DIR")).join("peers/test_environment.py");
    let python = std::env::var_os("FMI_HAZARD_PYTHON").unwrap_or_else(|| "python3".into());
    let mut command = Process::new(python);
    command.arg(tests).current_dir(dir.path()).env("FMI_HAZARD_RESEARCH", env!("CARGO_BIN_EXE_fmi-hazard-research"));
    let output = command.env("PYTHONDONTWRITEBYTECODE", "1").output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}
