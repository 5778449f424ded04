//! The modules of a crate, by its `mod` items from the root on: in which file each is, what it defines, brings in and says. What is
//! compiled for tests only is left out, and files of tests.

use std::collections::{BTreeMap, BTreeSet};

use syn::{Attribute, Expr, Item, Lit, Meta};

use crate::paths::{Parts, attributes, is_for_tests, said, used};
use crate::sources::Source;

/// A module, in a file of its own or inside one.
#[derive(Default)]
pub struct Module {
    /// The module that its file is.
    pub home: Parts,
    /// Its file.
    pub file: String,
    /// Names that stand for a path, as seen from here.
    pub names: BTreeMap<String, Parts>,
    /// What is defined here.
    pub items: BTreeSet<String>,
    /// Where all names come from that are there.
    pub globs: Vec<Parts>,
    /// All paths that it says.
    pub said: Vec<Parts>,
}

/// All modules of a crate, by their paths; the root has none.
pub type Modules = BTreeMap<Parts, Module>;

/// The files that cargo begins a crate with, and the library of the models, which a build script compiles.
#[must_use]
pub fn is_root(path: &str) -> bool {
    let (folder, name) = path.rsplit_once('/').unwrap_or(("", path));
    let alone = ["tests", "benches"].contains(&folder.rsplit('/').next().unwrap_or_default());
    alone || ["lib.rs", "main.rs", "build.rs"].contains(&name)
}

/// Whether a file has tests only.
#[must_use]
pub fn is_of_tests(path: &str) -> bool {
    path.ends_with("_tests.rs") || path.ends_with("/tests.rs")
}

/// The modules of the crate that begins with this file.
#[must_use]
pub fn modules(sources: &[Source], root: &str) -> Modules {
    let mut builder = Builder { sources, modules: Modules::new() };
    builder.file(root, Vec::new(), true);
    builder.modules
}

struct Builder<'a> {
    sources: &'a [Source],
    modules: Modules,
}

/// Where the items of a module stand.
struct Place {
    /// The module.
    path: Parts,
    /// The module that its file is, and the file.
    home: Parts,
    file: String,
    /// Where the files of its own modules are.
    folder: String,
}

impl Builder<'_> {
    /// Reads a file; where it `leads` its folder, as `mod.rs` does, its own modules are beside it. One that is not among the sources is
    /// another's.
    fn file(&mut self, path: &str, module: Parts, leads: bool) {
        let sources = self.sources;
        let Some(source) = sources.iter().find(|source| source.path == path) else { return };
        let folder = if leads { folder_of(path) } else { path.trim_end_matches(".rs") };
        let place = Place { path: module.clone(), home: module, file: path.to_owned(), folder: folder.to_owned() };
        self.items(&place, &source.file.items);
    }

    fn items(&mut self, place: &Place, items: &[Item]) {
        let mut module = Module { home: place.home.clone(), file: place.file.clone(), ..Module::default() };
        for item in items.iter().filter(|item| !is_for_tests(attributes(item))) {
            match item {
                Item::Mod(item) => self.module(place, item),
                Item::Use(item) => {
                    for (path, name) in used(item) {
                        match name {
                            Some(name) if name == "_" => {}
                            Some(name) => drop(module.names.insert(name, path)),
                            None => module.globs.push(path),
                        }
                    }
                    module.said.extend(used(item).into_iter().map(|(path, _)| path));
                }
                item => {
                    module.items.extend(name(item));
                    module.said.extend(said(item));
                }
            }
        }
        self.modules.insert(place.path.clone(), module);
    }

    fn module(&mut self, place: &Place, item: &syn::ItemMod) {
        let name = item.ident.to_string();
        let path: Parts = place.path.iter().cloned().chain([name.clone()]).collect();
        if let Some((_, items)) = &item.content {
            let folder = format!("{}/{name}", place.folder);
            self.items(&Place { path, home: place.home.clone(), file: place.file.clone(), folder }, items);
        } else if let Some(given) = given_path(&item.attrs) {
            self.file(&joined(folder_of(&place.file), &given), path, true);
        } else {
            for (file, leads) in [(format!("{name}.rs"), false), (format!("{name}/mod.rs"), true)] {
                let file = joined(&place.folder, &file);
                if !is_of_tests(&file) {
                    self.file(&file, path.clone(), leads);
                }
            }
        }
    }
}

fn folder_of(path: &str) -> &str {
    path.rsplit_once('/').map_or("", |(folder, _)| folder)
}

