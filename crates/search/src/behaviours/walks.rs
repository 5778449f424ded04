//! Whether a machine does what its behaviours say, whatever readings come: tried out by walks through them.
//!
//! A walk gives the machine one reading after the other and compares what it shows at each step with the behaviour that its
//! behaviours lead to. So whatever states remember that does not show while one reading is held is found if it shows on some walk: what
//! counts changes by many of them, a clock by long ones, hysteresis and orders of readings by random ones.

use std::collections::VecDeque;

use super::{Begins, Behaviours, Hold, Machine};
use crate::rng::Rng;

/// Readings of a walk, each held for some steps.
pub type Walk = Vec<(usize, usize)>;

/// Of so many changes of a walk in which nothing is held for long, one is followed by a stay in which more shows.
const SHOWS: usize = 100;

/// Kinds of walks: each finds what others do not.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Style {
    /// Another reading at each step: what counts changes.
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
    /// Nothing for most of it, then short stays: clocks.
    Late,
    /// One reading for most of it, then stays of any length: what somebody leaves behind who was there for long.
    Out,
    /// The same stay again and again with hardly anything between: what counts stops that are whole.
    Stops,
    /// A step as likely as some and as very many: what only short stays after long ones show, or long ones after short ones.
    Any,
    /// The same few changes again and again: what counts rounds.
    Rounds,
}

impl Style {
    /// All of them.
    pub const ALL: [Self; 11] = [
        Self::EveryStep,
        Self::Blinks,
        Self::Short,
        Self::Middle,
        Self::Long,
        Self::Phases,
        Self::Late,
        Self::Out,
        Self::Stops,
        Self::Any,
        Self::Rounds,
    ];

    /// A walk of this kind from reading 0 on, of at least so many steps, where states are taken for one after readings were `held` so long.
    /// After that some stays follow in which shows what it left behind. Of some walks each has a number: every other one of [`Self::Rounds`]
    /// goes through all readings, in another order each time.
    #[must_use]
    pub fn drawn(self, rng: &mut Rng, others: &[Vec<usize>], number: usize, (held, steps): (usize, usize)) -> Walk {
        let readings = others.len();
        let (mut walk, mut taken, mut present) = (Walk::new(), 0, 0);
        let phase = 1 + rng.below(held);
        let most = (3 * steps / 4).max(1);
        let mut round = if number.is_multiple_of(2) { readings.max(2) } else { 2 + rng.below(5) };
        let mut order = number / 2;
        let all = steps + steps.min(2 * held);
        while taken < all {
            let stays = walk.len();
            let is_over = taken >= steps;
            let shows = matches!(self, Self::EveryStep | Self::Blinks | Self::Short) && rng.below(SHOWS) == 0;
            let stay = match self {
                Self::Middle => 1 + rng.below(2 * held),
                _ if is_over || shows => 1 + rng.below(2 * held),
                Self::EveryStep => 1,
                Self::Blinks if stays % 2 == 1 => 1 + rng.below(2),
                Self::Short => 1 + rng.below(held.div_ceil(6)),
                Self::Long => 1 + rng.below(20 * held),
                Self::Phases if stays % 2 == 1 => phase,
                Self::Phases => 2 * held + stays / 2,
                Self::Late if stays == 0 => most + rng.below((steps / 8).max(1)),
                Self::Blinks | Self::Late => 1 + rng.below(held),
                Self::Out if (1..readings).contains(&stays) => most.div_ceil(readings - 1),
                Self::Out if stays == readings + 1 => [1, held, held, held][phase % 4],
                Self::Out => any_up_to(4 * held, rng),
                Self::Stops if stays % 2 == 1 => phase,
                Self::Stops => 1 + rng.below(3),
                Self::Any => any_up_to(steps / 2, rng),
                Self::Rounds if stays >= round => walk[stays - round].1,
                Self::Rounds => any_up_to(held, rng),
            };
            walk.push((present, stay));
            taken += stay;
            let mine = &others[present];
            if mine.is_empty() {
                continue;
            }
            let wanted = match self {
                // Of two readings one is that of the start.
                Self::Phases | Self::Blinks | Self::Stops if present != 0 => Some(0),
                Self::Out if stays + 1 < readings => Some(stays + 1),
                Self::Rounds if stays + 1 >= round => Some(walk[stays + 1 - round].0),
                // One that the round did not come to yet, if there is any.
                Self::Rounds if stays + 1 < readings => {
                    let is_new = |other: &&usize| walk.iter().all(|(come_to, _)| come_to != *other);
                    let mut new: Vec<usize> = mine.iter().filter(is_new).copied().collect();
                    new.sort_unstable();
                    (!new.is_empty()).then(|| {
                        let next = new[order % new.len()];
                        order /= new.len();
                        next
                    })
                }
                _ => None,
            };
            let to = |wanted| if wanted == present { Some(wanted) } else { towards(others, present, wanted) };
            let next = wanted.map(|wanted| (wanted, to(wanted)));
            present = match next {
                Some((wanted, Some(next))) => {
                    // On a way round there may be readings between.
                    round += usize::from(self == Self::Rounds && next != wanted);
                    next
                }
                _ => mine[rng.below(mine.len())],
            };
        }
        walk
    }
}

