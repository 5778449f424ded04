//! What is unsafe at an instant without ending a sequence: a contact with a robot that moves, and a robot that is nearer than the
//! protective separation distance.

use super::contacts::Posed;
use super::{Hit, Instant, Occupant, SignalledRuns};
use crate::Coverage;
use crate::hazard::contact::Apart;
use crate::hazard::criterion::separation::{Separation, Stopping};
use crate::hazard::{Contact, STANDSTILL_M_S};
use crate::robot::RobotFrame;

impl Occupant {
    /// What is unsafe at an instant without ending an action: a moving contact, or a robot that is too near.
    pub(super) fn passing<E: SignalledRuns>(
        &self,
        posed: Posed<'_>,
        instant: &mut Instant<'_, E>,
        coverage: &mut Coverage,
    ) -> Result<Option<Hit>, E::Error> {
        let place = &posed.stance.place;
        if let Some(moving) = &self.moving
            && self.near(place, instant.frame())
        {
            // What was counted is counted.
            let mut own = Coverage::new(self.cell.sensors.len());
            let posed = Posed { encounter: self.among(moving, place), ..posed };
            let hit = self.contact_near(posed, instant, true, &mut own)?;
            coverage.arm_checks += own.arm_checks;
            coverage.arm_boxes += own.arm_boxes;
            coverage.arm_checks_incomplete += own.arm_checks_incomplete;
            if hit.is_some() {
                return Ok(hit);
            }
        }
        match (&self.cell.separation, instant.earlier.stopping()?) {
            (Some(separation), Some(stopping)) => Ok(too_near(posed, instant.frame(), separation, &stopping)),
            _ => Ok(None),
        }
    }
}

/// The pair of trunk, head or legs and a link that lacks most of the protective separation distance, while some robot moves;
/// what an obstacle is between does not count.
fn too_near(posed: Posed<'_>, frame: &RobotFrame, separation: &Separation, stopping: &Stopping) -> Option<Hit> {
    let Posed { encounter, person, .. } = posed;
    let mut worst: Option<(f64, Contact)> = None;
    for link in (0..frame.links.len()).filter(|link| frame.speed_bounds[*link] > STANDSTILL_M_S) {
        let required_m = separation.required_m(stopping.time_s, stopping.travel_m[link]);
        let (centre, radius) = frame.links[link].bounding_sphere();
        for &(part, capsule) in person.body.parts() {
            let middle = (capsule.a + capsule.b) * 0.5;
            let half = (capsule.b - capsule.a).length() * 0.5 + capsule.radius;
            let lacks = worst.as_ref().map_or(0.0, |worst| worst.0);
            if required_m - ((centre - middle).length() - radius - half) <= lacks {
                continue;
            }
            let Some(contact) = encounter.approach(person, frame, (part, &capsule), link) else {
                continue;
            };
            let missing = required_m - contact.distance_m;
            if missing > lacks || (worst.is_none() && missing > 0.0) {
                let stops_after_s = stopping.time_s;
                let apart = Apart { required_m, stops_after_s, travel_m: stopping.travel_m[link] };
                worst = Some((missing, contact.too_near(apart)));
            }
        }
    }
    worst.map(|(_, contact)| Hit::new((contact, None), frame))
}
