//! Where the human stands, exactly: whole sub-steps along four directions, and a heading in eighths of a turn; and which doors stand
//! open then, since those that are closed are in the way.
//!
//! Metres are computed from the integers, never accumulated, so two routes to one spot give *equal* places, and the
//! exhaustive search can merge them. The four counts are a unique name of a spot: 1, (1+i)/sqrt 2, i, (-1+i)/sqrt 2 are
//! linearly independent over the rational numbers.

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_4};

use super::{Arrangement, Presses};
use crate::geometry::Vec3;

/// Where the human stands at first, in the world frame. Every place is counted from here.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Start {
    x_m: f64,
    y_m: f64,
    heading_rad: f64,
    /// Sine and cosine of the heading.
    sin: f64,
    cos: f64,
}

impl Start {
    /// Start at (`x_m`, `y_m`) on the floor, looking along `heading_deg`: 0 is towards +x, 90 towards +y.
    #[must_use]
    pub fn new(x_m: f64, y_m: f64, heading_deg: f64) -> Self {
        let heading_rad = heading_deg.to_radians();
        let (sin, cos) = libm::sincos(heading_rad);
        Self { x_m, y_m, heading_rad, sin, cos }
    }

    /// Where it is on the floor plan, m.
    #[must_use]
    pub const fn xy_m(&self) -> [f64; 2] {
        [self.x_m, self.y_m]
    }

    /// Where the human looks, from +x towards +y, degrees.
    #[must_use]
    pub const fn heading_deg(&self) -> f64 {
        self.heading_rad.to_degrees()
    }
}

/// A spot on the lattice of walks, a heading on it, and the doors that stand open meanwhile, and how things stand that follow the FMU.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Place {
    /// Sub-steps walked along 0, 45, 90 and 135 degrees from the start heading; opposite directions count down.
    steps: [i32; 4],
    /// Heading to the left of the start heading, in eighths of a full turn: 0..8.
    heading: u8,
    /// Controls whose doors stand open.
    open: Presses,
    /// How things stand that follow the FMU.
    arrangement: Arrangement,
}

impl Place {
    /// The start itself, all doors closed.
    pub const START: Self = Self { steps: [0; 4], heading: 0, open: Presses::NONE, arrangement: Arrangement::NONE };

    /// Heading to the left of the start heading, in eighths of a full turn: 0..8.
    #[cfg(test)]
    pub(crate) const fn heading_eighths(&self) -> u8 {
        self.heading
    }

    /// Controls whose doors stand open.
    #[must_use]
    pub const fn open(&self) -> Presses {
        self.open
    }

    /// The same spot while other doors stand open.
    #[must_use]
    pub const fn with_open(self, open: Presses) -> Self {
        Self { open, ..self }
    }

    /// How things stand that follow the FMU.
    #[must_use]
    pub const fn arrangement(&self) -> Arrangement {
        self.arrangement
    }

    /// The same spot while they stand otherwise.
    #[must_use]
    pub const fn amid(self, arrangement: Arrangement) -> Self {
        Self { arrangement, ..self }
    }

    /// The same spot after a turn to the left by `eighths` of a full turn.
    #[must_use]
    pub const fn turned(self, eighths: i8) -> Self {
        // 256 is a multiple of 8, so the wrapped byte has the right remainder for negative turns too.
        let turn = eighths.cast_unsigned();
        Self { heading: self.heading.wrapping_add(turn) % 8, ..self }
    }

    /// The place one sub-step ahead.
    #[must_use]
    pub const fn stepped(mut self) -> Self {
        let axis = (self.heading % 4) as usize;
        self.steps[axis] += if self.heading < 4 { 1 } else { -1 };
        self
    }

    /// The place one sub-step behind: the way back from [`Self::stepped`].
    #[must_use]
    pub const fn stepped_back(self) -> Self {
        self.turned(4).stepped().turned(4)
    }

    /// How many sub-steps along its heading lead here from `before`, a place with the same heading; backwards less than none.
    #[must_use]
    pub const fn ahead_of(&self, before: &Self) -> i32 {
        let axis = (self.heading % 4) as usize;
        let steps = self.steps[axis] - before.steps[axis];
        if self.heading < 4 { steps } else { -steps }
    }

    /// Position on the floor in the world frame (z = 0), for sub-steps of `sub_step_len_m`. Equal places give equal
    /// bits.
    #[must_use]
    pub fn position(&self, start: &Start, sub_step_len_m: f64) -> Vec3 {
        let [ahead, ahead_left, left, back_left] = self.steps;
        let forward = (f64::from(ahead) + f64::from(ahead_left - back_left) * FRAC_1_SQRT_2) * sub_step_len_m;
        let sideways = (f64::from(left) + f64::from(ahead_left + back_left) * FRAC_1_SQRT_2) * sub_step_len_m;
        Vec3::new(
            start.x_m + start.cos * forward - start.sin * sideways,
            start.y_m + start.sin * forward + start.cos * sideways,
            0.0,
        )
    }

