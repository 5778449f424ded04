//! Can an arm touch the robot, past the obstacles, and how badly? Branch and bound over the box of the four joint
//! angles.
//!
//! Upper arm, elbow, forearm and hand are judged each by itself, with each link: no contact hides another.
//!
//! A box is judged by its middle configuration and by how far any point of the arm can move within the box. It is
//! dropped when no contact in it can score more than what is known, when the arm certainly crosses an obstacle, or when it
//! is outside the joint limits; otherwise its middle is tried, and it is split until the movement is below the tolerance.
//!
//! **Guarantee.** When [`Reach::complete`] is true, no contact above the threshold is missed that stays one when the arm
//! moves by the tolerance: deeper than that, with more than that of clearance to obstacles and joint limits, and on a link
//! whose points within the tolerance are above the threshold too. Others are not looked for: they lie in thin layers around
//! shapes, and layers cost most. Of what a hand holds the tolerance is [`ArmModel::hand_tolerance_m`], for room past obstacles and to
//! joint limits, too; what the bare hand touches is found as without it. The bounds hold because signed distances
//! change by no more than their points move, depths included: so a forearm that sticks 0.2 m through a thin panel is known
//! to cross it for every configuration that differs by less than that. Sharper bounds hold for convex shapes alone; where
//! the nearest point of a mesh can be is told by its triangles.

mod barrier;
pub mod cells;
mod joint_box;
mod movement;
mod obstructed;
mod sweep;

use std::cell::Cell;

use self::barrier::{Barrier, Region};
use self::cells::ArmCells;
use self::joint_box::JointBox;
use self::movement::{Frame, Limb, Movement, NearestMoves, Placed, Plane, Share};
use self::obstructed::{crosses, ends_inside};
use self::sweep::Range;
use super::Side;
use super::arm::{ArmModel, Config, clamped};
use crate::geometry::distance::point_segment;
use crate::geometry::kinematics::Neighbourhood;
use crate::geometry::segment_cuboid::{segment_cuboid, segment_cuboid_apart, segment_hits_cuboid};
use crate::geometry::{Capsule, Cuboid, Hull, Pose, Solid, Vec3};
use crate::stop::Stop;

/// Part of the arm.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ArmSegment {
    /// Shoulder to elbow.
    UpperArm,
    /// The first part of the forearm, [`ELBOW_ZONE_M`] long: body regions count it with the elbow joint.
    Elbow,
    /// The rest of the forearm, up to the wrist.
    Forearm,
    /// Anything within the hand sphere around the wrist.
    Hand,
}

/// Length of forearm next to the elbow joint that counts as elbow, m.
pub(crate) const ELBOW_ZONE_M: f64 = 0.06;

/// How bad a contact is. Higher is worse; zero or less is never reported.
pub trait ContactScore {
    /// No contact of this segment with this link scores more.
    fn upper_bound(&self, segment: ArmSegment, link: usize) -> f64;

    /// No contact of this segment with one of these points of this link scores more.
    fn upper_bound_near(&self, segment: ArmSegment, link: usize, points: &Neighbourhood<'_>) -> f64;

    /// Score of a contact at the link's surface point `on_link` (world).
    fn score(&self, segment: ArmSegment, link: usize, on_link: Vec3) -> f64;
}

/// What is asked.
pub struct ReachQuery<'a, S: ContactScore> {
    /// The arm.
    pub arm: &'a ArmModel,
    /// Which arm.
    pub side: Side,
    /// Shoulder frame: x forward, y left, z up along the trunk.
    pub world_from_shoulder: Pose,
    /// How far shoulder, elbow and wrist may all be from where that frame has them, m: 0 for this one frame. With more, the
    /// answer is complete only where it is about every frame from which they are no farther, so without a contact in any; a
    /// contact that is found is one of this frame.
    pub carried_m: f64,
    /// Where the shoulder hangs from: in every frame that the answer is about the line from there to it is free of these
    /// obstacles, and nothing of it is carried farther. Nothing if that is not known.
    pub hangs_from: Option<(Vec3, &'a [Cuboid])>,
    /// Where joints of an arm may be that touches any of the links, between the obstacles or some of them; it settles most of what is
    /// out of reach behind these sooner. Nothing if that is not known.
    pub known: Option<&'a ArmCells>,
    /// Where the wrist is no farther from than this, m: a point in the world. Nothing if it may be anywhere.
    pub wrist_within: Option<(Vec3, f64)>,
    /// Robot links, world; those of several instants one after the other, to settle them in one search.
    pub links: &'a [Solid],
    /// Obstacles, world.
    pub obstacles: &'a [Cuboid],
    /// Score of contacts.
    pub score: &'a S,
    /// Contacts that score no more than this do not matter.
    pub threshold: f64,
    /// Depth and clearance below which a contact may be missed, m.
    pub tolerance_m: f64,
    /// A contact that scores more than this ends the search: enough is known. Infinite to find the worst.
    pub enough: f64,
    /// Boxes after which the search gives up and says so.
    pub work_limit: u32,
    /// When it has to give up in any case; nothing for never.
    pub stop: Option<&'a Stop>,
}

/// A configuration that touches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArmContact {
    /// Joint angles, rad.
    pub config: Config,
    /// What touches: of all contacts of the configuration the one with the highest score.
    pub segment: ArmSegment,
    /// Index of the link touched.
    pub link: usize,
    /// Point on the link's surface, world.
    pub on_link: Vec3,
    /// Point on the arm (for the hand, the point of the link itself, which the hand reaches), world.
    pub on_arm: Vec3,
    /// Elbow, world.
    pub elbow: Vec3,
    /// Wrist, world.
    pub wrist: Vec3,
    /// Signed distance, m; not positive.
    pub signed_distance: f64,
    /// Score.
    pub score: f64,
}

