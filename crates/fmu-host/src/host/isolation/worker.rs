//! The worker's side: a keeper that watches, and the live process in which the FMU runs.
#![expect(
    unsafe_code,
    reason = "takes over a file descriptor that the program left open for it, and the C library's output"
)]

use std::collections::BTreeMap;
use std::fs::{File, OpenOptions};
use std::io;
use std::os::fd::{AsFd, BorrowedFd, FromRawFd as _};
use std::sync::atomic::{AtomicU32, Ordering};

use rustix::thread::futex;

use super::channel::{Channel, GONE, LIVE, PARKED};
use super::habits::ProcessBaseline;
use super::message::{Leg, Load, Saving, StateCopyReply, Then, WorkerReply, WorkerRequest};
use super::process::{self, Fork, ProcessEnd};
use super::sandbox;
use crate::fmi::{self, Fmu, Slave};
use crate::host::activity::{Activity, Call};
use crate::host::plant::{Plant, PlantError, Reads, for_all_steps};
use crate::host::selftest::{self, Facts, Stage, moving};
use crate::host::system::{self, System};

/// Stands for the live process before there is one.
const NOBODY_YET: u32 = u32::MAX;

/// Exit code of a keeper that could not begin.
const CANNOT_BEGIN: u8 = 70;

/// Runs as a worker: `channel` is the number of the file descriptor of the shared memory, standard input the pipe that
/// tells when the program is gone. Returns the exit code.
#[must_use]
pub fn serve(channel: i32) -> u8 {
    begin(channel).map_or(CANNOT_BEGIN, |()| 0)
}

fn begin(channel: i32) -> io::Result<()> {
    // SAFETY: the program left this descriptor open for this worker and says so by its number; nobody else uses it.
    let file = unsafe { File::from_raw_fd(channel) };
    let channel = Channel::open(file)?;
    // The pipe moves away from standard input, which an FMU may read or close.
    // SAFETY: standard input is open: the program made it.
    let life = unsafe { BorrowedFd::borrow_raw(0) }.try_clone_to_owned()?;
    let nothing = OpenOptions::new().read(true).open("/dev/null")?;
    rustix::stdio::dup2_stdin(&nothing)?;
    process::die_with(life.as_fd())?;
    process::adopt_orphans();
    // The mapping and the pipe stay for as long as the process.
    let channel: &'static Channel = Box::leak(Box::new(channel));
    std::mem::forget(life);
    channel.head().alive.store(NOBODY_YET, Ordering::Release);
    match process::fork()? {
        Fork::Child => {
            channel.head().alive.store(process::own_pid(), Ordering::Release);
            live(channel)
        }
        Fork::Parent(child) => {
            keep(channel, child);
            Ok(())
        }
    }
}

/// The keeper: sees how the live process ends, tells it, and takes the whole family with it.
fn keep(channel: &Channel, first: i32) {
    let head = channel.head();
    while let Some((child, ended)) = process::wait_for_any_child() {
        let alive = head.alive.load(Ordering::Acquire);
        // A live process that hands over to a parked one says so first, by putting 0 there.
        if i32::try_from(alive) == Ok(child) || (alive == NOBODY_YET && child == first) {
            head.death.store(ended.code(), Ordering::Release);
            channel.ring();
            clear_away();
            return;
        }
    }
    head.death.store(ProcessEnd::Exit(0).code(), Ordering::Release);
    channel.ring();
}

/// Kills the children that are left, and the ones that they leave.
fn clear_away() {
    let path = format!("/proc/self/task/{}/children", process::own_pid());
    while let Ok(children) = std::fs::read_to_string(&path) {
        let children: Vec<i32> = children.split_whitespace().filter_map(|pid| pid.parse().ok()).collect();
        if children.is_empty() {
            return;
        }
        for child in children {
            process::kill(child);
        }
        let _ = process::wait_for_any_child();
    }
}

unsafe extern "C" {
    /// The C library's standard output.
    #[link_name = "stdout"]
    static STDOUT: *mut libc::FILE;
}

/// What the FMU prints and tells its logger goes out line by line: it may end this process at any time, and everything that
/// still waits in it would be lost.
fn speak_at_once() {
    // SAFETY: the C library's own stream, before anything was printed; the library takes a buffer of its own for NULL.
    unsafe { libc::setvbuf(STDOUT, std::ptr::null_mut(), libc::_IOLBF, 0) };
    fmi::on_log(|line| {
        // By the plain system call: no lock that a copy of this process could find taken.
        let _ = rustix::io::write(rustix::stdio::stderr(), format!("{line}\n").as_bytes());
    });
}

