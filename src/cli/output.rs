//! Writing to the terminal and to files: the one place that prints.

use std::io::{IsTerminal as _, Write as _};
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use clap::ValueEnum;
use indicatif::{ProgressBar, ProgressStyle};
use serde::Serialize;

use super::exit::Failure;
use crate::fmi::{escaped, is_unsafe};

/// How much is told besides results.
#[derive(Clone, Copy, Debug, Default, clap::Args)]
pub(super) struct Verbosity {
    /// Only results, warnings and errors: no progress, no notes
    #[arg(short, long, global = true, conflicts_with = "verbose")]
    quiet: bool,
    /// Also what was found out about the FMU, and where time went
    #[arg(short, long, global = true)]
    verbose: bool,
}

static QUIET: AtomicBool = AtomicBool::new(false);
static VERBOSE: AtomicBool = AtomicBool::new(false);

impl Verbosity {
    /// From here on.
    pub(super) fn apply(self) {
        QUIET.store(self.quiet, Ordering::Relaxed);
        VERBOSE.store(self.verbose, Ordering::Relaxed);
    }
}

fn quiet() -> bool {
    QUIET.load(Ordering::Relaxed)
}

/// How a result is printed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(super) enum Format {
    /// For people
    #[default]
    Table,
    /// For programs
    Json,
}

/// Prints a result. A reader that has gone away (a closed pipe) is no failure.
pub(super) fn result(text: &str) {
    let _ = std::io::stdout().lock().write_all(safe(text).as_bytes());
}

/// Prints a program text of our own as it is.
pub(super) fn script(text: &str) {
    let _ = std::io::stdout().lock().write_all(text.as_bytes());
}

/// Prints JSON, which has its own way of escaping.
pub(super) fn json(text: &str) {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        if c != '\n' && is_unsafe(c) {
            c.encode_utf16(&mut [0; 2]).iter().for_each(|unit| out.push_str(&format!("\\u{unit:04x}")));
        } else {
            out.push(c);
        }
    }
    let _ = std::io::stdout().lock().write_all(out.as_bytes());
}

/// Anything as JSON for people to read, with a line break at its end.
pub(super) fn pretty(what: &(impl Serialize + ?Sized)) -> Result<String, Failure> {
    Ok(serde_json::to_string_pretty(what).map_err(Failure::unusable)? + "\n")
}

/// Prints it as JSON.
pub(super) fn json_of(what: &(impl Serialize + ?Sized)) -> Result<(), Failure> {
    json(&pretty(what)?);
    Ok(())
}

/// Prints a message for the person at the terminal.
pub(super) fn note(text: &str) {
    if !quiet() {
        let _ = writeln!(std::io::stderr().lock(), "{}", safe(text));
    }
}

/// The same for who wants to know more.
pub(super) fn detail(text: &str) {
    if VERBOSE.load(Ordering::Relaxed) {
        note(text);
    }
}

/// Prints what may make a result mean something else.
pub(super) fn warning(text: &str) {
    let _ = writeln!(std::io::stderr().lock(), "   Warning {}", safe(text));
}

/// Prints an error.
pub(super) fn error(text: &str) {
    let _ = writeln!(std::io::stderr().lock(), "Error: {}", safe(text.trim()));
}

/// Text as it may reach a terminal. Names come from vendors, and cell files may travel inside FMUs: nothing in them may
/// steer the terminal or turn text around. Our own line breaks and colours stay.
fn safe(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find(|c| c != '\n' && is_unsafe(c)) {
        out.push_str(&rest[..at]);
        rest = &rest[at..];
        let length = colour(rest).unwrap_or_else(|| rest.chars().next().map_or(0, char::len_utf8));
        if colour(rest).is_some() {
            out.push_str(&rest[..length]);
        } else {
            out.push_str(&escaped(&rest[..length]));
        }
        rest = &rest[length..];
    }
    out + rest
}

/// Length of the escape sequence for a colour that `text` begins with.
fn colour(text: &str) -> Option<usize> {
    let parameters = text.strip_prefix("\u{1b}[")?;
    let end = parameters.find(|c: char| !c.is_ascii_digit() && c != ';')?;
    parameters[end..].starts_with('m').then_some(2 + end + 1)
}

