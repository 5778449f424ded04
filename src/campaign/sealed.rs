//! A result on disk. It is written beside its place and then moved there, so that it is whole or not there, whoever else writes the
//! same; and it says of which task it is and what its bytes come to, so that neither a torn file nor that of another task is taken.

use std::io::Write as _;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use super::CampaignError;
use super::manifest::hash;

/// Where results of tasks are, in the folder of the campaign.
pub(crate) const TASKS: &str = "tasks";

/// The first line of a result.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Seal {
    /// The task.
    task: String,
    /// SHA-256 of what follows the line.
    sha256: String,
    /// How long it took, s: no part of the result.
    seconds: f64,
}

/// What there is of a task.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Kept {
    /// Its result, and how long it took, s.
    Whole(Vec<u8>, f64),
    /// Something that is not its result.
    Damaged,
    /// Nothing.
    Missing,
}

/// Where the result of a task is.
#[must_use]
pub(crate) fn path(folder: &Path, task: &str) -> PathBuf {
    folder.join(TASKS).join(task)
}

/// Keeps the result of a task.
///
/// # Errors
/// When it cannot be written.
pub(crate) fn keep(folder: &Path, task: &str, bytes: &[u8], seconds: f64) -> Result<(), CampaignError> {
    let seal = Seal { task: task.to_owned(), sha256: hash(bytes), seconds: (seconds * 1000.0).round() / 1000.0 };
    let mut all = serde_json::to_vec(&seal).map_err(|e| CampaignError::Ours(e.to_string()))?;
    all.push(b'\n');
    all.extend(bytes);
    write(&path(folder, task), &all)
}

/// What there is of a task.
#[must_use]
pub(crate) fn kept(folder: &Path, task: &str) -> Kept {
    let Ok(mut bytes) = std::fs::read(path(folder, task)) else { return Kept::Missing };
    let Some(end) = bytes.iter().position(|&byte| byte == b'\n') else { return Kept::Damaged };
    let body = bytes.split_off(end + 1);
    match serde_json::from_slice::<Seal>(&bytes) {
        Ok(seal) if seal.task == task && seal.sha256 == hash(&body) => Kept::Whole(body, seal.seconds),
        _ => Kept::Damaged,
    }
}

/// Writes a file so that it is whole or as it was before.
///
/// # Errors
/// When that cannot be done.
pub(crate) fn write(path: &Path, bytes: &[u8]) -> Result<(), CampaignError> {
    let folder = path.parent().unwrap_or(Path::new(""));
    std::fs::create_dir_all(folder).map_err(CampaignError::machine("make the folder", folder))?;
    let written = tempfile::Builder::new().prefix(".writing-").tempfile_in(folder).and_then(|mut file| {
        file.write_all(bytes)?;
        file.as_file().sync_all()?;
        // As any file: others may read it.
        std::fs::set_permissions(file.path(), readable())?;
        file.persist(path).map_err(|e| e.error)
    });
    written.map(drop).map_err(CampaignError::machine("write", path))
}

fn readable() -> std::fs::Permissions {
    use std::os::unix::fs::PermissionsExt as _;
    std::fs::Permissions::from_mode(0o644)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_whole_result_of_the_same_task_is_taken() {
        let dir = tempfile::tempdir().unwrap();
        let folder = dir.path();
        assert_eq!(kept(folder, "a"), Kept::Missing);
        keep(folder, "a", b"{}\nmore\0", 1.23456).unwrap();
        assert_eq!(kept(folder, "a"), Kept::Whole(b"{}\nmore\0".to_vec(), 1.235));
        let whole = std::fs::read(path(folder, "a")).unwrap();
        for end in 0..whole.len() {
            std::fs::write(path(folder, "a"), &whole[..end]).unwrap();
            assert_eq!(kept(folder, "a"), Kept::Damaged, "{end} bytes of {}", whole.len());
        }
        std::fs::write(path(folder, "b"), &whole).unwrap();
        assert_eq!(kept(folder, "b"), Kept::Damaged, "it is that of another task");
        keep(folder, "b", b"", 0.0).unwrap();
        assert_eq!(kept(folder, "b"), Kept::Whole(Vec::new(), 0.0));
        assert_eq!(std::fs::read_dir(folder.join(TASKS)).unwrap().count(), 2, "nothing is left beside them");
    }
}
