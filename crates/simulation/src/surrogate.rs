//! What a sequence would lead to if the robots moved as they were seen to, without a step of the FMU.
//!
//! The person's way and what the sensors read follow from the cell alone. Where the FMU has been given the same inputs
//! before, its answer is known exactly. Beyond that the robots are assumed to move as in that observed episode whose
//! inputs differ in the fewest steps, and of those the one whose person was nearest. Only what was observed since the
//! run began is used; what earlier runs left in memory is not looked at, so a run does not depend on them.
//!
//! A posture changes nothing but the contacts, unless a light curtain sees it: so where there is none, all six are tried
//! with every walk.

mod rollout;

use std::collections::{BTreeMap, BTreeSet};
use std::convert::Infallible;
use std::sync::Arc;

use super::Coverage;
use super::detection_plane::DetectionPlane;
use super::robots::Robots;
use super::sensors::DelayLine;
use super::world::{
    Frames, Hit, IfSignalled, InputTrace, Instant, OperatedControls, Places, SignalledRuns, Walks, Window, World,
};
use crate::geometry::Vec3;
use crate::hazard::Class;
use crate::hazard::place::place_cell;
use crate::host::{NodeId, Plant, Recall};
use crate::human::{Action, Posture, Presses, Who};
use crate::search::EndingKind;

/// Observed episodes with different states of the FMU that are compared with; later ones are not.
const EPISODES_KEPT: usize = 512;

/// Entries of each memory, some hundred MB together; beyond that it is cleared and filled again.
const REMEMBERED: usize = 500_000;

/// First step, counted from the start of an action, from which on a light curtain may have been broken.
const EARLIEST: isize = -(DelayLine::LONGEST as isize);

/// Body regions of a second person are told apart by this.
const SECONDS_REGION: i64 = 1000;

/// Nothing is left of what imagining may cost.
const SPENT: u64 = 0;

/// What is imagined is imagined for arms that may be anywhere: so many actions are long enough for that.
const LONG_AFTER: usize = 1_000_000;

/// An observed episode.
#[derive(Clone, Debug)]
struct Observed {
    /// State of the FMU after each action.
    nodes: Vec<NodeId>,
    /// Inputs of each action, row-major.
    inputs: Vec<Vec<f64>>,
    /// Where everybody stood after each action, m.
    ends: Vec<Ends>,
}

/// Where the first person stands, and the second if there is one, m.
type Ends = (Vec3, Option<Vec3>);

/// How different an observed episode is from what is imagined: steps with other inputs, then squared distances, m^2.
#[derive(Clone, Copy, Debug, Default)]
struct Difference(usize, f64);

impl Difference {
    fn plus(self, other: Self) -> Self {
        Self(self.0 + other.0, self.1 + other.1)
    }

    fn less(&self, other: &Self) -> bool {
        self.0.cmp(&other.0).then(self.1.total_cmp(&other.1)).is_lt()
    }
}

/// The FMU had a light curtain been broken earlier.
#[derive(Clone, Copy, Debug)]
enum Shadow {
    Known(NodeId),
    Unknown,
    /// Before the start of time.
    Never,
}

/// The robots during an action, with all that contacts depend on.
#[derive(Clone, Copy, Debug)]
struct Situation {
    /// Equal numbers: the same to the last bit.
    number: usize,
    /// Whether everything about it was observed.
    certain: bool,
}

/// What the sensing in an action follows from: where it begins, what is on its way, switches, walk and posture, what is worked.
type SensingKey = (Places, Vec<DelayLine>, Presses, Action, OperatedControls);

/// Whom the robots meet follows from their situation, where an action begins, the action, and what is on its way where that counts.
type SurrogateKey = (usize, Places, Action, Vec<DelayLine>);

/// Memory of what was seen in this run, and of what follows from the cell.
#[derive(Debug)]
pub(super) struct Surrogate {
    // Of this run.
    reached: BTreeSet<NodeId>,
    observed: Vec<Observed>,
    last_nodes: BTreeSet<NodeId>,
    shadows: BTreeMap<(NodeId, usize, isize), Shadow>,
    situations: BTreeMap<NodeId, Situation>,
    // True in all runs.
    outputs: BTreeMap<Vec<u64>, usize>,
    outputs_of: BTreeMap<NodeId, usize>,
    numbers: BTreeMap<Vec<usize>, usize>,
    walks: BTreeMap<(Places, Action), Arc<Walks>>,
    sensed: BTreeMap<SensingKey, Arc<InputTrace>>,
    met: BTreeMap<SurrogateKey, (Option<EndingKind>, u64)>,
    // Of one proposal.
    asked: BTreeSet<SurrogateKey>,
    budget: u64,
    /// Contacts that are only imagined do not count in the figures of the run.
    unreal: Coverage,
    world: Arc<World>,
}

