//! Statistics over many seeds of one strategy: how many iterations until the first hazard, and how often none.
//!
//! The paper's `T` counts a miss as the whole budget (a capped, or restricted, mean); its figures fit that reading.

use super::Rng;

/// Iterations to the first hazard over many seeds; `None` is a miss within the budget.
#[derive(Clone, Debug, PartialEq)]
pub struct Runs {
    /// One entry a seed.
    pub first_hit: Vec<Option<u32>>,
    /// The budget in iterations.
    pub cap: u32,
}

/// A two-sided 95 % interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Lower end.
    pub low: f64,
    /// Upper end.
    pub high: f64,
}

/// What repeated independent tries, each a success with the same probability, give until the first success: the exact
/// figures of random search, where that probability is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Independent {
    /// Probability of a success in one try.
    pub probability: f64,
    /// Tries at most.
    pub cap: u32,
}

impl Independent {
    /// Probability that `tries` tries all fail.
    fn fails(&self, tries: u32) -> f64 {
        // The first try has not been made yet: nothing has failed, however sure a success is.
        if tries == 0 {
            return 1.0;
        }
        libm::exp(f64::from(tries) * libm::log1p(-self.probability))
    }

    /// Probability of no success at all.
    #[must_use]
    pub fn miss(&self) -> f64 {
        self.fails(self.cap)
    }

    /// Mean number of tries until the first success without any cap: `1 / probability`; none if there is no success.
    #[must_use]
    pub fn mean(&self) -> Option<f64> {
        (self.probability > 0.0).then(|| 1.0 / self.probability)
    }

    /// Mean and standard deviation of the number of tries, the cap counting as the number of a miss: what many runs with
    /// that cap give in the mean, which is the least of cap and [`Independent::mean`] or less.
    #[must_use]
    pub fn mean_and_sigma(&self) -> (f64, f64) {
        // Sums over k of P(T > k) and of (2 k + 1) P(T > k) are the first two moments.
        let (mut first, mut second) = (0.0, 0.0);
        for k in 0..self.cap {
            let still = self.fails(k);
            first += still;
            second += f64::from(2 * k + 1) * still;
        }
        (first, (second - first * first).max(0.0).sqrt())
    }
}

/// Number of bootstrap resamples behind each interval.
pub(crate) const RESAMPLES: usize = 10_000;

impl Runs {
    /// Iterations with misses counted as the cap.
    #[must_use]
    pub(crate) fn capped(&self) -> Vec<f64> {
        self.first_hit.iter().map(|h| f64::from(h.unwrap_or(self.cap))).collect()
    }

    /// Capped mean `T` and sample standard deviation `sigma`.
    #[must_use]
    pub fn mean_and_sigma(&self) -> (f64, f64) {
        let x = self.capped();
        let mean = mean(&x);
        let n = x.len() as f64;
        let var = x.iter().map(|v| (v - mean) * (v - mean)).sum::<f64>() / (n - 1.0).max(1.0);
        (mean, var.sqrt())
    }

    /// Number of seeds that found nothing.
    #[must_use]
    pub fn misses(&self) -> usize {
        self.first_hit.iter().filter(|h| h.is_none()).count()
    }

    /// Penalised average: a miss counts twice the cap (PAR-2).
    #[must_use]
    pub fn par2(&self) -> f64 {
        let cap = 2.0 * f64::from(self.cap);
        mean(&self.first_hit.iter().map(|h| h.map_or(cap, f64::from)).collect::<Vec<_>>())
    }

    /// Kaplan-Meier estimate of the share of runs still without a hazard after each iteration at which one found its
    /// first; misses are censored at the cap.
    #[must_use]
    pub fn survival(&self) -> Vec<(u32, f64)> {
        let mut hits: Vec<u32> = self.first_hit.iter().flatten().copied().collect();
        hits.sort_unstable();
        let mut left = self.first_hit.len() as f64;
        let (mut curve, mut share) = (Vec::new(), 1.0);
        for same in hits.chunk_by(|a, b| a == b) {
            let found = same.len() as f64;
            share *= 1.0 - found / left;
            left -= found;
            curve.push((same[0], share));
        }
        curve
    }

    /// Kaplan-Meier median: the iteration after which at most half of the runs are left; none if more missed.
    #[must_use]
    pub fn median(&self) -> Option<u32> {
        self.survival().into_iter().find(|(_, share)| *share <= 0.5).map(|(iteration, _)| iteration)
    }

    /// First hits over iterations run: the maximum-likelihood rate where each iteration hits independently, as in
    /// random search.
    #[must_use]
    pub fn rate(&self) -> f64 {
        let hits = self.first_hit.len() - self.misses();
        hits as f64 / self.capped().iter().sum::<f64>().max(1.0)
    }

    /// Percentile-bootstrap interval of the capped mean.
    #[must_use]
    pub fn mean_interval(&self, seed: u64) -> Interval {
        mean_interval(&self.capped(), seed)
    }

