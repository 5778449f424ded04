//! One search, its findings grouped and confirmed, as a [`ScanReport`].

use std::ops::ControlFlow;

use super::attempts::{Attempt, attempts};
use super::causes::causes;
use super::footing::not_repeatable;
use super::options::{Method, Progress, ScanError, ScanOptions};
use super::prepare::Prepared;
use super::searched::Searched;
use crate::cell::file::format::ControlledBy;
use crate::cell::{Control, Workcell};
use crate::geometry::segment_cuboid::segment_cuboid;
use crate::geometry::{Cuboid, Vec3};
use crate::hazard::criterion::separation::Stop;
use crate::host::Effort;
use crate::host::selftest::Rung;
use crate::human::action::ACTION_S;
use crate::human::arm::ArmModel;
use crate::human::{Arrangement, Presses};
use crate::report::criteria::{ClampingRecord, CriteriaRecord, SeparationTerms, StatedStop};
use crate::report::model::{
    FaultRecord, Residual, SCHEMA_VERSION, STANDARD_EDITION, ScanReport, Settings, Spent, Verdict,
};
use crate::report::people::SecondRecord;
use crate::report::speeds::Speeds;
use crate::sim::curtain::Curtain;
use crate::sim::journal::Journal;
use crate::standards::provenance::Table;
use crate::standards::tables;

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
    let unknown = unknown(prepared);
    if let Some(certificate) = &mut certificate {
        unknown.iter().cloned().for_each(|reason| certificate.refuse(reason));
        certificate.reasons.extend(rests_on(&prepared.cell));
    }
    warnings.extend(numbers_are_about(&prepared.cell));
    // Not somebody, but its time.
    let timed_out = interrupted && prepared.stop().ends_search() && !prepared.stop().is_asked();
    if timed_out {
        warnings.push(
            "its time ended the search; on another machine it may end elsewhere. Give it more with --time".to_owned(),
        );
    }
    let vacuous = coverage.vacuous(motion.moved);
    if let Some(error) = &broken {
        faults.push(FaultRecord { message: format!("the search ended here: {}", error.message), actions: Vec::new() });
    }
    if coverage.arm_checks_incomplete > 0 {
        warnings.push(format!(
            "{} arm checks stopped at their work limit: an arm contact may be missed",
            coverage.arm_checks_incomplete
        ));
    }
    // An arm's run in which what follows the FMU does otherwise is not the FMU's failure.
    let strayed = coverage.not_evaluated() && faults.is_empty() && !prepared.cell.following.is_empty();
    if strayed {
        warnings.push(
            "something that follows the FMU would do so otherwise in runs in which a plane tells of an arm: what the arm \
             meets there was not looked at"
                .to_owned(),
        );
    }
    let verdict = if !hazards.is_empty() {
        Verdict::HazardsFound
    } else if broken.is_some() || (doubt.is_some() && !interrupted) || (coverage.not_evaluated() && !strayed) {
        Verdict::FmuFailed
    } else if interrupted && !timed_out {
        Verdict::Interrupted
    } else if !unknown.is_empty()
        || (timed_out && quick_cut)
        || vacuous.is_some()
        || unsteady.is_some()
        || strayed
        || speeds.refusal().is_some()
    {
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
    let rung = footing.rung(prepared);
    let causes = causes(prepared, rung, &hazards, certificate.as_ref());
    let report = ScanReport {
        schema_version: SCHEMA_VERSION,
        tool: format!("fmi-hazard {}", env!("CARGO_PKG_VERSION")),
        verdict,
        subject: prepared.subject.clone(),
        settings: settings(prepared, options, name),
        residual: figures.map(|f| Residual::new(&f, !hazards.is_empty())),
        causes,
        hazards,
        certificate,
        coverage,
        spent,
        speeds: speeds.records,
        faults,
        self_test: prepared.self_test.clone(),
        standard_edition: STANDARD_EDITION,
        tables: used(&prepared.cell),
        unknown,
        warnings,
    };
    Ok(Scanned { report, rung, effort, remembered })
}

/// The tables behind what counts in a cell.
fn used(cell: &Workcell) -> Vec<Table> {
    let clamping = tables::of_clamping().filter(|_| cell.criteria.clamping);
    let pressure = tables::of_pressure().filter(|_| cell.criteria.pressure);
    tables::of_every_scan().chain(clamping).chain(pressure).collect()
}

