//! One human action after the other against the running FMU, as a search [`Environment`].
//!
//! A [`Snapshot`] holds everything: the FMU's state (as a node of [`Recall`]), the person's exact place, the sensors'
//! delay lines and the step index. So restoring gives what the uninterrupted run would give.

use std::sync::Arc;

use super::Coverage;
use super::encounter::{Encounter, Person};
use super::robot::RobotFrame;
use super::sensors::{DelayLine, input_row, sees};
use crate::cell::{Binding, Workcell};
use crate::geometry::{Capsule, Cuboid, Vec3};
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

/// A cell being simulated.
pub struct Simulation<P: Plant> {
    cell: Arc<Workcell>,
    binding: Arc<Binding>,
    options: Options,
    recall: Recall<P>,
    encounter: Encounter,
    body: Body,
    boxes: Vec<Cuboid>,
    /// Robot frames of each FMU state's last action, by node index.
    frames: Vec<Option<Arc<[RobotFrame]>>>,
    root: Snapshot,
    state: Snapshot,
    /// The person's places after each step of the last action.
    last_places: Vec<Place>,
    coverage: Coverage,
    findings: Vec<Finding>,
    faults: Vec<Fault>,
}

/// The input values an FMU gets at initialisation: sensors as they read at the person's start.
#[must_use]
pub fn initial_inputs(cell: &Workcell, binding: &Binding) -> Vec<f64> {
    let body = &cell.body;
    let place = Place::default();
    let feet = body.feet(place.position(&cell.start, sub_step_m(cell)), place.heading_rad(&cell.start));
    let readings: Vec<bool> = cell.sensors.iter().map(|s| sees(s, &feet)).collect();
    let mut row = Vec::new();
    input_row(&cell.sensors, binding, &readings, &mut row);
    row
}