/// The answer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reach {
    /// The worst contact found, within 5 % of the worst there is.
    pub best: Option<ArmContact>,
    /// Whether the guarantee holds; false when the work limit or a [`Stop`] ended the search, or there are more than 65,535
    /// pieces of links in reach.
    pub complete: bool,
    /// Boxes looked at.
    pub boxes: u32,
}

/// Boxes between two looks at whether the search has to end.
const LOOK: u32 = 64;

/// What is known of joints is asked for where they stay within this of a point, m: more room is hardly ever without any.
const KNOWN_WITHIN_M: f64 = 0.15;

/// A score this much above the best known is not looked for any more.
const SLACK: f64 = 1.05;

/// Length of the upper arm next to the shoulder whose thickness is ignored, beyond its radius: a shoulder may lean
/// against a wall.
const SHOULDER_CLEARANCE_M: f64 = 0.02;

/// A part of a link: the score's bound is tighter for it than for the whole link.
struct Piece {
    link: usize,
    solid: Solid,
    bounds: [f64; 4],
    /// Of a slab of a hull, for each part of the arm a plane that it is behind, the last that was found between the two.
    planes: [Cell<Option<Plane>>; 4],
}

impl Piece {
    fn new<S: ContactScore>(query: &ReachQuery<'_, S>, link: usize, solid: Solid) -> Self {
        let bounds_near =
            |points: &Neighbourhood<'_>| SEGMENTS.map(|segment| query.score.upper_bound_near(segment, link, points));
        let (centre, radius) = solid.bounding_sphere();
        let mut bounds = bounds_near(&Neighbourhood::ball(centre, radius));
        if let Solid::Hull(hull) = &solid
            && hull.is_cut()
            && bounds.iter().any(|bound| *bound > query.threshold)
        {
            // Speed is a convex function of the point: it is greatest at a corner.
            let mut at_corners = [f64::NEG_INFINITY; 4];
            for corner in hull.corners() {
                let at = bounds_near(&Neighbourhood::ball(corner, hull.margin_m()));
                at_corners = std::array::from_fn(|segment| at_corners[segment].max(at[segment]));
            }
            bounds = std::array::from_fn(|segment| bounds[segment].min(at_corners[segment]));
        }
        Self { link, solid, bounds, planes: Default::default() }
    }
}

/// Longest core of a piece, m.
const PIECE_M: f64 = 0.08;

/// Pieces that may still matter in a box: what is settled for a box is settled for all its parts.
#[derive(Clone)]
struct OpenPieces {
    /// For hand and forearm.
    beyond_elbow: Vec<u16>,
    /// For elbow and upper arm; looked at only where the others are settled.
    near_shoulder: Vec<u16>,
    /// What a hand holds was tried where no point of the arm moves by more than the tolerance for that.
    hand_was_tried: bool,
}

/// Drops pieces from the end of the list up to the first that may matter.
fn settle(open: &mut Vec<u16>, may_matter: impl Fn(usize) -> bool) {
    while open.last().is_some_and(|last| !may_matter(usize::from(*last))) {
        open.pop();
    }
}

