//! What FMUs print, with what they tell the logger: the beginning of it for a file, the last lines for messages.

use std::collections::VecDeque;
use std::fs::File;
use std::io::{self, Read as _};
use std::os::fd::{AsFd as _, OwnedFd};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use rustix::event::{PollFd, PollFlags, poll};

use crate::fmi::escaped;

/// Most that is kept of what FMUs print.
const KEPT: usize = 1 << 20;

/// What is kept of the end of what one process prints, bytes; the lines of it that are told, and how much of each.
const LAST: usize = 8 << 10;
const LINES: usize = 5;
const LONGEST: usize = 200;

/// Failures with what was printed before them that are kept.
const FAILURES: usize = 10;

/// How long what was printed is waited for, after the process has ended.
const WAIT: Duration = Duration::from_millis(200);

/// What all processes of some FMUs printed, as far as it is kept.
#[derive(Debug, Default)]
pub(super) struct PrintedLog {
    text: Vec<u8>,
    bytes: u64,
    before_failures: Vec<LastLines>,
}

/// What an FMU printed shortly before it failed. Not part of a result: it depends on what its process did before.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
pub struct LastLines {
    /// What happened.
    pub failure: String,
    /// The last lines.
    pub printed: Vec<String>,
}

impl PrintedLog {
    /// The beginning of it as text, and how many bytes there were.
    pub(super) fn beginning(&self) -> (String, u64) {
        let mut text = String::from_utf8_lossy(&self.text).into_owned();
        // What is no text takes more bytes than it had.
        text.truncate((0..=KEPT.min(text.len())).rev().find(|end| text.is_char_boundary(*end)).unwrap_or(0));
        (text, self.bytes)
    }

    /// Keeps what was printed before a failure, for the first few different ones.
    pub(super) fn keep(&mut self, failure: &str, printed: &[String]) {
        let known = self.before_failures.iter().any(|one| one.failure == failure);
        if !known && !printed.is_empty() && self.before_failures.len() < FAILURES {
            self.before_failures.push(LastLines { failure: failure.to_owned(), printed: printed.to_vec() });
        }
    }

    pub(super) fn before_failures(&self) -> Vec<LastLines> {
        self.before_failures.clone()
    }
}

/// What one worker prints: a thread reads it until all of its processes are gone.
pub(super) struct Printed {
    /// The end of the pipe that the thread reads, to see whether something is left in it.
    pipe: OwnedFd,
    last: Arc<Mutex<VecDeque<u8>>>,
    thread: Option<JoinHandle<()>>,
}

/// A lock that a panic elsewhere does not close.
pub(super) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Printed {
    /// Of the worker that writes to the other end of `pipe`; everything goes to `said` as well.
    pub(super) fn collect(pipe: OwnedFd, said: Arc<Mutex<PrintedLog>>) -> io::Result<Self> {
        let last: Arc<Mutex<VecDeque<u8>>> = Arc::default();
        let (reader, tail) = (File::from(pipe.try_clone()?), Arc::clone(&last));
        let thread =
            std::thread::Builder::new().name("fmu-output".to_owned()).spawn(move || read(reader, &said, &tail))?;
        Ok(Self { pipe, last, thread: Some(thread) })
    }

    /// The last lines so far, as they can be shown.
    pub(super) fn last_lines(&self) -> Vec<String> {
        let until = Instant::now() + WAIT;
        while rustix::io::ioctl_fionread(&self.pipe).is_ok_and(|left| left > 0) && Instant::now() < until {
            std::thread::sleep(Duration::from_millis(1));
        }
        let (bytes, cut) = {
            let last = lock(&self.last);
            (last.iter().copied().collect::<Vec<u8>>(), last.len() >= LAST)
        };
        let text = String::from_utf8_lossy(&bytes);
        // Of the first one only the end may be left.
        let lines = text.lines().skip(usize::from(cut && text.contains('\n')));
        let shown = lines.map(|line| escaped(line.trim_end()).chars().take(LONGEST).collect::<String>());
        let lines: Vec<String> = shown.filter(|line| !line.is_empty()).collect();
        lines[lines.len().saturating_sub(LINES)..].to_vec()
    }

    /// Waits for the thread, unless somebody who got away still holds the pipe.
    pub(super) fn finish(&mut self) {
        let Some(thread) = self.thread.take() else { return };
        let until = Instant::now() + Duration::from_millis(100);
        while !thread.is_finished() && Instant::now() < until {
            std::thread::sleep(Duration::from_micros(200));
        }
    }
}

fn read(mut pipe: File, said: &Mutex<PrintedLog>, last: &Mutex<VecDeque<u8>>) {
    let mut part = vec![0; 64 << 10];
    loop {
        // Waited for outside of the lock: whoever has it and finds the pipe empty has everything.
        let mut waited = [PollFd::from_borrowed_fd(pipe.as_fd(), PollFlags::IN)];
        match poll(&mut waited, None) {
            Ok(_) | Err(rustix::io::Errno::INTR) => {}
            Err(_) => return,
        }
        if waited[0].revents().is_empty() {
            continue;
        }
        let mut last = lock(last);
        let Ok(read @ 1..) = pipe.read(&mut part) else { return };
        last.extend(&part[..read]);
        let surplus = last.len().saturating_sub(LAST);
        last.drain(..surplus);
        drop(last);
        let mut said = lock(said);
        said.bytes += read as u64;
        let room = KEPT.saturating_sub(said.text.len()).min(read);
        said.text.extend_from_slice(&part[..room]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Write as _;

    #[test]
    fn the_last_lines_are_all_there_once_the_writer_is_gone() {
        for _ in 0..20 {
            let (reader, writer) = rustix::pipe::pipe().unwrap();
            let said: Arc<Mutex<PrintedLog>> = Arc::default();
            let mut printed = Printed::collect(reader, Arc::clone(&said)).unwrap();
            let mut writer = File::from(writer);
            for line in 0..5000 {
                writeln!(writer, "line {line}").unwrap();
            }
            write!(writer, "\n\x1b[2J{}", "x".repeat(1000)).unwrap();
            drop(writer);
            let lines = printed.last_lines();
            assert_eq!(lines[..4], [4996, 4997, 4998, 4999].map(|line| format!("line {line}")));
            assert!(lines[4].starts_with("\\u{1b}[2Jxxx") && lines[4].len() == LONGEST, "{lines:?}");
            printed.finish();
            let (text, bytes) = lock(&said).beginning();
            assert_eq!(text.len() as u64, bytes);
        }
    }
}
