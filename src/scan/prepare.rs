//! From a path to a cell that can be simulated: open, bind, load, self-test.

use super::accepted_for::fmu_digest;
use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

use super::contact_stop::{self, travel_after_contact};
use super::hosting::{Hosting, Source, StateChoice};
use super::loaded::{Tested, try_out, unbound};
use super::prepare_error::PrepareError;
use super::stop_time;
use crate::cell::binding::BoundUnit;
use crate::cell::error::Source as CellSource;
use crate::cell::file::accepted::accepted_for;
use crate::cell::file::layers::as_one;
use crate::cell::file::validate::validate;
use crate::cell::find::{OpenedCell, open};
use crate::cell::foreign::ssp::Wiring;
use crate::cell::workcell::FileLine;
use crate::cell::{Binding, Workcell, binding};
use crate::fmi::{Fmu, number};
use crate::host::isolation::{Isolated, LastLines, WorkerRestore};
use crate::host::selftest::{Agreement, SelfTest, StateRestore};
use crate::host::{Hosted, PlantError, Policy, System, SystemSetup, UnitPort};
use crate::obligations::{Point, Reply};
use crate::record::model::{FileSubject, FmuSubject, NumberedInitialCondition, Subject};
use crate::sim::{Options, Simulation, World};
use crate::stop::Stop;

/// Memory for saved FMU states, bytes.
const STATE_BUDGET: usize = 512 * 1024 * 1024;

/// An action that takes longer than this is worth a copy of the process: copying and coming back cost about as much as
/// four of them, the mean of what a replay of eight repeats.
const COPY_PAYS: Duration = Duration::from_micros(150);

/// Most processes that are kept as states.
const MOST_COPIES: usize = 1000;

/// A cell that can be simulated, any number of times.
pub struct Prepared {
    /// The cell.
    pub cell: Arc<Workcell>,
    /// The cell file, with what it extends as one text.
    pub text: String,
    /// Its variables.
    pub binding: Arc<Binding>,
    /// The FMUs' files.
    pub fmus: Arc<[Fmu]>,
    /// Their names, which stand in front of variables; empty for the only one.
    pub names: Vec<String>,
    /// What was scanned.
    pub subject: Subject,
    /// What the FMUs' promises are worth, together.
    pub self_test: SelfTest,
    /// How states are brought back unless asked otherwise.
    pub rung: StateRestore,
    /// What of the protection against the FMUs this machine lacks.
    pub missing_protection: Vec<String>,
    source: Source,
    /// The cell file and where it is.
    pub(super) found: CellSource,
    /// How the FMUs are connected, when they come as a system.
    wiring: Option<Wiring>,
    /// What came out when its sensors were tried.
    suspicions: Vec<String>,
    /// An output that the cell does not bind and that the FMU does not repeat.
    unsteady: Option<String>,
}

/// Opens, binds, loads (into this process) and self-tests what `path` names: a cell file, or an FMU with its cell (`cell` if it is elsewhere).
///
/// # Errors
/// [`PrepareError`].
pub fn prepare(path: &Path, cell: Option<&Path>) -> Result<Prepared, PrepareError> {
    prepare_in(path, cell, &Hosting::InProcess(Stop::default()))
}

/// The same with a choice of where the FMUs run.
///
/// # Errors
/// [`PrepareError`].
pub fn prepare_in(path: &Path, cell: Option<&Path>, hosting: &Hosting) -> Result<Prepared, PrepareError> {
    let (prepared, free_start) = prepare_unplaced(path, cell, hosting)?;
    free_start?;
    prepared.knowing_contact_stop()
}