struct Search<'a, S: ContactScore> {
    query: &'a ReachQuery<'a, S>,
    shoulder: Vec3,
    frame: Frame,
    /// Links in reach that may score above the threshold, with their bounding spheres.
    links: Vec<(usize, Vec3, f64)>,
    /// The same links cut into short pieces, with upper bounds of their scores by segment.
    pieces: Vec<Piece>,
    /// Obstacles in reach, with bounding radius.
    obstacles: Vec<(Cuboid, f64)>,
    /// What the shoulder is not behind.
    barriers: Vec<Barrier>,
    best: Option<ArmContact>,
    /// Whether an arm that is carried may touch where nothing smaller is looked at.
    unsettled: bool,
}

const SEGMENTS: [ArmSegment; 4] = [ArmSegment::UpperArm, ArmSegment::Elbow, ArmSegment::Forearm, ArmSegment::Hand];

/// Whether a line certainly passes through a flat box from one side to the other, or certainly has a point in it, wherever its
/// ends are within `moves_m` of these.
#[must_use]
pub(super) fn certainly_crosses(obstacle: &Cuboid, ends: [Vec3; 2], moves_m: f64) -> bool {
    segment_cuboid(ends[0], ends[1], obstacle).distance < -moves_m
        || crosses(obstacle, ends, 0.0, |_| [Range::NONE.wider(moves_m); 2])
}

/// Searches all configurations of one arm.
#[must_use]
pub fn reach<S: ContactScore>(query: &ReachQuery<'_, S>) -> Reach {
    let mut search = Search::new(query);
    if search.pieces.is_empty() {
        return Reach { best: None, complete: true, boxes: 0 };
    }
    if search.pieces.len() > usize::from(u16::MAX) {
        return Reach { best: None, complete: false, boxes: 0 };
    }
    let (complete, boxes) = search.run();
    Reach { best: search.best, complete, boxes }
}

/// A link as pieces whose union it is.
fn cut(link: &Solid) -> Vec<Solid> {
    let capsule = match link {
        Solid::Hull(hull) if hull.is_cut() => return hull.slabs().map(Solid::Hull).collect(),
        Solid::Hull(_) | Solid::Mesh(_) => return vec![link.clone()],
        Solid::Capsule(capsule) => capsule,
    };
    let length = (capsule.b - capsule.a).length();
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a robot link has a few pieces")]
    let count = (length / PIECE_M).ceil().clamp(1.0, 32.0) as u32;
    let at = |i: u32| capsule.a + (capsule.b - capsule.a) * (f64::from(i) / f64::from(count));
    (0..count).map(|i| Solid::Capsule(Capsule { a: at(i), b: at(i + 1), radius: capsule.radius })).collect()
}

impl<'a, S: ContactScore> Search<'a, S> {
    fn new(query: &'a ReachQuery<'a, S>) -> Self {
        let shoulder = query.world_from_shoulder.translation;
        let far = query.arm.reach() + query.carried_m;
        let in_reach = |link: &Solid| {
            let (centre, radius) = link.bounding_sphere();
            (centre - shoulder).length() - radius <= far && link.point_distance(shoulder).distance <= far
        };
        let matters = |i: usize| SEGMENTS.iter().any(|s| query.score.upper_bound(*s, i) > query.threshold);
        let links: Vec<usize> = (0..query.links.len()).filter(|&i| matters(i) && in_reach(&query.links[i])).collect();
        let pieces: Vec<Piece> = links
            .iter()
            .flat_map(|&link| cut(&query.links[link]).into_iter().map(move |solid| (link, solid)))
            .filter(|(_, solid)| in_reach(solid))
            .map(|(link, solid)| Piece::new(query, link, solid))
            .filter(|piece| piece.bounds.iter().any(|b| *b > query.threshold))
            .collect();
        let obstacles = query
            .obstacles
            .iter()
            .map(|o| (*o, o.half.length()))
            .filter(|(o, radius)| (o.centre - shoulder).length() - radius <= far)
            .collect();
        let barriers = query.hangs_from.map_or_else(Vec::new, |(from, all)| {
            let near = |o: &&Cuboid| (o.centre - from).length() - o.half.length() <= 2.0 * far;
            Barrier::all(&all.iter().filter(near).copied().collect::<Vec<_>>())
        });
        let sphere = |link: usize| {
            let (centre, radius) = query.links[link].bounding_sphere();
            (link, centre, radius)
        };
        let links = links.into_iter().map(sphere).collect();
        let frame = Frame::new(&query.world_from_shoulder, query.side);
        Self { query, shoulder, frame, links, pieces, obstacles, barriers, best: None, unsettled: false }
    }

