//! What `bench strategies` reports: each strategy's cost of the first hazard and the number of hazards it finds.

use std::fmt::Write as _;

use serde::Serialize;

use crate::search::statistics::{Interval, mean, mean_interval, ratio_of_means_interval, wilson};

/// Columns of [`Comparison::csv`].
pub const CSV_HEADER: &str = "cell,strategy,seeds,budget,iterations,iterations_low,iterations_high,\
                              actions,actions_low,actions_high,fmu_steps,fmu_steps_low,fmu_steps_high,misses,\
                              action_ratio,action_ratio_low,action_ratio_high,hazards,hazards_low,hazards_high\n";

/// What one run spent until its first hazard, or until its budget was used up.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Spent {
    /// Whether it found a hazard.
    pub hit: bool,
    /// Iterations.
    pub iterations: u32,
    /// Actions taken in the simulation; what is restored is not taken again.
    pub actions: u64,
    /// Steps of the FMU, each transition once.
    pub fmu_steps: u64,
    /// Different hazards after the whole budget, if the run went on so long.
    pub hazards: Option<usize>,
}

/// A mean with its 95 % interval.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Estimate {
    /// Mean.
    pub mean: f64,
    /// Lower end.
    pub low: f64,
    /// Upper end.
    pub high: f64,
}

impl Estimate {
    fn new(mean: f64, Interval { low, high }: Interval) -> Self {
        Self { mean, low, high }
    }

    fn of(values: &[f64]) -> Self {
        Self::new(mean(values), mean_interval(values, 0))
    }

    fn show(&self, digits: usize) -> [String; 2] {
        let Self { mean, low, high } = self;
        [format!("{mean:.digits$}"), format!("[{low:.digits$}, {high:.digits$}]")]
    }
}

/// One strategy.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// Strategy.
    pub strategy: String,
    /// Iterations to the first hazard; a miss counts as the budget.
    pub iterations: Estimate,
    /// Simulated actions to the first hazard; a miss counts what the budget took.
    pub actions: Estimate,
    /// FMU steps to the first hazard; a miss counts what the budget took.
    pub fmu_steps: Estimate,
    /// Seeds without a hazard.
    pub misses: usize,
    /// 95 % Wilson interval of the miss probability.
    pub miss_interval: [f64; 2],
    /// Simulated actions over those of the reference, which has none.
    pub action_ratio: Option<Estimate>,
    /// Different hazards after the whole budget, over the seeds that went on so long.
    pub hazards: Option<Estimate>,
    /// Each seed.
    pub runs: Vec<Spent>,
}

/// One cell.
#[derive(Clone, Debug, Serialize)]
pub struct Comparison {
    /// Cell name.
    pub cell: String,
    /// First seed.
    pub first_seed: u64,
    /// Number of seeds behind the costs of the first hazard.
    pub seeds: usize,
    /// Budget in iterations.
    pub budget: u32,
    /// All six postures checked per walk.
    pub posture_sweep: bool,
    /// What ratios refer to.
    pub reference: String,
    /// Strategies.
    pub rows: Vec<Row>,
}

fn column(runs: &[Spent], value: impl Fn(&Spent) -> f64) -> Vec<f64> {
    runs.iter().map(value).collect()
}

impl Comparison {
    /// Statistics of runs, one a seed, beginning with those that went to the end of the budget. `settings`: first seed,
    /// number of seeds to count for the first hazard, budget, posture sweep.
    #[must_use]
    pub fn new(cell: &str, settings: (u64, usize, u32, bool), runs: &[(String, Vec<Spent>)], reference: &str) -> Self {
        let (first_seed, seeds, budget, posture_sweep) = settings;
        let actions = |runs: &[Spent]| column(runs, |r| r.actions as f64);
        let counted = |runs: &[Spent]| runs[..seeds.min(runs.len())].to_vec();
        let base = runs.iter().find(|(name, _)| name == reference).map(|(_, r)| actions(&counted(r)));
        let row = |(strategy, all): &(String, Vec<Spent>)| {
            let first = counted(all);
            let spent = actions(&first);
            let misses = first.iter().filter(|r| !r.hit).count();
            let Interval { low, high } = wilson(misses, first.len());
            let ratio =
                |base: &Vec<f64>| Estimate::new(mean(&spent) / mean(base), ratio_of_means_interval(&spent, base, 0));
            let hazards: Vec<f64> = all.iter().filter_map(|r| r.hazards).map(|n| n as f64).collect();
            Row {
                strategy: strategy.clone(),
                iterations: Estimate::of(&column(&first, |r| f64::from(r.iterations))),
                actions: Estimate::of(&spent),
                fmu_steps: Estimate::of(&column(&first, |r| r.fmu_steps as f64)),
                misses,
                miss_interval: [low, high],
                action_ratio: base.as_ref().filter(|_| strategy != reference).map(ratio),
                hazards: (!hazards.is_empty()).then(|| Estimate::of(&hazards)),
                runs: all.clone(),
            }
        };
        let rows = runs.iter().map(row).collect();
        Self { cell: cell.to_owned(), first_seed, seeds, budget, posture_sweep, reference: reference.to_owned(), rows }
    }

