//! The robots at instants that people come to, by the way on which they are there: as they are then, and with what is between two.
//!
//! Of what is between two instants only bounds are known. In the first half of a step links are near where they were at its
//! beginning, in the second near where they are at its end, no farther than they get in half a step: they are looked at there, larger by
//! that (`Swept`). People have the readings of the sample that the step began with in all of it.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::sync::Arc;

use super::reading_regions::{ReadingRegions, ReadingTransition};
use super::reduced::{Grown, MayBeOff, Nearly, reduced};
use super::{History, ReachableInstant, StateOrigin};
use crate::cell::{Binding, Workcell};
use crate::search::behaviours::Number as Behaviour;
use crate::search::tracks::Lasting;
use crate::sim::between::{self, in_part_of_step};
use crate::sim::motion::{Comparison, Motion};
use crate::sim::robot::RobotFrame;
use crate::standards::iso_13855::{HAND_SPEED_M_S, WALKING_SPEED_M_S};
use crate::stop::Stop;

/// Robots that are looked at together, with the sensors that they heed.
#[derive(Clone, Debug)]
pub struct RobotGroup {
    /// Which sensors.
    pub sensors: Vec<bool>,
    /// Which links.
    pub links: Arc<[bool]>,
}

/// A step that ends at an instant.
#[derive(Clone, Debug)]
pub struct Instant {
    /// Number of the step, from 1.
    pub step: usize,
    /// How the reading that it begins with was come to.
    pub way: usize,
    /// For how long that had lasted when it began.
    pub lasting: Lasting,
    /// Where controls are worked, one way in which it came to that.
    pub story: Arc<StateOrigin>,
    /// The behaviour that the step begins with, where there are few in place of many histories.
    pub came: Option<Behaviour>,
}

/// See the top of this file.
pub struct Instants<'a> {
    cell: &'a Workcell,
    binding: &'a Binding,
    zones: &'a ReadingRegions,
    /// Which sensors matter, and which links count.
    part: &'a RobotGroup,
    /// What was seen on each way, by the bits of the outputs.
    seen: Vec<BTreeMap<Bits, ReachableInstant>>,
    /// The same of what is between the instants.
    swept: Vec<BTreeMap<Bits, Swept>>,
    /// The same step by step: the robots at both ends, and whether only the second half counts as they jumped there.
    steps: Vec<BTreeMap<([Number; 2], bool), Step>>,
    /// Robots at instants, by the bits of the outputs.
    frames: BTreeMap<Bits, (Number, Arc<RobotFrame>)>,
    /// What robots may be off by.
    off: MayBeOff,
    /// How told speeds are compared with the motion, and what was seen of that in all steps.
    comparison: Comparison,
    motion: Motion,
}

/// The bits of outputs.
type Bits = Box<[u64]>;

/// Most parts of steps that are looked at.
const MOST_PARTS: usize = 60_000;

/// Which of the robots at instants.
type Number = u32;

/// Who may be there in a step.
struct Step {
    /// In its first half.
    begins: ReachableInstant,
    /// In its second half.
    ends: ReachableInstant,
}

/// The robots within half a step of an instant.
struct Swept {
    seen: ReachableInstant,
    /// No point of a link is farther from where it is then, m.
    by_m: Vec<f64>,
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
    /// So much of a step into it which begins when the reading has lasted so long; between the last sample before the reading first
    /// changed and the first after it there is another step.
    #[expect(clippy::cast_precision_loss, reason = "some thousand steps")]
    fn after(lasting: Lasting, part: f64, step_s: f64) -> Self {
        let time_s = |steps: usize| (steps as f64 + part) * step_s;
        let (own_s, first_s) = (time_s(lasting.steps), time_s(lasting.since_first + 1));
        Self { within_m: [own_s, first_s].map(|s| WALKING_SPEED_M_S * s), depth_m: HAND_SPEED_M_S * first_s }
    }
}

