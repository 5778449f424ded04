//! One human action after the other against the running FMU, as a search [`Environment`].
//!
//! A [`Snapshot`] holds everything: the FMU's state (as a node of [`Recall`]), the person's exact place, the sensors'
//! delay lines and the step index. So restoring gives what the uninterrupted run would give. What an action does depends
//! on nothing else, so it is worked out once for each snapshot and remembered, unless everything is to be re-simulated.

mod through_curtain;

use std::collections::BTreeMap;
use std::sync::Arc;

use super::Coverage;
use super::curtain;
use super::encounter::{ArmSpace, Encounter, Person};
use super::robot::RobotFrame;
use super::sensors::{DelayLine, Seen, input_row, sees};
use crate::cell::binding::SensorBinding;
use crate::cell::{Binding, Workcell, Zone};
use crate::geometry::{Capsule, Cuboid, Vec3};
use crate::hazard::Contact;
use crate::hazard::Finding;
use crate::hazard::danger::{Proximity, UNSAFE_REWARD};
use crate::host::{Advanced, NodeId, Plant, PlantError, Policy, Recall};
use crate::human::arm::ArmModel;
use crate::human::walk::{WalkTrace, Walker};
use crate::human::{Action, BendFraction, Body, Place, Posture, Side, posture, shoulder};
use crate::search::{End, Environment, Step};
use crate::standards::iso_13855::WALKING_SPEED_M_S;

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
    place: Place,
    delays: Vec<DelayLine>,
    actions: Vec<Action>,
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

/// Body and robot farther apart than this are not compared, m: the least distance is then not known either.
const COMPARED_WITHIN_M: f64 = 1.0;

/// Most outcomes and most FMU states with robot frames that are remembered at a time, some hundred MB each; beyond that
/// all are forgotten and worked out again when they are needed.
const OUTCOMES_KEPT: usize = 300_000;
const FRAMES_KEPT: usize = 6_000;

/// What one action does from one snapshot.
#[derive(Clone, Debug)]
struct Outcome {
    /// Where it leads; `None` if the FMU could not finish it.
    to: Option<(NodeId, Place, Vec<DelayLine>)>,
    reward: f64,
    end: Option<End>,
    /// Findings with the last action only; the sequence that led here goes in front.
    findings: Vec<Finding>,
    fault: Option<String>,
    /// What was seen on the way.
    coverage: Coverage,
}

/// Everything an [`Outcome`] depends on. The number of actions so far follows from the node.
type Question = (NodeId, Place, Vec<DelayLine>, usize);

/// Sensors and inputs over one action.
struct Sensed {
    /// FMU inputs, one row a step.
    inputs: Vec<f64>,
    /// The delay lines afterwards.
    delays: Vec<DelayLine>,
    /// Readings in effect at the start of each step.
    readings: Vec<Vec<bool>>,
    /// For each step and light curtain, how many samples ago it was first broken; 0 for not at all.
    broken: Vec<Vec<usize>>,
}

/// A cell being simulated.
pub struct Simulation<P: Plant> {
    cell: Arc<Workcell>,
    binding: Arc<Binding>,
    options: Options,
    recall: Recall<P>,
    encounter: Encounter,
    body: Body,
    boxes: Vec<Cuboid>,
    /// Light curtains: index of the sensor, its plane.
    curtains: Vec<(usize, Cuboid)>,
    /// What each of them closes with the guarding beside it.
    closed: Vec<curtain::Closed>,
    /// Robot frames of each FMU state's last action.
    frames: BTreeMap<NodeId, Arc<[RobotFrame]>>,
    outcomes: BTreeMap<Question, Arc<Outcome>>,
    root: Snapshot,
    state: Snapshot,
    /// Where the person stood before the last action.
    from: Place,
    coverage: Coverage,
    findings: Vec<Finding>,
    faults: Vec<Fault>,
}

/// The input values an FMU gets at initialisation: sensors as they read at the person's start.
#[must_use]
pub fn initial_inputs(cell: &Workcell, binding: &Binding) -> Vec<f64> {
    let boxes: Vec<Cuboid> = cell.obstacles.iter().map(|(_, c)| *c).collect();
    let seen = seen(cell, &boxes, &Place::default(), Posture::Upright);
    let readings: Vec<bool> = cell.sensors.iter().map(|s| sees(s, &seen)).collect();
    let mut row = Vec::new();
    input_row(&cell.sensors, &cell.pose, binding, &readings, &seen, &mut row);
    row
}