/// Writes a file whole or not at all: into a temporary file beside it, then renamed.
pub(super) fn write_file(path: &Path, text: &str) -> Result<(), Failure> {
    let temporary = path.with_extension("part");
    std::fs::write(&temporary, text)
        .and_then(|()| std::fs::rename(&temporary, path))
        .map_err(|e| Failure::unusable(format!("cannot write {}: {e}", path.display())))
}

/// Progress of work with a known end: a bar on a terminal, plain lines elsewhere.
pub(super) struct Progress {
    bar: Option<ProgressBar>,
    total: u64,
    unit: &'static str,
    next_line: u64,
}

impl Progress {
    /// Progress towards `total`.
    pub(super) fn new(total: u64, unit: &'static str) -> Self {
        let bar = (std::io::stderr().is_terminal() && !quiet()).then(|| {
            let style = ProgressStyle::with_template("  Scanning [{bar:30}] {pos}/{len} {msg}  ETA {eta}");
            let bar = ProgressBar::new(total);
            match style {
                Ok(style) => bar.with_style(style.progress_chars("=> ")),
                Err(_) => bar,
            }
        });
        Self { bar, total, unit, next_line: total.div_ceil(10).max(1) }
    }

    /// `done` of the total, with a word on what came out so far.
    pub(super) fn at(&mut self, done: u64, message: &str) {
        if let Some(bar) = &self.bar {
            bar.set_position(done);
            bar.set_message(safe(message));
        } else if done >= self.next_line && self.total > 1 {
            note(format!("  {done}/{} {}  {message}", self.total, self.unit).trim_end());
            self.next_line = done + self.total.div_ceil(10).max(1);
        }
    }

    /// A line above the bar.
    pub(super) fn line(&self, text: &str) {
        match &self.bar {
            Some(bar) => bar.suspend(|| note(text)),
            None => note(text),
        }
    }

    /// The work is over.
    pub(super) fn finish(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

/// Progress of an exhaustive search: level after level, each with its states.
pub(super) struct Levels {
    bar: Option<ProgressBar>,
    horizon: u32,
    told: Option<(usize, Instant)>,
}

/// Between two lines about one level, where nobody watches a bar.
const BETWEEN_LINES: Duration = Duration::from_secs(15);

impl Levels {
    /// Levels up to `horizon` actions.
    pub(super) fn new(horizon: u32) -> Self {
        Self { bar: None, horizon, told: None }
    }

    /// `done` of the `of` states that are `depth` actions from the start.
    pub(super) fn at(&mut self, depth: usize, done: usize, of: usize, message: &str) {
        let (number, horizon) = (depth + 1, self.horizon);
        if quiet() {
            return;
        }
        if std::io::stderr().is_terminal() {
            let bar = self.bar.get_or_insert_with(|| {
                let style = ProgressStyle::with_template("  {prefix} [{bar:30}] {pos}/{len} states  {msg}  ETA {eta}");
                let bar = ProgressBar::new(of as u64);
                match style {
                    Ok(style) => bar.with_style(style.progress_chars("=> ")),
                    Err(_) => bar,
                }
            });
            if self.told.is_none_or(|(told, _)| told != depth) {
                bar.reset();
                bar.set_length(of as u64);
                bar.set_prefix(format!("Action {number} of {horizon}"));
            }
            bar.set_position(done as u64);
            bar.set_message(safe(message));
            self.told = Some((depth, Instant::now()));
            return;
        }
        let lately = self.told.is_some_and(|(told, when)| told == depth && when.elapsed() < BETWEEN_LINES);
        if !lately || done == of {
            note(&format!("  action {number} of {horizon}: {done}/{of} states  {message}"));
            self.told = Some((depth, Instant::now()));
        }
    }

    /// The work is over.
    pub(super) fn finish(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_line_breaks_and_colours_reach_the_terminal() {
        assert_eq!(safe("a\n\u{1b}[31;1mred\u{1b}[0m"), "a\n\u{1b}[31;1mred\u{1b}[0m");
        assert_eq!(safe("\u{1b}[2J\u{1b}]0;x\u{7}\r\u{9b}2J"), "\\u{1b}[2J\\u{1b}]0;x\\u{7}\\r\\u{9b}2J");
        assert_eq!(safe("\u{1b}["), "\\u{1b}[");
        assert_eq!(safe("\u{202e}gnp.exe"), "\\u{202e}gnp.exe");
    }
}
