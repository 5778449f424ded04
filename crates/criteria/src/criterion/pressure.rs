//! Pressure of a contact: the force over the surface that it acts on, which each link has to say.

use std::f64::consts::PI;

use crate::standards::BodyRegion;
use crate::standards::iso_ts_15066::spring_constant_n_m;

/// Area for which the spring constants of ISO/TS 15066 are made, m2.
const CALIBRATED_M2: f64 = 1e-4;

/// Newtons per square metre of one N/cm2.
const PA_PER_N_CM2: f64 = 1e4;

/// How small a link touches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Surface {
    /// An edge or a corner that is rounded with this radius, m.
    Radius(f64),
    /// A flat surface of so many m2.
    Area(f64),
}

/// What a link is like where it touches.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LinkContact {
    /// How small it is; nothing if that is not known.
    pub surface: Option<Surface>,
    /// Stiffness of the padding in front of it, N/m, if it has one.
    pub padding_n_m: Option<f64>,
}

impl Surface {
    /// Greatest pressure of a force on a region, N/cm2: never falls where the force rises.
    #[must_use]
    pub(crate) fn pressure_n_cm2(self, region: BodyRegion, force_n: f64) -> f64 {
        let pa = match self {
            Self::Area(area) => force_n / area,
            Self::Radius(radius) => {
                let modulus = spring_constant_n_m(region) / (2.0 * (CALIBRATED_M2 / PI).sqrt());
                let hertz = libm::cbrt(6.0 * force_n * modulus * modulus / (PI * PI * PI * radius * radius));
                hertz.max(force_n / (PI * radius * radius))
            }
        };
        pa / PA_PER_N_CM2
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: 140 N on 4 cm2 are 35 N/cm2. A hand (75 N/mm: 6.647 MPa) under 100 N and a ball of 10 mm:
    /// (6 * 100 * 6.647e6^2 / (pi^3 * 1e-4))^(1/3) = 2.045 MPa. A tip of 1 mm: 100 N / (pi * 1 mm2) = 3183 N/cm2.
    #[test]
    fn worked_values() {
        let hand = BodyRegion::Hand;
        assert!((Surface::Area(4e-4).pressure_n_cm2(hand, 140.0) - 35.0).abs() < 1e-9);
        assert!((Surface::Radius(0.01).pressure_n_cm2(hand, 100.0) - 204.5).abs() < 0.5);
        assert!((Surface::Radius(0.001).pressure_n_cm2(hand, 100.0) - 3183.1).abs() < 0.1);
    }

    /// Hertz's own relations, the other way round: contact radius a = cbrt(3 F R / (4 E)), mean pressure F / (pi a^2), greatest
    /// one 1.5 times that.
    #[test]
    fn a_ball_presses_as_hertz_says() {
        let chest = BodyRegion::Chest;
        let modulus = 25e3 / (2.0 * 0.005_641_9);
        for (force, radius) in [(50.0, 0.05), (100.0, 0.02), (280.0, 0.1)] {
            let contact = libm::cbrt(3.0 * force * radius / (4.0 * modulus));
            let greatest = 1.5 * force / (PI * contact * contact) / 1e4;
            let told = Surface::Radius(radius).pressure_n_cm2(chest, force);
            if contact < radius {
                assert!((told / greatest - 1.0).abs() < 1e-4, "{told} {greatest}");
            }
        }
    }

    #[test]
    fn more_force_is_more_pressure() {
        for surface in [Surface::Radius(0.001), Surface::Radius(0.03), Surface::Area(2e-4)] {
            let pressures: Vec<f64> =
                (0..200).map(|n| surface.pressure_n_cm2(BodyRegion::Thigh, f64::from(n) * 2.0)).collect();
            assert!(pressures.is_sorted() && pressures[0] == 0.0, "{surface:?}");
        }
    }
}
