//! FMUs in a worker process, as a [`Plant`]: a crash, a hang or too much memory is an error of one action, and the next
//! question meets a fresh worker.

use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use super::launch::{Launcher, Worker};
use super::message::{self, Saving, WorkerReply, WorkerRequest};
use crate::host::plant::{
    Arrived, Fingerprint, Leg, LegStart, Plant, PlantError, StateCopy, Stepped, Then, one_by_one,
};
use crate::stop::Stop;

/// How states are brought back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WorkerRestore {
    /// The FMU saves them.
    ByFmu,
    /// Copies of the process.
    ByFork,
    /// Not at all; each run has a fresh instance.
    Instances,
    /// Not at all; each run has a fresh process.
    Processes,
}

/// Each time a worker gives no answer costs its whole time limit. So often, in one search, it is seen whether it happens
/// again; then it is the FMU's way.
const TRIED_AGAIN: u32 = 6;

/// It is looked after so many restored states whether a worker has had its time.
const LOOK_AFTER: u32 = 64;

/// A plant in a worker process.
pub struct Isolated {
    launcher: Launcher,
    keeping: WorkerRestore,
    worker: Option<Worker>,
    /// Raised whenever saved states are lost: with a worker, and with an instance that saved them.
    generation: u64,
    free: Arc<Mutex<Numbers>>,
    replaced: u64,
    /// Steps that the present worker has made.
    steps: u64,
    /// How often a worker had to be ended because it gave no answer or took too much.
    ended_by_us: u32,
    /// Restoring, actions and what is done after them are asked for one by one, since a worker was lost that was asked for
    /// several at once, or refused to restore: so it shows what ends it.
    one_by_one: bool,
    /// A saved state that is to be restored with the next action.
    put_off: Option<u32>,
    /// States restored since it was looked whether the worker has had its time.
    restored: u32,
}

/// Numbers of saved states.
#[derive(Default)]
struct Numbers {
    next: u32,
    /// Given back, with their generation.
    back: Vec<(u64, u32)>,
    /// Those of parked processes that were told to go and may still be there.
    leaving: Vec<u32>,
    unused: Vec<u32>,
}

/// A saved state of an [`Isolated`] plant.
pub struct Checkpoint {
    number: u32,
    generation: u64,
    home: Arc<Mutex<Numbers>>,
}

impl Drop for Checkpoint {
    fn drop(&mut self) {
        self.home.lock().unwrap_or_else(PoisonError::into_inner).back.push((self.generation, self.number));
    }
}

impl Numbers {
    /// One that is free.
    fn take(&mut self) -> u32 {
        self.unused.pop().unwrap_or_else(|| {
            self.next += 1;
            self.next - 1
        })
    }
}

impl Isolated {
    /// A plant whose workers come from `launcher`; nothing is started yet.
    #[must_use]
    pub fn new(launcher: Launcher, keeping: WorkerRestore) -> Self {
        Self {
            launcher,
            keeping,
            worker: None,
            generation: 0,
            free: Arc::default(),
            replaced: 0,
            steps: 0,
            ended_by_us: 0,
            one_by_one: false,
            put_off: None,
            restored: 0,
        }
    }

    /// Workers replaced so far: because an FMU ended, blocked or filled one.
    #[must_use]
    pub const fn replaced(&self) -> u64 {
        self.replaced
    }

    /// The process in which the FMU runs now and the one that watches it, if there is one: for tests.
    #[must_use]
    pub fn pids(&self) -> Option<[u32; 2]> {
        self.worker.as_ref().map(Worker::pids)
    }

    /// Why copies of the FMU's process cannot stand for its states, if that is so: what lives outside of its memory is
    /// not copied.
    pub(super) fn reason_against_copies(&self) -> Option<String> {
        self.worker.as_ref().and_then(Worker::not_in_memory)
    }

    fn saving(&self) -> Option<Saving> {
        match self.keeping {
            WorkerRestore::ByFmu => Some(Saving::ByFmu),
            WorkerRestore::ByFork => Some(Saving::ByFork),
            WorkerRestore::Instances | WorkerRestore::Processes => None,
        }
    }

    /// All saved states are lost.
    fn lose(&mut self) {
        self.generation += 1;
        let mut free = self.free.lock().unwrap_or_else(PoisonError::into_inner);
        *free = Numbers::default();
    }

    fn end(&mut self) {
        self.worker = None;
        self.steps = 0;
        self.put_off = None;
        self.lose();
    }

