//! Where the packages are that robot descriptions name (`package://NAME/meshes/x.stl`): named ones first, then upwards from
//! the description, beside the cell file, and where ROS looks.
//!
//! A folder is the package `NAME` if it is called that, or if its `package.xml` has that `<name>`. Nothing is taken from
//! where a file is not there: the next place is looked at.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};

use crate::cell::file::files::relative;

/// What surrounds the search of packages besides the files themselves.
#[derive(Debug, Default)]
pub(in crate::cell) struct Packages {
    /// Folders that somebody named, by the package; relative to the cell file or absolute.
    named: BTreeMap<String, PathBuf>,
    /// Folders below which packages are: those of `ROS_PACKAGE_PATH`.
    roots: Vec<PathBuf>,
    /// Prefixes of installations, with packages in `share`: those of `AMENT_PREFIX_PATH`.
    prefixes: Vec<PathBuf>,
    /// Packages that were found where nobody finds them who has not the same environment or options.
    elsewhere: RefCell<BTreeMap<String, PathBuf>>,
}

/// A file of a package that is in none of the places.
#[derive(Debug, PartialEq, Eq)]
pub(in crate::cell) struct NotFound {
    /// Every place that was looked at, in words.
    pub looked: String,
}

/// How deep packages may be below a folder of `ROS_PACKAGE_PATH`.
const DEEPEST: usize = 5;

/// Most folders that are looked at below one of them.
const MOST_FOLDERS: usize = 20_000;

/// How far up from the description neighbours are searched by what their `package.xml` says.
const NEIGHBOURS: usize = 3;

impl Packages {
    /// With folders that somebody named, and where ROS looks on this machine.
    pub(in crate::cell) fn new(named: BTreeMap<String, PathBuf>) -> Self {
        let paths = |name: &str| {
            let value = std::env::var_os(name).unwrap_or_default();
            std::env::split_paths(&value).filter(|path| !path.as_os_str().is_empty()).collect()
        };
        Self { named, roots: paths("ROS_PACKAGE_PATH"), prefixes: paths("AMENT_PREFIX_PATH"), ..Self::default() }
    }

    /// The file `rest` of package `name` for the description `urdf`: relative to the cell file's `folder` if `urdf` is.
    pub(in crate::cell) fn find(
        &self,
        name: &str,
        rest: &str,
        folder: &Path,
        urdf: &Path,
    ) -> Result<PathBuf, NotFound> {
        let there = |package: &Path| folder.join(package).join(rest).is_file();
        let remember = |package: &Path| {
            self.elsewhere.borrow_mut().insert(name.to_owned(), package.to_owned());
            package.join(rest)
        };
        if let Some(package) = self.named.get(name) {
            // Whoever names it means that one.
            let looked = folder.join(package).join(rest).display().to_string();
            return if there(package) { Ok(remember(package)) } else { Err(NotFound { looked }) };
        }
        let description = std::path::absolute(folder.join(urdf)).unwrap_or_else(|_| folder.join(urdf));
        let description = path_clean::clean(&description);
        for (height, above) in description.ancestors().skip(1).enumerate() {
            let found = candidates(above, name, height < NEIGHBOURS).into_iter().find(|package| there(package));
            if let Some(package) = found {
                let beside = relative(&package, folder).filter(|short| urdf.is_relative() && there(short));
                return Ok(beside.unwrap_or(package).join(rest));
            }
        }
        if there(Path::new(name)) {
            return Ok(Path::new(name).join(rest));
        }
        for root in &self.roots {
            let mut left = MOST_FOLDERS;
            let below = |package: &Path| there(package);
            if let Some(package) = crawl(root, name, DEEPEST, &mut left, &below) {
                return Ok(remember(&package));
            }
        }
        let share = self.prefixes.iter().map(|prefix| prefix.join("share").join(name)).find(|package| there(package));
        share
            .map(|package| remember(&package))
            .ok_or_else(|| NotFound { looked: self.looked(name, folder, &description) })
    }

