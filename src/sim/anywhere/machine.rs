//! The FMU along all histories of readings, a communication step at a time: what the robots do, and for how long the readings
//! before had lasted.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::zones::Zones;
use super::{History, Seen};
use crate::cell::{Binding, Workcell};
use crate::host::{Advanced, NodeId, Plant, PlantError, Recall};
use crate::search::tracks::{Lasting, Taken, Watch};
use crate::sim::robot::RobotFrame;
use crate::sim::sensors::{self, DelayLine, input_row};
use crate::standards::iso_13855::{HAND_SPEED_M_S, WALKING_SPEED_M_S};

/// A state of the FMU, and what is on its way to it.
pub type State = (NodeId, Box<[DelayLine]>);

/// Robots that are looked at together, with the sensors that they heed.
#[derive(Clone, Debug)]
pub struct Part {
    /// Which sensors.
    pub sensors: Vec<bool>,
    /// Which links.
    pub links: Arc<[bool]>,
}

/// See the top of this file.
pub struct Machine<'a, P: Plant> {
    recall: Recall<P>,
    cell: &'a Workcell,
    binding: &'a Binding,
    zones: &'a Zones,
    /// A person of whom each of the readings is reported, as far as the FMU is told of people.
    people: Vec<sensors::Seen>,
    /// Which sensors matter, and which links count.
    part: &'a Part,
    /// The last transition: before it and after.
    last: (NodeId, NodeId),
    /// Why the FMU first could not finish a step.
    fault: Option<String>,
    /// What was seen on each way, by the bits of the outputs.
    seen: Vec<BTreeMap<Box<[u64]>, Seen>>,
    /// Robots at instants, by the bits of the outputs.
    frames: BTreeMap<Box<[u64]>, Arc<RobotFrame>>,
}

/// How far somebody gets until the end of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Far {
    /// From where the reading began, and from where they were not seen, m.
    within_m: [f64; 2],
    /// A hand behind a plane that tells of it since the reading first changed, m.
    depth_m: f64,
}

impl Far {
    /// Of a step that begins when the reading has lasted so long. Its end is a step later; and between the last sample before the
    /// reading first changed and the first after it there is another.
    #[expect(clippy::cast_precision_loss, reason = "some thousand steps")]
    fn after(lasting: Lasting, step_s: f64) -> Self {
        let time_s = |steps: usize| steps as f64 * step_s;
        let (own_s, first_s) = (time_s(lasting.steps + 1), time_s(lasting.since_first + 2));
        Self { within_m: [own_s, first_s].map(|s| WALKING_SPEED_M_S * s), depth_m: HAND_SPEED_M_S * first_s }
    }
}

