//! The rule that files use each other in one direction: where they do so in a circle, none of them can be understood before the others.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

use crate::arrows::{Arrows, arrows};
use crate::modules::{is_root, modules};
use crate::sources::Source;

/// Files each of which leads to each of the others, and how.
pub type Circles = BTreeMap<BTreeSet<String>, String>;

/// The circles of all crates that are in these sources.
#[must_use]
pub fn circles(sources: &[Source]) -> Circles {
    let roots = sources.iter().map(|source| &source.path).filter(|path| is_root(path));
    roots.flat_map(|root| circles_in(&arrows(&modules(sources, root)))).collect()
}

fn circles_in(arrows: &Arrows) -> Circles {
    let mut circles = Circles::new();
    let from: BTreeSet<&str> = arrows.keys().map(|(from, _)| from.as_str()).collect();
    let reached: BTreeMap<&str, BTreeSet<&str>> = from.iter().map(|from| (*from, reached(arrows, from))).collect();
    for (from, to) in &reached {
        let both = to.iter().filter(|to| reached.get(*to).is_some_and(|back| back.contains(from)));
        let files: BTreeSet<String> = both.map(|file| (*file).to_owned()).collect();
        if files.len() > 1 {
            let how = told(arrows, &files);
            circles.insert(files, how);
        }
    }
    circles
}

/// All files that a file leads to, itself among them where it is in a circle.
fn reached<'a>(arrows: &'a Arrows, from: &str) -> BTreeSet<&'a str> {
    let mut reached = BTreeSet::new();
    let mut ahead = vec![from];
    while let Some(at) = ahead.pop() {
        for (_, to) in arrows.keys().filter(|(from, _)| from == at) {
            if reached.insert(to.as_str()) {
                ahead.push(to);
            }
        }
    }
    reached
}

/// The arrows inside a circle.
fn told(arrows: &Arrows, files: &BTreeSet<String>) -> String {
    let inside = arrows.iter().filter(|((from, to), _)| files.contains(from) && files.contains(to));
    inside.fold(String::new(), |mut told, ((from, to), paths)| {
        let paths: Vec<&str> = paths.iter().map(String::as_str).collect();
        // Writing into a string does not fail.
        let _ = write!(told, "\n    {from} -> {to}: {}", paths.join(", "));
        told
    })
}

/// What is wrong: circles that are no part of one that is listed, and what is listed and is no circle any more.
#[must_use]
pub fn wrong(circles: &Circles, listed: &[&[&str]]) -> Vec<String> {
    let known = |circle: &BTreeSet<String>, of: &[&str]| circle.iter().all(|file| of.contains(&file.as_str()));
    let new = circles.iter().filter(|(circle, _)| !listed.iter().any(|of| known(circle, of)));
    let new = new.map(|(circle, how)| format!("a circle of {} files:{how}", circle.len()));
    let mended = listed.iter().filter(|of| !circles.keys().any(|circle| known(circle, of)));
    new.chain(mended.map(|of| format!("no circle any more: take it out of the list: {of:?}"))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sources::workspace;

    /// Circles that were there when the rule was made. Take out what is mended; add nothing.
    const LISTED: [&[&str]; 2] = [
        &["crates/simulation/src/world/contacts.rs", "crates/simulation/src/world/through_plane.rs"],
        &[
            "crates/simulation/src/world/occupant.rs",
            "crates/simulation/src/world/sensing.rs",
            "crates/simulation/src/world/operating.rs",
        ],
    ];

    #[test]
    fn no_files_of_a_crate_use_each_other_in_a_circle() {
        let wrong = wrong(&circles(&workspace().unwrap()), &LISTED);
        assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    }

    fn found(files: &[(&str, &str)]) -> Circles {
        let sources: Vec<Source> = files.iter().map(|(path, text)| Source::new(path, text).unwrap()).collect();
        circles(&sources)
    }

    #[test]
    fn a_circle_is_told_with_its_arrows_and_one_that_is_listed_until_it_is_mended() {
        let root = ("src/lib.rs", "mod a;\nmod b;\nmod c;\nmod d;");
        let (b, c) = (("src/b.rs", "fn f() { super::c::g() }"), ("src/c.rs", "use crate::{a, d};"));
        let circles = found(&[root, ("src/a.rs", "use crate::b::f;"), b, c, ("src/d.rs", "")]);
        let told = "a circle of 3 files:\n    src/a.rs -> src/b.rs: crate::b::f\n    src/b.rs -> src/c.rs: super::c::g\n    \
                    src/c.rs -> src/a.rs: crate::a";
        assert_eq!(wrong(&circles, &[]), [told]);
        assert_eq!(wrong(&circles, &[&["src/a.rs", "src/b.rs"]]).len(), 2, "it has grown");
        let listed: [&[&str]; 1] = [&["src/a.rs", "src/b.rs", "src/c.rs"]];
        assert!(wrong(&circles, &listed).is_empty());
        let mended = found(&[root, ("src/a.rs", ""), b, c, ("src/d.rs", "")]);
        assert!(mended.is_empty());
        assert_eq!(wrong(&mended, &listed).len(), 1);
    }

    #[test]
    fn what_leads_one_way_or_up_and_down_or_is_said_in_tests_is_no_circle() {
        let a = "mod inside { use super::super::b::f; }\nmod deep;\nfn g() {}\n// use crate::b;";
        let b = "fn f() { \"crate::a::g\"; }\n#[cfg(test)]\nmod tests { use crate::a::g; }";
        let deep = ("src/a/deep.rs", "use super::g;\nuse crate::a;");
        let files = [("src/lib.rs", "mod a;\nmod b;\nuse a::g;"), ("src/a.rs", a), ("src/b.rs", b), deep];
        assert!(found(&files).is_empty());
        let other = ("tests/a.rs", "use crate::b;\nmod b;");
        assert!(
            found(&[files[0], files[1], files[2], other, ("tests/b.rs", "use super::b;")]).is_empty(),
            "another crate"
        );
    }
}
