//! Which file of a crate uses which: every path that a module says leads to the module that defines what it names, also where that is
//! brought into another one and named there.

use std::collections::{BTreeMap, BTreeSet};

use crate::modules::Modules;
use crate::paths::Parts;

/// Arrows between files, each with the paths that draw it.
pub type Arrows = BTreeMap<(String, String), BTreeSet<String>>;

/// How often a name may stand for another one.
const DEEPEST: usize = 12;

/// The arrows between the files of a crate. Between a file and those of the modules above and below its own there are none: a module
/// names its own modules, and they may name it.
#[must_use]
pub fn arrows(modules: &Modules) -> Arrows {
    let mut arrows = Arrows::new();
    for (from, module) in modules {
        for path in &module.said {
            let Some(to) = led_to(modules, from, path, 0).and_then(|to| modules.get(&to)) else { continue };
            let related = to.home.starts_with(&module.home) || module.home.starts_with(&to.home);
            if !related {
                let arrow = arrows.entry((module.file.clone(), to.file.clone())).or_default();
                arrow.insert(path.join("::"));
            }
        }
    }
    arrows
}

/// The module that a path leads to, said in a module; none where it leads out of the crate or nowhere.
fn led_to(modules: &Modules, from: &[String], path: &[String], depth: usize) -> Option<Parts> {
    let first = path.first()?;
    let mut at = from.to_vec();
    let mut rest = path;
    match first.as_str() {
        "crate" => at.clear(),
        "self" => {}
        "super" => {
            while rest.first().is_some_and(|part| part == "super") {
                at.pop()?;
                rest = &rest[1..];
            }
            return onwards(modules, at, rest, depth);
        }
        _ => return named(modules, &at, rest, depth).flatten(),
    }
    rest = &rest[1..];
    onwards(modules, at, rest, depth)
}

/// From a module on along the rest of a path. What the module does not seem to have is taken to be its own: a macro may make it.
fn onwards(modules: &Modules, at: Parts, rest: &[String], depth: usize) -> Option<Parts> {
    if rest.is_empty() {
        return Some(at);
    }
    named(modules, &at, rest, depth).unwrap_or(Some(at))
}

/// Where the first name of a path leads to in a module, and the rest from there; none where the module knows no such name, and inside
/// that none where it leads out of the crate.
fn named(modules: &Modules, at: &[String], path: &[String], depth: usize) -> Option<Option<Parts>> {
    let module = modules.get(at)?;
    let (first, rest) = path.split_first()?;
    if depth > DEEPEST {
        return Some(None);
    }
    let below: Parts = at.iter().chain([first]).cloned().collect();
    if modules.contains_key(&below) {
        return Some(onwards(modules, below, rest, depth));
    }
    if module.items.contains(first) {
        return Some(Some(at.to_vec()));
    }
    if let Some(stands_for) = module.names.get(first) {
        let whole: Parts = stands_for.iter().chain(rest).cloned().collect();
        return Some(led_to(modules, at, &whole, depth + 1));
    }
    module.globs.iter().find_map(|glob| {
        let within = led_to(modules, at, glob, depth + 1)?;
        if within == at { None } else { named(modules, &within, path, depth + 1) }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modules::modules;
    use crate::sources::Source;

    /// The arrows of a crate of these files, which are modules of the root, without `.rs`.
    fn drawn(files: &[(&str, &str)]) -> Vec<String> {
        let source = |(name, text): &(&str, &str)| Source::new(&format!("src/{name}.rs"), text).unwrap();
        let sources: Vec<Source> = files.iter().map(source).collect();
        let short = |path: &str| path.trim_start_matches("src/").trim_end_matches(".rs").to_owned();
        let arrows = arrows(&modules(&sources, "src/lib.rs"));
        arrows.keys().map(|(from, to)| format!("{} {}", short(from), short(to))).collect()
    }

    const ROOT: (&str, &str) = ("lib", "mod a;\nmod b;\npub use b::Named;\nuse other::c;");

    #[test]
    fn a_path_leads_to_the_file_that_defines_what_it_names() {
        let b = ("b", "pub struct Named;\npub enum E { V }\npub mod deep;");
        let deep = ("b/deep", "pub struct D;");
        let leads = |text: &str| drawn(&[ROOT, ("a", text), b, deep]);
        for text in [
            "use crate::b::E;",
            "use super::b;",
            "fn f() -> crate::b::E { crate::b::E::V }",
            "use crate::Named;",
            "use super::*;\nfn f(_: Named) {}",
            "mod inside { fn f() -> super::super::b::E {} }",
            "fn f() { made!(x, crate::b::made_by_a_macro()) }",
        ] {
            assert_eq!(leads(text), ["a b"], "{text}");
        }
        assert_eq!(leads("use crate::b::deep::D;"), ["a b/deep"]);
        assert_eq!(leads("use crate::b;\nfn f(_: b::deep::D) {}"), ["a b", "a b/deep"]);
    }

    #[test]
    fn nothing_leads_out_of_the_crate_or_to_ones_own_parents_and_children() {
        let b = ("b", "mod deep;\nuse deep::D;\nuse crate::Named;\nfn f() { self::deep::f(); deep::g(); }");
        let deep = ("b/deep", "use super::f;\nuse crate::x;\npub struct D;");
        assert!(drawn(&[ROOT, ("a", ""), b, deep]).is_empty());
        for text in [
            "use crate::c::d;\nuse std::fmt;\nuse fmt::Debug;\nuse loop_a::loop_a;\nfn f() -> loop_a::X {}",
            "use crate::Unknown;",
            "// use crate::b::Named;\n/// [`crate::b::Named`]\nfn f() { \"crate::b::Named\"; }",
            "#[cfg(test)]\nmod tests { use crate::b::Named; }",
            "mod tests;",
        ] {
            assert!(
                drawn(&[ROOT, ("a", text), ("a/tests", "use crate::b;"), ("b", "struct Named;")]).is_empty(),
                "{text}"
            );
        }
    }
}
