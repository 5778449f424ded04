//! Poses of the person and robots, as they are at some instants, of which is known that no arm harms itself: shown for
//! many instants of a pose by one search, before the question comes up at each.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::Coverage;
use super::encounter::AtMany;
use super::robot::RobotFrame;
use super::world::World;
use crate::human::{Place, Posture};

/// Most poses of which this is remembered, some hundred MB; beyond that all is forgotten.
const POSES_KEPT: usize = 500_000;

/// Where the person stands, and the bend that is tried: what arms can reach follows from it.
pub(super) type Pose = (Place, Posture);

/// What is known.
#[derive(Default)]
pub(super) struct Harmless(BTreeMap<Pose, Vec<Arc<RobotFrame>>>);

/// A pose with instants that are to be settled.
pub(super) type Unsettled = (Pose, Vec<Arc<RobotFrame>>);

impl Harmless {
    /// Whether no arm of a person in this pose harms itself.
    pub(super) fn knows(&self, pose: &Pose, frame: &Arc<RobotFrame>) -> bool {
        self.0.get(pose).is_some_and(|known| known.iter().any(|known| Arc::ptr_eq(known, frame)))
    }

    /// Remembers those of the unsettled instants that are harmless.
    pub(super) fn learn(&mut self, (pose, frames): Unsettled, harmless: &[usize]) {
        if harmless.is_empty() {
            return;
        }
        if self.0.len() >= POSES_KEPT {
            self.0.clear();
        }
        self.0.entry(pose).or_default().extend(harmless.iter().filter_map(|&n| frames.get(n)).map(Arc::clone));
    }

    /// What of `asked`, in any order and often the same, is not known; each once, poses in their order.
    pub(super) fn unsettled<'a>(&self, asked: impl Iterator<Item = (Pose, &'a Arc<RobotFrame>)>) -> Vec<Unsettled> {
        // Addresses tell frames apart; what depends on an order goes by numbers, which do not differ from run to run.
        let mut numbers: BTreeMap<*const RobotFrame, usize> = BTreeMap::new();
        let mut frames: Vec<&Arc<RobotFrame>> = Vec::new();
        let mut all: Vec<(Pose, usize)> = Vec::new();
        for (pose, frame) in asked {
            let number = *numbers.entry(Arc::as_ptr(frame)).or_insert(frames.len());
            if number == frames.len() {
                frames.push(frame);
            }
            if all.last() != Some(&(pose, number)) {
                all.push((pose, number));
            }
        }
        all.sort_unstable();
        all.dedup();
        let of = |alike: &[(Pose, usize)]| {
            let pose = alike[0].0;
            let frames = alike.iter().map(|(_, number)| frames[*number]);
            let new: Vec<Arc<RobotFrame>> = frames.filter(|frame| !self.knows(&pose, frame)).map(Arc::clone).collect();
            (!new.is_empty()).then_some((pose, new))
        };
        all.chunk_by(|a, b| a.0 == b.0).filter_map(of).collect()
    }
}

/// Which of the instants of an unsettled pose are harmless for arms.
pub(super) fn settle(world: &World, (pose, frames): &Unsettled, coverage: &mut Coverage) -> Vec<usize> {
    let near: Vec<usize> = (0..frames.len()).filter(|&n| world.near(&pose.0, &frames[n])).collect();
    if near.is_empty() {
        return Vec::new();
    }
    let person = world.posed(&pose.0, pose.1);
    let mut harmless = Vec::new();
    let mut groups: Vec<Vec<usize>> = vec![near];
    while let Some(mut group) = groups.pop() {
        let robots: Vec<&RobotFrame> = group.iter().map(|&n| &*frames[n]).collect();
        match world.arms_at_many(&person, &robots, coverage) {
            AtMany::Harmless => harmless.extend(group),
            // A contact is soon found; that there is none for the others takes one search.
            AtMany::Harm { instant } => {
                group.remove(instant);
                groups.extend((!group.is_empty()).then_some(group));
            }
            AtMany::Unfinished if group.len() > 1 => {
                let second = group.split_off(group.len() / 2);
                groups.extend([second, group]);
            }
            AtMany::Unfinished => {}
        }
    }
    harmless
}
