//! All actions from many states at once, on all cores: the cell as an [`Expansion`] for the exhaustive search.
//!
//! First what needs the FMU, one after the other: the walks, the inputs that follow, the FMU's answer. Actions that give
//! it the same inputs from the same state step it once. Then what needs no FMU: whether the person, so placed, can touch
//! the robots, so placed. That question comes up many times in the same words (a place is reached along many ways, and
//! the robot is where it is), so each is asked once; the answers do not depend on each other and are worked out on all
//! cores, instant after instant, because after the first unsafe contact an action is over.
//!
//! **Equal states.** The person stands at the same place with the same heading, the sensors' delay lines are equal, and
//! the FMU is in the same state: it had the same inputs, or its serialised state is the same byte for byte. With a plane
//! (light curtain, door, two-hand control), the states in which the FMU would be had the plane told of an arm are equal as
//! well, because what an arm meets depends on them (see [`crate::sim::detection_plane`]). With two planes that an arm may pass at once the
//! inputs have to be the same.

mod ahead;
mod joined;
mod known;
mod questions;
mod situations;

use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use self::ahead::{Move, Outlook, WalkPath};
use self::joined::{CoursesByQuestion, Joined};
use self::situations::Situations;
use crate::cell::{Binding, Workcell};
use crate::hazard::Finding;
use crate::host::{Advanced, NodeId, Plant, PlantError, Policy, Recall};
use crate::human::walk::WalkTrace;
use crate::human::{Action, Place, Presses, Who};
use crate::search::exhaustive::{Effect, Expanded, Expansion, Noted, Of, PriorState};
use crate::sim::Coverage;
use crate::sim::action::{ActionStart, CarriedOut};
use crate::sim::action_hazards::is_told;
use crate::sim::answers::Answers;
use crate::sim::bound::RobotBounds;
use crate::sim::motion::Motion;
use crate::sim::robots::{Robots, Shadow};
use crate::sim::sensors::DelayLine;
use crate::sim::world::{Frames, InputTrace, OperatedControls, Places, RawReadings, Walks, World};

use fmi_hazard_cell::cell;
use fmi_hazard_criteria as hazard;
use fmi_hazard_human::human;
use fmi_hazard_search as search;
use fmi_hazard_simulation as sim;
use fmu_host::host;

/// A state of the cell at the end of an action. Equal states have the same future.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct State {
    // Places first: neighbours in the order then share most of their questions.
    places: Places,
    /// The first state of the FMU found that is the same.
    node: NodeId,
    delays: Box<[DelayLine]>,
    /// Controls that are switched over.
    switched: Presses,
}

/// How equal states of the FMU are told.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Merge {
    /// By equal serialised states if the FMU offers them, else by equal inputs.
    #[default]
    Auto,
    /// By equal inputs only.
    History,
}

/// A cell whose states are expanded.
pub struct Expander<P: Plant> {
    world: Arc<World>,
    robots: Robots<P>,
    /// For each of the people.
    bounds: Vec<RobotBounds>,
    workers: usize,
    by_bytes: bool,
    /// With a plane: the first node with the same state and the same states had the plane told of an arm; by the samples since
    /// the body was first seen in it, and how many such states there are.
    bundles: BTreeMap<(Vec<usize>, Vec<Shadow>), NodeId>,
    coverage: Coverage,
    answers: Arc<Answers>,
    questions: u64,
}

/// An action's FMU answer and what it was asked.
struct Transition {
    node: NodeId,
    frames: Frames,
    sensed: InputTrace,
    /// Where it leads everybody, where what follows the FMU has that differ from their ways.
    amid: Option<Walks>,
    /// Controls that are worked in it, by any of the actions that it stands for.
    worked: Presses,
}

/// What is not known yet of what an action from a state brings somebody.
struct Pending {
    /// Index of the state, who it is, index of their way from it, of the transition among those of the state.
    state: usize,
    who: Who,
    way: usize,
    transition: usize,
    /// Index of the action, or with two people the number of this question; and the action as the person takes it there.
    index: usize,
    action: Action,
    /// Whether a hazard by contact came before: then clamping alone is asked for.
    struck: bool,
}

/// Where an action leads.
#[derive(Clone, Debug)]
enum Reached {
    /// The numbers of the next state and of the transition.
    To(usize, usize),
    /// Nowhere: why the FMU could not finish it.
    Unfinished(String),
    /// Elsewhere than the way that it was asked along: what follows the FMU changes in it.
    Elsewhere,
}

