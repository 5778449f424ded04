//! Whether the behaviours of a machine stand for all of its histories: for how long readings are held before states are taken for one, that
//! there are no more than can be counted, and that walks show nothing else.

use std::ops::ControlFlow;

use super::shows::{Shows, ends, shows};
use super::walks::{Style, Walked, walk};
use super::{BehaviourSearchEnd, Behaviours, Extent, Machine, find, longest};
use crate::rng::Rng;

/// So long is looked ahead at first, and at most, for what shows late, s.
pub const AHEAD_S: [f64; 2] = [3.0, 12.0];
/// A reading is held for so long at least before states are taken for one, s, and longer by this part than what shows latest.
const HELD_S: f64 = 0.5;
const LONGER: f64 = 0.25;
/// So many times as long, one after the other, where walks show something else.
pub const TIMES_HELD: [usize; 3] = [1, 2, 4];
/// Walks of each style, by how many times as long as is looked, and how many of them.
const WALKS: [(usize, usize); 3] = [(LONGER_WALKS, 1), (10, 2), (1, 21)];
/// The longest are so many times as long.
pub const LONGER_WALKS: usize = 30;
/// Where more than this part of histories end in places of their own, of some histories at least, there are more behaviours than can be
/// counted, %.
const MOST_DIFFERENT: usize = 80;
const FEWEST_ENDS: usize = 20;

/// What is asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DecisionLimits {
    /// How long a step is, s.
    pub step_s: f64,
    /// So many steps from the start are looked at.
    pub steps: usize,
    /// So many behaviours at most.
    pub most: usize,
    /// Readings are held for so many times as long as what shows latest asks for: see [`TIMES_HELD`].
    pub times_held: usize,
}

/// How far it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Now {
    /// It is known for how long readings are held; behaviours are looked for next.
    Held,
    /// So many behaviours so far.
    Behaviours(usize),
    /// A walk was walked; there are so many behaviours.
    Walked(usize),
}

/// Why it ends before all is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Enough {
    /// There was only so much time for it.
    NotInTime,
    /// Somebody asked for that.
    Asked,
}

/// Is told how far it is, and may end it.
pub(crate) type Tell<'a> = dyn FnMut(Now) -> ControlFlow<Enough> + 'a;

/// Behaviours that stand for all histories.
#[derive(Clone, Debug)]
pub struct Decided {
    /// All of them.
    pub behaviours: Behaviours,
    /// What was seen of what shows late.
    pub shows: Shows,
    /// By reading, for so many steps it was held.
    pub held: Vec<usize>,
    /// So many walks showed nothing else.
    pub walks: usize,
}

/// Why they do not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Why {
    /// Something shows later than is looked, see [`AHEAD_S`].
    ShowsLate,
    /// So many of so many histories ended in different places.
    HardlyEverSame {
        /// Different places.
        different: usize,
        /// Histories.
        ends: usize,
    },
    /// There are more behaviours than allowed.
    TooMany,
    /// Time was over when there were so many.
    NotInTime(usize),
    /// Some steps could not be finished.
    Unfinished,
    /// Asked to end.
    Asked,
    /// A walk showed something else.
    RemembersMore {
        /// Of what kind the walk was.
        style: Style,
        /// For so many steps readings were held.
        held: usize,
        /// After so many steps of the walk.
        steps: usize,
        /// So often readings had changed.
        changes: usize,
    },
}

/// What is found, or why not; an error of the machine ends everything.
pub type DecisionResult<T, E> = Result<Result<T, Why>, E>;

/// All behaviours of a machine, if they stand for all of its histories.
///
/// # Errors
/// What the machine reports.
pub fn decide<M: Machine>(
    machine: &mut M,
    question: DecisionLimits,
    rng: &mut Rng,
    tell: &mut Tell<'_>,
) -> DecisionResult<Decided, M::Error> {
    decide_keeping(machine, question, rng, (&mut None, tell))
}

