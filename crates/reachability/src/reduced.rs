//! Of robots that are nearly alike at many instants those that count: whoever is outlasted by as fast ones that are nearly there is left
//! out, and these stand for them.
//!
//! Where people were given longer to come, and robots are at least as fast, at most as much harm follows from the others: the sets of places
//! grow with the time, and forces with speeds (`hazard::Strike`). What stands for others is larger and faster by as much as they differ, so
//! nothing is lost; where it is too much, somebody who is not hit is thought to be.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::ReachableInstant;
use crate::geometry::Vec3;
use crate::sim::robot::RobotFrame;
use crate::standards::iso_13855::{HAND_SPEED_M_S, WALKING_SPEED_M_S};
use crate::stop::Stop;

/// How nearly alike robots are that stand for each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearly {
    /// No point of a link is farther from where it is in the other, m.
    pub apart_m: f64,
    /// No point is faster by more, m/s.
    pub faster_m_s: f64,
    /// People get farther by no more until then, m.
    pub farther_m: f64,
}

/// What robots may be off by in any case, by the greatest speed of their links up to which it is so, m/s: slowest first.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MayBeOff(pub Vec<(f64, Nearly)>);

impl MayBeOff {
    /// By how much robots may be off that are so fast.
    #[must_use]
    pub(crate) fn of(&self, fastest_m_s: f64) -> Nearly {
        let of = self.0.iter().find(|(up_to_m_s, _)| fastest_m_s <= *up_to_m_s).or(self.0.last());
        of.map_or(Nearly { apart_m: 0.0, faster_m_s: 0.0, farther_m: 0.0 }, |(_, off)| *off)
    }
}

/// So many robots are gone through from one look at the clock to the next.
const LOOK_AFTER: usize = 16;

/// Robots at an instant, and what each link is larger by, m.
pub(super) type Grown = (ReachableInstant, Vec<f64>);

/// One that stands for itself and for others.
struct Stands<'a> {
    of: &'a Grown,
    by_m: Vec<f64>,
    faster_m_s: Vec<f64>,
    within_m: [f64; 2],
    depth_m: f64,
    /// What those that it stands for may be off by.
    off: Nearly,
}

/// Those that count: as they are, and so large and fast that they stand for all. What each may be off by in any case is added. Nothing,
/// where there is no time for it.
pub(super) fn reduced(
    all: &[Grown],
    links: &[bool],
    (nearly, off): (Nearly, &MayBeOff),
    stop: &Stop,
) -> Option<(Vec<ReachableInstant>, Vec<ReachableInstant>)> {
    let mut order: Vec<usize> = (0..all.len()).collect();
    let key = |number: &usize| (&all[*number].0, all[*number].0.frame.fastest);
    // Those first that stand for most: the fastest of those who were there longest.
    order.sort_by(|a, b| {
        let ((a, fast_a), (b, fast_b)) = (key(a), key(b));
        let longest = b.within_m.map(f64::to_bits).cmp(&a.within_m.map(f64::to_bits));
        fast_b.total_cmp(&fast_a).then(longest).then(b.depth_m.total_cmp(&a.depth_m)).then(a.step.cmp(&b.step))
    });
    let mut standing: Vec<Stands<'_>> = Vec::new();
    let mut by_place: BTreeMap<[i64; 3], Vec<usize>> = BTreeMap::new();
    for (count, number) in order.into_iter().enumerate() {
        if count.is_multiple_of(LOOK_AFTER) && stop.is_due() {
            return None;
        }
        let one = &all[number];
        let at = place(&one.0.frame, links, nearly.apart_m);
        let known = around(at).filter_map(|at| by_place.get(&at)).flatten();
        let mut fits = None;
        for candidate in known {
            let stands = &standing[*candidate];
            if outlasts(&stands.of.0, &one.0, nearly)
                && let Some(apart) = apart(&stands.of.0.frame, &one.0.frame, links, nearly)
            {
                fits = Some((*candidate, apart));
                break;
            }
        }
        if let Some((candidate, (apart_m, faster_m_s))) = fits {
            let stands = &mut standing[candidate];
            let grown = apart_m.iter().zip(&one.1).map(|(apart, by_m)| apart + by_m);
            (0..2).for_each(|n| stands.within_m[n] = stands.within_m[n].max(one.0.within_m[n]));
            stands.depth_m = stands.depth_m.max(one.0.depth_m);
            let off = off.of(one.0.frame.fastest_of(links));
            stands.off.apart_m = stands.off.apart_m.max(off.apart_m);
            stands.off.faster_m_s = stands.off.faster_m_s.max(off.faster_m_s);
            stands.off.farther_m = stands.off.farther_m.max(off.farther_m);
            stands.by_m.iter_mut().zip(grown).for_each(|(known, by_m)| *known = known.max(by_m));
            stands.faster_m_s.iter_mut().zip(faster_m_s).for_each(|(known, faster)| *known = known.max(faster));
        } else {
            by_place.entry(at).or_default().push(standing.len());
            let (within_m, depth_m) = (one.0.within_m, one.0.depth_m);
            standing.push(Stands {
                of: one,
                by_m: one.1.clone(),
                faster_m_s: vec![0.0; one.1.len()],
                within_m,
                depth_m,
                off: off.of(one.0.frame.fastest_of(links)),
            });
        }
    }
    let own = standing.iter().map(|stands| stands.of.0.clone()).collect();
    let wide = standing.iter().map(|stands| {
        let by_m: Vec<f64> = stands.by_m.iter().map(|by_m| by_m + stands.off.apart_m).collect();
        let faster: Arc<[f64]> = stands.faster_m_s.iter().map(|faster| faster + stands.off.faster_m_s).collect();
        let frame = Arc::new(stands.of.0.frame.standing_for(&by_m, faster));
        let within_m = stands.within_m.map(|within_m| within_m + stands.off.farther_m);
        let depth_m = stands.depth_m + stands.off.farther_m * HAND_SPEED_M_S / WALKING_SPEED_M_S;
        ReachableInstant { frame, within_m, depth_m, ..stands.of.0.clone() }
    });
    Some((own, wide.collect()))
}

