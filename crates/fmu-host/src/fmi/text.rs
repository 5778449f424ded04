//! Text from an FMU on its way to a person: names, log lines and messages come from outside and must neither steer a
//! terminal nor look like something else.

use std::fmt::Write as _;

/// Longest text that [`printable`] leaves whole, in characters.
const LONGEST: usize = 400;

/// Whether a character steers a terminal or changes how its neighbours look: control characters, marks of writing
/// direction, line separators, and characters without width.
#[must_use]
pub fn is_unsafe(c: char) -> bool {
    c.is_control()
        || matches!(
            c,
            '\u{61c}'
                | '\u{200b}'..='\u{200f}'
                | '\u{2028}'..='\u{202e}'
                | '\u{2060}'..='\u{206f}'
                | '\u{feff}'
                | '\u{fff9}'..='\u{fffb}'
                | '\u{e0000}'..='\u{e007f}'
        )
}

/// `text` with every unsafe character written as Rust writes it: `\n`, `\u{202e}`.
#[must_use]
pub fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        if is_unsafe(c) {
            out.extend(c.escape_default());
        } else {
            out.push(c);
        }
    }
    out
}

/// The same, with the middle of a long text left out: what is said before and after it still tells what it is about.
#[must_use]
pub fn printable(text: &str) -> String {
    let length = text.chars().count();
    if length <= LONGEST {
        return escaped(text);
    }
    let part = LONGEST / 2;
    let place = |n: usize| text.char_indices().nth(n).map_or(text.len(), |(i, _)| i);
    let mut out = escaped(&text[..place(part)]);
    let _ = write!(out, " ... ({} characters left out) ... ", length - 2 * part);
    out.push_str(&escaped(&text[place(length - part)..]));
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_steers_a_terminal_or_turns_text_around_is_written_out() {
        assert_eq!(escaped("q\u{1b}[2J\n\u{9b}1m"), "q\\u{1b}[2J\\n\\u{9b}1m");
        assert_eq!(escaped("a\u{202e}b\u{2066}c\u{200b}\u{feff}"), "a\\u{202e}b\\u{2066}c\\u{200b}\\u{feff}");
        assert_eq!(escaped("\u{e0041}"), "\\u{e0041}");
        // Ordinary writing of any language, quotes and backslashes stay.
        for plain in ["robot.q[1]", "\u{df}\u{e4}", "\u{5e0}\u{5e2}", "\u{65e5}\u{672c}", "e\u{301}", "'a' \"b\" \\"] {
            assert_eq!(escaped(plain), plain);
        }
    }

    #[test]
    fn long_texts_keep_their_beginning_and_their_end() {
        let text = format!("first{}last", "\u{e4}".repeat(70_000));
        let shown = printable(&text);
        assert!(shown.starts_with("first") && shown.ends_with("last"), "{shown}");
        assert!(shown.contains("... (69609 characters left out) ..."), "{shown}");
        assert_eq!(printable(&"x".repeat(400)), "x".repeat(400));
    }
}
