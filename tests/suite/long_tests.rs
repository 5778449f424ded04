//! The tests that only `tools/test --all` runs are those that CONTRIBUTING.md lists, each with its reason and the quick test that
//! stands for it.

use std::path::Path;

/// The tests of a file that are ignored, with their reasons.
fn ignored(text: &str) -> Vec<(String, String)> {
    let reasons = text.split("#[ignore = \"").skip(1);
    let one = |rest: &str| {
        let (reason, rest) = rest.split_once("\"]").expect("a reason ends");
        let (_, name) = rest.split_once("fn ").expect("a test follows");
        (name.split('(').next().expect("it has a name").to_owned(), reason.to_owned())
    };
    reasons.map(one).collect()
}

#[test]
fn what_only_the_long_run_has_is_listed_with_its_reason() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let in_folder = |folder: &str| {
        let mut files: Vec<_> =
            std::fs::read_dir(root.join(folder)).unwrap().map(|file| file.unwrap().path()).collect();
        files.sort();
        files
    };
    let files = [in_folder("tests/suite"), in_folder("research/tests")].concat();
    let (mut lines, mut all) = (Vec::new(), String::new());
    for file in files.iter().filter(|file| file.extension().is_some_and(|extension| extension == "rs")) {
        let text = std::fs::read_to_string(file).unwrap();
        let module = file.file_stem().unwrap().to_str().unwrap();
        if module != "long_tests" {
            let line = |(name, reason)| format!("- `{module}::{name}`: {reason}\n");
            lines.extend(ignored(&text).into_iter().map(line));
        }
        all += &text;
    }
    assert!(lines.len() > 10, "{lines:?}");
    let written = std::fs::read_to_string(root.join("CONTRIBUTING.md")).unwrap();
    let (_, list) = written.split_once("<!-- tests of --all -->\n").expect("it has the list");
    let (list, _) = list.split_once("<!-- end -->").expect("the list ends");
    assert!(list == lines.concat(), "CONTRIBUTING.md does not list what is ignored, which is:\n{}", lines.concat());
    // The quick test that stands for one is there, or the file of several.
    for line in &lines {
        let parts: Vec<&str> = line.split('`').collect();
        // Of a name that is told to be this one without its end, the end is quoted.
        let quoted = parts.windows(2).skip(2).step_by(2).filter(|two| !two[0].ends_with("without "));
        for name in quoted.map(|two| two[1]).filter(|name| name.contains('_')) {
            let own = name.rsplit("::").next().unwrap();
            let is_file = root.join(format!("tests/suite/{own}.rs")).is_file();
            assert!(is_file || all.contains(&format!("fn {own}()")), "there is no test `{name}`");
        }
    }
}
