//! What an arm touches of links at many instants, at each of which planes limit how deep it may be.
//!
//! Behind a plane that has just told of somebody an arm gets deeper with every instant. What it cannot touch when it may be as
//! deep as at the last of some instants it cannot touch at any of them. So all are asked for at once, as deep as at the last; only
//! where that touches something which is out of reach at its own instant are they divided.

use super::super::behind::{Kept, Limit};
use super::{HistorySearch, Pair};
use crate::geometry::{Cuboid, Vec3};
use crate::human::PoseBox;
use crate::sim::encounter::ArmOverBox;

/// Links at instants that the same planes limit arms at.
pub(super) struct Alike<'p> {
    planes: Vec<Limit>,
    /// How deep an arm may be behind those that have told, m, the shallowest first.
    pairs: Vec<(f64, &'p Pair)>,
}

/// What is known of an arm and such links.
pub(super) enum ArmVerdict<'p> {
    Nowhere,
    Unknown,
    /// It touches one, with what keeps it from deeper places then.
    Touches(&'p Pair, Vec<Cuboid>),
}

impl HistorySearch<'_> {
    /// Whether an arm of somebody in a box, whose shoulder is no farther from a point than so, may get to a link at an instant in
    /// time.
    pub(super) fn is_in_time(&self, pair: &Pair, at: &PoseBox, shoulder: (Vec3, f64)) -> bool {
        self.kept(pair, at, shoulder) != Some(Kept::Out)
    }

    /// What keeps such an arm from a link at an instant, if anything does.
    fn kept(&self, pair: &Pair, at: &PoseBox, shoulder: (Vec3, f64)) -> Option<Kept> {
        let seen = &self.history.seen[pair.n];
        self.of.kept(self.history, (seen, &seen.frame.links[pair.link]), at, shoulder)
    }

    /// Links at instants by the planes that limit such an arm; without those that it does not get to in time.
    pub(super) fn by_planes<'p>(
        &self,
        pairs: impl Iterator<Item = &'p Pair>,
        at: &PoseBox,
        shoulder: (Vec3, f64),
    ) -> Vec<Alike<'p>> {
        let mut all: Vec<Alike<'p>> = Vec::new();
        for pair in pairs {
            let (depth_m, planes) = match self.kept(pair, at, shoulder) {
                Some(Kept::Out) => continue,
                Some(Kept::Beyond(depth_m, planes)) => (depth_m, planes),
                None => (0.0, Vec::new()),
            };
            match all.iter_mut().find(|alike| alike.planes == planes) {
                Some(alike) => alike.pairs.push((depth_m, pair)),
                None => all.push(Alike { planes, pairs: vec![(depth_m, pair)] }),
            }
        }
        all.iter_mut().for_each(|alike| alike.pairs.sort_by(|a, b| a.0.total_cmp(&b.0)));
        all
    }

    /// What an arm touches of such links, where `ask` tells it of some of them with walls in its way. After `most` questions it is
    /// unknown.
    pub(super) fn meet<'p>(
        &self,
        Alike { planes, pairs }: &Alike<'p>,
        most: usize,
        mut ask: impl FnMut(&[&'p Pair], &[Cuboid]) -> ArmOverBox,
    ) -> ArmVerdict<'p> {
        let walls = |depth_m: f64| -> Vec<Cuboid> {
            let beyond = planes.iter().map(|limit| self.of.beyond(*limit, depth_m));
            self.walls.iter().copied().chain(beyond).collect()
        };
        let mut asked = 0;
        let mut pending = vec![pairs.as_slice()];
        while let Some(some) = pending.pop() {
            let Some((deepest_m, _)) = some.last() else { continue };
            if asked >= most {
                return ArmVerdict::Unknown;
            }
            asked += 1;
            let deepest = walls(*deepest_m);
            let links: Vec<&Pair> = some.iter().map(|(_, pair)| *pair).collect();
            // By the first of the second half; where that is as deep as all before it, by what is deeper.
            let middle = some[some.len() / 2].0;
            let half = match some.partition_point(|(depth_m, _)| *depth_m < middle) {
                0 => some.partition_point(|(depth_m, _)| *depth_m <= middle),
                half => half,
            };
            let met = ask(&links, &deepest);
            if let ArmOverBox::Touches(found) = met {
                let (depth_m, pair) = some[found];
                if depth_m >= *deepest_m {
                    return ArmVerdict::Touches(pair, deepest);
                }
                let own = walls(depth_m);
                asked += 1;
                if matches!(ask(&[pair], &own), ArmOverBox::Touches(_)) {
                    return ArmVerdict::Touches(pair, own);
                }
            }
            match met {
                ArmOverBox::Nowhere => {}
                // As deep as that at all of them.
                ArmOverBox::Unknown if half == some.len() => return ArmVerdict::Unknown,
                // The deeper half first: more is in reach there.
                ArmOverBox::Unknown | ArmOverBox::Touches(_) => pending.extend([&some[..half], &some[half..]]),
            }
        }
        ArmVerdict::Nowhere
    }
}
