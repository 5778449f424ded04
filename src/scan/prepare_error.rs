//! Why a cell cannot be simulated, and what to do about it.

use thiserror::Error;

use crate::cell::CellError;
use crate::cell::error::OpenError;
use crate::host::PlantError;
use crate::host::system::AlgebraicLoop;

/// Why a cell cannot be simulated.
#[derive(Debug, Error, miette::Diagnostic)]
#[non_exhaustive]
pub enum PrepareError {
    /// The files are wrong.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Open(#[from] OpenError),
    /// The cell and the FMU do not fit.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Bind(#[from] Box<CellError>),
    /// Somebody has no room at their start.
    #[error(transparent)]
    #[diagnostic(transparent)]
    NoRoom(Box<CellError>),
    /// Somebody begins in the zone of a sensor that does not always count.
    #[error("{error}")]
    #[diagnostic(forward(error))]
    DetectedAtTimes {
        /// The sensor.
        sensor: String,
        /// As messages show it.
        error: Box<CellError>,
    },
    /// The FMUs cannot be stepped one after the other.
    #[error(transparent)]
    #[diagnostic(help("give one of its connections delay_steps = 1: its value then counts from the next step on"))]
    Coupling(#[from] AlgebraicLoop),
    /// A beginning that the cell has not.
    #[error("the cell has no beginning {number}")]
    #[diagnostic(help(
        "it has {count}: each of human.start, human.other_starts and the places of human.start_area at each of human.begins_s"
    ))]
    NoInitialCondition {
        /// From 1.
        number: usize,
        /// How many there are.
        count: usize,
    },
    /// The FMU could not be loaded.
    #[error(transparent)]
    Load(#[from] crate::fmi::Error),
    /// The FMU could not be loaded into a worker.
    #[error("{0}")]
    NotLoaded(String),
    /// The FMU failed when it was first run.
    #[error("the FMU failed in its first run: {0}")]
    #[diagnostic(help(
        "no search is possible. `fmi-hazard inspect --self-test` shows what the FMU can do without a cell"
    ))]
    FirstRun(PlantError),
    /// The FMU does not repeat itself.
    #[error("two fresh instances of the FMU gave different outputs for the same inputs ({0})")]
    #[diagnostic(help(
        "its results depend on something outside its inputs (a clock, a random generator, another instance), so \
         findings could not be replayed. Ask its maker for a deterministic export"
    ))]
    NotDeterministic(String),
    /// The FMU runs once and not again.
    #[error("the FMU ran once and could not be run again: {0}")]
    #[diagnostic(help(
        "a search runs it many times. For FMUs that allow one instance in a process leave out --in-process: each run then \
         has a process of its own"
    ))]
    RunsOnce(String),
}

impl PrepareError {
    pub(super) fn first_run(error: PlantError) -> Self {
        if error.not_loaded { Self::NotLoaded(error.to_string()) } else { Self::FirstRun(error) }
    }

    /// Whether the FMU failed while running, as opposed to a file that is wrong.
    #[must_use]
    pub(crate) fn while_running(&self) -> bool {
        match self {
            Self::FirstRun(_) | Self::NotDeterministic(_) | Self::RunsOnce(_) => true,
            Self::Load(e) => e.while_running(),
            _ => false,
        }
    }
}