/// Whether people got about as far until then by everything; hands are faster than people walk.
fn outlasts(one: &ReachableInstant, other: &ReachableInstant, nearly: Nearly) -> bool {
    let depth_m = nearly.farther_m * HAND_SPEED_M_S / WALKING_SPEED_M_S;
    (0..2).all(|n| one.within_m[n] + nearly.farther_m >= other.within_m[n]) && one.depth_m + depth_m >= other.depth_m
}

/// How far links are apart, and by how much the other's are faster, if they are nearly alike.
fn apart(one: &RobotFrame, other: &RobotFrame, links: &[bool], nearly: Nearly) -> Option<(Vec<f64>, Vec<f64>)> {
    let (mut apart_m, mut faster_m_s) = (vec![0.0; links.len()], vec![0.0; links.len()]);
    for link in (0..links.len()).filter(|link| links[*link]) {
        apart_m[link] = other.moved_from(one, link);
        faster_m_s[link] = other.faster_than(one, link);
        let near = apart_m[link] <= nearly.apart_m && faster_m_s[link] <= nearly.faster_m_s;
        if !near || !other.strikes_as(one, link) {
            return None;
        }
    }
    Some((apart_m, faster_m_s))
}

/// About where robots are: the middles of their links, taken together.
#[expect(clippy::cast_possible_truncation, reason = "a few metres")]
fn place(frame: &RobotFrame, links: &[bool], apart_m: f64) -> [i64; 3] {
    let counts = frame.links.iter().zip(links).filter(|(_, counts)| **counts);
    let (mut sum, mut count) = (Vec3::ZERO, 0.0);
    for (link, _) in counts {
        (sum, count) = (sum + link.bounding_sphere().0, count + 1.0);
    }
    let middle = sum * (1.0 / f64::max(count, 1.0));
    // The middle of all moves no more than the one that moves most.
    [middle.x, middle.y, middle.z].map(|at| (at / apart_m).floor() as i64)
}

/// A cell and those beside it.
fn around([x, y, z]: [i64; 3]) -> impl Iterator<Item = [i64; 3]> {
    (0..27).map(move |n| [x + n % 3 - 1, y + n / 3 % 3 - 1, z + n / 9 - 1])
}
