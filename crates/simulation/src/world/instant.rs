//! A question about one instant, and its answer: how a person stands, where the robots are and would be had planes told of an arm, and
//! what is unsafe then.

use std::sync::Arc;

use crate::hazard::Contact;
use crate::hazard::criterion::separation::Stopping;
use crate::hazard::finding::ArmPose;
use crate::human::{Place, Posture, Who};
use crate::robot::RobotFrame;

/// The person at the end of a communication step, as far as contacts depend on it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct PersonState {
    /// Who it is.
    pub who: Who,
    /// Where the person stands.
    pub place: Place,
    /// The bend that is tried.
    pub posture: Posture,
    /// How many sub-steps the person got ahead during the step; backwards less than none.
    pub moved: i8,
    /// For each light curtain, how many samples ago it was first broken; 0 for not at all.
    pub broken: Vec<usize>,
    /// Where arms take their time: for so many steps they have not hung any more. Nothing once they may be anywhere.
    pub raised: Option<usize>,
    /// Whether a hazard by contact came before: then clamping alone is asked for.
    pub struck: bool,
}

impl PersonState {
    /// Whether body and arms are the same in both.
    #[must_use]
    pub fn poses_as(&self, other: &Self) -> bool {
        let of = |stance: &Self| (stance.who, stance.place, stance.posture, stance.raised);
        of(self) == of(other)
    }
}

/// An unsafe contact at one instant.
#[derive(Clone, Debug, PartialEq)]
pub struct Hit {
    /// The contact.
    pub contact: Contact,
    /// The arm, if it is one that touches.
    pub arm: Option<ArmPose>,
    /// Programme phase of the robot.
    pub phase: Option<i64>,
    /// Where planes told of the arm: when.
    pub windows: Vec<Window>,
    /// With a hazard by contact, and where clamping counts: the worst clamping at the same instant, which may be another contact.
    pub clamps: Option<Box<Hit>>,
}

impl Hit {
    pub(super) fn new((contact, arm): (Contact, Option<ArmPose>), frame: &RobotFrame) -> Self {
        Self { phase: frame.phase(contact.link), contact, arm, windows: Vec::new(), clamps: None }
    }
}

/// The robots after each step of an action.
pub type Frames = Arc<[Arc<RobotFrame>]>;

/// The samples, counted back from an instant, in which a plane told of an arm: from the `from`th last sample on, until the
/// `until`th last, which is not one of them any more. None if the two are equal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Window {
    /// The plane, by its place in the list of planes.
    pub curtain: usize,
    /// Samples before the instant, that one included.
    pub from: usize,
    /// Samples before the instant, that one not included.
    pub until: usize,
}

/// Something of the run in which planes told of an arm besides.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum IfSignalled<T> {
    /// This is it.
    Is(T),
    /// There is no such run: the windows begin before the start of time.
    BeforeTime,
    /// The FMU could not finish it: what an arm meets in it is not known.
    Unfinished,
}

impl<T> IfSignalled<T> {
    /// The same of something that follows from it.
    pub fn map<U>(self, with: impl FnOnce(T) -> U) -> IfSignalled<U> {
        match self {
            Self::Is(it) => IfSignalled::Is(with(it)),
            Self::BeforeTime => IfSignalled::BeforeTime,
            Self::Unfinished => IfSignalled::Unfinished,
        }
    }
}

/// Tells the robots' motion as it would be at the same instant had planes told of an arm in some windows, each of another
/// plane.
pub trait SignalledRuns {
    /// Why it cannot be told.
    type Error;

    /// The frames of the whole action.
    ///
    /// # Errors
    /// When the FMU fails.
    fn told_of(&mut self, windows: &[Window]) -> Result<IfSignalled<Frames>, Self::Error>;

    /// What a stop takes that is commanded at the instant; nothing where that does not matter.
    ///
    /// # Errors
    /// When the FMU fails.
    fn stopping(&mut self) -> Result<Option<Arc<Stopping>>, Self::Error> {
        Ok(None)
    }
}

/// The robots after step `i` of an action, and what there is to know of them.
pub struct Instant<'a, E> {
    /// After each step of the action.
    pub frames: &'a Frames,
    /// Number of the step in its action.
    pub i: usize,
    /// As they would be had planes told of an arm.
    pub earlier: E,
}

impl<'a, E> Instant<'a, E> {
    /// The robots then.
    pub(super) fn frame(&self) -> &'a RobotFrame {
        &self.frames[self.i]
    }
}