fn sub_step_m(cell: &Workcell) -> f64 {
    WALKING_SPEED_M_S * cell.step_s
}

/// The person at `place` as sensors see it.
fn seen(cell: &Workcell, boxes: &[Cuboid], place: &Place, bent: Posture) -> Seen {
    let position = place.position(&cell.start, sub_step_m(cell));
    let heading_rad = place.heading_rad(&cell.start);
    let has_curtain = cell.sensors.iter().any(|s| matches!(s.zone, Zone::Curtain(_)));
    let body = has_curtain.then(|| {
        let bend = posture::cut_back(&cell.body, position, heading_rad, bent, boxes);
        cell.body.placed(position, heading_rad, bent, bend)
    });
    Seen { feet: cell.body.feet(position, heading_rad), body, position, heading_rad }
}

impl<P: Plant> Simulation<P> {
    /// Starts the plant and puts the person at the start.
    ///
    /// # Errors
    /// When the FMU cannot be started.
    pub fn new(cell: Arc<Workcell>, binding: Arc<Binding>, plant: P, options: Options) -> Result<Self, PlantError> {
        let recall = Recall::new(plant, options.policy)?;
        let boxes: Vec<Cuboid> = cell.obstacles.iter().map(|(_, c)| *c).collect();
        let body = cell.body.clone();
        let place = Place::default();
        let at_start = seen(&cell, &boxes, &place, Posture::Upright);
        let delays = cell.sensors.iter().map(|s| DelayLine::settled(sees(s, &at_start))).collect();
        let root = Snapshot { node: NodeId::ROOT, place, delays, actions: Vec::new() };
        let encounter = Encounter {
            obstacles: boxes.clone(),
            arm: ArmModel::default(),
            reach_tolerance_m: cell.search.reach_tolerance_m,
        };
        let curtains = cell.sensors.iter().enumerate().filter_map(|(i, s)| match &s.zone {
            Zone::Curtain(plane) => Some((i, *plane)),
            _ => None,
        });
        let curtains: Vec<(usize, Cuboid)> = curtains.collect();
        Ok(Self {
            closed: curtains.iter().map(|(_, plane)| curtain::Closed::new(plane, &boxes)).collect(),
            curtains,
            coverage: Coverage::new(cell.sensors.len()),
            cell,
            binding,
            options,
            recall,
            encounter,
            body,
            boxes,
            frames: BTreeMap::new(),
            outcomes: BTreeMap::new(),
            state: root.clone(),
            root,
            from: place,
            findings: Vec::new(),
            faults: Vec::new(),
        })
    }

    /// Begins a new run: what was seen and found is forgotten, what is known of the cell stays.
    pub fn begin_run(&mut self) {
        self.coverage = Coverage::new(self.cell.sensors.len());
        self.findings.clear();
        self.faults.clear();
        self.state = self.root.clone();
    }

    /// Findings since the last call.
    pub fn take_findings(&mut self) -> Vec<Finding> {
        std::mem::take(&mut self.findings)
    }

    /// What was seen so far.
    #[must_use]
    pub const fn coverage(&self) -> &Coverage {
        &self.coverage
    }

    /// Actions the FMU could not finish; the first few with their sequences.
    #[must_use]
    pub fn faults(&self) -> &[Fault] {
        &self.faults
    }

    /// The FMU's states and what reaching them cost.
    #[must_use]
    pub const fn recall(&self) -> &Recall<P> {
        &self.recall
    }

    /// Whether the person's start is free of obstacles.
    #[must_use]
    pub fn start_is_free(&self) -> bool {
        self.walker().is_free(self.root.place)
    }

    /// Where the person stands, floor plan, m.
    #[must_use]
    pub fn position(&self) -> Vec3 {
        self.state.place.position(&self.cell.start, sub_step_m(&self.cell))
    }

    /// Person's position and robot after each step of the last action taken.
    #[must_use]
    pub fn last_action(&self) -> Vec<(Vec3, RobotFrame)> {
        let Some(frames) = self.frames.get(&self.state.node) else { return Vec::new() };
        let Some(action) = self.state.actions.last() else { return Vec::new() };
        let walked = self.walker().walk(self.from, action.walk(), self.cell.steps_per_action);
        let place = |p: &Place| p.position(&self.cell.start, sub_step_m(&self.cell));
        walked.places.iter().map(place).zip(frames.iter().cloned()).collect()
    }

