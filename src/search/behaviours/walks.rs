//! Whether a machine does what its behaviours say, whatever readings come: tried out by walks through them.
//!
//! A walk gives the machine one reading after the other and compares what it shows at each step with the behaviour that its
//! behaviours lead to. So whatever states remember that does not show while one reading is held is found if it shows on some walk: what
//! counts changes by many of them, a clock by long ones, hysteresis and orders of readings by random ones.

use super::{Behaviours, Machine};
use crate::search::rng::Rng;

/// Readings of a walk, each held for some steps.
pub type Walk = Vec<(usize, usize)>;

/// Kinds of walks: each finds what others do not.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Style {
    /// Another reading at each step, and some stays after that in which it would show: what counts changes.
    EveryStep,
    /// One reading again and again for a step or two, at changing distances: what an edge sets and the next one does not.
    Blinks,
    /// Stays of a few steps: orders of readings, and what a timer that was cut short leaves behind.
    Short,
    /// Stays about as long as readings are held before states are taken for one: timers and ramps that end just then.
    Middle,
    /// Stays of many times as long.
    Long,
    /// The same change again and again, a step later each time: each phase of what the machine does by itself.
    Phases,
    /// Nothing for long, then short stays: clocks.
    Late,
}

impl Style {
    /// All of them.
    pub const ALL: [Self; 7] =
        [Self::EveryStep, Self::Blinks, Self::Short, Self::Middle, Self::Long, Self::Phases, Self::Late];

    /// A walk of this kind from reading 0 on, of at least so many steps, where states are taken for one after readings were `held` so long.
    #[must_use]
    pub fn drawn(self, rng: &mut Rng, readings: usize, held: usize, steps: usize) -> Walk {
        let (mut walk, mut taken, mut present) = (Walk::new(), 0, 0);
        let phase = 1 + rng.below(held);
        let quiet = rng.below(steps.max(1));
        while taken < steps {
            let number = walk.len();
            let stay = match self {
                Self::EveryStep if taken + 4 * held < steps => 1,
                Self::Blinks if number % 2 == 1 => 1 + rng.below(2),
                Self::Blinks => 1 + rng.below(held),
                Self::Short => 1 + rng.below(held.div_ceil(6)),
                Self::Middle | Self::EveryStep => 1 + rng.below(2 * held),
                Self::Long => 1 + rng.below(20 * held),
                Self::Phases if number % 2 == 1 => phase,
                Self::Phases => 2 * held + number / 2,
                Self::Late if number == 0 => quiet + 1,
                Self::Late => 1 + rng.below(held),
            };
            walk.push((present, stay));
            taken += stay;
            if readings > 1 {
                present = match self {
                    // Of two readings one is that of the start.
                    Self::Phases | Self::Blinks if present != 0 => 0,
                    _ => (present + 1 + rng.below(readings - 1)) % readings,
                };
            }
        }
        walk
    }
}

/// How a walk came out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Walked {
    /// As behaviours say, for so many steps.
    Alike(usize),
    /// What was shown after so many steps is something else; so often had readings changed.
    Unlike {
        /// Steps.
        steps: usize,
        /// Changes.
        changes: usize,
    },
    /// A step could not be finished.
    Unfinished,
}

/// Walks from the start.
///
/// # Errors
/// What the machine reports.
pub fn walk<M: Machine>(
    machine: &mut M,
    behaviours: &Behaviours,
    readings: &[(usize, usize)],
) -> Result<Walked, M::Error> {
    let (mut state, shown) = machine.begin()?;
    let (mut number, mut taken, mut doubt) = (0, 0, None);
    if !machine.alike(shown, behaviours.shown(number)) {
        return Ok(Walked::Unlike { steps: 0, changes: 0 });
    }
    for (changes, (reading, steps)) in readings.iter().enumerate() {
        let Some((shown, after)) = machine.hold(&state, *reading, *steps)? else { return Ok(Walked::Unfinished) };
        for one in shown {
            // Behaviours that were looked for up to some step say nothing of later ones.
            let Some(next) = behaviours.next(number, *reading) else { return Ok(Walked::Alike(taken)) };
            let told = [number, next].map(|number| behaviours.shown(number));
            (number, taken) = (next, taken + 1);
            let unlike = Ok(Walked::Unlike { steps: taken, changes });
            if machine.alike(one, told[1]) {
                // Where rounding decides in which of two steps something switches, it does so by the step after.
                if doubt.take().is_some_and(|(one, before)| !machine.switches(one, [before, told[0], told[1]])) {
                    return unlike;
                }
            } else if doubt.replace((one, told[0])).is_some() {
                return unlike;
            }
        }
        state = after;
    }
    Ok(Walked::Alike(taken))
}
