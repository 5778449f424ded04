//! Many seeds of several strategies on one cell, side by side.

use std::fmt::Write as _;

use serde::Serialize;

use crate::search::statistics::{Interval, Runs, ratio_interval};

/// One strategy's runs.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// Strategy name.
    pub strategy: String,
    /// Iteration of the first hazard for each seed, in the order of the seeds; `None` is a miss.
    pub first_hit: Vec<Option<u32>>,
    /// Capped mean of the iterations to the first hazard.
    pub mean: f64,
    /// Its 95 % bootstrap interval.
    pub mean_interval: [f64; 2],
    /// Sample standard deviation.
    pub sigma: f64,
    /// Seeds without a hazard.
    pub misses: usize,
    /// 95 % Wilson interval of the miss probability.
    pub miss_interval: [f64; 2],
    /// Mean number of 200 ms actions simulated until the first hazard or the end of the budget.
    pub mean_actions: f64,
    /// Capped mean over that of the reference (the last row), with its 95 % bootstrap interval.
    pub ratio_to_reference: Option<[f64; 3]>,
}

/// The table.
#[derive(Clone, Debug, Serialize)]
pub struct Campaign {
    /// Cell name.
    pub cell: String,
    /// Budget in iterations.
    pub iterations: u32,
    /// First seed and number of seeds.
    pub seeds: [u64; 2],
    /// All six postures checked per walk (then iterations do not compare with the paper's).
    pub posture_sweep: bool,
    /// Strategies; the last is the reference.
    pub rows: Vec<Row>,
}

const fn pair(i: Interval) -> [f64; 2] {
    [i.low, i.high]
}

impl Campaign {
    /// Statistics of `runs` (strategy, first hits, actions simulated per seed); the last strategy is the reference.
    #[must_use]
    pub fn new(
        cell: &str,
        seeds: [u64; 2],
        iterations: u32,
        posture_sweep: bool,
        runs: &[(String, Runs, Vec<u64>)],
    ) -> Self {
        let row = |(i, (strategy, r, actions)): (usize, &(String, Runs, Vec<u64>))| {
            let (mean, sigma) = r.mean_and_sigma();
            let ratio = (i + 1 < runs.len()).then(|| {
                let reference = &runs[runs.len() - 1].1;
                let interval = ratio_interval(r, reference, 0);
                [mean / reference.mean_and_sigma().0, interval.low, interval.high]
            });
            Row {
                strategy: strategy.clone(),
                first_hit: r.first_hit.clone(),
                mean,
                mean_interval: pair(r.mean_interval(0)),
                sigma,
                misses: r.misses(),
                miss_interval: pair(r.miss_interval()),
                mean_actions: actions.iter().sum::<u64>() as f64 / (actions.len() as f64).max(1.0),
                ratio_to_reference: ratio,
            }
        };
        let rows = runs.iter().enumerate().map(row).collect();
        Self { cell: cell.to_owned(), iterations, seeds, posture_sweep, rows }
    }

    /// A table for a terminal.
    #[must_use]
    pub fn render(&self) -> String {
        let mut out = String::new();
        let sweep =
            if self.posture_sweep { "posture sweep on" } else { "posture sweep off, iterations as in the paper" };
        let _ = writeln!(
            out,
            "{}: iterations to the first hazard, {} seeds from {}, misses counted as {} ({sweep})",
            self.cell, self.seeds[1], self.seeds[0], self.iterations
        );
        let _ = writeln!(
            out,
            " {:<18} {:>7} {:>17} {:>7} {:>7} {:>15} {:>9}  ratio to {}",
            "strategy",
            "T",
            "95 % interval",
            "sigma",
            "misses",
            "95 % interval",
            "actions",
            self.rows.last().map_or("", |r| r.strategy.as_str())
        );
        for r in &self.rows {
            let ratio = match r.ratio_to_reference {
                Some([v, low, high]) => format!("{v:.2} [{low:.2}, {high:.2}]"),
                None => "1".to_owned(),
            };
            let _ = writeln!(
                out,
                " {:<18} {:>7.1} {:>17} {:>7.1} {:>7} {:>15} {:>9.0}  {ratio}",
                r.strategy,
                r.mean,
                format!("[{:.1}, {:.1}]", r.mean_interval[0], r.mean_interval[1]),
                r.sigma,
                r.misses,
                format!("[{:.3}, {:.3}]", r.miss_interval[0], r.miss_interval[1]),
                r.mean_actions,
            );
        }
        out
    }
}