    /// The body's capsules, world, for a person who stands at `xy` and looks along `heading_deg` in the posture of
    /// `action`.
    #[must_use]
    pub fn body_at(&self, xy: [f64; 2], heading_deg: f64, action: Option<Action>) -> Vec<Capsule> {
        let position = Vec3::new(xy[0], xy[1], 0.0);
        let heading = heading_deg.to_radians();
        let bent = action.map_or(Posture::Upright, Action::posture);
        let bend = posture::cut_back(&self.body, position, heading, bent, &self.boxes);
        self.body.placed(position, heading, bent, bend).parts().iter().map(|(_, c)| *c).collect()
    }

    /// Takes an action from the present state.
    fn act(&mut self, action: Action) -> Result<Step, PlantError> {
        let outcome = self.outcome(action)?;
        self.coverage.merge(&outcome.coverage);
        let mut actions = self.state.actions.clone();
        for finding in &outcome.findings {
            let mut finding = finding.clone();
            finding.actions.splice(0..0, actions.iter().copied());
            self.findings.push(finding);
        }
        actions.push(action);
        if let Some(message) = &outcome.fault {
            if self.faults.len() < FAULTS_KEPT && self.faults.iter().all(|f| f.message != *message) {
                self.faults.push(Fault { actions, message: message.clone() });
            }
        } else if let Some((node, place, delays)) = &outcome.to {
            self.from = self.state.place;
            self.state = Snapshot { node: *node, place: *place, delays: delays.clone(), actions };
        }
        Ok(Step { reward: outcome.reward, end: outcome.end })
    }

