//! Opening the archive of an FMU safely: everything is checked before a byte is written, and what is written is
//! counted, whatever the archive's headers say.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{self, BufReader, Read, Write};
use std::path::{Path, PathBuf};

use sha2::{Digest as _, Sha256};
use zip::{CompressionMethod, ZipArchive};

use super::error::Error;
use super::temporary::Folder;
use super::text::printable;

/// Limits against archives that unpack to more than anybody wants.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ArchiveLimits {
    /// Bytes of all files together.
    pub total_bytes: u64,
    /// Unpacked over packed size of one file, once it is larger than a megabyte.
    pub ratio: u64,
    /// Number of entries.
    pub entries: usize,
    /// Bytes of modelDescription.xml.
    pub description_bytes: u64,
}

impl Default for ArchiveLimits {
    /// 2 GiB, 1000 : 1, 100 000 entries, 256 MiB of modelDescription.xml.
    fn default() -> Self {
        Self { total_bytes: 2 << 30, ratio: 1000, entries: 100_000, description_bytes: 256 << 20 }
    }
}

/// Size below which the compression ratio of a file does not matter.
const SMALL: u64 = 1 << 20;

/// Longest name of a file or folder, and longest path, in bytes: what Linux takes, with room for the folder above.
const LONGEST_NAME: usize = 255;
const LONGEST_PATH: usize = 3000;

/// An unpacked archive that is no FMU, for instance one that holds FMUs. Its files are removed with it.
pub struct Archive {
    files: Folder,
    sha256: String,
}

impl Archive {
    /// Checks and unpacks `path` as FMUs are, within the default [`ArchiveLimits`].
    ///
    /// # Errors
    /// When it cannot be read, is damaged, or could do harm.
    pub fn open(path: &Path) -> Result<Self, Error> {
        let Unpacked { files, sha256 } = unpack_any(path, &ArchiveLimits::default(), false)?;
        Ok(Self { files, sha256 })
    }

    /// Where its files are.
    #[must_use]
    pub fn folder(&self) -> &Path {
        self.files.path()
    }

    /// SHA-256 of the archive, lower-case hex.
    #[must_use]
    pub fn sha256(&self) -> &str {
        &self.sha256
    }
}

/// An unpacked archive.
pub(super) struct Unpacked {
    pub(super) files: Folder,
    pub(super) sha256: String,
}

/// Checks and unpacks `path`.
pub(super) fn unpack(path: &Path, limits: &ArchiveLimits) -> Result<Unpacked, Error> {
    unpack_any(path, limits, true)
}

fn unpack_any(path: &Path, limits: &ArchiveLimits, is_fmu: bool) -> Result<Unpacked, Error> {
    let cannot_read = |error| Error::Read { path: path.to_owned(), error };
    let damaged = |reason: String| Error::Archive { path: path.to_owned(), reason };
    let kind = std::fs::metadata(path).map_err(cannot_read)?;
    if kind.is_dir() {
        return Err(damaged("it is a folder, an FMU is a file: zip the folder's contents".to_owned()));
    }
    if !kind.is_file() {
        return Err(damaged("it is not a file".to_owned()));
    }
    let sha256 = sha256(path).map_err(cannot_read)?;
    let file = File::open(path).map_err(cannot_read)?;
    let mut archive = ZipArchive::new(BufReader::new(file)).map_err(|e| damaged(format!("not a zip archive ({e})")))?;
    let entries = check(path, &mut archive, limits, is_fmu)?;
    let files = Folder::new("fmu-");
    let folder = tempfile::env::temp_dir();
    let cannot_unpack = |error| Error::Unpack { path: path.to_owned(), folder: folder.clone(), error };
    let files = files.map_err(cannot_unpack)?;
    for entry in &entries {
        let target = files.path().join(&entry.relative);
        if entry.folder {
            std::fs::create_dir_all(&target).map_err(cannot_unpack)?;
            continue;
        }
        if let Some(parent) = target.parent() {
            std::fs::create_dir_all(parent).map_err(cannot_unpack)?;
        }
        let broken = |e: &dyn std::fmt::Display| damaged(format!("{}: {e}", printable(&entry.name)));
        let packed = archive.by_index(entry.index).map_err(|e| broken(&e))?;
        let out = File::create(&target).map_err(cannot_unpack)?;
        // One byte more than announced tells a file that is larger than its header says.
        let mut packed = packed.take(entry.size.saturating_add(1));
        let mut out = Destination { file: out, failed: false };
        let written = match io::copy(&mut packed, &mut out) {
            Ok(written) => written,
            Err(error) if out.failed => return Err(cannot_unpack(error)),
            Err(error) => return Err(broken(&error)),
        };
        if written != entry.size {
            return Err(broken(&"its size is not the one that the archive says"));
        }
    }
    Ok(Unpacked { files, sha256 })
}

