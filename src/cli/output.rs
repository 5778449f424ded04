//! Writing to the terminal and to files: the one place that prints.

use std::io::{ErrorKind, IsTerminal as _, Write as _};
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use clap::ValueEnum;
use indicatif::{ProgressBar, ProgressStyle};
use serde::Serialize;

use super::events::{self, Event};
use super::exit::Failure;
use crate::fmi::{escaped, is_unsafe};
use crate::report::view::View;

/// How much is told besides results.
#[derive(Clone, Copy, Debug, Default, clap::Args)]
pub(super) struct Verbosity {
    /// Only results, warnings and errors: no progress, no notes
    #[arg(short, long, global = true, conflicts_with = "verbose")]
    quiet: bool,
    /// Also what was found out about the FMU, and where time went
    #[arg(short, long, global = true)]
    verbose: bool,
    /// How progress, notes, warnings and errors are told on standard error
    #[arg(long, global = true, value_enum, default_value_t, value_name = "HOW", conflicts_with = "quiet")]
    progress: StderrFormat,
}

/// How standard error is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
enum StderrFormat {
    /// For people
    #[default]
    Text,
    /// For programs: a JSON object a line, as `schema --of commands` says; when nobody reads them any more, the program ends as
    /// on Ctrl-C
    Json,
}

static QUIET: AtomicBool = AtomicBool::new(false);
static VERBOSE: AtomicBool = AtomicBool::new(false);
static EVENTS: AtomicBool = AtomicBool::new(false);

impl Verbosity {
    /// From here on.
    pub(super) fn apply(self) {
        QUIET.store(self.quiet, Ordering::Relaxed);
        VERBOSE.store(self.verbose, Ordering::Relaxed);
        EVENTS.store(self.progress == StderrFormat::Json, Ordering::Relaxed);
    }
}

fn quiet() -> bool {
    QUIET.load(Ordering::Relaxed)
}

/// Whether a program reads standard error.
fn prints_events() -> bool {
    EVENTS.load(Ordering::Relaxed)
}

/// Whether somebody watches bars.
fn has_bars() -> bool {
    std::io::stderr().is_terminal() && !quiet() && !prints_events()
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

/// How results are shown: as wide as the terminal, with colours where these are wanted.
pub(super) fn view() -> View {
    let verbose = VERBOSE.load(Ordering::Relaxed);
    let out = std::io::stdout();
    if !out.is_terminal() {
        return View { verbose, ..View::default() };
    }
    let width = terminal_size::terminal_size_of(&out).map_or(80, |(width, _)| usize::from(width.0));
    let is_set = |name: &str| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    let dumb = std::env::var_os("TERM").is_some_and(|term| term == "dumb");
    View { width: width.clamp(40, 100), verbose, colour: !is_set("NO_COLOR") && !dumb }
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
    let _ = std::io::stdout().lock().write_all(safe_json(text).as_bytes());
}

/// JSON as it may reach a terminal.
fn safe_json(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        if c != '\n' && is_unsafe(c) {
            c.encode_utf16(&mut [0; 2]).iter().for_each(|unit| out.push_str(&format!("\\u{unit:04x}")));
        } else {
            out.push(c);
        }
    }
    out
}