    fn run(&mut self) -> (bool, u32) {
        let whole = JointBox::whole();
        let all: Vec<u16> = (0..self.pieces.len()).filter_map(|i| u16::try_from(i).ok()).collect();
        let open = OpenPieces { beyond_elbow: all.clone(), near_shoulder: all, hand_was_tried: false };
        let mut stack = vec![(whole, self.place(whole.middle), open)];
        let mut boxes = 0;
        while let Some((next, placed, mut open)) = stack.pop() {
            if self.unsettled
                || boxes == self.query.work_limit
                || (boxes % LOOK == LOOK - 1 && self.query.stop.is_some_and(Stop::is_due))
            {
                return (false, boxes);
            }
            if self.best.is_some_and(|b| b.score > self.query.enough) {
                return (true, boxes);
            }
            boxes += 1;
            let Some(joint) = self.look_at(&next, &placed, &mut open) else { continue };
            let placed = |half: JointBox| half.within_limits().map(|b| (b, self.place(b.middle)));
            match next.halves(joint).map(placed) {
                [Some(mut far), Some(mut near)] => {
                    // The half that is nearer to harm last: it is taken first.
                    if self.distance_to_harm(&far.1, &open) < self.distance_to_harm(&near.1, &open) {
                        std::mem::swap(&mut far, &mut near);
                    }
                    stack.push((far.0, far.1, open.clone()));
                    stack.push((near.0, near.1, open));
                }
                [Some((b, placed)), None] | [None, Some((b, placed))] => stack.push((b, placed, open)),
                [None, None] => {}
            }
        }
        (!self.unsettled, boxes)
    }

    fn place(&self, config: Config) -> Placed {
        let turns = config.map(libm::sincos);
        let [elbow, wrist] = self.query.arm.at(&turns).map(|point| self.shoulder + self.frame.to_world(point));
        Placed { shoulder: self.shoulder, elbow, wrist, turns }
    }

    /// How far a configuration is from a contact that matters, m, by the piece that is looked at next.
    fn distance_to_harm(&self, placed: &Placed, open: &OpenPieces) -> f64 {
        let (cutoff, arm) = (self.cutoff(), self.query.arm);
        let beyond_elbow = !open.beyond_elbow.is_empty();
        let open = if beyond_elbow { &open.beyond_elbow } else { &open.near_shoulder };
        let zone = self.end_of_elbow(placed);
        let distance = |i: &u16| {
            let piece = &self.pieces[usize::from(*i)];
            let [upper, elbow, fore, hand] = piece.bounds;
            // What is soon told is enough to go by.
            let limb = |from: Vec3, to: Vec3, radius: f64| piece.solid.at_least(from, to) - radius;
            let mut nearest = f64::MAX;
            if beyond_elbow && hand > cutoff {
                nearest = piece.solid.at_least(placed.wrist, placed.wrist) - arm.hand_radius_m;
            } else if beyond_elbow && fore > cutoff {
                nearest = limb(zone, placed.wrist, arm.forearm_radius_m);
            }
            if !beyond_elbow && elbow > cutoff {
                nearest = limb(placed.elbow, zone, arm.forearm_radius_m);
            }
            if !beyond_elbow && upper > cutoff {
                nearest = nearest.min(limb(placed.shoulder, placed.elbow, arm.upper_arm_radius_m));
            }
            nearest
        };
        // The piece that is looked at first: it decides.
        open.last().map_or(f64::MAX, distance)
    }

    /// What a contact must score to matter.
    fn cutoff(&self) -> f64 {
        self.best.map_or(self.query.threshold, |b| (b.score * SLACK).max(self.query.threshold))
    }

    /// Judges a box, tries its middle; the joint to split at, or `None` when the box is done.
    fn look_at(&mut self, b: &JointBox, placed: &Placed, open: &mut OpenPieces) -> Option<usize> {
        let arm = self.query.arm;
        let movement = Movement::of(arm, b, placed, self.frame, self.query.carried_m);
        if self.is_known_beyond_elbow(placed, &movement) {
            open.beyond_elbow.clear();
        }
        let hand = !open.hand_was_tried;
        settle(&mut open.beyond_elbow, |i| self.hand_or_forearm_may_matter(hand, &self.pieces[i], placed, &movement));
        let beyond_elbow = !open.beyond_elbow.is_empty();
        if !beyond_elbow {
            settle(&mut open.near_shoulder, |i| self.elbow_or_upper_arm_may_matter(&self.pieces[i], placed, &movement));
            if open.near_shoulder.is_empty() {
                return None;
            }
        }
        if self.is_too_far(placed, movement.wrist) || self.certainly_blocked(placed, &movement) {
            return None;
        }
        let config = clamped(b.middle);
        let candidate = if config == b.middle { *placed } else { self.place(config) };
        self.try_configuration(config, &candidate);
        open.hand_was_tried |= self.holds()
            && self.best.is_none()
            && self.query.carried_m <= 0.0
            && movement.wrist.max(movement.elbow) <= self.hand_tolerance_m();
        // What joints move far less than the arm is carried settles nothing.
        let fine = self.query.tolerance_m.max(0.5 * self.query.carried_m);
        let [elbow, wrist] = [movement.elbow, movement.wrist].map(|by| by - movement.shoulder);
        if !beyond_elbow && elbow > 0.5 * fine {
            // Where only the upper arm counts, the joints that move it settle the matter sooner.
            return Some(usize::from(b.half[1] > b.half[0]));
        }
        // Near a joint's axis the wrist may stay where the elbow moves far.
        let next = (wrist.max(elbow) > fine).then_some(movement.widest_joint);
        self.unsettled |= next.is_none() && self.query.carried_m > 0.0;
        next
    }

