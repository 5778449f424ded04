//! Sentences are made in Rust and drawn by the viewer: what a string in `viewer/src` says in three words or more, no string in `src/`
//! or `crates/` says as well. Two versions of a sentence drift apart.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// Files of the viewer that still have sentences of which the program has a version of its own. Take out what is mended; add nothing.
const EXCEPTED: [&str; 1] = ["whole.js"];

/// Fewest words that are a sentence here.
const WORDS: usize = 3;

/// What strings of a source say, without comments and without what is filled in, in small letters and without punctuation; each piece
/// between spaces.
fn said(source: &str, rust: bool) -> Vec<String> {
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

/// What the files below a folder say, by their names.
fn all_said(folder: &Path, extension: &str) -> BTreeMap<String, Vec<String>> {
    let mut all = BTreeMap::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|found| found == extension) {
                let name = path.strip_prefix(env!("CARGO_MANIFEST_DIR")).unwrap().display().to_string();
                all.insert(name, said(&fs::read_to_string(&path).unwrap(), extension == "rs"));
            }
        }
    }
    all
}

/// What two sources both say: each with where the program says it.
fn twice(viewer: &[String], program: &BTreeMap<String, Vec<String>>) -> Vec<String> {
    let mut twice = Vec::new();
    for mine in viewer {
        for (file, pieces) in program {
            let same = pieces.iter().filter(|its| its.contains(mine.as_str()) || mine.contains(its.as_str()));
            twice.extend(same.map(|its| format!("\"{}\" and in {file} \"{}\"", mine.trim(), its.trim())));
        }
    }
    twice
}

#[test]
fn what_the_viewer_says_the_program_does_not_say_as_well() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let viewer = all_said(&root.join("viewer/src"), "js");
    let program: BTreeMap<_, _> =
        [all_said(&root.join("src"), "rs"), all_said(&root.join("crates"), "rs")].into_iter().flatten().collect();
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
    let program = BTreeMap::from([("a.rs".to_owned(), said("\"turns left and walks on\"", true))]);
    assert_eq!(twice(&said("`Left and walks, ${x}`", false), &program).len(), 1);
    assert!(twice(&said("`turns left ${x} walks on`", false), &program).is_empty());
}
