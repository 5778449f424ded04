//! The one door for randomness: a seeded PCG-64 (MCG) generator, passed down, never global.

use rand_core::{Rng as _, SeedableRng as _};
use rand_pcg::Pcg64Mcg;

/// A seeded generator whose stream is part of the tool's documented behaviour: same seed, same numbers.
#[derive(Clone, Debug)]
pub struct Rng(Pcg64Mcg);

impl Rng {
    /// A generator for `seed`, any number.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self(Pcg64Mcg::seed_from_u64(seed))
    }

    /// A uniform integer in `0..bound` without bias (rejection), `bound > 0`.
    ///
    /// Written here, and not taken from `rand`, because value stability of its ranges is promised only within a
    /// minor version, and results must not change with a dependency.
    pub fn below(&mut self, bound: usize) -> usize {
        let bound = bound as u64;
        let zone = u64::MAX - (u64::MAX - bound + 1) % bound;
        loop {
            let x = self.0.next_u64();
            if x <= zone {
                #[expect(clippy::cast_possible_truncation, reason = "the result is below a usize")]
                return (x % bound) as usize;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Rng;

    #[test]
    fn same_seed_gives_the_same_numbers_and_another_seed_others() {
        let draw = |seed| (0..20).scan(Rng::new(seed), |r, _| Some(r.below(36))).collect::<Vec<_>>();
        assert_eq!(draw(7), draw(7));
        assert_ne!(draw(7), draw(8));
    }

    #[test]
    fn the_stream_is_frozen() {
        // A change here changes every published result: it needs a new minor version and a changelog entry.
        let mut rng = Rng::new(1);
        let first: Vec<usize> = (0..8).map(|_| rng.below(36)).collect();
        assert_eq!(first, FROZEN);
    }
    const FROZEN: [usize; 8] = [7, 19, 20, 28, 8, 27, 35, 26];

    #[test]
    fn all_values_come_about_equally_often() {
        let mut rng = Rng::new(3);
        let mut count = [0_u32; 36];
        for _ in 0..36_000 {
            count[rng.below(36)] += 1;
        }
        // Chi-squared with 35 degrees of freedom: 99.9 % quantile is 66.6.
        let chi2: f64 = count.iter().map(|&n| (f64::from(n) - 1000.0).powi(2) / 1000.0).sum();
        assert!(chi2 < 66.6, "chi-squared {chi2}");
    }
}