fn remember<K: Ord, V: Clone>(memory: &mut BTreeMap<K, V>, key: K, value: V) -> V {
    if memory.len() >= REMEMBERED {
        memory.clear();
    }
    memory.insert(key, value.clone());
    value
}

impl Surrogate {
    /// What imagining looked at.
    pub(super) const fn coverage(&self) -> &Coverage {
        &self.unreal
    }

    pub(super) fn new(world: &World) -> Self {
        let own = World::new(Arc::clone(&world.cell), Arc::clone(&world.binding));
        let own = own.heeding(world.stop()).content_with_any();
        Self {
            world: Arc::new(own),
            reached: BTreeSet::new(),
            observed: Vec::new(),
            last_nodes: BTreeSet::new(),
            shadows: BTreeMap::new(),
            situations: BTreeMap::new(),
            outputs: BTreeMap::new(),
            outputs_of: BTreeMap::new(),
            numbers: BTreeMap::new(),
            walks: BTreeMap::new(),
            sensed: BTreeMap::new(),
            met: BTreeMap::new(),
            asked: BTreeSet::new(),
            budget: u64::MAX,
            unreal: Coverage::new(world.cell.sensors.len()),
        }
    }

    /// Forgets what the run has seen.
    pub(super) fn forget(&mut self) {
        self.reached.clear();
        self.observed.clear();
        self.last_nodes.clear();
        self.shadows.clear();
        self.situations.clear();
    }

    /// From now on the questions asked may cost so much, each counted once and as if nothing were remembered.
    fn begin(&mut self, budget: u64) {
        self.asked.clear();
        self.budget = budget;
    }

    /// Takes what a question costs from what may be spent. Whether that was enough.
    fn spend(&mut self, question: SurrogateKey, cost: u64) -> bool {
        if self.asked.insert(question) {
            self.budget = self.budget.checked_sub(cost).unwrap_or(SPENT);
        }
        self.budget > SPENT
    }

    /// Different actions of the FMU that the run needed.
    pub(super) fn reached(&self) -> usize {
        self.reached.len()
    }

    /// The run needed the FMU to reach these states.
    pub(super) fn add_reached(&mut self, nodes: &BTreeSet<NodeId>) {
        let before = self.reached.len();
        self.reached.extend(nodes);
        if self.reached.len() > before {
            self.shadows.clear();
            self.situations.clear();
        }
    }

    /// An episode has ended in `last`.
    pub(super) fn observe<P: Plant>(&mut self, world: &World, recall: &Recall<P>, last: NodeId, actions: &[Action]) {
        if self.observed.len() >= EPISODES_KEPT || !self.last_nodes.insert(last) {
            return;
        }
        let mut nodes: Vec<NodeId> =
            std::iter::successors(Some(last), |n| Some(recall.parent(*n))).take(actions.len()).collect();
        nodes.reverse();
        let inputs = nodes.iter().map(|n| recall.inputs(*n)).collect();
        let mut places = world.starts();
        let mut end = |action: &Action| {
            places = self.walk(world, places, world.taken_by_all(&places, *action)).ends();
            ends_of(world, &places)
        };
        let ends = actions.iter().map(&mut end).collect();
        self.observed.push(Observed { nodes, inputs, ends });
    }

    fn walk(&mut self, world: &World, from: Places, action: Action) -> Arc<Walks> {
        let doors = world.first.works_doors(action);
        // Who stands goes the same way in every posture, but may get to another door.
        let goes_as = |action: Action| {
            let stands = !action.posture().is_low() && doors.is_none();
            if stands { action.in_posture(Posture::Upright) } else { action }
        };
        let key = (from, each_as(action, goes_as).pressing(doors));
        if let Some(known) = self.walks.get(&key) {
            return Arc::clone(known);
        }
        remember(&mut self.walks, key, Arc::new(world.walks(from, action)))
    }

    fn sense(
        &mut self,
        world: &World,
        walks: &Walks,
        (delays, switched): (&[DelayLine], Presses),
        action: Action,
    ) -> Arc<InputTrace> {
        let worked = world.worked_by(&walks.starts(), action);
        let seen_as = |action: Action| {
            let stands = world.posture_is_unseen() && !action.posture().is_low();
            if stands { action.in_posture(Posture::Upright) } else { action }
        };
        let seen = each_as(action, seen_as).pressing(Presses::NONE);
        let key = (walks.starts(), delays.to_vec(), switched, seen, worked);
        if let Some(known) = self.sensed.get(&key) {
            return Arc::clone(known);
        }
        let sights = world.raw_readings_of_all(walks, seen);
        remember(&mut self.sensed, key, Arc::new(world.sense(delays, switched, &sights, &worked)))
    }

