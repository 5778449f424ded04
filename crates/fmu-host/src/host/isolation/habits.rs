//! What an FMU does to the process it runs in, besides computing: working folder, locale, rounding mode, signal handlers,
//! threads, files, output, memory.
#![expect(unsafe_code, reason = "asks the C library for its locale and its signal handlers")]

use std::ffi::CStr;
use std::fmt;
use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use super::launch::Launcher;
use super::message::{Saving, WorkerReply, WorkerRequest};
use crate::host::plant::{PlantError, insist};
use crate::host::rounding;

/// Something an FMU does to its process.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", tag = "habit")]
pub enum Habit {
    /// It changes the working folder.
    WorkingFolder,
    /// It changes the locale.
    Locale {
        /// To this.
        to: String,
    },
    /// It leaves another rounding mode behind.
    RoundingMode,
    /// It installs signal handlers.
    SignalHandlers {
        /// For these.
        signals: Vec<String>,
    },
    /// It has threads of its own.
    Threads {
        /// How many.
        count: usize,
    },
    /// It leaves files in its working folder.
    Files {
        /// Their names.
        names: Vec<String>,
    },
    /// It prints.
    Prints {
        /// Bytes in these runs.
        bytes: u64,
    },
    /// It takes more and more memory.
    Leaks {
        /// Bytes a step, about.
        bytes_per_step: u64,
    },
    /// It takes more and more memory when states are saved and given back.
    LeaksStates {
        /// Bytes a state, about.
        bytes_per_state: u64,
    },
}

impl fmt::Display for Habit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::WorkingFolder => f.write_str("changes the working folder"),
            Self::Locale { to } => write!(f, "changes the locale to {to}"),
            Self::RoundingMode => f.write_str("changes the rounding mode"),
            Self::SignalHandlers { signals } => write!(f, "handles signals: {}", signals.join(", ")),
            Self::Threads { count: 1 } => f.write_str("has 1 thread of its own"),
            Self::Threads { count } => write!(f, "has {count} threads of its own"),
            Self::Files { names } => write!(f, "writes files: {}", names.join(", ")),
            Self::Prints { bytes } => write!(f, "prints ({bytes} bytes)"),
            Self::Leaks { bytes_per_step } => {
                write!(f, "takes about {bytes_per_step} more bytes of memory with each step")
            }
            Self::LeaksStates { bytes_per_state } => {
                write!(
                    f,
                    "takes about {bytes_per_state} more bytes of memory with each state it saves, also if that is given back"
                )
            }
        }
    }
}

impl Habit {
    /// What it means for a scan.
    #[must_use]
    pub const fn means(&self) -> &'static str {
        match self {
            Self::WorkingFolder => "nothing: each worker has a working folder of its own",
            Self::Locale { .. } => "nothing for results; numbers in its log may be written with a comma",
            Self::RoundingMode => "nothing: it is set back after each call",
            Self::SignalHandlers { .. } => "nothing in a worker; with --in-process they would take Ctrl-C",
            Self::Threads { .. } => "copies of its process cannot stand for its states",
            Self::Files { .. } => "they are removed with the worker; state kept in them is not restored",
            Self::Prints { .. } => "it goes to fmu.log, not to the terminal",
            Self::Leaks { .. } | Self::LeaksStates { .. } => {
                "workers are replaced by fresh ones when they have grown too much"
            }
        }
    }
}

/// Runs in a row, after one that warms up; the memory of the last half is compared.
const RUNS: usize = 12;
/// States saved and freed in a row, after as many that warm up: what else was freed before is taken again first.
const STATES: u32 = 256;
/// Growth below this is the allocator's, bytes a step or a state.
const LEAK: u64 = 64;

