//! The FMU's states, and the robots as its outputs tell them; also as they *would* be had a light curtain been broken
//! some time before.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use super::motion::{Comparison, Motion};
use super::robot::RobotFrame;
use super::sensors::DelayLine;
use super::world::{Earlier, Frames, World};
use crate::cell::binding::SensorBinding;
use crate::host::{Advanced, NodeId, Plant, PlantError, Recall};

/// Most FMU states whose robot frames are remembered at a time, some hundred MB; beyond that all are forgotten and worked
/// out again when they are needed.
const FRAMES_KEPT: usize = 6_000;

/// The FMU's states, and the robots as its outputs tell them.
pub(super) struct Robots<P: Plant> {
    world: Arc<World>,
    pub(super) recall: Recall<P>,
    /// Robot frames of each FMU state's last action.
    frames: BTreeMap<NodeId, Frames>,
    /// For states at which actions begin, where they are known: see [`Robots::remember_shadows`].
    shadows: BTreeMap<(NodeId, usize), Vec<Option<NodeId>>>,
    /// States that were reached since they were last taken.
    reached: BTreeSet<NodeId>,
    /// How told speeds are compared with the motion, and what was seen of that in all frames.
    comparison: Comparison,
    motion: Motion,
}

impl<P: Plant> Robots<P> {
    pub(super) fn new(world: Arc<World>, recall: Recall<P>) -> Self {
        let comparison = Comparison::new(&world.cell, &world.binding);
        let (frames, shadows) = (BTreeMap::new(), BTreeMap::new());
        Self { world, recall, frames, shadows, reached: BTreeSet::new(), comparison, motion: Motion::default() }
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
    pub(super) fn frames(&mut self, node: NodeId) -> Frames {
        if let Some(frames) = self.frames.get(&node) {
            return Arc::clone(frames);
        }
        if self.frames.len() >= FRAMES_KEPT {
            self.frames.clear();
        }
        let before = (node != NodeId::ROOT).then(|| &**self.recall.outputs(self.recall.parent(node)));
        let (binding, step_s) = (&self.world.binding, self.world.cell.step_s);
        let unsettled = if self.recall.depth(node) > 1 { 0 } else { self.comparison.unsettled() };
        let rows = binding.first_rows(self.recall.outputs(node), before, step_s, unsettled);
        let frame = |row: &[f64]| RobotFrame::new(&self.world.cell, &self.world.binding, row);
        let frames: Frames = rows.chunks(self.world.binding.columns()).map(frame).collect();
        self.compare_speeds(node, &frames);
        self.frames.insert(node, Arc::clone(&frames));
        frames
    }

    /// Compares the told speeds with the motion over the action into `node`, and looks at how fast the links are.
    fn compare_speeds(&mut self, node: NodeId, frames: &Frames) {
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

    /// What was seen so far of the robots' motion.
    pub(super) const fn motion(&self) -> &Motion {
        &self.motion
    }

    /// The state after the action into `node` had the input of `sensor` been active from step `first` of that action
    /// on, or from so many steps before it; nothing before the start of time, or if the FMU could not do that.
    pub(super) fn had_broken(
        &mut self,
        node: NodeId,
        sensor: usize,
        first: isize,
    ) -> Result<Option<NodeId>, PlantError> {
        let SensorBinding::Input(column) = self.world.binding.sensors[sensor] else { return Ok(None) };
        if node == NodeId::ROOT {
            return Ok(None);
        }
        let per_action = self.world.cell.steps_per_action;
        let back = per_action.cast_signed() - first;
        let known = usize::try_from(back - 1).ok().and_then(|b| self.shadows.get(&(node, sensor))?.get(b));
        if let Some(known) = known {
            return Ok(*known);
        }
        let parent = self.recall.parent(node);
        let from = match usize::try_from(first) {
            Ok(_) => parent,
            Err(_) => match self.had_broken(parent, sensor, first + per_action.cast_signed())? {
                Some(from) => from,
                None => return Ok(None),
            },
        };
        let active = f64::from(u8::from(self.world.cell.sensors[sensor].active));
        let mut inputs = self.recall.inputs(node);
        let skipped = usize::try_from(first).unwrap_or(0);
        for row in inputs.chunks_mut(self.world.binding.inputs.len()).skip(skipped) {
            row[column] = active;
        }
        Ok(match self.advance(from, &inputs)? {
            Advanced::To(node) => Some(node),
            Advanced::Fault(_) => None,
        })
    }

    /// The states in which the FMU would be in `node`'s stead had the light curtain of `sensor` been broken for the last
    /// 1, 2, ... steps, as many as may ever matter. They decide, with the state itself, what a hand that reaches through
    /// the curtain later may meet. Remembered, so that nothing before `node` is asked again.
    pub(super) fn remember_shadows(&mut self, node: NodeId, sensor: usize) -> Result<&[Option<NodeId>], PlantError> {
        if !self.shadows.contains_key(&(node, sensor)) {
            let per_action = self.world.cell.steps_per_action.cast_signed();
            let longest = isize::from(DelayLine::LONGEST) + self.world.cell.sensors[sensor].delay_steps.cast_signed();
            let shadow = |back: isize| self.had_broken(node, sensor, per_action - back);
            let shadows = (1..=longest).map(shadow).collect::<Result<_, _>>()?;
            self.shadows.insert((node, sensor), shadows);
        }
        Ok(&self.shadows[&(node, sensor)])
    }

    /// Forgets what belongs to states before those that `keep` names.
    pub(super) fn release(&mut self, depth: usize, keep: impl Fn(NodeId) -> bool) {
        self.shadows.retain(|(node, _), _| keep(*node));
        self.frames.clear();
        self.reached.clear();
        self.recall.release_before(depth);
    }
}

/// The robots as they would be after step `i` of the action into `node`.
pub(super) struct HadBroken<'a, P: Plant> {
    robots: &'a mut Robots<P>,
    node: NodeId,
    i: usize,
}

impl<'a, P: Plant> HadBroken<'a, P> {
    pub(super) const fn new(robots: &'a mut Robots<P>, node: NodeId, i: usize) -> Self {
        Self { robots, node, i }
    }
}

impl<P: Plant> HadBroken<'_, P> {
    /// The state of the FMU; nothing before the start of time, or if the FMU could not do that.
    pub(super) fn node_for(&mut self, c: usize, samples: usize) -> Result<Option<NodeId>, PlantError> {
        let sensor = self.robots.world.curtains[c].sensor;
        // First step whose inputs change, counted from the start of the action.
        let delay = self.robots.world.cell.sensors[sensor].delay_steps;
        let first = (self.i + 1 + delay).cast_signed() - samples.cast_signed();
        if first > self.i.cast_signed() {
            return Ok(Some(self.node));
        }
        self.robots.had_broken(self.node, sensor, first)
    }
}

impl<P: Plant> Earlier for HadBroken<'_, P> {
    type Error = PlantError;

    fn broken_for(&mut self, c: usize, samples: usize) -> Result<Option<Frames>, PlantError> {
        let node = self.node_for(c, samples)?;
        Ok(node.map(|node| self.robots.frames(node)))
    }
}
