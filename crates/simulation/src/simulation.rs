//! One human action after the other against the running FMU, as a search [`Environment`].
//!
//! A [`Snapshot`] holds everything: the FMU's state (as a node of [`Recall`]), the people's exact places, the sensors'
//! delay lines and the step index. So restoring gives what the uninterrupted run would give. What an action does depends
//! on nothing else, so it is worked out once for each snapshot and remembered, unless everything is to be re-simulated.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::sync::Arc;

use super::Coverage;
use super::action::{ActionStart, CarriedOut};
use super::action_hazards::{ActionHazards, PersonCourse};
use super::encounter::ArmSpace;
use super::motion::Motion;
use super::robot::RobotFrame;
use super::robots::{Instead, Robots};
use super::sensors::DelayLine;
use super::surrogate::Surrogate;
use super::world::{self, InputTrace, Occupant, PersonState, Places, Walks, World};
use crate::cell::{Binding, Workcell};
use crate::geometry::Vec3;
use crate::hazard::Finding;
use crate::hazard::danger::{Proximity, UNSAFE_REWARD};
use crate::host::{Advanced, NodeId, Plant, PlantError, Policy, Recall};
use crate::human::walk::WalkTrace;
use crate::human::{Action, Arrangement, PlacedBody, Posture, Presses, Who};
use crate::search::{End, Environment, Step};

/// Settings of a simulation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// How FMU states are brought back.
    pub policy: Policy,
    /// Check all six postures whenever they give the FMU the same inputs; off, iterations count as in the paper.
    pub posture_sweep: bool,
}

/// Everything needed to come back to a state.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    node: NodeId,
    places: Places,
    delays: Vec<DelayLine>,
    switched: Presses,
    actions: Vec<Action>,
    /// Whether the FMU could finish every run in which a plane tells of an arm, on the way here.
    evaluated: bool,
    /// Whether a hazard by contact came before, where that does not end a sequence for clamping.
    struck: bool,
}

/// An action the FMU could not finish.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// The sequence that leads there.
    pub actions: Vec<Action>,
    /// What happened.
    pub message: String,
}

/// Different faults kept with their sequences; further ones are only counted.
const FAULTS_KEPT: usize = 20;

/// Most outcomes that are remembered at a time, some hundred MB; beyond that all are forgotten and worked out again when
/// they are needed.
const OUTCOMES_KEPT: usize = 300_000;

/// What there is to see at one instant.
#[derive(Clone, Debug)]
pub struct Instant {
    /// Where the person stands, floor plan, m.
    pub position: Vec3,
    /// The body.
    pub body: PlacedBody,
    /// The second person's place and body, if there is one.
    pub second: Option<(Vec3, PlacedBody)>,
    /// Whether each sensor reports the person.
    pub readings: Vec<bool>,
    /// How things stand that follow the FMU.
    pub arrangement: Arrangement,
    /// The robots.
    pub frame: RobotFrame,
}

/// A sequence from the start, with everything that there is to see.
#[derive(Clone, Debug)]
pub struct RecordedRun {
    /// The start, then the end of each step.
    pub instants: Vec<Instant>,
    /// Inputs of the FMU, one row a step.
    pub inputs: Vec<f64>,
    /// Its outputs, one row a step.
    pub outputs: Vec<f64>,
    /// The controls that are really worked in each action.
    pub worked: Vec<Presses>,
}

impl RecordedRun {
    /// The same as seen by one of two people: that one as the person, and the other as the second.
    #[must_use]
    pub fn by(mut self, who: Who) -> Self {
        let swap = |instant: &mut Instant| {
            if let Some((position, body)) = &mut instant.second {
                std::mem::swap(position, &mut instant.position);
                std::mem::swap(body, &mut instant.body);
            }
        };
        if who == Who::Second {
            self.instants.iter_mut().for_each(swap);
        }
        self
    }
}

/// An arm in a plane, which then tells of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReachedThrough {
    /// The plane's sensor.
    pub sensor: usize,
    /// The steps, counted from the start, at which the FMU is told.
    pub steps: Range<usize>,
}