    /// What an action does from the present state, remembered or worked out.
    fn outcome(&mut self, action: Action) -> Result<Arc<Outcome>, PlantError> {
        if self.options.policy == Policy::Replay {
            return Ok(Arc::new(self.work_out(action)?));
        }
        let question = (self.state.node, self.state.place, self.state.delays.clone(), action.index());
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

    /// Walks, runs the sensors and the FMU, and compares person and robot at every step.
    fn work_out(&mut self, action: Action) -> Result<Outcome, PlantError> {
        let mut coverage = Coverage::new(self.cell.sensors.len());
        coverage.actions = 1;
        let walked = self.walker().walk(self.state.place, action.walk(), self.cell.steps_per_action);
        coverage.walks_blocked = u64::from(walked.blocked.contains(&true));
        let sensed = self.sense(&walked, action.posture());
        let node = match self.recall.advance(self.state.node, self.cell.steps_per_action, &sensed.inputs)? {
            Advanced::To(node) => node,
            Advanced::Fault(fault) => {
                coverage.episodes_not_evaluated = 1;
                return Ok(Outcome {
                    to: None,
                    reward: Proximity::Far.reward(),
                    end: Some(End::NotEvaluated),
                    findings: Vec::new(),
                    fault: Some(fault.message.clone()),
                    coverage,
                });
            }
        };
        let frames = self.frames(node);
        coverage.robot_top_speed_m_s = frames.iter().map(|f| f.fastest).fold(0.0, f64::max);
        for (sensor, fired) in coverage.sensor_actions.iter_mut().enumerate() {
            let any = (0..frames.len()).any(|i| self.reading(sensor, &sensed.readings[i], &frames[i]));
            *fired = u64::from(any);
        }
        let mut findings = Vec::new();
        if self.options.posture_sweep {
            self.sweep(&walked, action, &sensed, &frames, &mut findings, &mut coverage)?;
        }
        let hit = self.first_unsafe(&walked, action, &sensed, &frames, &mut coverage)?;
        let last = walked.places.len() - 1;
        let (reward, end) = if let Some(finding) = hit {
            findings.push(finding);
            (UNSAFE_REWARD, Some(End::Unsafe))
        } else if self.state.actions.len() + 1 < self.horizon() {
            (0.0, None)
        } else {
            let person = self.person(&walked, last, action.posture());
            let walls: Vec<Cuboid> = self.curtains.iter().map(|(_, plane)| curtain::unbroken(plane)).collect();
            let space = ArmSpace { walls: &walls, links: None };
            let proximity = self.encounter.proximity(&person, &frames[last], &space, &mut coverage);
            (proximity.reward(), Some(End::Horizon))
        };
        let to = Some((node, walked.places[last], sensed.delays));
        Ok(Outcome { to, reward, end, findings, fault: None, coverage })
    }

    /// Sensor readings at the start of each step, and the FMU inputs that follow.
    fn sense(&self, walked: &WalkTrace, bent: Posture) -> Sensed {
        let steps = walked.places.len();
        let mut sensed = Sensed {
            inputs: Vec::with_capacity(steps * self.binding.inputs.len()),
            delays: self.state.delays.clone(),
            readings: Vec::with_capacity(steps),
            broken: Vec::new(),
        };
        for before in std::iter::once(&walked.start).chain(&walked.places).take(steps) {
            let seen = seen(&self.cell, &self.boxes, before, bent);
            let sensors = self.cell.sensors.iter().zip(&mut sensed.delays);
            let readings: Vec<bool> =
                sensors.map(|(sensor, line)| line.push(sees(sensor, &seen), sensor.delay_steps)).collect();
            input_row(&self.cell.sensors, &self.cell.pose, &self.binding, &readings, &seen, &mut sensed.inputs);
            sensed.readings.push(readings);
            sensed.broken.push(self.curtains.iter().map(|(s, _)| sensed.delays[*s].first_seen()).collect());
        }
        sensed
    }

    /// Whether a sensor reports the person: what it told the FMU at the start of the step, or what the FMU says of its
    /// own one at the step's end.
    fn reading(&self, sensor: usize, readings: &[bool], frame: &RobotFrame) -> bool {
        match &self.binding.sensors[sensor] {
            SensorBinding::Input(_) => readings[sensor],
            SensorBinding::Output(reader) => (reader.read(frame.outputs()) != 0.0) == self.cell.sensors[sensor].active,
        }
    }

    /// The robot after each step of the action into `node`.
    fn frames(&mut self, node: NodeId) -> Arc<[RobotFrame]> {
        if let Some(frames) = self.frames.get(&node) {
            return Arc::clone(frames);
        }
        if self.frames.len() >= FRAMES_KEPT {
            self.frames.clear();
        }
        let rows = self.recall.outputs(node).chunks(self.binding.outputs.len());
        let frames: Arc<[RobotFrame]> = rows.map(|row| RobotFrame::new(&self.cell, &self.binding, row)).collect();
        self.frames.insert(node, Arc::clone(&frames));
        frames
    }

    /// The other postures with the same walk. Where no light curtain sees the difference they give the FMU the same
    /// inputs, so its outputs hold for them too.
    fn sweep(
        &mut self,
        walked: &WalkTrace,
        action: Action,
        sensed: &Sensed,
        frames: &Arc<[RobotFrame]>,
        findings: &mut Vec<Finding>,
        coverage: &mut Coverage,
    ) -> Result<(), PlantError> {
        for posture in Posture::ALL.into_iter().filter(|p| *p != action.posture()) {
            let sibling = Action::new(action.walk(), posture);
            let found = if self.curtains.is_empty() {
                self.first_unsafe(walked, sibling, sensed, frames, coverage)?
            } else {
                let own = self.sense(walked, posture);
                let advanced = self.recall.advance(self.state.node, self.cell.steps_per_action, &own.inputs)?;
                let Advanced::To(node) = advanced else { continue };
                let frames = self.frames(node);
                self.first_unsafe(walked, sibling, &own, &frames, coverage)?
            };
            findings.extend(found);
        }
        Ok(())
    }

    /// The first instant of an action with an unsafe contact.
    fn first_unsafe(
        &mut self,
        walked: &WalkTrace,
        action: Action,
        sensed: &Sensed,
        frames: &Arc<[RobotFrame]>,
        coverage: &mut Coverage,
    ) -> Result<Option<Finding>, PlantError> {
        for i in 0..frames.len() {
            coverage.contact_checks += 1;
            if !self.near(walked, i, &frames[i]) {
                continue;
            }
            let person = self.person(walked, i, action.posture());
            let mut readings = sensed.readings[i].clone();
            let mut found = None;
            let body_contact = self.encounter.unsafe_body_contact(&person, &frames[i], coverage);
            let in_time = |contact: &Contact| self.in_time(contact.on_robot, walked, i, &sensed.broken);
            if let Some(contact) = body_contact.filter(in_time) {
                found = Some((contact, None, frames[i].phase(contact.link), None));
            } else if self.curtains.is_empty() {
                let hit = self.encounter.unsafe_arm_contact(&person, &frames[i], &ArmSpace::OPEN, coverage);
                found = hit.map(|(contact, arm)| (contact, arm, frames[i].phase(contact.link), None));
            } else if let Some(reached) = self.reach_through(&person, walked, i, sensed, frames, coverage)? {
                if let Some(curtain) = reached.broke {
                    readings[curtain] = true;
                }
                found = Some((reached.contact, reached.arm, reached.phase, reached.since_s));
            }
            let Some((contact, arm, phase, since_s)) = found else { continue };
            let Some(class) = contact.class() else { continue };
            let step = self.state.actions.len() * self.cell.steps_per_action + i + 1;
            let place = &walked.places[i];
            let sensors = (0..self.cell.sensors.len()).map(|s| self.reading(s, &readings, &frames[i])).collect();
            #[expect(clippy::cast_precision_loss, reason = "at most 64 000 steps")]
            let time_s = step as f64 * self.cell.step_s;
            return Ok(Some(Finding {
                class,
                contact,
                actions: vec![action],
                step,
                time_s,
                person: place.position(&self.cell.start, sub_step_m(&self.cell)),
                heading_rad: place.heading_rad(&self.cell.start),
                bend_sixteenths: self.bend(place, action.posture()).sixteenths(),
                arm,
                sensors,
                phase,
                through_curtain_s: since_s,
            }));
        }
        Ok(None)
    }

    /// Whether any part of the person could touch the robot, or come so near that the distance is worth knowing.
    fn near(&self, walked: &WalkTrace, i: usize, frame: &RobotFrame) -> bool {
        // A robot that a light curtain would have stopped may be elsewhere.
        if !self.curtains.is_empty() {
            return true;
        }
        let centre = walked.places[i].position(&self.cell.start, sub_step_m(&self.cell)) + Vec3::Z;
        let reach = self.body.reach_from_one_metre(self.encounter.arm.reach());
        frame.links.iter().any(|l| {
            let (c, r) = l.bounding_sphere();
            (c - centre).length() - r - reach <= COMPARED_WITHIN_M
        })
    }

    fn bend(&self, place: &Place, bent: Posture) -> BendFraction {
        let position = place.position(&self.cell.start, sub_step_m(&self.cell));
        posture::cut_back(&self.body, position, place.heading_rad(&self.cell.start), bent, &self.boxes)
    }

    fn walker(&self) -> Walker<'_> {
        Walker {
            body: &self.body,
            start: &self.cell.start,
            sub_step_len_m: sub_step_m(&self.cell),
            obstacles: &self.boxes,
        }
    }

