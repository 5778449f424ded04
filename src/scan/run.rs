//! One search, its findings grouped and confirmed, as a [`ScanReport`].

use std::ops::ControlFlow;
use std::sync::Arc;

use thiserror::Error;

use super::exhaustive::{Census, Exhaustive, census};
use super::minimise::minimise;
use super::prepare::{Prepared, StateChoice};
use super::residual::Watch;
use crate::hazard::{Finding, Groups};
use crate::host::{Effort, Hosted, PlantError};
use crate::human::action::ACTION_S;
use crate::report::model::{
    Certificate, FaultRecord, Hazard, Residual, SCHEMA_VERSION, STANDARD_EDITION, ScanReport, Settings, Spent, Verdict,
};
use crate::report::speeds::Speeds;
use crate::search::mcts_dpw::Parameters;
use crate::search::residual::Figures;
use crate::search::{Hybrid, MctsDpw, Plan, Profile, Random, Rng, Strategy};
use crate::sim::journal::Journal;
use crate::sim::motion::Motion;
use crate::sim::replay::replay;
use crate::sim::simulation::Snapshot;
use crate::sim::{Coverage, Simulation};
use crate::standards::provenance::tables;

/// Strategies by name.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum StrategyName {
    /// Monte Carlo tree search with double progressive widening, the paper's method made to work.
    MctsDpw,
    /// The same with the parameters of the cited algorithm (adaptive stress testing).
    MctsDpwLee,
    /// The paper to the letter.
    MctsDpwLiteral,
    /// Uniform random sequences, the paper's baseline.
    Random,
    /// Sequences imagined from the robot motion seen so far, then verified.
    Plan,
    /// Plan, and every fifth sequence random.
    #[default]
    Hybrid,
}

/// How sequences are chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// One after the other, by a strategy, within a budget of iterations.
    Strategy(StrategyName),
    /// All of them, equal states once.
    Exhaustive(Exhaustive),
    /// First a strategy, so that something is there soon; then all of them, as far as the budget goes.
    Auto(StrategyName, Exhaustive),
}

impl StrategyName {
    /// A fresh strategy.
    #[must_use]
    pub fn build(self) -> Box<dyn Strategy<Simulation<Hosted>>> {
        let mcts = |profile| Box::new(MctsDpw::<Snapshot>::new(profile));
        match self {
            Self::MctsDpw => mcts(Profile::Paper),
            Self::MctsDpwLee => mcts(Profile::Lee),
            Self::MctsDpwLiteral => mcts(Profile::PaperLiteral),
            Self::Random => Box::new(Random),
            Self::Plan => Box::new(Plan::<Snapshot>::default()),
            Self::Hybrid => Box::new(Hybrid::<Snapshot>::default()),
        }
    }
}

impl StrategyName {
    /// A fresh strategy; a tree search with these parameters instead of its profile's.
    #[must_use]
    pub fn build_with(self, parameters: Parameters) -> Box<dyn Strategy<Simulation<Hosted>>> {
        let mcts = |profile| Box::new(MctsDpw::<Snapshot>::with_parameters(profile, parameters));
        match self {
            Self::MctsDpw => mcts(Profile::Paper),
            Self::MctsDpwLee => mcts(Profile::Lee),
            Self::MctsDpwLiteral => mcts(Profile::PaperLiteral),
            other => other.build(),
        }
    }
}

/// How to search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ScanOptions {
    /// How sequences are chosen.
    pub method: Method,
    /// Seed.
    pub seed: u64,
    /// Budget.
    pub iterations: u32,
    /// Stop at the first hazard.
    pub stop_at_first: bool,
    /// Check all six postures per walk.
    pub posture_sweep: bool,
    /// How states are brought back.
    pub state: StateChoice,
}

