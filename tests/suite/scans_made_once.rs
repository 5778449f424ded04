//! The store of scans that tests share.

use crate::common::examples;
use crate::common::stored::scanned;

/// The same scan is not made twice, one of another cell or with other arguments is.
#[test]
fn the_same_scan_is_made_once_and_another_one_is_made() {
    // Nobody else scans this: the process and the time are in it.
    let own = format!("{} {:?}", std::process::id(), std::time::Instant::now());
    let scan = |comment: &str, iterations: &str| {
        let dir = examples();
        let cell = dir.path().join("safety-fence/cell.toml");
        let text = std::fs::read_to_string(&cell).unwrap();
        std::fs::write(&cell, format!("# {own} {comment}\n{text}")).unwrap();
        let few = ["--strategy", "random", "--iterations", iterations];
        let arguments = [&["safety-fence/cell.toml", "--no-advice"], &few[..], &["--out", "o"]].concat();
        let ran = scanned(dir.path(), &arguments);
        let scan = std::fs::read_to_string(dir.path().join("o/scan.json")).unwrap();
        assert!(ran.code == Some(1) || ran.code == Some(4), "{}", ran.stderr);
        (ran.made, ran.stdout, scan)
    };
    let (first, again) = (scan("one", "2"), scan("one", "2"));
    assert!(first.0 && !again.0);
    assert_eq!((first.1, first.2), (again.1, again.2));
    assert!(scan("one", "3").0 && scan("other", "2").0);
}
