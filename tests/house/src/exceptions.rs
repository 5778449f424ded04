//! What breaks a rule, compared with the list of what broke it when the rule was made.

use std::collections::BTreeMap;

/// A file, something in it (or nothing, where the rule is about files), and its figure when it was listed.
pub type Exception = (&'static str, &'static str, usize);

/// What is found: a file and something in it, with its figure.
pub type Found = BTreeMap<(String, String), usize>;

/// What is wrong: what is over the limit without being listed or by more than it is listed with, and what is listed and is not over it.
#[must_use]
pub fn wrong(found: &Found, most: usize, listed: &[Exception]) -> Vec<String> {
    let mut wrong = Vec::new();
    let over = |figure: &usize| *figure > most;
    for ((path, name), figure) in found.iter().filter(|(_, figure)| over(figure)) {
        match listed.iter().find(|(file, of, _)| file == path && of == name) {
            None => wrong.push(format!("{path} {name}: {figure}, and at most {most} are allowed")),
            Some((_, _, before)) if figure > before => {
                wrong.push(format!("{path} {name}: {figure}, and has grown: it was listed with {before}"));
            }
            Some(_) => {}
        }
    }
    for (path, name, _) in listed {
        if !found.get(&((*path).to_owned(), (*name).to_owned())).is_some_and(over) {
            wrong.push(format!("{path} {name}: no longer breaks the rule, or is gone: take it out of the list"));
        }
    }
    wrong
}

/// Adds something; of several with one name the largest counts.
pub fn add(found: &mut Found, path: &str, name: &str, figure: usize) {
    let largest = found.entry((path.to_owned(), name.to_owned())).or_default();
    *largest = figure.max(*largest);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_new_has_grown_or_is_mended_is_told_and_what_is_listed_is_not() {
        let mut found = Found::new();
        for (name, figure) in [("small", 5), ("listed", 9), ("twice", 2), ("twice", 8), ("twice", 3)] {
            add(&mut found, "a.rs", name, figure);
        }
        assert!(wrong(&found, 5, &[("a.rs", "listed", 9), ("a.rs", "twice", 10)]).is_empty());
        let told = |listed: &[Exception]| wrong(&found, 5, listed);
        assert_eq!(told(&[("a.rs", "listed", 9)]), ["a.rs twice: 8, and at most 5 are allowed"]);
        assert_eq!(told(&[("a.rs", "listed", 9), ("b.rs", "twice", 9)]).len(), 2, "another file's");
        let grown = told(&[("a.rs", "listed", 8), ("a.rs", "twice", 8)]);
        assert_eq!(grown, ["a.rs listed: 9, and has grown: it was listed with 8"]);
        let mended = told(&[("a.rs", "listed", 9), ("a.rs", "twice", 8), ("a.rs", "small", 7)]);
        assert_eq!(mended, ["a.rs small: no longer breaks the rule, or is gone: take it out of the list"]);
    }
}
