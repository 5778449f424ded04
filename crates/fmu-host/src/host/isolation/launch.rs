//! Starting a worker, asking it with a time limit, and ending it with all that it started.
#![expect(unsafe_code, reason = "lets one file descriptor pass to the worker")]

use std::io;
use std::os::fd::{AsRawFd as _, BorrowedFd};
use std::os::unix::process::CommandExt as _;
use std::path::PathBuf;
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::atomic::Ordering;
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use super::channel::{Channel, GO, GONE};
use super::message::{Load, Unpacked, WorkerReply, WorkerRequest};
use super::near::{Near, Stay};
use super::printed::{LastLines, Printed, PrintedLog, lock};
use super::process::{self, ProcessEnd};
use super::sandbox::Rules;
use crate::fmi::temporary::Folder;
use crate::host::activity::{Call, Doing};
use crate::host::plant::PlantError;
use crate::host::system::SystemSetup;
use crate::stop::Stop;

/// How much an FMU may take.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Longest time of one call of the FMU.
    pub call: Duration,
    /// Most memory of a worker, bytes.
    pub memory: u64,
    /// A worker whose memory has grown by this much is replaced by a fresh one when it is convenient, bytes.
    pub growth: u64,
    /// So is one after so many communication steps: what else an FMU uses up, like file descriptors, ends with it.
    pub steps: u64,
    /// When everything has to end.
    pub stop: Stop,
}

impl Default for Limits {
    /// 10 s a call, 4 GiB, replaced after growing by 256 MiB or a hundred million steps.
    fn default() -> Self {
        Self {
            call: Duration::from_secs(10),
            memory: 4 << 30,
            growth: 256 << 20,
            steps: 100_000_000,
            stop: Stop::default(),
        }
    }
}

/// How an FMU is guarded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Guard {
    /// No files but its own, no network, no other programs.
    Sandboxed,
    /// It may do what its user may do.
    Trusted,
}

/// Starts workers for the FMUs of one cell.
#[derive(Clone)]
pub struct Launcher {
    load: Arc<Load>,
    guard: Guard,
    /// Limits of each worker.
    pub(super) limits: Limits,
    /// The program to start.
    program: PathBuf,
    said: Arc<Mutex<PrintedLog>>,
}

impl Launcher {
    /// For these unpacked FMUs. `program` is started as `program worker N` and must then call
    /// [`serve`](super::serve)`(N)` before it does anything else, as `fmi-hazard` does.
    #[must_use]
    pub fn new(program: PathBuf, fmus: Vec<Unpacked>, setup: SystemSetup, guard: Guard, limits: Limits) -> Self {
        let load = Load { fmus, setup, event_mode: None, sandbox: None };
        Self { load: Arc::new(load), guard, limits, program, said: Arc::default() }
    }

    /// The same with the event modes that the self-test settled on.
    pub(super) fn with_event_mode(mut self, event_mode: Vec<bool>) -> Self {
        Arc::make_mut(&mut self.load).event_mode = Some(event_mode);
        self
    }

    /// The same FMUs with another setup.
    #[must_use]
    pub fn with_setup(mut self, setup: SystemSetup) -> Self {
        Arc::make_mut(&mut self.load).setup = setup;
        self
    }

    /// When everything with these FMUs has to end.
    #[must_use]
    pub const fn stop(&self) -> &Stop {
        &self.limits.stop
    }

    /// The setup of the FMUs.
    #[must_use]
    pub fn setup(&self) -> &SystemSetup {
        &self.load.setup
    }

    /// What the FMUs printed so far, and how many bytes it was; only the first megabyte is kept.
    #[must_use]
    pub fn printed(&self) -> (String, u64) {
        lock(&self.said).beginning()
    }

    /// What was printed before the first few failures.
    #[must_use]
    pub fn before_failures(&self) -> Vec<LastLines> {
        lock(&self.said).before_failures()
    }

    /// Whether FMUs may do less than their user may.
    pub(super) fn is_sandboxed(&self) -> bool {
        self.guard == Guard::Sandboxed
    }