/// The live process: answers questions until it is killed.
fn live(channel: &'static Channel) -> ! {
    speak_at_once();
    let before = ProcessBaseline::now();
    let mut server =
        Server { channel, before, activity: Activity::new(&channel.head().activity), hosted: None, last: 0 };
    loop {
        let (number, question) = channel.next_question(server.last);
        server.last = number;
        let answer = match postcard::from_bytes(&question) {
            Ok(question) => server.answer(question),
            Err(error) => WorkerReply::NotLoaded { message: format!("not understood: {error}"), running: false },
        };
        server.activity.end();
        let bytes = postcard::to_stdvec(&answer).unwrap_or_default();
        channel.answer(server.last, &bytes);
    }
}

/// The FMUs of a worker.
struct Hosted {
    load: Load,
    slaves: Vec<Slave>,
    plant: System,
    /// States that the FMU saved.
    saved: BTreeMap<u32, system::Checkpoint>,
}

impl Hosted {
    fn restore(&mut self, number: u32) -> Result<(), PlantError> {
        let saved = self.saved.get(&number).ok_or_else(|| PlantError::of("this saved state is not known"))?;
        self.plant.restore(saved)
    }

    /// The outputs of all legs, one after the other.
    fn legs(&mut self, legs: &[Leg]) -> Result<Vec<f64>, PlantError> {
        let mut all = Vec::new();
        for Leg { from, steps, inputs, reads, to } in legs {
            let inputs = for_all_steps(inputs, self.plant.input_count(), *steps);
            all.extend(self.stepped(Some(*from), *steps, &inputs, *reads)?);
            let saved = self.plant.save()?;
            self.saved.insert(*to, saved);
        }
        Ok(all)
    }

    /// Outputs of an action from the present state, or from a saved one.
    fn stepped(
        &mut self,
        from: Option<u32>,
        steps: usize,
        inputs: &[f64],
        reads: Reads,
    ) -> Result<Vec<f64>, PlantError> {
        if let Some(number) = from {
            self.restore(number).map_err(|error| PlantError { restoring: true, ..error })?;
        }
        self.plant.advance_reading(steps, inputs, reads)
    }
}

/// On which side of a copy a process finds itself.
enum Side {
    /// It goes on.
    Original,
    /// It waited as a saved state and was called to life, by a question of its own.
    Copy,
}

struct Server {
    channel: &'static Channel,
    before: ProcessBaseline,
    activity: Activity,
    hosted: Option<Hosted>,
    /// Number of the question that is being answered.
    last: u32,
}

impl Server {
    fn answer(&mut self, question: WorkerRequest) -> WorkerReply {
        if let WorkerRequest::Load(load) = question {
            return self.load(*load);
        }
        let Some(hosted) = &mut self.hosted else { return not_loaded("nothing is loaded".to_owned(), false) };
        let rows = |result: Result<Vec<f64>, PlantError>| result.map_or_else(WorkerReply::Failed, WorkerReply::Rows);
        match question {
            WorkerRequest::Load(_) => WorkerReply::Done,
            WorkerRequest::Restart => {
                hosted.saved.clear();
                rows(hosted.plant.restart())
            }
            WorkerRequest::Advance { from, steps, inputs, then } => {
                match hosted.stepped(from, steps, &inputs, Reads::Each) {
                    Ok(rows) => {
                        let taken = match then {
                            Then::Nothing => Ok(StateCopyReply::Nothing),
                            Then::Fingerprint => hosted.plant.fingerprint().map(StateCopyReply::Fingerprint),
                            Then::Save { number, how } => match self.save(number, how) {
                                Ok(Side::Original) => Ok(StateCopyReply::Saved),
                                // Called to life by another question.
                                Ok(Side::Copy) => return WorkerReply::Done,
                                Err(error) => Err(error),
                            },
                        };
                        WorkerReply::Stepped { rows, taken }
                    }
                    Err(error) => WorkerReply::Failed(error),
                }
            }
            WorkerRequest::Legs { legs, forget } => {
                forget.iter().for_each(|number| {
                    hosted.saved.remove(number);
                });
                rows(hosted.legs(&legs))
            }
            WorkerRequest::Fingerprint => {
                hosted.plant.fingerprint().map_or_else(WorkerReply::Failed, WorkerReply::Print)
            }
            WorkerRequest::Save { number, how } => self
                .save(number, how)
                .map_or_else(WorkerReply::Failed, |(Side::Original | Side::Copy)| WorkerReply::Done),
            WorkerRequest::Restore { number, how: Saving::ByFork } => {
                let head = self.channel.head();
                head.alive.store(0, Ordering::Release);
                head.tell(number, LIVE);
                process::leave(0)
            }
            WorkerRequest::Restore { number, how: Saving::ByFmu } => {
                hosted.restore(number).map_or_else(WorkerReply::Failed, |()| WorkerReply::Done)
            }
            WorkerRequest::Forget(numbers) => {
                hosted.saved.retain(|number, _| !numbers.contains(number));
                WorkerReply::Done
            }
            WorkerRequest::Habits { steps, runs } => self.habits(steps, runs),
            WorkerRequest::SelfTest { steps, stage, reference } => self.test(steps, stage, reference),
        }
    }

