//! What is reported of strategies: each strategy's cost of the first hazard and the number of hazards it finds.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use serde::Serialize;

use crate::growth::{Growth, checkpoints};
use fmi_hazard::search::statistics::{Interval, mean, mean_interval, ratio_of_means_interval, wilson};

/// First columns of [`Comparison::csv`].
const CSV_HEADER: &str = "cell,strategy,seeds,budget,iterations,iterations_low,iterations_high,\
                              actions,actions_low,actions_high,fmu_steps,fmu_steps_low,fmu_steps_high,misses,\
                              action_ratio,action_ratio_low,action_ratio_high,hazards,hazards_low,hazards_high,\
                              all_found,all_of,all_iterations,all_actions,all_fmu_steps";

/// Columns of [`Comparison::csv`] for a budget; those about a complete list stay empty if there is none.
#[must_use]
pub(crate) fn csv_header(budget: u32) -> String {
    let mut header = CSV_HEADER.to_owned();
    for i in checkpoints(budget) {
        for what in ["hazards", "recall", "weighted_recall"] {
            let _ = write!(header, ",{what}_at_{i}");
        }
    }
    header + "\n"
}

/// What one run spent until its first hazard, or until its budget was used up.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Spent {
    /// Whether it found a hazard.
    pub hit: bool,
    /// Iterations.
    pub iterations: u32,
    /// Actions taken in the simulation; what is restored is not taken again.
    pub actions: u64,
    /// Steps of the FMU, each transition once.
    pub fmu_steps: u64,
    /// Different hazards on the way through the whole budget, if the run went on so long.
    pub growth: Option<Growth>,
}

/// What it took to find every hazard of the complete list: means over the seeds that did, which are the lucky ones if not
/// all did.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub(crate) struct AllFound {
    /// Seeds that found all.
    pub seeds: usize,
    /// Seeds that went to the end of the budget.
    pub of: usize,
    /// Mean iterations; none if no seed found all.
    pub iterations: Option<f64>,
    /// Mean simulated actions.
    pub actions: Option<f64>,
    /// Mean FMU steps.
    pub fmu_steps: Option<f64>,
}

impl AllFound {
    fn of(runs: &[&Growth]) -> Self {
        let costs: Vec<_> = runs.iter().filter_map(|growth| growth.all).collect();
        let column = |values: Vec<f64>| (!values.is_empty()).then(|| mean(&values));
        Self {
            seeds: costs.len(),
            of: runs.len(),
            iterations: column(costs.iter().map(|c| f64::from(c.iterations)).collect()),
            actions: column(costs.iter().map(|c| c.actions as f64).collect()),
            fmu_steps: column(costs.iter().map(|c| c.fmu_steps as f64).collect()),
        }
    }

    fn show(&self) -> String {
        match (self.iterations, self.actions, self.fmu_steps) {
            (Some(i), Some(a), Some(s)) => {
                format!("{} of {}: {i:.0} iterations, {a:.0} actions, {s:.0} FMU steps", self.seeds, self.of)
            }
            _ => "not reached".to_owned(),
        }
    }
}

/// A mean with its 95 % interval.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub(crate) struct Estimate {
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
pub(crate) struct Row {
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
    /// Different hazards at each checkpoint, over the same seeds.
    pub hazards_at: Vec<Estimate>,
    /// Part of the complete list that was found at each checkpoint; empty if that is not known.
    pub recall_at: Vec<Estimate>,
    /// The same by weight: part of all hazardous sequences that begin with a hazard found.
    pub weighted_recall_at: Vec<Estimate>,
    /// What it took to find all; none if the complete list is not known.
    pub all: Option<AllFound>,
    /// Each seed.
    pub runs: Vec<Spent>,
}

/// One cell.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Comparison {
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
    /// Iterations after which hazards are counted.
    pub checkpoints: Vec<u32>,
    /// Number of different hazards of the cell, from an exhaustive search; none if it was not asked for or did not get
    /// through.
    pub all_hazards: Option<usize>,
    /// What the user should know.
    pub notes: Vec<String>,
    /// Strategies.
    pub rows: Vec<Row>,
}

