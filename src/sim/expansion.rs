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
//! well, because what an arm meets depends on them (see [`super::curtain`]). With two planes that an arm may pass at once the
//! inputs have to be the same.

use std::collections::{BTreeMap, BTreeSet};
use std::convert::Infallible;
use std::sync::Arc;
use std::sync::atomic::Ordering;

use super::Coverage;
use super::bound::RobotBounds;
use super::encounter::Person;
use super::harmless::{Harmless, settle};
use super::journal::{Block, Journal};
use super::motion::Motion;
use super::robots::{Instead, Robots, Shadow};
use super::sensors::DelayLine;
use super::threads::shared_out;
use super::world::{Asked, Earlier, Frames, HadTold, Hit, Instant, Sensed, Sight, Stance, Window, World};
use crate::cell::{Binding, Workcell};
use crate::hazard::Finding;
use crate::host::{Advanced, NodeId, Plant, PlantError, Policy, Recall};
use crate::human::walk::WalkTrace;
use crate::human::{Action, Place, Posture, Walk};
use crate::search::exhaustive::{Effect, Expanded, Expansion};

/// A state of the cell at the end of an action. Equal states have the same future.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct State {
    // Places first: neighbours in the order then share most of their questions.
    place: Place,
    /// The first state of the FMU found that is the same.
    node: NodeId,
    delays: Box<[DelayLine]>,
}

/// How equal states of the FMU are told.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
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
    bounds: RobotBounds,
    workers: usize,
    by_bytes: bool,
    /// With a plane: the first node with the same state and the same states had the plane told of an arm; by the samples since
    /// the body was first seen in it, and how many such states there are.
    bundles: BTreeMap<(Vec<usize>, Vec<Shadow>), NodeId>,
    harmless: Harmless,
    coverage: Coverage,
    journal: Journal,
    questions: u64,
}

/// An action's FMU answer and what it was asked.
struct Transition {
    node: NodeId,
    frames: Frames,
    sensed: Sensed,
}

/// Where the actions from a place lead, and what there is for the sensors to see on the way.
struct Ahead {
    /// By walk.
    walks: Vec<WalkTrace>,
    /// By walk and posture; one posture only where the sensors see all alike.
    sights: Vec<Vec<Vec<Sight>>>,
}

/// What is not known yet of an action from a state.
struct Pending {
    /// Index of the state, of the walk, of the transition among those of the state.
    state: usize,
    walk: usize,
    transition: usize,
    action: Action,
}

/// The robots at an instant, and as they would be had planes told of an arm.
struct Situation {
    /// Whether any of them is fast enough to harm, or not known.
    may_harm: bool,
    frames: Frames,
    i: usize,
    /// By the windows in which they told.
    earlier: BTreeMap<Vec<Window>, HadTold<Frames>>,
}

impl Earlier for &Situation {
    type Error = Infallible;

    fn told_of(&mut self, windows: &[Window]) -> Result<HadTold<Frames>, Infallible> {
        Ok(self.earlier.get(windows).cloned().unwrap_or(HadTold::BeforeTime))
    }
}

