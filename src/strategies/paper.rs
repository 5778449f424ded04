//! The results table of the paper as data (Huck, Ledermann, Kroeger, ICRA 2021, Table I): 10 seeds, 320 iterations.
//!
//! `T` is the mean number of iterations to the first hazard. What a miss counts is not said there; counted as the whole
//! budget, the figures have the spread that random search must give.

use serde::Serialize;

/// Mean iterations to the first hazard, standard deviation, misses of ten.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct PaperRow {
    /// Mean.
    pub t: f64,
    /// Standard deviation.
    pub sigma: f64,
    /// Seeds of ten that found nothing.
    pub misses: u32,
}

/// One line of the table.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct PaperScenario {
    /// Name of our cell for it.
    pub cell: &'static str,
    /// Tree search.
    pub mcts: PaperRow,
    /// Random search.
    pub random: PaperRow,
    /// Share of random sequences that are hazardous, as the figures for random search suggest.
    pub random_rate: f64,
}

const fn row(t: f64, sigma: f64, misses: u32) -> PaperRow {
    PaperRow { t, sigma, misses }
}

/// The table.
pub const TABLE: [PaperScenario; 6] = [
    PaperScenario { cell: "safety-fence", mcts: row(16.3, 12.8, 0), random: row(37.4, 52.8, 0), random_rate: 0.0267 },
    PaperScenario { cell: "sensor-mat", mcts: row(131.6, 76.6, 1), random: row(203.4, 133.4, 4), random_rate: 0.00295 },
    PaperScenario {
        cell: "head-collision",
        mcts: row(83.1, 45.8, 0),
        random: row(115.8, 113.0, 1),
        random_rate: 0.0078,
    },
    PaperScenario { cell: "light-curtain", mcts: row(14.9, 13.4, 0), random: row(28.5, 23.4, 0), random_rate: 0.0351 },
    PaperScenario { cell: "two-scanners", mcts: row(69.4, 66.8, 0), random: row(174.3, 137.7, 2), random_rate: 0.0046 },
    PaperScenario {
        cell: "heavy-workpiece",
        mcts: row(24.6, 25.6, 0),
        random: row(71.1, 57.9, 0),
        random_rate: 0.0141,
    },
];

/// The line of a cell.
#[must_use]
pub(crate) fn of(cell: &str) -> Option<&'static PaperScenario> {
    TABLE.iter().find(|scenario| scenario.cell == cell)
}
