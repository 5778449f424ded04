//! The FMU's states, and the robots as its outputs tell them; also as they *would* be had planes told of an arm.
//!
//! Robots do the same in many states: what follows from outputs is worked out once for all actions with equal outputs,
//! before and in them, at the same time of the run.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use super::Coverage;
use super::motion::{Comparison, Motion};
use super::robot::RobotFrame;
use super::world::{Command, Frames, IfSignalled, SignalledRuns, Window, World};
use crate::hazard::STANDSTILL_M_S;
use crate::hazard::criterion::separation::{Stop, Stopping};
use crate::host::{Advanced, NodeId, Plant, PlantError, Recall};
use crate::human::walk::WalkTrace;
use crate::human::{Arrangement, Place, Presses, Who};

/// Most motions of robots that are remembered at a time, and most frames that differ, some hundred MB each; beyond
/// that all are forgotten and worked out again when they are needed.
const MOTIONS_KEPT: usize = 200_000;
const DIFFERENT_KEPT: usize = 50_000;

/// So many actions of 0.2 s are waited for robots to stand, 5 s; then they count as not stopping.
const MOST_ACTIONS_UNTIL_STILL: usize = 25;

/// A plane that tells of an arm: the steps, counted from the start of an action, in which its input is active besides.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct PlaneSignal {
    sensor: u16,
    first: i16,
    /// The first step again in which it is not; [`PlaneSignal::EVER`] for never.
    until: i16,
}

impl PlaneSignal {
    const EVER: i16 = i16::MAX;

    /// Steps from its beginning to its end, or for what never ends to that of an action of so many steps, which it begins
    /// in or before.
    fn earlier(self, per_action: i16) -> usize {
        let end = if self.until == Self::EVER { per_action } else { self.until };
        usize::try_from(end - self.first).unwrap_or(0)
    }

    /// Whether anything is told before the end of an action of so many steps.
    const fn counts(self, per_action: i16) -> bool {
        self.first < self.until && self.first < per_action
    }

    /// The same, counted from an action of so many steps before.
    const fn before(self, steps: i16) -> Self {
        let until = if self.until == Self::EVER { Self::EVER } else { self.until + steps };
        Self { first: self.first + steps, until, ..self }
    }
}

/// The state that stands in for another.
pub type Shadow = IfSignalled<NodeId>;

/// Those of a sensor, and when it ended, by how much earlier it began.
type Shadows = ((u16, i16), Vec<Option<Shadow>>);

/// The robots after each step of an action.
#[derive(Clone)]
pub struct Moved {
    pub(super) frames: Frames,
    /// For each frame a number that only equal ones have.
    pub numbers: Arc<[u32]>,
    /// Robots of which anything changes its place.
    pub(super) moving: BTreeSet<usize>,
}

/// The FMU's states, and the robots as its outputs tell them.
pub struct Robots<P: Plant> {
    world: Arc<World>,
    /// The FMU's states.
    pub recall: Recall<P>,
    /// The robots over an action, by the outputs before it, those of it ([`Recall::trace`]) and the actions until its end.
    motions: BTreeMap<(u32, u32, usize), Moved>,
    /// Frames that differ, by the bits of what they follow from, with their numbers.
    different: BTreeMap<Box<[u64]>, (u32, Arc<RobotFrame>)>,
    /// Numbers that were given to frames; none is given twice.
    numbered: u32,
    /// The states that stand in for others had a plane told of an arm, where they are known: by the number of the state;
    /// then by sensor and when it ended; then by how much earlier it began.
    shadows: Vec<Vec<Shadows>>,
    /// The same for several planes.
    of_several: BTreeMap<(NodeId, Box<[PlaneSignal]>), Shadow>,
    /// What the FMU said when it first could not finish such a run.
    unfinished: Option<String>,
    /// Whether in such a run something that follows the FMU would have done so otherwise.
    strayed: bool,
    /// States, each with one that stands in for it in such a run.
    astray: BTreeSet<(NodeId, NodeId)>,
    /// How everything that follows the FMU stands after each step of the action into a state.
    said: BTreeMap<NodeId, Arc<[Arrangement]>>,
    /// What stops take, by the state and the step of the action into it.
    stops: BTreeMap<(NodeId, usize), Arc<Stopping>>,
    /// States that were reached since they were last taken.
    reached: BTreeSet<NodeId>,
    /// How told speeds are compared with the motion, and what was seen of that in all frames.
    comparison: Comparison,
    motion: Motion,
}