impl<'a> Instants<'a> {
    /// None yet.
    #[must_use]
    pub fn new((cell, binding): (&'a Workcell, &'a Binding), zones: &'a ReadingRegions, part: &'a RobotGroup) -> Self {
        Self {
            cell,
            binding,
            zones,
            part,
            seen: vec![BTreeMap::new(); zones.ways.len()],
            swept: zones.ways.iter().map(|_| BTreeMap::new()).collect(),
            steps: zones.ways.iter().map(|_| BTreeMap::new()).collect(),
            frames: BTreeMap::new(),
            off: MayBeOff::default(),
            comparison: Comparison::new(cell, binding),
            motion: Motion::default(),
        }
    }

    /// The same of robots that may be off by so much.
    #[must_use]
    pub fn that_are_off(self, off: MayBeOff) -> Self {
        Self { off, ..self }
    }

    /// What was seen of the robots' motion and the speeds that are told of it.
    #[must_use]
    pub const fn motion(&self) -> &Motion {
        &self.motion
    }

    /// Forgets who was where, for another exploration of the same states.
    pub(crate) fn clear(&mut self) {
        self.seen.iter_mut().for_each(BTreeMap::clear);
        self.swept.iter_mut().for_each(BTreeMap::clear);
        self.steps.iter_mut().for_each(BTreeMap::clear);
    }

    /// How many rows of outputs, one after the other, tell how told speeds go with the motion.
    #[must_use]
    pub(crate) fn compared_rows(&self) -> usize {
        self.comparison.rows()
    }

    /// Compares the told speeds with the motion over rows up to the one after a step of this number: the step before the last is what
    /// they tell of, as only then it is known how they go on.
    pub(crate) fn compare_speeds(&mut self, rows: &[f64], count: usize, step: usize) {
        self.comparison.look(rows, step + 1 - count, count - 1, &mut self.motion);
    }

    /// Takes in the robots after a step, and during it.
    pub(crate) fn look(&mut self, before: &[f64], after: &[f64], taken: &Instant) {
        let step_s = self.cell.step_s;
        let after = self.binding.rows(after, Some(before), step_s).into_owned();
        // What follows from both ends of a step is that of its beginning, too.
        let before = [before, &after[before.len()..]].concat();
        let ((from, begins), (to, ends)) = (self.frame(&before), self.frame(&after));
        self.motion.look_at_links(std::slice::from_ref(&ends.1), taken.step);
        let may_harm = |frame: &RobotFrame| {
            let off = self.off.of(frame.fastest_of(&self.part.links));
            frame.may_harm_by(&self.part.links, off.faster_m_s)
        };
        if may_harm(&ends.1) {
            let seen = self.seen_at(taken, &ends.1, 1.0);
            take_in(self.seen[taken.way].entry(ends.0.clone()).or_insert_with(|| seen.clone()), &seen);
        } else if !may_harm(&begins.1) {
            return;
        }
        let by_m = begins.1.swept_m(&ends.1, step_s);
        let is_jump = taken.step <= self.binding.settled_steps() && ends.1.jumps_from(&begins.1, step_s);
        let in_step = Step { begins: self.seen_at(taken, &begins.1, 0.5), ends: self.seen_at(taken, &ends.1, 1.0) };
        let halves = [(begins, in_step.begins.clone()), (ends, in_step.ends.clone())];
        let halves = halves.into_iter().skip(usize::from(is_jump));
        for ((bits, frame), seen) in halves.filter(|((_, frame), _)| may_harm(frame)) {
            let by_m = if is_jump { frame.swept_m(&frame, step_s) } else { by_m.clone() };
            let known = self.swept[taken.way].entry(bits);
            let known = known.or_insert_with(|| Swept { seen: seen.clone(), by_m: by_m.clone() });
            take_in(&mut known.seen, &seen);
            known.by_m.iter_mut().zip(by_m).for_each(|(known, by_m)| *known = known.max(by_m));
        }
        match self.steps[taken.way].entry(([from, to], is_jump)) {
            Entry::Vacant(entry) => {
                entry.insert(in_step);
            }
            Entry::Occupied(mut known) => {
                let known = known.get_mut();
                take_in(&mut known.begins, &in_step.begins);
                take_in(&mut known.ends, &in_step.ends);
            }
        }
    }