    fn ask(&mut self, question: &WorkerRequest) -> Result<WorkerReply, PlantError> {
        if let (false, Some(number)) = (
            matches!(question, WorkerRequest::Advance { .. } | WorkerRequest::Legs { .. } | WorkerRequest::Forget(_)),
            self.put_off,
        ) {
            self.put_off = None;
            self.ask(&WorkerRequest::Restore { number, how: Saving::ByFmu })?;
        }
        let worker = match &mut self.worker {
            Some(worker) => worker,
            none => none.insert(self.launcher.start(self.keeping == WorkerRestore::ByFork)?),
        };
        match worker.ask(question, &self.launcher.limits) {
            Ok(WorkerReply::Failed(error)) => Err(self.failed(error)),
            Ok(answer) => Ok(answer),
            Err(error) => {
                self.replaced += u64::from(!error.stopped);
                self.ended_by_us += u32::from(error.ended_by_us);
                self.end();
                Err(PlantError { settled: self.ended_by_us > TRIED_AGAIN, ..error })
            }
        }
    }

    /// The FMU failed. After a fatal error no instance of it may be called; a fresh process has none.
    fn failed(&mut self, error: PlantError) -> PlantError {
        if error.fatal {
            self.replaced += 1;
            self.end();
        }
        PlantError { fatal: false, ..error }
    }

    /// Whether these are so many rows of outputs. An FMU that writes where it should not may have written there too.
    fn are_rows(&self, rows: &[f64], count: usize) -> bool {
        rows.len() == count * self.output_count() && rows.iter().all(|v| v.is_finite())
    }

    /// What the worker says makes no sense: it is of no use any more.
    fn unexpected(&mut self) -> PlantError {
        self.replaced += 1;
        self.end();
        PlantError { lost: true, ..PlantError::of("the FMU's process gave an answer that makes no sense") }
    }

    /// Whether the worker has had its time.
    fn is_worn(&self) -> bool {
        let limits = &self.launcher.limits;
        self.worker.as_ref().is_some_and(|worker| self.steps >= limits.steps || worker.growth() > limits.growth)
    }

    /// Numbers of states that nobody needs any more.
    fn given_back(&self) -> Vec<u32> {
        let back = std::mem::take(&mut self.free.lock().unwrap_or_else(PoisonError::into_inner).back);
        back.into_iter().filter(|(g, _)| *g == self.generation).map(|(_, n)| n).collect()
    }

    /// Tells the worker of states that nobody needs any more.
    fn tidy(&mut self) -> Result<(), PlantError> {
        let numbers = self.given_back();
        if numbers.is_empty() {
            return Ok(());
        }
        let forked = matches!(self.saving(), Some(Saving::ByFork));
        if let (true, Some(worker)) = (forked, &self.worker) {
            numbers.iter().for_each(|slot| worker.forget_parked(*slot));
        } else {
            self.ask(&WorkerRequest::Forget(numbers.clone()))?;
        }
        let mut free = self.free.lock().unwrap_or_else(PoisonError::into_inner);
        if forked {
            free.leaving.extend(numbers)
        } else {
            free.unused.extend(numbers)
        }
        Ok(())
    }

    /// Takes back the numbers of parked processes that have gone. Where all places are taken it waits for one, for a second
    /// at most.
    fn collect_gone(&self) {
        let Some(worker) = &self.worker else { return };
        let mut free = self.free.lock().unwrap_or_else(PoisonError::into_inner);
        for _ in 0..1000 {
            let (gone, leaving) =
                std::mem::take(&mut free.leaving).into_iter().partition(|slot| worker.has_gone(*slot));
            free.leaving = leaving;
            free.unused.extend::<Vec<u32>>(gone);
            let full = usize::try_from(free.next).is_ok_and(|next| next >= super::channel::SLOTS);
            if !full || !free.unused.is_empty() || free.leaving.is_empty() {
                return;
            }
            std::thread::sleep(Duration::from_millis(1));
        }
    }

    /// A number for a state that is about to be saved.
    fn number(&mut self) -> Result<u32, PlantError> {
        self.tidy()?;
        self.collect_gone();
        let mut free = self.free.lock().unwrap_or_else(PoisonError::into_inner);
        Ok(free.take())
    }

    /// The state that was saved under this number.
    fn checkpoint(&self, number: u32) -> Checkpoint {
        Checkpoint { number, generation: self.generation, home: Arc::clone(&self.free) }
    }

