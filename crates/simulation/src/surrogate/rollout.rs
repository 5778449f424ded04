//! The imagined way of the person: action after action, where it leads, what is sensed, and what the robots would do.

use std::sync::Arc;

use super::super::robots::Robots;
use super::super::sensors::DelayLine;
use super::super::simulation::Simulation;
use super::super::world::{InputTrace, Places, World};
use super::{Difference, Ends, SPENT, Surrogate, ends_of};
use crate::host::{NodeId, Plant};
use crate::human::{Posture, Presses};
use crate::search::plan::{PredictedHazard, Rollout, SurrogateModel};

/// The FMU's state after an action, and whether that is certain; nothing if it cannot be told.
type PredictedState = Option<(NodeId, bool)>;

/// The person on its imagined way.
pub(super) struct RolloutState {
    pub(super) places: Places,
    pub(super) delays: Vec<DelayLine>,
    /// Controls that are switched over.
    pub(super) switched: Presses,
    /// The FMU's state, as long as it is known.
    at: Option<NodeId>,
    taken: Vec<usize>,
    /// What was sensed in each action taken, and where it ended.
    way: Vec<(Arc<InputTrace>, Ends)>,
    /// How different each observed episode is in the first `compared` actions.
    differences: Vec<Difference>,
    compared: usize,
}

impl RolloutState {
    /// The state of the FMU after the next action: the true one if it is known, else that of the observed episode which
    /// is least different; nothing if none was that long.
    fn predict<P: Plant>(
        &mut self,
        imagination: &Surrogate,
        world: &World,
        robots: &Robots<P>,
        sensed: &InputTrace,
        end: Ends,
    ) -> PredictedState {
        let steps = world.cell.steps_per_action;
        let known = self.at.and_then(|at| imagination.known(robots, at, steps, &sensed.inputs));
        if let Some(known) = known {
            return Some((known, true));
        }
        let k = self.taken.len();
        for (j, (sensed, end)) in self.way.iter().enumerate().skip(self.compared) {
            for (episode, sum) in self.differences.iter_mut().enumerate() {
                *sum = sum.plus(imagination.difference(world, episode, j, &sensed.inputs, *end));
            }
        }
        self.compared = self.way.len();
        let mut best: Option<(Difference, NodeId)> = None;
        for (episode, sum) in self.differences.iter().enumerate() {
            let Some(node) = imagination.observed[episode].nodes.get(k) else { continue };
            let difference = sum.plus(imagination.difference(world, episode, k, &sensed.inputs, end));
            if best.as_ref().is_none_or(|(least, _)| difference.less(least)) {
                best = Some((difference, *node));
            }
        }
        best.map(|(_, node)| (node, false))
    }
}

impl<P: Plant> SurrogateModel for Simulation<P> {
    fn calm(&self) -> usize {
        // That of standing still, in every repertoire.
        0
    }

    fn begin_imagining(&mut self, budget: u64) {
        self.imagination.begin(budget);
    }

    fn is_over_budget(&self) -> bool {
        self.imagination.budget == SPENT
    }

    fn imagine(&mut self, actions: &[usize]) -> Rollout {
        let Self { robots, imagination, .. } = self;
        let world = &Arc::clone(&imagination.world);
        // What follows the FMU changes here from action to action only.
        let mut imagined = Rollout { visions: Vec::new(), exact: !world.follows() };
        let mut person = RolloutState {
            places: robots.starts(),
            delays: world.delays_at_start(),
            switched: Presses::NONE,
            at: Some(NodeId::ROOT),
            taken: Vec::with_capacity(actions.len()),
            way: Vec::with_capacity(actions.len()),
            differences: vec![Difference::default(); imagination.observed.len()],
            compared: 0,
        };
        for &action in actions {
            let action = world.taken_by_all(&person.places, world.cell.repertoire.action(action));
            let walks = imagination.walk(world, person.places, action);
            let end = ends_of(world, &walks.ends());
            // The wanted posture first, then the others: the first that is safe goes on. Where a light curtain sees the
            // difference, each would need arm checks of its own, and those behind a curtain are many: only the wanted one.
            // Low ones lead elsewhere and are seen otherwise.
            let stands = world.posture_is_unseen() && !action.posture().is_low();
            // So may those that get to another door.
            let alike = stands && world.first.works_doors(action).is_none();
            let others = Posture::USUAL.into_iter().filter(|p| *p != action.posture() && alike);
            let unseen = stands && action.presses().is_none();
            let mut goes_on = None;
            let mut foreseen: Option<(Arc<InputTrace>, PredictedState)> = None;
            for posture in std::iter::once(action.posture()).chain(others) {
                let tried = action.in_posture(posture);
                let Some(index) = world.cell.repertoire.index(tried) else { continue };
                let (sensed, robot) = match foreseen.take() {
                    Some(same) if unseen => same,
                    _ => {
                        let sensed = imagination.sense(world, &walks, (&person.delays, person.switched), tried);
                        let robot = person.predict(imagination, world, robots, &sensed, end);
                        (sensed, robot)
                    }
                };
                foreseen = Some((Arc::clone(&sensed), robot));
                let Some((node, known)) = robot else { continue };
                let Some((met, situation)) = imagination.meets(world, robots, &person, tried, &sensed, node) else {
                    return Rollout { exact: false, ..imagined };
                };
                imagined.exact &= known && situation.certain;
                if let Some(niche) = met {
                    let actions = person.taken.iter().copied().chain([index]).collect();
                    imagined.visions.push(PredictedHazard { actions, niche });
                } else if goes_on.is_none() {
                    goes_on =
                        Some((index, sensed, known.then_some(node), robots.amid_what_is_said(&walks.ends(), node)));
                }
            }
            let Some((index, sensed, at, ends)) = goes_on else {
                // Every posture tried is unsafe, or no episode was so long.
                imagined.exact &= !imagined.visions.is_empty();
                return imagined;
            };
            person.places = ends;
            person.delays.clone_from(&sensed.delays);
            person.switched = sensed.switched;
            person.at = at;
            person.taken.push(index);
            person.way.push((sensed, end));
        }
        imagined
    }
}
