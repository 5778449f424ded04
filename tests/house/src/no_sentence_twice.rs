//! The rule that sentences are made in Rust and drawn by the viewer: what a string in `viewer/src` says in three words or more, no string
//! in `src/` or `crates/` says as well. Two versions of a sentence drift apart.

use std::collections::BTreeMap;

/// What two sources both say: each with where the program says it.
#[must_use]
pub fn twice(viewer: &[String], program: &BTreeMap<String, Vec<String>>) -> Vec<String> {
    let mut twice = Vec::new();
    for mine in viewer {
        for (file, pieces) in program {
            let same = pieces.iter().filter(|its| its.contains(mine.as_str()) || mine.contains(its.as_str()));
            twice.extend(same.map(|its| format!("\"{}\" and in {file} \"{}\"", mine.trim(), its.trim())));
        }
    }
    twice
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sources::texts;
    use crate::strings::said;

    /// Files of the viewer that still have sentences of which the program has a version of its own. Take out what is mended; add nothing.
    const EXCEPTED: [&str; 1] = ["whole.js"];

    /// What the files below a folder say, by their names.
    fn all_said(folder: &str, extension: &str) -> BTreeMap<String, Vec<String>> {
        let texts = texts(folder, extension).unwrap();
        texts.into_iter().map(|(path, text)| (path, said(&text, extension == "rs"))).collect()
    }

    #[test]
    fn what_the_viewer_says_the_program_does_not_say_as_well() {
        let viewer = all_said("viewer/src", "js");
        let program: BTreeMap<_, _> = [all_said("src", "rs"), all_said("crates", "rs")].into_iter().flatten().collect();
        assert!(viewer.len() > 30 && program.len() > 100, "{} and {} files", viewer.len(), program.len());
        let mut wrong = Vec::new();
        for (file, pieces) in &viewer {
            let twice = twice(pieces, &program);
            let excepted = EXCEPTED.iter().any(|name| file.ends_with(name));
            if excepted && twice.is_empty() {
                wrong.push(format!("{file} is mended: take it out of the list of exceptions"));
            } else if !excepted {
                wrong.extend(twice.into_iter().map(|what| format!("{file}: {what}")));
            }
        }
        assert!(wrong.is_empty(), "made in Rust and again in the viewer:\n{}", wrong.join("\n"));
    }

    #[test]
    fn a_sentence_in_both_is_told_and_what_shares_some_words_only_is_not() {
        let program = BTreeMap::from([("a.rs".to_owned(), said("\"turns left and walks on\"", true))]);
        assert_eq!(twice(&said("`Left and walks, ${x}`", false), &program).len(), 1);
        assert!(twice(&said("`turns left ${x} walks on`", false), &program).is_empty());
    }
}