/// The same for runs from elsewhere than where the cell file says, [`Prepared::prepared_at`]: whether somebody can begin there is told
/// beside it.
///
/// # Errors
/// [`PrepareError`].
pub(crate) fn prepare_unplaced(
    path: &Path,
    cell: Option<&Path>,
    hosting: &Hosting,
) -> Result<(Prepared, Result<(), PrepareError>), PrepareError> {
    let cell_file = cell.map(|cell| cell.display().to_string());
    let OpenedCell { cell, source: cell_source, fmus, wiring, found } = open(path, cell)?;
    let text = as_one(&cell_source);
    let (names, fmus): (Vec<String>, Vec<Fmu>) = fmus.into_iter().unzip();
    let Fitted { cell, binding, setup, free_start } = fit(cell, &cell_source, &names, &fmus, wiring.as_ref())?;
    let order = setup.order()?;
    let couplings = setup.couplings();
    let episode = cell.steps_per_action * usize::try_from(cell.search.actions).unwrap_or(8);
    let tried = |watched: Vec<UnitPort>| {
        let watching = SystemSetup { watched, ..setup.clone() };
        let tried = try_out(&fmus, hosting, &watching, episode)?;
        Ok::<_, PrepareError>((tried, watching.column_names()))
    };
    let watched = unbound(&fmus, &setup);
    let all = watched.is_empty();
    // Some FMUs do not survive it when outputs are read that nobody has ever read.
    let first = tried(watched).or_else(|error| if all { Err(error) } else { tried(Vec::new()) })?;
    let unrepeated = |test: &SelfTest| test.unrepeated().map(ToString::to_string);
    let (tested, unsteady) = match unrepeated(&first.0.self_test) {
        Some(_) if first.1.len() > setup.outputs.len() => {
            // Perhaps those that are bound repeat themselves.
            let output = match first.0.self_test.unrepeated() {
                Some(Agreement::Differs { output: Some(output), .. }) => output.clone(),
                _ => "unknown".to_owned(),
            };
            (tried(Vec::new())?.0, Some(output))
        }
        _ => (first.0, None),
    };
    let Tested { self_test, missing_protection, step_time, source } = tested;
    let source = source.with_setup(setup);
    let action = step_time * u32::try_from(cell.steps_per_action).unwrap_or(1);
    let rung = self_test.rung(action > COPY_PAYS);
    match self_test.unrepeated() {
        None => {}
        Some(Agreement::Failed { reason, printed }) => {
            let error = PlantError { printed: printed.clone(), ..PlantError::of(reason.as_str()) };
            return Err(PrepareError::RunsOnce(error.to_string()));
        }
        Some(differs) => return Err(PrepareError::NotDeterministic(differs.to_string())),
    }
    let subject_of = |unit: usize| {
        let fmu = &fmus[unit];
        let description = fmu.description();
        FmuSubject {
            unit: names[unit].clone(),
            sha256: fmu.sha256().to_owned(),
            fmi_version: description.fmi_version.clone(),
            model_name: description.model_name.clone(),
            generation_tool: description.generation_tool.clone().unwrap_or_default(),
        }
    };
    let subjects = order.into_iter().map(subject_of).collect();
    let subject = Subject {
        cell: cell.name.clone(),
        beginning: numbered_initial_condition(&cell),
        cell_found: found,
        cell_sha256: cell.sha256.clone(),
        files: files(&cell, wiring.as_ref()),
        path: path.display().to_string(),
        cell_file,
        fmus: subjects,
        couplings,
    };
    accepted_for(cell.file(), &cell_source, &fmu_digest(&subject))?;
    let prepared = Prepared {
        cell,
        text,
        binding,
        fmus: fmus.into(),
        names,
        subject,
        self_test,
        rung,
        missing_protection,
        source,
        found: cell_source,
        wiring,
        suspicions: Vec::new(),
        unsteady,
    };
    Ok((prepared, free_start))
}

/// The files that the cell's robots come from, and the system that its FMUs come in.
fn files(cell: &Workcell, wiring: Option<&Wiring>) -> Vec<FileSubject> {
    let told = |path: &Path, sha256: &str| FileSubject { path: path.display().to_string(), sha256: sha256.to_owned() };
    let system = wiring.map(|w| told(w.path.file_name().unwrap_or_default().as_ref(), &w.sha256));
    system.into_iter().chain(cell.files.iter().map(|file| told(&file.path, &file.sha256))).collect()
}