/// A file that is written, and whether it was writing that failed, not reading.
struct Destination {
    file: File,
    failed: bool,
}

impl Write for Destination {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes).inspect_err(|e| self.failed |= e.kind() != io::ErrorKind::Interrupted)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

struct Entry {
    index: usize,
    size: u64,
    name: String,
    relative: PathBuf,
    folder: bool,
}

fn too_large(limits: &ArchiveLimits) -> String {
    format!("it unpacks to more than {} MiB", limits.total_bytes >> 20)
}

fn check(
    path: &Path,
    archive: &mut ZipArchive<BufReader<File>>,
    limits: &ArchiveLimits,
    is_fmu: bool,
) -> Result<Vec<Entry>, Error> {
    let refused = |reason: String| Error::Refused { path: path.to_owned(), reason };
    let damaged = |reason: String| Error::Archive { path: path.to_owned(), reason };
    if archive.len() > limits.entries {
        return Err(refused(format!("it has {} entries, the limit is {}", archive.len(), limits.entries)));
    }
    // The library keeps one of them; which one another program reads is anybody's guess.
    if archive.has_duplicate_names() {
        return Err(refused("two of its entries have the same name".to_owned()));
    }
    if archive.has_overlapping_files().map_err(|e| damaged(e.to_string()))? {
        return Err(refused("some of its entries share the same bytes, as in archives made to fill a disk".to_owned()));
    }
    let mut entries = Vec::with_capacity(archive.len());
    let mut seen: BTreeMap<String, String> = BTreeMap::new();
    let mut total = 0_u64;
    for index in 0..archive.len() {
        let file = archive.by_index_raw(index).map_err(|e| damaged(e.to_string()))?;
        let name = file.name().map_err(|e| damaged(e.to_string()))?.into_owned();
        let shown = printable(&name);
        if file.is_symlink() {
            return Err(refused(format!("{shown} is a link, which could point outside the FMU's folder")));
        }
        let relative = safe_path(&name)
            .ok_or_else(|| refused(format!("the path {shown} would write outside the FMU's folder")))?;
        if name.len() > LONGEST_PATH || name.split('/').any(|part| part.len() > LONGEST_NAME) {
            return Err(refused(format!("the path {shown} is longer than file systems take")));
        }
        if file.encrypted() {
            return Err(refused(format!("{shown} is encrypted. Zip the FMU without a password")));
        }
        if !matches!(file.compression(), CompressionMethod::Stored | CompressionMethod::Deflated) {
            let how = file.compression();
            return Err(refused(format!("{shown} is compressed with {how}, FMUs may use Deflate only. Zip it again")));
        }
        // The folder itself, which some packers list.
        if relative.as_os_str().is_empty() {
            continue;
        }
        let key = relative.to_string_lossy().to_lowercase();
        if let Some(other) = seen.insert(key, name.clone()) {
            return Err(refused(format!("it contains {shown} twice (also as {})", printable(&other))));
        }
        total = total.saturating_add(file.size());
        if total > limits.total_bytes {
            return Err(refused(too_large(limits)));
        }
        if file.size() > SMALL && file.size() / file.compressed_size().max(1) > limits.ratio {
            return Err(refused(format!("{shown} unpacks to more than {} times its size", limits.ratio)));
        }
        if is_description(&relative) && file.size() > limits.description_bytes {
            let limit = limits.description_bytes >> 20;
            return Err(refused(format!("{shown} is larger than {limit} MiB")));
        }
        entries.push(Entry { index, size: file.size(), folder: file.is_dir(), name, relative });
    }
    both_file_and_folder(&entries).map_or(Ok(()), |name| {
        Err(refused(format!("it contains {} both as a file and as a folder", printable(name))))
    })?;
    if is_fmu && !entries.iter().any(|e| e.relative == Path::new("modelDescription.xml")) {
        let like = |e: &&Entry| e.name.to_lowercase().ends_with("modeldescription.xml");
        let hint = match entries.iter().find(like).map(|e| printable(&e.name)) {
            Some(name) if name.contains('/') => format!(", only {name}: zip the folder's contents, not the folder"),
            Some(name) => format!(", only {name}: its name must be modelDescription.xml, in these letters"),
            None => ": this is a zip file, but not an FMU".to_owned(),
        };
        return Err(Error::NoDescription { path: path.to_owned(), hint });
    }
    Ok(entries)
}