    /// Rows as comma-separated values; [`CSV_HEADER`] names the columns.
    #[must_use]
    pub fn csv(&self) -> String {
        let mut out = String::new();
        for r in &self.rows {
            let _ = write!(out, "{},{},{},{}", self.cell, r.strategy, self.seeds, self.budget);
            let mut estimate = |e: Option<&Estimate>| {
                let _ = match e {
                    Some(e) => write!(out, ",{},{},{}", e.mean, e.low, e.high),
                    None => write!(out, ",,,"),
                };
            };
            [&r.iterations, &r.actions, &r.fmu_steps].into_iter().for_each(|e| estimate(Some(e)));
            let _ = write!(out, ",{}", r.misses);
            let mut estimate = |e: Option<&Estimate>| {
                let _ = match e {
                    Some(e) => write!(out, ",{},{},{}", e.mean, e.low, e.high),
                    None => write!(out, ",,,"),
                };
            };
            estimate(r.action_ratio.as_ref());
            estimate(r.hazards.as_ref());
            out.push('\n');
        }
        out
    }
}

/// A table of several cells, for a terminal or as Markdown.
#[must_use]
pub fn table(comparisons: &[Comparison], markdown: bool) -> String {
    let reference = comparisons.first().map_or("", |c| c.reference.as_str());
    let ratio = format!("actions over {reference}");
    let interval = "95 % interval";
    let header = [
        "scenario",
        "strategy",
        "iterations",
        interval,
        "actions",
        interval,
        "FMU steps",
        interval,
        "misses",
        &ratio,
        "hazards",
        interval,
    ];
    let mut rows: Vec<Vec<String>> = Vec::new();
    for c in comparisons {
        for (i, r) in c.rows.iter().enumerate() {
            let mut row = vec![if i == 0 { c.cell.clone() } else { String::new() }, r.strategy.clone()];
            row.extend(r.iterations.show(1));
            row.extend(r.actions.show(0));
            row.extend(r.fmu_steps.show(0));
            row.push(format!("{} of {}", r.misses, c.seeds));
            row.push(r.action_ratio.map_or_else(String::new, |e| e.show(2).join(" ")));
            row.extend(r.hazards.map_or_else(Default::default, |e| e.show(1)));
            rows.push(row);
        }
    }
    super::columns(&header, &rows, markdown)
}

#[cfg(test)]
mod tests {
    use super::*;

    const fn spent(hit: bool, iterations: u32, actions: u64, hazards: Option<usize>) -> Spent {
        Spent { hit, iterations, actions, fmu_steps: 2 * actions, hazards }
    }

    #[test]
    fn means_misses_and_ratios_by_hand() {
        let quick = vec![spent(true, 2, 10, Some(4)), spent(true, 4, 30, None)];
        let slow = vec![spent(true, 8, 60, Some(1)), spent(false, 20, 100, None)];
        let runs = [("quick".to_owned(), quick), ("slow".to_owned(), slow)];
        let c = Comparison::new("cell", (1, 2, 20, false), &runs, "slow");
        let close = |a: f64, b: f64| (a - b).abs() < 1e-12;
        assert!(close(c.rows[0].iterations.mean, 3.0) && close(c.rows[0].fmu_steps.mean, 40.0));
        assert!(close(c.rows[1].actions.mean, 80.0) && c.rows[1].misses == 1);
        assert!(c.rows[0].action_ratio.is_some_and(|r| close(r.mean, 0.25) && r.low < 0.25 && r.high > 0.25));
        assert!(c.rows[1].action_ratio.is_none());
        assert!(c.rows[0].hazards.is_some_and(|h| close(h.mean, 4.0)));
        let columns = CSV_HEADER.split(',').count();
        assert!(c.csv().lines().all(|line| line.split(',').count() == columns), "{}", c.csv());
        assert_eq!(table(&[c], true).lines().count(), 4);
    }
}