/// Which of its beginnings a cell is about, if it has several or another than the FMU's own start.
fn numbered_initial_condition(cell: &Workcell) -> Option<NumberedInitialCondition> {
    let told = cell.beginnings.len() > 1 || cell.lead_in_steps() > 0;
    told.then(|| initial_condition_record(cell, cell.beginning))
}

/// One of a cell's beginnings, from 0, as results tell it.
pub(super) fn initial_condition_record(cell: &Workcell, number: usize) -> NumberedInitialCondition {
    let beginning = &cell.beginnings[number];
    NumberedInitialCondition {
        number: number + 1,
        of: cell.beginnings.len(),
        xy_m: beginning.start.xy_m(),
        heading_deg: beginning.start.heading_deg(),
        begins_s: beginning.begins_s(cell.step_s),
    }
}

/// A cell that fits its FMUs.
struct Fitted {
    cell: Arc<Workcell>,
    binding: Arc<Binding>,
    setup: SystemSetup,
    /// Whether the person has room at the start.
    free_start: Result<(), PrepareError>,
}

/// Binds the cell's variables.
fn fit(
    cell: Workcell,
    source: &CellSource,
    names: &[String],
    fmus: &[Fmu],
    wiring: Option<&Wiring>,
) -> Result<Fitted, PrepareError> {
    let units = BoundUnit::all(names.iter().zip(fmus));
    let binding = binding::bind(cell.file(), source, &units, wiring)?;
    let (cell, binding) = (Arc::new(cell), Arc::new(binding));
    let world = World::new(Arc::clone(&cell), Arc::clone(&binding));
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let setup = binding.setup(&names, world.initial_inputs(), cell.step_s);
    let setup = SystemSetup { lead_in_steps: cell.lead_in_steps(), ..setup };
    let start = world.first.position(&world.first.start());
    let second = world.second.as_ref().filter(|second| !second.start_is_free());
    let at_times = world.seen_at_start_at_times();
    let free_start = if let Some(sensor) = at_times.first() {
        let message = format!("somebody begins where `{sensor}` sees them, which counts only while the FMU says so");
        let help = "begin where it sees nobody: whether it counts as the FMU begins is not known".to_owned();
        let error = source.error(source.table("human"), "here", message, Some(help));
        Err(PrepareError::DetectedAtTimes { sensor: (*sensor).to_owned(), error })
    } else if let Some(second) = second {
        let start = second.position(&second.start());
        let message = format!(
            "the second person's start ({:.2}, {:.2}) m is inside an obstacle or touches one",
            start.x, start.y
        );
        let span = cell.file().human.second.as_ref().map_or_else(|| source.table("human"), |table| table.start.span());
        let help = "move it; the body needs 0.14 m of room around it".to_owned();
        Err(PrepareError::NoRoom(source.error(span, "here", message, Some(help))))
    } else if world.first.start_is_free() {
        Ok(())
    } else {
        let message =
            format!("the person's start ({:.2}, {:.2}) m is inside an obstacle or touches one", start.x, start.y);
        let human = &cell.file().human.first;
        let starts: Vec<_> = human.start.iter().chain(&human.other_starts).collect();
        let number = cell.beginning % cell.starts.len();
        let which = if number == 0 { "human.start" } else { "this one of human.other_starts" };
        let help = format!("move {which}; the body needs 0.14 m of room around it");
        let span = starts.get(number).map_or_else(|| source.table("human"), |start| start.span());
        Err(PrepareError::NoRoom(source.error(span, "here", message, Some(help))))
    };
    Ok(Fitted { cell, binding, setup, free_start })
}

