//! Contacts behind a light curtain: was there time to get there, and where is the robot if the curtain was broken that
//! long before? The last steps are run again from a saved state with the curtain's input active. The geometry is in
//! [`curtain`].

use std::sync::Arc;

use super::{Sensed, Simulation, sub_step_m};
use crate::cell::binding::SensorBinding;
use crate::geometry::{Cuboid, Solid, Vec3};
use crate::hazard::Contact;
use crate::hazard::finding::ArmPose;
use crate::host::{Advanced, NodeId, Plant, PlantError};
use crate::human::Side;
use crate::human::walk::WalkTrace;
use crate::sim::Coverage;
use crate::sim::curtain;
use crate::sim::encounter::{ArmSpace, Person};
use crate::sim::robot::RobotFrame;

/// An arm contact in a cell with light curtains.
pub(super) struct Reached {
    pub(super) contact: Contact,
    pub(super) arm: Option<ArmPose>,
    pub(super) phase: Option<i64>,
    /// The curtain that the arm breaks.
    pub(super) broke: Option<usize>,
    /// How long before the contact it did, s.
    pub(super) since_s: Option<f64>,
}

impl<P: Plant> Simulation<P> {
    /// An unsafe arm contact after step `i` of an action: without breaking a curtain, or through one, with the robot as
    /// it is when the curtain was broken as long before as the hand needs (see [`curtain`]).
    pub(super) fn reach_through(
        &mut self,
        person: &Person,
        walked: &WalkTrace,
        i: usize,
        sensed: &Sensed,
        frames: &Arc<[RobotFrame]>,
        coverage: &mut Coverage,
    ) -> Result<Option<Reached>, PlantError> {
        let (curtains, from, step_s) = (self.curtains.clone(), self.start(), self.cell.step_s);
        let walls: Vec<Cuboid> = curtains.iter().map(|(_, plane)| curtain::unbroken(plane)).collect();
        let shoulder = |side: Side| person.body.shoulder(side).translation;
        // Arms that are not through any plane yet, and do not go through one.
        let outside =
            |side: &Side| curtains.iter().all(|(_, plane)| curtain::depth(plane, from, shoulder(*side)) <= 0.0);
        let mut before = person.clone();
        before.arms.retain(outside);
        let around = |link: &Solid| {
            let reach = self.encounter.arm.reach();
            let arms = || before.arms.iter().map(|&side| shoulder(side));
            let passes = |closed: &curtain::Closed| arms().any(|s| !closed.out_of_reach(s, reach, link));
            curtains
                .iter()
                .zip(&self.closed)
                .all(|((_, plane), closed)| curtain::within(plane, from, 0.0, link) || passes(closed))
        };
        let links: Vec<bool> = frames[i].links.iter().map(around).collect();
        let space = ArmSpace { walls: &walls, links: Some(&links) };
        if let Some((contact, arm)) = self.encounter.unsafe_arm_contact(&before, &frames[i], &space, coverage) {
            let phase = frames[i].phase(contact.link);
            return Ok(Some(Reached { contact, arm, phase, broke: None, since_s: None }));
        }
        for (c, (sensor, plane)) in curtains.iter().enumerate() {
            if self.is_inside(plane, walked, i, sensed.broken[i][c]) {
                let hit = self.encounter.unsafe_arm_contact(person, &frames[i], &ArmSpace::OPEN, coverage);
                return Ok(hit.map(|(contact, arm)| {
                    let phase = frames[i].phase(contact.link);
                    Reached { contact, arm, phase, broke: None, since_s: None }
                }));
            }
            let depths = person.arms.iter().map(|&side| curtain::depth(plane, from, shoulder(side)));
            let deepest = depths.fold(f64::MIN, f64::max) + self.encounter.arm.reach();
            if deepest <= 0.0 {
                continue;
            }
            let mut steps = 0;
            let mut now = self.broken_for(steps, i, *sensor, sensed, frames)?;
            while let Some(frame) = now {
                // Of instants at which the robot is the same, the last leaves the hand the most time.
                let depth = curtain::depth_m(steps + 1, step_s);
                let later =
                    if depth < deepest { self.broken_for(steps + 1, i, *sensor, sensed, frames)? } else { None };
                if later.as_ref().is_none_or(|later| !later.same_outputs(&frame)) {
                    let mut walls = walls.clone();
                    walls[c] = curtain::beyond(plane, from, depth);
                    // A contact deeper than the tolerance that leaves as much room to what is out of reach in time: the
                    // guarantee of the arm search asks for no more, and thin layers of space cost it most.
                    let far = depth - 2.0 * self.encounter.reach_tolerance_m;
                    let links: Vec<bool> = frame.links.iter().map(|l| curtain::within(plane, from, far, l)).collect();
                    let space = ArmSpace { walls: &walls, links: Some(&links) };
                    if let Some((contact, arm)) = self.encounter.unsafe_arm_contact(person, &frame, &space, coverage) {
                        let phase = frame.phase(contact.link);
                        #[expect(clippy::cast_precision_loss, reason = "a few dozen")]
                        let since_s = Some((steps + 1) as f64 * step_s);
                        return Ok(Some(Reached { contact, arm, phase, broke: Some(*sensor), since_s }));
                    }
                }
                steps += 1;
                now = later;
            }
        }
        Ok(None)
    }

