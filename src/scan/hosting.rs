//! Where FMUs run, and how their states are brought back.

use std::path::PathBuf;

use crate::fmi::Slave;
use crate::host::SystemSetup;
use crate::host::isolation::{Guard, Launcher, Limits};
use crate::stop::Stop;

/// How FMU states are to be brought back.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum StateChoice {
    /// What the self-test recommends.
    #[default]
    Auto,
    /// Saved FMU states.
    Fmu,
    /// A copy of the FMU's process for every state.
    Fork,
    /// A fresh instance and all inputs again, for every sequence.
    Replay,
    /// A fresh process and all inputs again.
    Process,
}

/// Where FMUs run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Hosting {
    /// In this process: a crash of theirs is one of ours. Their steps end when this says so.
    InProcess(Stop),
    /// In worker processes.
    Workers {
        /// The program that serves as a worker, see [`Launcher::new`].
        program: PathBuf,
        /// How the FMUs are guarded.
        guard: Guard,
        /// How much they may take.
        limits: Limits,
    },
}

/// What plants are made of.
pub(super) enum Source {
    Here { slaves: Vec<Slave>, setup: SystemSetup, stop: Stop },
    Apart(Launcher),
}

impl Source {
    /// The same FMUs with another setup.
    pub(super) fn with_setup(&self, setup: SystemSetup) -> Self {
        match self {
            Self::Here { slaves, stop, .. } => Self::Here { slaves: slaves.clone(), setup, stop: stop.clone() },
            Self::Apart(launcher) => Self::Apart(launcher.clone().with_setup(setup)),
        }
    }
}
