//! The tasks of a shard, as many at a time as there are threads. What is done is left out; what is stopped leaves nothing behind.

use std::ops::ControlFlow;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

use super::manifest::{Manifest, Task};
use super::part::Runner;
use super::{CampaignError, sealed};
use crate::scan::Hosting;
use crate::stop::Stop;

/// Which tasks.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Which {
    /// All of them.
    All,
    /// Those of a shard, from 1, of so many: every so manyth task, so that neighbours go to different shards.
    Shard(usize, usize),
    /// Those of these names.
    Named(Vec<String>),
}

/// What is told meanwhile.
pub enum CampaignEvent<'a> {
    /// A task has its result already.
    Skipped,
    /// A task begins.
    TaskStarted(&'a str, &'a str),
    /// A task has ended after so many seconds.
    Done(&'a str, f64),
    /// A task has failed; the others go on.
    Failed(&'a str, CampaignError),
}

/// What became of the tasks.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Ran {
    /// Done now.
    pub done: usize,
    /// Done before.
    pub skipped: usize,
    /// Failed.
    pub failed: usize,
    /// Whether somebody stopped it.
    pub stopped: bool,
}

impl Which {
    /// The tasks of a plan that these are.
    ///
    /// # Errors
    /// When there is no task of a name.
    pub(crate) fn tasks(&self, manifest: &Manifest) -> Result<Vec<Task>, CampaignError> {
        match self {
            Self::All => Ok(manifest.tasks()),
            Self::Shard(number, of) => {
                let all = manifest.tasks().into_iter().skip(number.saturating_sub(1));
                Ok(all.step_by((*of).max(1)).collect())
            }
            Self::Named(names) => names.iter().map(|name| manifest.task(name)).collect(),
        }
    }
}

/// Does these tasks with so many threads, and keeps each result when it is there.
///
/// # Errors
/// When a result cannot be written. What goes wrong in one task is told and hinders no other.
pub(crate) fn run(
    folder: &Path,
    manifest: &Manifest,
    tasks: &[Task],
    hosting: &Hosting,
    (workers, stop): (usize, &Stop),
    tell: &(dyn Fn(CampaignEvent<'_>) + Sync),
) -> Result<Ran, CampaignError> {
    let workers = workers.max(1);
    let (next, mut ran) = (AtomicUsize::new(0), Ran::default());
    // A task alone has all threads; of many each has one.
    let at_a_time = workers.min(tasks.len()).max(1);
    let per_task = workers.div_ceil(at_a_time);
    let work = || -> Result<Ran, CampaignError> {
        let mut runner = Runner::new(folder, manifest, hosting, per_task, stop.clone());
        let mut own = Ran::default();
        while !stop.is_asked() {
            let Some(&task) = tasks.get(next.fetch_add(1, Ordering::Relaxed)) else { break };
            let name = manifest.name(task);
            if matches!(sealed::kept(folder, &name), sealed::Kept::Whole(..)) {
                own.skipped += 1;
                tell(CampaignEvent::Skipped);
                continue;
            }
            tell(CampaignEvent::TaskStarted(&name, &manifest.words(task.scan)));
            let began = Instant::now();
            let mut go_on = |_: crate::scan::Progress<'_>| match stop.ends_search() {
                true => ControlFlow::Break(()),
                false => ControlFlow::Continue(()),
            };
            match runner.result(task, &mut go_on) {
                Ok(Some(bytes)) => {
                    let seconds = began.elapsed().as_secs_f64();
                    sealed::keep(folder, &name, &bytes, seconds)?;
                    own.done += 1;
                    tell(CampaignEvent::Done(&name, seconds));
                }
                Ok(None) => break,
                Err(_) if stop.is_asked() => break,
                Err(error @ CampaignError::Machine { .. }) => return Err(error),
                Err(error) => {
                    own.failed += 1;
                    tell(CampaignEvent::Failed(&name, error));
                }
            }
        }
        Ok(own)
    };
    std::thread::scope(|scope| {
        let threads: Vec<_> = (0..at_a_time).map(|_| scope.spawn(work)).collect();
        for thread in threads {
            let own = thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))?;
            ran.done += own.done;
            ran.skipped += own.skipped;
            ran.failed += own.failed;
        }
        Ok::<_, CampaignError>(())
    })?;
    ran.stopped = stop.is_asked();
    Ok(ran)
}