    /// The robot after step `i` of the action if a curtain has been seen broken in the last `samples` samples; `None`
    /// before the start of time, or if the FMU could not do that.
    fn broken_for(
        &mut self,
        samples: usize,
        i: usize,
        sensor: usize,
        sensed: &Sensed,
        frames: &Arc<[RobotFrame]>,
    ) -> Result<Option<RobotFrame>, PlantError> {
        let per_action = self.cell.steps_per_action;
        // First step whose inputs change, counted from the start of the present action.
        let delay = self.cell.sensors[sensor].delay_steps;
        let Some(back) = samples.checked_sub(i + 1 + delay) else {
            // Within the present action, or not yet.
            let first = i + 1 + delay - samples;
            if first > i {
                return Ok(Some(frames[i].clone()));
            }
            return self.rerun(self.state.node, &[], first, sensor, sensed, i);
        };
        // The actions to run again, oldest first.
        let again = back.div_ceil(per_action);
        let mut nodes = Vec::with_capacity(again);
        let mut node = self.state.node;
        for _ in 0..again {
            if node == NodeId::ROOT {
                return Ok(None);
            }
            nodes.push(node);
            node = self.recall.parent(node);
        }
        nodes.reverse();
        self.rerun(node, &nodes, again * per_action - back, sensor, sensed, i)
    }

    /// Runs the transitions into `nodes` and the present action again from `from`, with the input of `sensor` active
    /// from step `first` on.
    fn rerun(
        &mut self,
        from: NodeId,
        nodes: &[NodeId],
        first: usize,
        sensor: usize,
        sensed: &Sensed,
        i: usize,
    ) -> Result<Option<RobotFrame>, PlantError> {
        let SensorBinding::Input(column) = self.binding.sensors[sensor] else { return Ok(None) };
        let active = f64::from(u8::from(self.cell.sensors[sensor].active));
        let (width, per_action) = (self.binding.inputs.len(), self.cell.steps_per_action);
        let mut at = from;
        for place in 0..=nodes.len() {
            let original = nodes.get(place).map_or(&sensed.inputs[..], |&node| self.recall.inputs(node));
            let mut inputs = original.to_vec();
            for (row, values) in inputs.chunks_mut(width).enumerate() {
                if place * per_action + row >= first {
                    values[column] = active;
                }
            }
            match self.recall.advance(at, per_action, &inputs)? {
                Advanced::To(node) => at = node,
                Advanced::Fault(_) => return Ok(None),
            }
        }
        Ok(Some(self.frames(at)[i].clone()))
    }

    /// Whether a bend could have come as far as `point` behind each light curtain since it broke its plane.
    pub(super) fn in_time(&self, point: Vec3, walked: &WalkTrace, i: usize, broken: &[Vec<usize>]) -> bool {
        let from = self.start();
        self.curtains.iter().enumerate().all(|(c, (_, plane))| {
            let steps = broken.get(i).map_or(0, |b| b[c]);
            self.is_inside(plane, walked, i, steps)
                || curtain::depth(plane, from, point) <= curtain::depth_m(steps + 1, self.cell.step_s)
        })
    }

    /// Whether the person has walked through a curtain's plane so long ago that this is no longer remembered.
    fn is_inside(&self, plane: &Cuboid, walked: &WalkTrace, i: usize, steps: usize) -> bool {
        let stands = walked.places[i].position(&self.cell.start, sub_step_m(&self.cell));
        steps == 0 && curtain::depth(plane, self.start(), stands) > 0.0
    }

    /// The person's start, floor plan, m: the side from which light curtains are passed.
    fn start(&self) -> Vec3 {
        self.root.place.position(&self.cell.start, sub_step_m(&self.cell))
    }
}
