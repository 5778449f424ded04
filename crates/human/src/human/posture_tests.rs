//! Tests of the cut-back: by hand at walls, at the feed opening of a fence, and against parry in random scenes.

use parry3d_f64::query;
use parry3d_f64::shape::{Capsule as ParryCapsule, Cuboid as ParryCuboid};
use proptest::prelude::*;

use super::*;
use crate::geometry::{Pose, Rotation, rotation_about};
use crate::human::walk::Walker;
use crate::human::{Action, Anthropometry, BodyPart, Place, PlacedBody, Side, Start, Walk, shoulder};

const NORTH: f64 = std::f64::consts::FRAC_PI_2;

fn median_man() -> Body {
    Body::new(&Anthropometry::default()).unwrap()
}

/// An upright box between two corners.
fn block(low: [f64; 3], high: [f64; 3]) -> Cuboid {
    let (low, high) = (Vec3::from(low), Vec3::from(high));
    Cuboid { centre: 0.5 * (low + high), half: 0.5 * (high - low), rotation: Rotation::IDENTITY }
}

fn reached(body: &Body, x: f64, y: f64, heading: f64, posture: Posture, obstacles: &[Cuboid]) -> u8 {
    cut_back(body, Vec3::new(x, y, 0.0), heading, posture, obstacles).sixteenths()
}

#[test]
fn nothing_in_the_way_cuts_nothing() {
    let far = block([2.0, -1.0, 0.0], [3.0, 1.0, 2.0]);
    let table_beneath = block([0.2, -1.0, 0.0], [1.0, 1.0, 0.75]);
    for posture in Posture::USUAL {
        assert_eq!(reached(&median_man(), 0.0, 0.0, 0.0, posture, &[]), 16);
        assert_eq!(reached(&median_man(), 0.0, 0.0, 0.0, posture, &[far, table_beneath]), 16, "{posture:?}");
    }
}

/// Facing a wall at distance d from the hip, by hand: the head (0.72 up the trunk, radius 0.105) comes first, at
/// sin(angle) = (d - 0.105) / 0.72, and a sixteenth is 45/16 = 2.8125 degrees.
#[test]
fn a_wall_ahead_stops_the_head() {
    // d = 0.30: 15.71 degrees are 5.58 sixteenths; 0.40: 24.19 are 8.60; 0.55: 38.17 are 13.57; 0.62 is never reached.
    for (distance, sixteenths) in [(0.30, 5), (0.40, 8), (0.55, 13), (0.62, 16)] {
        let wall = block([distance, -2.0, 0.0], [distance + 0.02, 2.0, 2.0]);
        assert_eq!(reached(&median_man(), 0.0, 0.0, 0.0, Posture::Forward, &[wall]), sixteenths, "{distance} m");
        // Nothing is behind or beside.
        assert_eq!(reached(&median_man(), 0.0, 0.0, 2.0 * NORTH, Posture::Forward, &[wall]), 16);
        assert_eq!(reached(&median_man(), 0.0, 0.0, NORTH, Posture::Left, &[wall]), 16);
    }
}

/// With the back to a fence who kneels or crawls does not push the feet through it: no part is behind it that is not upright.
#[test]
fn nobody_kneels_through_a_fence() {
    let (body, fence) = (median_man(), [block([-0.01, -2.0, 0.0], [0.01, 2.0, 2.0])]);
    let mut kept = 0;
    for posture in Posture::LOW {
        for (number, x) in [-0.7, -0.4, -0.2, -0.16].into_iter().enumerate() {
            for eighth in 0..8_u8 {
                let (at, heading) = (Vec3::new(x, 0.3, 0.0), f64::from(eighth) * 0.5 * NORTH);
                let fraction = cut_back(&body, at, heading, posture, &fence);
                let placed = body.placed(at, heading, posture, fraction);
                for (part, capsule) in placed.parts() {
                    let deepest = capsule.a.x.max(capsule.b.x);
                    assert!(deepest < -0.01, "{posture:?} {number} heading {heading}: {part:?} {deepest} {fraction:?}");
                }
                let all = body.placed(at, heading, posture, BendFraction::FULL);
                kept += usize::from(all.parts().iter().any(|(_, capsule)| capsule.a.x.max(capsule.b.x) > 0.01));
            }
        }
    }
    assert!(kept > 20, "{kept} would get through");
}

/// Leaning sideways towards a wall: 30/16 = 1.875 degrees a sixteenth; at 0.40 m the head stops after 24.19 degrees,
/// which are 12.9. The shoulder would pass it too (0.40 m at 30 degrees), but later.
#[test]
fn a_wall_beside_stops_the_head() {
    let wall = block([0.40, -2.0, 0.0], [0.42, 2.0, 2.0]);
    assert_eq!(reached(&median_man(), 0.0, 0.0, NORTH, Posture::Right, &[wall]), 12);
    assert_eq!(reached(&median_man(), 0.0, 0.0, -NORTH, Posture::Left, &[wall]), 12);
}