    /// Wilson interval of the probability that a run finds nothing (95 %).
    #[must_use]
    pub fn miss_interval(&self) -> Interval {
        wilson(self.misses(), self.first_hit.len())
    }
}

/// Percentile-bootstrap interval of the ratio of capped means `a / b` (independent samples).
#[must_use]
pub fn ratio_interval(a: &Runs, b: &Runs, seed: u64) -> Interval {
    ratio_of_means_interval(&a.capped(), &b.capped(), seed)
}

/// Wilson score interval for `hits` of `n`, 95 %.
#[must_use]
pub fn wilson(hits: usize, n: usize) -> Interval {
    let z = 1.959_963_984_540_054_f64;
    let (k, n) = (hits as f64, n as f64);
    if n == 0.0 {
        return Interval { low: 0.0, high: 1.0 };
    }
    let p = k / n;
    let centre = (p + z * z / (2.0 * n)) / (1.0 + z * z / n);
    let half = z / (1.0 + z * z / n) * (p * (1.0 - p) / n + z * z / (4.0 * n * n)).sqrt();
    Interval { low: (centre - half).max(0.0), high: (centre + half).min(1.0) }
}

/// Exact two-sided 95 % interval for `hits` of `n` (Clopper and Pearson, Biometrika 26, 1934).
#[must_use]
pub(crate) fn clopper_pearson(hits: u64, n: u64) -> Interval {
    let hits = hits.min(n);
    Interval { low: 1.0 - binomial_upper(n - hits, n, 0.025), high: binomial_upper(hits, n, 0.025) }
}

/// Exact one-sided upper bound for `hits` of `n` with confidence `1 - alpha`: the probability of a hit with which so few
/// hits, or fewer, have the probability `alpha`. For no hit that is `1 - alpha^(1/n)`.
#[must_use]
pub(crate) fn binomial_upper(hits: u64, n: u64, alpha: f64) -> f64 {
    if hits >= n {
        return 1.0;
    }
    // The sum falls from a half or so at `hits / n` to 0 at 1: halve until no number lies between.
    let (mut low, mut high) = (hits as f64 / n as f64, 1.0);
    loop {
        let middle = f64::midpoint(low, high);
        if middle <= low || middle >= high {
            return high;
        }
        if at_most(hits, n, middle) > alpha {
            low = middle;
        } else {
            high = middle;
        }
    }
}

/// Probability of at most `hits` hits in `n` tries, `hits / n < p < 1`: the terms fall from that of `hits` downwards.
fn at_most(hits: u64, n: u64, p: f64) -> f64 {
    let (k, all) = (hits as f64, n as f64);
    let ways = libm::lgamma(all + 1.0) - libm::lgamma(k + 1.0) - libm::lgamma(all - k + 1.0);
    let mut term = libm::exp(ways + k * libm::log(p) + (all - k) * libm::log1p(-p));
    let (mut sum, mut i) = (term, k);
    while i > 0.0 && term > sum * f64::EPSILON {
        term *= i * (1.0 - p) / ((all - i + 1.0) * p);
        sum += term;
        i -= 1.0;
    }
    sum
}

/// Percentile-bootstrap interval of a mean.
#[must_use]
pub fn mean_interval(x: &[f64], seed: u64) -> Interval {
    bootstrap(seed, |rng| resampled_mean(x, rng))
}

/// Percentile-bootstrap interval of the ratio of the means of `x` and `y` (independent samples).
#[must_use]
pub fn ratio_of_means_interval(x: &[f64], y: &[f64], seed: u64) -> Interval {
    bootstrap(seed, |rng| resampled_mean(x, rng) / resampled_mean(y, rng))
}

/// Mean.
#[must_use]
pub fn mean(x: &[f64]) -> f64 {
    x.iter().sum::<f64>() / (x.len() as f64).max(1.0)
}

fn resampled_mean(x: &[f64], rng: &mut Rng) -> f64 {
    (0..x.len()).map(|_| x[rng.below(x.len())]).sum::<f64>() / (x.len() as f64).max(1.0)
}