    /// The robots by these rows.
    #[expect(clippy::cast_possible_truncation, reason = "fewer than the states of an FMU")]
    fn frame(&mut self, rows: &[f64]) -> (Number, (Bits, Arc<RobotFrame>)) {
        let bits: Bits = rows.iter().map(|value| value.to_bits()).collect();
        let number = self.frames.len() as Number;
        let of = || (number, Arc::new(RobotFrame::new(self.cell, self.binding, rows)));
        let (number, frame) = self.frames.entry(bits.clone()).or_insert_with(of);
        (*number, (bits, Arc::clone(frame)))
    }

    /// Who may be there so much of a step into it.
    fn seen_at(&self, taken: &Instant, frame: &Arc<RobotFrame>, part: f64) -> ReachableInstant {
        let way = &self.zones.ways[taken.way];
        let far = Far::after(taken.lasting, part, self.cell.step_s);
        // Nobody has to come from anywhere to be where nothing was seen; who works a control there is no farther from it.
        let within_m = match (way.from, way.unchanged) {
            (None, _) => [f64::MAX; 2],
            (Some(_), true) => [far.within_m[0], f64::MAX],
            (Some(_), false) => far.within_m,
        };
        ReachableInstant {
            step: taken.step,
            lasting: taken.lasting.steps,
            frame: Arc::clone(frame),
            within_m,
            // Who comes back to a plane may have told it of an arm before.
            depth_m: if way.unchanged { f64::INFINITY } else { far.depth_m },
            story: Arc::clone(&taken.story),
            came: taken.came,
        }
    }

    /// What was seen, one history for each way.
    #[must_use]
    pub fn histories(&self) -> Vec<History> {
        let seen = self.seen.iter().map(|seen| seen.values().cloned().collect());
        self.zones.ways.iter().zip(seen).map(|(way, seen)| self.history(way, seen)).collect()
    }

    /// The same of what is between the instants: links as large as what they sweep within half a step.
    #[must_use]
    pub fn histories_between(&self) -> Vec<History> {
        let grown = |swept: &Swept| ReachableInstant {
            frame: Arc::new(swept.seen.frame.grown(&swept.by_m)),
            ..swept.seen.clone()
        };
        let seen = self.swept.iter().map(|swept| swept.values().map(grown).collect());
        self.zones.ways.iter().zip(seen).map(|(way, seen)| self.history(way, seen)).collect()
    }

    /// Histories as they are and with what is between the instants, of those robots only that count: the others are as long and as fast at
    /// most, nearly there. All may be off by so much. Nothing, where there is no time for it.
    #[must_use]
    pub fn reduced(&self, nearly: Nearly, stop: &Stop) -> Option<Vec<(History, History)>> {
        let of_way = |(way, swept): (&ReadingTransition, &BTreeMap<Bits, Swept>)| {
            let all: Vec<Grown> = swept.values().map(|swept| (swept.seen.clone(), swept.by_m.clone())).collect();
            let (own, wide) = reduced(&all, &self.part.links, (nearly, &self.off), stop)?;
            Some((self.history(way, own), self.history(way, wide)))
        };
        self.zones.ways.iter().zip(&self.swept).map(of_way).collect()
    }

    /// One of these with steps in so many parts, an even number, of which only those count in which links may be where `near` says. None
    /// where that are too many, where it is not known how far links get in a step, or where speeds are worked out from the motion: then
    /// no joint seems ever faster than at a steady speed.
    #[must_use]
    pub fn history_in_parts(&self, way: usize, parts: usize, near: &dyn Fn(&RobotFrame) -> bool) -> Option<History> {
        if !self.binding.derived.is_empty() {
            return None;
        }
        let step_s = self.cell.step_s;
        let mut all = Vec::new();
        for ((_, is_jump), Step { begins, ends }) in &self.steps[way] {
            let by_m = if *is_jump {
                ends.frame.swept_m(&ends.frame, step_s)
            } else {
                begins.frame.swept_m(&ends.frame, step_s)
            };
            if !by_m.iter().all(|by_m| by_m.is_finite()) {
                return None;
            }
            let [first, last] = [begins, ends].map(|seen| Arc::new(seen.frame.grown(&by_m)));
            if !near(&first) && !near(&last) {
                continue;
            }
            if *is_jump {
                all.push(ReachableInstant { frame: last, ..ends.clone() });
                continue;
            }
            for number in 0..parts {
                let seen = if 2 * number < parts { begins } else { ends };
                if !seen.frame.may_harm_by(&self.part.links, 0.0) {
                    continue;
                }
                let part = between::StepFraction { number, of: parts, step_s };
                let frame = in_part_of_step(self.cell, self.binding, [&begins.frame, &ends.frame], &part);
                all.push(ReachableInstant { frame: Arc::new(frame), ..seen.clone() });
            }
            if all.len() > MOST_PARTS {
                return None;
            }
        }
        Some(self.history(&self.zones.ways[way], all))
    }