    /// Whether forearm and hand are known to touch nothing in the box, from wherever the elbow may be in it.
    fn is_known_beyond_elbow(&self, placed: &Placed, movement: &Movement) -> bool {
        movement.elbow <= KNOWN_WITHIN_M
            && self.query.known.is_some_and(|known| !known.may_touch_from_elbow(placed.elbow, movement.elbow))
    }

    /// Whether the hand holds something.
    fn holds(&self) -> bool {
        self.query.arm.held_m() > 0.0
    }

    /// How deep a contact of what the hand holds may be and still be missed, m.
    fn hand_tolerance_m(&self) -> f64 {
        self.query.arm.hand_tolerance_m(self.query.tolerance_m)
    }

    /// Whether some contact of the hand, or of the forearm, with a piece could score above the cutoff within the box; of what is held
    /// only if that is asked.
    fn hand_or_forearm_may_matter(&self, asked: bool, piece: &Piece, placed: &Placed, movement: &Movement) -> bool {
        let (cutoff, arm) = (self.cutoff(), self.query.arm);
        let [_, _, fore, hand] = piece.bounds;
        if hand > cutoff {
            let bare = arm.hand_radius_m - arm.held_m();
            let held =
                || asked && self.hand_may_matter((arm.hand_radius_m, self.hand_tolerance_m()), piece, placed, movement);
            if self.hand_may_matter((bare, self.query.tolerance_m), piece, placed, movement) || (self.holds() && held())
            {
                return true;
            }
        }
        let ends = [self.elbow_part(), 1.0].map(Share::on_forearm);
        let limb = Limb { ends, radius: arm.forearm_radius_m };
        fore > cutoff && self.limb_may_matter(ArmSegment::Forearm, piece, &limb, placed, movement)
    }

    /// The same of a hand of which nothing is farther from the wrist than this, m, to a tolerance.
    fn hand_may_matter(
        &self,
        (radius_m, tolerance_m): (f64, f64),
        piece: &Piece,
        placed: &Placed,
        movement: &Movement,
    ) -> bool {
        let (cutoff, link) = (self.cutoff(), &piece.solid);
        // Contacts no deeper than the tolerance are not looked for.
        let gap = |distance: f64| distance - radius_m + tolerance_m;
        if gap(link.at_least(placed.wrist, placed.wrist)) <= movement.wrist {
            let wrist = Limb { ends: [Share::on_forearm(1.0); 2], radius: radius_m };
            let plane = &piece.planes[ArmSegment::Hand as usize];
            if wrist.is_beyond(plane, tolerance_m, placed, movement) {
                return false;
            }
            let near = link.point_distance(placed.wrist);
            Plane::remember(plane, link, &near);
            let is_slab = matches!(link, Solid::Hull(hull) if hull.is_cut());
            let bound = || {
                let bound = |points| self.query.score.upper_bound_near(ArmSegment::Hand, piece.link, points);
                // Above the limit only where the link's points are no farther than the tolerance: not looked for.
                let less = |by: f64| (by - tolerance_m).max(0.0);
                if !link.is_convex() {
                    let (centre, radius) = link.nearest_within(placed.wrist, &near, movement.wrist);
                    bound(&Neighbourhood::ball(centre, less(radius)))
                } else if near.distance > movement.wrist {
                    let moves = NearestMoves::new(link, &near, movement);
                    let along = |n| less(moves.along(n));
                    bound(&Neighbourhood {
                        along: Some(&along),
                        ..Neighbourhood::ball(near.on_second, less(moves.at_most()))
                    })
                } else if is_slab && near.distance <= 0.0 {
                    // A wrist inside is its own point; one that has left the slab is no farther from it than it has come out.
                    let around = movement.wrist + (movement.wrist + near.distance).max(0.0);
                    bound(&Neighbourhood::ball(placed.wrist, less(around)))
                } else {
                    // A wrist inside is its own point.
                    let around = 2.0 * movement.wrist + (-near.distance).max(0.0);
                    bound(&Neighbourhood::ball(near.on_second, less(around)))
                }
            };
            let gap = gap(near.distance);
            // A convex link stays behind the plane through its nearest point: only movement against it counts.
            let touches = gap <= movement.wrist && {
                let n = (near.on_first - near.on_second).normalize_or_zero();
                near.distance <= 0.0 || !link.is_convex() || gap <= -movement.wrist(n).low
            };
            if touches && bound() > cutoff {
                // The whole line stays near this one. A wrist that may be inside the link has no line to check.
                let line = near.distance > movement.wrist;
                let to = || link.nearest_within(placed.wrist, &near, movement.wrist);
                if !(line && self.line_certainly_blocked(placed, to(), movement)) {
                    return true;
                }
            }
        }
        false
    }

