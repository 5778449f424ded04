//! Errors of the cell file: what is wrong, where, and what to do. Shown once, with the line of the file.

use std::cell::RefCell;
use std::ops::Range;
use std::path::{Path, PathBuf};

use miette::{Diagnostic, NamedSource, SourceSpan};
use thiserror::Error;

use super::hash::sha256;

/// A problem in a cell file, with its place.
#[derive(Clone, Debug, Error, Diagnostic)]
#[error("{message}")]
pub struct CellError {
    /// What is wrong.
    pub message: String,
    /// The file.
    #[source_code]
    source_code: NamedSource<String>,
    /// Where in it.
    #[label("{label}")]
    span: Option<SourceSpan>,
    /// The same counted through the file and those that it extends.
    at: Range<usize>,
    label: String,
    /// What to do.
    #[help]
    pub help: Option<String>,
    /// Further problems of the same file, in its order.
    #[related]
    pub others: Vec<CellError>,
}

impl CellError {
    /// This problem and `others` as one, in the order of the file, each once.
    #[must_use]
    pub fn and(self, others: impl IntoIterator<Item = Self>) -> Box<Self> {
        let mut all: Vec<Self> = Vec::new();
        for mut other in std::iter::once(self).chain(others) {
            all.append(&mut other.others);
            all.push(other);
        }
        all.sort_by_key(|problem| problem.at.start);
        all.dedup_by(|a, b| a.message == b.message && a.at == b.at);
        let first = all.remove(0);
        Box::new(Self { others: all, ..first })
    }

    /// This problem and the others, in the order of the file.
    pub fn each(&self) -> impl Iterator<Item = &Self> {
        std::iter::once(self).chain(&self.others)
    }

    /// The same without what is said of these places; nothing if nothing is left.
    pub(super) fn apart_from(&self, places: &[Range<usize>]) -> Option<Box<Self>> {
        let touches =
            |problem: &Self, place: &Range<usize>| problem.at.start < place.end && place.start < problem.at.end;
        let elsewhere = self.each().filter(|problem| !places.iter().any(|place| touches(problem, place)));
        let mut elsewhere = elsewhere.map(|problem| Self { others: Vec::new(), ..problem.clone() });
        elsewhere.next().map(|first| first.and(elsewhere))
    }

    /// Line of the problem, counted from 1, when it has one.
    #[must_use]
    pub fn line(&self) -> Option<usize> {
        let offset = self.span?.offset();
        Some(self.source_code.inner().get(..offset)?.matches('\n').count() + 1)
    }

    /// The file that it is in, as messages call it: the cell file, or one that it extends.
    #[must_use]
    pub fn file(&self) -> &str {
        self.source_code.name()
    }
}

/// Why a cell could not be opened.
#[derive(Debug, Error, miette::Diagnostic)]
#[non_exhaustive]
pub enum OpenError {
    /// The cell file is wrong.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Cell(#[from] Box<CellError>),
    /// The FMU could not be read.
    #[error(transparent)]
    Fmu(#[from] crate::fmi::Error),
    /// A file could not be read.
    #[error("cannot read {path}: {error}")]
    Read {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        error: std::io::Error,
    },
    /// An FMU without a cell.
    #[error("{fmu} comes without a cell file, so neither the robot's shape nor the person's start is known")]
    #[diagnostic(help(
        "write a cell file and scan that: `fmi-hazard examples export DIR` gives complete examples, `fmi-hazard schema` \
         every key. Looked for: {looked}"
    ))]
    NoCell {
        /// The FMU.
        fmu: PathBuf,
        /// Places tried.
        looked: String,
    },
}

/// The text of a cell file, for making errors that point into it, with those of the files that it extends. Places are
/// counted through all of them, one behind the other.
#[derive(Clone, Debug)]
pub struct Source {
    name: String,
    text: String,
    folder: PathBuf,
    bases: Vec<Base>,
}

/// A file that a cell file extends, by itself or by way of others.
#[derive(Clone, Debug)]
pub struct Base {
    /// What it is called in messages.
    pub name: String,
    /// Its text.
    pub text: String,
    /// Where it is, seen from the folder of the cell file.
    pub path: PathBuf,
}

impl Base {
    /// SHA-256 of its text, lower-case hex.
    #[must_use]
    pub fn sha256(&self) -> String {
        sha256(self.text.as_bytes())
    }
}

