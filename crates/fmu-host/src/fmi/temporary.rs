//! Temporary folders that do not outlive the program for long, even if it is killed.
//!
//! All folders of a process lie in one, which holds a locked file. The system drops the lock with the process, however
//! it ends, so whoever comes next can tell folders that nobody needs any more, and removes them.

use std::fs::File;
use std::io;
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError, Weak};

use rustix::fs::{FlockOperation, flock};
use tempfile::TempDir;

/// A folder that is removed when it is dropped.
pub(crate) struct Folder {
    folder: TempDir,
    _root: Arc<Root>,
}

impl Folder {
    /// An empty folder.
    pub(crate) fn new(prefix: &str) -> io::Result<Self> {
        let root = Root::of_this_process()?;
        Ok(Self { folder: tempfile::Builder::new().prefix(prefix).tempdir_in(root.folder.path())?, _root: root })
    }

    /// Where it is.
    pub(crate) fn path(&self) -> &Path {
        self.folder.path()
    }
}

/// The folder of all folders of this process.
struct Root {
    folder: TempDir,
    _lock: File,
}

/// How the names of such folders begin.
const PREFIX: &str = "fmi-hazard-";
/// The locked file in each.
const LOCK: &str = "lock";

impl Root {
    fn of_this_process() -> io::Result<Arc<Self>> {
        static ROOT: Mutex<Weak<Root>> = Mutex::new(Weak::new());
        let mut root = ROOT.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(root) = root.upgrade() {
            return Ok(root);
        }
        let all = tempfile::env::temp_dir();
        sweep(&all);
        let mut tries = 0;
        let new = loop {
            tries += 1;
            match Self::new(&all) {
                Err(_) if tries < TRIES => {}
                made => break Arc::new(made?),
            }
        };
        *root = Arc::downgrade(&new);
        Ok(new)
    }

    /// A new one; nothing if another process swept it away before it was locked.
    fn new(all: &Path) -> io::Result<Self> {
        let folder = tempfile::Builder::new().prefix(PREFIX).tempdir_in(all)?;
        let lock = File::create_new(folder.path().join(LOCK))?;
        flock(&lock, FlockOperation::NonBlockingLockExclusive)?;
        // Whoever had the lock in between has removed the file.
        std::fs::metadata(folder.path().join(LOCK))?;
        Ok(Self { folder, _lock: lock })
    }
}

/// How often such a folder is made: other processes that begin at the same moment may take it for one that nobody needs.
const TRIES: u32 = 20;

/// Removes what processes left behind that are gone. What cannot be removed stays: it may be another user's.
fn sweep(all: &Path) {
    for entry in std::fs::read_dir(all).into_iter().flatten().flatten() {
        if !entry.file_name().to_string_lossy().starts_with(PREFIX) {
            continue;
        }
        let Ok(lock) = File::open(entry.path().join(LOCK)) else { continue };
        if flock(&lock, FlockOperation::NonBlockingLockExclusive).is_ok() {
            let _ = std::fs::remove_dir_all(entry.path());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folders_of_living_processes_stay_and_others_go() {
        let all = tempfile::tempdir().unwrap();
        let [alive, gone, other] = ["fmi-hazard-a", "fmi-hazard-b", "someone-else"].map(|name| all.path().join(name));
        for folder in [&alive, &gone, &other] {
            std::fs::create_dir_all(folder.join("inside")).unwrap();
            File::create(folder.join(LOCK)).unwrap();
        }
        let lock = File::open(alive.join(LOCK)).unwrap();
        flock(&lock, FlockOperation::NonBlockingLockExclusive).unwrap();
        sweep(all.path());
        assert!(alive.exists() && !gone.exists() && other.exists());
        drop(lock);
        sweep(all.path());
        assert!(!alive.exists());
    }

    #[test]
    fn the_folder_goes_with_the_last_of_its_users() {
        let (a, b) = (Folder::new("a-").unwrap(), Folder::new("b-").unwrap());
        let (at, root) = (a.path().to_owned(), a.path().parent().unwrap().to_owned());
        assert_eq!(b.path().parent().unwrap(), root);
        drop(a);
        assert!(!at.exists() && b.path().exists());
    }
}