    /// The same of the upper arm and of what counts as elbow.
    fn elbow_or_upper_arm_may_matter(&self, piece: &Piece, placed: &Placed, movement: &Movement) -> bool {
        let (cutoff, arm) = (self.cutoff(), self.query.arm);
        let [upper, elbow, _, _] = piece.bounds;
        let to_zone = [Share::ELBOW, Share::on_forearm(self.elbow_part())];
        let to_elbow = [Share::SHOULDER, Share::ELBOW];
        let may_matter =
            |segment, ends, radius| self.limb_may_matter(segment, piece, &Limb { ends, radius }, placed, movement);
        (elbow > cutoff && may_matter(ArmSegment::Elbow, to_zone, arm.forearm_radius_m))
            || (upper > cutoff && may_matter(ArmSegment::UpperArm, to_elbow, arm.upper_arm_radius_m))
    }

    /// Whether some contact of a limb with a piece could score above the cutoff within the box.
    fn limb_may_matter(
        &self,
        segment: ArmSegment,
        piece: &Piece,
        limb: &Limb,
        placed: &Placed,
        movement: &Movement,
    ) -> bool {
        let tolerance = self.query.tolerance_m;
        let plane = &piece.planes[segment as usize];
        let Some(near) = limb.may_touch((&piece.solid, plane), tolerance, placed, movement) else { return false };
        let bound = |(centre, radius): (Vec3, f64)| {
            self.query.score.upper_bound_near(segment, piece.link, &Neighbourhood::ball(centre, radius))
        };
        let touched = limb.touched(&piece.solid, &near, tolerance, placed, movement);
        touched.on_core.is_none_or(|ball| bound(ball) > self.cutoff())
            && touched.beside.is_none_or(|ends| ends.into_iter().any(|ball| bound(ball) > self.cutoff()))
    }

    /// The part of the forearm that counts as elbow.
    fn elbow_part(&self) -> f64 {
        (ELBOW_ZONE_M / self.query.arm.forearm_m).min(1.0)
    }

    /// Where that part ends.
    fn end_of_elbow(&self, placed: &Placed) -> Vec3 {
        placed.elbow + (placed.wrist - placed.elbow) * self.elbow_part()
    }

    /// Whether the line from the wrist to the link's nearest point passes through an obstacle in the whole box. That point
    /// is in a ball, given by its centre and radius.
    fn line_certainly_blocked(&self, placed: &Placed, (to, by): (Vec3, f64), movement: &Movement) -> bool {
        self.obstacles_near(placed.wrist, to, 0.0).any(|o| {
            segment_cuboid(placed.wrist, to, o).distance < -movement.wrist.max(by)
                || crosses(o, [placed.wrist, to], 0.0, |n| [movement.wrist(n), Range { low: -by, high: by }])
        })
    }

