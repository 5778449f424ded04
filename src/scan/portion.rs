//! A part of an exhaustive search: the same way through the cell, with a share of the questions whether a person can be touched.
//! It finds no hazard and certifies nothing; what it answers is looked up when the whole search is run.

use std::ops::ControlFlow;
use std::sync::Arc;

use super::execution::ExecutionMode;
use super::hosting::StateChoice;
use super::options::{Exhaustive, Progress, ScanError};
use super::prepare::Prepared;
use crate::search::exhaustive::{SearchEvent, Stopped, exhaust};
use crate::sequences::Expander;
use crate::sim::answers::{Answers, Share};

/// What is answered to the questions of `share`; nothing if it was told to stop.
///
/// # Errors
/// When the FMU fails.
pub(crate) fn portion(
    prepared: &Prepared,
    how: Exhaustive,
    share: Share,
    tell: &mut dyn FnMut(Progress<'_>) -> ControlFlow<()>,
) -> Result<Option<Arc<Answers>>, ScanError> {
    let footing = ExecutionMode::asked(prepared, StateChoice::Auto, how.merge);
    let (cell, binding) = (Arc::clone(&prepared.cell), Arc::clone(&prepared.binding));
    let answers = Arc::new(Answers::in_memory(share));
    let (plant, policy) = (footing.plant(prepared), footing.policy(prepared));
    let mut expander = Expander::new(cell, binding, plant, policy, footing.merge, how.workers)
        .map_err(|cause| ScanError { cause })?
        .with_answers(Arc::clone(&answers));
    let account = exhaust(&mut expander, how.budget, &mut |told| match told {
        SearchEvent::Progress { depth, done, of, cost } => tell(Progress::Level { depth, done, of, hazards: 0, cost }),
        SearchEvent::Working | SearchEvent::UnsafeState(_) | SearchEvent::Noted { .. } | SearchEvent::Failed { .. } => {
            tell(Progress::Working)
        }
    });
    match account {
        Ok(account) if account.stopped == Stopped::Asked => Ok(None),
        // As far as the budget goes: what is left is worked out by whoever needs it.
        Ok(_) => Ok(Some(answers)),
        Err(cause) if cause.stopped => Ok(None),
        Err(cause) => Err(ScanError { cause }),
    }
}
