//! Opening the archive of an FMU safely: everything is checked before a byte is written, and what is written is
//! counted, whatever the archive's headers say.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{self, BufReader, Read, Write};
use std::path::{Path, PathBuf};

use sha2::{Digest as _, Sha256};
use zip::ZipArchive;

use super::error::Error;
use super::temporary::Folder;

/// Limits against archives that unpack to more than anybody wants.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ArchiveLimits {
    /// Bytes of all files together.
    pub total_bytes: u64,
    /// Unpacked over packed size of one file, once it is larger than a megabyte.
    pub ratio: u64,
    /// Number of entries.
    pub entries: usize,
}

impl Default for ArchiveLimits {
    /// 2 GiB, 1000 : 1, 100 000 entries.
    fn default() -> Self {
        Self { total_bytes: 2 << 30, ratio: 1000, entries: 100_000 }
    }
}

/// Size below which the compression ratio of a file does not matter.
const SMALL: u64 = 1 << 20;

/// An unpacked archive.
pub(super) struct Unpacked {
    pub(super) files: Folder,
    pub(super) sha256: String,
}

/// Checks and unpacks `path`.
pub(super) fn unpack(path: &Path, limits: &ArchiveLimits) -> Result<Unpacked, Error> {
    let cannot_read = |error| Error::Read { path: path.to_owned(), error };
    let damaged = |reason: String| Error::Archive { path: path.to_owned(), reason };
    let sha256 = sha256(path).map_err(cannot_read)?;
    let file = File::open(path).map_err(cannot_read)?;
    let mut archive = ZipArchive::new(BufReader::new(file)).map_err(|e| damaged(format!("not a zip archive ({e})")))?;
    let entries = check(path, &mut archive, limits)?;
    let files = Folder::new("fmu-").map_err(cannot_read)?;
    let mut left = limits.total_bytes;
    for entry in &entries {
        let target = files.path().join(&entry.relative);
        if entry.folder {
            std::fs::create_dir_all(&target).map_err(cannot_read)?;
            continue;
        }
        if let Some(parent) = target.parent() {
            std::fs::create_dir_all(parent).map_err(cannot_read)?;
        }
        let packed = archive.by_index(entry.index).map_err(|e| damaged(format!("{}: {e}", entry.name)))?;
        let mut out = File::create(&target).map_err(cannot_read)?;
        // One byte more than allowed tells a file that is larger than its header says.
        let written =
            io::copy(&mut packed.take(left + 1), &mut out).map_err(|e| damaged(format!("{}: {e}", entry.name)))?;
        if written > left {
            return Err(Error::Refused { path: path.to_owned(), reason: too_large(limits) });
        }
        left -= written;
        out.flush().map_err(cannot_read)?;
    }
    Ok(Unpacked { files, sha256 })
}

struct Entry {
    index: usize,
    name: String,
    relative: PathBuf,
    folder: bool,
}

fn too_large(limits: &ArchiveLimits) -> String {
    format!("it unpacks to more than {} MiB", limits.total_bytes >> 20)
}

fn check(path: &Path, archive: &mut ZipArchive<BufReader<File>>, limits: &ArchiveLimits) -> Result<Vec<Entry>, Error> {
    let refused = |reason: String| Error::Refused { path: path.to_owned(), reason };
    let damaged = |reason: String| Error::Archive { path: path.to_owned(), reason };
    if archive.len() > limits.entries {
        return Err(refused(format!("it has {} entries, the limit is {}", archive.len(), limits.entries)));
    }
    let mut entries = Vec::with_capacity(archive.len());
    let mut seen: BTreeMap<String, String> = BTreeMap::new();
    let mut total = 0_u64;
    for index in 0..archive.len() {
        let file = archive.by_index(index).map_err(|e| damaged(e.to_string()))?;
        let name = file.name().map_err(|e| damaged(e.to_string()))?.into_owned();
        let shown: String = name.chars().map(|c| if c.is_control() { '?' } else { c }).collect();
        if file.is_symlink() {
            return Err(refused(format!("{shown} is a link, which could point outside the FMU's folder")));
        }
        let relative = safe_path(&name)
            .ok_or_else(|| refused(format!("the path {shown} would write outside the FMU's folder")))?;
        let key = name.trim_end_matches('/').to_lowercase();
        if let Some(other) = seen.insert(key, name.clone()) {
            let other: String = other.chars().map(|c| if c.is_control() { '?' } else { c }).collect();
            return Err(refused(format!("it contains {shown} twice (also as {other})")));
        }
        total = total.saturating_add(file.size());
        if total > limits.total_bytes {
            return Err(refused(too_large(limits)));
        }
        if file.size() > SMALL && file.size() / file.compressed_size().max(1) > limits.ratio {
            return Err(refused(format!("{shown} unpacks to more than {} times its size", limits.ratio)));
        }
        entries.push(Entry { index, folder: file.is_dir(), name, relative });
    }
    if !seen.contains_key("modeldescription.xml") {
        let nested = entries.iter().find(|e| e.name.to_lowercase().ends_with("/modeldescription.xml"));
        let hint = nested.map_or_else(
            || ": this is a zip file, but not an FMU".to_owned(),
            |e| format!(", only {}: zip the folder's contents, not the folder", e.name),
        );
        return Err(Error::NoDescription { path: path.to_owned(), hint });
    }
    Ok(entries)
}

/// The path below the FMU's folder, if it stays there: no `..`, no root, no drive, no backslash.
fn safe_path(name: &str) -> Option<PathBuf> {
    if name.is_empty() || name.starts_with('/') || name.contains(['\\', '\0', ':']) {
        return None;
    }
    let mut path = PathBuf::new();
    for part in name.split('/').filter(|p| !p.is_empty()) {
        if part == "." || part == ".." {
            return None;
        }
        path.push(part);
    }
    Some(path)
}

fn sha256(path: &Path) -> io::Result<String> {
    let mut file = File::open(path)?;
    let mut hash = Sha256::new();
    let mut buffer = vec![0; 1 << 16];
    loop {
        let read = file.read(&mut buffer)?;
        if read == 0 {
            break;
        }
        hash.update(&buffer[..read]);
    }
    Ok(hash.finalize().iter().map(|b| format!("{b:02x}")).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_that_leave_the_folder_are_refused() {
        for bad in ["../x", "a/../../x", "/etc/x", "C:/x", "a\\..\\x", "./x", ""] {
            assert_eq!(safe_path(bad), None, "{bad}");
        }
        assert_eq!(safe_path("a/b.txt"), Some(PathBuf::from("a/b.txt")));
    }
}