/// The same; what was found is kept where it does not stand for all.
///
/// # Errors
/// What the machine reports.
pub fn decide_keeping<M: Machine>(
    machine: &mut M,
    question: DecisionLimits,
    rng: &mut Rng,
    (kept, tell): (&mut Option<Behaviours>, &mut Tell<'_>),
) -> DecisionResult<Decided, M::Error> {
    let (shows, held) = match held_for(machine, question, rng)? {
        Ok(held) => held,
        Err(why) => return Ok(Err(why)),
    };
    if let Err(why) = comes_back(machine, (question.steps, shows.ahead), rng)? {
        return Ok(Err(why));
    }
    let behaviours = match closed(machine, question, &held, (kept, tell))? {
        Ok(found) => found,
        Err(why) => return Ok(Err(why)),
    };
    machine.tell_apart(true);
    let walked = walked(machine, question, (&behaviours, longest(&held)), rng, tell);
    machine.tell_apart(false);
    match walked? {
        Ok(walks) => Ok(Ok(Decided { behaviours, shows, held, walks })),
        Err(why) => {
            *kept = Some(behaviours);
            Ok(Err(why))
        }
    }
}

/// For how many steps each reading is held before states are taken for one, by what shows latest.
///
/// # Errors
/// What the machine reports.
pub fn held_for<M: Machine>(
    machine: &mut M,
    DecisionLimits { step_s, steps, times_held, .. }: DecisionLimits,
    rng: &mut Rng,
) -> DecisionResult<(Shows, Vec<usize>), M::Error> {
    let mut ahead = steps_of(AHEAD_S[0], step_s);
    let shown = loop {
        let Some(shown) = shows(machine, rng, (steps, ahead))? else { return Ok(Err(Why::Unfinished)) };
        if 5 * longest(&shown.steps) <= 4 * ahead {
            break shown;
        }
        if ahead >= steps_of(AHEAD_S[1], step_s) {
            return Ok(Err(Why::ShowsLate));
        }
        ahead *= 2;
    };
    let held = |shown: &usize| times_held * steps_of(HELD_S.max(seconds(*shown, step_s) * (1.0 + LONGER)), step_s);
    let held = shown.steps.iter().map(held).collect();
    Ok(Ok((shown, held)))
}

/// Whether a machine may come back to just the same, by where histories end.
fn comes_back<M: Machine>(machine: &mut M, within: (usize, usize), rng: &mut Rng) -> DecisionResult<(), M::Error> {
    let Some((ends, different)) = ends(machine, rng, within)? else { return Ok(Err(Why::Unfinished)) };
    let is_lost = ends >= FEWEST_ENDS && 100 * different > MOST_DIFFERENT * ends;
    Ok(if is_lost { Err(Why::HardlyEverSame { different, ends }) } else { Ok(()) })
}

/// All behaviours, if there are not too many; those that were found are kept otherwise.
fn closed<M: Machine>(
    machine: &mut M,
    DecisionLimits { most, .. }: DecisionLimits,
    held: &[usize],
    (kept, tell): (&mut Option<Behaviours>, &mut Tell<'_>),
) -> DecisionResult<Behaviours, M::Error> {
    let mut enough = tell(Now::Held).break_value();
    let found = find(machine, Extent { held, steps: usize::MAX, most }, &mut |behaviours| {
        enough = enough.or_else(|| tell(Now::Behaviours(behaviours)).break_value());
        if enough.is_some() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    })?;
    let why = match found.ended {
        BehaviourSearchEnd::Closed | BehaviourSearchEnd::Steps => return Ok(Ok(found)),
        BehaviourSearchEnd::Most => Why::TooMany,
        BehaviourSearchEnd::Unfinished => Why::Unfinished,
        BehaviourSearchEnd::Asked if enough == Some(Enough::NotInTime) => Why::NotInTime(found.count()),
        BehaviourSearchEnd::Asked => Why::Asked,
    };
    *kept = Some(found);
    Ok(Err(why))
}

/// Of each walk its kind, which of those of its kind it is, and for how many steps it goes on, if so many are looked at.
pub fn each_walk(steps: usize) -> impl Iterator<Item = (Style, usize, usize)> {
    let long =
        move || WALKS.iter().flat_map(move |(times, walks)| std::iter::repeat_n(times * steps, *walks)).enumerate();
    Style::ALL.into_iter().flat_map(move |style| long().map(move |(number, long)| (style, number, long)))
}

/// Tries out whether a machine does what its behaviours say, held for so many steps: how many walks that was.
fn walked<M: Machine>(
    machine: &mut M,
    DecisionLimits { steps, .. }: DecisionLimits,
    (found, held): (&Behaviours, usize),
    rng: &mut Rng,
    tell: &mut Tell<'_>,
) -> DecisionResult<usize, M::Error> {
    let (mut walked, others) = (0, machine.others());
    for (style, number, long) in each_walk(steps) {
        let drawn = style.drawn(rng, &others, number, (held, long));
        match walk(machine, found, &drawn)? {
            Walked::Alike(_) => walked += 1,
            Walked::Unfinished => return Ok(Err(Why::Unfinished)),
            Walked::Unlike { steps, changes } => {
                return Ok(Err(Why::RemembersMore { style, held, steps, changes }));
            }
        }
        if tell(Now::Walked(found.count())).is_break() {
            return Ok(Err(Why::Asked));
        }
    }
    Ok(Ok(walked))
}

/// Steps that take so long.
#[must_use]
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some seconds")]
pub fn steps_of(time_s: f64, step_s: f64) -> usize {
    (time_s / step_s - 1e-9).ceil().max(1.0) as usize
}

#[expect(clippy::cast_precision_loss, reason = "some thousand")]
fn seconds(steps: usize, step_s: f64) -> f64 {
    steps as f64 * step_s
}