/// What one action does from one snapshot.
#[derive(Clone, Debug)]
struct ActionOutcome {
    /// Where it leads; `None` if the FMU could not finish it.
    to: Option<(NodeId, Places, Vec<DelayLine>, Presses)>,
    reward: f64,
    end: Option<End>,
    /// States of the FMU that had to be reached to work this out.
    reached: BTreeSet<NodeId>,
    /// Findings with the last action only; the sequence that led here goes in front.
    findings: Vec<Finding>,
    /// Clampings behind the first hazard by contact, in the same way.
    behind: Vec<Finding>,
    fault: Option<String>,
    /// Whether the FMU could finish every run in which a plane tells of an arm, or none was needed to find a contact.
    evaluated: bool,
    /// What was seen on the way.
    coverage: Coverage,
}

/// Everything an [`ActionOutcome`] depends on. The number of actions so far follows from the node, and so do controls that are
/// switched over.
/// Whether a hazard by contact came before, comes last.
type ActionKey = (NodeId, Places, Vec<DelayLine>, Action, bool);

/// The same of what one of the people meets in it.
type PersonQuestion = (Who, ActionKey);

/// What the contact check of an action tells.
#[derive(Clone, Debug)]
struct ContactCheck {
    met: PersonCourse,
    coverage: Coverage,
    /// States of the FMU that had to be reached for it.
    reached: BTreeSet<NodeId>,
}

/// A cell being simulated.
pub struct Simulation<P: Plant> {
    pub(super) world: Arc<World>,
    options: Options,
    pub(super) robots: Robots<P>,
    /// What this run has seen of the robots, and what follows from it.
    pub(super) imagination: Surrogate,
    outcomes: BTreeMap<ActionKey, Arc<ActionOutcome>>,
    /// Contact checks by the state that the action leads to: each posture is looked at with every other one's walk.
    looks: BTreeMap<PersonQuestion, Arc<ContactCheck>>,
    root: Snapshot,
    state: Snapshot,
    coverage: Coverage,
    findings: Vec<Finding>,
    behind: Vec<Finding>,
    faults: Vec<Fault>,
}

impl<P: Plant> Simulation<P> {
    /// Starts the plant and puts the person at the start.
    ///
    /// # Errors
    /// When the FMU cannot be started.
    pub fn new(cell: Arc<Workcell>, binding: Arc<Binding>, plant: P, options: Options) -> Result<Self, PlantError> {
        let stop = plant.stop();
        let recall = Recall::new(plant, options.policy)?;
        let world = Arc::new(World::new(cell, binding).heeding(&stop));
        let robots = Robots::new(Arc::clone(&world), recall);
        let root = Snapshot {
            node: NodeId::ROOT,
            places: robots.starts(),
            delays: world.delays_at_start(),
            switched: Presses::NONE,
            actions: Vec::new(),
            evaluated: true,
            struck: false,
        };
        Ok(Self {
            coverage: world.nothing_seen(),
            robots,
            imagination: Surrogate::new(&world),
            world,
            options,
            outcomes: BTreeMap::new(),
            looks: BTreeMap::new(),
            state: root.clone(),
            root,
            findings: Vec::new(),
            behind: Vec::new(),
            faults: Vec::new(),
        })
    }

    /// Begins a new run: what was seen and found is forgotten, what is known of the cell stays.
    pub fn begin_run(&mut self) {
        self.coverage = self.world.nothing_seen();
        self.findings.clear();
        self.behind.clear();
        self.faults.clear();
        self.imagination.forget();
        self.state = self.root.clone();
    }

    /// Communication steps that a simulation which remembers every transition had to take since the run began: those of
    /// the different actions of the FMU, told apart by all inputs until then. What earlier runs left behind does not
    /// count; actions that the FMU could not finish are left out.
    #[must_use]
    pub fn fmu_steps_of_run(&self) -> u64 {
        (self.imagination.reached() * self.world.cell.steps_per_action) as u64
    }

