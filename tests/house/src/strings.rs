//! What the strings of a source say, of Rust and of the viewer's JavaScript.

/// Fewest words that are a sentence here.
const WORDS: usize = 3;

/// What strings of a source say, without comments and without what is filled in, in small letters and without punctuation; each piece
/// between spaces.
#[must_use]
pub fn said(source: &str, rust: bool) -> Vec<String> {
    let mut strings = Strings { rest: source, rust, found: Vec::new() };
    strings.code(false);
    let letters = |token: &str| token.chars().filter(|c| c.is_alphabetic()).count() > 1 || token == "a";
    let word = |token: &str| token.trim_matches(|c: char| !c.is_alphanumeric()).to_lowercase();
    let piece = |text: &String| {
        let words: Vec<String> = text.split_whitespace().map(word).filter(|token| letters(token)).collect();
        (words.len() >= WORDS).then(|| format!(" {} ", words.join(" ")))
    };
    strings.found.iter().filter_map(piece).collect()
}

/// Reads string after string.
struct Strings<'a> {
    rest: &'a str,
    rust: bool,
    found: Vec<String>,
}

impl Strings<'_> {
    fn take(&mut self) -> Option<char> {
        let next = self.rest.chars().next()?;
        self.rest = &self.rest[next.len_utf8()..];
        Some(next)
    }

    fn skip_behind(&mut self, end: &str) {
        self.rest = self.rest.find(end).map_or("", |at| &self.rest[at + end.len()..]);
    }

    /// To the end, or to the brace that closes what is filled in.
    fn code(&mut self, filled_in: bool) {
        let mut open = 0_usize;
        while let Some(next) = self.take() {
            match next {
                '/' if self.rest.starts_with('/') => self.skip_behind("\n"),
                '/' if self.rest.starts_with('*') => self.skip_behind("*/"),
                '"' => self.string('"'),
                '\'' | '`' if !self.rust => self.string(next),
                '\'' => self.character(),
                'r' if self.rust && self.rest.trim_start_matches('#').starts_with('"') => self.raw(),
                '{' => open += 1,
                '}' if filled_in && open == 0 => return,
                '}' => open = open.saturating_sub(1),
                _ => {}
            }
        }
    }

    /// A character, or a lifetime, which ends nowhere.
    fn character(&mut self) {
        let mut chars = self.rest.char_indices();
        match (chars.next(), chars.next()) {
            (Some((_, '\\')), _) => {
                self.take();
                self.take();
                self.skip_behind("'");
            }
            (_, Some((at, '\''))) => self.rest = &self.rest[at + 1..],
            _ => {}
        }
    }

    /// `r"..."` or `r#"..."#`; what begins an identifier with these letters is none.
    fn raw(&mut self) {
        let hashes = self.rest.len() - self.rest.trim_start_matches('#').len();
        let end = format!("\"{}", "#".repeat(hashes));
        self.rest = &self.rest[hashes + 1..];
        let length = self.rest.find(&end).unwrap_or(self.rest.len());
        self.found.extend(self.rest[..length].split(['{', '}', '\n']).map(str::to_owned));
        self.skip_behind(&end);
    }

    /// A string in pieces, between which something is filled in.
    fn string(&mut self, quote: char) {
        let mut piece = String::new();
        while let Some(next) = self.take() {
            match next {
                '\\' => match self.take() {
                    // A line that goes on.
                    Some('\n') => self.rest = self.rest.trim_start(),
                    Some('n' | 't') | None => piece.push(' '),
                    Some(escaped) => piece.push(escaped),
                },
                '$' if quote == '`' && self.rest.starts_with('{') => {
                    self.take();
                    self.found.push(std::mem::take(&mut piece));
                    self.code(true);
                }
                '{' | '}' if self.rust => {
                    self.found.push(std::mem::take(&mut piece));
                    if next == '{' && !self.rest.starts_with('{') {
                        self.skip_behind("}");
                    }
                }
                _ if next == quote => break,
                _ => piece.push(next),
            }
        }
        self.found.push(piece);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strings_are_read_whole_and_comments_are_not() {
        let js = "// \"not this one here\"\nconst a = \"it's what one sees\"; /* 'nor this one either' */\n\
                  f(`walks ${x ? `on and on and on` : {}} straight ahead, upright`, 'a \\'b\\' and more to come');";
        assert_eq!(
            said(js, false),
            [" it's what one sees ", " on and on and on ", " straight ahead upright ", " a and more to come "]
        );
        let rust = "/// \"nor this one either\"\nfn a<'a>(c: char) { c == '\"' || c == '\\''; b(\"{x:.2} m less \\\n      than the limit\"); r#\"one \"two\" \
                    three\"# }";
        assert_eq!(said(rust, true), [" less than the limit ", " one two three "]);
    }
}
