//! Paths in results. They are relative to the folder of the result where that is possible, so that a result may be moved
//! together with what it is of; and what they name is found again.

use std::path::Path;

use crate::cell::file::files::named_from;
use crate::record::model::{ScanReport, Subject};

/// `path` as a file in `folder` names it, so that it is found from there: without going through links if that is enough.
#[must_use]
pub(crate) fn relative_to(path: &Path, folder: &Path) -> String {
    let plainly = named_from(path, folder);
    if folder.join(&plainly).exists() || !path.exists() {
        return plainly;
    }
    match (path.canonicalize(), folder.canonicalize()) {
        (Ok(path), Ok(folder)) => named_from(&path, &folder),
        _ => plainly,
    }
}

/// The same report for a file in `folder`.
#[must_use]
pub(crate) fn relative(report: &ScanReport, folder: &Path) -> ScanReport {
    let from = |path: &str| relative_to(Path::new(path), folder);
    let subject = &report.subject;
    // A cell file inside an archive stands behind the archive's path.
    let cell_found = match subject.cell_found.rsplit_once('!') {
        Some((archive, inside)) if inside.starts_with("extra/") => format!("{}!{inside}", from(archive)),
        _ => from(&subject.cell_found),
    };
    let subject = Subject {
        path: from(&subject.path),
        cell_file: subject.cell_file.as_deref().map(from),
        cell_found,
        ..subject.clone()
    };
    ScanReport { subject, ..report.clone() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::recorded::found;

    #[test]
    fn a_path_is_seen_from_the_result_and_found_again() {
        let dir = tempfile::tempdir().unwrap();
        let (cell, out) = (dir.path().join("cells/a/cell.toml"), dir.path().join("out/x"));
        std::fs::create_dir_all(cell.parent().unwrap()).unwrap();
        std::fs::create_dir_all(&out).unwrap();
        std::fs::write(&cell, "").unwrap();
        assert_eq!(relative_to(&cell, &out), "../../cells/a/cell.toml");
        assert_eq!(found(Path::new("../../cells/a/cell.toml"), &out), cell);
        // Results in a folder that is a link.
        let linked = dir.path().join("link");
        std::os::unix::fs::symlink(&out, &linked).unwrap();
        let named = relative_to(&cell, &linked);
        for folder in [&out, &linked] {
            let found = found(Path::new(&named), folder).canonicalize().unwrap();
            assert_eq!(found, cell.canonicalize().unwrap(), "{named}");
        }
        let gone = found(Path::new("../gone.toml"), &out);
        assert_eq!(gone, dir.path().join("out/gone.toml"));
    }
}