    /// Packages that a cell file has to name, so that they are found without the options and the environment of now.
    pub(in crate::cell) fn elsewhere(&self) -> Vec<(String, PathBuf)> {
        self.elsewhere.borrow().clone().into_iter().collect()
    }

    /// Every place, in words.
    fn looked(&self, name: &str, folder: &Path, description: &Path) -> String {
        let shown = |paths: &mut dyn Iterator<Item = &Path>| {
            paths.map(|path| path.display().to_string()).collect::<Vec<_>>().join(", ")
        };
        let path = |variable: &str, paths: &[PathBuf]| match paths {
            [] => format!("{variable} is not set"),
            all => format!("{variable}: {}", shown(&mut all.iter().map(PathBuf::as_path))),
        };
        format!(
            "folders called {name}, share/{name} and folders whose package.xml says {name}, in {}; {}; {}; {}",
            shown(&mut description.ancestors().skip(1)),
            std::path::absolute(folder.join(name)).unwrap_or_else(|_| folder.join(name)).display(),
            path("ROS_PACKAGE_PATH", &self.roots),
            path("AMENT_PREFIX_PATH", &self.prefixes),
        )
    }
}

/// Folders in and at `above` that may be the package, the likeliest first.
fn candidates(above: &Path, name: &str, neighbours: bool) -> Vec<PathBuf> {
    let mut all = Vec::new();
    if is_package(above, name) {
        all.push(above.to_owned());
    }
    all.extend([above.join(name), above.join("share").join(name)]);
    if neighbours && above.parent().is_some() {
        all.extend(folders(above).into_iter().filter(|folder| says(folder, name)));
    }
    all
}

/// The package below `root`, at most `depth` folders down, that has the file; as ROS does, not inside other packages.
fn crawl(root: &Path, name: &str, depth: usize, left: &mut usize, has: &dyn Fn(&Path) -> bool) -> Option<PathBuf> {
    if *left == 0 {
        return None;
    }
    *left -= 1;
    if is_package(root, name) && has(root) {
        return Some(root.to_owned());
    }
    let ends = depth == 0
        || ["package.xml", "CATKIN_IGNORE", "COLCON_IGNORE", "AMENT_IGNORE"]
            .iter()
            .any(|file| root.join(file).is_file());
    if ends {
        return None;
    }
    folders(root).into_iter().find_map(|folder| crawl(&folder, name, depth - 1, left, has))
}

/// Folders in `folder`, by name; hidden ones are left out, and links, which may lead back.
fn folders(folder: &Path) -> Vec<PathBuf> {
    let Ok(entries) = fs::read_dir(folder) else { return Vec::new() };
    let entries = entries.flatten().filter(|entry| !entry.file_name().to_string_lossy().starts_with('.'));
    let mut all: Vec<PathBuf> =
        entries.filter(|entry| entry.file_type().is_ok_and(|kind| kind.is_dir())).map(|entry| entry.path()).collect();
    all.sort();
    all
}

fn is_package(folder: &Path, name: &str) -> bool {
    folder.file_name() == Some(OsStr::new(name)) || says(folder, name)
}