    /// Heading in the world frame, rad, anticlockwise from +x.
    #[must_use]
    pub fn heading_rad(&self, start: &Start) -> f64 {
        start.heading_rad + f64::from(self.heading) * FRAC_PI_4
    }
}

#[cfg(test)]
mod tests {
    use rand_core::{Rng, SeedableRng};
    use rand_pcg::Pcg64;

    use super::*;

    const LEN: f64 = 0.032;

    fn bits(position: Vec3) -> [u64; 3] {
        [position.x.to_bits(), position.y.to_bits(), position.z.to_bits()]
    }

    /// Naive twin: adds metres step by step along an angle in degrees.
    #[test]
    fn random_walks_agree_with_accumulated_metres() {
        for seed in 0..20 {
            let mut random = Pcg64::seed_from_u64(seed);
            let heading_deg = f64::from(random.next_u32() % 360) + 0.25;
            let start = Start::new(1.05, -1.7, heading_deg);
            let (mut place, mut x, mut y, mut degrees) = (Place::START, 1.05, -1.7, heading_deg);
            for _ in 0..200 {
                let turn = [0_i8, 1, 2, -1, -2][random.next_u32() as usize % 5];
                place = place.turned(turn);
                degrees += 45.0 * f64::from(turn);
                for _ in 0..10 {
                    place = place.stepped();
                    x += LEN * libm::cos(degrees.to_radians());
                    y += LEN * libm::sin(degrees.to_radians());
                }
                let position = place.position(&start, LEN);
                assert!((position.x - x).abs() < 1e-9 && (position.y - y).abs() < 1e-9, "seed {seed}: {position}");
                let turns = (place.heading_rad(&start) - degrees.to_radians()) / std::f64::consts::TAU;
                assert!((turns - turns.round()).abs() < 1e-9, "seed {seed}: {turns}");
            }
        }
    }

    /// Shuffles the steps of a random walk: another route, the same spot, the same bits.
    #[test]
    fn another_route_gives_the_same_bits() {
        let start = Start::new(0.2, -1.5, 37.0);
        for seed in 0..20 {
            let mut random = Pcg64::seed_from_u64(seed);
            let mut below = |n: usize| random.next_u32() as usize % n;
            let mut headings: Vec<i8> = (0..80).map(|_| i8::try_from(below(8)).unwrap()).collect();
            let walked = |headings: &[i8]| {
                let mut place = Place::START;
                for heading in headings {
                    let here = i8::try_from(place.heading_eighths()).unwrap();
                    place = place.turned(heading - here).stepped();
                }
                place.turned(-i8::try_from(place.heading_eighths()).unwrap())
            };
            let first = walked(&headings);
            for last in (1..headings.len()).rev() {
                headings.swap(last, below(last + 1));
            }
            // A detour: there and back again along each of the eight directions.
            headings.extend([0, 4, 5, 1, 2, 6, 7, 3]);
            let second = walked(&headings);
            assert_eq!(first, second, "seed {seed}");
            assert_eq!(bits(first.position(&start, LEN)), bits(second.position(&start, LEN)), "seed {seed}");
        }
    }

    #[test]
    fn turns_go_round_in_eighths() {
        for heading in 0..8_i8 {
            for turn in -8..=8_i8 {
                let place = Place::START.turned(heading).turned(turn);
                assert_eq!(i8::try_from(place.heading_eighths()).unwrap(), (heading + turn).rem_euclid(8));
            }
        }
    }

    /// Ten steps along each of the eight headings from the origin, start heading along +x.
    #[test]
    fn headings_point_where_they_say() {
        let start = Start::new(0.0, 0.0, 0.0);
        let diagonal = 0.32 / 2.0_f64.sqrt();
        let expected = [
            (0.32, 0.0),
            (diagonal, diagonal),
            (0.0, 0.32),
            (-diagonal, diagonal),
            (-0.32, 0.0),
            (-diagonal, -diagonal),
            (0.0, -0.32),
            (diagonal, -diagonal),
        ];
        for (heading, (x, y)) in (0..8).zip(expected) {
            let mut place = Place::START.turned(heading);
            for _ in 0..10 {
                place = place.stepped();
            }
            let distance = (place.position(&start, LEN) - Vec3::new(x, y, 0.0)).length();
            assert!(distance < 1e-15, "heading {heading}: off by {distance}");
        }
    }
}