    /// Findings since the last call.
    pub fn take_findings(&mut self) -> Vec<Finding> {
        std::mem::take(&mut self.findings)
    }

    /// Clampings since the last call that came behind the first hazard by contact of their sequence.
    pub fn take_behind(&mut self) -> Vec<Finding> {
        std::mem::take(&mut self.behind)
    }

    /// Whether more actions may be taken for what comes behind the first hazard by contact: one came, and clamping counts.
    #[must_use]
    pub const fn goes_on(&self) -> bool {
        self.state.struck
    }

    /// Actions since the last reset, as they were taken.
    #[must_use]
    pub fn taken(&self) -> &[Action] {
        &self.state.actions
    }

    /// What was seen so far.
    #[must_use]
    pub const fn coverage(&self) -> &Coverage {
        &self.coverage
    }

    /// What was done so far, in communication steps, about, what was only imagined included: the same on every machine.
    #[must_use]
    pub fn cost(&self) -> u64 {
        let (real, unreal) = (&self.coverage, self.imagination.coverage());
        let questions = real.contact_checks + unreal.contact_checks;
        super::coverage::cost(self.recall().steps(), questions, real.arm_boxes + unreal.arm_boxes)
    }

    /// What was seen of the robots' motion, in all runs so far.
    #[must_use]
    pub const fn motion(&self) -> &Motion {
        self.robots.motion()
    }

    /// Actions the FMU could not finish; the first few with their sequences.
    #[must_use]
    pub fn faults(&self) -> &[Fault] {
        &self.faults
    }

    /// Whether all that was asked of the FMU since the last reset is known: else a contact may have been missed.
    #[must_use]
    pub const fn is_evaluated(&self) -> bool {
        self.state.evaluated
    }

    /// Why the last action that the FMU could not finish was not evaluated.
    #[must_use]
    pub fn not_evaluated(&self) -> PlantError {
        let otherwise = match self.robots.has_strayed() {
            true => "what follows the FMU would stand otherwise had a plane told of an arm, which is not followed up",
            false => "the FMU could not finish an action",
        };
        let why = self.faults.last().map_or(otherwise, |fault| &fault.message);
        PlantError::of(why)
    }

    /// The FMU's states and what reaching them cost.
    #[must_use]
    pub const fn recall(&self) -> &Recall<P> {
        &self.robots.recall
    }

    /// What does not change over the scan.
    #[must_use]
    pub const fn world(&self) -> &Arc<World> {
        &self.world
    }

    /// Runs `actions` from the start and keeps everything that there is to see, without looking for contacts. An arm that
    /// reaches `through` planes is reported, as trunk and legs are.
    ///
    /// # Errors
    /// When the FMU fails.
    pub fn watch(&mut self, actions: &[Action], through: &[ReachedThrough]) -> Result<RecordedRun, PlantError> {
        let world = Arc::clone(&self.world);
        let Snapshot { mut node, mut places, mut delays, mut switched, .. } = self.root.clone();
        let mut watched = RecordedRun {
            instants: vec![self.at_start()],
            inputs: Vec::new(),
            outputs: Vec::new(),
            worked: Vec::new(),
        };
        for (number, action) in actions.iter().enumerate() {
            let action = world.taken_by_all(&places, *action);
            let begun = watched.instants.len() - 1;
            let tell = |sensed: &mut InputTrace| {
                for ReachedThrough { sensor, steps } in through {
                    let steps = steps.start.saturating_sub(begun)..steps.end.saturating_sub(begun);
                    world.report_arm(*sensor, steps, sensed);
                }
            };
            let from = ActionStart { node, places, delays: &delays, switched };
            let CarriedOut { walks, sensed, advanced } = self.robots.go(&from, action, &tell)?;
            node = match advanced {
                Advanced::To(node) => node,
                Advanced::Fault(fault) => return Err((*fault).clone()),
            };
            for (i, frame) in self.robots.frames(node).iter().enumerate() {
                let placed = |who: Who| {
                    let (own, walked) = (world.of(who)?, walks.of(who)?);
                    let stance = own.stance(walked, (number, i), action.of(who).posture(), &sensed);
                    Some((own.position(&walked.places[i]), own.body_of(&stance)))
                };
                let Some((position, body)) = placed(Who::First) else { continue };
                watched.instants.push(Instant {
                    position,
                    body,
                    second: placed(Who::Second),
                    readings: world.readings(&sensed.readings[i], frame),
                    arrangement: walks.first.places[i].arrangement(),
                    frame: RobotFrame::clone(frame),
                });
            }
            watched.outputs.extend_from_slice(self.robots.recall.outputs(node));
            watched.inputs.extend(sensed.inputs);
            watched.worked.push(world.worked_by(&walks.starts(), action).presses);
            places = self.robots.amid_what_is_said(&walks.ends(), node);
            (delays, switched) = (sensed.delays, sensed.switched);
        }
        Ok(watched)
    }

