//! The walking of one action: sub-step after sub-step from place to place, stopped by obstacles.

use super::obstacles::{TOUCHING_M, capsule_hits};
use super::{Action, Body, Place, Posture, Start, Walk};
use crate::geometry::{Cuboid, Vec3};

/// Walks one body in one cell.
#[derive(Clone, Copy, Debug)]
pub struct Walker<'a> {
    /// Who walks.
    pub body: &'a Body,
    /// Where the places are counted from.
    pub start: &'a Start,
    /// Length of a sub-step, m: walking speed times the duration of an action over the number of sub-steps.
    pub sub_step_len_m: f64,
    /// What the human cannot walk through, world frame.
    pub obstacles: &'a [Cuboid],
    /// Those that move by themselves, each with all its boxes: one that has come to stand on the human lets them out, and no deeper in.
    pub moving: &'a [Vec<usize>],
    /// How many sub-steps at once who runs gets ahead.
    pub strides: u8,
}

/// Where one action leads.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WalkTrace {
    /// Place at the start, the turn already made, doors still as they were.
    pub start: Place,
    /// Place at the end of each sub-step.
    pub places: Vec<Place>,
    /// Whether an obstacle has stopped the walk by the end of each sub-step.
    pub blocked: Vec<bool>,
}

impl WalkTrace {
    /// Place at the end of the action.
    #[must_use]
    pub fn end(&self) -> Place {
        self.places.last().copied().unwrap_or(self.start)
    }
}