    fn history(&self, way: &ReadingTransition, mut seen: Vec<ReachableInstant>) -> History {
        seen.sort_by_key(|seen| (seen.step, seen.lasting));
        let matter = self.part.sensors.iter().zip(&self.zones.known[way.to]);
        History {
            readings: matter.map(|(matters, reading)| reading.filter(|_| *matters)).collect(),
            links: Arc::clone(&self.part.links),
            fields: [&way.field, self.zones.origin()].map(Arc::clone),
            seen,
        }
    }
}

/// The same robots at an instant that somebody got to in another way.
fn take_in(known: &mut ReachableInstant, seen: &ReachableInstant) {
    for (known, seen) in known.within_m.iter_mut().zip(seen.within_m) {
        *known = known.max(seen);
    }
    known.depth_m = known.depth_m.max(seen.depth_m);
    if seen.lasting > known.lasting {
        (known.lasting, known.step) = (seen.lasting, seen.step);
        known.story.clone_from(&seen.story);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::binding::{BoundUnit, bind};
    use crate::cell::find::open;

    /// Robots at some instant.
    fn frame() -> Arc<RobotFrame> {
        let dir = tempfile::tempdir().unwrap();
        fmi_hazard_examples::by_name("sensor-mat").unwrap().export(dir.path()).unwrap();
        let opened = open(&dir.path().join("sensor-mat/cell.toml"), None).unwrap();
        let units = BoundUnit::all(opened.fmus.iter().map(|(name, fmu)| (name, fmu)));
        let binding = bind(opened.cell.file(), &opened.source, &units, None).unwrap();
        Arc::new(RobotFrame::new(&opened.cell, &binding, &vec![0.0; binding.columns()]))
    }

    /// Whoever came one way may be farther, and whoever came the other way deeper: both are possible then, in whichever order they are
    /// looked at.
    #[test]
    fn of_two_ways_to_an_instant_the_most_of_each_counts() {
        let frame = frame();
        let seen = |(step, lasting), within_m, depth_m| ReachableInstant {
            step,
            lasting,
            frame: Arc::clone(&frame),
            within_m,
            depth_m,
            story: Arc::default(),
            came: None,
        };
        let (longer, deeper) = (seen((9, 3), [0.1, 0.5], 0.2), seen((7, 2), [0.3, 0.4], 0.6));
        for (first, second) in [(&longer, &deeper), (&deeper, &longer)] {
            let mut known = first.clone();
            take_in(&mut known, second);
            assert_eq!((known.within_m, known.depth_m), ([0.3, 0.5], 0.6));
            // The story is that of the way on which the reading had lasted longer.
            assert_eq!((known.step, known.lasting), (9, 3));
        }
    }

    /// By hand, with steps of 20 ms. Whoever is reported for the first time at one sample is at its end, a step later, no farther than
    /// 0.032 m from where that may be; and where they were not reported is two steps back. A hand gets 0.08 m in these.
    #[test]
    fn a_step_ends_a_step_after_the_sample_that_it_begins_with() {
        let after = |steps, since_first, part| Far::after(Lasting { steps, changes: 1, since_first }, part, 0.02);
        let far = |steps, since_first| after(steps, since_first, 1.0);
        let near = |a: Far, within_m: [f64; 2], depth_m: f64| {
            let differ = [a.within_m[0] - within_m[0], a.within_m[1] - within_m[1], a.depth_m - depth_m];
            assert!(differ.into_iter().all(|by| by.abs() < 1e-12), "{a:?}");
        };
        near(far(0, 0), [0.032, 0.064], 0.08);
        near(far(3, 9), [0.128, 0.352], 0.44);
        // Half a step before that.
        near(after(3, 9, 0.5), [0.112, 0.336], 0.42);
    }
}
