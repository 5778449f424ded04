//! The rule that a file begins by saying what it is for: in the lines of `//!` at its top, at least one sentence.

/// Fewest words that are a sentence.
const WORDS: usize = 3;

/// Whether a text begins with such lines.
#[must_use]
pub fn says_what_it_is_for(text: &str) -> bool {
    let lines: Vec<&str> = text.lines().map_while(|line| line.strip_prefix("//!")).collect();
    let said = lines.join(" ");
    let ends = |at: usize| said[at + 1..].is_empty() || said[at + 1..].starts_with(' ');
    let mut begins = 0;
    said.char_indices().filter(|(at, c)| matches!(c, '.' | ':' | '?') && ends(*at)).any(|(at, _)| {
        let words = said[begins..at].split_whitespace().count();
        begins = at + 1;
        words >= WORDS
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sources::rust;

    #[test]
    fn every_file_begins_by_saying_what_it_is_for() {
        let texts = rust().unwrap();
        let silent = texts.iter().filter(|(_, text)| !says_what_it_is_for(text)).map(|(path, _)| path.as_str());
        let silent: Vec<&str> = silent.collect();
        assert!(silent.is_empty(), "no sentence of `//!` at the top:\n{}", silent.join("\n"));
    }

    #[test]
    fn a_sentence_at_the_top_is_seen_and_nothing_else_is_one() {
        for says in [
            "//! What it is for.\nuse a::b;\n",
            "//! One sentence on\n//! two lines: and more\n",
            "//! Why is it so?",
            "//! The cell: what is around it.",
        ] {
            assert!(says_what_it_is_for(says), "{says}");
        }
        let silent = [
            "",
            "fn f() {}\n",
            "// What it is for.\n",
            "/// What it is for.\nfn f() {}\n",
            "use a::b;\n//! What it is for.\n",
            "//!\nfn f() {}\n",
            "//! Todo.\n",
            "//! No end of it in crate.rs\n",
        ];
        for text in silent {
            assert!(!says_what_it_is_for(text), "{text}");
        }
    }
}