fn bootstrap(seed: u64, mut statistic: impl FnMut(&mut Rng) -> f64) -> Interval {
    let mut rng = Rng::new(seed);
    let mut values: Vec<f64> = (0..RESAMPLES).map(|_| statistic(&mut rng)).collect();
    values.sort_by(f64::total_cmp);
    let at = |per_mille: usize| values[(RESAMPLES * per_mille / 1000).min(RESAMPLES - 1)];
    Interval { low: at(25), high: at(975) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn misses_count_as_the_cap() {
        let runs = Runs { first_hit: vec![Some(10), None, Some(20)], cap: 320 };
        let (t, sigma) = runs.mean_and_sigma();
        assert!((t - 350.0 / 3.0).abs() < 1e-12);
        // By hand: deviations -106.667, 203.333, -96.667; sum of squares 62 066.667; / 2; square root.
        assert!((sigma - 176.163_f64).abs() < 1e-3, "{sigma}");
        assert_eq!(runs.misses(), 1);
    }

    #[test]
    fn independent_tries_by_hand() {
        // Up to 2 tries at 1/4: one with 1/4, two with 3/4; mean 7/4, variance 3/16; none succeeds with 9/16.
        let two = Independent { probability: 0.25, cap: 2 };
        let (mean, sigma) = two.mean_and_sigma();
        assert!((mean - 1.75).abs() < 1e-12 && (sigma - (3.0_f64 / 16.0).sqrt()).abs() < 1e-12, "{mean} {sigma}");
        assert!((two.miss() - 9.0 / 16.0).abs() < 1e-12);
        // Without a cap in sight: the geometric distribution, mean 1/p, variance (1 - p) / p^2.
        let (mean, sigma) = Independent { probability: 0.1, cap: 2000 }.mean_and_sigma();
        assert!((mean - 10.0).abs() < 1e-9 && (sigma - 90.0_f64.sqrt()).abs() < 1e-9);
        assert_eq!(Independent { probability: 0.0, cap: 320 }.mean_and_sigma(), (320.0, 0.0));
        assert_eq!(Independent { probability: 1.0, cap: 320 }.mean_and_sigma(), (1.0, 0.0));
    }

    #[test]
    fn survival_by_hand() {
        // Freireich et al. (1963), 6-MP group, as far as no one is lost in between: 3 of 7 at 6, then 1 at 7.
        let first_hit = vec![Some(6), Some(6), Some(6), Some(7), None, None, None];
        let runs = Runs { first_hit, cap: 35 };
        let curve = runs.survival();
        assert_eq!(curve.len(), 2);
        assert!((curve[0].1 - 4.0 / 7.0).abs() < 1e-12 && (curve[1].1 - 3.0 / 7.0).abs() < 1e-12, "{curve:?}");
        assert_eq!(runs.median(), Some(7));
        assert!((runs.par2() - (18.0 + 7.0 + 210.0) / 7.0).abs() < 1e-12);
        assert!((runs.rate() - 4.0 / (18.0 + 7.0 + 105.0)).abs() < 1e-12);
        assert_eq!(Runs { first_hit: vec![None, Some(1), None], cap: 5 }.median(), None);
    }

    #[test]
    fn wilson_agrees_with_published_values() {
        // Newcombe (1998), Table I, method 3: 81 of 263 -> 0.2553..0.3662; 0 of 20 -> 0..0.1611.
        let i = wilson(81, 263);
        assert!((i.low - 0.2553).abs() < 5e-5 && (i.high - 0.3662).abs() < 5e-5, "{i:?}");
        let i = wilson(0, 20);
        assert!(i.low.abs() < 1e-12 && (i.high - 0.1611).abs() < 5e-5, "{i:?}");
    }

    #[test]
    fn clopper_pearson_agrees_with_published_values() {
        // Newcombe (1998), Table I, method 5.
        for (hits, n, low, high) in
            [(81, 263, 0.2527, 0.3676), (15, 148, 0.0578, 0.1617), (0, 20, 0.0, 0.1684), (1, 29, 0.0009, 0.1776)]
        {
            let i = clopper_pearson(hits, n);
            assert!((i.low - low).abs() < 5e-5 && (i.high - high).abs() < 5e-5, "{hits} of {n}: {i:?}");
        }
        assert_eq!(clopper_pearson(0, 0), Interval { low: 0.0, high: 1.0 });
        assert_eq!(clopper_pearson(7, 7).high.to_bits(), 1.0_f64.to_bits());
    }

    #[test]
    fn binomial_bounds_in_closed_form() {
        // No hit: (1 - p)^n = alpha. All but one: 1 - p^n = alpha. Half of two: p^2 = 1 - alpha.
        for n in [1, 2, 64, 320, 1_000_000] {
            let tries = n as f64;
            let none = -libm::expm1(libm::log(0.05) / tries);
            assert!((binomial_upper(0, n, 0.05) / none - 1.0).abs() < 1e-9, "{n}");
            let all_but_one = libm::exp(libm::log(0.95) / tries);
            assert!((binomial_upper(n - 1, n, 0.05) - all_but_one).abs() < 1e-9, "{n}");
        }
        // Far from the ends, by the normal approximation with continuity correction.
        let i = clopper_pearson(500_000, 1_000_000);
        assert!((i.high - 0.500_980_5).abs() < 1e-6 && (i.low - 0.499_019_5).abs() < 1e-6, "{i:?}");
    }

    #[test]
    fn bootstrap_of_a_mean_matches_the_normal_approximation() {
        let first_hit: Vec<Option<u32>> = (0..200).map(|i| Some(50 + i % 21)).collect();
        let runs = Runs { first_hit, cap: 320 };
        let (t, sigma) = runs.mean_and_sigma();
        let half = 1.96 * sigma / 200_f64.sqrt();
        let i = runs.mean_interval(1);
        assert!((i.low - (t - half)).abs() < 0.1 && (i.high - (t + half)).abs() < 0.1, "{i:?} {t} {half}");
    }
}