impl Ahead {
    fn new(world: &World, place: Place) -> Self {
        let walk = |w| world.walk(place, Action::new(w, Posture::Upright));
        let walks: Vec<WalkTrace> = Walk::ALL.into_iter().map(walk).collect();
        let sights = |walked: &WalkTrace| {
            let told_apart = if world.posture_is_unseen_on(walked) { &Posture::ALL[..1] } else { &Posture::ALL };
            told_apart.iter().map(|&bent| world.sights(walked, bent)).collect()
        };
        Self { sights: walks.iter().map(sights).collect(), walks }
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
struct Situations {
    rows: Rows,
    /// By the numbers of their rows, and the windows that these belong to.
    numbers: BTreeMap<(Vec<u32>, Vec<Asked>), usize>,
    /// By node, step and the windows of planes.
    known: BTreeMap<(NodeId, usize, Vec<Asked>), usize>,
    all: Vec<Situation>,
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

/// Numbers of the next state and of the transition, or why there is none.
type Reached = Result<(usize, usize), String>;

/// A stance, and the numbers of the situations that it is asked about.
type Question = (Stance, Vec<usize>);

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
        let by_bytes = merge == Merge::Auto && recall.merge_equal_states()?;
        let world = Arc::new(World::new(cell, binding).heeding(stop));
        Ok(Self {
            bounds: RobotBounds::new(&world.cell),
            robots: Robots::new(Arc::clone(&world), recall),
            workers: workers.max(1),
            by_bytes,
            bundles: BTreeMap::new(),
            harmless: Harmless::default(),
            coverage: Coverage::new(world.cell.sensors.len()),
            questions: 0,
            journal: Journal::default(),
            world,
        })
    }

    /// The same, going on from what `journal` holds and adding to it.
    #[must_use]
    pub fn with_journal(mut self, journal: Journal) -> Self {
        self.journal = journal;
        self
    }

    /// What was worked out before.
    #[must_use]
    pub const fn journal(&self) -> &Journal {
        &self.journal
    }

    /// The same, when the search is over.
    #[must_use]
    pub fn into_journal(self) -> Journal {
        self.journal
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
        if self.world.curtains.is_empty() {
            return Ok(same);
        }
        if !self.world.neighbours.is_empty() {
            return Ok(node);
        }
        let (mut sinces, mut bundle) = (Vec::new(), vec![Shadow::Is(same)]);
        for plane in 0..self.world.curtains.len() {
            let since = delays[self.world.curtains[plane].sensor].first_seen();
            let shadows = self.robots.shadows(node, place, plane, since)?;
            bundle.extend(shadows.into_iter().map(|shadow| shadow.map(|n| self.robots.recall.same(n))));
            sinces.extend([since, bundle.len()]);
        }
        Ok(*self.bundles.entry((sinces, bundle)).or_insert(node))
    }

    /// The part that needs the FMU: successors, transitions, and the actions whose contacts are to be looked for.
    fn advance(
        &mut self,
        index: usize,
        depth: usize,
        state: &State,
        ahead: &Ahead,
        pending: &mut Vec<Pending>,
    ) -> Result<(Expanded<State, Finding>, Vec<Transition>), PlantError> {
        let mut expanded = Expanded { next: Vec::new(), effects: Vec::new() };
        let mut transitions: Vec<Transition> = Vec::new();
        let per_action = self.world.cell.steps_per_action;
        let last = depth + 1 == self.horizon();
        for (w, walk) in Walk::ALL.into_iter().enumerate() {
            // Postures that the sensors see alike share everything but the contacts.
            let mut alike: Vec<(Sensed, Reached)> = Vec::new();
            for (p, posture) in Posture::ALL.into_iter().enumerate() {
                let action = Action::new(walk, posture);
                let own = ahead.sights[w].get(p).map(|sights| self.world.sense(&state.delays, sights));
                let known = match &own {
                    None => alike.first().map(|(_, to)| to.clone()),
                    Some(own) => alike.iter().find(|(s, _)| s.same(own)).map(|(_, to)| to.clone()),
                };
                let to = match (known, own) {
                    (Some(to), _) => to,
                    (None, None) => Err(String::new()),
                    (None, Some(sensed)) => {
                        let to = match self.robots.recall.advance(state.node, per_action, &sensed.inputs)? {
                            Advanced::Fault(fault) => {
                                self.coverage.episodes_not_evaluated += 1;
                                Err(fault.message.clone())
                            }
                            Advanced::To(node) => {
                                let place = ahead.walks[w].end();
                                // Where the sequences end, nothing depends on which state it is.
                                let representative =
                                    if last { node } else { self.representative(node, &place, &sensed.delays)? };
                                let delays = sensed.delays.clone().into_boxed_slice();
                                expanded.next.push(State { place, node: representative, delays });
                                let frames = self.robots.frames(node);
                                self.look(&ahead.walks[w], &sensed, &frames);
                                transitions.push(Transition { node, frames, sensed: sensed.clone() });
                                Ok((expanded.next.len() - 1, transitions.len() - 1))
                            }
                        };
                        alike.push((sensed, to.clone()));
                        to
                    }
                };
                let (next, transition) = match to {
                    Ok(to) => to,
                    Err(reason) => {
                        expanded.effects.push(Effect::NotEvaluated(reason));
                        continue;
                    }
                };
                expanded.effects.push(Effect::To(next));
                pending.push(Pending { state: index, walk: w, transition, action });
            }
        }
        Ok((expanded, transitions))
    }

    fn look(&mut self, walked: &WalkTrace, sensed: &Sensed, frames: &Frames) {
        let coverage = &mut self.coverage;
        coverage.actions += 1;
        coverage.walks_blocked += u64::from(walked.blocked.contains(&true));
        let fastest = frames.iter().map(|f| f.fastest).fold(0.0, f64::max);
        coverage.robot_top_speed_m_s = coverage.robot_top_speed_m_s.max(fastest);
        for (sensor, fired) in coverage.sensor_actions.iter_mut().enumerate() {
            let any = (0..frames.len()).any(|i| self.world.reading(sensor, &sensed.readings[i], &frames[i]));
            *fired += u64::from(any);
        }
    }

    /// The number of the situation after step `i` of a transition, for a person at this place.
    fn situation(
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

    /// Where the actions from each of these states lead, worked out on all threads; nothing if told to stop.
    fn look_ahead(&self, states: &[&State], go_on: &mut dyn FnMut() -> bool) -> Option<BTreeMap<Place, Ahead>> {
        let places: BTreeSet<Place> = states.iter().map(|state| state.place).collect();
        let places: Vec<Place> = places.into_iter().collect();
        let world = &self.world;
        let looked = shared_out(self.workers, places.len(), go_on, |numbers, _| {
            numbers.map(|number| Ahead::new(world, places[number])).collect::<Vec<_>>()
        })?;
        Some(places.iter().copied().zip(looked.into_iter().flatten()).collect())
    }

    /// Finds out of all poses of the pending actions at once where arms are harmless, on all threads; `false` if told to stop.
    ///
    /// Who stands or turns is in the same pose at every instant of an action, and many actions lead through the same poses.
    /// At planes it matters when they were passed: there each instant is asked about by itself.
    fn settle_arms<'a>(
        &mut self,
        pending: &[Pending],
        transitions: &[Vec<Transition>],
        walked: &dyn Fn(&Pending) -> &'a WalkTrace,
        go_on: &mut dyn FnMut() -> bool,
    ) -> bool {
        if !self.world.curtains.is_empty() {
            return true;
        }
        let of = |p: &'_ Pending| {
            let (frames, walked, posture) = (&transitions[p.state][p.transition].frames, walked(p), p.action.posture());
            frames.iter().zip(&walked.places).map(move |(frame, place)| ((*place, posture), frame))
        };
        let harmful = pending.iter().flat_map(of).filter(|(_, frame)| frame.may_harm);
        let unsettled = self.harmless.unsettled(harmful);
        // These count as no questions: whoever asks them later gets the answer.
        let instants = unsettled.iter().map(|(_, frames)| frames.len() as u64).sum::<u64>();
        let asked = (0, instants, self.robots.recall.trail());
        let (settled, coverage) = match self.journal.next(asked) {
            Some(Block { found, coverage, .. }) => (found, coverage),
            None => {
                let (world, sensors) = (&self.world, self.world.cell.sensors.len());
                let settled = shared_out(self.workers, unsettled.len(), go_on, |numbers, stopped| {
                    let mut coverage = Coverage::new(sensors);
                    let mut settled = Vec::new();
                    for number in numbers {
                        let narrow = |n: usize| u32::try_from(n).unwrap_or(u32::MAX);
                        let harmless = settle(world, &unsettled[number], &mut coverage);
                        settled.extend(harmless.into_iter().map(|n| (narrow(number), narrow(n))));
                        // What was under way then says nothing.
                        if world.stop().is_due() {
                            stopped.store(true, Ordering::Relaxed);
                            break;
                        }
                    }
                    (settled, coverage)
                });
                let Some(settled) = settled else { return false };
                let (mut found, mut total) = (Vec::new(), Coverage::new(sensors));
                for (settled, coverage) in settled {
                    total.merge(&coverage);
                    found.extend(settled);
                }
                if self.journal.keeps() {
                    self.journal.add(&Block { asked, found: found.clone(), coverage: total.clone() });
                }
                (found, total)
            }
        };
        self.coverage.merge(&coverage);
        let mut of_pose: Vec<Vec<usize>> = vec![Vec::new(); unsettled.len()];
        for (number, n) in settled {
            if let Some(harmless) = of_pose.get_mut(number as usize) {
                harmless.push(n as usize);
            }
        }
        for (pose, harmless) in unsettled.into_iter().zip(of_pose) {
            self.harmless.learn(pose, &harmless);
        }
        true
    }

