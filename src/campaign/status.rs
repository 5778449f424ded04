//! What of a campaign is there, and what is missing.

use std::collections::BTreeSet;
use std::path::Path;

use super::manifest::{Manifest, Task};
use super::sealed::{Kept, TASKS, kept};

/// What there is.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Status {
    /// Tasks with a result.
    pub done: Vec<Task>,
    /// Tasks without.
    pub missing: Vec<Task>,
    /// Of these, those of which there is something that is no whole result.
    pub damaged: Vec<Task>,
    /// Results of what is not in the plan any more.
    pub others: usize,
    /// How long those that are done took together, s.
    pub seconds: f64,
}

/// Looks at every task.
#[must_use]
pub(crate) fn status(folder: &Path, manifest: &Manifest) -> Status {
    let mut status = Status::default();
    let mut names = BTreeSet::new();
    for task in manifest.tasks() {
        let name = manifest.name(task);
        match kept(folder, &name) {
            Kept::Whole(_, seconds) => {
                status.seconds += seconds;
                status.done.push(task);
            }
            damaged @ (Kept::Damaged | Kept::Missing) => {
                if damaged == Kept::Damaged {
                    status.damaged.push(task);
                }
                status.missing.push(task);
            }
        }
        names.insert(name);
    }
    // What parts of a search came to when they were put together.
    names.extend(manifest.scans.iter().map(|scan| scan.id.clone()));
    let files = std::fs::read_dir(folder.join(TASKS)).into_iter().flatten().flatten();
    let files = files.map(|file| file.file_name().to_string_lossy().into_owned());
    status.others = files.filter(|name| !name.starts_with('.') && !names.contains(name)).count();
    status
}
