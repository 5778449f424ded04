//! Files that a cell file names: each is read once, and remembered with its hash, so that results can say what they are of.

use path_clean::clean;
use std::cell::RefCell;
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

use crate::cell::hash::sha256;
use crate::cell::workcell::GeometryFile;

/// Files that were read, in that order.
#[derive(Debug, Default)]
pub(super) struct Files(RefCell<Vec<(GeometryFile, Arc<[u8]>)>>);

impl Files {
    /// The content of `path`, relative to `folder`.
    pub(super) fn read(&self, folder: &Path, path: &Path) -> std::io::Result<Arc<[u8]>> {
        let path = clean(path);
        if let Some((_, bytes)) = self.0.borrow().iter().find(|(file, _)| file.path == path) {
            return Ok(Arc::clone(bytes));
        }
        let bytes: Arc<[u8]> = std::fs::read(folder.join(&path))?.into();
        let sha256 = sha256(&bytes);
        self.0.borrow_mut().push((GeometryFile { path, sha256 }, Arc::clone(&bytes)));
        Ok(bytes)
    }

    /// Files that were read elsewhere.
    pub(super) fn note<'a>(&self, files: impl Iterator<Item = (&'a Path, &'a [u8])>) {
        let told = |(path, bytes): (&Path, &'a [u8])| {
            (GeometryFile { path: path.to_owned(), sha256: sha256(bytes) }, bytes.into())
        };
        self.0.borrow_mut().extend(files.map(told));
    }

    /// What was read so far.
    pub(super) fn take(&self) -> Vec<GeometryFile> {
        self.0.take().into_iter().map(|(file, _)| file).collect()
    }
}

/// `path` as a file in `folder` names it, by way of what both are in; nothing if that is the root alone.
#[must_use]
pub(crate) fn relative(path: &Path, folder: &Path) -> Option<PathBuf> {
    let absolute = |path: &Path| {
        let path = if path.as_os_str().is_empty() { Path::new(".") } else { path };
        clean(std::path::absolute(path).unwrap_or_else(|_| path.to_owned()))
    };
    let (path, folder) = (absolute(path), absolute(folder));
    let shared = path.components().zip(folder.components()).take_while(|(a, b)| a == b).count();
    if shared <= 1 {
        return None;
    }
    let up = folder.components().skip(shared).map(|_| Component::ParentDir);
    Some(up.chain(path.components().skip(shared)).collect())
}

/// The same as text; absolute where it cannot be told from there.
#[must_use]
pub fn named_from(path: &Path, folder: &Path) -> String {
    let absolute = || clean(std::path::absolute(path).unwrap_or_else(|_| path.to_owned()));
    relative(path, folder).unwrap_or_else(absolute).display().to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_read_once_and_hashed() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("a"), "abc").unwrap();
        let files = Files::default();
        assert_eq!(&*files.read(folder.path(), Path::new("a")).unwrap(), b"abc");
        assert_eq!(&*files.read(folder.path(), Path::new("./a")).unwrap(), b"abc");
        let read = files.take();
        assert_eq!(read.len(), 1);
        // FIPS 180-2, appendix B.1.
        assert_eq!(read[0].sha256, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    }
}