    /// What there is to see at the present state, and nothing if the FMU cannot show it.
    ///
    /// # Errors
    /// When the FMU fails.
    pub fn now(&mut self) -> Result<Instant, PlantError> {
        let actions = self.state.actions.clone();
        let watched = self.watch(&actions, &[])?;
        watched.instants.into_iter().next_back().ok_or_else(|| PlantError::of("nothing was watched"))
    }

    /// Where the person looks at the present state, rad from +x towards +y.
    #[must_use]
    pub fn heading_rad(&self) -> f64 {
        self.state.places.first.heading_rad(&self.world.cell.start)
    }

    /// Person, sensors and robot at the start.
    fn at_start(&self) -> Instant {
        let world = &self.world;
        let row = world.binding.rows(self.robots.recall.outputs(NodeId::ROOT), None, world.cell.step_s);
        let frame = RobotFrame::new(&world.cell, &world.binding, &row);
        let placed = |own: &Occupant| {
            let (who, place, posture) = (own.who, own.start(), Posture::Upright);
            let stance = PersonState { who, place, posture, moved: 0, broken: Vec::new(), raised: None, struck: false };
            (own.position(&place), own.body_of(&stance))
        };
        let (position, body) = placed(&world.first);
        Instant {
            position,
            body,
            second: world.second.as_ref().map(placed),
            readings: world.readings(&world.readings_at_start(), &frame),
            arrangement: self.root.places.first.arrangement(),
            frame,
        }
    }

    /// Takes an action from the present state, whether or not it is one of those that the cell's person does.
    ///
    /// # Errors
    /// When the FMU fails, or the search has to end.
    pub fn take(&mut self, action: Action) -> Result<Step, PlantError> {
        let step = self.act(action)?;
        // What was looked for may not have been looked for to its end.
        if self.world.stop().is_due() {
            self.findings.clear();
            self.behind.clear();
            return Err(PlantError::stopped());
        }
        Ok(step)
    }

    fn act(&mut self, action: Action) -> Result<Step, PlantError> {
        let action = self.world.taken_by_all(&self.state.places, action);
        let outcome = self.outcome(action)?;
        self.coverage.merge(&outcome.coverage);
        self.imagination.add_reached(&outcome.reached);
        let mut actions = self.state.actions.clone();
        for (told, list) in [(&outcome.findings, &mut self.findings), (&outcome.behind, &mut self.behind)] {
            for finding in told {
                let mut finding = finding.clone();
                finding.actions.splice(0..0, actions.iter().copied());
                list.push(finding);
            }
        }
        actions.push(action);
        let arm = (outcome.coverage.arm_runs_not_evaluated > 0).then(|| self.robots.unfinished()).flatten();
        if let Some(message) = outcome.fault.clone().or(arm)
            && self.faults.len() < FAULTS_KEPT
            && self.faults.iter().all(|f| f.message != message)
        {
            self.faults.push(Fault { actions: actions.clone(), message });
        }
        let evaluated = self.state.evaluated && outcome.evaluated;
        if let Some((node, places, delays, switched)) = &outcome.to {
            let (node, places, switched) = (*node, *places, *switched);
            let was_struck = self.state.struck;
            let struck = was_struck || (outcome.end == Some(End::Unsafe) && self.world.goes_on());
            self.state = Snapshot { node, places, delays: delays.clone(), switched, actions, evaluated, struck };
            if outcome.end.is_some() && !was_struck {
                self.imagination.observe(&self.world, &self.robots.recall, node, &self.state.actions);
            }
        }
        let end = match outcome.end {
            Some(End::Horizon) if !evaluated => {
                self.coverage.episodes_not_evaluated += 1;
                Some(End::NotEvaluated)
            }
            end => end,
        };
        Ok(Step { reward: outcome.reward, end })
    }

