//! How readings that are answered alike are named, in the lines that accept that: `door with mat like mat`.

use std::collections::BTreeSet;

const LIKE: &str = " like ";
const WITH: &str = " with ";
const NOBODY: &str = "none";

/// One reading and the one that stands for it, each by the names of the sensors that see somebody.
#[must_use]
pub fn like(reading: &[&str], other: &[&str]) -> String {
    let named = |names: &[&str]| if names.is_empty() { NOBODY.to_owned() } else { names.join(WITH) };
    format!("{}{LIKE}{}", named(reading), named(other))
}

/// Whether this is such a line about sensors of these names.
#[must_use]
pub fn is_of(line: &str, names: &[&str]) -> bool {
    let is_side = |side: &str| side == NOBODY || is_joined(side, names);
    line.match_indices(LIKE).any(|(at, _)| is_side(&line[..at]) && is_side(&line[at + LIKE.len()..]))
}

fn is_joined(text: &str, names: &[&str]) -> bool {
    let mut begins = BTreeSet::from([0]);
    while let Some(at) = begins.pop_first() {
        for rest in names.iter().filter_map(|name| text[at..].strip_prefix(name)) {
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

    /// Names may have the words between them inside.
    #[test]
    fn lines_are_known_again() {
        let names = ["mat", "mat with gate", "door", "left like right"];
        for line in
            [like(&["mat", "door"], &["door"]), like(&["left like right"], &[]), like(&[], &["mat with gate", "mat"])]
        {
            assert!(is_of(&line, &names), "{line}");
        }
        for line in ["mat", "mat like curtain", "mat with like door", "mat like door with"] {
            assert!(!is_of(line, &names), "{line}");
        }
    }
}