    /// Whether every configuration of the box has the upper arm or the forearm in an obstacle.
    fn certainly_blocked(&self, placed: &Placed, movement: &Movement) -> bool {
        let arm = self.query.arm;
        let at_most = movement.elbow.max(movement.wrist);
        // Configurations that leave no more room than the tolerance are not looked for.
        let [r_fore, r_upper] = [arm.forearm_radius_m, arm.upper_arm_radius_m].map(|r| r + self.query.tolerance_m);
        if let Some((from, _)) = self.query.hangs_from {
            let chain = [
                Region::ball(from, movement.shoulder),
                Region::ball(placed.shoulder, movement.shoulder),
                Region::ball(placed.elbow, movement.elbow),
                Region::ball(placed.wrist, movement.wrist),
            ];
            if self.barriers.iter().any(|barrier| barrier.is_passed(&chain)) {
                return true;
            }
        }
        let from = self.clear_of_shoulder(placed);
        self.obstacles_near(placed.elbow, placed.wrist, r_fore).any(|o| {
            // The half next to the elbow moves less than the whole.
            let middle = (placed.elbow + placed.wrist) * 0.5;
            let halfway = movement.elbow.max(0.5 * (movement.elbow + movement.wrist));
            segment_cuboid(placed.elbow, placed.wrist, o).distance - r_fore < -at_most
                || segment_cuboid(placed.elbow, middle, o).distance - r_fore < -halfway
                || crosses(o, [placed.elbow, placed.wrist], r_fore, |n| movement.both(n))
                || ends_inside(o, placed.wrist, r_fore, |n| movement.wrist(n))
                || ends_inside(o, placed.elbow, r_fore, |n| movement.elbow(n))
        }) || self.obstacles_near(placed.shoulder, placed.elbow, r_upper).any(|o| {
            segment_cuboid(from, placed.elbow, o).distance - r_upper < -movement.elbow
                || segment_cuboid(placed.shoulder, placed.elbow, o).distance < -movement.elbow
                || crosses(o, [placed.shoulder, placed.elbow], 0.0, |n| [movement.of_shoulder(), movement.elbow(n)])
        })
    }

    /// Whether the wrist is farther than it may be, moved by no more than this.
    fn is_too_far(&self, placed: &Placed, moves_m: f64) -> bool {
        self.query.wrist_within.is_some_and(|(from, far_m)| (placed.wrist - from).length() - moves_m > far_m)
    }

    /// Where along the upper arm its thickness begins to count.
    fn clear_of_shoulder(&self, placed: &Placed) -> Vec3 {
        let skipped = self.query.arm.upper_arm_radius_m + SHOULDER_CLEARANCE_M;
        placed.shoulder + (placed.elbow - placed.shoulder) * (skipped / self.query.arm.upper_arm_m).min(1.0)
    }

    /// Obstacles that may be within `radius` of a segment.
    fn obstacles_near(&self, a: Vec3, b: Vec3, radius: f64) -> impl Iterator<Item = &Cuboid> {
        let (middle, half) = ((a + b) * 0.5, (b - a).length() * 0.5 + radius);
        let near = move |o: &Cuboid, r: f64| {
            (o.centre - middle).length() <= half + r && segment_cuboid_apart(a, b, o) <= radius
        };
        self.obstacles.iter().filter(move |(o, r)| near(o, *r)).map(|(o, _)| o)
    }

    /// Whether upper arm and forearm are clear of obstacles.
    fn free(&self, placed: &Placed) -> bool {
        let arm = self.query.arm;
        let from = self.clear_of_shoulder(placed);
        !self.obstacles_near(placed.shoulder, placed.elbow, arm.upper_arm_radius_m).any(|o| {
            segment_hits_cuboid(placed.shoulder, placed.elbow, o)
                || segment_cuboid(from, placed.elbow, o).distance < arm.upper_arm_radius_m
        }) && !self
            .obstacles_near(placed.elbow, placed.wrist, arm.forearm_radius_m)
            .any(|o| segment_cuboid(placed.elbow, placed.wrist, o).distance < arm.forearm_radius_m)
    }

    /// Takes the configuration as the best if a contact of it scores more, and it is free.
    fn try_configuration(&mut self, config: Config, placed: &Placed) {
        let mut worst: Option<ArmContact> = None;
        self.each_contact(config, placed, |contact| {
            if worst.is_none_or(|w| contact.score > w.score) {
                worst = Some(contact);
            }
        });
        let Some(contact) = worst else { return };
        let is_better = contact.score > self.best.map_or(self.query.threshold, |b| b.score);
        if is_better && !self.is_too_far(placed, 0.0) && self.free(placed) {
            self.best = Some(ArmContact { signed_distance: self.depth(&contact, placed), ..contact });
        }
    }

    /// The axis of a limb that is no hand, and its radius, m.
    fn limb(&self, segment: ArmSegment, placed: &Placed) -> ([Vec3; 2], f64) {
        let (arm, zone) = (self.query.arm, self.end_of_elbow(placed));
        match segment {
            ArmSegment::Elbow => ([placed.elbow, zone], arm.forearm_radius_m),
            ArmSegment::Forearm | ArmSegment::Hand => ([zone, placed.wrist], arm.forearm_radius_m),
            ArmSegment::UpperArm => ([placed.shoulder, placed.elbow], arm.upper_arm_radius_m),
        }
    }

