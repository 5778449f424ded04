//! The FMU along all histories of readings, a communication step at a time: what the robots do, and for how long the readings
//! before had lasted.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::StateOrigin;
use super::controls::Controls;
use super::instants::{Instant, Instants, RobotGroup};
use super::reading_regions::ReadingRegions;
use crate::cell::{Binding, Workcell};
use crate::host::{Advanced, NodeId, Plant, PlantError, Recall};
use crate::search::tracks::{PossibleStep, Watch};
use crate::sim::sensors::{self, DelayLine, input_row};

/// A state of the FMU, what is on its way to it, and what is worked.
pub type State = (NodeId, Box<[DelayLine]>, Controls);

/// See the top of this file.
pub struct Machine<'a, P: Plant> {
    recall: Recall<P>,
    cell: &'a Workcell,
    binding: &'a Binding,
    zones: &'a ReadingRegions,
    /// A person of whom each of the readings is reported, as far as the FMU is told of people.
    people: Vec<sensors::SensorTarget>,
    /// The last transition: before it and after.
    last: (NodeId, NodeId),
    /// Presses that there may be.
    presses: u32,
    /// Where controls are worked, how it came to states the first time.
    stories: BTreeMap<State, Arc<StateOrigin>>,
    /// Why the FMU first could not finish a step.
    fault: Option<String>,
    /// The robots, and where people may be.
    instants: Instants<'a>,
}

impl<'a, P: Plant> Machine<'a, P> {
    /// Ready to be stepped from where the FMU begins.
    #[must_use]
    pub fn new(
        recall: Recall<P>,
        (cell, binding): (&'a Workcell, &'a Binding),
        (zones, people): (&'a ReadingRegions, Vec<sensors::SensorTarget>),
        (part, presses): (&'a RobotGroup, u32),
    ) -> Self {
        Self {
            recall,
            presses,
            stories: BTreeMap::new(),
            cell,
            binding,
            zones,
            people,
            last: (NodeId::ROOT, NodeId::ROOT),
            fault: None,
            instants: Instants::new((cell, binding), zones, part),
        }
    }

    /// The FMU's states.
    pub const fn recall(&self) -> &Recall<P> {
        &self.recall
    }

    /// The robots, and where people may be.
    pub const fn instants(&self) -> &Instants<'a> {
        &self.instants
    }

    /// Why the FMU first could not finish a step.
    #[must_use]
    pub fn fault(&self) -> Option<&str> {
        self.fault.as_deref()
    }

    /// Forgets what was seen, for another exploration of the same states.
    pub fn begin(&mut self) {
        self.instants.clear();
        self.stories.clear();
    }

    /// A state comes of another, where the story goes on so.
    fn comes_of(&mut self, before: &State, state: &State, goes_on: impl FnOnce(&mut StateOrigin)) {
        if self.presses == 0 || self.stories.contains_key(state) {
            return;
        }
        let mut story = self.stories.get(before).cloned().unwrap_or_default();
        goes_on(Arc::make_mut(&mut story));
        self.stories.insert(state.clone(), story);
    }

    /// Takes in the robots after a step, and during it.
    pub fn look(&mut self, taken: &PossibleStep<'_, State>) {
        let rows = self.rows_up_to(self.instants.compared_rows().min(taken.step + 1).max(2));
        let (columns, step) = (self.recall.outputs(NodeId::ROOT).len(), taken.step);
        self.instants.compare_speeds(&rows, rows.len() / columns.max(1), step);
        let story = self.stories.get(taken.state).cloned().unwrap_or_default();
        let instant = Instant { step, way: taken.way, lasting: taken.lasting, story, came: None };
        let (before, after) = self.last;
        self.instants.look(self.recall.outputs(before), self.recall.outputs(after), &instant);
    }

    /// The last so many rows of outputs up to the present state.
    fn rows_up_to(&self, wanted: usize) -> Vec<f64> {
        let mut nodes = vec![self.last.1, self.last.0];
        while nodes.len() < wanted {
            let Some(first) = nodes.last() else { break };
            nodes.push(self.recall.parent(*first));
        }
        nodes.iter().rev().flat_map(|node| self.recall.outputs(*node).iter().copied()).collect()
    }
}

impl<P: Plant> Watch for Machine<'_, P> {
    type State = State;
    type Error = PlantError;

    fn begins(&self) -> Vec<usize> {
        vec![0]
    }

    fn start(&mut self) -> Result<State, PlantError> {
        let first = &self.zones.readings[self.zones.ways[0].to];
        let sensors = self.cell.sensors.iter().zip(first);
        let settled = |(sensor, raw): (&crate::cell::Sensor, &bool)| {
            DelayLine::steady(*raw, sensor.delay_steps).latching(sensor.latched, *raw).on_its_way()
        };
        Ok((NodeId::ROOT, sensors.map(settled).collect(), Controls::new(self.presses)))
    }

    fn step(&mut self, state: &State, way: usize) -> Result<Option<State>, PlantError> {
        let (node, lines, controls) = state;
        let reading = &self.zones.readings[self.zones.ways[way].to];
        let mut lines = lines.clone();
        let sensors = self.cell.sensors.iter().zip(lines.iter_mut()).zip(reading);
        let told: Vec<bool> = sensors.map(|((sensor, line), raw)| line.push(*raw, sensor.delay_steps)).collect();
        lines.iter_mut().for_each(|line| *line = line.on_its_way());
        let person = &self.people[self.zones.ways[way].to];
        let mut inputs = Vec::new();
        input_row(self.cell, self.binding, &told, person, controls.on(), &mut inputs);
        match self.recall.advance(*node, 1, &inputs)? {
            Advanced::To(next) => {
                self.last = (*node, next);
                let after = (self.recall.same(next), lines, controls.clone().after_a_step());
                let step = self.recall.depth(*node) + 1;
                let changed = (!self.zones.ways[way].unchanged).then_some(step);
                self.comes_of(state, &after, |story| story.changed = story.changed.or(changed));
                Ok(Some(after))
            }
            Advanced::Fault(fault) => {
                self.fault.get_or_insert_with(|| fault.message.clone());
                Ok(None)
            }
        }
    }

    fn next(&self, way: usize) -> &[(usize, usize)] {
        self.zones.next(way)
    }

    fn changes(&self, way: usize) -> bool {
        self.zones.ways[way].pressed.is_none()
    }

    fn at_once(&self, way: usize) -> &[usize] {
        self.zones.at_once(way)
    }

    fn enters(&mut self, state: &State, way: usize, step: usize) -> Option<State> {
        let pressed = self.zones.ways[way].pressed;
        if pressed.is_none() {
            return Some(state.clone());
        }
        let (node, lines, controls) = state;
        let after = (*node, lines.clone(), controls.press(pressed, &self.cell.controls)?);
        self.comes_of(state, &after, |story| story.pressed.push((step, pressed)));
        Some(after)
    }

    fn others(&mut self, state: &State, step: usize) -> Vec<State> {
        let (node, lines, controls) = state;
        let mut all = Vec::new();
        for (pressed, controls) in controls.others(self.cell) {
            let after = (*node, lines.clone(), controls);
            let pressed = (!pressed.is_none()).then_some((step, pressed));
            self.comes_of(state, &after, |story| story.pressed.extend(pressed));
            all.push(after);
        }
        all
    }
}
