//! Many seeds of several strategies on one cell, side by side.

use std::fmt::Write as _;

use serde::Serialize;

use super::paper;
use crate::search::statistics::{Interval, Runs, ratio_interval};
use crate::sim::Coverage;

/// Columns of [`Campaign::csv`].
pub(crate) const CSV_HEADER: &str = "cell,strategy,seeds,budget,t,t_low,t_high,sigma,misses,par2,km_median,rate,\
                              ratio,ratio_low,ratio_high,paper_t,paper_sigma,paper_misses_of_10\n";

/// One strategy's runs.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Row {
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
    /// Penalised average: a miss counts twice the budget.
    pub par2: f64,
    /// Kaplan-Meier median; none if more than half of the seeds found nothing.
    pub median: Option<u32>,
    /// First hits over iterations run.
    pub rate: f64,
    /// Kaplan-Meier curve: share of seeds without a hazard after these iterations.
    pub survival: Vec<(u32, f64)>,
    /// Mean number of 200 ms actions simulated until the first hazard or the end of the budget.
    pub mean_actions: f64,
    /// What all runs together have seen.
    pub coverage: Coverage,
    /// Capped mean over that of the reference (the last row), with its 95 % bootstrap interval.
    pub ratio_to_reference: Option<[f64; 3]>,
}

/// The table.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Campaign {
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
    /// Statistics of `runs` (strategy, first hits, what was seen); the last strategy is the reference.
    #[must_use]
    pub(crate) fn new(
        cell: &str,
        seeds: [u64; 2],
        iterations: u32,
        posture_sweep: bool,
        runs: &[(String, Runs, Coverage)],
    ) -> Self {
        let row = |(i, (strategy, r, coverage)): (usize, &(String, Runs, Coverage))| {
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
                par2: r.par2(),
                median: r.median(),
                rate: r.rate(),
                survival: r.survival(),
                mean_actions: coverage.actions as f64 / (r.first_hit.len() as f64).max(1.0),
                coverage: coverage.clone(),
                ratio_to_reference: ratio,
            }
        };
        let rows = runs.iter().enumerate().map(row).collect();
        Self { cell: cell.to_owned(), iterations, seeds, posture_sweep, rows }
    }

    /// Rows as comma-separated values, one a strategy; [`CSV_HEADER`] names the columns.
    #[must_use]
    pub(crate) fn csv(&self) -> String {
        let optional = |v: Option<String>| v.unwrap_or_default();
        let row = |r: &Row| {
            let paper = paper::of(&self.cell).and_then(|p| match r.strategy.as_str() {
                "mcts-dpw" => Some(p.mcts),
                "random" => Some(p.random),
                _ => None,
            });
            let fields = [
                self.cell.clone(),
                r.strategy.clone(),
                self.seeds[1].to_string(),
                self.iterations.to_string(),
                r.mean.to_string(),
                r.mean_interval[0].to_string(),
                r.mean_interval[1].to_string(),
                r.sigma.to_string(),
                r.misses.to_string(),
                r.par2.to_string(),
                optional(r.median.map(|m| m.to_string())),
                r.rate.to_string(),
                optional(r.ratio_to_reference.map(|v| v[0].to_string())),
                optional(r.ratio_to_reference.map(|v| v[1].to_string())),
                optional(r.ratio_to_reference.map(|v| v[2].to_string())),
                optional(paper.map(|p| p.t.to_string())),
                optional(paper.map(|p| p.sigma.to_string())),
                optional(paper.map(|p| p.misses.to_string())),
            ];
            fields.join(",") + "\n"
        };
        self.rows.iter().map(row).collect()
    }

    /// A table for a terminal.
    #[must_use]
    pub(crate) fn render(&self) -> String {
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
        for r in &self.rows {
            let c = &r.coverage;
            let _ = writeln!(
                out,
                " {:<18} {} contact checks, robot within arm's reach at {}; robot up to {:.2} m/s, body as near as {}; sensors \
                 fired in {:?} actions, {} walks blocked",
                r.strategy,
                c.contact_checks,
                c.checks_with_robot_in_arm_reach,
                c.robot_top_speed_m_s,
                if c.closest_approach_m < 1e6 { format!("{:.2} m", c.closest_approach_m) } else { "never".to_owned() },
                c.sensor_actions,
                c.walks_blocked,
            );
        }
        out
    }
}

/// The paper's table beside ours, for several cells.
#[must_use]
pub(crate) fn beside_the_paper(campaigns: &[Campaign], markdown: bool) -> String {
    let header = [
        "scenario",
        "strategy",
        "T",
        "95 % interval",
        "sigma",
        "misses",
        "PAR-2",
        "median",
        "ratio to random",
        "paper: T",
        "sigma",
        "misses",
        "ratio",
    ];
    let mut rows: Vec<Vec<String>> = Vec::new();
    for campaign in campaigns {
        let paper = paper::of(&campaign.cell);
        for (i, r) in campaign.rows.iter().enumerate() {
            let theirs = paper.and_then(|p| match r.strategy.as_str() {
                "mcts-dpw" => Some((p.mcts, Some(p.mcts.t / p.random.t))),
                "random" => Some((p.random, None)),
                _ => None,
            });
            let blank = String::new;
            rows.push(vec![
                if i == 0 { campaign.cell.clone() } else { blank() },
                r.strategy.clone(),
                format!("{:.1}", r.mean),
                format!("[{:.1}, {:.1}]", r.mean_interval[0], r.mean_interval[1]),
                format!("{:.1}", r.sigma),
                format!("{} of {}", r.misses, campaign.seeds[1]),
                format!("{:.1}", r.par2),
                r.median.map_or_else(|| "-".to_owned(), |m| m.to_string()),
                r.ratio_to_reference.map_or_else(blank, |[v, low, high]| format!("{v:.2} [{low:.2}, {high:.2}]")),
                theirs.map_or_else(blank, |(p, _)| format!("{:.1}", p.t)),
                theirs.map_or_else(blank, |(p, _)| format!("{:.1}", p.sigma)),
                theirs.map_or_else(blank, |(p, _)| format!("{} of 10", p.misses)),
                theirs.and_then(|(_, ratio)| ratio).map_or_else(blank, |ratio| format!("{ratio:.2}")),
            ]);
        }
    }
    crate::report::columns(&header, &rows, markdown)
}