impl<P: Plant> Robots<P> {
    /// Of a world, nothing of which was stepped yet.
    pub fn new(world: Arc<World>, recall: Recall<P>) -> Self {
        let comparison = Comparison::new(&world.cell, &world.binding);
        Self {
            world,
            recall,
            motions: BTreeMap::new(),
            different: BTreeMap::new(),
            numbered: 0,
            shadows: Vec::new(),
            of_several: BTreeMap::new(),
            unfinished: None,
            strayed: false,
            astray: BTreeSet::new(),
            said: BTreeMap::new(),
            stops: BTreeMap::new(),
            reached: BTreeSet::new(),
            comparison,
            motion: Motion::default(),
        }
    }

    /// What does not change over the scan.
    pub(super) const fn world(&self) -> &Arc<World> {
        &self.world
    }

    /// One action of the FMU from `node`.
    pub(super) fn advance(&mut self, node: NodeId, inputs: &[f64]) -> Result<Advanced, PlantError> {
        let advanced = self.recall.advance(node, self.world.cell.steps_per_action, inputs)?;
        if let Advanced::To(node) = advanced {
            self.reached.insert(node);
        }
        Ok(advanced)
    }

    /// The states that were reached since the last call.
    pub(super) fn take_reached(&mut self) -> BTreeSet<NodeId> {
        std::mem::take(&mut self.reached)
    }

    /// Counts these states as reached, too.
    pub(super) fn add_reached(&mut self, nodes: &BTreeSet<NodeId>) {
        self.reached.extend(nodes);
    }

    /// The robots after each step of the action into `node`.
    pub fn frames(&mut self, node: NodeId) -> Frames {
        Arc::clone(&self.moved(node).frames)
    }

    /// The same, with their numbers.
    pub fn moved(&mut self, node: NodeId) -> &Moved {
        let recall = &self.recall;
        let key = (recall.trace(recall.parent(node)), recall.trace(node), recall.depth(node));
        if !self.motions.contains_key(&key) {
            let moved = self.motion_into(node);
            if self.motions.len() >= MOTIONS_KEPT {
                self.motions.clear();
            }
            self.motions.insert(key, moved);
        }
        &self.motions[&key]
    }

    fn motion_into(&mut self, node: NodeId) -> Moved {
        if self.different.len() >= DIFFERENT_KEPT {
            self.different.clear();
        }
        let before = (node != NodeId::ROOT).then(|| &**self.recall.outputs(self.recall.parent(node)));
        let (binding, step_s) = (&self.world.binding, self.world.cell.step_s);
        let unsettled = if self.recall.depth(node) > 1 { 0 } else { self.comparison.unsettled() };
        let rows = binding.first_rows(self.recall.outputs(node), before, step_s, unsettled);
        let (world, different, numbered) = (&self.world, &mut self.different, &mut self.numbered);
        let frame = |row: &[f64]| {
            let bits = row.iter().map(|value| value.to_bits()).collect();
            let new = || {
                *numbered += 1;
                (*numbered, Arc::new(RobotFrame::new(&world.cell, &world.binding, row)))
            };
            different.entry(bits).or_insert_with(new).clone()
        };
        let (numbers, frames): (Vec<u32>, Vec<_>) = rows.chunks(world.binding.columns()).map(frame).unzip();
        let known = std::mem::take(&mut self.motion.moved);
        self.compare_speeds(node, &frames);
        let moving = self.motion.moved.clone();
        self.motion.moved.extend(known);
        Moved { frames: frames.into(), numbers: numbers.into(), moving }
    }

