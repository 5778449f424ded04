//! How hard a robot strikes at one instant: force ratios per speed, for somebody who can give way and for a part of the body that
//! cannot, and pressures where the link says how small it touches.

use super::criterion::pressure::{LinkContact, Surface};
use super::criterion::{Criteria, Criterion};
use crate::geometry::Vec3;
use crate::standards::body_area::quasi_static_pressure_n_cm2;
use crate::standards::iso_ts_15066::{
    Recoil, TRANSIENT_FACTOR, padded_impedance_n_s_m, quasi_static_limit_n, robot_effective_mass, transient_limit_n,
};
use crate::standards::{BodyArea, BodyRegion};

/// Robot points slower than this count as standing still, m/s.
pub const STANDSTILL_M_S: f64 = 1e-3;

/// How hard a link of a robot strikes as a whole at one instant.
#[derive(Clone, Debug, PartialEq)]
pub struct Strike {
    /// Effective mass `m_R = M/2 + m_L` (A.4), kg.
    pub effective_mass_kg: f64,
    /// What counts.
    pub criteria: Criteria,
    /// How small the link touches; nothing if that is not known or does not count.
    surface: Option<Surface>,
    padding_n_m: Option<f64>,
    /// `F / F_max` per speed, of the transient force; by region.
    free: [f64; BodyRegion::ALL.len()],
    /// The same of a part that is clamped.
    clamped: [f64; BodyRegion::ALL.len()],
}

impl Strike {
    /// For a robot of `moving_mass_kg` that carries `payload_kg`, and a link that touches like this.
    #[must_use]
    pub fn new(moving_mass_kg: f64, payload_kg: f64, criteria: Criteria, contact: LinkContact) -> Self {
        let effective_mass_kg = robot_effective_mass(moving_mass_kg, payload_kg);
        let padding_n_m = contact.padding_n_m;
        let per_speed = |recoil, limit: fn(BodyRegion) -> f64| {
            BodyRegion::ALL.map(|region| {
                1.0 / (limit(region) / padded_impedance_n_s_m(region, recoil, effective_mass_kg, padding_n_m))
            })
        };
        Self {
            effective_mass_kg,
            criteria,
            surface: contact.surface.filter(|_| criteria.pressure),
            padding_n_m,
            free: per_speed(Recoil::Free, transient_limit_n),
            clamped: per_speed(Recoil::None, quasi_static_limit_n),
        }
    }

    /// For a robot of which nothing else is known, by the paper's criterion or with the speed of approach.
    #[cfg(test)]
    pub(crate) fn of_robot(moving_mass_kg: f64, payload_kg: f64, criterion: Criterion) -> Self {
        Self::new(moving_mass_kg, payload_kg, Criteria::default().with_speed(criterion), LinkContact::default())
    }

    /// `F_coll / F_max` for a contact of `region` with a robot point moving at `speed_m_s`, of somebody who can give way; linear in
    /// the speed, and whatever counts.
    #[must_use]
    pub(crate) fn force_ratio(&self, region: BodyRegion, speed_m_s: f64) -> f64 {
        self.free[region as usize] * speed_m_s
    }

    /// How unsafe a contact is of somebody who can give way: the largest of what counts over its limit. Never falls where the speed
    /// rises.
    #[must_use]
    pub fn ratio(&self, region: BodyRegion, speed_m_s: f64) -> f64 {
        let force = if self.criteria.transient_force.is_some() { self.force_ratio(region, speed_m_s) } else { 0.0 };
        if self.surface.is_none() {
            return force;
        }
        let pressed = self.pressed(region, None, self.force_n(region, Recoil::Free, speed_m_s), Recoil::Free);
        force.max(pressed.map_or(0.0, |(pressure, limit)| pressure / limit))
    }

    /// The same of a part that is clamped, where the gap closes at `closing_m_s`.
    #[must_use]
    pub fn clamped_ratio(&self, region: BodyRegion, closing_m_s: f64) -> f64 {
        let force = self.clamped[region as usize] * closing_m_s;
        if self.surface.is_none() {
            return force;
        }
        let pressed = self.pressed(region, None, self.force_n(region, Recoil::None, closing_m_s), Recoil::None);
        force.max(pressed.map_or(0.0, |(pressure, limit)| pressure / limit))
    }

    /// Force on a region at a speed, N.
    #[must_use]
    pub(crate) fn force_n(&self, region: BodyRegion, recoil: Recoil, speed_m_s: f64) -> f64 {
        speed_m_s * padded_impedance_n_s_m(region, recoil, self.effective_mass_kg, self.padding_n_m)
    }

    /// Pressure and its limit for a force, N/cm2, where that is known and counts; of an area of the region, or of all of it.
    #[must_use]
    pub(crate) fn pressed(
        &self,
        region: BodyRegion,
        area: Option<BodyArea>,
        force_n: f64,
        recoil: Recoil,
    ) -> Option<(f64, f64)> {
        let surface = self.surface?;
        let quasi_static = area.map_or_else(|| quasi_static_pressure_n_cm2(region), BodyArea::quasi_static_n_cm2);
        let factor = match recoil {
            Recoil::Free if !region.permits_no_contact() => TRANSIENT_FACTOR,
            Recoil::Free | Recoil::None => 1.0,
        };
        Some((surface.pressure_n_cm2(region, force_n), factor * quasi_static))
    }

    /// The speed that decides when a robot point at velocity `robot` meets an arm of a person who walks at `human`, m/s. How an
    /// arm itself moves is open, so its approach has any direction.
    #[must_use]
    pub fn deciding_speed(&self, robot: Vec3, human: Vec3) -> f64 {
        match self.criteria.speed() {
            Criterion::Absolute => robot.length(),
            Criterion::Approach if robot.length() <= STANDSTILL_M_S => 0.0,
            Criterion::Approach => (robot - human).length(),
        }
    }

    /// An upper bound on the speed that decides where no robot point is faster than `robot_m_s`, nor faster than `relative`
    /// gives, m/s, seen by the person.
    #[must_use]
    pub fn deciding_speed_bound(&self, robot_m_s: f64, relative: impl FnOnce() -> f64) -> f64 {
        match self.criteria.speed() {
            Criterion::Absolute => robot_m_s,
            Criterion::Approach if robot_m_s <= STANDSTILL_M_S => 0.0,
            Criterion::Approach => relative(),
        }
    }

    /// Whether any contact with a robot point no faster than this could be unsafe: [`Contact::class`](super::Contact::class) asks
    /// both.
    #[must_use]
    pub fn may_harm(&self, speed_m_s: f64) -> bool {
        speed_m_s > STANDSTILL_M_S || self.free.iter().any(|ratio| ratio * speed_m_s > 1.0)
    }

    /// Whether a contact of `region` with a robot point no faster than this could be unsafe, for somebody who stands.
    #[must_use]
    pub fn may_harm_region(&self, region: BodyRegion, speed_m_s: f64) -> bool {
        self.ratio(region, speed_m_s) > 1.0 || (region.permits_no_contact() && speed_m_s > STANDSTILL_M_S)
    }
}