    fn person(&self, walked: &WalkTrace, i: usize, bent: Posture) -> Person {
        let place = &walked.places[i];
        let before = if i == 0 { &walked.start } else { &walked.places[i - 1] };
        let at = |p: &Place| p.position(&self.cell.start, sub_step_m(&self.cell));
        let heading = place.heading_rad(&self.cell.start);
        let body = self.body.placed(at(place), heading, bent, self.bend(place, bent));
        let arms = Side::BOTH.into_iter().filter(|&s| shoulder::is_available(&body, s, &self.boxes)).collect();
        Person { body, arms, velocity: (at(place) - at(before)) / self.cell.step_s }
    }
}

impl<P: Plant> Environment for Simulation<P> {
    type Snapshot = Snapshot;
    type Error = PlantError;

    fn actions(&self) -> usize {
        Action::COUNT
    }

    fn horizon(&self) -> usize {
        usize::try_from(self.cell.search.actions).unwrap_or(usize::MAX)
    }

    fn reset(&mut self) -> Result<(), PlantError> {
        self.coverage.episodes += 1;
        self.state = self.root.clone();
        Ok(())
    }

    fn step(&mut self, action: usize) -> Result<Step, PlantError> {
        self.act(Action::ALL[action])
    }

    fn save(&self) -> Snapshot {
        self.state.clone()
    }

    fn restore(&mut self, snapshot: &Snapshot) -> Result<(), PlantError> {
        self.state.clone_from(snapshot);
        Ok(())
    }
}
