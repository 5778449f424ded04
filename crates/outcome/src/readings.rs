//! How readings that are answered alike are named, in the lines that accept that: `door with mat like mat`. Names that would read in two
//! ways are put in quotes there: `"mat with gate" like door`.

use std::borrow::Cow;
use std::collections::BTreeSet;

const LIKE: &str = " like ";
const WITH: &str = " with ";
const NOBODY: &str = "none";

/// One reading and the one that stands for it, each by the names of the sensors that see somebody.
#[must_use]
pub fn like(reading: &[&str], other: &[&str]) -> String {
    let named = |names: &[&str]| match names {
        [] => NOBODY.to_owned(),
        names => names.iter().map(|name| in_words(name)).collect::<Vec<_>>().join(WITH),
    };
    format!("{}{LIKE}{}", named(reading), named(other))
}

/// A name, in quotes where it might be taken for several.
fn in_words(name: &str) -> Cow<'_, str> {
    let is_plain = name != NOBODY && ![LIKE, WITH, "\""].iter().any(|part| format!(" {name} ").contains(part));
    if is_plain { Cow::Borrowed(name) } else { Cow::Owned(format!("{name:?}")) }
}

/// Whether this is such a line about sensors of these names.
#[must_use]
pub fn is_of(line: &str, names: &[&str]) -> bool {
    let names: Vec<Cow<'_, str>> = names.iter().map(|name| in_words(name)).collect();
    let is_side = |side: &str| side == NOBODY || is_joined(side, &names);
    line.match_indices(LIKE).any(|(at, _)| is_side(&line[..at]) && is_side(&line[at + LIKE.len()..]))
}

fn is_joined(text: &str, names: &[Cow<'_, str>]) -> bool {
    let mut begins = BTreeSet::from([0]);
    while let Some(at) = begins.pop_first() {
        for rest in names.iter().filter_map(|name| text[at..].strip_prefix(&**name)) {
            if rest.is_empty() {
                return true;
            }
            if let Some(next) = rest.strip_prefix(WITH) {
                begins.insert(text.len() - next.len());
            }
        }
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Names may have the words between them inside, and those that stand for nobody.
    #[test]
    fn lines_are_known_again() {
        let names = ["mat", "gate", "mat with gate", "door", "left like right", "none", "a \"b\""];
        assert_eq!(like(&["mat", "door"], &[]), "mat with door like none");
        let two_ways = [
            (like(&["mat with gate"], &["door"]), like(&["mat", "gate"], &["door"])),
            (like(&["none"], &["door"]), like(&[], &["door"])),
        ];
        assert!(two_ways.iter().all(|(one, other)| one != other && is_of(one, &names) && is_of(other, &names)));
        for line in
            [like(&["mat", "door"], &["door"]), like(&["left like right"], &[]), like(&["a \"b\"", "none"], &["mat"])]
        {
            assert!(is_of(&line, &names), "{line}");
        }
        for line in ["mat", "mat like curtain", "mat with like door", "mat like door with"] {
            assert!(!is_of(line, &names), "{line}");
        }
    }
}