    /// The state that the FMU reaches, if this run has seen it do so.
    fn known<P: Plant>(&self, robots: &Robots<P>, from: NodeId, steps: usize, inputs: &[f64]) -> Option<NodeId> {
        robots.recall.known(from, steps, inputs).filter(|node| self.reached.contains(node))
    }

    /// How different an observed episode is in action `k`.
    fn difference(&self, world: &World, episode: usize, k: usize, inputs: &[f64], end: Ends) -> Difference {
        let observed = &self.observed[episode];
        let (Some(theirs), Some(at)) = (observed.inputs.get(k), observed.ends.get(k)) else {
            return Difference::default();
        };
        let width = world.binding.inputs.len().max(1);
        let bits = |row: &[f64]| row.iter().map(|v| v.to_bits()).collect::<Vec<_>>();
        let other = |(a, b): &(&[f64], &[f64])| a != b && bits(a) != bits(b);
        let rows = inputs.chunks(width).zip(theirs.chunks(width)).filter(other).count();
        let squared = |(a, b): (Vec3, Vec3)| (a - b).dot(a - b);
        Difference(rows, squared((end.0, at.0)) + end.1.zip(at.1).map_or(0.0, squared))
    }

    /// The number of the outputs of the action into `node`.
    fn outputs_of<P: Plant>(&mut self, robots: &Robots<P>, node: NodeId) -> usize {
        let (outputs, of) = (&mut self.outputs, &mut self.outputs_of);
        *of.entry(node).or_insert_with(|| {
            let bits = robots.recall.outputs(node).iter().map(|v| v.to_bits()).collect();
            let next = outputs.len();
            *outputs.entry(bits).or_insert(next)
        })
    }

    /// The FMU in the stead of `node` had the light curtain of `sensor` been broken from step `first` of the action on.
    fn shadow<P: Plant>(
        &mut self,
        world: &World,
        robots: &Robots<P>,
        node: NodeId,
        sensor: usize,
        first: isize,
    ) -> Shadow {
        let Some(column) = world.binding.sensors[sensor].input() else { return Shadow::Never };
        if node == NodeId::ROOT {
            return Shadow::Never;
        }
        if let Some(known) = self.shadows.get(&(node, sensor, first)) {
            return *known;
        }
        let per_action = world.cell.steps_per_action;
        let parent = robots.recall.parent(node);
        let from = match first {
            0.. => Shadow::Known(parent),
            _ => self.shadow(world, robots, parent, sensor, first + per_action.cast_signed()),
        };
        let shadow = match from {
            Shadow::Known(from) => {
                let active = world.cell.sensors[sensor].signal.value(true);
                let mut inputs = robots.recall.inputs(node);
                let skipped = usize::try_from(first).unwrap_or(0);
                for row in inputs.chunks_mut(world.binding.inputs.len().max(1)).skip(skipped) {
                    row[column] = active;
                }
                self.known(robots, from, per_action, &inputs).map_or(Shadow::Unknown, Shadow::Known)
            }
            other => other,
        };
        self.shadows.insert((node, sensor, first), shadow);
        shadow
    }

    /// The robots during the action into `node`.
    fn situation<P: Plant>(&mut self, world: &World, robots: &Robots<P>, node: NodeId) -> Situation {
        if let Some(known) = self.situations.get(&node) {
            return *known;
        }
        let mut key = vec![self.outputs_of(robots, node)];
        let mut certain = true;
        for DetectionPlane { sensor, .. } in &world.first.curtains {
            for first in EARLIEST..world.cell.steps_per_action.cast_signed() {
                key.push(match self.shadow(world, robots, node, *sensor, first) {
                    Shadow::Known(shadow) => self.outputs_of(robots, shadow),
                    Shadow::Never => usize::MAX,
                    Shadow::Unknown => {
                        certain = false;
                        key[0]
                    }
                });
            }
        }
        let next = self.numbers.len();
        let situation = Situation { number: *self.numbers.entry(key).or_insert(next), certain };
        self.situations.insert(node, situation);
        situation
    }

