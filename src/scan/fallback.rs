//! A search, and the same again on the next rung when it is not to be relied on.

use std::ops::ControlFlow;
use std::sync::Arc;

use super::confirm::confirm;
use super::execution::{Doubt, DoubtOrigin, ExecutionMode};
use super::exhaustive::census;
use super::options::{Method, Progress, ScanError, ScanOptions};
use super::prepare::Prepared;
use super::quick::{Quick, search};
use super::searched::{AUTO, Searched};
use crate::hazard::{Group, Groups};
use crate::host::audit::repeated;
use crate::host::selftest::StateRestore;
use crate::host::{FmuUsage, Hosted, Plant as _, Unlike};
use crate::obligations::{Need, Point};
use crate::record::hazard::Hazard;
use crate::sequences::Merge;
use crate::sim::answers::Answers;

/// Sequences of the quick part of a scan before its complete part begins: so that something is there soon.
const FIRST: u32 = 5;

/// They may cost so much, in communication steps about. Where each takes long, the complete part begins without the rest of them.
const FIRST_COST: u64 = 200_000;

/// While the complete part goes on, the quick one may cost one of so many parts of what that did so far. It has one thread,
/// the other all: so it takes a larger part of the time.
const SHARE: u64 = 16;

/// The last of several attempts.
pub(super) struct FallbackResult {
    pub footing: ExecutionMode,
    pub searched: Searched,
    pub hazards: Vec<Hazard>,
    /// Why there were several.
    pub notes: Vec<String>,
    /// Of all.
    pub effort: FmuUsage,
    /// What is wrong with it, if there is no other rung.
    pub doubt: Option<Doubt>,
}