    /// A worker with the FMUs loaded. With `fork` it may copy itself.
    pub(super) fn start(&self, fork: bool) -> Result<Worker, PlantError> {
        if self.limits.stop.is_due() {
            return Err(PlantError::stopped());
        }
        let ours = |what: &str, e: &dyn std::fmt::Display| PlantError {
            message: format!("{what}: {e}. This concerns this machine, not the FMU"),
            fatal: true,
            ..PlantError::default()
        };
        let mut worker = Worker::spawn(self).map_err(|e| ours("a worker process cannot be started", &e))?;
        let folders = |load: &Load| load.fmus.iter().map(|fmu| fmu.folder.clone()).collect();
        let mut load = (*self.load).clone();
        let own = worker.folder.path().to_owned();
        load.sandbox = (self.guard == Guard::Sandboxed).then(|| Rules { read: folders(&load), write: vec![own], fork });
        match worker.ask(&WorkerRequest::Load(Box::new(load)), &self.limits)? {
            WorkerReply::Loaded { missing } => {
                worker.missing = missing;
                worker.resident_at_start = worker.resident();
                Ok(worker)
            }
            WorkerReply::NotLoaded { message, running } => {
                let error = PlantError { message, fatal: true, not_loaded: !running, ..PlantError::default() };
                Err(worker.with_last_words(error).at(0.0))
            }
            other => Err(ours("a worker gave an unexpected answer", &format!("{other:?}"))),
        }
    }
}

/// A worker process; ended when dropped.
pub(super) struct Worker {
    channel: Channel,
    keeper: Child,
    /// Closing it kills the worker's process group.
    life: Option<ChildStdin>,
    printed: Option<Printed>,
    said: Arc<Mutex<PrintedLog>>,
    /// Working directory of the FMUs, and the only place where they may write.
    folder: Folder,
    /// What of the sandbox this machine lacks.
    pub(super) missing: Vec<String>,
    resident_at_start: u64,
    near: Near,
}

/// How often a waiting program looks whether all is well.
const LOOK: Duration = Duration::from_millis(50);

impl Worker {
    fn spawn(launcher: &Launcher) -> io::Result<Self> {
        let (channel, file) = Channel::create()?;
        let folder = Folder::new("worker-")?;
        let (output, input) = rustix::pipe::pipe_with(rustix::pipe::PipeFlags::CLOEXEC)?;
        let descriptor = file.as_raw_fd();
        let mut command = Command::new(&launcher.program);
        command
            .arg("worker")
            .arg(descriptor.to_string())
            .current_dir(folder.path())
            .env("LC_ALL", "C")
            .env("TMPDIR", folder.path())
            .process_group(0)
            .stdin(Stdio::piped())
            .stdout(Stdio::from(input.try_clone()?))
            .stderr(Stdio::from(input));
        // SAFETY: between fork and exec only one system call is made, on a descriptor that stays open in this scope.
        unsafe {
            command.pre_exec(move || {
                let file = BorrowedFd::borrow_raw(descriptor);
                Ok(rustix::io::fcntl_setfd(file, rustix::io::FdFlags::empty())?)
            });
        }
        let mut keeper = command.spawn()?;
        drop(command);
        drop(file);
        let life = keeper.stdin.take();
        let printed = Printed::collect(output, Arc::clone(&launcher.said))?;
        // A trusted FMU may start programs, which would inherit its place.
        let near = if launcher.guard == Guard::Sandboxed { Near::Unknown } else { Near::Free };
        Ok(Self {
            channel,
            keeper,
            life,
            printed: Some(printed),
            said: Arc::clone(&launcher.said),
            folder,
            missing: Vec::new(),
            resident_at_start: 0,
            near,
        })
    }