    fn load(&mut self, load: Load) -> WorkerReply {
        // Initialisers of a library run while it is loaded, so the sandbox comes first.
        let missing = match &load.sandbox {
            None => Vec::new(),
            Some(rules) => match sandbox::enter(rules) {
                Ok(missing) => missing,
                Err(error) => return not_loaded(format!("the sandbox cannot be set up: {error}"), false),
            },
        };
        self.activity.begin(Call::Load, 0);
        let slaves =
            load.fmus.iter().map(|fmu| Fmu::reopen(&fmu.path, &fmu.folder)?.load()).collect::<Result<Vec<_>, _>>();
        let slaves = match slaves {
            Ok(slaves) => slaves,
            Err(error) => return not_loaded(error.to_string(), error.while_running()),
        };
        for (slave, prefer) in slaves.iter().zip(load.event_mode.iter().flatten()) {
            slave.prefer_event_mode(*prefer);
        }
        match self.system(&slaves, &load) {
            Ok(plant) => {
                self.hosted = Some(Hosted { load, slaves, plant, saved: BTreeMap::new() });
                WorkerReply::Loaded { missing }
            }
            Err(answer) => answer,
        }
    }

    fn system(&self, slaves: &[Slave], load: &Load) -> Result<System, WorkerReply> {
        let built = System::new(slaves, load.setup.clone());
        built.map(|system| system.watched(self.activity)).map_err(|e| not_loaded(e.to_string(), false))
    }

    fn habits(&mut self, steps: usize, runs: usize) -> WorkerReply {
        let Some(hosted) = &mut self.hosted else { return WorkerReply::Done };
        let setup = &hosted.load.setup;
        let inputs = moving(setup, steps, 0);
        for _ in 0..runs {
            let run = hosted.plant.restart().and_then(|_| hosted.plant.advance(steps, &inputs));
            if let Err(error) = run {
                return WorkerReply::Failed(error);
            }
        }
        WorkerReply::Habits(serde_json::to_string(&self.before.since()).unwrap_or_default())
    }

    fn test(&mut self, steps: usize, stage: Stage, reference: Vec<f64>) -> WorkerReply {
        let Some(hosted) = &self.hosted else { return WorkerReply::Done };
        let (slaves, setup) = (&hosted.slaves, &hosted.load.setup);
        let reference = match reference.is_empty() {
            true => match selftest::reference(slaves, setup, steps, self.activity) {
                Ok(rows) => rows,
                Err(error) => return WorkerReply::Failed(error),
            },
            false => reference,
        };
        if stage == Stage::FirstRun {
            // Of a run that is too long for a message the beginning is told.
            let rows = reference.into_iter().take(super::examine::KEPT).collect();
            let facts = serde_json::to_string(&Facts::of(slaves, setup)).unwrap_or_default();
            return WorkerReply::FirstRun { rows, facts };
        }
        let found = selftest::stage(slaves, setup, steps, stage, &reference, self.activity);
        WorkerReply::Tested(serde_json::to_string(&found).unwrap_or_default())
    }

    /// Keeps the present state under a number.
    fn save(&mut self, number: u32, how: Saving) -> Result<Side, PlantError> {
        match (how, &mut self.hosted) {
            (Saving::ByFork, _) => self.park(number),
            (Saving::ByFmu, Some(hosted)) => {
                hosted.saved.insert(number, hosted.plant.save()?);
                Ok(Side::Original)
            }
            (Saving::ByFmu, None) => Err(PlantError::of("nothing is loaded")),
        }
    }