    /// Compares the told speeds with the motion over the action into `node`, and looks at how fast the links are.
    fn compare_speeds(&mut self, node: NodeId, frames: &[Arc<RobotFrame>]) {
        let parent = self.recall.parent(node);
        let actions = self.recall.depth(parent);
        if node == NodeId::ROOT {
            return;
        }
        let before = self.recall.outputs(parent);
        let rows: Vec<f64> = before.iter().chain(self.recall.outputs(node).iter()).copied().collect();
        let new = before.len() / self.world.binding.outputs.len();
        let step = actions * self.world.cell.steps_per_action + 1;
        self.comparison.look(&rows, step.saturating_sub(new), new, &mut self.motion);
        self.motion.look_at_links(frames, step);
    }

    /// What a stop takes that is commanded after step `i` of the action into `node`; nothing where separation does not count, or the
    /// figures are stated and a sensor has `told` of the person.
    pub fn stopping(&mut self, node: NodeId, i: usize, told: bool) -> Result<Option<Arc<Stopping>>, PlantError> {
        let world = Arc::clone(&self.world);
        let Some(separation) = &world.cell.separation else { return Ok(None) };
        if node == NodeId::ROOT {
            return Ok(None);
        }
        let frames = self.frames(node);
        match (&separation.stop, world.stop_command) {
            (Stop::Stated { .. }, _) if told => Ok(None),
            (Stop::Stated { reaction_s, stop_time_s, stop_distance_m }, _) => {
                let travel = |speed: &f64| speed * reaction_s + stop_distance_m;
                let travel_m = frames[i].speed_bounds.iter().map(travel).collect();
                Ok(Some(Arc::new(Stopping { time_s: reaction_s + stop_time_s, travel_m })))
            }
            (Stop::Measured(_), Some(command)) => {
                if let Some(known) = self.stops.get(&(node, i)) {
                    return Ok(Some(Arc::clone(known)));
                }
                let stopping = Arc::new(self.run_until_still(node, i, command)?);
                if self.stops.len() >= MOTIONS_KEPT {
                    self.stops.clear();
                }
                self.stops.insert((node, i), Arc::clone(&stopping));
                Ok(Some(stopping))
            }
            (Stop::Measured(name), None) => Err(PlantError::of(format!("`{name}` is no input of the FMU"))),
        }
    }

    /// Runs the FMU on after step `i` of the action into `node`, with a command as soon as it is told, until all robots stand.
    fn run_until_still(&mut self, node: NodeId, i: usize, command: Command) -> Result<Stopping, PlantError> {
        let Command { column, value, delay_steps } = command;
        let (per_action, width) = (self.world.cell.steps_per_action, self.world.binding.inputs.len());
        let mut inputs = self.recall.inputs(node);
        let last: Vec<f64> = inputs[inputs.len() - width..].to_vec();
        inputs.chunks_mut(width).skip(i + 1 + delay_steps).for_each(|row| row[column] = value);
        // Of the actions after it: what is left of the delay, then the command.
        let mut delay = (i + 1 + delay_steps).saturating_sub(per_action);
        let links = self.world.cell.links.len();
        let never = || Stopping { time_s: f64::INFINITY, travel_m: vec![f64::INFINITY; links] };
        let parent = self.recall.parent(node);
        let mut at = match self.recall.advance(parent, per_action, &inputs)? {
            Advanced::To(at) => at,
            // What the FMU would do is not known: as if it did not stop.
            Advanced::Fault(_) => return Ok(never()),
        };
        let mut since: Vec<Arc<RobotFrame>> = self.frames(at).iter().skip(i + 1).cloned().collect();
        for _ in 0..MOST_ACTIONS_UNTIL_STILL {
            let still = |frame: &Arc<RobotFrame>| frame.fastest <= STANDSTILL_M_S;
            if delay == 0 && since.len() >= per_action && since[since.len() - per_action..].iter().all(still) {
                let moving = since.iter().rposition(|frame| !still(frame)).map_or(0, |last| last + 1);
                #[expect(clippy::cast_precision_loss, reason = "a few hundred steps")]
                // It stands by the end of the step after the last at whose end it moves, and is no faster in a step than at its
                // faster end.
                let time_s = (moving + 1) as f64 * self.world.cell.step_s;
                let own = self.frames(node);
                let mut travel_m = vec![0.0; self.world.cell.links.len()];
                let ends = std::iter::once(&own[i]).chain(&since);
                for (begin, end) in ends.zip(&since[..=moving]) {
                    let speeds = begin.speed_bounds.iter().zip(&end.speed_bounds).map(|(a, b)| a.max(*b));
                    let steps = travel_m.iter_mut().zip(speeds);
                    steps.for_each(|(travel, speed)| *travel += speed * self.world.cell.step_s);
                }
                return Ok(Stopping { time_s, travel_m });
            }
            let mut held = last.repeat(per_action);
            held.chunks_mut(width).skip(delay).for_each(|row| row[column] = value);
            delay = delay.saturating_sub(per_action);
            at = match self.recall.advance(at, per_action, &held)? {
                Advanced::To(at) => at,
                Advanced::Fault(_) => return Ok(never()),
            };
            since.extend(self.frames(at).iter().cloned());
        }
        Ok(never())
    }