impl Prepared {
    /// The same FMUs in another cell, `text`. What the self-test found is taken over.
    ///
    /// # Errors
    /// When the text is no cell of these FMUs, or the person has no room at the start.
    pub fn changed(&self, text: &str) -> Result<Self, PrepareError> {
        let found = self.found.with_text(text);
        let cell = validate(&found)?;
        self.with(found, cell, text.to_owned(), self.cell.beginning)
    }

    /// The same cell with another of its beginnings, from 0.
    ///
    /// # Errors
    /// When there is none of that number, or the person has no room there.
    pub fn beginning(&self, number: usize) -> Result<Self, PrepareError> {
        let cell = Workcell::clone(&self.cell);
        let mut other = self.with(self.found.clone(), cell, self.text.clone(), number)?;
        other.suspicions.clone_from(&self.suspicions);
        Ok(other)
    }

    pub(super) fn with(
        &self,
        found: CellSource,
        cell: Workcell,
        text: String,
        beginning: usize,
    ) -> Result<Self, PrepareError> {
        let count = cell.beginnings.len();
        if beginning >= count {
            return Err(PrepareError::NoInitialCondition { number: beginning + 1, count });
        }
        let cell = cell.initial_condition_at(beginning);
        let Fitted { cell, binding, setup, free_start } =
            fit(cell, &found, &self.names, &self.fmus, self.wiring.as_ref())?;
        accepted_for(cell.file(), &found, &fmu_digest(&self.subject))?;
        free_start?;
        let source = self.source.with_setup(setup);
        Self {
            subject: Subject {
                cell: cell.name.clone(),
                beginning: numbered_initial_condition(&cell),
                cell_sha256: cell.sha256.clone(),
                files: files(&cell, self.wiring.as_ref()),
                ..self.subject.clone()
            },
            cell,
            text,
            binding,
            fmus: Arc::clone(&self.fmus),
            names: self.names.clone(),
            self_test: self.self_test.clone(),
            rung: self.rung,
            missing_protection: self.missing_protection.clone(),
            source,
            found,
            wiring: self.wiring.clone(),
            suspicions: Vec::new(),
            unsteady: self.unsteady.clone(),
        }
        .knowing_contact_stop()
    }

    /// The same with how far links go on after a contact, where that is to be found out.
    fn knowing_contact_stop(mut self) -> Result<Self, PrepareError> {
        let Some(signal) = self.cell.clamping.signal.clone() else { return Ok(self) };
        let until_s = stop_time::run_s(&self.cell, &self.fmus, contact_stop::RUN_S);
        let plant = |idle: &[f64]| self.plant_from(StateChoice::Replay, idle);
        let travel = travel_after_contact((&self.cell, &self.binding), &signal, until_s, plant);
        let travel = travel.map_err(PrepareError::FirstRun)?;
        match travel {
            Some(travel_m) => {
                let mut cell = Workcell::clone(&self.cell);
                cell.travel_after_contact_m = travel_m;
                self.cell = Arc::new(cell);
            }
            None => self.suspicions.push(format!(
                "the contact signal `{signal}` does not stop the robots: after it was set they still moved for 5 s. Gaps are looked at \
                 as they are at each instant"
            )),
        }
        Ok(self)
    }

    /// What the user should know of the cell file.
    #[must_use]
    pub fn warnings(&self) -> Vec<String> {
        let system = self.wiring.iter().flat_map(|wiring| &wiring.structure.warnings);
        let cell = self.cell.warnings.iter().chain(&self.binding.warnings).chain(&self.self_test.remarks);
        system.chain(cell).chain(&self.suspicions).cloned().chain(stop_time::beyond(&self.cell, &self.fmus)).collect()
    }

    /// Why nothing can be certified of these FMUs, whatever a search finds: what the self-test calls impossible for their
    /// outputs together is possible for those that the cell binds.
    #[must_use]
    pub(crate) fn unsteady(&self) -> Option<String> {
        let output = self.unsteady.as_ref()?;
        Some(format!(
            "the FMU does not repeat its output `{output}`, which the cell does not bind: something in it depends on a clock, \
             a random generator or the like, and where else that shows is not known, so nothing is certified. Ask its maker \
             for a deterministic export, or for one without this output"
        ))
    }