/// Whether the `package.xml` in a folder has this name.
fn says(folder: &Path, name: &str) -> bool {
    let Ok(text) = fs::read_to_string(folder.join("package.xml")) else { return false };
    let Ok(document) = roxmltree::Document::parse(&text) else { return false };
    let names = document.root_element().children().filter(|node| node.has_tag_name("name"));
    names.filter_map(|node| node.text()).any(|text| text.trim() == name)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A folder with these files, of which those called package.xml say that they are `arm`.
    fn tree(files: &[&str]) -> tempfile::TempDir {
        let dir = tempfile::tempdir().unwrap();
        for file in files {
            let path = dir.path().join(file);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, "<package format=\"2\"><name> arm </name><version>1</version></package>").unwrap();
        }
        dir
    }

    #[test]
    fn packages_are_found_in_the_usual_layouts() {
        for (urdf, mesh) in [
            ("arm/urdf/x.urdf", "arm/meshes/a.stl"),
            ("arm/robots/x.urdf", "arm/meshes/a.stl"),
            ("arm/urdf/deep/er/x.urdf", "arm/meshes/a.stl"),
            ("x.urdf", "arm/meshes/a.stl"),
            ("robots/x.urdf", "arm/meshes/a.stl"),
            ("other/urdf/x.urdf", "arm/meshes/a.stl"),
            ("urdf/x.urdf", "share/arm/meshes/a.stl"),
            ("share/other/urdf/x.urdf", "share/arm/meshes/a.stl"),
        ] {
            let dir = tree(&[mesh]);
            let found = Packages::default().find("arm", "meshes/a.stl", dir.path(), Path::new(urdf));
            assert_eq!(found, Ok(PathBuf::from(mesh)), "{urdf}");
            // The cell file may be elsewhere.
            let cell = dir.path().join("cells/one");
            let urdf = Path::new("../..").join(urdf);
            fs::create_dir_all(&cell).unwrap();
            let found = Packages::default().find("arm", "meshes/a.stl", &cell, &urdf);
            assert_eq!(found, Ok(Path::new("../..").join(mesh)), "{}", urdf.display());
        }
    }

    #[test]
    fn the_folder_of_a_package_may_have_another_name() {
        for (urdf, package) in [("arm-1.2/urdf/x.urdf", "arm-1.2"), ("x.urdf", "a"), ("other/urdf/x.urdf", "z")] {
            let (xml, mesh) = (format!("{package}/package.xml"), format!("{package}/meshes/a.stl"));
            let dir = tree(&[&xml, &mesh]);
            let found = Packages::default().find("arm", "meshes/a.stl", dir.path(), Path::new(urdf));
            assert_eq!(found, Ok(PathBuf::from(mesh)), "{urdf}");
        }
    }

    #[test]
    fn a_named_package_is_that_one_and_what_ros_names_comes_last() {
        let dir = tree(&[
            "arm/meshes/a.stl",
            "mine/meshes/a.stl",
            "ws/src/deep/arm_x/package.xml",
            "ws/src/deep/arm_x/b.stl",
            "opt/share/arm/c.stl",
        ]);
        let named = Packages { named: BTreeMap::from([("arm".to_owned(), "mine".into())]), ..Packages::default() };
        let find = |packages: &Packages, rest: &str| packages.find("arm", rest, dir.path(), Path::new("x.urdf"));
        assert_eq!(find(&named, "meshes/a.stl"), Ok("mine/meshes/a.stl".into()));
        assert_eq!(named.elsewhere(), [("arm".to_owned(), PathBuf::from("mine"))]);
        let told = find(&named, "meshes/b.stl").unwrap_err();
        assert!(told.looked.ends_with("mine/meshes/b.stl"), "{}", told.looked);
        let ros = Packages {
            roots: vec![dir.path().join("ws")],
            prefixes: vec![dir.path().join("opt")],
            ..Packages::default()
        };
        assert_eq!(find(&ros, "meshes/a.stl"), Ok("arm/meshes/a.stl".into()));
        assert!(ros.elsewhere().is_empty());
        assert_eq!(find(&ros, "b.stl"), Ok(dir.path().join("ws/src/deep/arm_x/b.stl")));
        assert_eq!(find(&ros, "c.stl"), Ok(dir.path().join("opt/share/arm/c.stl")));
        let told = find(&ros, "d.stl").unwrap_err().looked;
        for place in [
            dir.path().display().to_string(),
            "share/arm".to_owned(),
            "ROS_PACKAGE_PATH: ".to_owned(),
            "opt".to_owned(),
        ] {
            assert!(told.contains(&place), "{place}: {told}");
        }
    }
}