    /// Notes of an action into `node`, so many before it, which robots moved in it, how fast they are, and who was near them.
    pub fn note(&mut self, walks: &[(Who, &WalkTrace)], node: NodeId, worked: Presses, coverage: &mut Coverage) {
        let before = self.recall.depth(self.recall.parent(node));
        let moved = self.moved(node).clone();
        for robot in moved.moving {
            coverage.robot(robot).moved = true;
        }
        self.world.count_near(walks, before, &moved.frames, coverage);
        let controls = coverage.control_actions.iter_mut().enumerate();
        controls.for_each(|(control, actions)| *actions += u64::from(worked.has(control)));
    }

    /// What was seen so far of the robots' motion.
    pub const fn motion(&self) -> &Motion {
        &self.motion
    }

    /// What the FMU said when it first could not finish a run in which planes told of an arm.
    pub fn unfinished(&self) -> Option<String> {
        let message = self.unfinished.as_ref()?;
        Some(format!("while a plane told of an arm: {message}"))
    }

    /// Whether in such a run something that follows the FMU would have done so otherwise: it is not followed up.
    pub const fn has_strayed(&self) -> bool {
        self.strayed
    }

    /// The state after the action into `node` had planes told of an arm besides.
    fn if_signalled(&mut self, node: NodeId, told: &[PlaneSignal]) -> Result<Shadow, PlantError> {
        let per_action = i16::try_from(self.world.cell.steps_per_action).unwrap_or(i16::MAX);
        if let [one] = told
            && one.counts(per_action)
            && let Some(known) = self.known_shadow(node, told, per_action)
        {
            return Ok(known);
        }
        // What is told later than in this action changes nothing yet.
        let told: Box<[PlaneSignal]> = told.iter().copied().filter(|t| t.counts(per_action)).collect();
        if told.is_empty() {
            return Ok(Shadow::Is(node));
        }
        if node == NodeId::ROOT {
            return Ok(Shadow::BeforeTime);
        }
        if let Some(known) = self.known_shadow(node, &told, per_action) {
            return Ok(known);
        }
        let parent = self.recall.parent(node);
        let earlier: Vec<PlaneSignal> = told.iter().filter(|t| t.first < 0).map(|t| t.before(per_action)).collect();
        let shadow = match self.if_signalled(parent, &earlier)? {
            Shadow::Is(from) if self.astray.contains(&(parent, from)) => self.strayed(),
            Shadow::Is(from) => {
                let mut inputs = self.recall.inputs(node);
                for t in &told {
                    let Some(column) = self.world.binding.sensors[usize::from(t.sensor)].input() else { continue };
                    let active = self.world.cell.sensors[usize::from(t.sensor)].signal.value(true);
                    let step = |s: i16| usize::try_from(s.clamp(0, per_action)).unwrap_or(0);
                    let rows = inputs.chunks_mut(self.world.binding.inputs.len());
                    for row in rows.take(step(t.until)).skip(step(t.first)) {
                        row[column] = active;
                    }
                }
                match self.advance(from, &inputs)? {
                    Advanced::To(node) => Shadow::Is(node),
                    Advanced::Fault(fault) => {
                        self.unfinished.get_or_insert_with(|| fault.message.clone());
                        Shadow::Unfinished
                    }
                }
            }
            none => none,
        };
        if let Shadow::Is(other) = &shadow
            && self.strays(node, *other, usize::MAX)
        {
            self.astray.insert((node, *other));
        }
        self.remember_shadow(node, told, per_action, shadow.clone());
        Ok(shadow)
    }

