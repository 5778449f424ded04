//! What sensors may report of a person who stands somewhere in a box of places and headings.

use crate::cell::{DetectionZone, Sensor};
use crate::geometry::Cuboid;
use crate::geometry::polygon::{contains, distance_to_edge};
use crate::geometry::segment_cuboid::segment_cuboid;
use crate::human::{Body, BodyPart, PlacedBody, PoseBox};

/// What a sensor may report: that it is clear, and that it sees the person. Never neither.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct May {
    pub clear: bool,
    pub see: bool,
}

impl May {
    /// Whether it may report this.
    pub(crate) const fn be(self, reading: bool) -> bool {
        if reading { self.see } else { self.clear }
    }
}

/// Whether `sensor` may be clear of a person who is in the box and bends in any way.
pub(super) fn may_stay_clear(sensor: &Sensor, of: &Body, body: &PlacedBody, at: &PoseBox) -> bool {
    match &sensor.zone {
        DetectionZone::Plane(plane) => plane_may(plane, body, at, |part| !part.is_trunk()).clear,
        DetectionZone::Floor(_) | DetectionZone::Post { .. } | DetectionZone::InFmu => {
            may_report(sensor, of, body, at).clear
        }
    }
}

/// What may be reported of those parts of a body that is in the box.
fn plane_may(plane: &Cuboid, body: &PlacedBody, at: &PoseBox, counts: impl Fn(BodyPart) -> bool) -> May {
    let mut may = May { clear: true, see: false };
    for (_, c) in body.parts().iter().filter(|(part, _)| counts(*part)) {
        let gap = segment_cuboid(c.a, c.b, plane).distance - c.radius;
        let moves = at.moves_m(lever(at, c.a.x, c.a.y).max(lever(at, c.b.x, c.b.y)));
        may.see |= gap < moves;
        may.clear &= gap >= -moves;
    }
    May { see: may.see || !may.clear, ..may }
}

/// What `sensor` may report of a person who stands in the box, whose body is `body` in the middle of it. One inside the FMU
/// may report anything.
pub(super) fn may_report(sensor: &Sensor, of: &Body, body: &PlacedBody, at: &PoseBox) -> May {
    let feet = || of.feet(at.position(), at.heading_rad).map(|foot| (foot, at.moves_m(lever(at, foot.x, foot.y))));
    // Whether a foot may be in a polygon, and whether it may be outside.
    let stands = |polygon: &[[f64; 2]]| {
        feet().map(|(foot, moves)| {
            let xy = [foot.x, foot.y];
            let (inside, near) = (contains(polygon, xy), distance_to_edge(polygon, xy) <= moves);
            [inside || near, !inside || near]
        })
    };
    match &sensor.zone {
        DetectionZone::Floor(polygon) => {
            let [left, right] = stands(polygon);
            May { see: left[0] || right[0], clear: left[1] && right[1] }
        }
        DetectionZone::Post { post, .. } => {
            let [left, right] = stands(post);
            May { clear: left[0] && right[0], see: left[1] || right[1] }
        }
        DetectionZone::Plane(plane) => plane_may(plane, body, at, |_| true),
        DetectionZone::InFmu => May { clear: true, see: true },
    }
}

/// How far a point is from the upright axis between the feet in the middle of a box, m.
pub(super) fn lever(at: &PoseBox, x: f64, y: f64) -> f64 {
    libm::hypot(x - at.xy_m[0], y - at.xy_m[1])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::sensor::{Signal, mat};
    use crate::geometry::{Vec3, rotation_about};
    use crate::human::{Anthropometry, BendFraction, Posture};
    use crate::search::Rng;
    use crate::sim::sensors::{SensorTarget, sees};

    /// Random poses of random boxes: what a sensor reports is among what it may; and of small boxes only one is, mostly.
    #[test]
    fn what_a_sensor_reports_in_a_box_is_among_what_it_may() {
        let mut rng = Rng::new(29);
        let mut uniform = |low: f64, high: f64| {
            low + (high - low) * f64::from(u32::try_from(rng.below(1 << 20)).unwrap()) / f64::from(1 << 20)
        };
        let body = Body::new(&Anthropometry::default()).unwrap();
        let polygon = vec![[-0.5, -0.4], [0.6, -0.5], [0.3, 0.5], [-0.4, 0.4]];
        let plane = Cuboid {
            centre: Vec3::new(0.1, 0.0, 1.0),
            half: Vec3::new(0.6, 0.0, 0.9),
            rotation: rotation_about(Vec3::Z, 0.4),
        };
        let zones = [
            DetectionZone::Floor(polygon.clone()),
            DetectionZone::Plane(plane),
            DetectionZone::Post { post: polygon, plane },
        ];
        let (mut seen_by, mut certain, mut small_boxes, mut bent_away) = ([[0; 2]; 3], 0, 0, 0);
        for number in 0..6000 {
            let small = number % 3 == 0;
            let at = PoseBox {
                xy_m: [uniform(-1.0, 1.0), uniform(-1.0, 1.0)],
                half_m: if small { 0.005 } else { uniform(0.0, 0.4) },
                heading_rad: uniform(0.0, 6.0),
                half_rad: if small { 0.01 } else { uniform(0.0, 3.1) },
            };
            let posture = Posture::USUAL[number % 6];
            // Two of five are floors, and two planes.
            let zone = number / 6 % 5 % 3;
            let sensor = Sensor {
                name: String::new(),
                // Any: by its zone alone it reports.
                kind: mat::KIND,
                zone: zones[zone].clone(),
                signal: Signal::Boolean { active: true },
                delay_steps: 0,
                latched: false,
            };
            let placed = |at: &PoseBox| body.placed(at.position(), at.heading_rad, posture, BendFraction::FULL);
            let may = may_report(&sensor, &body, &placed(&at), &at);
            assert!(may.clear || may.see);
            small_boxes += usize::from(small);
            certain += usize::from(small && may.clear != may.see);
            for _ in 0..10 {
                let mut within = |middle: f64, half: f64| middle + uniform(-1.0, 1.0) * half;
                let xy_m = [within(at.xy_m[0], at.half_m), within(at.xy_m[1], at.half_m)];
                let there = PoseBox::point(xy_m, within(at.heading_rad, at.half_rad));
                let seen = SensorTarget {
                    feet: body.feet(there.position(), there.heading_rad),
                    besides: None,
                    body: Some(placed(&there)),
                    position: there.position(),
                    heading_rad: there.heading_rad,
                };
                let reading = sees(&sensor, &seen);
                assert!(may.be(reading), "{zone}: {reading} at {there:?} in {at:?}");
                // Whoever is clear of it bent in some way may be so for what is known of somebody upright.
                let upright = body.placed(at.position(), at.heading_rad, Posture::Upright, BendFraction::FULL);
                let stays = may_stay_clear(&sensor, &body, &upright, &at);
                assert!(reading || stays, "{zone}: clear at {there:?} in {at:?}");
                bent_away += usize::from(!reading && !may_report(&sensor, &body, &upright, &at).clear);
                seen_by[zone][usize::from(reading)] += 1;
            }
        }
        assert!(seen_by.iter().all(|[clear, seen]| 11 * seen > *clear && 23 * clear > *seen), "{seen_by:?}");
        assert!(10 * certain > 9 * small_boxes && bent_away > 2, "{certain} of {small_boxes}, {bent_away}");
    }
}