    /// Whether the motion is the FMUs' own in steps of other lengths, and with Event Mode and without: what both engines reply.
    #[must_use]
    pub(crate) fn steps(&self) -> Reply {
        let SelfTest { half_steps, .. } = &self.self_test;
        let against = self.self_test.against_motion().into_iter().map(Point::open).collect();
        let shown = self.self_test.motion_shown();
        let step = number(self.cell.step_s * 1000.0);
        let figure = match shown.is_empty() {
            // The question is about these steps.
            true => format!("in communication steps of {step} ms; in half of them: {half_steps}"),
            false => shown.join("; "),
        };
        Reply::unless(against, figure)
    }

    /// The files that the cell file extends, as messages call them, the next first.
    pub(crate) fn extends(&self) -> impl Iterator<Item = &str> {
        self.found.bases().iter().map(|base| base.name.as_str())
    }

    /// A line of the cell file, or of one that it extends, as messages show it.
    #[must_use]
    pub(crate) fn shown(&self, place: &FileLine) -> String {
        let base = self.found.bases().iter().find(|base| Some(&base.path) == place.base.as_ref());
        let file = base.map_or(self.subject.cell_found.as_str(), |base| base.name.as_str());
        format!("{file}:{}", place.line)
    }

    /// When everything with its FMUs has to end.
    #[must_use]
    pub fn stop(&self) -> Stop {
        match &self.source {
            Source::Here { stop, .. } => stop.clone(),
            Source::Apart(launcher) => launcher.stop().clone(),
        }
    }

    /// Adds to what the user should know.
    pub(crate) fn warn(&mut self, warnings: Vec<String>) {
        self.suspicions.extend(warnings);
    }

    /// The FMUs, not yet started, for states that are brought back as chosen.
    ///
    /// # Panics
    /// Never: preparing has shown that the connections form no loop.
    #[must_use]
    pub fn plant(&self, choice: StateChoice) -> Hosted {
        self.plant_of(choice, SystemSetup::clone)
    }

    #[expect(clippy::expect_used, reason = "the order was worked out when preparing")]
    pub(super) fn plant_of(&self, choice: StateChoice, setup_of: impl Fn(&SystemSetup) -> SystemSetup) -> Hosted {
        match &self.source {
            Source::Here { slaves, setup, stop } => {
                let system = System::new(slaves, setup_of(setup)).expect("the connections form no loop");
                Hosted::Here(system.heeding(stop))
            }
            Source::Apart(launcher) => {
                let launcher = launcher.clone().with_setup(setup_of(launcher.setup()));
                Hosted::Apart(Isolated::new(launcher, self.keeping(choice)))
            }
        }
    }

    /// The same, initialised with these `inputs` instead of those that follow from the person's start.
    #[must_use]
    pub fn plant_from(&self, choice: StateChoice, inputs: &[f64]) -> Hosted {
        let with = |setup: &SystemSetup| SystemSetup { initial_inputs: inputs.to_vec(), ..setup.clone() };
        self.plant_of(choice, with)
    }

    /// The same, from the FMU's own start on: without the steps that lead in.
    #[must_use]
    pub(crate) fn plant_without_lead_in(&self, choice: StateChoice) -> Hosted {
        self.plant_of(choice, |setup| SystemSetup { lead_in_steps: 0, ..setup.clone() })
    }

    fn keeping(&self, choice: StateChoice) -> WorkerRestore {
        match choice {
            StateChoice::Auto => match self.rung {
                StateRestore::SavedStates => WorkerRestore::ByFmu,
                StateRestore::Copies => WorkerRestore::ByFork,
                StateRestore::Instances => WorkerRestore::Instances,
                StateRestore::Processes => WorkerRestore::Processes,
            },
            StateChoice::Fmu => WorkerRestore::ByFmu,
            StateChoice::Fork => WorkerRestore::ByFork,
            // Who allows one instance in a process gets a process for each.
            StateChoice::Replay if self.self_test.deterministic == Agreement::Exact => WorkerRestore::Instances,
            StateChoice::Replay | StateChoice::Process => WorkerRestore::Processes,
        }
    }