    /// What an action does from the present state, remembered or worked out.
    fn outcome(&mut self, action: Action) -> Result<Arc<ActionOutcome>, PlantError> {
        if self.options.policy == Policy::Replay {
            return Ok(Arc::new(self.work_out(action)?));
        }
        let question = (self.state.node, self.state.places, self.state.delays.clone(), action, self.state.struck);
        if let Some(known) = self.outcomes.get(&question) {
            return Ok(Arc::clone(known));
        }
        let outcome = Arc::new(self.work_out(action)?);
        if self.outcomes.len() >= OUTCOMES_KEPT {
            self.outcomes.clear();
        }
        self.outcomes.insert(question, Arc::clone(&outcome));
        Ok(outcome)
    }

    /// Walks, runs the sensors and the FMU, and compares people and robots at every step.
    fn work_out(&mut self, action: Action) -> Result<ActionOutcome, PlantError> {
        let mut coverage = crate::nothing_seen(&self.world.cell);
        coverage.actions = 1;
        self.robots.take_reached();
        let CarriedOut { walks, sensed, advanced } = self.go(action)?;
        coverage.walks_blocked = u64::from(walks.blocked());
        let node = match advanced {
            Advanced::To(node) => node,
            Advanced::Fault(fault) => {
                coverage.episodes_not_evaluated = 1;
                return Ok(ActionOutcome {
                    to: None,
                    reward: Proximity::Far.reward(),
                    end: Some(End::NotEvaluated),
                    reached: BTreeSet::new(),
                    findings: Vec::new(),
                    behind: Vec::new(),
                    fault: Some(fault.message.clone()),
                    evaluated: false,
                    coverage,
                });
            }
        };
        let worked = self.world.worked_by(&walks.starts(), action).presses;
        self.robots.note(&walks.each().collect::<Vec<_>>(), node, worked, &mut coverage);
        let frames = self.robots.frames(node);
        coverage.robot_top_speed_m_s = frames.iter().map(|f| f.fastest).fold(0.0, f64::max);
        for (sensor, fired) in coverage.sensor_actions.iter_mut().enumerate() {
            let any = (0..frames.len()).any(|i| self.world.reading(sensor, &sensed.readings[i], &frames[i]));
            *fired = u64::from(any);
        }
        let mut told = ActionFindings::default();
        if self.options.posture_sweep {
            for (who, _) in walks.each() {
                self.sweep(&walks, (who, action), &sensed, node, &mut told, &mut coverage)?;
            }
        }
        let unfinished = coverage.arm_runs_not_evaluated;
        let befallen = self.befallen(&walks, action, &sensed, node, &mut coverage)?;
        let ends = !befallen.ends.is_empty();
        let evaluated = ends || coverage.arm_runs_not_evaluated == unfinished;
        told.add(befallen, self.state.struck, |_| true);
        // Behind a hazard by contact an episode is over, and clamping is all that is asked.
        let (reward, end) = if ends || self.state.struck {
            (UNSAFE_REWARD, Some(End::Unsafe))
        } else if self.state.actions.len() + 1 < self.horizon() {
            (0.0, None)
        } else {
            let world = Arc::clone(&self.world);
            let last = frames.len() - 1;
            let reward = walks.each().map(|(who, walked)| {
                let own = world.of(who).unwrap_or(&world.first);
                let when = (self.state.actions.len(), last);
                let person = own.person(&own.stance(walked, when, action.of(who).posture(), &sensed));
                let walls = own.unbroken();
                let space = ArmSpace { walls: &walls, links: None };
                let encounter = own.encounter(&walked.places[last]);
                encounter.proximity(&person, &frames[last], &space, &mut coverage).reward()
            });
            (reward.fold(Proximity::Far.reward(), f64::max), Some(End::Horizon))
        };
        let to = Some((node, self.robots.amid_what_is_said(&walks.ends(), node), sensed.delays, sensed.switched));
        let reached = self.robots.take_reached();
        let ActionFindings { findings, behind } = told;
        Ok(ActionOutcome { to, reward, end, reached, findings, behind, fault: None, evaluated, coverage })
    }