/// What is seen of each of the people, and what is worked.
type Key = (usize, Option<usize>, OperatedControls);

/// Actions along one walk from a state. Those that the FMU is told the same of share everything but the contacts.
#[derive(Default)]
struct Alike {
    /// By the posture that is seen, and what is worked.
    by_key: Vec<(Key, Reached)>,
    /// By what is told.
    by_inputs: Vec<(InputTrace, Reached)>,
}

impl Alike {
    fn by_key(&self, key: &Key) -> Option<Reached> {
        self.by_key.iter().find(|(known, _)| known == key).map(|(_, to)| to.clone())
    }

    fn by_inputs(&self, sensed: &InputTrace) -> Option<Reached> {
        self.by_inputs.iter().find(|(known, _)| known.same(sensed)).map(|(_, to)| to.clone())
    }

    fn keep(&mut self, key: Key, sensed: InputTrace, to: &Reached) {
        self.by_key.push((key, to.clone()));
        if self.by_inputs(&sensed).is_none() {
            self.by_inputs.push((sensed, to.clone()));
        }
    }
}

/// The ways of everybody in an action.
struct Goes<'a> {
    first: &'a WalkPath,
    second: Option<&'a WalkPath>,
}

impl Goes<'_> {
    fn starts(&self) -> Places {
        Places { first: self.first.walked.start, second: self.second.map(|way| way.walked.start) }
    }

    fn traces(&self) -> Vec<(Who, &WalkTrace)> {
        let second = self.second.map(|way| (Who::Second, &way.walked));
        std::iter::once((Who::First, &self.first.walked)).chain(second).collect()
    }

    fn walks(&self) -> Walks {
        Walks { first: self.first.walked.clone(), second: self.second.map(|way| way.walked.clone()) }
    }

    /// What there is to see of everybody, of which these are the sights.
    fn sights(&self, (own, others): (usize, Option<usize>)) -> Cow<'_, [RawReadings]> {
        let own = &self.first.sights[own];
        match self.second.zip(others) {
            Some((second, others)) => Cow::Owned(RawReadings::of_either(own, &second.sights[others])),
            None => Cow::Borrowed(own),
        }
    }
}

impl<P: Plant> Expander<P> {
    /// Starts the plant; contacts are looked for by `workers` threads, which does not change the results.
    ///
    /// # Errors
    /// When the FMU cannot be started.
    pub fn new(
        cell: Arc<Workcell>,
        binding: Arc<Binding>,
        plant: P,
        policy: Policy,
        merge: Merge,
        workers: usize,
    ) -> Result<Self, PlantError> {
        let stop = plant.stop();
        let mut recall = Recall::new(plant, policy)?;
        recall.ends_at(usize::try_from(cell.search.actions).unwrap_or(usize::MAX));
        let by_bytes = merge == Merge::Auto && recall.merge_equal_states()?;
        let world = Arc::new(World::new(cell, binding).heeding(&stop));
        Ok(Self {
            bounds: world.people().map(|own| RobotBounds::new(&own.cell)).collect(),
            robots: Robots::new(Arc::clone(&world), recall),
            workers: workers.max(1),
            by_bytes,
            bundles: BTreeMap::new(),
            coverage: world.nothing_seen(),
            questions: 0,
            answers: Arc::default(),
            world,
        })
    }

    /// The same, with what is known from before, and what is kept.
    #[must_use]
    pub fn with_answers(self, answers: Arc<Answers>) -> Self {
        Self { answers, ..self }
    }

    /// What was seen. Actions and contact checks that came up several times count once.
    #[must_use]
    pub const fn coverage(&self) -> &Coverage {
        &self.coverage
    }

    /// What was seen of the robots' motion, in all runs so far.
    #[must_use]
    pub const fn motion(&self) -> &Motion {
        self.robots.motion()
    }

    /// The FMU's states and what reaching them cost.
    #[must_use]
    pub const fn recall(&self) -> &Recall<P> {
        &self.robots.recall
    }

    /// What the FMU said when it first could not finish a run in which planes told of an arm.
    #[must_use]
    pub fn arm_run_unfinished(&self) -> Option<String> {
        self.robots.unfinished()
    }

    /// Whether in such a run something that follows the FMU would have done so otherwise: it is not followed up.
    #[must_use]
    pub const fn arm_run_strayed(&self) -> bool {
        self.robots.has_strayed()
    }