impl Source {
    /// A source shown as `name` in messages, which is in the current folder.
    #[must_use]
    pub fn new(name: &str, text: &str) -> Self {
        Self { name: name.to_owned(), text: text.to_owned(), folder: PathBuf::new(), bases: Vec::new() }
    }

    /// The same in `folder`: files that it names are relative to that.
    #[must_use]
    pub fn in_folder(self, folder: &Path) -> Self {
        Self { folder: folder.to_owned(), ..self }
    }

    /// Another text in its place, which extends nothing.
    #[must_use]
    pub fn with_text(&self, text: &str) -> Self {
        Self { text: text.to_owned(), bases: Vec::new(), ..self.clone() }
    }

    /// The same on top of one more file.
    #[must_use]
    pub(super) fn on(mut self, base: Base) -> Self {
        self.bases.push(base);
        self
    }

    /// The files that it extends, the next first.
    #[must_use]
    pub fn bases(&self) -> &[Base] {
        &self.bases
    }

    /// The texts of the file and of those that it extends, each with where it begins.
    pub(super) fn parts(&self) -> impl Iterator<Item = (usize, &str)> {
        let texts = std::iter::once(&self.text).chain(self.bases.iter().map(|base| &base.text));
        texts.scan(0, |next, text| {
            let start = *next;
            // Ends do not touch the next beginnings.
            *next += text.len() + 1;
            Some((start, text.as_str()))
        })
    }

    /// All these texts, a line break behind each.
    pub(super) fn whole(&self) -> String {
        self.parts().map(|(_, text)| format!("{text}\n")).collect()
    }

    /// Which of the files a place is in, from 0, and where that begins.
    fn part(&self, offset: usize) -> (usize, usize) {
        let parts = self.parts().enumerate().map(|(number, (start, _))| (number, start));
        parts.take_while(|(_, start)| *start <= offset).last().unwrap_or_default()
    }

    /// The file of those that it extends that a place is in.
    #[must_use]
    pub(crate) fn base_at(&self, offset: usize) -> Option<&Base> {
        self.part(offset).0.checked_sub(1).and_then(|number| self.bases.get(number))
    }

    /// The folder that its files are relative to.
    #[must_use]
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// What it is called in messages.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The text.
    #[must_use]
    pub(crate) fn text(&self) -> &str {
        &self.text
    }

    /// SHA-256 of the text, lower-case hex.
    #[must_use]
    pub fn sha256(&self) -> String {
        sha256(self.text.as_bytes())
    }

    /// Line of a place in its file, from 1.
    #[must_use]
    pub(crate) fn line(&self, offset: usize) -> usize {
        let start = self.part(offset).1;
        let text = self.base_at(offset).map_or(&self.text, |base| &base.text);
        text.get(..offset - start).map_or(0, |before| before.matches('\n').count()) + 1
    }

    /// Where the header `[name]` stands, or the first line if it does not.
    #[must_use]
    pub fn table(&self, name: &str) -> Range<usize> {
        let header = format!("[{name}]");
        let found = self.parts().find_map(|(start, text)| Some(start + text.find(&header)?));
        found.map_or(0..0, |at| at..at + header.len())
    }

    /// An error at `span` (a byte range; empty at 0 means the file as a whole and shows its first line).
    #[must_use]
    pub fn error(
        &self,
        span: Range<usize>,
        label: &str,
        message: impl Into<String>,
        help: Option<String>,
    ) -> Box<CellError> {
        let first = 0..self.text.lines().next().map_or(0, str::len);
        let at = if span.end > 0 { span } else { first };
        let (name, text) = self.base_at(at.start).map_or((&self.name, &self.text), |base| (&base.name, &base.text));
        let start = at.start - self.part(at.start).1;
        let (text, span) = shown(text, start..start + at.len());
        Box::new(CellError {
            message: message.into(),
            source_code: NamedSource::new(name, text).with_language("TOML"),
            span: Some(SourceSpan::from((span.start, span.len()))),
            at,
            label: label.to_owned(),
            help,
            others: Vec::new(),
        })
    }

    /// A complaint of the `toml` crate, with a suggestion where a key or value is nearly right.
    #[must_use]
    pub(super) fn parse_error(&self, message: &str, span: Range<usize>) -> Box<CellError> {
        self.error(span, "here", message, did_you_mean(message))
    }
}

/// A line longer than this is not shown as a whole, bytes; so much of it is, before and behind a place.
const LONG_LINE: usize = 240;
const AROUND: usize = 60;