    /// Asks for legs that fit into a message.
    fn ask_legs(&mut self, legs: &[Leg<'_, Checkpoint>], all: &mut Vec<Arrived<Checkpoint>>) -> Result<(), PlantError> {
        let forget = self.given_back();
        let to: Vec<u32> = {
            let mut free = self.free.lock().unwrap_or_else(PoisonError::into_inner);
            free.unused.extend(&forget);
            legs.iter().map(|_| free.take()).collect()
        };
        let before = all.len();
        all.extend(to.iter().map(|number| (Vec::new(), self.checkpoint(*number))));
        let from = |leg: &Leg<'_, Checkpoint>| match leg.from {
            LegStart::At(saved) => saved.number,
            LegStart::After(number) => all[number].1.number,
        };
        let told = legs.iter().zip(&to);
        let legs = told
            .map(|(leg, to)| {
                let (steps, inputs, reads) = (leg.steps, leg.inputs.clone(), leg.reads);
                message::Leg { from: from(leg), steps, inputs, reads, to: *to }
            })
            .collect::<Vec<_>>();
        let read: Vec<usize> = legs.iter().map(|leg| leg.reads.rows(leg.steps)).collect();
        let steps: usize = legs.iter().map(|leg| leg.steps).sum();
        let count = read.iter().sum();
        let rows = match self.ask(&WorkerRequest::Legs { legs, forget }) {
            Ok(WorkerReply::Rows(rows)) if self.are_rows(&rows, count) => rows,
            Ok(_) => return Err(self.unexpected()),
            Err(error) => {
                self.one_by_one |= error.lost || error.restoring;
                return Err(error);
            }
        };
        self.steps += steps as u64;
        let mut rest = &rows[..];
        for (leg, read) in all[before..].iter_mut().zip(read) {
            let (own, after) = rest.split_at(read * self.output_count());
            (leg.0, rest) = (own.to_vec(), after);
        }
        Ok(())
    }

    /// What a worker is to do after an action.
    fn asked_for(&mut self, then: Then) -> Result<message::Then, PlantError> {
        Ok(match (then, self.saving()) {
            (Then::Fingerprint, _) => message::Then::Fingerprint,
            (Then::Save, Some(how)) => message::Then::Save { number: self.number()?, how },
            (Then::Nothing, _) | (Then::Save, None) => message::Then::Nothing,
        })
    }

    /// Steps on, and does something after the last step.
    fn run(
        &mut self,
        steps: usize,
        inputs: &[f64],
        then: message::Then,
    ) -> Result<(Vec<f64>, Result<message::StateCopyReply, PlantError>), PlantError> {
        let (width, rows) = (self.input_count().max(1), self.output_count().max(1));
        // Long runs go in parts that fit into a message.
        let part = (super::channel::AREA / 32 / width.max(rows)).max(1);
        let (mut trace, mut taken) = (Vec::with_capacity(steps * rows), Ok(message::StateCopyReply::Nothing));
        let mut done = 0;
        while done < steps {
            let now = part.min(steps - done);
            let from = self.put_off.take();
            let inputs = inputs[done * self.input_count()..(done + now) * self.input_count()].to_vec();
            let then = if done + now == steps { then } else { message::Then::Nothing };
            match self.ask(&WorkerRequest::Advance { from, steps: now, inputs, then })? {
                WorkerReply::Stepped { rows, taken: after } if self.are_rows(&rows, now) => {
                    trace.extend(rows);
                    taken = after;
                }
                _ => return Err(self.unexpected()),
            }
            self.steps += now as u64;
            done += now;
        }
        Ok((trace, taken))
    }
}

impl Plant for Isolated {
    type Checkpoint = Checkpoint;

    fn input_count(&self) -> usize {
        self.launcher.setup().inputs.len()
    }

    fn output_count(&self) -> usize {
        self.launcher.setup().columns()
    }

    fn restart(&mut self) -> Result<Vec<f64>, PlantError> {
        // Whoever needs copies may be one who runs once in a process; others begin anew so rarely that it costs nothing.
        if self.is_worn() || matches!(self.keeping, WorkerRestore::Processes | WorkerRestore::ByFork) {
            self.end();
        }
        if self.keeping == WorkerRestore::ByFmu {
            // They belong to the instance that ends here.
            self.lose();
        }
        self.put_off = None;
        match self.ask(&WorkerRequest::Restart)? {
            WorkerReply::Rows(rows) if self.are_rows(&rows, 1) => Ok(rows),
            _ => Err(self.unexpected()),
        }
    }

    fn advance(&mut self, steps: usize, inputs: &[f64]) -> Result<Vec<f64>, PlantError> {
        self.run(steps, inputs, message::Then::Nothing).map(|(rows, _)| rows)
    }