    /// Asks and waits for the answer.
    ///
    /// # Errors
    /// When the FMU ended or blocked the process, or took too much memory: this worker is of no use any more.
    pub(super) fn ask(&mut self, question: &WorkerRequest, limits: &Limits) -> Result<WorkerReply, PlantError> {
        if limits.stop.is_due() {
            return Err(PlantError::stopped());
        }
        let bytes = postcard::to_stdvec(question).unwrap_or_default();
        if bytes.len() > super::channel::AREA {
            return Err(PlantError::of("a message to the worker is too long: this is an error of this program"));
        }
        // Threads begin with an instance, and would inherit its place: not before its first action.
        if let (WorkerRequest::Advance { .. } | WorkerRequest::Legs { .. }, Some(alive)) = (question, self.alive()) {
            self.near.follow(alive);
        }
        let number = self.channel.ask(&bytes);
        let _stay = Stay::here(&self.near);
        let (mut stamp, mut since) = (0, Instant::now());
        let mut over = false;
        loop {
            let rung = self.channel.times_rung();
            if let Some(answer) = self.channel.answer_to(number) {
                return postcard::from_bytes(&answer)
                    .map_err(|_| self.gone("overwrote the memory in which it answers".to_owned(), true));
            }
            if let Some(ended) = ProcessEnd::of(self.channel.head().death.load(Ordering::Acquire)) {
                return Err(self.gone(format!("ended its process ({ended})"), false));
            }
            if over {
                return Err(self.gone("ended its process".to_owned(), false));
            }
            self.channel.sleep(rung, LOOK);
            if self.channel.times_rung() != rung {
                continue;
            }
            if limits.stop.is_due() {
                return Err(PlantError::stopped());
            }
            // What the keeper said before it left is read after it has left: it may have had its say just now.
            over = matches!(self.keeper.try_wait(), Ok(Some(_)) | Err(_));
            if over {
                continue;
            }
            let doing = self.doing();
            if doing.stamp != stamp {
                (stamp, since) = (doing.stamp, Instant::now());
            } else if since.elapsed() > limits.call {
                return Err(self.gone(format!("gave no answer for {} s", limits.call.as_secs_f64()), true));
            }
            let resident = self.resident();
            if resident > limits.memory {
                return Err(self.gone(format!("took more than {} MB of memory", limits.memory / 1_000_000), true));
            }
        }
    }

    /// The error for a worker that is of no use any more.
    fn gone(&self, how: String, by_us: bool) -> PlantError {
        let doing = self.doing();
        let place = match doing.call {
            Call::Write | Call::Step | Call::Read => format!("{}, number {} of its run", doing.call, doing.step + 1),
            call => call.to_string(),
        };
        let error = PlantError {
            message: format!("the FMU {how} {place}"),
            // Before its first step.
            time_s: (doing.step == 0).then_some(0.0),
            lost: true,
            ended_by_us: by_us,
            ..PlantError::default()
        };
        self.with_last_words(error)
    }

    /// The same with what the FMU printed shortly before, unless the message has it already.
    pub(super) fn with_last_words(&self, error: PlantError) -> PlantError {
        let mut printed = self.printed.as_ref().map_or_else(Vec::new, Printed::last_lines);
        printed.retain(|line| !error.message.contains(line.as_str()));
        lock(&self.said).keep(&error.message, &printed);
        PlantError { printed, ..error }
    }

    fn doing(&self) -> Doing {
        Doing::of(self.channel.head().activity.load(Ordering::Relaxed))
    }

    /// Tells a parked process that nobody needs it any more.
    pub(super) fn forget_parked(&self, slot: u32) {
        self.channel.head().tell(slot, GO);
    }

    /// Whether the parked process that was told so has gone. Before that, another one in its place could be taken for it.
    pub(super) fn has_gone(&self, slot: u32) -> bool {
        let slot = self.channel.head().slot(slot);
        slot.is_none_or(|slot| slot.load(Ordering::Acquire) == GONE)
    }

    /// The live process; nothing if there is none. Its number stands in memory that the FMU could write to, so it counts
    /// only if the system says that the process is one of this worker's group.
    fn alive(&self) -> Option<i32> {
        let alive = i32::try_from(self.channel.head().alive.load(Ordering::Acquire)).ok()?;
        (process::group_of(alive) == i32::try_from(self.keeper.id()).ok()).then_some(alive)
    }