/// What is told while a scan runs.
pub enum Progress<'a> {
    /// An iteration has ended: how many so far, and how many hazards.
    Iteration {
        /// Iterations so far.
        done: u32,
        /// Hazards so far.
        hazards: usize,
    },
    /// States of one level of an exhaustive search.
    Level {
        /// Actions before these states.
        depth: usize,
        /// States looked at.
        done: usize,
        /// States of the level.
        of: usize,
        /// Hazards so far.
        hazards: usize,
    },
    /// Nothing new.
    Working,
    /// A hazard that was not met before; not confirmed yet.
    Found(&'a Hazard),
}

/// The scan could not go on.
#[derive(Debug, Error, miette::Diagnostic)]
#[error("the FMU failed: {cause}")]
#[diagnostic(help("run `fmi-hazard selftest` on the FMU; its maker can reproduce the failure from what it prints"))]
pub struct ScanError {
    /// What the FMU did.
    pub cause: PlantError,
}

/// A finished scan.
pub struct Scanned {
    /// Its result: the same wherever the FMU runs and however its states are brought back.
    pub report: ScanReport,
    /// What the FMU did for it.
    pub effort: Effort,
    /// Questions of the exhaustive search whose answers were in its journal.
    pub remembered: u64,
}

/// Searches, groups, confirms.
///
/// `tell` hears about the progress and may end the scan early; what was found until then is still confirmed.
///
/// # Errors
/// Only when the FMU cannot be started at all; a failure later ends the search with what was found until then.
pub fn scan(
    prepared: &Prepared,
    options: ScanOptions,
    tell: &mut dyn FnMut(Progress<'_>) -> ControlFlow<()>,
) -> Result<Scanned, ScanError> {
    scan_with(prepared, options, Journal::default(), tell)
}

/// The same, going on from what `journal` holds of an exhaustive search and adding to it.
///
/// # Errors
/// As [`scan`].
pub fn scan_with(
    prepared: &Prepared,
    options: ScanOptions,
    journal: Journal,
    tell: &mut dyn FnMut(Progress<'_>) -> ControlFlow<()>,
) -> Result<Scanned, ScanError> {
    let links: Vec<String> = prepared.cell.links.iter().map(|l| l.name.clone()).collect();
    let sensors: Vec<String> = prepared.cell.sensors.iter().map(|s| s.name.clone()).collect();
    let mut groups = Groups::default();
    let searched = match options.method {
        Method::Strategy(name) => search(prepared, name, options, &links, &mut groups, tell)?,
        Method::Exhaustive(how) => {
            Searched::all(census(prepared, options.state, how, journal, &links, &mut groups, tell)?)
        }
        Method::Auto(name, how) => {
            let quick = search(prepared, name, options, &links, &mut groups, tell)?;
            if quick.interrupted || quick.broken.is_some() || (options.stop_at_first && !groups.is_empty()) {
                Searched { name: AUTO, ..quick }
            } else {
                let mut all = Groups::default();
                let searched = Searched::all(census(prepared, options.state, how, journal, &links, &mut all, tell)?);
                let only_quick = groups.added_to(&mut all);
                groups = all;
                searched.after(quick, &only_quick)
            }
        }
    };
    let Searched {
        name,
        iterations,
        interrupted,
        broken,
        mut certificate,
        figures,
        coverage,
        motion,
        mut faults,
        fmu_steps,
        fmu_states,
        effort,
        remembered,
        notes,
    } = searched;
    let mut warnings = prepared.warnings();
    warnings.extend(notes);
    // One process for all; each replay has a fresh instance in it.
    let mut plant = prepared.plant(StateChoice::Replay);
    let hazards: Vec<Hazard> = groups
        .ranked()
        .into_iter()
        .map(|group| {
            let mut hazard = Hazard::new(group, &links, &sensors);
            hazard.confirmed = Some(confirm(prepared, &mut plant, &group.worst));
            hazard.shortest.confirmed = Some(confirm(prepared, &mut plant, &group.shortest));
            hazard
        })
        .collect();
    let vacuous = coverage.vacuous(motion.moved);
    let speeds = Speeds::new(&prepared.cell, &prepared.binding, &motion);
    warnings.extend(speeds.sentences());
    if let (Some(certificate), Some(reason)) = (&mut certificate, speeds.refusal()) {
        certificate.refuse(reason);
    }
    if let Some(error) = &broken {
        faults.push(FaultRecord { message: format!("the search ended here: {error}"), actions: Vec::new() });
    }
    if coverage.arm_checks_incomplete > 0 {
        warnings.push(format!(
            "{} arm checks stopped at their work limit: an arm contact may be missed",
            coverage.arm_checks_incomplete
        ));
    }
    let verdict = if !hazards.is_empty() {
        Verdict::HazardsFound
    } else if broken.is_some() || coverage.episodes_not_evaluated > 0 {
        Verdict::FmuFailed
    } else if interrupted {
        Verdict::Interrupted
    } else if vacuous.is_some() || speeds.refusal().is_some() {
        Verdict::Inconclusive
    } else {
        Verdict::NoneFound
    };
    if let (Some(reason), true) = (vacuous, hazards.is_empty()) {
        warnings.push(format!("{reason}: this result says nothing about the cell"));
    }
    // Where every sequence was looked at, the truth is known.
    let figures = figures.filter(|_| !certificate.as_ref().is_some_and(|c| c.complete));
    let spent = Spent {
        iterations,
        actions: coverage.actions,
        fmu_steps,
        fmu_states,
        contact_checks: coverage.contact_checks,
        arm_checks: coverage.arm_checks,
    };
    let report = ScanReport {
        schema_version: SCHEMA_VERSION,
        tool: format!("fmi-hazard {}", env!("CARGO_PKG_VERSION")),
        verdict,
        subject: prepared.subject.clone(),
        settings: settings(prepared, options, name),
        residual: figures.map(|f| Residual::new(&f, !hazards.is_empty())),
        hazards,
        certificate,
        coverage,
        spent,
        speeds: speeds.records,
        faults,
        self_test: prepared.self_test.clone(),
        standard_edition: STANDARD_EDITION,
        tables: tables().collect(),
        warnings,
    };
    Ok(Scanned { report, effort, remembered })
}

/// Name of [`Method::Auto`].
const AUTO: &str = "auto";

/// What a search gives besides its groups.
struct Searched {
    name: &'static str,
    iterations: u64,
    interrupted: bool,
    broken: Option<PlantError>,
    certificate: Option<Certificate>,
    /// From random sequences, if the number of iterations was the one fixed beforehand.
    figures: Option<Figures>,
    coverage: Coverage,
    motion: Motion,
    faults: Vec<FaultRecord>,
    fmu_steps: u64,
    fmu_states: usize,
    effort: Effort,
    remembered: u64,
    notes: Vec<String>,
}

impl Searched {
    /// The second part of a search whose first part was `quick`, which alone met the hazards `only_quick`.
    fn after(self, quick: Self, only_quick: &[String]) -> Self {
        let mut coverage = quick.coverage;
        coverage.merge(&self.coverage);
        let mut motion = quick.motion;
        motion.merge(&self.motion);
        let mut notes = self.notes;
        if self.certificate.as_ref().is_some_and(|c| c.complete) && !only_quick.is_empty() {
            notes.push(format!(
                "the quick search met hazards that the complete one did not ({}): this is an error of this tool, please \
                 report it with the cell",
                only_quick.join(", ")
            ));
        }
        let mut faults = quick.faults;
        faults.extend(self.faults);
        Self {
            name: AUTO,
            iterations: quick.iterations,
            figures: quick.figures,
            coverage,
            motion,
            faults,
            fmu_steps: quick.fmu_steps + self.fmu_steps,
            fmu_states: quick.fmu_states.max(self.fmu_states),
            effort: quick.effort.and(self.effort),
            notes,
            ..self
        }
    }

    fn all(census: Census) -> Self {
        let Census {
            certificate,
            coverage,
            motion,
            fmu_steps,
            fmu_states,
            effort,
            remembered,
            faults,
            interrupted,
            broken,
        } = census;
        Self {
            name: "exhaustive",
            iterations: 0,
            interrupted,
            broken,
            certificate,
            figures: None,
            coverage,
            motion,
            faults,
            fmu_steps,
            fmu_states,
            effort,
            remembered,
            notes: Vec::new(),
        }
    }
}

/// Sequence after sequence; then the shortest one of each hazard is looked for.
fn search(
    prepared: &Prepared,
    strategy: StrategyName,
    options: ScanOptions,
    links: &[String],
    groups: &mut Groups,
    tell: &mut dyn FnMut(Progress<'_>) -> ControlFlow<()>,
) -> Result<Searched, ScanError> {
    let sensors: Vec<String> = prepared.cell.sensors.iter().map(|s| s.name.clone()).collect();
    let mut simulation =
        prepared.simulation(options.state, options.posture_sweep).map_err(|cause| ScanError { cause })?;
    let mut strategy = strategy.build();
    let mut rng = Rng::new(options.seed);
    let mut watch = Watch::new(options.iterations);
    let (mut done, mut interrupted, mut broken) = (0, false, None);
    while done < options.iterations {
        let outcome = strategy.iterate(&mut simulation, &mut rng);
        done += 1;
        let findings = simulation.take_findings();
        if let Ok(iteration) = &outcome {
            watch.after(iteration, &findings, groups, links);
        }
        for finding in findings {
            let Some(id) = groups.add(finding, u64::from(done), links) else { continue };
            if let Some(group) = groups.get(&id) {
                interrupted |= tell(Progress::Found(&Hazard::new(group, links, &sensors))).is_break();
            }
        }
        if let Err(error) = outcome {
            broken = Some(error);
            break;
        }
        interrupted |= tell(Progress::Iteration { done, hazards: groups.len() }).is_break();
        if interrupted || (options.stop_at_first && !groups.is_empty()) {
            break;
        }
    }
    // A search that ended because of what it met would give figures about itself.
    let stopped = interrupted || broken.is_some() || (options.stop_at_first && !groups.is_empty());
    let (coverage, motion) = (simulation.coverage().clone(), simulation.motion().clone());
    let faults = simulation.faults().iter();
    let faults = faults.map(|f| FaultRecord { message: f.message.clone(), actions: f.actions.clone() }).collect();
    let (fmu_steps, fmu_states) = (simulation.recall().steps(), simulation.recall().states());
    if broken.is_none() && !interrupted {
        for (identity, group) in groups.iter_mut() {
            // A failure here costs no finding: the sequence stays as it was found.
            if let Ok(shorter) = minimise(&mut simulation, &group.shortest, identity, links) {
                group.shortest = shorter;
            }
        }
    }
    Ok(Searched {
        name: strategy.name(),
        iterations: u64::from(done),
        interrupted,
        broken,
        certificate: None,
        figures: watch.figures().filter(|_| !stopped),
        coverage,
        motion,
        faults,
        fmu_steps,
        fmu_states,
        effort: simulation.recall().effort_of_workers(),
        remembered: 0,
        notes: Vec::new(),
    })
}

/// Whether a fresh instance without any restore gives the same contact to the last bit.
fn confirm(prepared: &Prepared, plant: &mut Hosted, finding: &Finding) -> bool {
    let again = replay(Arc::clone(&prepared.cell), Arc::clone(&prepared.binding), plant, &finding.actions);
    again.is_ok_and(|again| again.as_ref() == Some(finding))
}

fn settings(prepared: &Prepared, options: ScanOptions, strategy: &str) -> Settings {
    let exhaustive = matches!(options.method, Method::Exhaustive(_));
    Settings {
        strategy: strategy.to_owned(),
        seed: options.seed,
        iterations: if exhaustive { 0 } else { options.iterations },
        stop_at_first: options.stop_at_first && !exhaustive,
        posture_sweep: options.posture_sweep || exhaustive,
        actions_per_sequence: prepared.cell.search.actions,
        action_s: ACTION_S,
        contact_check_interval_s: prepared.cell.step_s,
        reach_tolerance_m: prepared.cell.search.reach_tolerance_m,
        speed_criterion: "absolute speed of the robot point (conservative, as in the paper)",
    }
}