/// What no search can know, and so passes nobody.
fn unknown(prepared: &Prepared) -> Vec<String> {
    let mut unknown = Vec::new();
    let links = prepared.cell.links_of_unknown_pressure();
    if !links.is_empty() {
        let (says, it) = if links.len() == 1 { ("does not say", "it") } else { ("do not say", "them") };
        unknown.push(format!(
            "pressure: {} {says} how small the surface is that touches (contact in the cell file), so no pressure by {it} is excluded",
            links.join(", ")
        ));
    }
    let below = planes_with_room_for_legs(&prepared.cell);
    if !below.is_empty() {
        unknown.push(format!(
            "who is low may have a hand below {} before the body is in it: hands are looked at as if they came through",
            below.join(", ")
        ));
    }
    let between = controls_between_planes(&prepared.cell);
    if !between.is_empty() {
        unknown.push(format!(
            "a hand may get to {} through more than one light curtain, door or line of buttons: one of these ways was looked at",
            between.join(", ")
        ));
    }
    unknown
}

/// Names of the planes below which people in low postures get with legs and hands, but not with the whole body.
fn planes_with_room_for_legs(cell: &Workcell) -> Vec<&str> {
    if cell.repertoire.low().is_empty() {
        return Vec::new();
    }
    let obstacles: Vec<Cuboid> = cell.standing(Presses::NONE, Arrangement::NONE);
    let curtains = Curtain::all(cell, Vec3::ZERO, &obstacles);
    let some = curtains.iter().filter(|c| !c.hands_only && !c.lets_below && c.closed.has_room_below());
    some.map(|curtain| cell.sensors[curtain.sensor].name.as_str()).collect()
}

/// Names of the controls that a hand may get to through more than one plane that tells of it.
fn controls_between_planes(cell: &Workcell) -> Vec<&str> {
    // Fingers work them, not what they hold.
    let reach = ArmModel::default().reach();
    let planes = || cell.sensors.iter().filter_map(|sensor| sensor.zone.plane());
    let several = |control: &&Control| {
        let Some(place) = control.place.filter(|_| control.by == ControlledBy::Person) else { return false };
        let near = |(plane, _): &(&Cuboid, _)| segment_cuboid(place.a, place.b, plane).distance <= reach + place.radius;
        planes().filter(near).count() > 1
    };
    cell.controls.iter().filter(several).map(|control| control.name.as_str()).collect()
}

/// What was tried out, and not shown, for a criterion.
fn rests_on(cell: &Workcell) -> Option<String> {
    let signal = cell.clamping.signal.as_ref()?;
    Some(format!(
        "how far links go on after a contact was tried out by `{signal}` at moments 0.1 s apart, with nobody there"
    ))
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

/// What counts as unsafe, where that is more or other than the transient force.
pub(super) fn criteria(cell: &Workcell) -> Option<CriteriaRecord> {
    (!cell.judges_by_force_alone()).then(|| CriteriaRecord {
        transient_force: cell.criteria.transient_force,
        clamping: cell.criteria.clamping.then(|| ClampingRecord {
            contact_signal: cell.clamping.signal.clone(),
            travel_after_contact_m: cell.travel_after_contact_m.iter().copied().fold(0.0, f64::max),
        }),
        pressure: cell.criteria.pressure,
        moving_contact_faster_than_m_s: cell.criteria.moving_contact_m_s,
        separation: cell.separation.as_ref().map(|separation| SeparationTerms {
            stop: match &separation.stop {
                Stop::Measured(name) => Some(name.clone()),
                Stop::Stated { .. } => None,
            },
            stated: match separation.stop {
                Stop::Measured(_) => None,
                Stop::Stated { reaction_s, stop_time_s, stop_distance_m } => {
                    Some(StatedStop { reaction_s, stop_time_s, stop_distance_m })
                }
            },
            intrusion_m: separation.intrusion_m,
            person_uncertainty_m: separation.person_uncertainty_m,
            robot_uncertainty_m: separation.robot_uncertainty_m,
            approach_m_s: separation.approach_m_s,
        }),
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
        actions_per_sequence: prepared.cell.search.actions,
        action_s: ACTION_S,
        contact_check_interval_s: prepared.cell.step_s,
        reach_tolerance_m: prepared.cell.search.reach_tolerance_m,
        speed_criterion: prepared.cell.search.criterion,
        criteria: criteria(&prepared.cell),
        arm_speed_m_s: prepared.cell.arm_speed_m_s,
        held_m: prepared.cell.holds_m(),
        also: prepared.cell.repertoire.abilities().to_vec(),
        run_m_s: prepared.cell.repertoire.run_m_s(),
        second: SecondRecord::of(&prepared.cell),
        controls: prepared.cell.controls.iter().map(Into::into).collect(),
        until_s: None,
        presses: None,
        begins: Some(prepared.begins()),
        seen_at_start: prepared.seen_at_start(),
        body: Some((&prepared.cell.body).into()),
        floor_m: None,
        start_region_m: None,
    }
}
