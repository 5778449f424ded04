//! From a path to a cell that can be simulated: open, bind, load, self-test.

use std::path::Path;
use std::sync::Arc;

use thiserror::Error;

use crate::cell::binding::BoundUnit;
use crate::cell::find::{OpenError, OpenedCell, open};
use crate::cell::{Binding, CellError, Workcell, binding};
use crate::fmi::{Fmu, Slave};
use crate::host::selftest::{Agreement, SelfTest, Stage, selftest};
use crate::host::system::AlgebraicLoop;
use crate::host::{PlantError, Policy, System, SystemSetup};
use crate::report::model::{FmuSubject, Subject};
use crate::sim::{Options, Simulation, World};

/// Memory for saved FMU states, bytes.
const STATE_BUDGET: usize = 512 * 1024 * 1024;

/// How FMU states are to be brought back.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum StateChoice {
    /// What the self-test recommends.
    #[default]
    Auto,
    /// Saved FMU states.
    Fmu,
    /// A fresh instance and all inputs again, for every sequence.
    Replay,
}

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
    /// The FMUs cannot be stepped one after the other.
    #[error(transparent)]
    #[diagnostic(help("give one of its connections delay_steps = 1: its value then counts from the next step on"))]
    Coupling(#[from] AlgebraicLoop),
    /// The FMU could not be loaded.
    #[error(transparent)]
    Load(#[from] crate::fmi::Error),
    /// The FMU failed when it was first run.
    #[error("the FMU failed in its first run: {0}")]
    #[diagnostic(help("no search is possible. `fmi-hazard selftest` shows what the FMU can do without a cell"))]
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
        "a search runs it many times. FMUs that allow one instance in a process need a process for each run, which this \
         version does not do yet"
    ))]
    RunsOnce(String),
    /// The person starts inside something.
    #[error("the person's start ({x:.2}, {y:.2}) m is inside an obstacle or touches one")]
    #[diagnostic(help("move human.start in the cell file; the body needs 0.14 m of room around it"))]
    StartBlocked {
        /// Start, m.
        x: f64,
        /// Start, m.
        y: f64,
    },
}

impl PrepareError {
    /// Whether the FMU failed while running, as opposed to a file that is wrong.
    #[must_use]
    pub fn while_running(&self) -> bool {
        match self {
            Self::FirstRun(_) | Self::NotDeterministic(_) | Self::RunsOnce(_) => true,
            Self::Load(e) => e.while_running(),
            _ => false,
        }
    }
}

/// A cell that can be simulated, any number of times.
pub struct Prepared {
    /// The cell.
    pub cell: Arc<Workcell>,
    /// Its variables.
    pub binding: Arc<Binding>,
    /// The FMUs' files.
    pub fmus: Vec<Fmu>,
    /// What was scanned.
    pub subject: Subject,
    /// What the FMUs' promises are worth, together.
    pub self_test: SelfTest,
    slaves: Vec<Slave>,
    setup: SystemSetup,
}

/// Opens, binds, loads and self-tests what `path` names: a cell file, or an FMU with its cell (`cell` if it is elsewhere).
///
/// # Errors
/// [`PrepareError`].
pub fn prepare(path: &Path, cell: Option<&Path>) -> Result<Prepared, PrepareError> {
    let OpenedCell { cell, source, fmus, found } = open(path, cell)?;
    let file_name = |fmu: &Fmu| fmu.path().file_name().map_or_else(String::new, |n| n.to_string_lossy().into_owned());
    let bound = |(name, fmu): &(String, Fmu)| (name.clone(), file_name(fmu));
    let names: Vec<(String, String)> = fmus.iter().map(bound).collect();
    let units: Vec<BoundUnit<'_>> = fmus
        .iter()
        .zip(&names)
        .map(|((_, fmu), (name, file))| BoundUnit { name, description: fmu.description(), file: file.clone() })
        .collect();
    let binding = binding::bind(&cell, &source, &units)?;
    let unit_names: Vec<&str> = names.iter().map(|(name, _)| name.as_str()).collect();
    let (cell, binding) = (Arc::new(cell), Arc::new(binding));
    let world = World::new(Arc::clone(&cell), Arc::clone(&binding));
    let setup = binding.setup(&unit_names, world.initial_inputs(), cell.step_s);
    let order = setup.order()?;
    let slaves = fmus.iter().map(|(_, fmu)| fmu.load()).collect::<Result<Vec<_>, _>>()?;
    let couplings = System::new(&slaves, setup.clone())?.couplings();
    let episode = cell.steps_per_action * usize::try_from(cell.search.actions).unwrap_or(8);
    // Serialised states are not needed here, and bringing one back in another instance crashes some FMUs.
    let self_test =
        selftest(&slaves, &setup, episode, &[Stage::Serialize], &mut |_| {}).map_err(PrepareError::FirstRun)?;
    if let Agreement::Failed { reason } = &self_test.deterministic {
        return Err(PrepareError::RunsOnce(reason.clone()));
    }
    if !self_test.repeatable() {
        return Err(PrepareError::NotDeterministic(self_test.deterministic.to_string()));
    }
    let subject_of = |unit: usize| {
        let (name, fmu) = &fmus[unit];
        let description = fmu.description();
        FmuSubject {
            unit: name.clone(),
            sha256: fmu.sha256().to_owned(),
            fmi_version: description.fmi_version.clone(),
            model_name: description.model_name.clone(),
            generation_tool: description.generation_tool.clone().unwrap_or_default(),
        }
    };
    let subjects = order.into_iter().map(subject_of).collect();
    let subject = Subject {
        cell: cell.name.clone(),
        cell_found: found,
        cell_sha256: cell.sha256.clone(),
        path: path.display().to_string(),
        fmus: subjects,
        couplings,
    };
    let fmus = fmus.into_iter().map(|(_, fmu)| fmu).collect();
    if !world.start_is_free() {
        let start = world.position(&world.start());
        return Err(PrepareError::StartBlocked { x: start.x, y: start.y });
    }
    Ok(Prepared { cell, binding, fmus, subject, self_test, slaves, setup })
}

impl Prepared {
    /// The FMUs with new instances, not yet started.
    ///
    /// # Panics
    /// Never: preparing has shown that the connections form no loop.
    #[must_use]
    #[expect(clippy::expect_used, reason = "the same setup was built when preparing")]
    pub fn plant(&self) -> System {
        System::new(&self.slaves, self.setup.clone()).expect("the connections form no loop")
    }

    /// How states are brought back for a choice.
    #[must_use]
    pub fn policy(&self, choice: StateChoice) -> Policy {
        match choice {
            StateChoice::Auto => self.self_test.policy(STATE_BUDGET),
            StateChoice::Fmu => Policy::States { max_checkpoints: usize::MAX },
            StateChoice::Replay => Policy::Replay,
        }
    }

    /// A simulation of its own, with FMU instances of its own.
    ///
    /// # Errors
    /// When an FMU cannot be started.
    pub fn simulation(&self, state: StateChoice, posture_sweep: bool) -> Result<Simulation<System>, PlantError> {
        let options = Options { policy: self.policy(state), posture_sweep };
        Simulation::new(Arc::clone(&self.cell), Arc::clone(&self.binding), self.plant(), options)
    }
}
