//! The rule that CONTRIBUTING.md names what is there: each crate of the workspace, and each folder directly below a crate's `src/`.

/// A crate.
pub struct Package {
    /// Its name.
    pub name: String,
    /// Its folder from the root of the workspace; nothing for the root itself.
    pub folder: String,
    /// The folders directly below its `src/`.
    pub folders: Vec<String>,
}

/// What a text does not name between backquotes: a crate, its folder, and what is in it, which is in the line that names the crate; what is
/// in the crate of the root has a line of its own, as a row of a table.
#[must_use]
pub fn unnamed(text: &str, packages: &[Package]) -> Vec<String> {
    let mut unnamed = Vec::new();
    for Package { name, folder, folders } in packages {
        let here = |what: &str| text.lines().any(|line| names(line, name) && names(line, what));
        let missing = [name, folder].into_iter().filter(|what| !what.is_empty() && !names(text, what));
        unnamed.extend(missing.map(|what| format!("`{what}`")));
        for below in folders {
            if folder.is_empty() && !text.lines().any(|line| line.starts_with(&format!("| `{below}/` |"))) {
                unnamed.push(format!("`{below}/`, of `{name}`, in a row of its own"));
            } else if !folder.is_empty() && !here(below) {
                unnamed.push(format!("`{below}`, in the line of `{name}`"));
            }
        }
    }
    unnamed
}

/// Whether a text has this between backquotes, as it is or as a folder.
fn names(text: &str, what: &str) -> bool {
    text.contains(&format!("`{what}`")) || text.contains(&format!("`{what}/`"))
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::path::Path;

    use super::*;
    use crate::sources::root;

    fn manifest(folder: &Path) -> toml::Table {
        fs::read_to_string(folder.join("Cargo.toml")).unwrap().parse().unwrap()
    }

    fn package(folder: &str) -> Package {
        let path = root().join(folder);
        let name = manifest(&path)["package"]["name"].as_str().unwrap().to_owned();
        let entries = fs::read_dir(path.join("src")).unwrap().map(Result::unwrap);
        let below = entries.filter(|entry| entry.path().is_dir());
        let mut folders: Vec<String> = below.map(|entry| entry.file_name().into_string().unwrap()).collect();
        folders.sort();
        Package { name, folder: folder.to_owned(), folders }
    }

    #[test]
    fn the_book_of_the_house_names_every_crate_and_its_folders() {
        let members = manifest(&root())["workspace"]["members"].as_array().unwrap().clone();
        let members = members.iter().map(|member| member.as_str().unwrap());
        let packages: Vec<Package> = [""].into_iter().chain(members).map(package).collect();
        assert!(packages.len() > 8 && packages[0].folders.len() > 3, "{} crates", packages.len());
        let unnamed = unnamed(&fs::read_to_string(root().join("CONTRIBUTING.md")).unwrap(), &packages);
        assert!(unnamed.is_empty(), "CONTRIBUTING.md does not name:\n{}", unnamed.join("\n"));
    }

    #[test]
    fn what_is_not_named_or_only_elsewhere_is_told() {
        let package = |name: &str, folder: &str, folders: &[&str]| Package {
            name: name.to_owned(),
            folder: folder.to_owned(),
            folders: folders.iter().map(|&below| below.to_owned()).collect(),
        };
        let packages = [package("top", "", &["cli"]), package("low", "crates/low", &["deep"])];
        let whole = "| `top` | `src/` |\n| `low` | `crates/low/` | `deep`: what is deep |\n| `cli/` | commands |\n";
        assert!(unnamed(whole, &packages).is_empty());
        for (left_out, told) in [
            ("`top`", "`top`"),
            ("`low`", "`low`"),
            ("`crates/low/`", "`crates/low`"),
            ("`deep`", "`deep`"),
            ("| `cli/`", "`cli/`"),
        ] {
            let unnamed = unnamed(&format!("{}\n`deep` and cli, low", whole.replace(left_out, "")), &packages);
            assert!(unnamed.iter().any(|what| what.starts_with(told)), "{left_out}: {unnamed:?}");
        }
    }
}