    /// Whether equal states of the FMU are told by their serialised bytes, else by the inputs.
    #[must_use]
    pub const fn merges_by_bytes(&self) -> bool {
        self.by_bytes
    }

    /// Different questions whether a contact is possible.
    #[must_use]
    pub const fn questions(&self) -> u64 {
        self.questions
    }

    /// The first node with the same future as `node`, where the sensors remember `delays` and the person is at `place`.
    fn representative(&mut self, node: NodeId, place: &Place, delays: &[DelayLine]) -> Result<NodeId, PlantError> {
        let same = self.robots.recall.same(node);
        // With two people there are none.
        if self.world.first.curtains.is_empty() {
            return Ok(same);
        }
        if !self.world.first.neighbours.is_empty() {
            return Ok(node);
        }
        let (mut sinces, mut bundle) = (Vec::new(), vec![Shadow::Is(same)]);
        for plane in 0..self.world.first.curtains.len() {
            let since = delays[self.world.first.curtains[plane].sensor].first_seen();
            let shadows = self.robots.shadows(node, place, plane, since)?;
            bundle.extend(shadows.into_iter().map(|shadow| shadow.map(|n| self.robots.recall.same(n))));
            sinces.extend([since, bundle.len()]);
        }
        Ok(*self.bundles.entry((sinces, bundle)).or_insert(node))
    }

    /// All actions from each of these states, as [`Expansion::expand`] says.
    fn all_from(
        &mut self,
        depth: usize,
        states: &[(&State, PriorState)],
        go_on: &mut dyn FnMut() -> bool,
    ) -> Result<Option<Vec<Expanded<State, Finding>>>, PlantError> {
        let (states, befores): (Vec<&State>, Vec<PriorState>) = states.iter().copied().unzip();
        let Some(outlook) = self.look_ahead(&states, go_on) else { return Ok(None) };
        let mut joined = Joined::default();
        let (mut pending, mut expanded, mut transitions) = (Vec::new(), Vec::new(), Vec::new());
        for (index, state) in states.iter().enumerate() {
            if !go_on() {
                return Ok(None);
            }
            let (state, before) = (*state, befores[index]);
            let (one, own) = self.advance((index, depth), (state, before), &outlook, &mut pending, &mut joined)?;
            expanded.push(one);
            transitions.push(own);
        }
        let ahead = |p: &Pending| outlook.of(p.who, &states[p.state].places);
        let nowhere = WalkTrace { start: self.world.first.start(), places: Vec::new(), blocked: Vec::new() };
        let walked = |p: &Pending| match &transitions[p.state][p.transition].amid {
            Some(walks) => walks.of(p.who).unwrap_or(&nowhere),
            None => ahead(p).map_or(&nowhere, |ahead| &ahead.ways[p.way].walked),
        };
        let (mut met, goes_on) = (CoursesByQuestion::of(&joined), self.world.goes_on());
        let mut situations = Situations::default();
        for i in 0..self.world.cell.steps_per_action {
            let asked = self.asked(i, &pending, &transitions, &walked, &mut situations)?;
            let (questions, places) = self.to_ask((depth, i), asked, &pending, &transitions, &walked);
            let Some(answers) = self.answer(&questions, &situations.all, go_on) else { return Ok(None) };
            let mut places = places.iter();
            pending.retain_mut(|p| {
                let Some(&(q, s)) = places.next().and_then(Option::as_ref) else { return true };
                let Some(hit) = &answers[q][s] else { return true };
                let transition = &transitions[p.state][p.transition];
                let stance = &questions[q].0;
                let finding = |hit| {
                    let sensors = self.world.readings(&transition.sensed.readings[i], &transition.frames[i]);
                    self.world.of_person_state(stance).finding(hit, stance, sensors, (depth + 1, i))
                };
                let Some(found) = finding(hit) else { return true };
                let clamping = hit.clamps.as_deref().and_then(finding);
                let ends = !p.struck && found.class.ends();
                if joined.is_used() {
                    let course = met.course(p.index);
                    if p.struck { course.is_clamped(found) } else { course.meets(found, clamping) }
                } else {
                    alone((&mut expanded[p.state], befores[p.state]), p, (found, clamping), goes_on);
                }
                p.struck |= ends;
                !ends || goes_on
            });
        }
        joined.settle(&met, &befores, goes_on, &mut expanded);
        Ok(Some(expanded))
    }