/// A thin shelf at breast height stops the chest although head and shoulders would pass over it.
#[test]
fn a_low_barrier_stops_the_chest() {
    // Upper edge at 1.15 m, its face 0.25 m ahead: the lower chest (1.17 m high, radius 0.14) meets it.
    let rail = block([0.25, -2.0, 1.05], [0.27, 2.0, 1.15]);
    let body = median_man();
    let sixteenths = reached(&body, 0.0, 0.0, 0.0, Posture::Forward, &[rail]);
    assert!((1..16).contains(&sixteenths), "{sixteenths}");
    let head = body
        .placed(Vec3::ZERO, 0.0, Posture::Forward, BendFraction::new(sixteenths).unwrap())
        .capsule(BodyPart::Head)
        .a;
    assert!(head.z > 1.15 + 0.105 && head.x > 0.27, "the head is over the rail: {head}");
}

/// Right beside a wall the shoulder is in the wall even upright. That must neither freeze the human nor let it through.
#[test]
fn a_shoulder_in_the_wall_does_not_forbid_bending_along_it() {
    // The wall's face 0.15 m to the right; shoulders reach 0.19, the chest 0.22.
    let wall = block([0.15, -2.0, 0.0], [0.17, 2.0, 2.0]);
    let body = median_man();
    assert_eq!(reached(&body, 0.0, 0.0, NORTH, Posture::Forward, &[wall]), 16);
    assert_eq!(reached(&body, 0.0, 0.0, NORTH, Posture::Left, &[wall]), 16);
    // Towards it, the head (radius 0.105) has 0.045 m: asin(0.045 / 0.72) = 3.58 degrees are 1.9 sixteenths.
    assert_eq!(reached(&body, 0.0, 0.0, NORTH, Posture::Right, &[wall]), 1);
}

/// The fence of the feed-opening cell with the conforming slot (0.12 m high, z 0.80 to 0.92). Wherever the human stands
/// before it and however it bends, no part of the trunk and no shoulder comes to the robot's side. Uncut, it would.
#[test]
fn conforming_slot_keeps_the_trunk_outside() {
    let fence = [
        block([-1.5, -0.01, 0.0], [-0.3, 0.01, 2.0]),
        block([0.3, -0.01, 0.0], [1.5, 0.01, 2.0]),
        block([-0.3, -0.01, 0.0], [0.3, 0.01, 0.80]),
        block([-0.3, -0.01, 0.92], [0.3, 0.01, 2.0]),
    ];
    let body = median_man();
    let farthest = |x: f64, y: f64, heading: f64, posture, fraction| {
        let placed = body.placed(Vec3::new(x, y, 0.0), heading, posture, fraction);
        let trunk = placed.parts().iter().filter(|(part, _)| part.is_trunk());
        let flesh = trunk.map(|(_, capsule)| capsule.a.y.max(capsule.b.y));
        let joints = Side::BOTH
            .into_iter()
            .filter(|side| shoulder::is_available(&placed, *side, &fence))
            .map(|side| placed.shoulder(side).translation.y);
        flesh.chain(joints).fold(f64::NEG_INFINITY, f64::max)
    };
    let mut uncut = f64::NEG_INFINITY;
    for x in [-0.7, -0.3, -0.15, 0.0, 0.15, 0.3, 0.7] {
        for start_y in [-0.75, -0.74, -0.73] {
            for heading_deg in [45.0, 90.0, 135.0] {
                let start = Start::new(x, start_y, heading_deg);
                let walker = Walker {
                    body: &body,
                    start: &start,
                    sub_step_len_m: 0.032,
                    obstacles: &fence,
                    moving: &[],
                    strides: 1,
                };
                let mut place = Place::START;
                for _ in 0..4 {
                    let trace = walker.walk(place, Action::new(Walk::Forward, Posture::Upright), 10);
                    for &place in &trace.places {
                        let (at, heading) = (place.position(&start, 0.032), place.heading_rad(&start));
                        // Beyond the ends of the fence one may lean around it.
                        if at.x.abs() > 0.9 {
                            continue;
                        }
                        for posture in Posture::ALL {
                            let fraction = cut_back(&body, at, heading, posture, &fence);
                            let inside = farthest(at.x, at.y, heading, posture, fraction);
                            assert!(inside < -0.01, "{posture:?} from {at} reaches y = {inside}");
                            uncut = uncut.max(farthest(at.x, at.y, heading, posture, BendFraction::FULL));
                        }
                    }
                    place = trace.end();
                }
            }
        }
    }
    assert!(uncut > 0.2, "without the cut-back the trunk would be at y = {uncut}");
}

/// What must stay free, from the placed body.
fn guarded(placed: &PlacedBody) -> [Capsule; 7] {
    let line = |a, b| Capsule { a, b, radius: 0.0 };
    let hip = placed.world_from_trunk();
    let joints = Side::BOTH.map(|side| placed.shoulder(side).translation);
    let between_joints = 0.5 * (joints[0] + joints[1]);
    [
        *placed.capsule(BodyPart::Head),
        *placed.capsule(BodyPart::Neck),
        *placed.capsule(BodyPart::UpperChest),
        *placed.capsule(BodyPart::LowerChest),
        line(between_joints, joints[0]),
        line(between_joints, joints[1]),
        line(hip.translation, placed.capsule(BodyPart::Head).a),
    ]
}