    /// Leaves a copy of this process behind that waits until it is needed.
    fn park(&mut self, number: u32) -> Result<Side, PlantError> {
        let Some(slot) = self.channel.head().slot(number) else {
            return Err(PlantError::of("too many states are kept as processes"));
        };
        slot.store(PARKED, Ordering::Release);
        match process::fork() {
            Ok(Fork::Parent(_)) => Ok(Side::Original),
            Ok(Fork::Child) => {
                self.wait_at(slot);
                Ok(Side::Copy)
            }
            Err(error) => Err(PlantError::of(format!("the process cannot be copied: {error}"))),
        }
    }

    /// A parked process: copies of it go on living as often as they are called. Returns in each of them.
    fn wait_at(&mut self, slot: &AtomicU32) {
        let head = self.channel.head();
        loop {
            match slot.load(Ordering::Acquire) {
                PARKED => {
                    let _ = futex::wait(slot, futex::Flags::empty(), PARKED, None);
                }
                LIVE => {
                    slot.store(PARKED, Ordering::Release);
                    match process::fork() {
                        // Once more, so that the one who lives is a child of the keeper.
                        Ok(Fork::Child) => match process::fork() {
                            Ok(Fork::Child) => break,
                            Ok(Fork::Parent(_)) => process::leave(0),
                            Err(_) => self.cannot_live(),
                        },
                        Ok(Fork::Parent(_)) => {
                            let _ = process::wait_for_any_child();
                        }
                        Err(_) => self.cannot_live(),
                    }
                }
                _ => {
                    slot.store(GONE, Ordering::Release);
                    process::leave(0)
                }
            }
        }
        head.alive.store(process::own_pid(), Ordering::Release);
        // The question that woke this copy is the last one asked.
        self.last = self.channel.asked();
    }

    /// Tells that nobody lives any more.
    fn cannot_live(&self) -> ! {
        self.channel.head().death.store(ProcessEnd::Exit(CANNOT_BEGIN).code(), Ordering::Release);
        self.channel.ring();
        process::leave(i32::from(CANNOT_BEGIN))
    }
}

fn not_loaded(message: String, running: bool) -> WorkerReply {
    WorkerReply::NotLoaded { message, running }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::host::isolation::Unpacked;
    use crate::host::system::SystemSetup;

    /// Whoever asks comes to the state another way then: the action was not tried.
    #[test]
    fn a_state_that_cannot_be_restored_is_no_failure_of_the_action() {
        let setup = SystemSetup::default();
        let plant = System::new(&[], setup.clone()).unwrap();
        let load = Load { fmus: Vec::new(), setup, event_mode: None, sandbox: None };
        let mut hosted = Hosted { load, slaves: Vec::new(), plant, saved: BTreeMap::new() };
        let state = hosted.plant.save().unwrap();
        hosted.saved.insert(3, state);
        for from in [None, Some(3)] {
            assert_eq!(hosted.stepped(from, 1, &[], Reads::Each), Ok(Vec::new()), "{from:?}");
        }
        // Nothing was saved under this number.
        let error = hosted.stepped(Some(4), 1, &[], Reads::Each).unwrap_err();
        assert!(error.restoring && !error.lost && !error.fatal, "{error:?}");
    }

    #[test]
    fn each_fmu_has_event_mode_if_it_had_it_in_the_first_run() {
        let dir = tempfile::tempdir().unwrap();
        let written = fmi_hazard_examples::by_name("safety-fence").unwrap().export(dir.path()).unwrap();
        let fmu = Fmu::open(&written[0]).unwrap();
        let channel: &'static Channel = Box::leak(Box::new(Channel::create().unwrap().0));
        let activity = Activity::new(&channel.head().activity);
        let mut server = Server { channel, before: ProcessBaseline::now(), activity, hosted: None, last: 0 };
        let names = vec!["one".to_owned(), "two".to_owned()];
        let setup = SystemSetup { names, ..SystemSetup::default() };
        for (found, used) in [(None, [false; 2]), (Some(vec![true, false]), [true, false])] {
            let fmus = vec![Unpacked::of(&fmu); 2];
            let answer = server.load(Load { fmus, setup: setup.clone(), event_mode: found, sandbox: None });
            assert!(matches!(answer, WorkerReply::Loaded { .. }), "{answer:?}");
            let slaves = &server.hosted.as_ref().unwrap().slaves;
            assert_eq!(slaves.iter().map(Slave::prefers_event_mode).collect::<Vec<_>>(), used);
        }
    }
}
