//! The robots at an instant, as they are and as they would be had planes told of an arm: each once, whichever actions lead
//! to it.

use std::collections::BTreeMap;
use std::convert::Infallible;
use std::sync::Arc;

use super::{Expander, Pending, Transition};
use crate::host::{NodeId, Plant, PlantError};
use crate::human::Place;
use crate::human::walk::WalkTrace;
use crate::sim::robots::{Instead, Shadow};
use crate::sim::world::{Asked, Earlier, Frames, HadTold, Window};

/// The robots at an instant, and as they would be had planes told of an arm.
pub(super) struct Situation {
    /// Whether any of them is fast enough to harm, or not known.
    may_harm: bool,
    pub(super) frames: Frames,
    pub(super) i: usize,
    /// By the windows in which they told.
    earlier: BTreeMap<Vec<Window>, HadTold<Frames>>,
}

impl Earlier for &Situation {
    type Error = Infallible;

    fn told_of(&mut self, windows: &[Window]) -> Result<HadTold<Frames>, Infallible> {
        Ok(self.earlier.get(windows).cloned().unwrap_or(HadTold::BeforeTime))
    }
}

/// Numbers the rows of robot frames that differ.
#[derive(Default)]
struct Rows {
    numbers: BTreeMap<Vec<u64>, u32>,
    of_node: BTreeMap<NodeId, Arc<[u32]>>,
}

/// Situations that differ.
#[derive(Default)]
pub(super) struct Situations {
    rows: Rows,
    /// By the numbers of their rows, and the windows that these belong to.
    numbers: BTreeMap<(Vec<u32>, Vec<Asked>), usize>,
    /// By node, step and the windows of planes.
    known: BTreeMap<(NodeId, usize, Vec<Asked>), usize>,
    pub(super) all: Vec<Situation>,
}

impl Rows {
    fn of(&mut self, node: NodeId, frames: &Frames) -> Arc<[u32]> {
        if let Some(known) = self.of_node.get(&node) {
            return Arc::clone(known);
        }
        let numbers = &mut self.numbers;
        let number = |outputs: &[f64]| {
            let next = u32::try_from(numbers.len()).unwrap_or(u32::MAX);
            *numbers.entry(outputs.iter().map(|v| v.to_bits()).collect()).or_insert(next)
        };
        let rows: Arc<[u32]> = frames.iter().map(|f| f.outputs()).map(number).collect();
        self.of_node.insert(node, Arc::clone(&rows));
        rows
    }
}

impl<P: Plant> Expander<P> {
    /// The number of the situation after step `i` of a transition, for a person at this place.
    pub(super) fn situation(
        &mut self,
        transition: &Transition,
        i: usize,
        place: &Place,
        situations: &mut Situations,
    ) -> Result<usize, PlantError> {
        let asked = self.world.windows_that_may_matter(place, &transition.sensed.broken[i]);
        let question = (transition.node, i, asked);
        if let Some(number) = situations.known.get(&question) {
            return Ok(*number);
        }
        let mut rows = vec![situations.rows.of(transition.node, &transition.frames)[i]];
        let mut earlier = BTreeMap::new();
        for windows in Asked::windows(&question.2, &self.world.neighbours) {
            let shadow = Instead::new(&mut self.robots, transition.node, i).node_for(&windows)?;
            let frames = shadow.clone().map(|node| self.robots.frames(node));
            rows.push(match (&shadow, &frames) {
                (Shadow::Is(node), HadTold::Is(frames)) => situations.rows.of(*node, frames)[i],
                (Shadow::Unfinished, _) => u32::MAX - 1,
                _ => u32::MAX,
            });
            earlier.insert(windows, frames);
        }
        let key = (rows, question.2.clone());
        let all = &mut situations.all;
        let number = *situations.numbers.entry(key).or_insert_with(|| {
            let told_may_harm = |told: &HadTold<Frames>| match told {
                HadTold::Is(frames) => frames[i].may_harm,
                HadTold::BeforeTime => false,
                HadTold::Unfinished => true,
            };
            let may_harm = transition.frames[i].may_harm || earlier.values().any(told_may_harm);
            all.push(Situation { may_harm, frames: Arc::clone(&transition.frames), i, earlier });
            all.len() - 1
        });
        situations.known.insert(question, number);
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
        // Postures of a walk mostly share the transition: then the situation is the same.
        let mut last = None;
        let mut asked = Vec::with_capacity(pending.len());
        for p in pending {
            let situation = match last {
                Some((state, transition, known)) if (state, transition) == (p.state, p.transition) => known,
                _ => {
                    let transition = &transitions[p.state][p.transition];
                    // Without light curtains nothing but the present matters.
                    let harmless = self.world.curtains.is_empty() && !transition.frames[i].may_harm;
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
