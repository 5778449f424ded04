//! One search, its findings grouped and confirmed, as a [`ScanReport`].

use std::ops::ControlFlow;
use std::sync::Arc;

use super::causes::causes;
use super::fallback::{FallbackResult, search_with_fallback};
use super::from_start::FromStart;
use super::options::{Method, Progress, ScanError, ScanOptions};
use super::prepare::Prepared;
use super::searched::Searched;
use super::settings::of_cell;
use super::share::share;
use crate::cell::Workcell;
use crate::host::FmuUsage;
use crate::host::selftest::StateRestore;
use crate::obligations::verdict::SearchEnd;
use crate::obligations::{Obligations, Verdict};
use crate::record::headline::{self};
use crate::record::model::{FaultRecord, Headline, SCHEMA_VERSION, STANDARD_EDITION, ScanReport, Settings, Spent};
use crate::scan::speeds::Speeds;
use crate::sim::answers::Answers;
use crate::standards::provenance::Table;
use crate::standards::tables;

/// A finished scan.
pub struct Scanned {
    /// Its result: the same wherever the FMU runs and however its states are brought back.
    pub report: ScanReport,
    /// How states were brought back in the end.
    pub rung: StateRestore,
    /// What the FMU did for it.
    pub effort: FmuUsage,
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
    scan_with(prepared, options, &Arc::default(), tell)
}

/// The same, with the answers of an exhaustive search that are known from before, and those that it adds.
///
/// # Errors
/// As [`scan`].
pub fn scan_with(
    prepared: &Prepared,
    options: ScanOptions,
    answers: &Arc<Answers>,
    tell: &mut dyn FnMut(Progress<'_>) -> ControlFlow<()>,
) -> Result<Scanned, ScanError> {
    let mut scanned = scan_alone(prepared, options, answers, tell)?;
    scanned.report.cycle = share(prepared, tell);
    // How much of the cycle that is stands in it.
    scanned.report.headline = headline::from_start(&scanned.report);
    Ok(scanned)
}

/// The same, without asking how much of the robots' cycle was met.
pub(super) fn scan_alone(
    prepared: &Prepared,
    options: ScanOptions,
    answers: &Arc<Answers>,
    tell: &mut dyn FnMut(Progress<'_>) -> ControlFlow<()>,
) -> Result<Scanned, ScanError> {
    let links: Vec<String> = prepared.cell.links.iter().map(|l| l.name.clone()).collect();
    let FallbackResult { footing, mut searched, hazards, notes, effort, doubt } =
        search_with_fallback(prepared, options, answers, &links, tell)?;
    let mut warnings = prepared.warnings();
    warnings.extend(notes);
    warnings.extend(searched.notes.iter().cloned());
    let speeds = Speeds::new(&prepared.cell, &prepared.binding, &searched.motion);
    warnings.extend(speeds.sentences());
    warnings.extend(numbers_are_about(&prepared.cell));
    // Not somebody, but its time.
    let timed_out = searched.interrupted && prepared.stop().ends_search() && !prepared.stop().is_asked();
    if timed_out {
        warnings.push(
            "its time ended the search; on another machine it may end elsewhere. Give it more with --time".to_owned(),
        );
    }
    // Also in runs in which a plane tells of an arm.
    let Searched { coverage, motion, .. } = &mut searched;
    coverage.robots.iter_mut().enumerate().for_each(|(number, robot)| robot.moved |= motion.moved.contains(&number));
    // An arm's run in which what follows the FMU does otherwise is not the FMU's failure.
    let not_evaluated = searched.coverage.not_evaluated();
    let strayed = not_evaluated && searched.faults.is_empty() && !prepared.cell.following.is_empty();
    let obligations = {
        let engine = FromStart::new(prepared, options, &searched, doubt.as_ref(), (&speeds, !hazards.is_empty()));
        Obligations::of(&if strayed { engine.having_strayed() } else { engine })
    };
    let ended = SearchEnd {
        found: !hazards.is_empty(),
        failed: searched.broken.is_some() || (doubt.is_some() && !searched.interrupted) || (not_evaluated && !strayed),
        interrupted: searched.interrupted && !timed_out,
    };
    let verdict = Verdict::of(ended, &obligations);
    // Where every sequence was looked at, the truth is known.
    let has_all = searched.has_all();
    let Searched { name, iterations, broken, mut certificate, figures, coverage, mut faults, .. } = searched;
    let Searched { fmu_steps, fmu_states, .. } = searched;
    if let Some(error) = &broken {
        faults.push(FaultRecord { message: format!("the search ended here: {}", error.message), actions: Vec::new() });
    }
    if let Some(certificate) = &mut certificate {
        certificate.close(&obligations);
    }
    let figures = figures.filter(|_| !has_all);
    let spent = Spent {
        iterations,
        actions: coverage.actions,
        fmu_steps,
        fmu_states,
        contact_checks: coverage.contact_checks,
        arm_checks: coverage.arm_checks,
    };
    let rung = footing.rung(prepared);
    let causes = causes(prepared, rung, &hazards, certificate.as_ref());
    let mut report = ScanReport {
        schema_version: SCHEMA_VERSION,
        tool: format!("fmi-hazard {}", env!("CARGO_PKG_VERSION")),
        verdict,
        headline: Headline::default(),
        subject: prepared.subject.clone(),
        settings: settings(prepared, options, name),
        residual: figures.map(|f| super::residual::record(&f, !hazards.is_empty())),
        causes,
        hazards,
        certificate,
        coverage,
        cycle: None,
        spent,
        speeds: speeds.records,
        faults,
        self_test: prepared.self_test.clone(),
        standard_edition: STANDARD_EDITION,
        tables: used(&prepared.cell),
        obligations,
        warnings,
    };
    report.headline = headline::from_start(&report);
    Ok(Scanned { report, rung, effort })
}

/// The tables behind what counts in a cell.
fn used(cell: &Workcell) -> Vec<Table> {
    let clamping = tables::of_clamping().filter(|_| cell.criteria.clamping);
    let pressure = tables::of_pressure().filter(|_| cell.criteria.pressure);
    tables::of_every_scan().chain(clamping).chain(pressure).collect()
}

/// What numbers of sequences leave out, where something counts that does not end them.
fn numbers_are_about(cell: &Workcell) -> Option<String> {
    let passing = cell.criteria.moving_contact_m_s.is_some() || cell.separation.is_some();
    passing.then(|| {
        "numbers and shares of sequences, and what bounds them, are about what ends a sequence; of moving contacts and separation the \
         worst of each action is told"
            .to_owned()
    })
}

fn settings(prepared: &Prepared, options: ScanOptions, strategy: &str) -> Settings {
    let exhaustive = matches!(options.method, Method::Exhaustive(_));
    Settings {
        strategy: strategy.to_owned(),
        seed: options.seed,
        iterations: if exhaustive { 0 } else { options.iterations },
        stop_at_first: options.stop_at_first && !exhaustive,
        posture_sweep: options.posture_sweep || exhaustive,
        begins: Some(prepared.begins()),
        seen_at_start: prepared.seen_at_start(),
        ..of_cell(&prepared.cell)
    }
}