/// Finds the habits in a few runs of so many steps; in one, if the FMU runs `once` in a process: then leaks do not show.
/// If it `saves` states, in saving and freeing some too.
///
/// # Errors
/// When the FMU cannot be run that often.
pub fn habits(launcher: &Launcher, steps: usize, once: bool, saves: bool) -> Result<Vec<Habit>, PlantError> {
    insist(&mut || {
        let (_, before) = launcher.printed();
        let mut worker = launcher.start(false)?;
        let mut runs = |runs: usize| -> Result<(Vec<Habit>, u64), PlantError> {
            let found = match worker.ask(&WorkerRequest::Habits { steps, runs }, &launcher.limits)? {
                WorkerReply::Habits(found) => {
                    serde_json::from_str(&found).map_err(|e| PlantError::of(e.to_string()))?
                }
                WorkerReply::Failed(error) => return Err(error),
                _ => return Err(PlantError::of("a worker gave an unexpected answer")),
            };
            Ok((found, worker.resident()))
        };
        let (mut found, middle) = runs(if once { 1 } else { RUNS / 2 })?;
        if !once {
            let (all, end) = runs(RUNS / 2)?;
            found = all;
            let steps = u64::try_from(steps * (RUNS / 2)).unwrap_or(u64::MAX).max(1);
            let bytes_per_step = end.saturating_sub(middle) / steps;
            if bytes_per_step > LEAK {
                found.push(Habit::Leaks { bytes_per_step });
            }
        }
        let mut saved_and_freed = |times: u32| -> Result<Option<u64>, PlantError> {
            let number = 0;
            for _ in 0..times {
                let saved = worker.ask(&WorkerRequest::Save { number, how: Saving::ByFmu }, &launcher.limits)?;
                if !matches!(saved, WorkerReply::Done) {
                    return Ok(None);
                }
                worker.ask(&WorkerRequest::Forget(vec![number]), &launcher.limits)?;
            }
            Ok(Some(worker.resident()))
        };
        if saves
            && let Some(warm) = saved_and_freed(STATES)?
            && let Some(end) = saved_and_freed(STATES)?
        {
            let bytes_per_state = end.saturating_sub(warm) / u64::from(STATES);
            if bytes_per_state > LEAK {
                found.push(Habit::LeaksStates { bytes_per_state });
            }
        }
        drop(worker);
        let (_, after) = launcher.printed();
        if after > before {
            found.push(Habit::Prints { bytes: after - before });
        }
        found.sort();
        Ok(found)
    })
}

/// A process before an FMU was loaded into it.
pub(super) struct ProcessBaseline {
    folder: Option<PathBuf>,
    locale: String,
    handlers: Vec<usize>,
}

const SIGNALS: [(libc::c_int, &str); 9] = [
    (libc::SIGINT, "SIGINT"),
    (libc::SIGTERM, "SIGTERM"),
    (libc::SIGHUP, "SIGHUP"),
    (libc::SIGSEGV, "SIGSEGV"),
    (libc::SIGBUS, "SIGBUS"),
    (libc::SIGFPE, "SIGFPE"),
    (libc::SIGILL, "SIGILL"),
    (libc::SIGABRT, "SIGABRT"),
    (libc::SIGCHLD, "SIGCHLD"),
];

impl ProcessBaseline {
    /// This process, now.
    pub(super) fn now() -> Self {
        Self {
            folder: std::env::current_dir().ok(),
            locale: locale(),
            handlers: SIGNALS.iter().map(|(signal, _)| handler(*signal)).collect(),
        }
    }

    /// What is different now.
    pub(super) fn since(&self) -> Vec<Habit> {
        let now = Self::now();
        let mut found = Vec::new();
        if now.folder != self.folder {
            found.push(Habit::WorkingFolder);
        }
        if now.locale != self.locale {
            found.push(Habit::Locale { to: now.locale });
        }
        if rounding::was_changed() {
            found.push(Habit::RoundingMode);
        }
        let changed =
            SIGNALS.iter().zip(now.handlers.iter().zip(&self.handlers)).filter(|(_, (now, then))| now != then);
        let signals: Vec<String> = changed.map(|((_, name), _)| (*name).to_owned()).collect();
        if !signals.is_empty() {
            found.push(Habit::SignalHandlers { signals });
        }
        let count = std::fs::read_dir("/proc/self/task").into_iter().flatten().count().saturating_sub(1);
        if count > 0 {
            found.push(Habit::Threads { count });
        }
        let files = self.folder.iter().filter_map(|folder| std::fs::read_dir(folder).ok()).flatten().flatten();
        let mut names: Vec<String> = files.map(|file| file.file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        if !names.is_empty() {
            found.push(Habit::Files { names });
        }
        found
    }
}

fn locale() -> String {
    // SAFETY: with NULL the locale is asked for, not set.
    let name = unsafe { libc::setlocale(libc::LC_ALL, std::ptr::null()) };
    if name.is_null() {
        return String::new();
    }
    // SAFETY: not NULL, and a text of the C library that nobody changes meanwhile.
    unsafe { CStr::from_ptr(name) }.to_string_lossy().into_owned()
}

/// The handler of a signal, as a number.
fn handler(signal: libc::c_int) -> usize {
    // SAFETY: all-zero bytes are a valid value of this plain structure.
    let mut action: libc::sigaction = unsafe { std::mem::zeroed() };
    // SAFETY: with NULL for the new action the present one is written to `action`.
    if unsafe { libc::sigaction(signal, std::ptr::null(), &raw mut action) } == 0 { action.sa_sigaction } else { 0 }
}
