//! Manners at the terminal: what goes where, how much of it, colours and progress only where they belong, completions and
//! manual pages.

use std::path::Path;
use std::process::{Command, Output, Stdio};

use crate::common::{examples, fmi_hazard};
use crate::sample;

const SCAN: [&str; 7] =
    ["scan", "--no-advice", "head-collision/cell.toml", "--strategy", "hybrid", "--iterations", "10"];

fn ran(dir: &Path, arguments: &[&str]) -> (Option<i32>, String, String) {
    let Output { status, stdout, stderr } = fmi_hazard(dir).args(arguments).output().unwrap();
    (status.code(), String::from_utf8(stdout).unwrap(), String::from_utf8(stderr).unwrap())
}

#[test]
fn quiet_says_results_and_warnings_only_and_verbose_says_more() {
    if !sample::is_turn(2, 4) {
        return;
    }
    let dir = examples();
    let dir = dir.path();
    let (code, result, said) = ran(dir, &SCAN);
    assert!(code == Some(1) && said.contains("Loaded") && said.contains("10/10 iterations"), "{said}");
    assert!(result.contains("\n C-") && !result.contains("\n H-"), "{result}");
    for arguments in [[&["--quiet"], &SCAN[..]].concat(), [&SCAN[..], &["-q"]].concat()] {
        assert_eq!(ran(dir, &arguments), (Some(1), result.clone(), String::new()));
    }
    let (_, _, warned) = ran(dir, &[&SCAN[..], &["-q", "--trust-fmu"]].concat());
    assert!(warned.lines().count() == 1 && warned.contains("Warning the FMU is trusted"), "{warned}");
    let (_, every, more) = ran(dir, &[&["-v"], &SCAN[..]].concat());
    assert!(!said.contains("sha256") && !said.contains("to search and confirm"));
    // What is told is the end of it, and every hazard stands before. All of them are of the head, for which no speed is safe.
    let told = &result[result.find("\n 1 cause").unwrap()..];
    assert!(every.ends_with(told), "{every}");
    let mut rows = every.lines().filter(|line| line.starts_with(" H-")).peekable();
    assert!(rows.peek().is_some() && rows.all(|row| row.contains("  none  ")), "{every}");
    for word in ["sha256", "states restored exact", "to search and confirm"] {
        assert!(more.contains(word), "{word}: {more}");
    }
    // JSON stays JSON.
    let (_, json, said) = ran(dir, &[&["-q"], &SCAN[..], &["--format", "json"]].concat());
    assert!(said.is_empty() && serde_json::from_str::<serde_json::Value>(&json).is_ok());
    // Errors are told all the same.
    let (code, _, said) = ran(dir, &["-q", "scan", "--no-advice", "nowhere.toml"]);
    assert!(code == Some(2) && said.contains("nowhere.toml"), "{said}");
    let (code, _, said) = ran(dir, &["-q", "-v", "schema"]);
    assert!(code == Some(2) && said.contains("cannot be used with"), "{said}");
}

#[test]
fn a_scan_is_resumed_quietly_too() {
    let dir = examples();
    let dir = dir.path();
    for quiet in [&["scan", "--resume", "nowhere", "-q"][..], &["-q", "scan", "--resume", "nowhere"]] {
        let (code, _, said) = ran(dir, quiet);
        assert!(code == Some(2) && said.contains("there is no scan to go on with in nowhere"), "{said}");
    }
    for other in [&["head-collision/cell.toml"][..], &["--seed", "2"], &["--fmu-timeout", "3"], &["--workers", "1"]] {
        let (code, _, said) = ran(dir, &[&["scan", "--resume", "nowhere"], other].concat());
        assert!(code == Some(2) && said.contains("cannot be used with"), "{other:?}: {said}");
    }
}

/// What the command shows on a terminal of its own, without colours if so wished.
fn on_a_terminal(dir: &Path, arguments: &[&str], no_color: bool) -> String {
    let words = [&[env!("CARGO_BIN_EXE_fmi-hazard")], arguments].concat();
    let mut command = Command::new("script");
    command.args(["--quiet", "--return", "--command", &words.join(" "), "/dev/null"]).current_dir(dir);
    command.env("TERM", "xterm").env_remove("NO_COLOR").stdin(Stdio::null());
    if no_color {
        command.env("NO_COLOR", "1");
    }
    String::from_utf8_lossy(&command.output().unwrap().stdout).into_owned()
}

/// Whether there is an escape sequence that sets a colour.
fn coloured(text: &str) -> bool {
    let codes = text.split("\u{1b}[").skip(1).filter_map(|rest| {
        let end = rest.find(|c: char| !c.is_ascii_digit() && c != ';')?;
        rest[end..].starts_with('m').then_some(&rest[..end])
    });
    codes.flat_map(|codes| codes.split(';')).any(|code| matches!(code.parse(), Ok(30..=37 | 90..=97)))
}