fn column(runs: &[Spent], value: impl Fn(&Spent) -> f64) -> Vec<f64> {
    runs.iter().map(value).collect()
}

impl Comparison {
    /// Statistics of runs, one a seed, beginning with those that went to the end of the budget. `settings`: first seed,
    /// number of seeds to count for the first hazard, budget, posture sweep. `all_hazards`: how many the cell has, where
    /// that is known.
    #[must_use]
    pub(crate) fn new(
        cell: &str,
        settings: (u64, usize, u32, bool),
        runs: &[(String, Vec<Spent>)],
        reference: &str,
        all_hazards: Option<usize>,
    ) -> Self {
        let (first_seed, seeds, budget, posture_sweep) = settings;
        let checkpoints = checkpoints(budget);
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
            let growths: Vec<&Growth> = all.iter().filter_map(|r| r.growth.as_ref()).collect();
            let at = |value: &dyn Fn(&Growth, usize) -> Option<f64>| -> Vec<Estimate> {
                let column = |i: usize| growths.iter().filter_map(|growth| value(growth, i)).collect::<Vec<f64>>();
                let columns = (0..checkpoints.len()).map(column);
                columns.filter(|values| !values.is_empty()).map(|values| Estimate::of(&values)).collect()
            };
            let hazards_at = at(&|growth, i| growth.groups.get(i).map(|&n| n as f64));
            Row {
                strategy: strategy.clone(),
                iterations: Estimate::of(&column(&first, |r| f64::from(r.iterations))),
                actions: Estimate::of(&spent),
                fmu_steps: Estimate::of(&column(&first, |r| r.fmu_steps as f64)),
                misses,
                miss_interval: [low, high],
                action_ratio: base.as_ref().filter(|_| strategy != reference).map(ratio),
                hazards: hazards_at.last().copied(),
                hazards_at,
                recall_at: at(&|growth, i| growth.recall.get(i).copied()),
                weighted_recall_at: at(&|growth, i| growth.weighted_recall.get(i).copied()),
                all: all_hazards.map(|_| AllFound::of(&growths)),
                runs: all.clone(),
            }
        };
        let rows = runs.iter().map(row).collect();
        Self {
            cell: cell.to_owned(),
            first_seed,
            seeds,
            budget,
            posture_sweep,
            reference: reference.to_owned(),
            notes: runs.iter().filter_map(unknown).collect(),
            checkpoints,
            all_hazards,
            rows,
        }
    }

    /// Rows as comma-separated values; [`csv_header`] names the columns.
    #[must_use]
    pub(crate) fn csv(&self) -> String {
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
            let mut number = |n: Option<f64>| {
                let _ = match n {
                    Some(n) => write!(out, ",{n}"),
                    None => write!(out, ","),
                };
            };
            let all = r.all.as_ref();
            number(all.map(|a| a.seeds as f64));
            number(all.map(|a| a.of as f64));
            let costs = [all.and_then(|a| a.iterations), all.and_then(|a| a.actions), all.and_then(|a| a.fmu_steps)];
            costs.into_iter().for_each(&mut number);
            for i in 0..self.checkpoints.len() {
                let estimates = [&r.hazards_at, &r.recall_at, &r.weighted_recall_at];
                estimates.into_iter().for_each(|at| number(at.get(i).map(|e| e.mean)));
            }
            out.push('\n');
        }
        out
    }
}

/// The hazards that a strategy met beyond a complete list: there can be none.
fn unknown((strategy, runs): &(String, Vec<Spent>)) -> Option<String> {
    let ids: BTreeSet<&str> =
        runs.iter().filter_map(|r| r.growth.as_ref()).flat_map(|g| &g.unknown).map(String::as_str).collect();
    let ids: Vec<&str> = ids.into_iter().collect();
    (!ids.is_empty()).then(|| {
        format!(
            "{strategy} met hazards that the complete search did not ({}): this is an error of this tool, please report it \
             with the cell",
            ids.join(", ")
        )
    })
}