    /// What becomes of an action from the present state.
    fn go(&mut self, action: Action) -> Result<CarriedOut, PlantError> {
        let Snapshot { node, places, delays, switched, .. } = &self.state;
        let from = ActionStart { node: *node, places: *places, delays, switched: *switched };
        self.robots.go(&from, action, &|_| {})
    }

    /// The other postures of one of the people with the same walk. Where no light curtain sees the difference they give the FMU the
    /// same inputs, so its outputs hold for them too.
    fn sweep(
        &mut self,
        walks: &Walks,
        (who, action): (Who, Action),
        sensed: &InputTrace,
        node: NodeId,
        told: &mut ActionFindings,
        coverage: &mut Coverage,
    ) -> Result<(), PlantError> {
        let world = Arc::clone(&self.world);
        let Some(repertoire) = world.cell.repertoire.of(who) else { return Ok(()) };
        let own = action.of(who);
        for posture in repertoire.postures().iter().copied().filter(|p| *p != own.posture()) {
            let sibling = action.with(who, own.in_posture(posture));
            // Low ones lead other ways and are seen otherwise: they are actions for themselves.
            if posture.is_low() || own.posture().is_low() {
                continue;
            }
            let found = if world.posture_is_unseen() && action.presses().is_none() {
                self.befallen(walks, sibling, sensed, node, coverage)?
            } else {
                // Another posture may get to another door.
                let CarriedOut { walks, sensed, advanced } = self.go(sibling)?;
                let Advanced::To(node) = advanced else { continue };
                self.befallen(&walks, sibling, &sensed, node, coverage)?
            };
            // What befalls the other one is told with their own postures.
            told.add(found, self.state.struck, |finding| finding.who == who);
        }
        Ok(())
    }

    /// What befalls everybody in the action into `node`.
    fn befallen(
        &mut self,
        walks: &Walks,
        action: Action,
        sensed: &InputTrace,
        node: NodeId,
        coverage: &mut Coverage,
    ) -> Result<ActionHazards, PlantError> {
        let mut each = Vec::new();
        for (who, _) in walks.each() {
            each.push(self.of_one(walks, (who, action), sensed, node, coverage)?);
        }
        Ok(ActionHazards::of(each.iter()))
    }

