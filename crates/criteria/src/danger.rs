//! Danger level `c_D` and reward of the paper (Huck et al. 2021).
//!
//! ```text
//! c_D = F_coll / F_max                         (a) contact
//!       min(F_virtual / F_max * exp(-d), 1)    (b) no contact, d <= 1.5 m; the force if the closest pair collided
//!       0.01                                   (c) farther away, or fully separated by a barrier
//! R   = R_E    unsafe state
//!       -1/c_D last action, not unsafe
//!       0      otherwise
//! ```

/// Distance beyond which a robot counts as far away, m.
pub(crate) const NEAR_M: f64 = 1.5;

/// Danger level of a far or separated robot.
pub(crate) const FAR_LEVEL: f64 = 0.01;

/// Reward of an unsafe state, `R_E`: the paper asks for a non-negative constant; the other rewards are at most zero.
pub const UNSAFE_REWARD: f64 = 0.0;

/// How near the end state of an episode came to harm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Proximity {
    /// (a) Contact with this force ratio.
    Contact {
        /// `F_coll / F_max`.
        ratio: f64,
    },
    /// (b) Nothing between the closest pair, `distance_m` apart; `ratio` if it collided now.
    Near {
        /// Distance of the closest pair, m.
        distance_m: f64,
        /// `F_virtual / F_max`.
        ratio: f64,
    },
    /// (c) Far away or behind a barrier.
    Far,
}

impl Proximity {
    /// Danger level `c_D`, never below [`FAR_LEVEL`] (a resting robot must not divide by zero).
    #[must_use]
    pub(crate) fn danger_level(self) -> f64 {
        match self {
            Self::Contact { ratio } => ratio.max(FAR_LEVEL),
            Self::Near { distance_m, ratio } if distance_m <= NEAR_M => {
                (ratio * libm::exp(-distance_m)).clamp(FAR_LEVEL, 1.0)
            }
            Self::Near { .. } | Self::Far => FAR_LEVEL,
        }
    }

    /// Reward of an episode that ends here without an unsafe state.
    #[must_use]
    pub fn reward(self) -> f64 {
        -1.0 / self.danger_level()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_three_cases_by_hand() {
        assert!((Proximity::Contact { ratio: 0.9 }.reward() + 1.0 / 0.9).abs() < 1e-12);
        // 1.2 * exp(-0.5) = 0.7278
        let near = Proximity::Near { distance_m: 0.5, ratio: 1.2 };
        assert!((near.danger_level() - 0.727_837).abs() < 1e-6);
        // Capped at 1: 3 * exp(-0.5) = 1.82
        assert!((Proximity::Near { distance_m: 0.5, ratio: 3.0 }.danger_level() - 1.0).abs() < 1e-12);
        assert!((Proximity::Near { distance_m: 1.6, ratio: 3.0 }.danger_level() - 0.01).abs() < 1e-12);
        assert!((Proximity::Far.reward() + 100.0).abs() < 1e-12);
        assert!((Proximity::Near { distance_m: 0.1, ratio: 0.0 }.danger_level() - 0.01).abs() < 1e-12);
    }
}