    /// The part that needs the FMU: successors, transitions, and what is to be looked for contacts.
    fn advance(
        &mut self,
        (number, depth): (usize, usize),
        (state, before): (&State, PriorState),
        outlook: &Outlook,
        pending: &mut Vec<Pending>,
        joined: &mut Joined,
    ) -> Result<(Expanded<State, Finding>, Vec<Transition>), PlantError> {
        let mut expanded = Expanded { next: Vec::new(), effects: Vec::new(), noted: Vec::new() };
        let mut transitions: Vec<Transition> = Vec::new();
        let Some(ahead) = outlook.of(Who::First, &state.places) else { return Ok((expanded, transitions)) };
        let beside = outlook.of(Who::Second, &state.places);
        let last = depth + 1 == self.horizon();
        let ways = beside.map_or(1, |beside| beside.ways.len());
        let mut alike: Vec<Alike> = (0..ahead.ways.len() * ways).map(|_| Alike::default()).collect();
        // What differs from the ways ahead, by the transition.
        let mut amid: Vec<(Walks, InputTrace, Reached)> = Vec::new();
        joined.begin();
        for index in 0..self.actions() {
            let repertoire = &self.world.cell.repertoire;
            let (wanted, (own, others)) = (repertoire.action(index), repertoire.apart(index));
            let Move { taken, way, sight } = ahead.taken(own, self.world.first.works_doors(wanted));
            let second = beside.map(|beside| (beside, beside.taken(others, Presses::NONE)));
            let action = taken.pressing(wanted.presses());
            let action = second.as_ref().map_or(action, |(_, second)| action.beside(second.taken));
            let other_way = second.as_ref().map(|(beside, second)| &beside.ways[second.way]);
            let goes = Goes { first: &ahead.ways[way], second: other_way };
            let alike = &mut alike[way * ways + second.as_ref().map_or(0, |(_, second)| second.way)];
            let key =
                (sight, second.as_ref().map(|(_, second)| second.sight), self.world.worked_by(&goes.starts(), action));
            let to = match alike.by_key(&key) {
                Some(to) => to,
                None => {
                    let sights = goes.sights((sight, key.1));
                    let sensed = self.world.sense(&state.delays, state.switched, &sights, &key.2);
                    let to = match alike.by_inputs(&sensed) {
                        Some(to) => to,
                        None => self.reach((state, last), &goes, &sensed, &mut expanded, &mut transitions)?,
                    };
                    alike.keep(key, sensed, &to);
                    to
                }
            };
            let to = match to {
                Reached::Elsewhere => {
                    self.elsewhere((state, last), goes.walks(), action, &mut amid, &mut expanded, &mut transitions)?
                }
                to => to,
            };
            let (next, transition) = match to {
                Reached::To(next, transition) => (next, transition),
                Reached::Unfinished(reason) => {
                    expanded.effects.push(Effect::NotEvaluated(reason));
                    continue;
                }
                Reached::Elsewhere => continue,
            };
            expanded.effects.push(Effect::To(next));
            transitions[transition].worked = transitions[transition].worked.and(key.2.presses);
            let struck = before == PriorState::Unsafe;
            let of = |who, way| Pending { state: number, who, way, transition, index, action: action.of(who), struck };
            match second {
                None => pending.push(of(Who::First, way)),
                Some((_, second)) => {
                    let both = [of(Who::First, way), of(Who::Second, second.way)];
                    joined.add((number, index), action, both, pending);
                }
            }
        }
        for transition in &transitions {
            let controls = self.coverage.control_actions.iter_mut().enumerate();
            controls.for_each(|(control, actions)| *actions += u64::from(transition.worked.has(control)));
        }
        Ok((expanded, transitions))
    }

    /// Has the FMU answer to what was sensed along the ways of everybody: a new successor and a new transition.
    fn reach(
        &mut self,
        (state, last): (&State, bool),
        goes: &Goes<'_>,
        sensed: &InputTrace,
        expanded: &mut Expanded<State, Finding>,
        transitions: &mut Vec<Transition>,
    ) -> Result<Reached, PlantError> {
        let per_action = self.world.cell.steps_per_action;
        let node = match self.robots.recall.advance(state.node, per_action, &sensed.inputs)? {
            Advanced::Fault(fault) => {
                self.coverage.episodes_not_evaluated += 1;
                return Ok(Reached::Unfinished(fault.message.clone()));
            }
            Advanced::To(node) => node,
        };
        if self.world.follows() && self.robots.says_otherwise(&goes.walks(), node).is_some() {
            return Ok(Reached::Elsewhere);
        }
        let walks = goes.traces();
        let ends = Places { first: goes.first.walked.end(), second: goes.second.map(|way| way.walked.end()) };
        let places = self.robots.amid_what_is_said(&ends, node);
        let (frames, worked) = (self.robots.frames(node), Presses::NONE);
        let transition = Transition { node, frames, sensed: sensed.clone(), amid: None, worked };
        self.arrive((places, &walks, last), transition, expanded, transitions)
    }