    /// For each pending action the situation after step `i`, where anything could harm in it.
    fn asked<'a>(
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

    /// The same as questions, each once: stances, and the situations that each is asked about. And for each pending action
    /// where its answer will be: the number of the stance, and of the situation among those of it.
    fn to_ask<'a>(
        &self,
        i: usize,
        asked: Vec<Option<usize>>,
        pending: &[Pending],
        transitions: &[Vec<Transition>],
        walked: &dyn Fn(&Pending) -> &'a WalkTrace,
    ) -> (Vec<Question>, Vec<Option<(usize, usize)>>) {
        let mut numbers: BTreeMap<&[usize], usize> = BTreeMap::new();
        let mut all: Vec<_> = Vec::new();
        for ((number, p), situation) in pending.iter().enumerate().zip(asked) {
            let Some(situation) = situation else { continue };
            let sensed = &transitions[p.state][p.transition].sensed;
            let next = numbers.len();
            let broken = *numbers.entry(&sensed.broken[i]).or_insert(next);
            let (walked, posture) = (walked(p), p.action.posture());
            all.push(((walked.places[i], posture, World::has_walked(walked, i), broken), situation, number));
        }
        all.sort_unstable();
        let mut questions: Vec<Question> = Vec::new();
        let mut places = vec![None; pending.len()];
        for alike in all.chunk_by(|a, b| a.0 == b.0) {
            let p = &pending[alike[0].2];
            let stance =
                self.world.stance(walked(p), i, p.action.posture(), &transitions[p.state][p.transition].sensed);
            let mut situations: Vec<usize> = Vec::new();
            for (_, situation, number) in alike {
                if situations.last() != Some(situation) {
                    situations.push(*situation);
                }
                places[*number] = Some((questions.len(), situations.len() - 1));
            }
            questions.push((stance, situations));
        }
        (questions, places)
    }

    /// Answers all questions: each stance with the situations it is asked about.
    fn answer(
        &mut self,
        questions: &[Question],
        situations: &[Situation],
        go_on: &mut dyn FnMut() -> bool,
    ) -> Option<Vec<Vec<Option<Hit>>>> {
        let asked = questions.iter().map(|(_, asked)| asked.len() as u64).sum::<u64>();
        self.questions += asked;
        let asked = (asked, questions.len() as u64, self.robots.recall.trail());
        if let Some(block) = self.journal.next(asked) {
            self.coverage.merge(&block.coverage);
            let found = self.found_again(&block, questions, situations);
            // A search that had to end may have missed what is there.
            return (!self.world.stop().is_due()).then_some(found);
        }
        let (all, coverage) = self.work_out(questions, situations, go_on)?;
        if self.journal.keeps() {
            let number = |i: usize| u32::try_from(i).unwrap_or(u32::MAX);
            let of = |(q, hits): (usize, &Vec<Option<Hit>>)| {
                let found = hits.iter().enumerate().filter(|(_, hit)| hit.is_some());
                found.map(|(s, _)| (number(q), number(s))).collect::<Vec<_>>()
            };
            let found = all.iter().enumerate().flat_map(of).collect();
            self.journal.add(&Block { asked, found, coverage: coverage.clone() });
        }
        self.coverage.merge(&coverage);
        Some(all)
    }

    /// The answers to questions of which is known where something is to be found.
    fn found_again(&self, block: &Block, questions: &[Question], situations: &[Situation]) -> Vec<Vec<Option<Hit>>> {
        let mut all: Vec<Vec<Option<Hit>>> = questions.iter().map(|(_, asked)| vec![None; asked.len()]).collect();
        let mut counted = Coverage::new(self.world.cell.sensors.len());
        for together in block.found.chunk_by(|a, b| a.0 == b.0) {
            let Some((stance, asked)) = together.first().and_then(|(q, _)| questions.get(*q as usize)) else {
                continue;
            };
            // All of the stance, as before: what is found for one may follow from what was found for another.
            let mut instants = instants_of(&self.harmless, stance, asked, situations);
            let Ok(hits) = self.world.contacts(stance, &mut None, &mut instants, &mut counted);
            all[together[0].0 as usize] = hits;
        }
        all
    }

    /// Looks for contacts, on all threads.
    fn work_out(
        &self,
        questions: &[Question],
        situations: &[Situation],
        go_on: &mut dyn FnMut() -> bool,
    ) -> Option<(Vec<Vec<Option<Hit>>>, Coverage)> {
        let (world, harmless, sensors) = (&self.world, &self.harmless, self.world.cell.sensors.len());
        let found = shared_out(self.workers, questions.len(), go_on, |numbers, stopped| {
            let (mut answers, mut coverage) = (Vec::new(), Coverage::new(sensors));
            let mut last: Option<(&Stance, Option<Person>)> = None;
            for (stance, asked) in &questions[numbers] {
                let same = |known: &Stance| known.place == stance.place && known.posture == stance.posture;
                let mut posed = last.take().filter(|(known, _)| same(known)).and_then(|(_, posed)| posed);
                let mut instants = instants_of(harmless, stance, asked, situations);
                let Ok(hits) = world.contacts(stance, &mut posed, &mut instants, &mut coverage);
                last = Some((stance, posed));
                // What was under way then says nothing.
                if world.stop().is_due() {
                    stopped.store(true, Ordering::Relaxed);
                    break;
                }
                answers.push(hits);
            }
            (answers, coverage)
        })?;
        let (mut all, mut total) = (Vec::with_capacity(questions.len()), Coverage::new(sensors));
        for (answers, coverage) in found {
            total.merge(&coverage);
            all.extend(answers);
        }
        Some((all, total))
    }
}

