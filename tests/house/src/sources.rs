//! The sources of the workspace: read from its folders, not from what is committed, so that a new file is seen at once.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::{fs, io};

/// Where Rust of the workspace is.
const FOLDERS: [&str; 6] = ["benches", "crates", "fmus", "research", "src", "tests"];

/// A file of Rust.
pub struct Source {
    /// Its path from the root of the workspace, with `/`.
    pub path: String,
    /// What is in it, parsed.
    pub file: syn::File,
}

impl Source {
    /// Parses a text.
    ///
    /// # Errors
    /// When it is not Rust.
    pub fn new(path: &str, text: &str) -> io::Result<Self> {
        let file = syn::parse_file(text).map_err(|error| io::Error::other(format!("{path}: {error}")))?;
        Ok(Self { path: path.to_owned(), file })
    }
}

/// The folder of the workspace.
#[must_use]
pub fn root() -> PathBuf {
    let own = Path::new(env!("CARGO_MANIFEST_DIR"));
    own.ancestors().nth(2).map_or_else(|| own.to_owned(), Path::to_owned)
}

/// The files below a folder of the workspace whose names end so: paths from the root, and texts. Links are not followed; what is hidden
/// or built is left out.
///
/// # Errors
/// When something cannot be read.
pub fn texts(folder: &str, extension: &str) -> io::Result<BTreeMap<String, String>> {
    let root = root();
    let (mut texts, mut folders) = (BTreeMap::new(), vec![folder.to_owned()]);
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(root.join(&folder))? {
            let entry = entry?;
            let name = entry.file_name().to_string_lossy().into_owned();
            let path = format!("{folder}/{name}");
            let kind = entry.file_type()?;
            if kind.is_dir() && name != "target" && !name.starts_with('.') {
                folders.push(path);
            } else if kind.is_file() && Path::new(&name).extension().is_some_and(|found| found == extension) {
                texts.insert(path, fs::read_to_string(entry.path())?);
            }
        }
    }
    Ok(texts)
}

/// All Rust of the workspace: paths from the root, and texts.
///
/// # Errors
/// When something cannot be read.
pub fn rust() -> io::Result<BTreeMap<String, String>> {
    let mut all = BTreeMap::new();
    for folder in FOLDERS {
        all.append(&mut texts(folder, "rs")?);
    }
    Ok(all)
}

/// The same, parsed.
///
/// # Errors
/// When something cannot be read, or is not Rust.
pub fn workspace() -> io::Result<Vec<Source>> {
    rust()?.iter().map(|(path, text)| Source::new(path, text)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_folders_with_rust_are_read_and_a_file_is_told_that_is_none() {
        let texts = rust().unwrap();
        for path in ["src/lib.rs", "crates/stop/build.rs", "fmus/models/lib.rs", "tests/house/src/sources.rs"] {
            assert!(texts.contains_key(path), "{path}");
        }
        assert!(texts.len() > 500, "{}", texts.len());
        let error = Source::new("a.rs", "fn f( {}").err().unwrap();
        assert!(error.to_string().starts_with("a.rs: "), "{error}");
    }
}