/// How many different hazards were found after so many iterations, or which part of all, and that part by weight; for a
/// terminal or as Markdown. Nothing if no run went to the end of its budget.
#[must_use]
pub(crate) fn growth_table(comparisons: &[Comparison], markdown: bool) -> String {
    let Some(first) = comparisons.first().filter(|c| c.rows.iter().any(|r| !r.hazards_at.is_empty())) else {
        return String::new();
    };
    let known = comparisons.iter().any(|c| c.all_hazards.is_some());
    let at: Vec<String> = first.checkpoints.iter().map(|i| format!("at {i}")).collect();
    let mut header = vec!["scenario", "strategy"];
    header.extend(at.iter().map(String::as_str));
    if known {
        header.extend(["hazards of the cell", "all found"]);
    }
    let mut rows: Vec<Vec<String>> = Vec::new();
    for c in comparisons {
        for (i, r) in c.rows.iter().enumerate() {
            let mut row = vec![if i == 0 { c.cell.clone() } else { String::new() }, r.strategy.clone()];
            row.extend((0..first.checkpoints.len()).map(|i| {
                match (r.hazards_at.get(i), r.recall_at.get(i), r.weighted_recall_at.get(i)) {
                    (_, Some(recall), Some(weighted)) => format!("{:.3} ({:.3})", recall.mean, weighted.mean),
                    (Some(hazards), _, _) => format!("{:.1} found", hazards.mean),
                    _ => String::new(),
                }
            }));
            if known {
                row.push(c.all_hazards.map_or_else(|| "not known".to_owned(), |n| n.to_string()));
                row.push(r.all.map_or_else(String::new, |all| all.show()));
            }
            rows.push(row);
        }
    }
    fmi_hazard::report::columns(&header, &rows, markdown)
}

/// A table of several cells, for a terminal or as Markdown.
#[must_use]
pub(crate) fn table(comparisons: &[Comparison], markdown: bool) -> String {
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
    fmi_hazard::report::columns(&header, &rows, markdown)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spent(hit: bool, iterations: u32, actions: u64, hazards: Option<usize>) -> Spent {
        let growth = hazards.map(|n| Growth {
            groups: vec![n - 1, n],
            recall: vec![0.25, 0.5],
            weighted_recall: vec![0.5, 0.75],
            unknown: if n == 1 { vec!["H-000001".to_owned()] } else { Vec::new() },
            ..Growth::default()
        });
        Spent { hit, iterations, actions, fmu_steps: 2 * actions, growth }
    }

    #[test]
    fn means_misses_and_ratios_by_hand() {
        let quick = vec![spent(true, 2, 10, Some(4)), spent(true, 4, 30, None)];
        let slow = vec![spent(true, 8, 60, Some(1)), spent(false, 20, 100, None)];
        let runs = [("quick".to_owned(), quick), ("slow".to_owned(), slow)];
        let c = Comparison::new("cell", (1, 2, 20, false), &runs, "slow", Some(8));
        let close = |a: f64, b: f64| (a - b).abs() < 1e-12;
        assert!(close(c.rows[0].iterations.mean, 3.0) && close(c.rows[0].fmu_steps.mean, 40.0));
        assert!(close(c.rows[1].actions.mean, 80.0) && c.rows[1].misses == 1);
        assert!(c.rows[0].action_ratio.is_some_and(|r| close(r.mean, 0.25) && r.low < 0.25 && r.high > 0.25));
        assert!(c.rows[1].action_ratio.is_none());
        assert!(c.rows[0].hazards.is_some_and(|h| close(h.mean, 4.0)));
        assert!(c.rows[0].recall_at.iter().map(|e| e.mean).eq([0.25, 0.5]));
        assert!(
            c.notes.len() == 1 && c.notes[0].contains("slow met") && c.notes[0].contains("H-000001"),
            "{:?}",
            c.notes
        );
        let columns = csv_header(20).split(',').count();
        assert!(c.csv().lines().all(|line| line.split(',').count() == columns), "{}", c.csv());
        let growth = growth_table(std::slice::from_ref(&c), true);
        assert!(growth.contains("| 0.250 (0.500) | 0.500 (0.750) | 8 ") && growth.contains("not reached"), "{growth}");
        assert_eq!(table(&[c], true).lines().count(), 4);
    }
}