/// A text for showing a place in it: where lines are long, as in files that a program wrote on one, only what is around the place. Lines
/// keep their numbers.
fn shown(text: &str, place: Range<usize>) -> (String, Range<usize>) {
    let boundary = |mut at: usize| {
        at = at.min(text.len());
        while !text.is_char_boundary(at) {
            at -= 1;
        }
        at
    };
    let start = boundary(place.start);
    let line = text[..start].rfind('\n').map_or(0, |at| at + 1);
    let end = text[start..].find('\n').map_or(text.len(), |at| start + at);
    // Those before and behind are shown with it.
    let before = text[..line].trim_end_matches('\n').rsplit('\n').next().unwrap_or_default();
    let behind = text.get(end + 1..).and_then(|rest| rest.split('\n').next()).unwrap_or_default();
    if [end - line, before.len(), behind.len()].iter().all(|length| *length <= LONG_LINE) {
        return (text.to_owned(), place);
    }
    let from = boundary(start.saturating_sub(AROUND)).max(line);
    let to = boundary((start + place.len().min(AROUND) + AROUND).min(end));
    let mut out = "\n".repeat(text[..line].matches('\n').count());
    out += if from > line { "... " } else { "" };
    let begins = out.len() + start - from;
    out += &text[from..to];
    let ends = (begins + place.len()).min(out.len());
    out += if to < end { " ..." } else { "" };
    (out, begins..ends)
}

/// Problems met so far: checks go on behind a mistake, so that all are told at once.
#[derive(Debug, Default)]
pub(super) struct Problems(RefCell<Vec<CellError>>);

impl Problems {
    /// The value of `result`, or nothing and its problem is remembered.
    pub(super) fn keep<T>(&self, result: Result<T, Box<CellError>>) -> Option<T> {
        result.map_err(|problem| self.tell(problem)).ok()
    }

    /// Remembers a problem.
    pub(super) fn tell(&self, problem: Box<CellError>) {
        self.0.borrow_mut().push(*problem);
    }

    /// What of `results` is well; the problems of the others are remembered.
    pub(super) fn keep_all<T>(&self, results: impl IntoIterator<Item = Result<T, Box<CellError>>>) -> Vec<T> {
        results.into_iter().filter_map(|result| self.keep(result)).collect()
    }

    /// `value` if there was no problem.
    ///
    /// # Errors
    /// All problems together.
    pub(super) fn take_or<T>(&self, value: T) -> Result<T, Box<CellError>> {
        let mut all = self.0.take();
        all.pop().map_or(Ok(value), |last| Err(last.and(all)))
    }
}

/// Name of `path` for messages: the file name alone if there is one.
#[must_use]
pub(super) fn display_name(path: &Path) -> String {
    path.display().to_string()
}

/// The nearest of `candidates` to `word`, if near enough to be a slip.
#[must_use]
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let score = |c: &str| strsim::jaro_winkler(&word.to_lowercase(), &c.to_lowercase());
    candidates
        .into_iter()
        .map(|c| (score(c), c))
        .filter(|(s, _)| *s > 0.75)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|x| x.1)
}

/// Reads serde's "unknown field `x`, expected one of `a`, `b`" and suggests the nearest.
fn did_you_mean(message: &str) -> Option<String> {
    let mut quoted = message.split('`').skip(1).step_by(2);
    if let Some(name) = message.starts_with("missing field").then(|| quoted.next()).flatten() {
        return Some(format!("add `{name}` to this table; `fmi-hazard schema` tells what it takes"));
    }
    if message.starts_with("invalid type") {
        return Some("texts stand in quotes, numbers and true or false do not; lists in [ ], tables in { }".to_owned());
    }
    if message.starts_with("invalid length") || message.starts_with("invalid value") {
        return Some("`fmi-hazard schema` tells what it takes".to_owned());
    }
    if message.starts_with("duplicate key") {
        return Some("remove one of the two".to_owned());
    }
    if !message.starts_with("unknown") {
        return Some(
            "the file is written in TOML: key = value, texts in quotes, tables as [name] (toml.io)".to_owned(),
        );
    }
    Some(match meant(message) {
        Some(candidate) => format!("did you mean `{candidate}`?"),
        None => "`fmi-hazard schema` prints every key with its meaning".to_owned(),
    })
}

/// What is meant by an unknown key or value, if it is a slip.
pub(super) fn meant(message: &str) -> Option<&str> {
    let mut quoted = message.split('`').skip(1).step_by(2);
    let word = quoted.next()?;
    nearest(word, quoted)
}