/// Searches; when what was found is not to be relied on, again on the next rung. What a plain run confirmed stays.
pub(super) fn search_with_fallback(
    prepared: &Prepared,
    options: ScanOptions,
    answers: &Arc<Answers>,
    links: &[String],
    tell: &mut dyn FnMut(Progress<'_>) -> ControlFlow<()>,
) -> Result<FallbackResult, ScanError> {
    let sensors: Vec<String> = prepared.cell.sensors.iter().map(|s| s.name.clone()).collect();
    let merge = match options.method {
        Method::Strategy(_) => Merge::History,
        Method::Exhaustive(how) | Method::Auto(_, how) => how.merge,
    };
    let mut footing = ExecutionMode::asked(prepared, options.state, merge);
    let (mut notes, mut kept, mut effort) = (Vec::new(), Groups::default(), FmuUsage::default());
    loop {
        // One process for all; each plain run has a fresh instance in it.
        let mut plain = footing.plain(prepared);
        let mut groups = Groups::default();
        let once = once(prepared, (footing, &mut plain), (options, answers), links, &mut groups, tell);
        let mut searched = match once {
            Err(error) if error.cause.stopped => Searched::nothing(options.method, sensors.len()),
            // What an earlier attempt confirmed is told all the same.
            Err(error) if !notes.is_empty() => {
                let broken = Some(error.cause);
                Searched { broken, interrupted: false, ..Searched::nothing(options.method, sensors.len()) }
            }
            searched => searched?,
        };
        effort = effort.and(searched.effort);
        let only_kept = if searched.has_all() { Vec::new() } else { kept.clone().added_to(&mut groups) };
        let stop = plain.stop();
        stop.finishing();
        let ranked = groups.ranked();
        let of = ranked.len();
        // Why a hazard could not be run once more, if not because there was no time.
        let mut not_run = None;
        let confirmed = |(done, group): (usize, &Group)| {
            searched.interrupted |= tell(Progress::Confirming { done, of }).is_break() && stop.is_asked();
            let mut hazard = Hazard::new(group, links, &sensors, prepared.cell.names());
            confirm(prepared, &mut plain, group, &mut hazard, &mut not_run);
            // A plain run of this scan has confirmed it before.
            let before = only_kept.contains(&hazard.id).then_some(true);
            hazard.confirmed = hazard.confirmed.or(before);
            hazard.shortest.confirmed = hazard.shortest.confirmed.or(before);
            hazard
        };
        let mut hazards: Vec<Hazard> = ranked.into_iter().enumerate().map(confirmed).collect();
        let sure = |h: &Hazard| h.confirmed == Some(true) && h.shortest.confirmed == Some(true);
        // Those of an earlier attempt are there because they were confirmed.
        hazards.retain(|hazard| sure(hazard) || !only_kept.contains(&hazard.id));
        let refuted = |h: &&Hazard| h.confirmed == Some(false) || h.shortest.confirmed == Some(false);
        let unconfirmed = hazards.iter().filter(refuted).count();
        let open = hazards.iter().filter(|h| h.confirmed.is_none() || h.shortest.confirmed.is_none()).count();
        if open > 0 {
            let why = match not_run {
                Some(_) => "the FMU could not be run any more",
                None => "it was stopped, or its time was up",
            };
            let why = format!("{open} hazards were not confirmed any more: {why}");
            searched.gaps.push((Need::Confirmed, Point::open(why)));
        }
        if let Some(error) = not_run {
            searched.notes.push(format!("not every hazard could be run once more from the start: {}", error.message));
            searched.broken.get_or_insert(error);
        }
        let unsure = || Doubt { unlike: Unlike::State, shown: DoubtOrigin::Unconfirmed(unconfirmed) };
        let mut doubt = searched.doubt.take().or_else(|| (unconfirmed > 0).then(unsure));
        let next = match &mut doubt {
            Some(doubt) if !searched.interrupted => match repeatable(prepared, &mut plain, doubt) {
                Ok(true) => footing.lower(prepared, doubt.unlike),
                Ok(false) => None,
                Err(error) if error.cause.stopped => {
                    searched.interrupted = true;
                    None
                }
                Err(error) => {
                    searched.broken.get_or_insert(error.cause);
                    None
                }
            },
            _ => None,
        };
        let (Some(doubt), Some(next)) = (&doubt, next) else {
            return Ok(FallbackResult { footing, searched, hazards, notes, effort, doubt });
        };
        let because = footing.lowered(prepared, doubt, next);
        if tell(Progress::SearchAgain { because: &because }).is_break() {
            searched.interrupted = true;
            return Ok(FallbackResult { footing, searched, hazards, notes, effort, doubt: Some(doubt.clone()) });
        }
        notes.push(because);
        for hazard in hazards.iter().filter(|hazard| sure(hazard)) {
            if let Some(group) = groups.get(&hazard.id) {
                kept.add(group.worst.clone(), group.first_iteration, links);
                kept.add(group.shortest.clone(), group.first_iteration, links);
            }
        }
        footing = next;
        stop.searching();
    }
}

/// Whether the history in which a doubt showed itself gives the same twice in plain runs, each in a process of its own if
/// it can have one. If that is not what the plain run of the audit gave, it is that one which is wrong.
fn repeatable(prepared: &Prepared, plain: &mut Hosted, doubt: &mut Doubt) -> Result<bool, ScanError> {
    let DoubtOrigin::Audit(difference) = &doubt.shown else { return Ok(true) };
    let mut apart;
    let plant = match prepared.has_processes() {
        true => {
            apart = prepared.plant_by(StateRestore::Processes);
            &mut apart
        }
        false => plain,
    };
    let again = repeated(plant, &difference.history).map_err(|cause| ScanError { cause })?;
    if again.is_some_and(|gave| gave != difference.gave) {
        doubt.unlike = Unlike::Plain;
    }
    Ok(again.is_some())
}

/// One search on one footing.
fn once(
    prepared: &Prepared,
    (footing, plain): (ExecutionMode, &mut Hosted),
    (options, answers): (ScanOptions, &Arc<Answers>),
    links: &[String],
    groups: &mut Groups,
    tell: &mut dyn FnMut(Progress<'_>) -> ControlFlow<()>,
) -> Result<Searched, ScanError> {
    let all = |how, plain: &mut Hosted, groups: &mut Groups, tell: &mut dyn FnMut(Progress<'_>) -> ControlFlow<()>| {
        census(prepared, (footing, plain), (how, answers), links, groups, tell).map(Searched::all)
    };
    match options.method {
        Method::Strategy(name) => search(prepared, (footing, plain), name, options, links, groups, tell),
        Method::Exhaustive(how) => all(how, plain, groups, tell),
        Method::Auto(name, how) => {
            let mut quick = Quick::new(prepared, footing, name, options, links)?;
            let first = |done, cost| options.stop_at_first || (done < FIRST && cost < FIRST_COST);
            let _ = quick.run(first, tell);
            let mut found = Groups::default();
            let mut rest = None;
            if !quick.has_ended() {
                // One search beside the other.
                let mut both = |progress: Progress<'_>| {
                    let spent = if let Progress::Level { cost, .. } = progress { cost } else { 0 };
                    tell(progress)?;
                    quick.run(|_, cost| cost < spent / SHARE, &mut |progress| match progress {
                        Progress::Iteration { .. } => tell(Progress::Working),
                        other => tell(other),
                    })
                };
                match all(how, plain, &mut found, &mut both) {
                    Err(error) if error.cause.stopped => quick.interrupt(),
                    Err(error) => quick.fail(error.cause),
                    Ok(searched) => rest = Some(searched),
                }
                if rest.as_ref().is_some_and(Searched::needs_quick) {
                    let _ = quick.run(|_, _| true, tell);
                }
            }
            // What the complete part met, it met with the shortest sequences there are.
            if rest.as_ref().is_none_or(Searched::needs_quick) {
                quick.shorten(|identity| !found.has(identity), tell);
            }
            let (quick, only_quick) = quick.end(plain, tell);
            *groups = found;
            let only_quick = only_quick.added_to(groups);
            Ok(match rest {
                Some(searched) if quick.doubt.is_none() => searched.after(quick, &only_quick),
                _ => Searched { name: AUTO, ..quick },
            })
        }
    }
}