    fn advance_and(&mut self, steps: usize, inputs: &[f64], then: Then) -> Result<Stepped<Checkpoint>, PlantError> {
        let together = steps > 0 && !self.one_by_one && (then != Then::Save || self.saving().is_some());
        if then != Then::Nothing && !together {
            let rows = self.advance(steps, inputs)?;
            let taken = match then {
                Then::Save => self.save().map(StateCopy::Saved),
                _ => self.fingerprint().map(StateCopy::Fingerprint),
            };
            return Ok((rows, taken));
        }
        let put_off = self.put_off.is_some();
        let stepped = self.asked_for(then).and_then(|then| Ok((then, self.run(steps, inputs, then)?)));
        let several = then != Then::Nothing || put_off;
        self.one_by_one |= stepped.as_ref().is_err_and(|error| (several && error.lost) || error.restoring);
        let (then, (rows, taken)) = stepped?;
        let taken = match (then, taken) {
            (message::Then::Nothing, Ok(message::StateCopyReply::Nothing)) => Ok(StateCopy::Nothing),
            (message::Then::Fingerprint, Ok(message::StateCopyReply::Fingerprint(print))) => {
                Ok(StateCopy::Fingerprint(print))
            }
            (message::Then::Save { number, .. }, Ok(message::StateCopyReply::Saved)) => {
                Ok(StateCopy::Saved(self.checkpoint(number)))
            }
            (_, Err(error)) => Err(self.failed(error)),
            _ => Err(self.unexpected()),
        };
        Ok((rows, taken))
    }

    fn advance_each(&mut self, legs: &[Leg<'_, Checkpoint>]) -> Result<Vec<Arrived<Checkpoint>>, PlantError> {
        let mut all = Vec::with_capacity(legs.len());
        if self.keeping != WorkerRestore::ByFmu || self.one_by_one || self.ended_by_us > 0 {
            one_by_one(self, legs, &mut all)?;
            return Ok(all);
        }
        let held = |leg: &Leg<'_, Checkpoint>| match leg.from {
            LegStart::At(saved) => self.holds(saved),
            LegStart::After(_) => true,
        };
        if self.is_worn() || !legs.iter().all(held) {
            self.end();
            return Err(PlantError { lost: true, ..PlantError::of("the FMU's process is replaced") });
        }
        self.put_off = None;
        let row = 8 * self.output_count().max(1);
        let mut next = 0;
        while next < legs.len() {
            let mut bytes = 0;
            // As many as fit into a message, and one in any case.
            let fits = |leg: &&Leg<'_, Checkpoint>| {
                bytes += (row * leg.reads.rows(leg.steps)).max(8 * leg.inputs.len()) + 64;
                bytes <= super::channel::AREA / 4
            };
            let count = legs[next..].iter().take_while(fits).count();
            if count == 0 {
                one_by_one(self, &legs[next..=next], &mut all)?;
                next += 1;
                continue;
            }
            self.ask_legs(&legs[next..next + count], &mut all)?;
            next += count;
        }
        Ok(all)
    }

    fn save(&mut self) -> Result<Checkpoint, PlantError> {
        let how = self.saving().ok_or_else(|| PlantError::of("this plant keeps no states"))?;
        let number = self.number()?;
        match self.ask(&WorkerRequest::Save { number, how })? {
            WorkerReply::Done => Ok(self.checkpoint(number)),
            _ => Err(self.unexpected()),
        }
    }

    fn fingerprint(&mut self) -> Result<Option<Fingerprint>, PlantError> {
        match self.ask(&WorkerRequest::Fingerprint)? {
            WorkerReply::Print(print) => Ok(print),
            _ => Err(self.unexpected()),
        }
    }

    fn restore(&mut self, checkpoint: &Checkpoint) -> Result<(), PlantError> {
        let how = self.saving().ok_or_else(|| PlantError::of("this plant keeps no states"))?;
        if self.is_worn() {
            self.end();
            return Err(PlantError {
                lost: true,
                ..PlantError::of("the FMU's process has had its time and is replaced")
            });
        }
        match self.ask(&WorkerRequest::Restore { number: checkpoint.number, how })? {
            WorkerReply::Done => Ok(()),
            _ => Err(self.unexpected()),
        }
    }

    fn restore_soon(&mut self, checkpoint: &Checkpoint) -> Result<(), PlantError> {
        self.restored += 1;
        // Whoever gave no answer once may do so in restoring, which is no fault of the steps.
        let apart = self.one_by_one || self.ended_by_us > 0 || self.keeping != WorkerRestore::ByFmu;
        if apart || self.restored >= LOOK_AFTER || !self.holds(checkpoint) {
            self.restored = 0;
            return self.restore(checkpoint);
        }
        self.put_off = Some(checkpoint.number);
        Ok(())
    }

    fn holds(&self, checkpoint: &Checkpoint) -> bool {
        checkpoint.generation == self.generation && self.worker.is_some()
    }

    fn stop(&self) -> Stop {
        self.launcher.stop().clone()
    }
}
