//! The robots at an instant, as they are and as they would be had planes told of an arm: each once, whichever actions lead
//! to it.

use std::collections::BTreeMap;
use std::convert::Infallible;
use std::hash::Hash as _;
use std::mem::discriminant;
use std::sync::{Arc, OnceLock};

use super::{Expander, Pending, Transition};
use crate::hazard::criterion::separation::Stopping;
use crate::host::{NodeId, Plant, PlantError};
use crate::human::Place;
use crate::human::walk::WalkTrace;
use crate::sim::answers::{Digest, Key};
use crate::sim::robots::{Instead, Shadow};
use crate::sim::world::{Asked, Frames, IfSignalled, SignalledRuns, Window};

/// The robots at an instant, and as they would be had planes told of an arm.
pub(super) struct Situation {
    /// Whether any of them is fast enough to harm, or not known.
    may_harm: bool,
    pub(super) frames: Frames,
    pub(super) i: usize,
    /// By the windows in which they told.
    earlier: BTreeMap<Vec<Window>, IfSignalled<Frames>>,
    /// What a stop takes from then on, where separation counts.
    stopping: Option<Arc<Stopping>>,
    key: OnceLock<Key>,
}

impl Situation {
    /// What answers follow from: the FMU's outputs at the instant, as it was and as it would have been.
    pub(super) fn key(&self) -> &Key {
        // May harm follows from the rest.
        let Self { may_harm: _, frames, i, earlier, stopping, key } = self;
        key.get_or_init(|| {
            let mut digest = Digest::default();
            digest.numbers(frames[*i].outputs());
            for (windows, told) in earlier {
                (windows, discriminant(told)).hash(&mut digest);
                if let IfSignalled::Is(frames) = told {
                    digest.numbers(frames[*i].outputs());
                }
            }
            stopping.as_deref().map(bits_of).hash(&mut digest);
            digest.key()
        })
    }
}

/// What tells stops apart.
fn bits_of(Stopping { time_s, travel_m }: &Stopping) -> Vec<u64> {
    std::iter::once(*time_s).chain(travel_m.iter().copied()).map(f64::to_bits).collect()
}

impl SignalledRuns for &Situation {
    type Error = Infallible;

    fn stopping(&mut self) -> Result<Option<Arc<Stopping>>, Infallible> {
        Ok(self.stopping.clone())
    }

    fn told_of(&mut self, windows: &[Window]) -> Result<IfSignalled<Frames>, Infallible> {
        Ok(self.earlier.get(windows).cloned().unwrap_or(IfSignalled::BeforeTime))
    }
}

/// Situations that differ.
#[derive(Default)]
pub(super) struct Situations {
    /// What may be asked of planes, each list of windows once, by what it follows from.
    asked: BTreeMap<Vec<Asked>, usize>,
    windows: Vec<Vec<Vec<Window>>>,
    /// By the number of the windows, then those of the frames.
    numbers: BTreeMap<(usize, Vec<u32>, Vec<u64>), usize>,
    /// At one step, by node, the number of the windows, and whether a sensor reports somebody.
    known: BTreeMap<(NodeId, usize, bool), usize>,
    pub(super) all: Vec<Situation>,
}

impl Situations {
    /// The number of the windows that may be asked for.
    fn windows(&mut self, asked: Vec<Asked>, neighbours: &[(usize, usize)]) -> usize {
        if let Some(number) = self.asked.get(&asked) {
            return *number;
        }
        self.windows.push(Asked::windows(&asked, neighbours));
        self.asked.insert(asked, self.windows.len() - 1);
        self.windows.len() - 1
    }
}

/// Stands for the robots of a run that the FMU could not finish, and of one that would begin before the start of time.
const UNFINISHED: u32 = u32::MAX - 1;
const BEFORE_TIME: u32 = u32::MAX;

impl<P: Plant> Expander<P> {
    /// The number of the situation after step `i` of a transition, for a person at this place.
    fn situation(
        &mut self,
        transition: &Transition,
        i: usize,
        place: &Place,
        situations: &mut Situations,
    ) -> Result<usize, PlantError> {
        let asked = self.world.first.windows_that_may_matter(place, &transition.sensed.broken[i]);
        let asked = situations.windows(asked, &self.world.first.neighbours);
        let told = self.world.any_reports(&transition.sensed.readings[i], &transition.frames[i]);
        if let Some(number) = situations.known.get(&(transition.node, asked, told)) {
            return Ok(*number);
        }
        let stopping = self.robots.stopping(transition.node, i, told)?;
        let windows = &situations.windows[asked];
        let mut shadows: Vec<Shadow> = Vec::with_capacity(windows.len());
        let mut numbers = vec![self.robots.moved(transition.node).numbers[i]];
        for windows in windows {
            let shadow = Instead::new(&mut self.robots, transition.node, i, told).node_for(windows)?;
            numbers.push(match &shadow {
                Shadow::Is(node) => self.robots.moved(*node).numbers[i],
                Shadow::Unfinished => UNFINISHED,
                Shadow::BeforeTime => BEFORE_TIME,
            });
            shadows.push(shadow);
        }
        let stop = stopping.as_deref().map(bits_of).unwrap_or_default();
        let key = (asked, numbers, stop);
        let number = match situations.numbers.get(&key) {
            Some(number) => *number,
            None => {
                let mut told = |shadow: Shadow| shadow.map(|node| self.robots.frames(node));
                let earlier: BTreeMap<_, _> = windows.iter().cloned().zip(shadows.into_iter().map(&mut told)).collect();
                let told_may_harm = |told: &IfSignalled<Frames>| match told {
                    IfSignalled::Is(frames) => frames[i].may_harm,
                    IfSignalled::BeforeTime => false,
                    IfSignalled::Unfinished => true,
                };
                let may_harm = transition.frames[i].may_harm || earlier.values().any(told_may_harm);
                let frames = Arc::clone(&transition.frames);
                situations.all.push(Situation { may_harm, frames, i, earlier, stopping, key: OnceLock::new() });
                situations.numbers.insert(key, situations.all.len() - 1);
                situations.all.len() - 1
            }
        };
        situations.known.insert((transition.node, asked, told), number);
        Ok(number)
    }

    /// For each pending action the situation after step `i`, where anything could harm in it.
    pub(super) fn asked<'a>(
        &mut self,
        i: usize,
        pending: &[Pending],
        transitions: &[Vec<Transition>],
        walked: &dyn Fn(&Pending) -> &'a WalkTrace,
        situations: &mut Situations,
    ) -> Result<Vec<Option<usize>>, PlantError> {
        situations.known.clear();
        // Postures of a walk mostly share the transition: then the situation is the same.
        let mut last = None;
        let mut asked = Vec::with_capacity(pending.len());
        for p in pending {
            let situation = match last {
                Some((state, transition, known)) if (state, transition) == (p.state, p.transition) => known,
                _ => {
                    let transition = &transitions[p.state][p.transition];
                    // Without light curtains nothing but the present matters.
                    let harmless = self.world.first.curtains.is_empty() && !transition.frames[i].may_harm;
                    let situation = match harmless {
                        true => None,
                        false => Some(self.situation(transition, i, &walked(p).places[i], situations)?),
                    };
                    situation.filter(|s| situations.all[*s].may_harm)
                }
            };
            last = Some((p.state, p.transition, situation));
            self.coverage.contact_checks += u64::from(situation.is_none());
            asked.push(situation);
        }
        Ok(asked)
    }
}