/// What a stance is asked about, without the arms where they are known to be harmless.
fn instants_of<'a>(
    harmless: &Harmless,
    stance: &Stance,
    asked: &[usize],
    situations: &'a [Situation],
) -> Vec<Instant<'a, &'a Situation>> {
    let instant = |s: &usize| {
        let situation = &situations[*s];
        let arms = !harmless.knows(&(stance.place, stance.posture), &situation.frames[situation.i]);
        Instant { frames: &situation.frames, i: situation.i, earlier: situation, arms }
    };
    asked.iter().map(instant).collect()
}

impl<P: Plant> Expansion for Expander<P> {
    type State = State;
    type Unsafe = Finding;
    type Error = PlantError;

    fn actions(&self) -> usize {
        Action::COUNT
    }

    fn horizon(&self) -> usize {
        usize::try_from(self.world.cell.search.actions).unwrap_or(usize::MAX)
    }

    fn effort(&self, action: usize) -> u32 {
        Action::ALL[action].effort()
    }

    fn start(&mut self) -> Result<State, PlantError> {
        let delays = self.world.delays_at_start().into_boxed_slice();
        let place = self.world.start();
        let node = self.representative(NodeId::ROOT, &place, &delays)?;
        Ok(State { place, node, delays })
    }

    fn may_matter(&self, state: &State, remaining: usize) -> bool {
        self.bounds.may_meet(self.world.position(&state.place), self.world.reach_m(), remaining)
    }