impl<'a, P: Plant> Machine<'a, P> {
    /// Ready to be stepped from where the FMU begins.
    #[must_use]
    pub fn new(
        recall: Recall<P>,
        (cell, binding): (&'a Workcell, &'a Binding),
        (zones, people): (&'a Zones, Vec<sensors::Seen>),
        part: &'a Part,
    ) -> Self {
        Self {
            recall,
            cell,
            binding,
            zones,
            people,
            part,
            last: (NodeId::ROOT, NodeId::ROOT),
            fault: None,
            seen: vec![BTreeMap::new(); zones.ways.len()],
            frames: BTreeMap::new(),
        }
    }

    /// The FMU's states.
    pub const fn recall(&self) -> &Recall<P> {
        &self.recall
    }

    /// Why the FMU first could not finish a step.
    #[must_use]
    pub fn fault(&self) -> Option<&str> {
        self.fault.as_deref()
    }

    /// Forgets what was seen, for another exploration of the same states.
    pub fn begin(&mut self) {
        self.seen.iter_mut().for_each(BTreeMap::clear);
    }

    /// Takes in the robots after a step.
    pub fn look(&mut self, taken: &Taken<'_, State>) {
        let (before, node) = self.last;
        let before = &**self.recall.outputs(before);
        let rows = self.binding.rows(self.recall.outputs(node), Some(before), self.cell.step_s);
        let bits: Box<[u64]> = rows.iter().map(|value| value.to_bits()).collect();
        let frame = Arc::clone(
            self.frames
                .entry(bits.clone())
                .or_insert_with(|| Arc::new(RobotFrame::new(self.cell, self.binding, &rows))),
        );
        if !frame.may_harm_by(&self.part.links) {
            return;
        }
        let way = &self.zones.ways[taken.way];
        let lasting = taken.lasting.steps;
        let far = Far::after(taken.lasting, self.cell.step_s);
        let seen = Seen {
            step: taken.step,
            lasting,
            frame,
            within_m: if way.from.is_none() { [f64::MAX; 2] } else { far.within_m },
            // Who comes back to a plane may have told it of an arm before.
            depth_m: if way.from.is_some() { far.depth_m } else { f64::INFINITY },
        };
        let known = self.seen[taken.way].entry(bits).or_insert_with(|| seen.clone());
        for (known, seen) in known.within_m.iter_mut().zip(seen.within_m) {
            *known = known.max(seen);
        }
        known.depth_m = known.depth_m.max(seen.depth_m);
        if lasting > known.lasting {
            (known.lasting, known.step) = (lasting, taken.step);
        }
    }

    /// What was seen, one history for each way.
    #[must_use]
    pub fn histories(&self) -> Vec<History> {
        let ways = self.zones.ways.iter().zip(&self.seen);
        ways.map(|(way, seen)| {
            let mut seen: Vec<Seen> = seen.values().cloned().collect();
            seen.sort_by_key(|seen| (seen.step, seen.lasting));
            let matter = self.part.sensors.iter().zip(&self.zones.readings[way.to]);
            History {
                readings: matter.map(|(matters, reading)| matters.then_some(*reading)).collect(),
                links: Arc::clone(&self.part.links),
                fields: [&way.field, self.zones.origin()].map(Arc::clone),
                seen,
            }
        })
        .collect()
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
        let settled =
            |(sensor, raw): (&crate::cell::Sensor, &bool)| DelayLine::settled(*raw, sensor.delay_steps).on_its_way();
        Ok((NodeId::ROOT, sensors.map(settled).collect()))
    }

    fn step(&mut self, (node, lines): &State, way: usize) -> Result<Option<State>, PlantError> {
        let reading = &self.zones.readings[self.zones.ways[way].to];
        let mut lines = lines.clone();
        let sensors = self.cell.sensors.iter().zip(lines.iter_mut()).zip(reading);
        let told: Vec<bool> = sensors.map(|((sensor, line), raw)| line.push(*raw, sensor.delay_steps)).collect();
        lines.iter_mut().for_each(|line| *line = line.on_its_way());
        let person = &self.people[self.zones.ways[way].to];
        let mut inputs = Vec::new();
        input_row(&self.cell.sensors, &self.cell.pose, self.binding, &told, person, &mut inputs);
        match self.recall.advance(*node, 1, &inputs)? {
            Advanced::To(next) => {
                self.last = (*node, next);
                Ok(Some((self.recall.same(next), lines)))
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
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand, with steps of 20 ms. Whoever is reported for the first time at one sample is at its end, a step later, no farther than
    /// 0.032 m from where that may be; and where they were not reported is two steps back. A hand gets 0.08 m in these.
    #[test]
    fn a_step_ends_a_step_after_the_sample_that_it_begins_with() {
        let far = |steps, since_first| Far::after(Lasting { steps, changes: 1, since_first }, 0.02);
        let near = |a: Far, within_m: [f64; 2], depth_m: f64| {
            let differ = [a.within_m[0] - within_m[0], a.within_m[1] - within_m[1], a.depth_m - depth_m];
            assert!(differ.into_iter().all(|by| by.abs() < 1e-12), "{a:?}");
        };
        near(far(0, 0), [0.032, 0.064], 0.08);
        near(far(3, 9), [0.128, 0.352], 0.44);
    }
}