    /// Whether what follows the FMU does so otherwise in the first steps of the action into `shadow` than in that into `node`: then the
    /// person went elsewhere, or was seen otherwise, than in the run that it stands in for.
    fn strays(&mut self, node: NodeId, shadow: NodeId, steps: usize) -> bool {
        if !self.world.follows() || node == shadow {
            return false;
        }
        let (own, other) = (self.said(node), self.said(shadow));
        own.is_empty() || !own.iter().take(steps).eq(other.iter().take(steps))
    }

    /// How everything that follows the FMU stands after each step of the action into `node`. Known for good once it was asked for while its
    /// outputs were.
    pub(super) fn said(&mut self, node: NodeId) -> Arc<[Arrangement]> {
        if let Some(known) = self.said.get(&node) {
            return Arc::clone(known);
        }
        let frames = self.frames(node);
        let said: Arc<[Arrangement]> = frames.iter().map(|frame| self.world.arrangement(frame.outputs())).collect();
        if !said.is_empty() {
            self.said.insert(node, Arc::clone(&said));
        }
        said
    }

    /// Whether it does so before step `i` of the action: then the person would be elsewhere in that step.
    fn is_astray_before(&mut self, node: NodeId, shadow: NodeId, i: usize) -> bool {
        self.astray.contains(&(node, shadow)) && self.strays(node, shadow, i)
    }

    /// Such a run is not evaluated.
    const fn strayed(&mut self) -> Shadow {
        self.strayed = true;
        Shadow::Unfinished
    }

    fn known_shadow(&self, node: NodeId, told: &[PlaneSignal], per_action: i16) -> Option<Shadow> {
        let [one] = told else { return self.of_several.get(&(node, told.into())).cloned() };
        let of_node = self.shadows.get(node.index())?;
        let (_, known) = of_node.iter().find(|(of, _)| *of == (one.sensor, one.until))?;
        known.get(one.earlier(per_action))?.clone()
    }

    fn remember_shadow(&mut self, node: NodeId, told: Box<[PlaneSignal]>, per_action: i16, shadow: Shadow) {
        let [one] = *told else {
            self.of_several.insert((node, told), shadow);
            return;
        };
        let (earlier, of) = (one.earlier(per_action), (one.sensor, one.until));
        if self.shadows.len() <= node.index() {
            self.shadows.resize_with(node.index() + 1, Vec::new);
        }
        let of_node = &mut self.shadows[node.index()];
        let place = of_node.iter().position(|(known, _)| *known == of).unwrap_or_else(|| {
            of_node.push((of, Vec::new()));
            of_node.len() - 1
        });
        let known = &mut of_node[place].1;
        if known.len() <= earlier {
            known.resize(earlier + 1, None);
        }
        known[earlier] = Some(shadow);
    }

    /// The steps of the action into a state that a window, seen from step `i` of it, is about.
    fn told(&self, window: &Window, i: usize) -> PlaneSignal {
        let narrow = |n: isize| i16::try_from(n).unwrap_or(i16::MAX - 1);
        let number = self.world.first.curtains[window.curtain].sensor;
        let sensor = &self.world.cell.sensors[number];
        let now = (i + 1 + sensor.delay_steps).cast_signed();
        let until = match window.until {
            until if until > 0 && !sensor.latched => narrow(now - until.cast_signed()),
            _ => PlaneSignal::EVER,
        };
        let first = narrow(now - window.from.cast_signed());
        // What takes effect after this step only is not told yet.
        let none = window.from == window.until || usize::try_from(first).is_ok_and(|first| first > i);
        let first = if none { until } else { first };
        PlaneSignal { sensor: u16::try_from(number).unwrap_or(u16::MAX), first, until }
    }