/// Tells a program something, in a line. Without a reader this process is asked to end, as somebody at a terminal would.
pub(super) fn event(event: &Event<'_>) {
    static GONE: AtomicBool = AtomicBool::new(false);
    if !prints_events() {
        return;
    }
    let Ok(line) = serde_json::to_string(event) else { return };
    let told = std::io::stderr().lock().write_all((safe_json(&line) + "\n").as_bytes());
    if told.is_err_and(|error| error.kind() == ErrorKind::BrokenPipe) && !GONE.swap(true, Ordering::Relaxed) {
        events::interrupt();
    }
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

/// What is being done, for [`phase`], since when, and when something was last printed.
static PHASE: Mutex<Option<Phase>> = Mutex::new(None);

struct Phase {
    text: String,
    since: Instant,
    printed: Instant,
    /// Nothing was printed yet.
    silent: bool,
}

/// Longest time without a line, where nobody watches a bar; and longest time without the first one, anywhere.
const BETWEEN_LINES: Duration = Duration::from_secs(15);
const FIRST_LINE: Duration = Duration::from_secs(2);

/// Says what is being done, for whoever waits: it is told when nothing was for two seconds, and later, where there is no bar,
/// when nothing else was for a while.
pub(super) fn phase(text: &str) {
    let now = Instant::now();
    let Ok(mut phase) = PHASE.lock() else { return };
    match phase.as_mut() {
        Some(phase) => {
            phase.since = now;
            text.clone_into(&mut phase.text);
        }
        None => {
            *phase = Some(Phase { text: text.to_owned(), since: now, printed: now, silent: true });
            if !quiet() {
                // Ends with the program.
                let tell = if prints_events() { each_phase } else { still_there };
                let _ = std::thread::Builder::new().name("still-there".to_owned()).spawn(tell);
            }
        }
    }
}

/// Tells a program what is being done, when it changes.
fn each_phase() {
    let mut told = String::new();
    loop {
        if let Ok(phase) = PHASE.lock()
            && let Some(phase) = phase.as_ref()
            && told != phase.text
        {
            phase.text.clone_into(&mut told);
            event(&Event::Doing { text: &told });
        }
        std::thread::sleep(events::BETWEEN);
    }
}

/// Tells now and then that the program is at work.
fn still_there() {
    loop {
        std::thread::sleep(Duration::from_millis(500));
        let Ok(phase) = PHASE.lock() else { return };
        let Some(Phase { text, since, printed, silent }) = phase.as_ref() else { continue };
        if !silent && std::io::stderr().is_terminal() {
            return;
        }
        let patience = if *silent { FIRST_LINE } else { BETWEEN_LINES };
        if printed.elapsed() < patience.saturating_sub(Duration::from_millis(500)) {
            continue;
        }
        let waited = since.elapsed().as_secs();
        let line = if waited < 2 { format!("  {text}") } else { format!("  {text} ({waited} s)") };
        drop(phase);
        note(&line);
    }
}

/// Prints a message between other lines, on a terminal with a bar too.
pub(super) fn interlude(text: &str) {
    if std::io::stderr().is_terminal() && !prints_events() {
        note("");
    }
    note(text);
}

/// Prints a message for the person at the terminal.
pub(super) fn note(text: &str) {
    if let Ok(mut phase) = PHASE.lock()
        && let Some(phase) = phase.as_mut()
    {
        (phase.printed, phase.silent) = (Instant::now(), false);
    }
    if prints_events() {
        event(&Event::Note { text: text.trim() });
    } else if !quiet() {
        let _ = writeln!(std::io::stderr().lock(), "{}", safe(text));
    }
}

/// Whether somebody wants to know more.
pub(super) fn verbose() -> bool {
    VERBOSE.load(Ordering::Relaxed)
}

/// The same for who wants to know more.
pub(super) fn detail(text: &str) {
    if verbose() {
        note(text);
    }
}

/// Prints what may make a result mean something else.
pub(super) fn warning(text: &str) {
    if prints_events() {
        return event(&Event::Warning { text: text.trim() });
    }
    let _ = writeln!(std::io::stderr().lock(), "   Warning {}", safe(text));
}

/// Prints an error.
pub(super) fn error(text: &str) {
    if prints_events() {
        return event(&Event::Error { text: text.trim() });
    }
    let _ = writeln!(std::io::stderr().lock(), "Error: {}", safe(text.trim()));
}

/// Prints a failure to stderr and returns its exit code.
pub(super) fn failed(failure: &Failure) -> u8 {
    error(&failure.text());
    failure.code()
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
    told: events::Sometimes,
}

impl Progress {
    /// Progress towards `total`.
    pub(super) fn new(total: u64, unit: &'static str) -> Self {
        let bar = has_bars().then(|| {
            let style = ProgressStyle::with_template("  Scanning [{bar:30}] {pos}/{len} {msg}  ETA {eta}");
            let bar = ProgressBar::new(total);
            match style {
                Ok(style) => bar.with_style(style.progress_chars("=> ")),
                Err(_) => bar,
            }
        });
        Self { bar, total, unit, next_line: total.div_ceil(10).max(1), told: events::Sometimes::default() }
    }

    /// `done` of the total, with a word on what came out so far.
    pub(super) fn at(&mut self, done: u64, message: &str) {
        if prints_events() {
            let Self { total, unit, .. } = *self;
            if total > 1 && self.told.again(done == total) {
                event(&Event::Progress { done, total, unit, text: message });
            }
        } else if let Some(bar) = &self.bar {
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
    events: events::Sometimes,
}

impl Levels {
    /// Levels up to `horizon` actions.
    pub(super) fn new(horizon: u32) -> Self {
        Self { bar: None, horizon, told: None, events: events::Sometimes::default() }
    }

    /// `done` of the `of` states that are `depth` actions from the start.
    pub(super) fn at(&mut self, depth: usize, done: usize, of: usize, message: &str) {
        let (number, horizon) = (depth + 1, self.horizon);
        if quiet() {
            return;
        }
        if prints_events() {
            if self.events.again(done == of) {
                let text = &format!("action {number} of {horizon}: {message}");
                event(&Event::Progress { done: done as u64, total: of as u64, unit: "states", text });
            }
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

/// How long an exhaustive search will take, by how its states grew and how fast they were looked at.
pub(super) struct Estimate {
    horizon: usize,
    began: Instant,
    /// States of the levels so far; of the last one, how many were looked at.
    levels: Vec<usize>,
    done: usize,
}

impl Estimate {
    /// Of a search up to `horizon` actions.
    pub(super) fn new(horizon: u32) -> Self {
        let horizon = usize::try_from(horizon).unwrap_or(usize::MAX);
        Self { horizon, began: Instant::now(), levels: Vec::new(), done: 0 }
    }

    /// `done` of the `of` states that are `depth` actions from the start were looked at.
    pub(super) fn level(&mut self, depth: usize, done: usize, of: usize) {
        if depth == 0 && self.levels.len() > 1 {
            (self.began, self.levels) = (Instant::now(), Vec::new());
        }
        self.levels.truncate(depth);
        self.levels.push(of);
        self.done = done;
    }

    /// In words, to be added to others: nothing before there is something to go by. It takes no longer than `limit`.
    pub(super) fn left(&self, limit: Option<Duration>) -> String {
        let told = |time: Duration| match time.as_secs() {
            s if s < 90 => format!("{} s", s.max(1)),
            s if s < 5400 => format!("{} min", s.div_ceil(60)),
            s => format!("{} h", s.div_ceil(3600)),
        };
        match (self.by_growth(), limit) {
            (Some(time), Some(limit)) if time > limit => format!(", ends in {} by its time limit", told(limit)),
            (Some(time), _) => format!(", about {} left", told(time)),
            (None, Some(limit)) => format!(", at most {} left", told(limit)),
            (None, None) => String::new(),
        }
    }

    #[expect(clippy::cast_precision_loss, reason = "an estimate")]
    fn by_growth(&self) -> Option<Duration> {
        let [.., before, last] = self.levels[..] else { return None };
        let earlier: usize = self.levels[..self.levels.len() - 1].iter().sum();
        let looked = (earlier + self.done) as f64;
        let growth = last as f64 / before.max(1) as f64;
        let (mut level, mut ahead) = (last as f64, (last - self.done.min(last)) as f64);
        for _ in self.levels.len()..self.horizon {
            level *= growth;
            ahead += level;
        }
        Duration::try_from_secs_f64(self.began.elapsed().as_secs_f64() * ahead / looked.max(1.0)).ok()
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
