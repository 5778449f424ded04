//! One search, its findings grouped and confirmed, as a [`ScanReport`].

use std::ops::ControlFlow;

use thiserror::Error;

use super::attempts::{Attempt, attempts};
use super::exhaustive::{Census, Exhaustive};
use super::footing::{Doubt, not_repeatable};
use super::prepare::{Prepared, StateChoice};
use crate::host::selftest::Rung;
use crate::host::{Effort, Hosted, PlantError};
use crate::human::action::ACTION_S;
use crate::report::model::{
    Certificate, FaultRecord, Hazard, Residual, SCHEMA_VERSION, STANDARD_EDITION, ScanReport, Settings, Spent, Verdict,
};
use crate::report::speeds::Speeds;
use crate::search::mcts_dpw::Parameters;
use crate::search::residual::Figures;
use crate::search::{Hybrid, MctsDpw, Plan, Profile, Random, Strategy};
use crate::sim::journal::Journal;
use crate::sim::motion::Motion;
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
    /// All of them, as far as the budget goes, and beside it a strategy for a small part of the cost; where the budget ends
    /// before all of them were looked at, the strategy's own budget is used up.
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
        /// What the search cost so far, in communication steps, about.
        cost: u64,
    },
    /// Shorter sequences are looked for.
    Shortening {
        /// Hazards for which that is done.
        done: usize,
        /// Of so many.
        of: usize,
    },
    /// Hazards are confirmed by runs from the start.
    Confirming {
        /// Hazards so far.
        done: usize,
        /// Of so many.
        of: usize,
    },
    /// What the FMU did is run again from the start.
    RunAgain {
        /// Runs so far.
        done: usize,
        /// Of so many.
        of: usize,
    },
    /// Nothing found so far counts: everything is searched again on another footing.
    SearchAgain {
        /// Why, and how.
        because: &'a str,
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
    /// How states were brought back in the end.
    pub rung: Rung,
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
    let Attempt { footing, searched, hazards, notes, effort, doubt } =
        attempts(prepared, options, journal, &links, tell)?;
    let Searched {
        name,
        iterations,
        interrupted,
        quick_cut,
        broken,
        mut certificate,
        figures,
        coverage,
        motion,
        mut faults,
        fmu_steps,
        fmu_states,
        remembered,
        notes: found,
        ..
    } = searched;
    let mut warnings = prepared.warnings();
    warnings.extend(notes.into_iter().chain(found));
    let unsteady = prepared.unsteady();
    let doubted = doubt.as_ref().map(|doubt| match interrupted {
        true => format!("{}: it was stopped before that was looked into", doubt.words()),
        false => not_repeatable(doubt),
    });
    let against: Vec<String> = doubted.into_iter().chain(unsteady.clone()).collect();
    if let Some(certificate) = certificate.as_mut().filter(|_| !against.is_empty()) {
        against.iter().cloned().for_each(|reason| certificate.refuse(reason));
    } else {
        warnings.extend(against);
    }
    let speeds = Speeds::new(&prepared.cell, &prepared.binding, &motion);
    warnings.extend(speeds.sentences());
    if let (Some(certificate), Some(reason)) = (&mut certificate, speeds.refusal()) {
        certificate.refuse(reason);
    }
    // Not somebody, but its time.
    let timed_out = interrupted && prepared.stop().ends_search() && !prepared.stop().is_asked();
    if timed_out {
        warnings.push(
            "its time ended the search; on another machine it may end elsewhere. Give it more with --time".to_owned(),
        );
    }
    let vacuous = coverage.vacuous(motion.moved);
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
    } else if broken.is_some() || (doubt.is_some() && !interrupted) || coverage.not_evaluated() {
        Verdict::FmuFailed
    } else if interrupted && !timed_out {
        Verdict::Interrupted
    } else if (timed_out && quick_cut) || vacuous.is_some() || unsteady.is_some() || speeds.refusal().is_some() {
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
    Ok(Scanned { report, rung: footing.rung(prepared), effort, remembered })
}

/// Name of [`Method::Auto`].
pub(super) const AUTO: &str = "auto";

/// What a search gives besides its groups.
pub(super) struct Searched {
    pub name: &'static str,
    pub iterations: u64,
    pub interrupted: bool,
    /// The quick part did not try all its sequences, because it was told to stop.
    pub quick_cut: bool,
    pub broken: Option<PlantError>,
    pub certificate: Option<Certificate>,
    /// From random sequences, if the number of iterations was the one fixed beforehand.
    pub figures: Option<Figures>,
    pub coverage: Coverage,
    pub motion: Motion,
    pub faults: Vec<FaultRecord>,
    pub fmu_steps: u64,
    pub fmu_states: usize,
    pub effort: Effort,
    pub remembered: u64,
    /// Why it is not to be relied on.
    pub doubt: Option<Doubt>,
    pub notes: Vec<String>,
}

impl Searched {
    /// Stopped before anything was looked at.
    pub(super) fn nothing(method: Method, sensors: usize) -> Self {
        let name = match method {
            Method::Strategy(name) => name.build().name(),
            Method::Exhaustive(_) => "exhaustive",
            Method::Auto(..) => AUTO,
        };
        Self {
            name,
            iterations: 0,
            interrupted: true,
            quick_cut: true,
            broken: None,
            certificate: None,
            figures: None,
            coverage: Coverage::new(sensors),
            motion: Motion::default(),
            faults: Vec::new(),
            fmu_steps: 0,
            fmu_states: 0,
            effort: Effort::default(),
            remembered: 0,
            doubt: None,
            notes: Vec::new(),
        }
    }

    /// Whether sequence after sequence is worth trying beside a complete search that came to this.
    pub(super) fn needs_quick(&self) -> bool {
        let complete = self.certificate.as_ref().is_some_and(|c| c.complete);
        !complete && !self.interrupted && self.broken.is_none() && self.doubt.is_none()
    }

    /// The second part of a search whose first part was `quick`, which alone met the hazards `only_quick`.
    pub(super) fn after(self, quick: Self, only_quick: &[String]) -> Self {
        let mut coverage = quick.coverage;
        coverage.merge(&self.coverage);
        let mut motion = quick.motion;
        motion.merge(&self.motion);
        let mut certificate = self.certificate;
        if let Some(certificate) = certificate.as_mut().filter(|c| c.complete && !only_quick.is_empty()) {
            certificate.refuse(format!(
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
            certificate,
            interrupted: self.interrupted || quick.interrupted,
            quick_cut: quick.quick_cut,
            broken: self.broken.or(quick.broken),
            ..self
        }
    }

    pub(super) fn all(census: Census) -> (Self, Journal) {
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
            doubt,
            journal,
        } = census;
        let searched = Self {
            name: "exhaustive",
            iterations: 0,
            interrupted,
            quick_cut: false,
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
            doubt,
            notes: Vec::new(),
        };
        (searched, journal)
    }
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