    /// The same of an action in which what follows the FMU changes: for itself.
    fn elsewhere(
        &mut self,
        (state, last): (&State, bool),
        walks: Walks,
        action: Action,
        amid: &mut Vec<(Walks, InputTrace, Reached)>,
        expanded: &mut Expanded<State, Finding>,
        transitions: &mut Vec<Transition>,
    ) -> Result<Reached, PlantError> {
        let from =
            ActionStart { node: state.node, places: state.places, delays: &state.delays, switched: state.switched };
        let CarriedOut { walks, sensed, advanced } = self.robots.go_along(&from, walks, action, &|_| {})?;
        let node = match advanced {
            Advanced::Fault(fault) => {
                self.coverage.episodes_not_evaluated += 1;
                return Ok(Reached::Unfinished(fault.message.clone()));
            }
            Advanced::To(node) => node,
        };
        let same = |(known, told, _): &&(Walks, InputTrace, Reached)| *known == walks && told.same(&sensed);
        if let Some((_, _, to)) = amid.iter().find(same) {
            return Ok(to.clone());
        }
        let places = self.robots.amid_what_is_said(&walks.ends(), node);
        let traces: Vec<_> = walks.each().collect();
        let (frames, worked) = (self.robots.frames(node), Presses::NONE);
        let transition = Transition { node, frames, sensed: sensed.clone(), amid: Some(walks.clone()), worked };
        let to = self.arrive((places, &traces, last), transition, expanded, transitions)?;
        amid.push((walks, sensed, to.clone()));
        Ok(to)
    }

    /// A new successor, and the transition to it.
    fn arrive(
        &mut self,
        (places, walks, last): (Places, &[(Who, &WalkTrace)], bool),
        transition: Transition,
        expanded: &mut Expanded<State, Finding>,
        transitions: &mut Vec<Transition>,
    ) -> Result<Reached, PlantError> {
        let Transition { node, sensed, .. } = &transition;
        self.robots.note(walks, *node, Presses::NONE, &mut self.coverage);
        // Where the sequences end, nothing depends on which state it is.
        let node = if last { *node } else { self.representative(*node, &places.first, &sensed.delays)? };
        let (delays, switched) = (sensed.delays.clone().into_boxed_slice(), sensed.switched);
        expanded.next.push(State { places, node, delays, switched });
        let blocked = walks.iter().any(|(_, walked)| walked.blocked.contains(&true));
        self.look(blocked, sensed, &transition.frames);
        transitions.push(transition);
        Ok(Reached::To(expanded.next.len() - 1, transitions.len() - 1))
    }

    fn look(&mut self, blocked: bool, sensed: &InputTrace, frames: &Frames) {
        let coverage = &mut self.coverage;
        coverage.actions += 1;
        coverage.walks_blocked += u64::from(blocked);
        let fastest = frames.iter().map(|f| f.fastest).fold(0.0, f64::max);
        coverage.robot_top_speed_m_s = coverage.robot_top_speed_m_s.max(fastest);
        for (sensor, fired) in coverage.sensor_actions.iter_mut().enumerate() {
            let any = (0..frames.len()).any(|i| self.world.reading(sensor, &sensed.readings[i], &frames[i]));
            *fired += u64::from(any);
        }
    }
}

/// Takes in what an only person meets in an action at an instant.
fn alone(
    (expanded, before): (&mut Expanded<State, Finding>, PriorState),
    p: &Pending,
    (found, clamping): (Finding, Option<Finding>),
    goes_on: bool,
) {
    let in_action = |finding: Finding| Finding { actions: vec![p.action], ..finding };
    let (found, clamping) = (in_action(found), clamping.map(in_action));
    let Expanded { noted, effects, .. } = expanded;
    if p.struck {
        note_clamping(noted, (p.index, found), before, false);
        return;
    }
    let known = noted.iter().position(|noted| noted.action == p.index);
    if !found.class.ends() {
        match known {
            Some(known) if noted[known].met.outweighs(&found) => {}
            Some(known) => noted[known].met = found,
            None => noted.push(Noted { action: p.index, met: found, of: Of::Safe }),
        }
        return;
    }
    // What does not end the action is told unless something does.
    known.map(|known| noted.remove(known));
    if let Some(clamping) = clamping {
        let is_told = is_told(&clamping, Some(&found));
        note_clamping(noted, (p.index, clamping), before, is_told);
    }
    effects[p.index] = effects[p.index].hits(found, goes_on);
}