/// Distance between a capsule and a box by parry's own capsule, which this floor does not use.
fn distance(capsule: &Capsule, obstacle: &Cuboid) -> f64 {
    let solid = ParryCapsule::new(capsule.a, capsule.b, capsule.radius.max(1e-12));
    let world_from_box = Pose::from_parts(obstacle.centre, obstacle.rotation);
    query::distance(&Pose::IDENTITY, &solid, &world_from_box, &ParryCuboid::new(obstacle.half)).unwrap().distance
}

prop_compose! {
    fn any_box()(
        x in -1.0..1.0, y in -1.0..1.0, z in 0.2..2.0,
        hx in 0.005..0.4, hy in 0.005..0.4, hz in 0.005..0.4,
        turn in 0.0..std::f64::consts::TAU, tilt in -0.5..0.5,
    ) -> Cuboid {
        Cuboid {
            centre: Vec3::new(x, y, z),
            half: Vec3::new(hx, hy, hz),
            rotation: rotation_about(Vec3::Z, turn) * rotation_about(Vec3::X, tilt),
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    /// Whoever is free upright is free after the cut-back and all the way there, and one more sixteenth would not be.
    #[test]
    fn cut_back_leaves_the_trunk_free_and_is_no_larger_than_needed(
        boxes in prop::collection::vec(any_box(), 1..6),
        posture in 1..6_usize,
        heading in -4.0..4.0,
    ) {
        let body = median_man();
        let posture = Posture::ALL[posture];
        let nearest = |fraction| {
            let shapes = guarded(&body.placed(Vec3::ZERO, heading, posture, fraction));
            let pairs = shapes.iter().flat_map(|shape| boxes.iter().map(move |obstacle| distance(shape, obstacle)));
            pairs.fold(f64::INFINITY, f64::min)
        };
        prop_assume!(nearest(BendFraction::UPRIGHT) > 0.0);
        let reached = cut_back(&body, Vec3::ZERO, heading, posture, &boxes);
        for sixteenths in 0..=reached.sixteenths() {
            prop_assert!(nearest(BendFraction::new(sixteenths).unwrap()) > 0.0, "{sixteenths} of {reached:?}");
        }
        if let Some(next) = BendFraction::new(reached.sixteenths() + 1) {
            prop_assert!(nearest(next) < 1e-6, "{next:?} would be free by {}", nearest(next));
        }
    }
}

/// Random boxes of places and headings beside random walls: what is cut back in a pose of a box is between what is told of it,
/// and in small boxes that is nearly one value.
#[test]
fn no_pose_of_a_box_is_cut_back_less_or_more_than_told() {
    let mut rng = crate::search::Rng::new(17);
    let mut uniform = |low: f64, high: f64| {
        low + (high - low) * f64::from(u32::try_from(rng.below(1 << 20)).unwrap()) / f64::from(1 << 20)
    };
    let (body, mut cut, mut narrow) = (median_man(), 0, 0);
    for number in 0..600 {
        let walls: Vec<Cuboid> = (0..3)
            .map(|_| Cuboid {
                centre: Vec3::new(uniform(-1.0, 1.0), uniform(-1.0, 1.0), uniform(0.5, 1.6)),
                half: Vec3::new(uniform(0.2, 0.8), uniform(0.005, 0.2), uniform(0.1, 0.8)),
                rotation: rotation_about(Vec3::Z, uniform(0.0, 3.0)),
            })
            .collect();
        let small = number % 2 == 0;
        let at = PoseBox {
            xy_m: [uniform(-0.3, 0.3), uniform(-0.3, 0.3)],
            half_m: if small { 0.002 } else { uniform(0.0, 0.2) },
            heading_rad: uniform(0.0, 6.0),
            half_rad: if small { 0.002 } else { uniform(0.0, 0.6) },
        };
        let posture = Posture::USUAL[1 + number % 5];
        let (least, most) = may_be_cut_back(&body, &at, posture, &walls);
        narrow += usize::from(small && most.sixteenths() - least.sixteenths() <= 1);
        for _ in 0..20 {
            let mut within = |middle: f64, half: f64| middle + uniform(-1.0, 1.0) * half;
            let xy = [within(at.xy_m[0], at.half_m), within(at.xy_m[1], at.half_m)];
            let heading = within(at.heading_rad, at.half_rad);
            let own = cut_back(&body, Vec3::new(xy[0], xy[1], 0.0), heading, posture, &walls);
            assert!(
                (least..=most).contains(&own),
                "{own:?} not in {least:?} to {most:?}: {at:?} {posture:?} {walls:?}"
            );
            cut += usize::from(own != BendFraction::FULL);
        }
    }
    assert!(cut > 1000 && narrow > 200, "{cut} {narrow}");
}