    /// The FMUs, not yet started, for states that are brought back by this rung.
    #[must_use]
    pub(super) fn plant_by(&self, rung: StateRestore) -> Hosted {
        match (&self.source, rung) {
            (Source::Apart(launcher), StateRestore::Copies) => {
                Hosted::Apart(Isolated::new(launcher.clone(), WorkerRestore::ByFork))
            }
            (Source::Apart(launcher), StateRestore::Processes) => {
                Hosted::Apart(Isolated::new(launcher.clone(), WorkerRestore::Processes))
            }
            (_, StateRestore::SavedStates) => self.plant(StateChoice::Fmu),
            (Source::Apart(launcher), StateRestore::Instances) => {
                Hosted::Apart(Isolated::new(launcher.clone(), WorkerRestore::Instances))
            }
            (Source::Here { .. }, _) => self.plant(StateChoice::Replay),
        }
    }

    /// How states are brought back by this rung.
    pub(super) fn policy_by(&self, rung: StateRestore) -> Policy {
        let max_checkpoints = match rung {
            StateRestore::SavedStates => self.self_test.most_states(STATE_BUDGET),
            StateRestore::Copies => MOST_COPIES,
            StateRestore::Instances | StateRestore::Processes => 0,
        };
        Policy::States { max_checkpoints }
    }

    /// Whether runs can have a process of their own.
    pub(super) const fn has_processes(&self) -> bool {
        matches!(self.source, Source::Apart(_))
    }

    /// How states are brought back for a choice.
    #[must_use]
    pub fn policy(&self, choice: StateChoice) -> Policy {
        let max_checkpoints = match (choice, self.rung) {
            (StateChoice::Replay, _) => return Policy::Replay,
            (StateChoice::Fmu, _) => usize::MAX,
            (StateChoice::Fork, _) | (StateChoice::Auto, StateRestore::Copies) => MOST_COPIES,
            (StateChoice::Auto, StateRestore::SavedStates) => self.self_test.most_states(STATE_BUDGET),
            (StateChoice::Process, _) | (StateChoice::Auto, StateRestore::Instances | StateRestore::Processes) => 0,
        };
        Policy::States { max_checkpoints }
    }

    /// Whether equal serialised states are equal states: only for FMUs that save them faithfully.
    #[must_use]
    pub(crate) fn compares_states_by_bytes(&self) -> bool {
        // What is differentiated depends on the step before, too.
        let remembers = self.binding.derived.is_empty();
        remembers && self.self_test.restore == Agreement::Exact && self.self_test.bytes_per_state.is_some()
    }

    /// What the FMUs printed so far, and how many bytes it was; nothing is caught of those in this process.
    #[must_use]
    pub(crate) fn printed(&self) -> (String, u64) {
        match &self.source {
            Source::Here { .. } => (String::new(), 0),
            Source::Apart(launcher) => launcher.printed(),
        }
    }

    /// What the FMUs printed before the first few failures; nothing of those in this process.
    #[must_use]
    pub(crate) fn before_failures(&self) -> Vec<LastLines> {
        match &self.source {
            Source::Here { .. } => Vec::new(),
            Source::Apart(launcher) => launcher.before_failures(),
        }
    }

    /// A simulation of its own, with FMU instances of its own.
    ///
    /// # Errors
    /// When an FMU cannot be started.
    pub fn simulation(&self, state: StateChoice, posture_sweep: bool) -> Result<Simulation<Hosted>, PlantError> {
        let options = Options { policy: self.policy(state), posture_sweep };
        Simulation::new(Arc::clone(&self.cell), Arc::clone(&self.binding), self.plant(state), options)
    }
}
