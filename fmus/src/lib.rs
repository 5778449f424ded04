//! The example cells that come with fmi-hazard: their FMUs and cell files, embedded, and how to write them out.
//!
//! Knows nothing of what is in the files: the build script compiles the models (`models/`, `hostile/`) and packs them with the cells
//! (`scenarios/`).

use std::io;
use std::path::{Path, PathBuf};

/// One example cell.
#[derive(Debug, Clone, Copy)]
pub struct Example {
    /// Name of the cell, e.g. `safety-fence`; also the name of its folder and of its FMU.
    pub name: &'static str,
    /// One sentence on what the cell is.
    pub summary: &'static str,
    /// Its FMUs, complete archives: name and content. The first is the whole cell in FMI 2.0.
    pub fmus: &'static [(&'static str, &'static [u8])],
    /// The cell files (`cell.toml`, `fixed.toml`, `README.md`, the picture in it): name and content.
    pub files: &'static [(&'static str, &'static [u8])],
}

include!(concat!(env!("OUT_DIR"), "/examples.rs"));

/// Descriptions of public robots: name and content. Their sources and licences are in them.
pub const ROBOTS: [(&str, &[u8]); 2] = [
    ("ur10e.urdf", include_bytes!("../scenarios/robots/ur10e.urdf")),
    ("lbr_iiwa14_r820.urdf", include_bytes!("../scenarios/robots/lbr_iiwa14_r820.urdf")),
];

/// Folder with all FMUs that were built, those for tests among them. It is there on the machine that built them only.
pub const TEST_FMUS: &str = env!("TEST_FMUS");

/// All example cells, in a fixed order.
pub fn all() -> &'static [Example] {
    EXAMPLES
}

/// The example of this name.
pub fn by_name(name: &str) -> Option<&'static Example> {
    EXAMPLES.iter().find(|example| example.name == name)
}

impl Example {
    /// Writes `<dir>/<name>/<name>.fmu`, further FMUs and the cell files beside it, and returns the paths written. Folders are made
    /// as needed, files that exist are replaced.
    ///
    /// # Errors
    /// Whatever the file system says, with the path.
    pub fn export(&self, dir: &Path) -> io::Result<Vec<PathBuf>> {
        let folder = dir.join(self.name);
        std::fs::create_dir_all(&folder).map_err(|error| naming(&folder, &error))?;
        let mut written = Vec::with_capacity(self.files.len() + self.fmus.len());
        for (name, content) in self.fmus.iter().chain(self.files) {
            let path = folder.join(name);
            std::fs::write(&path, content).map_err(|error| naming(&path, &error))?;
            written.push(path);
        }
        Ok(written)
    }
}

/// Writes [`ROBOTS`] to `<dir>/robots` and returns the paths written.
///
/// # Errors
/// Whatever the file system says, with the path.
fn export_robots(dir: &Path) -> io::Result<Vec<PathBuf>> {
    let folder = dir.join("robots");
    std::fs::create_dir_all(&folder).map_err(|error| naming(&folder, &error))?;
    let write = |(name, content): &(&str, &[u8])| {
        let path = folder.join(name);
        std::fs::write(&path, content).map_err(|error| naming(&path, &error)).map(|()| path)
    };
    ROBOTS.iter().map(write).collect()
}

/// Writes all examples as [`Example::export`] does, and the robots.
///
/// # Errors
/// Whatever the file system says, with the path.
pub fn export(dir: &Path) -> io::Result<Vec<PathBuf>> {
    let mut written = Vec::new();
    for example in all() {
        written.extend(example.export(dir)?);
    }
    written.extend(export_robots(dir)?);
    Ok(written)
}

fn naming(path: &Path, error: &io::Error) -> io::Error {
    io::Error::new(error.kind(), format!("{} cannot be written: {error}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exported_files_are_complete_fmus() {
        let dir = tempfile::tempdir().unwrap();
        let written = export(dir.path()).unwrap();
        assert!(written.contains(&dir.path().join("safety-fence/safety-fence.fmu")));
        for path in written.iter().filter(|path| path.extension().is_some_and(|extension| extension == "fmu")) {
            let mut archive = zip::ZipArchive::new(std::fs::File::open(path).unwrap()).unwrap();
            assert!(archive.by_name("modelDescription.xml").is_ok());
        }
        for example in all() {
            let description = dir.path().join(example.name);
            assert_eq!(std::fs::read_dir(description).unwrap().count(), example.files.len() + example.fmus.len());
        }
    }

    #[test]
    fn a_folder_that_cannot_be_made_is_named() {
        let dir = tempfile::tempdir().unwrap();
        let file = dir.path().join("taken");
        std::fs::write(&file, "").unwrap();
        let error = export(&file).unwrap_err();
        assert!(error.to_string().contains("taken"), "{error}");
    }

    #[test]
    fn examples_are_found_by_name() {
        assert_eq!(by_name("safety-fence").map(|example| example.name), Some("safety-fence"));
        assert!(by_name("faulty").is_none(), "the faulty models are for tests only");
    }
}
