//! Writing to the terminal and to files: the one place that prints.

use std::io::{IsTerminal as _, Write as _};
use std::path::Path;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

use super::exit::Failure;

/// Prints a result. A reader that has gone away (a closed pipe) is no failure.
pub(super) fn result(text: &str) {
    let _ = std::io::stdout().lock().write_all(text.as_bytes());
}

/// Prints a message for the person at the terminal.
pub(super) fn note(text: &str) {
    let _ = writeln!(std::io::stderr().lock(), "{text}");
}

/// Prints an error.
pub(super) fn error(text: &str) {
    let _ = writeln!(std::io::stderr().lock(), "Error: {}", text.trim());
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
        let bar = std::io::stderr().is_terminal().then(|| {
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
            bar.set_message(message.to_owned());
        } else if done >= self.next_line && self.total > 1 {
            note(&format!("  {done}/{} {}  {message}", self.total, self.unit));
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
            bar.set_message(message.to_owned());
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