    /// The unsafe contact of an action during which the robots move as in the action into `node`. Nothing if to know it costs more than may
    /// be spent.
    fn meets<P: Plant>(
        &mut self,
        world: &World,
        robots: &mut Robots<P>,
        person: &rollout::RolloutState,
        action: Action,
        sensed: &InputTrace,
        node: NodeId,
    ) -> Option<(Option<EndingKind>, Situation)> {
        let situation = self.situation(world, robots, node);
        // Without light curtains, contacts do not depend on what was sensed.
        let delays = if world.first.curtains.is_empty() { Vec::new() } else { person.delays.clone() };
        let key = (situation.number, person.places, action, delays);
        if let Some((known, cost)) = self.met.get(&key).copied() {
            return self.spend(key, cost).then_some((known, situation));
        }
        let before = self.unreal.cost(0);
        let walks = self.walk(world, person.places, action);
        let frames = robots.frames(node);
        let mut shadows = Vec::with_capacity(world.first.curtains.len());
        for DetectionPlane { sensor, .. } in &world.first.curtains {
            let firsts = EARLIEST..world.cell.steps_per_action.cast_signed();
            let of = |first| match self.shadow(world, robots, node, *sensor, first) {
                Shadow::Known(node) => Some(robots.frames(node)),
                // Nothing speaks against it that the robots go on as they do.
                Shadow::Unknown => Some(Arc::clone(&frames)),
                Shadow::Never => None,
            };
            shadows.push((world.cell.sensors[*sensor].delay_steps, firsts.map(of).collect::<Vec<_>>()));
        }
        let mut met = None;
        'action: for i in 0..frames.len() {
            if self.unreal.cost(0) - before >= self.budget || self.world.stop().is_due() {
                self.budget = SPENT;
                return None;
            }
            for (who, walked) in walks.each() {
                let Some(own) = world.of(who) else { continue };
                let stance = own.stance(walked, (LONG_AFTER, i), action.of(who).posture(), sensed);
                let earlier = IfBroken { own: &frames, shadows: &shadows, i };
                let Ok(hit) = own.contact(&stance, &mut Instant { frames: &frames, i, earlier }, &mut self.unreal);
                if let Some(hit) = hit.filter(|hit| hit.contact.class().is_some_and(Class::ends)) {
                    met = Some(niche(&hit, who, own.position(&stance.place)));
                    break 'action;
                }
            }
        }
        let cost = self.unreal.cost(0) - before;
        remember(&mut self.met, key.clone(), (met, cost));
        self.spend(key, cost).then_some((met, situation))
    }
}

/// The robots had a light curtain been broken, as far as that was observed.
struct IfBroken<'a> {
    own: &'a Frames,
    /// For each light curtain its delay and the robots by the first step from which on it was broken.
    shadows: &'a [(usize, Vec<Option<Frames>>)],
    i: usize,
}

impl SignalledRuns for IfBroken<'_> {
    type Error = Infallible;

    fn told_of(&mut self, windows: &[Window]) -> Result<IfSignalled<Frames>, Infallible> {
        // Of arms ahead of the body, or past two planes, nothing was observed: the robots may go on as they do.
        let [Window { curtain, from, until: 0 }] = windows else { return Ok(IfSignalled::Is(Arc::clone(self.own))) };
        let (delay, shadows) = &self.shadows[*curtain];
        let first = (self.i + 1 + delay).cast_signed() - from.cast_signed();
        if first > self.i.cast_signed() {
            return Ok(IfSignalled::Is(Arc::clone(self.own)));
        }
        let number = usize::try_from(first - EARLIEST).ok();
        Ok(number.and_then(|n| shadows.get(n).cloned().flatten()).map_or(IfSignalled::BeforeTime, IfSignalled::Is))
    }
}

/// Endings of one kind: body region and robot link that meet, where the person stands and who it is, and the programme phase.
fn niche(hit: &Hit, who: Who, person: Vec3) -> EndingKind {
    let (x, y) = place_cell(person);
    let link = hit.contact.link.cast_signed() as i64;
    let region = hit.contact.region as i64 + if who == Who::Second { SECONDS_REGION } else { 0 };
    EndingKind([region, link, x, y, hit.phase.unwrap_or(i64::MIN)])
}

/// What one of the people does as `one` has it, for each of them.
fn each_as(action: Action, one: impl Fn(Action) -> Action) -> Action {
    let own = one(action.of(Who::First));
    let both = if action.is_of_two() { own.beside(one(action.of(Who::Second))) } else { own };
    both.pressing(action.presses())
}

fn ends_of(world: &World, places: &Places) -> Ends {
    let of = |who: Who| Some(world.of(who)?.position(places.of(who)?));
    (world.first.position(&places.first), of(Who::Second))
}