    /// The states in which the FMU would be in `node`'s stead had a plane told of an arm in the last 1, 2, ... samples, or,
    /// where the body was first seen in it `since` samples ago, in the 1, 2, ... samples before that: as many as may ever
    /// matter to a person who is at `place`. They decide, with the state itself, what an arm may meet later. Remembered, so
    /// that nothing before `node` is asked again.
    pub fn shadows(
        &mut self,
        node: NodeId,
        place: &Place,
        curtain: usize,
        since: usize,
    ) -> Result<Vec<Shadow>, PlantError> {
        let last = self.world.cell.steps_per_action - 1;
        let windows = self.world.first.windows_that_will_matter(place, curtain, since);
        let shadow = |window: Window| match self.if_signalled(node, &[self.told(&window, last)])? {
            // The person would go elsewhere from here on.
            Shadow::Is(other) if self.astray.contains(&(node, other)) => Ok(Shadow::Unfinished),
            shadow => Ok(shadow),
        };
        windows.into_iter().map(shadow).collect()
    }

    /// Forgets what belongs to states before those that `keep` names.
    pub fn release(&mut self, depth: usize, keep: &BTreeSet<NodeId>) {
        let mut before = std::mem::take(&mut self.shadows);
        for node in keep.iter().map(|node| node.index()) {
            let Some(of_node) = before.get_mut(node) else { break };
            self.shadows.resize_with(node + 1, Vec::new);
            self.shadows[node] = std::mem::take(of_node);
        }
        self.forget_motions();
        self.recall.release_before(depth);
    }

    /// Forgets what can be worked out again from the FMU's states.
    pub fn forget_motions(&mut self) {
        self.motions.clear();
        self.different.clear();
        self.stops.clear();
        self.reached.clear();
    }

    /// Memory for states, and for what stands in for them had several planes told of an arm.
    pub fn bytes(&self) -> usize {
        /// A pair of windows on the heap, and its share of the map's nodes.
        const OF_SEVERAL: usize =
            size_of::<((NodeId, Box<[PlaneSignal]>), Shadow)>() + 2 * size_of::<PlaneSignal>() + 32;
        let said = size_of::<(NodeId, Arc<[Arrangement]>)>()
            + 32
            + size_of::<Arrangement>() * self.world.cell.steps_per_action;
        self.recall.bytes() + self.of_several.len() * OF_SEVERAL + self.said.len() * said
    }
}

/// The robots as they would be after step `i` of the action into `node`.
pub struct Instead<'a, P: Plant> {
    robots: &'a mut Robots<P>,
    node: NodeId,
    i: usize,
    /// Whether a sensor reports the person then.
    told: bool,
}

impl<'a, P: Plant> Instead<'a, P> {
    /// After this step of the action into this state, with the person reported then or not.
    pub const fn new(robots: &'a mut Robots<P>, node: NodeId, i: usize, told: bool) -> Self {
        Self { robots, node, i, told }
    }

    /// The state of the FMU had planes told of an arm in these windows.
    pub fn node_for(&mut self, windows: &[Window]) -> Result<Shadow, PlantError> {
        let told = |window: &Window| self.robots.told(window, self.i);
        let shadow = match windows {
            [window] => self.robots.if_signalled(self.node, &[told(window)])?,
            _ => {
                let told: Vec<PlaneSignal> = windows.iter().map(told).collect();
                self.robots.if_signalled(self.node, &told)?
            }
        };
        match shadow {
            Shadow::Is(other) if self.robots.is_astray_before(self.node, other, self.i) => Ok(self.robots.strayed()),
            shadow => Ok(shadow),
        }
    }
}

impl<P: Plant> SignalledRuns for Instead<'_, P> {
    type Error = PlantError;

    fn told_of(&mut self, windows: &[Window]) -> Result<IfSignalled<Frames>, PlantError> {
        let node = self.node_for(windows)?;
        Ok(node.map(|node| self.robots.frames(node)))
    }

    fn stopping(&mut self) -> Result<Option<Arc<Stopping>>, PlantError> {
        self.robots.stopping(self.node, self.i, self.told)
    }
}
