//! Sequence after sequence, chosen by a strategy: the quick part of a scan.

use std::ops::ControlFlow;
use std::sync::Arc;

use super::footing::{Doubt, Footing};
use super::minimise::minimise;
use super::prepare::Prepared;
use super::residual::Watch;
use super::run::{Progress, ScanError, ScanOptions, Searched, StrategyName};
use crate::hazard::Groups;
use crate::host::Hosted;
use crate::host::audit::{Scope, audit};
use crate::report::model::{FaultRecord, Hazard};
use crate::search::Rng;
use crate::sim::{Options, Simulation};

/// Sequence after sequence; then the shortest one of each hazard is looked for, and what the FMU did is run again plainly.
pub(super) fn search(
    prepared: &Prepared,
    (footing, plain): (Footing, &mut Hosted),
    strategy: StrategyName,
    options: ScanOptions,
    links: &[String],
    groups: &mut Groups,
    tell: &mut dyn FnMut(Progress<'_>) -> ControlFlow<()>,
) -> Result<Searched, ScanError> {
    let sensors: Vec<String> = prepared.cell.sensors.iter().map(|s| s.name.clone()).collect();
    let own = Options { policy: footing.policy(prepared), posture_sweep: options.posture_sweep };
    let (cell, binding) = (Arc::clone(&prepared.cell), Arc::clone(&prepared.binding));
    let mut simulation =
        Simulation::new(cell, binding, footing.plant(prepared), own).map_err(|cause| ScanError { cause })?;
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
    let mut doubt = broken.as_ref().and_then(Doubt::of_search);
    if broken.is_none() && !interrupted {
        for (identity, group) in groups.iter_mut() {
            // A failure here costs no finding: the sequence stays as it was found.
            if let Ok(shorter) = minimise(&mut simulation, &group.shortest, identity, links) {
                group.shortest = shorter;
            }
        }
        let scope = Scope { since: 0, runs: usize::MAX, steps: footing.least_audit(), instance: footing.instance() };
        let audited = audit(plain, simulation.recall(), scope, &mut |_, _| tell(Progress::Working).is_continue())
            .map_err(|cause| ScanError { cause })?;
        interrupted |= audited.stopped;
        doubt = audited.difference.map(Doubt::of_audit);
    }
    Ok(Searched {
        name: strategy.name(),
        iterations: u64::from(done),
        interrupted,
        broken,
        doubt,
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