    /// How deep a contact is; with a hull that is cut that is worked out only of what counts.
    fn depth(&self, contact: &ArmContact, placed: &Placed) -> f64 {
        match &self.query.links[contact.link] {
            Solid::Hull(hull) if hull.is_cut() && contact.segment != ArmSegment::Hand => {
                let ([a, b], thickness) = self.limb(contact.segment, placed);
                self.query.links[contact.link].segment_distance(a, b).distance - thickness
            }
            _ => contact.signed_distance,
        }
    }

    /// The contacts of a configuration, of each part of the arm with each link, wherever obstacles are but for the hand's.
    fn each_contact(&self, config: Config, placed: &Placed, mut consider: impl FnMut(ArmContact)) {
        let arm = self.query.arm;
        let mut consider = |signed_distance: f64, segment, link, on_link: Vec3, on_arm: Vec3| {
            if signed_distance <= 0.0 {
                let score = self.query.score.score(segment, link, on_link);
                let (elbow, wrist) = (placed.elbow, placed.wrist);
                consider(ArmContact { config, segment, link, on_link, on_arm, elbow, wrist, signed_distance, score });
            }
        };
        for &(index, centre, radius) in &self.links {
            let link = &self.query.links[index];
            let near = |segment, a: Vec3, b: Vec3, thickness: f64| {
                let is_near = point_segment(centre, a, b).distance - radius <= thickness;
                is_near
                    && (link.is_capsule()
                        || (self.matters_beside(segment, index, [a, b], thickness) && link.at_least(a, b) <= thickness))
            };
            if near(ArmSegment::Hand, placed.wrist, placed.wrist, arm.hand_radius_m) {
                let hand = link.point_distance(placed.wrist);
                if hand.distance <= arm.hand_radius_m {
                    // A wrist inside the link touches it where it is.
                    let at = if hand.distance > 0.0 { hand.on_second } else { placed.wrist };
                    let blocked = hand.distance > 0.0
                        && self.obstacles_near(placed.wrist, at, 0.0).any(|o| segment_hits_cuboid(placed.wrist, at, o));
                    if !blocked {
                        consider(hand.distance - arm.hand_radius_m, ArmSegment::Hand, index, at, at);
                    }
                }
            }
            for segment in [ArmSegment::Elbow, ArmSegment::Forearm, ArmSegment::UpperArm] {
                let (ends, thickness) = self.limb(segment, placed);
                let [a, b] = ends;
                if !near(segment, a, b, thickness) {
                    continue;
                }
                if let Solid::Hull(hull) = link
                    && hull.is_cut()
                {
                    self.each_contact_with_hull((index, hull), (segment, ends, thickness), &mut consider);
                } else {
                    let near = link.segment_distance(a, b);
                    consider(near.distance - thickness, segment, index, near.on_second, near.on_first);
                }
            }
        }
    }

    /// The contacts of a limb with a hull that is cut. What of its axis is inside the hull, it touches: the fastest point of that is one of
    /// the ends.
    fn each_contact_with_hull(
        &self,
        (index, hull): (usize, &Hull),
        (segment, [a, b], thickness): (ArmSegment, [Vec3; 2], f64),
        consider: &mut impl FnMut(f64, ArmSegment, usize, Vec3, Vec3),
    ) {
        let Ok(near) = hull.within(a, b, thickness) else { return };
        if near.distance > 0.0 {
            consider(near.distance - thickness, segment, index, near.on_second, near.on_first);
        } else if self.matters_beside(segment, index, [a, b], 0.0) {
            hull.inside(a, b).into_iter().for_each(|at| consider(near.distance - thickness, segment, index, at, at));
        }
    }

    /// Whether a point of a link that is no farther than `by_m` from the line between `ends` may score more than what is known. Of a hull that
    /// is cut it is asked: speed is a convex function of the point, so it is greatest around one of the ends.
    fn matters_beside(&self, segment: ArmSegment, link: usize, ends: [Vec3; 2], by_m: f64) -> bool {
        let known = self.best.map_or(self.query.threshold, |best| best.score);
        let Solid::Hull(hull) = &self.query.links[link] else { return true };
        !hull.is_cut()
            || ends
                .iter()
                .any(|end| self.query.score.upper_bound_near(segment, link, &Neighbourhood::ball(*end, by_m)) > known)
    }
}

#[cfg(test)]
#[path = "reach_tests.rs"]
mod tests;