    /// What one of the people meets in the action into `node`, as if they were alone, remembered or looked for.
    fn of_one(
        &mut self,
        walks: &Walks,
        (who, action): (Who, Action),
        sensed: &InputTrace,
        node: NodeId,
        coverage: &mut Coverage,
    ) -> Result<PersonCourse, PlantError> {
        let Some(walked) = walks.of(who) else { return Ok(PersonCourse::default()) };
        let own = action.of(who);
        let in_action = |finding: Finding| Finding { actions: vec![action], ..finding };
        if self.options.policy == Policy::Replay {
            let met = self.look((who, walked), own, sensed, node, coverage)?;
            return Ok(met.each(in_action));
        }
        // With the state that it leads to, what was sensed follows from what was on its way before.
        let question = (who, (node, walks.starts(), self.state.delays.clone(), action, self.state.struck));
        let known = self.looks.get(&question).map(Arc::clone);
        let look = if let Some(known) = known {
            known
        } else {
            let before = self.robots.take_reached();
            let mut counted = Coverage::new(self.world.cell.sensors.len());
            let met = self.look((who, walked), own, sensed, node, &mut counted)?;
            let look = Arc::new(ContactCheck { met, coverage: counted, reached: self.robots.take_reached() });
            self.robots.add_reached(&before);
            if self.looks.len() >= OUTCOMES_KEPT {
                self.looks.clear();
            }
            self.looks.insert(question, Arc::clone(&look));
            look
        };
        self.robots.add_reached(&look.reached);
        coverage.merge(&look.coverage);
        Ok(look.met.clone().each(in_action))
    }

    fn look(
        &mut self,
        (who, walked): (Who, &WalkTrace),
        action: Action,
        sensed: &InputTrace,
        node: NodeId,
        coverage: &mut Coverage,
    ) -> Result<PersonCourse, PlantError> {
        let frames = self.robots.frames(node);
        let world = Arc::clone(&self.world);
        let own = world.of(who).unwrap_or(&world.first);
        let (mut met, mut struck) = (PersonCourse::default(), self.state.struck);
        for i in 0..frames.len() {
            let when = (self.state.actions.len(), i);
            let stance = PersonState { struck, ..own.stance(walked, when, action.posture(), sensed) };
            let told = world.any_reports(&sensed.readings[i], &frames[i]);
            let earlier = Instead::new(&mut self.robots, node, i, told);
            let mut instant = world::Instant { frames: &frames, i, earlier };
            let Some(hit) = own.contact(&stance, &mut instant, coverage)? else { continue };
            let when = (self.state.actions.len() + 1, i);
            let finding = |hit| own.finding(hit, &stance, world.readings(&sensed.readings[i], &frames[i]), when);
            let Some(found) = finding(&hit) else { continue };
            if struck {
                met.is_clamped(found);
                continue;
            }
            let ends = found.class.ends();
            met.meets(found, hit.clamps.as_deref().and_then(finding));
            if ends && !self.world.goes_on() {
                break;
            }
            struck = ends;
        }
        Ok(met)
    }
}

/// What is told of an action.
#[derive(Default)]
struct ActionFindings {
    /// Until the first hazard by contact.
    findings: Vec<Finding>,
    /// Clampings behind it.
    behind: Vec<Finding>,
}

impl ActionFindings {
    /// Adds what befalls people of whom this is asked; `struck` where a hazard by contact came before.
    fn add(&mut self, befallen: ActionHazards, struck: bool, counts: impl Fn(&Finding) -> bool) {
        let ActionHazards { ends, noted, clampings } = befallen;
        self.findings.extend(noted.into_iter().chain(ends).filter(&counts));
        let news = clampings.into_iter().filter(|(_, is_told)| struck || !is_told);
        self.behind.extend(news.map(|(finding, _)| finding).filter(counts));
    }
}

impl<P: Plant> Environment for Simulation<P> {
    type Snapshot = Snapshot;
    type Error = PlantError;

    fn actions(&self) -> usize {
        self.world.cell.repertoire.count()
    }

    fn horizon(&self) -> usize {
        usize::try_from(self.world.cell.search.actions).unwrap_or(usize::MAX)
    }

    fn reset(&mut self) -> Result<(), PlantError> {
        self.coverage.episodes += 1;
        self.state = self.root.clone();
        Ok(())
    }

    fn step(&mut self, action: usize) -> Result<Step, PlantError> {
        self.take(self.world.cell.repertoire.action(action))
    }

    fn save(&self) -> Snapshot {
        self.state.clone()
    }

    fn restore(&mut self, snapshot: &Snapshot) -> Result<(), PlantError> {
        self.state.clone_from(snapshot);
        Ok(())
    }
}