/// What follows a reading first on a shortest way to another; nothing where none leads there.
fn towards(others: &[Vec<usize>], from: usize, to: usize) -> Option<usize> {
    let mut first: Vec<Option<usize>> = vec![None; others.len()];
    let mut open: VecDeque<usize> = VecDeque::new();
    for other in &others[from] {
        first[*other] = Some(*other);
        open.push_back(*other);
    }
    while let Some(next) = open.pop_front().filter(|_| first[to].is_none()) {
        for other in &others[next] {
            if first[*other].is_none() {
                first[*other] = first[next];
                open.push_back(*other);
            }
        }
    }
    first[to]
}

/// From one to so many, small ones as likely as large ones.
fn any_up_to(most: usize, rng: &mut Rng) -> usize {
    let most = most.max(1);
    let halved = rng.below(most.ilog2() as usize + 1);
    1 + rng.below(most >> halved)
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

/// So many holds are asked for at once, each of so many steps at most: what they show is kept until it is compared.
const AT_ONCE: usize = 48;
const PIECE: usize = 100;

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
    let pieces = readings.iter().enumerate().flat_map(|(changes, (reading, steps))| {
        (0..*steps).step_by(PIECE).map(move |from| (changes, *reading, PIECE.min(steps - from)))
    });
    let pieces: Vec<_> = pieces.collect();
    for some in pieces.chunks(AT_ONCE) {
        let hold = |(place, (_, reading, steps)): (usize, &(usize, usize, usize))| Hold {
            from: place.checked_sub(1).map_or(Begins::At(&state), Begins::After),
            reading: *reading,
            steps: *steps,
            last: false,
        };
        let holds: Vec<_> = some.iter().enumerate().map(hold).collect();
        let Some(mut held) = machine.hold_each(&holds)? else { return Ok(Walked::Unfinished) };
        for ((shown, _), (changes, reading, _)) in held.iter().zip(some) {
            let reading = machine.taken_for(*reading);
            for one in shown {
                // Behaviours that were looked for up to some step say nothing of later ones.
                let Some(next) = behaviours.next(number, reading) else { return Ok(Walked::Alike(taken)) };
                let told = [number, next].map(|number| behaviours.shown(number));
                (number, taken) = (next, taken + 1);
                let unlike = Ok(Walked::Unlike { steps: taken, changes: *changes });
                if machine.alike(*one, told[1]) {
                    // Where rounding decides in which of two steps something switches, it does so by the step after.
                    if doubt.take().is_some_and(|(one, before)| !machine.switches(one, [before, told[0], told[1]])) {
                        return unlike;
                    }
                } else if doubt.replace((*one, told[0])).is_some() {
                    return unlike;
                }
            }
        }
        if let Some((_, after)) = held.pop() {
            state = after;
        }
    }
    Ok(Walked::Alike(taken))
}