/// Notes a clamping behind a hazard by contact; of one kind in one action the worst. What is told with the end of the action is news
/// for sequences only that met a hazard before.
fn note_clamping(noted: &mut Vec<Noted<Finding>>, (action, met): (usize, Finding), before: PriorState, is_told: bool) {
    let of = match (before, is_told) {
        (PriorState::Safe, true) => return,
        (PriorState::Either, true) | (PriorState::Unsafe, _) => Of::Unsafe,
        (PriorState::Safe, false) => Of::Safe,
        (PriorState::Either, false) => Of::Either,
    };
    let alike = |noted: &&mut Noted<Finding>| noted.action == action && noted.of == of && noted.met.is_like(&met);
    match noted.iter_mut().find(alike) {
        Some(known) if known.met.contact.ratio() >= met.contact.ratio() => {}
        Some(known) => known.met = met,
        None => noted.push(Noted { action, met, of }),
    }
}

impl<P: Plant> Expander<P> {
    /// The same, as if this had been seen: for tests of what follows from it.
    #[doc(hidden)]
    #[must_use]
    pub fn having_seen(self, coverage: Coverage) -> Self {
        Self { coverage, ..self }
    }
}

impl<P: Plant> Expansion for Expander<P> {
    type State = State;
    type Unsafe = Finding;
    type Error = PlantError;

    fn actions(&self) -> usize {
        self.world.cell.repertoire.count()
    }

    fn horizon(&self) -> usize {
        usize::try_from(self.world.cell.search.actions).unwrap_or(usize::MAX)
    }

    fn effort(&self, action: usize) -> u32 {
        self.world.cell.repertoire.action(action).effort()
    }

    fn start(&mut self) -> Result<State, PlantError> {
        let delays = self.world.delays_at_start().into_boxed_slice();
        let places = self.robots.starts();
        let node = self.representative(NodeId::ROOT, &places.first, &delays)?;
        Ok(State { places, node, delays, switched: Presses::NONE })
    }

    fn may_matter(&self, state: &State, remaining: usize) -> bool {
        self.world.people().zip(&self.bounds).any(|(own, bounds)| {
            let place = state.places.of(own.who);
            place.is_none_or(|place| bounds.may_meet(own.position(place), own.reach_m(), remaining))
        })
    }

    fn expand(
        &mut self,
        depth: usize,
        states: &[(&State, PriorState)],
        go_on: &mut dyn FnMut() -> bool,
    ) -> Result<Option<Vec<Expanded<State, Finding>>>, PlantError> {
        match self.all_from(depth, states, go_on) {
            Err(error) if error.stopped => Ok(None),
            expanded => expanded,
        }
    }

    fn release_before(&mut self, depth: usize) {
        // What an arm meets that passes two planes at once is worked out from the beginning.
        if !self.world.first.neighbours.is_empty() {
            self.robots.forget_motions();
            return;
        }
        let recall = &self.robots.recall;
        let keep: BTreeSet<NodeId> = self.bundles.values().copied().filter(|n| recall.depth(*n) >= depth).collect();
        self.bundles.retain(|_, node| keep.contains(node));
        self.robots.release(depth, &keep);
    }

    /// What is behind planes takes the most memory, and so do two people.
    fn together(&self) -> usize {
        match (&self.world.second, self.world.first.curtains.is_empty()) {
            // About as many as there are actions of one person.
            (Some(_), _) => (64 * 1296 / self.actions().max(1)).clamp(1, 64),
            (None, true) => 1024,
            (None, false) => 512,
        }
    }

    /// Boxes of joint angles looked at.
    fn work(&self) -> u64 {
        self.coverage.arm_boxes
    }

    fn cost(&self) -> u64 {
        sim::coverage::cost(self.robots.recall.steps(), self.questions, self.coverage.arm_boxes)
    }

    fn bytes(&self) -> usize {
        self.robots.bytes()
    }

    /// A person who is not there takes none.
    fn state_bytes(&self) -> usize {
        let second = if self.world.second.is_some() { 0 } else { size_of::<Option<Place>>() };
        size_of::<State>() - second
    }
}