    fn expand(
        &mut self,
        depth: usize,
        states: &[&State],
        go_on: &mut dyn FnMut() -> bool,
    ) -> Result<Option<Vec<Expanded<State, Finding>>>, PlantError> {
        let Some(ahead) = self.look_ahead(states, go_on) else { return Ok(None) };
        let (mut pending, mut expanded, mut transitions) = (Vec::new(), Vec::new(), Vec::new());
        for (index, state) in states.iter().enumerate() {
            if !go_on() {
                return Ok(None);
            }
            let (one, own) = self.advance(index, depth, state, &ahead[&state.place], &mut pending)?;
            expanded.push(one);
            transitions.push(own);
        }
        let walked = |p: &Pending| &ahead[&states[p.state].place].walks[p.walk];
        if !self.settle_arms(&pending, &transitions, &walked, go_on) {
            return Ok(None);
        }
        let mut situations = Situations::default();
        for i in 0..self.world.cell.steps_per_action {
            let asked = self.asked(i, &pending, &transitions, &walked, &mut situations)?;
            let (questions, places) = self.to_ask(i, asked, &pending, &transitions, &walked);
            let Some(answers) = self.answer(&questions, &situations.all, go_on) else { return Ok(None) };
            let mut places = places.iter();
            pending.retain(|p| {
                let Some(&(q, s)) = places.next().and_then(Option::as_ref) else { return true };
                let Some(hit) = &answers[q][s] else { return true };
                let transition = &transitions[p.state][p.transition];
                let readings = &transition.sensed.readings[i];
                let frame = &transition.frames[i];
                let finding = self.world.finding(hit, &questions[q].0, readings, frame, (depth + 1, i));
                let Some(finding) = finding else { return true };
                let finding = Finding { actions: vec![p.action], ..finding };
                expanded[p.state].effects[p.action.index()] = Effect::Unsafe(finding);
                false
            });
        }
        Ok(Some(expanded))
    }

    fn release_before(&mut self, depth: usize) {
        // What an arm meets that passes two planes at once is worked out from the beginning.
        if !self.world.neighbours.is_empty() {
            return;
        }
        let recall = &self.robots.recall;
        let keep: BTreeSet<NodeId> = self.bundles.values().copied().filter(|n| recall.depth(*n) >= depth).collect();
        self.bundles.retain(|_, node| keep.contains(node));
        self.robots.release(depth, |node| keep.contains(&node));
    }

    fn together(&self) -> usize {
        std::env::var("TOG").ok().and_then(|v| v.parse().ok()).unwrap_or(1024)
    }

    /// Boxes of joint angles looked at.
    fn work(&self) -> u64 {
        self.coverage.arm_boxes
    }

    fn cost(&self) -> u64 {
        super::coverage::cost(self.robots.recall.steps(), self.questions, self.coverage.arm_boxes)
    }

    fn bytes(&self) -> usize {
        self.robots.recall.bytes()
    }
}