#[test]
fn bars_and_colours_are_for_terminals_and_colours_only_if_wanted() {
    let dir = examples();
    let dir = dir.path();
    let shown = on_a_terminal(dir, &SCAN, false);
    assert!(shown.contains("Scanning [") && !shown.contains("10/10 iterations"), "{shown}");
    let shown = on_a_terminal(dir, &[&["-q"], &SCAN[..]].concat(), false);
    assert!(!shown.contains("Scanning [") && !shown.contains("Loaded") && shown.contains("confirmed by"), "{shown}");
    // An error is coloured, but not against the user's wish.
    let wrong = ["scan", "--no-advice", "head-collision/wrong.toml"];
    let cell = std::fs::read_to_string(dir.join("head-collision/cell.toml")).unwrap();
    std::fs::write(dir.join(wrong[2]), cell.replace("moving_mass_kg", "moving_mas_kg")).unwrap();
    let shown = on_a_terminal(dir, &wrong, false);
    assert!(coloured(&shown) && shown.contains("moving_mass_kg"), "{shown:?}");
    let plain = on_a_terminal(dir, &wrong, true);
    assert!(!coloured(&plain) && plain.contains("moving_mass_kg"), "{plain:?}");
    assert!(!coloured(&on_a_terminal(dir, &["--help"], true)));
    // Nothing of the kind where nobody looks, without being told.
    let output =
        Command::new(env!("CARGO_BIN_EXE_fmi-hazard")).args(SCAN).current_dir(dir).env_remove("NO_COLOR").output();
    let output = output.unwrap();
    assert!(!output.stdout.contains(&0x1b) && !output.stderr.contains(&0x1b));
}

#[test]
fn shells_complete_commands_and_options() {
    let dir = tempfile::TempDir::new().unwrap();
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let (code, script, _) = ran(dir.path(), &["manual", "--completions", shell]);
        assert!(code == Some(0) && script.contains("fmi-hazard") && script.contains("write-baseline"), "{shell}");
        // `worker` is not for people; `--workers` is.
        let words = script.split(|c: char| !c.is_ascii_alphanumeric());
        assert!(words.clone().any(|word| word == "workers") && !words.clone().any(|word| word == "worker"), "{shell}");
    }
    let complete = |words: &str, at: usize| {
        let program = env!("CARGO_BIN_EXE_fmi-hazard");
        let script = format!(
            "source <('{program}' manual --completions bash); COMP_WORDS=({words}); COMP_CWORD={at}; \
             _fmi__hazard fmi-hazard \"${{COMP_WORDS[{at}]}}\" \"${{COMP_WORDS[{at}-1]}}\"; echo \"${{COMPREPLY[@]}}\""
        );
        let output = Command::new("bash").args(["-c", &script]).output().unwrap();
        String::from_utf8(output.stdout).unwrap().trim().to_owned()
    };
    assert_eq!(complete("fmi-hazard rep", 1), "replay report");
    assert_eq!(complete("fmi-hazard scan --strat", 2), "--strategy");
    assert!(complete("fmi-hazard scan --strategy ''", 3).contains("exhaustive"));
}

#[test]
fn every_command_has_a_manual_page_with_all_its_options() {
    let dir = tempfile::TempDir::new().unwrap();
    assert_eq!(ran(dir.path(), &["manual", "--pages", "man"]).0, Some(0));
    let (_, help, _) = ran(dir.path(), &["--help"]);
    let commands = help.lines().skip_while(|line| *line != "Begin:").take_while(|line| *line != "Options:");
    let names: Vec<&str> = commands
        .filter(|line| line.starts_with("  ") && !line.starts_with("   "))
        .filter_map(|line| line.split_whitespace().next())
        .filter(|name| *name != "help")
        .collect();
    assert!(names.len() > 10 && names.contains(&"scan"), "{names:?}");
    for name in names {
        let page = std::fs::read_to_string(dir.path().join(format!("man/fmi-hazard-{name}.1"))).unwrap();
        assert!(page.contains(".TH"), "{name}");
        let (_, help, _) = ran(dir.path(), &[name, "--help"]);
        let options = help.split(|c: char| !(c.is_ascii_alphanumeric() || c == '-')).filter(|w| w.starts_with("--"));
        // Hyphens are escaped on such pages.
        let plain = page.replace('\\', "");
        for option in options.filter(|option| option.len() > 3) {
            assert!(plain.contains(option), "{name} {option}");
        }
    }
    assert!(!dir.path().join("man/fmi-hazard-worker.1").exists());
}