/// The name of a file that other entries want to be a folder.
fn both_file_and_folder(entries: &[Entry]) -> Option<&str> {
    // Sorted by their parts, what lies in a folder follows it directly.
    let mut sorted: Vec<&Entry> = entries.iter().collect();
    sorted.sort_by(|a, b| a.relative.cmp(&b.relative));
    let clash = sorted.windows(2).find(|pair| !pair[0].folder && pair[1].relative.starts_with(&pair[0].relative));
    clash.map(|pair| pair[0].name.as_str())
}

/// Whether this is the model description, in whatever letters.
fn is_description(relative: &Path) -> bool {
    relative.to_str().is_some_and(|name| name.eq_ignore_ascii_case("modelDescription.xml"))
}

/// The path below the FMU's folder, if it stays there: no `..`, no root, no drive, no backslash. A `.` is where one is.
fn safe_path(name: &str) -> Option<PathBuf> {
    if name.is_empty() || name.starts_with('/') || name.contains(['\\', '\0', ':']) {
        return None;
    }
    let mut path = PathBuf::new();
    for part in name.split('/').filter(|p| !p.is_empty()) {
        match part {
            ".." => return None,
            "." => {}
            part => path.push(part),
        }
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
    use zip::ZipWriter;
    use zip::write::SimpleFileOptions;

    use super::*;

    /// Three files of 400 bytes each.
    #[test]
    fn the_limit_of_what_is_unpacked_is_for_all_files_together() {
        let mut archive = ZipWriter::new(io::Cursor::new(Vec::<u8>::new()));
        for name in ["modelDescription.xml", "resources/a", "resources/b"] {
            archive.start_file(name, SimpleFileOptions::default()).unwrap();
            archive.write_all(&[b'x'; 400]).unwrap();
        }
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("x.fmu");
        std::fs::write(&path, archive.finish().unwrap().into_inner()).unwrap();
        let fails = |total_bytes| unpack(&path, &ArchiveLimits { total_bytes, ..ArchiveLimits::default() }).err();
        assert!(fails(1200).is_none());
        let refused =
            |error: Error| matches!(error, Error::Refused { reason, .. } if reason.contains("unpacks to more"));
        assert!(fails(1199).is_some_and(refused));
    }

    #[test]
    fn paths_that_leave_the_folder_are_refused() {
        for bad in ["../x", "a/../../x", "/etc/x", "C:/x", "a\\..\\x", "./../x", ""] {
            assert_eq!(safe_path(bad), None, "{bad}");
        }
        for good in ["a/b.txt", "./a/b.txt", "a/./b.txt"] {
            assert_eq!(safe_path(good), Some(PathBuf::from("a/b.txt")), "{good}");
        }
    }
}