fn sub_step_m(cell: &Workcell) -> f64 {
    WALKING_SPEED_M_S * cell.step_s
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
        let feet = body.feet(place.position(&cell.start, sub_step_m(&cell)), place.heading_rad(&cell.start));
        let delays = cell.sensors.iter().map(|s| DelayLine::settled(sees(s, &feet))).collect();
        let root = Snapshot { node: NodeId::ROOT, place, delays, actions: Vec::new() };
        let encounter = Encounter {
            obstacles: boxes.clone(),
            arm: ArmModel::default(),
            reach_tolerance_m: cell.search.reach_tolerance_m,
        };
        let coverage = Coverage::new(cell.sensors.len());
        Ok(Self {
            cell,
            binding,
            options,
            recall,
            encounter,
            body,
            boxes,
            frames: Vec::new(),
            state: root.clone(),
            root,
            last_places: Vec::new(),
            coverage,
            findings: Vec::new(),
            faults: Vec::new(),
        })
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
        let Some(Some(frames)) = self.frames.get(self.state.node.index()) else { return Vec::new() };
        let place = |p: &Place| p.position(&self.cell.start, sub_step_m(&self.cell));
        self.last_places.iter().map(place).zip(frames.iter().cloned()).collect()
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

    /// Walks, runs the sensors and the FMU, and compares person and robot at every step.
    fn act(&mut self, action: Action) -> Result<Step, PlantError> {
        let depth = self.state.actions.len();
        self.coverage.actions += 1;
        let walked = self.walker().walk(self.state.place, action.walk(), self.cell.steps_per_action);
        self.coverage.walks_blocked += u64::from(walked.blocked.contains(&true));
        let (inputs, delays, readings) = self.sense(&walked);
        let mut actions = self.state.actions.clone();
        actions.push(action);
        let node = match self.recall.advance(self.state.node, self.cell.steps_per_action, &inputs)? {
            Advanced::To(node) => node,
            Advanced::Fault(fault) => {
                let fault = Fault { actions, message: fault.message.clone() };
                if self.faults.len() < FAULTS_KEPT && self.faults.iter().all(|f| f.message != fault.message) {
                    self.faults.push(fault);
                }
                self.coverage.episodes_not_evaluated += 1;
                return Ok(Step { reward: Proximity::Far.reward(), end: Some(End::NotEvaluated) });
            }
        };
        let frames = self.frames(node);
        self.findings_of_siblings(&walked, &frames, &readings, &actions);
        let hit = self.first_unsafe(&walked, &frames, &readings, &actions);
        let last = walked.places.len() - 1;
        self.last_places.clone_from(&walked.places);
        self.state = Snapshot { node, place: walked.places[last], delays, actions };
        if let Some(finding) = hit {
            self.findings.push(finding);
            return Ok(Step { reward: UNSAFE_REWARD, end: Some(End::Unsafe) });
        }
        if depth + 1 < self.horizon() {
            return Ok(Step { reward: 0.0, end: None });
        }
        let frame = &frames[last];
        let person = self.person(&walked, last, action.posture());
        let proximity = self.encounter.proximity(&person, frame, &mut self.coverage);
        Ok(Step { reward: proximity.reward(), end: Some(End::Horizon) })
    }

    /// Sensor readings at the start of each step, as FMU inputs; the delay lines after the action.
    fn sense(&mut self, walked: &WalkTrace) -> (Vec<f64>, Vec<DelayLine>, Vec<Vec<bool>>) {
        let mut delays = self.state.delays.clone();
        let mut inputs = Vec::with_capacity(walked.places.len() * self.binding.inputs.len());
        let mut all = Vec::with_capacity(walked.places.len());
        let mut fired = vec![false; self.cell.sensors.len()];
        for before in std::iter::once(&walked.start).chain(&walked.places).take(walked.places.len()) {
            let position = before.position(&self.cell.start, sub_step_m(&self.cell));
            let feet = self.body.feet(position, before.heading_rad(&self.cell.start));
            let readings: Vec<bool> = self
                .cell
                .sensors
                .iter()
                .zip(&mut delays)
                .map(|(sensor, line)| line.push(sees(sensor, &feet), sensor.delay_steps))
                .collect();
            fired.iter_mut().zip(&readings).for_each(|(f, r)| *f |= r);
            input_row(&self.cell.sensors, &self.binding, &readings, &mut inputs);
            all.push(readings);
        }
        self.coverage.sensor_actions.iter_mut().zip(fired).for_each(|(n, f)| *n += u64::from(f));
        (inputs, delays, all)
    }

    /// The robot after each step of the action into `node`.
    fn frames(&mut self, node: NodeId) -> Arc<[RobotFrame]> {
        if self.frames.len() <= node.index() {
            self.frames.resize(node.index() + 1, None);
        }
        if let Some(frames) = &self.frames[node.index()] {
            return Arc::clone(frames);
        }
        let rows = self.recall.outputs(node).chunks(self.binding.outputs.len());
        let frames: Arc<[RobotFrame]> = rows.map(|row| RobotFrame::new(&self.cell, &self.binding, row)).collect();
        let fastest = frames.iter().map(|f| f.fastest).fold(0.0, f64::max);
        self.coverage.robot_top_speed_m_s = self.coverage.robot_top_speed_m_s.max(fastest);
        self.frames[node.index()] = Some(Arc::clone(&frames));
        frames
    }

    /// The other postures with the same walk: they give the FMU the same inputs, since every sensor looks at feet and
    /// legs, so the FMU's outputs hold for them too.
    fn findings_of_siblings(
        &mut self,
        walked: &WalkTrace,
        frames: &[RobotFrame],
        readings: &[Vec<bool>],
        actions: &[Action],
    ) {
        let Some((&action, prefix)) = actions.split_last().filter(|_| self.options.posture_sweep) else { return };
        for posture in Posture::ALL.into_iter().filter(|p| *p != action.posture()) {
            let mut sibling = prefix.to_vec();
            sibling.push(Action::new(action.walk(), posture));
            if let Some(finding) = self.first_unsafe(walked, frames, readings, &sibling) {
                self.findings.push(finding);
            }
        }
    }

    /// The first instant of the last of `actions` with an unsafe contact.
    fn first_unsafe(
        &mut self,
        walked: &WalkTrace,
        frames: &[RobotFrame],
        readings: &[Vec<bool>],
        actions: &[Action],
    ) -> Option<Finding> {
        let posture = actions.last()?.posture();
        for (i, frame) in frames.iter().enumerate() {
            self.coverage.contact_checks += 1;
            if !self.near(walked, i, frame) {
                continue;
            }
            let person = self.person(walked, i, posture);
            let Some((contact, arm)) = self.encounter.unsafe_contact(&person, frame, &mut self.coverage) else {
                continue;
            };
            let step = (actions.len() - 1) * self.cell.steps_per_action + i + 1;
            let place = &walked.places[i];
            #[expect(clippy::cast_precision_loss, reason = "at most 64 000 steps")]
            let time_s = step as f64 * self.cell.step_s;
            return Some(Finding {
                class: contact.class()?,
                contact,
                actions: actions.to_vec(),
                step,
                time_s,
                person: place.position(&self.cell.start, sub_step_m(&self.cell)),
                heading_rad: place.heading_rad(&self.cell.start),
                bend_sixteenths: self.bend(place, posture).sixteenths(),
                arm,
                sensors: readings[i].clone(),
                phase: frame.phase,
            });
        }
        None
    }

    /// Whether any part of the person could touch the robot, or come closer to it than ever before in this run. Only
    /// the coverage depends on the run: without a touch there is nothing to find.
    fn near(&mut self, walked: &WalkTrace, i: usize, frame: &RobotFrame) -> bool {
        let centre = walked.places[i].position(&self.cell.start, sub_step_m(&self.cell)) + Vec3::Z;
        let gap = frame.links.iter().map(|l| {
            let (c, r) = l.bounding_sphere();
            (c - centre).length() - r
        });
        let gap = gap.fold(f64::MAX, f64::min) - self.body.reach_from_one_metre(self.encounter.arm.reach());
        gap <= self.coverage.closest_approach_m.max(0.0)
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