    /// Memory of the live process, bytes; 0 if it cannot be told.
    pub(super) fn resident(&self) -> u64 {
        let Some(alive) = self.alive() else { return 0 };
        let pages = |text: String| text.split_whitespace().nth(1)?.parse::<u64>().ok();
        let pages = std::fs::read_to_string(format!("/proc/{alive}/statm")).ok().and_then(pages);
        pages.unwrap_or(0) * rustix::param::page_size() as u64
    }

    /// How much the live process has grown since the FMUs were loaded, bytes.
    pub(super) fn growth(&self) -> u64 {
        self.resident().saturating_sub(self.resident_at_start)
    }

    /// What the live process has besides its memory: threads, children, sockets.
    pub(super) fn not_in_memory(&self) -> Option<String> {
        let Some(alive) = self.alive() else { return Some("the FMU's process cannot be looked at".to_owned()) };
        let process = PathBuf::from(format!("/proc/{alive}"));
        let list = |what: &str| std::fs::read_dir(process.join(what)).into_iter().flatten().flatten();
        let threads = list("task").count();
        if threads != 1 {
            let own = threads.max(1) - 1;
            let s = if own == 1 { "" } else { "s" };
            return Some(format!("the FMU runs {own} thread{s} of its own, which a copy does not have"));
        }
        let children = std::fs::read_to_string(process.join(format!("task/{alive}/children"))).unwrap_or_default();
        if !children.trim().is_empty() {
            return Some("the FMU has started other processes, which are not copied".to_owned());
        }
        let target = |entry: std::fs::DirEntry| std::fs::read_link(entry.path()).ok();
        list("fd")
            .filter_map(target)
            .any(|target| target.to_string_lossy().starts_with("socket:"))
            .then(|| "the FMU has opened sockets, which copies would share".to_owned())
    }

    /// The process in which the FMU runs, and the one that watches it.
    pub(super) fn pids(&self) -> [u32; 2] {
        [self.channel.head().alive.load(Ordering::Acquire), self.keeper.id()]
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        let since = Instant::now();
        let mut is_killed = false;
        while matches!(self.keeper.try_wait(), Ok(None)) {
            // The keeper sees the live process end, clears the family away and goes. Of a worker that was just begun that process is
            // not known yet.
            if let Some(alive) = self.alive().filter(|_| !is_killed) {
                process::kill(alive);
                is_killed = true;
            }
            if since.elapsed() > Duration::from_secs(1) {
                let _ = self.keeper.kill();
            }
            std::thread::sleep(Duration::from_micros(200));
        }
        // Whoever is left in the group goes with the pipe.
        if let Ok(group) = i32::try_from(self.keeper.id()) {
            process::kill(-group);
        }
        self.life = None;
        // What a process that got away still prints is not waited for.
        if let Some(mut printed) = self.printed.take_if(|_| since.elapsed() < Duration::from_secs(1)) {
            printed.finish();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sleeper() -> Child {
        Command::new("sleep").arg("600").process_group(0).spawn().unwrap()
    }

    #[test]
    fn an_fmu_that_names_another_process_as_its_own_does_not_get_it_killed() {
        let (channel, _file) = Channel::create().unwrap();
        let mut other = sleeper();
        let worker = Worker {
            channel,
            keeper: sleeper(),
            life: None,
            printed: None,
            said: Arc::default(),
            folder: Folder::new("worker-").unwrap(),
            missing: Vec::new(),
            resident_at_start: 0,
            near: Near::Free,
        };
        let head = worker.channel.head();
        for (named, real) in [(worker.keeper.id(), true), (other.id(), false), (0, false), (u32::MAX, false)] {
            head.alive.store(named, Ordering::Release);
            assert_eq!(worker.alive().is_some(), real, "{named}");
            assert_eq!(worker.resident() > 0, real, "{named}");
        }
        head.alive.store(other.id(), Ordering::Release);
        drop(worker);
        assert!(matches!(other.try_wait(), Ok(None)), "it was killed");
        other.kill().unwrap();
        other.wait().unwrap();
    }
}
