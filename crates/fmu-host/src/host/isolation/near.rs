//! Keeps a worker on the processor of the thread that asks it.
//!
//! The two take turns, so they lose nothing by sharing one, and waking a sleeper on the own processor costs a few
//! microseconds instead of up to a hundred for one that idles. The worker follows the asking thread; the asking thread
//! stays where it is only while it sleeps. An FMU with threads of its own is left alone, since they would share too.

use rustix::thread::{CpuSet, Pid, sched_getaffinity, sched_getcpu, sched_setaffinity};

/// Questions after which it is looked again whether the FMU has threads.
const LOOK_AGAIN: u32 = 4096;

/// Where a worker is kept.
#[derive(Debug)]
pub(super) enum Near {
    /// Nowhere yet.
    Unknown,
    /// On the processor of whoever asked last.
    Following {
        /// The process that answers.
        process: i32,
        /// The processor.
        processor: usize,
        /// Questions since it was looked what the process does.
        questions: u32,
    },
    /// Nowhere: it has threads, or may start programs.
    Free,
}

impl Near {
    /// Keeps `process` near this thread.
    pub(super) fn follow(&mut self, process: i32) {
        let processor = sched_getcpu();
        match self {
            Self::Free => return,
            Self::Following { process: p, processor: c, questions } if *questions < LOOK_AGAIN => {
                *questions += 1;
                if (*p, *c) == (process, processor) {
                    return;
                }
            }
            _ => {}
        }
        let tasks = tasks(process);
        let moved = match tasks[..] {
            [task] => sched_setaffinity(Some(task), &one(processor)).is_ok(),
            _ => false,
        };
        if moved {
            *self = Self::Following { process, processor, questions: 0 };
        } else {
            if let (Self::Following { .. }, Ok(anywhere)) = (&*self, sched_getaffinity(None)) {
                for task in tasks {
                    let _ = sched_setaffinity(Some(task), &anywhere);
                }
            }
            *self = Self::Free;
        }
    }
}

/// The threads of a process.
fn tasks(process: i32) -> Vec<Pid> {
    let entries = std::fs::read_dir(format!("/proc/{process}/task")).into_iter().flatten().flatten();
    entries.filter_map(|entry| Pid::from_raw(entry.file_name().to_str()?.parse().ok()?)).collect()
}

/// This thread stays on the processor it is on while this lives.
pub(super) struct Stay(Option<CpuSet>);

impl Stay {
    /// From now on, if the worker follows.
    pub(super) fn here(near: &Near) -> Self {
        let Near::Following { processor, .. } = near else { return Self(None) };
        let before = sched_getaffinity(None).ok();
        Self(before.filter(|_| sched_setaffinity(None, &one(*processor)).is_ok()))
    }
}

impl Drop for Stay {
    fn drop(&mut self) {
        if let Some(before) = &self.0 {
            let _ = sched_setaffinity(None, before);
        }
    }
}

fn one(processor: usize) -> CpuSet {
    let mut set = CpuSet::new();
    set.set(processor);
    set
}