/// A path from a folder on, without `..`.
fn joined(folder: &str, path: &str) -> String {
    let mut parts: Vec<&str> = folder.split('/').filter(|part| !part.is_empty()).collect();
    for part in path.split('/') {
        if part == ".." {
            parts.pop();
        } else {
            parts.push(part);
        }
    }
    parts.join("/")
}

/// What `#[path = "..."]` says.
fn given_path(attributes: &[Attribute]) -> Option<String> {
    attributes.iter().find_map(|attribute| match &attribute.meta {
        Meta::NameValue(given) if given.path.is_ident("path") => match &given.value {
            Expr::Lit(syn::ExprLit { lit: Lit::Str(path), .. }) => Some(path.value()),
            _ => None,
        },
        _ => None,
    })
}

/// The name that an item defines.
fn name(item: &Item) -> Option<String> {
    let ident = match item {
        Item::Const(item) => &item.ident,
        Item::Enum(item) => &item.ident,
        Item::Fn(item) => &item.sig.ident,
        Item::Macro(item) => item.ident.as_ref()?,
        Item::Static(item) => &item.ident,
        Item::Struct(item) => &item.ident,
        Item::Trait(item) => &item.ident,
        Item::Type(item) => &item.ident,
        Item::Union(item) => &item.ident,
        _ => return None,
    };
    Some(ident.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sources::{rust, workspace};

    #[test]
    fn every_file_of_the_workspace_is_a_module_of_a_crate_or_has_tests() {
        let sources = workspace().unwrap();
        let roots = sources.iter().map(|source| source.path.as_str()).filter(|path| is_root(path));
        let all: Vec<Modules> = roots.map(|root| modules(&sources, root)).collect();
        let known: BTreeSet<&str> = all.iter().flat_map(|of| of.values().map(|module| module.file.as_str())).collect();
        let others = sources.iter().map(|source| source.path.as_str()).filter(|path| !known.contains(path));
        let texts = rust().unwrap();
        let declared = |path: &str| {
            let module = format!(" mod {};", path.trim_end_matches(".rs").rsplit('/').next().unwrap());
            texts.values().any(|text| {
                text.split("#[cfg(test)]\n")
                    .skip(1)
                    .filter_map(|behind| behind.lines().next())
                    .any(|line| format!(" {line}").ends_with(&module))
            })
        };
        let unknown: Vec<&str> = others.filter(|path| !is_of_tests(path) && !declared(path)).collect();
        assert!(all.len() > 20 && unknown.is_empty(), "{} crates, and in none:\n{}", all.len(), unknown.join("\n"));
    }

    #[test]
    fn modules_are_in_the_files_that_the_compiler_looks_at() {
        let text = [
            (
                "c/src/lib.rs",
                "mod a;\nmod b { mod c; pub fn f() {} }\n#[path = \"../x/y.rs\"] mod d;\n#[cfg(test)] mod t;\nmod e_tests;",
            ),
            ("c/src/a/mod.rs", "mod g;\nuse self::g::{H as I, _x as _};\nuse super::b::*;"),
            ("c/src/a/g.rs", "struct H;\nfn f() { let mod_z = 1; } // mod z;"),
            ("c/src/b/c.rs", ""),
            ("c/x/y.rs", "mod z;"),
            ("c/x/z.rs", ""),
            ("c/src/t.rs", ""),
            ("c/src/e_tests.rs", ""),
        ];
        let sources: Vec<Source> = text.iter().map(|(path, text)| Source::new(path, text).unwrap()).collect();
        let found = modules(&sources, "c/src/lib.rs");
        let files: Vec<_> = found.iter().map(|(path, module)| (path.join("::"), module.file.as_str())).collect();
        let expected = [
            ("", "c/src/lib.rs"),
            ("a", "c/src/a/mod.rs"),
            ("a::g", "c/src/a/g.rs"),
            ("b", "c/src/lib.rs"),
            ("b::c", "c/src/b/c.rs"),
            ("d", "c/x/y.rs"),
            ("d::z", "c/x/z.rs"),
        ];
        assert_eq!(files, expected.map(|(path, file)| (path.to_owned(), file)));
        let a = &found[&vec!["a".to_owned()]];
        assert_eq!(a.names.keys().collect::<Vec<_>>(), ["I"]);
        assert_eq!((a.globs.len(), a.said.len()), (1, 3));
        assert!(found[&vec!["a".to_owned(), "g".to_owned()]].items.contains("H"));
        assert!(found[&vec!["b".to_owned()]].home.is_empty());
    }
}
