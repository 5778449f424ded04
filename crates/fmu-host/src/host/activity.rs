//! What a plant is doing just now, readable from outside while it does it: so a crash or a hang has a place and a time.

use std::fmt;
use std::sync::atomic::{AtomicU64, Ordering};

/// A kind of call.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Call {
    /// Nothing of the FMU runs.
    None,
    /// The binary is loaded.
    Load,
    /// An instance is made.
    Instantiate,
    /// It is initialised.
    Initialise,
    /// Inputs are written.
    Write,
    /// A step is made.
    Step,
    /// Outputs are read.
    Read,
    /// The state is saved.
    Save,
    /// The state is restored.
    Restore,
    /// A state is serialised or brought back from its bytes.
    Serialize,
    /// The instance is reset.
    Reset,
    /// An instance is freed.
    Free,
}

const CALLS: [(Call, &str); 12] = [
    (Call::None, "between two calls"),
    (Call::Load, "while its binary was loaded"),
    (Call::Instantiate, "while it was instantiated"),
    (Call::Initialise, "during initialisation"),
    (Call::Write, "while inputs were set"),
    (Call::Step, "in a step"),
    (Call::Read, "while outputs were read"),
    (Call::Save, "while its state was saved"),
    (Call::Restore, "while a state was restored"),
    (Call::Serialize, "while a state was serialised"),
    (Call::Reset, "while it was reset"),
    (Call::Free, "while an instance was freed"),
];

/// The call that is under way, and in which step: one word that others may read at any time.
#[derive(Clone, Copy)]
pub struct Activity(&'static AtomicU64);

/// What was read from an [`Activity`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Doing {
    /// The call.
    pub call: Call,
    /// Communication steps made before.
    pub step: u64,
    /// Changes with every call.
    pub stamp: u64,
}

/// Bits for the step and for the running number.
const STEP_BITS: u32 = 32;

impl Activity {
    /// One that is written to `word`.
    pub(super) const fn new(word: &'static AtomicU64) -> Self {
        Self(word)
    }

    /// One that nobody reads.
    #[must_use]
    pub fn unseen() -> Self {
        static WORD: AtomicU64 = AtomicU64::new(0);
        Self(&WORD)
    }

    /// A call begins.
    pub(super) fn begin(self, call: Call, step: u64) {
        let number = self.0.load(Ordering::Relaxed) >> (STEP_BITS + 4);
        let step = step & ((1 << STEP_BITS) - 1);
        let kind = call as u64;
        self.0.store(((number + 1) << (STEP_BITS + 4)) | (step << 4) | kind, Ordering::Relaxed);
    }

    /// Calls of the FMU are over for now.
    pub(super) fn end(self) {
        self.begin(Call::None, 0);
    }
}

impl Doing {
    /// What a word of [`Activity`] says.
    pub(super) fn of(word: u64) -> Self {
        let kind = usize::try_from(word & 15).unwrap_or(0);
        let call = CALLS.get(kind).map_or(Call::None, |(call, _)| *call);
        Self { call, step: (word >> 4) & ((1 << STEP_BITS) - 1), stamp: word }
    }
}

impl fmt::Display for Call {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let words = CALLS.iter().find(|(call, _)| call == self).map_or("", |(_, words)| words);
        f.write_str(words)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tells_call_and_step_and_that_something_happens() {
        static WORD: AtomicU64 = AtomicU64::new(0);
        let activity = Activity::new(&WORD);
        let mut stamps = Vec::new();
        for (call, _) in CALLS {
            for step in [0, 7, 4_000_000_000] {
                activity.begin(call, step);
                let doing = Doing::of(WORD.load(Ordering::Relaxed));
                assert_eq!((doing.call, doing.step), (call, step));
                assert!(!stamps.contains(&doing.stamp));
                stamps.push(doing.stamp);
            }
        }
    }
}