impl Walker<'_> {
    /// Whether the body is clear of every obstacle at this place in a posture, or merely touches. To be asked of the start,
    /// before anything else: who starts inside an obstacle can never walk.
    #[must_use]
    pub fn is_free(&self, place: Place, posture: Posture) -> bool {
        let capsule = self.body.blocking_capsule(place.position(self.start, self.sub_step_len_m), posture);
        !self.obstacles.iter().any(|obstacle| capsule_hits(&capsule, obstacle))
    }

    /// Whether nothing is in the way from one place to the next.
    fn may_go(&self, from: Place, to: Place, posture: Posture) -> bool {
        let at = |place: Place| place.position(self.start, self.sub_step_len_m);
        let then = self.body.blocking_capsule(at(to), posture);
        let mut hit =
            self.obstacles.iter().enumerate().filter(|(_, obstacle)| capsule_hits(&then, obstacle)).peekable();
        if hit.peek().is_none() {
            return true;
        }
        // Out of what stands on them, of several out of what they are deepest in: so nobody is held by them.
        let on = self.on_the_human(from, posture);
        let deepest_m =
            |place: Place| on.iter().map(|boxes| self.outside_m(at(place), boxes)).fold(f64::INFINITY, f64::min);
        hit.all(|(number, _)| on.iter().any(|boxes| boxes.contains(&number)))
            && deepest_m(to) >= deepest_m(from) - TOUCHING_M
    }

    /// What moves by itself and has come to stand on somebody here.
    fn on_the_human(&self, place: Place, posture: Posture) -> Vec<&[usize]> {
        let capsule = self.body.blocking_capsule(place.position(self.start, self.sub_step_len_m), posture);
        let is_on = |boxes: &&Vec<usize>| boxes.iter().any(|number| capsule_hits(&capsule, &self.obstacles[*number]));
        self.moving.iter().filter(is_on).map(Vec::as_slice).collect()
    }

    /// How far a place is outside of the rectangle around some boxes, seen from above, m; inside less than 0: how far it is to the nearest
    /// side.
    fn outside_m(&self, place: Vec3, boxes: &[usize]) -> f64 {
        let around = boxes.iter().map(|number| {
            let Cuboid { centre, half, rotation } = self.obstacles[*number];
            let reach = [Vec3::X * half.x, Vec3::Y * half.y, Vec3::Z * half.z].map(|edge| (rotation * edge).abs());
            let reach = reach[0] + reach[1] + reach[2];
            (centre - reach, centre + reach)
        });
        let (low, high) = around
            .fold((Vec3::splat(f64::INFINITY), Vec3::splat(f64::NEG_INFINITY)), |(low, high), (from, to)| {
                (low.min(from), high.max(to))
            });
        let beyond = (low - place).max(place - high);
        beyond.x.max(beyond.y)
    }

    /// Walks one action of `sub_steps` sub-steps, as fast in every posture. The human stops at the last free place before an obstacle and
    /// stays there until the action ends; it does not slide along. It may still turn.
    #[must_use]
    pub fn walk(&self, from: Place, action: Action, sub_steps: usize) -> WalkTrace {
        let mut place = from.turned(action.walk().turn_eighths());
        let mut stopped = false;
        let mut trace = WalkTrace { start: place, places: vec![place; sub_steps], blocked: vec![false; sub_steps] };
        for (reached, blocked) in trace.places.iter_mut().zip(&mut trace.blocked) {
            place = self.step(place, action, &mut stopped);
            (*reached, *blocked) = (place, stopped);
        }
        trace
    }

    /// One sub-step of an action, the turn already made: where it leads. Whoever was `stopped` stays.
    #[must_use]
    pub fn step(&self, mut place: Place, action: Action, stopped: &mut bool) -> Place {
        let walk = action.walk();
        let at_once = match walk {
            Walk::Stop => 0,
            Walk::Run => self.strides,
            _ => 1,
        };
        for _ in 0..at_once {
            let next = if walk == Walk::Back { place.stepped_back() } else { place.stepped() };
            if !*stopped && self.may_go(place, next, action.posture()) {
                place = next;
            } else {
                *stopped = true;
            }
        }
        place
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Rotation, rotation_about};
    use crate::human::Anthropometry;
    use crate::standards::iso_13855::WALKING_SPEED_M_S;

    const LEN: f64 = 0.032;
    const SUB_STEPS: usize = 10;

    /// Somebody who walks among boxes, of which these move by themselves.
    fn amid<'a>(body: &'a Body, start: &'a Start, obstacles: &'a [Cuboid], moving: &'a [Vec<usize>]) -> Walker<'a> {
        Walker { body, start, sub_step_len_m: LEN, obstacles, moving, strides: 2 }
    }

    fn walked(start: &Start, obstacles: &[Cuboid], walks: &[Walk]) -> Vec<WalkTrace> {
        let body = Body::new(&Anthropometry::default()).unwrap();
        let walker = Walker { body: &body, start, sub_step_len_m: LEN, obstacles, moving: &[], strides: 2 };
        assert!(walker.is_free(Place::START, Posture::Upright));
        let mut place = Place::START;
        let mut traces = Vec::new();
        for walk in walks {
            let trace = walker.walk(place, Action::new(*walk, Posture::Upright), SUB_STEPS);
            place = trace.end();
            traces.push(trace);
        }
        traces
    }

    /// A panel along x at y = 0, 20 mm thick.
    fn panel(height: f64, rotation: Rotation) -> Cuboid {
        Cuboid { centre: Vec3::new(0.0, 0.0, 0.5 * height), half: Vec3::new(5.0, 0.01, 0.5 * height), rotation }
    }

    /// The step that ISO 13855's walking speed gives in one action of 0.2 s: 0.32 m, as the published cells assume.
    #[test]
    fn one_action_at_walking_speed_is_032_m() {
        assert!((WALKING_SPEED_M_S * 0.02 - LEN).abs() < 1e-15);
        assert!((10.0 * LEN - 0.32).abs() < 1e-15);
    }

    #[test]
    fn free_walks_end_where_they_should() {
        let start = Start::new(1.0, 2.0, 90.0);
        let end = |walks: &[Walk]| walked(&start, &[], walks).last().unwrap().end().position(&start, LEN);
        let diagonal = 0.32 * 0.5_f64.sqrt();
        for (walk, x, y) in [
            (Walk::Stop, 0.0, 0.0),
            (Walk::Forward, 0.0, 0.32),
            (Walk::Left45, -diagonal, diagonal),
            (Walk::Left90, -0.32, 0.0),
            (Walk::Right45, diagonal, diagonal),
            (Walk::Right90, 0.32, 0.0),
        ] {
            let distance = (end(&[walk]) - Vec3::new(1.0 + x, 2.0 + y, 0.0)).length();
            assert!(distance < 1e-12, "{walk:?} ends {distance} m off");
        }
        // Around a square, back to the start.
        let square = walked(&start, &[], &[Walk::Left90; 4]);
        assert_eq!(square[3].end(), Place::START);
        assert!(square.iter().all(|trace| trace.blocked == [false; SUB_STEPS]));
    }

    /// By hand: the panel's face is at y = -0.01, the body 0.14 m thick before it: no farther than y = -0.15. From
    /// -0.50, ten steps of 0.032 m lead to -0.18; the eleventh would end at -0.148.
    #[test]
    fn panel_stops_the_walk_at_the_last_free_sub_step() {
        for height in [0.5, 2.0] {
            let start = Start::new(0.0, -0.50, 90.0);
            let walls = [panel(height, Rotation::IDENTITY)];
            let traces = walked(&start, &walls, &[Walk::Forward, Walk::Forward, Walk::Stop, Walk::Left90]);
            assert_eq!(traces[0].blocked, [false; SUB_STEPS]);
            assert_eq!(traces[1].blocked, [true; SUB_STEPS]);
            for trace in &traces[1..=2] {
                let y = trace.end().position(&start, LEN).y;
                assert!((y + 0.18).abs() < 1e-12, "{y}");
            }
            // Away along the panel the way is free.
            assert_eq!(traces[3].blocked, [false; SUB_STEPS]);
        }
    }

    /// Stopped in mid-action: from -0.26 the steps end at -0.228, -0.196, -0.164; the fourth would end at -0.132.
    #[test]
    fn blocked_means_until_the_action_ends() {
        let start = Start::new(0.0, -0.26, 90.0);
        let trace = &walked(&start, &[panel(2.0, Rotation::IDENTITY)], &[Walk::Forward])[0];
        assert_eq!(trace.blocked.iter().position(|blocked| *blocked), Some(3));
        assert!(trace.blocked[3..].iter().all(|blocked| *blocked));
        assert!((trace.end().position(&start, LEN).y + 0.164).abs() < 1e-12);
        // No sliding: obliquely against the panel, no motion along it either.
        let oblique = &walked(&Start::new(0.0, -0.16, 45.0), &[panel(2.0, Rotation::IDENTITY)], &[Walk::Forward])[0];
        assert_eq!(oblique.end(), Place::START);
    }

    #[test]
    fn what_lies_on_the_floor_or_hangs_overhead_does_not_stop() {
        let start = Start::new(0.0, -0.5, 90.0);
        let sill = panel(0.04, Rotation::IDENTITY);
        let lintel = Cuboid { centre: Vec3::new(0.0, 0.0, 1.87), ..panel(0.2, Rotation::IDENTITY) };
        let ends = walked(&start, &[sill, lintel], &[Walk::Forward; 4]);
        assert!((ends[3].end().position(&start, LEN).y - 0.78).abs() < 1e-12);
        let low_lintel = Cuboid { centre: Vec3::new(0.0, 0.0, 1.80), ..lintel };
        assert!(walked(&start, &[low_lintel], &[Walk::Forward; 4])[3].blocked[9]);
    }

    /// Back is the way one came; who runs gets twice as far, and no farther than up to a wall.
    #[test]
    fn back_and_fast() {
        let start = Start::new(0.0, -1.0, 90.0);
        let y = |trace: &WalkTrace| trace.end().position(&start, LEN).y;
        let traces = walked(
            &start,
            &[panel(2.0, Rotation::IDENTITY)],
            &[Walk::Run, Walk::Back, Walk::Back, Walk::Run, Walk::Run],
        );
        let ends: Vec<f64> = traces.iter().map(y).collect();
        for (end, expected) in ends.iter().zip([-0.36, -0.68, -1.0, -0.36, -0.168]) {
            assert!((end - expected).abs() < 1e-12, "{ends:?}");
        }
        // -0.36 and six sub-steps: three steps of two.
        assert_eq!(traces[4].blocked.iter().position(|blocked| *blocked), Some(3));
        let ahead: Vec<i32> = traces[4].places.windows(2).map(|pair| pair[1].ahead_of(&pair[0])).collect();
        assert_eq!(ahead, [2, 2, 0, 0, 0, 0, 0, 0, 0]);
        assert_eq!(traces[1].places[0].ahead_of(&traces[1].start), -1);
        assert_eq!(traces[1].end(), traces[0].places[4]);
    }

    /// Below a beam at 1 m only who is lower gets through.
    #[test]
    fn who_is_low_gets_below_a_beam() {
        let start = Start::new(0.0, -0.5, 90.0);
        let beam = Cuboid { centre: Vec3::new(0.0, 0.0, 1.2), ..panel(0.4, Rotation::IDENTITY) };
        let body = Body::new(&Anthropometry::default()).unwrap();
        let walker =
            Walker { body: &body, start: &start, sub_step_len_m: LEN, obstacles: &[beam], moving: &[], strides: 1 };
        for posture in Posture::ALL {
            let through = matches!(posture, Posture::Crouching | Posture::Crawling);
            let trace = walker.walk(Place::START, Action::new(Walk::Forward, posture), 30);
            assert_eq!(trace.blocked.contains(&true), !through, "{posture:?}");
        }
    }

    /// A panel turned by 45 degrees about z: the distance from the face decides, not the axes.
    #[test]
    fn turned_panels_block_too() {
        let turned = panel(2.0, rotation_about(Vec3::Z, std::f64::consts::FRAC_PI_4));
        let start = Start::new(0.0, -1.0, 90.0);
        let traces = walked(&start, &[turned], &[Walk::Forward; 4]);
        let end = traces[3].end().position(&start, LEN);
        // Distance from the panel's middle plane is |y| cos 45, at least 0.15.
        let distance = end.y.abs() * 0.5_f64.sqrt();
        assert!((0.15..0.15 + LEN).contains(&distance), "{distance}");
    }

    #[test]
    fn a_start_inside_an_obstacle_is_told() {
        let body = Body::new(&Anthropometry::default()).unwrap();
        for (y, free) in [(0.0, false), (-0.1, false), (-0.149, false), (-0.151, true), (0.2, true)] {
            let walls = [panel(2.0, Rotation::IDENTITY)];
            let start = Start::new(0.3, y, 90.0);
            let walker =
                Walker { body: &body, start: &start, sub_step_len_m: LEN, obstacles: &walls, moving: &[], strides: 1 };
            assert_eq!(walker.is_free(Place::START, Posture::Upright), free, "y = {y}");
        }
    }

    /// A box 0.6 m deep has come to stand on the human, 0.1 m in from its front: they walk out of it and along it, not through it, and not
    /// into it again; one that stands still holds whoever is in it.
    #[test]
    fn a_box_that_has_come_lets_out_and_no_deeper_in() {
        let (body, start) = (Body::new(&Anthropometry::default()).unwrap(), Start::new(0.0, 0.0, 0.0));
        let block =
            Cuboid { centre: Vec3::new(0.2, 0.0, 0.5), half: Vec3::new(0.3, 2.0, 0.5), rotation: Rotation::IDENTITY };
        let (obstacles, place) = ([block], Place::START);
        let moves = [vec![0]];
        let ways = |moving: &[Vec<usize>], turn: i8| {
            let walker = amid(&body, &start, &obstacles, moving);
            let walked = walker.walk(place.turned(turn), Action::new(Walk::Forward, Posture::Upright), 30);
            (walked.end().position(&start, LEN), walked.blocked[0])
        };
        let far = 30.0 * LEN;
        for (turn, expected) in [(4, [-far, 0.0]), (2, [0.0, far]), (6, [0.0, -far]), (0, [0.0, 0.0]), (1, [0.0, 0.0])]
        {
            let (end, blocked) = ways(&moves, turn);
            assert!((end - Vec3::new(expected[0], expected[1], 0.0)).length() < 1e-9, "{turn}: {end}");
            assert_eq!(blocked, expected == [0.0, 0.0], "{turn}");
            assert_eq!(ways(&[], turn), (Vec3::ZERO, true), "{turn}");
        }
        let walker = amid(&body, &start, &obstacles, &moves);
        let out = walker.walk(place.turned(4), Action::new(Walk::Forward, Posture::Upright), 30).end();
        let back = walker.walk(out.turned(4), Action::new(Walk::Forward, Posture::Upright), 60).end();
        assert!(walker.is_free(back, Posture::Upright) && back.position(&start, LEN).x < 0.0);
    }

    /// Two boxes of one thing that adjoin, turned by some degrees: from anywhere in them some of the eight directions lead out, and walking
    /// on along them does.
    #[test]
    fn what_has_come_in_several_boxes_holds_nobody() {
        let body = Body::new(&Anthropometry::default()).unwrap();
        for degrees in [0.0, 10.0, 30.0, 45.0, 80.0] {
            let rotation = rotation_about(Vec3::Z, f64::to_radians(degrees));
            let half = |x: f64| Cuboid {
                centre: rotation * Vec3::new(x, 0.0, 0.5),
                half: Vec3::new(0.25, 1.0, 0.5),
                rotation,
            };
            let (obstacles, moves) = ([half(-0.25), half(0.25)], [vec![0, 1]]);
            for x in [-0.4, -0.05, 0.0, 0.05, 0.3] {
                let start = Start::new(x, 0.2, 5.0);
                let walker = amid(&body, &start, &obstacles, &moves);
                let gets_out = |turn: i8| {
                    let end =
                        walker.walk(Place::START.turned(turn), Action::new(Walk::Forward, Posture::Upright), 60).end();
                    walker.is_free(end, Posture::Upright)
                };
                assert!((0..8).any(gets_out), "{degrees} degrees, x = {x}");
                // Near the middle of it any way is one out.
                assert!(degrees > 0.0 || f64::abs(x) < 0.3 || !(0..8).all(gets_out), "x = {x}: through it, too");
            }
        }
    }
}
