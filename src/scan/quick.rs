//! Sequence after sequence, chosen by a strategy: the quick part of a scan.

use std::ops::ControlFlow;
use std::sync::Arc;

use super::execution::{Doubt, ExecutionMode};
use super::minimise::minimise;
use super::options::{Progress, ScanError, ScanOptions, StrategyName};
use super::prepare::Prepared;
use super::residual::Watch;
use super::searched::Searched;
use crate::hazard::{Groups, Identity};
use crate::host::audit::{Scope, audit};
use crate::host::{Hosted, PlantError};
use crate::record::hazard::Hazard;
use crate::record::model::FaultRecord;
use crate::search::{Rng, Strategy};
use crate::sim::motion::Motion;
use crate::sim::simulation::Fault;
use crate::sim::{Coverage, Options, Simulation};

/// Looking for shorter sequences may cost as much as half the search, and this, in communication steps about.
const SHORTENING: u64 = 500_000;

/// Tells the chances behind a first contact from those of the strategy.
const BEHIND: u64 = 0x0043_4c41_4d50;

/// A search by a strategy that can be continued.
pub(super) struct Quick<'a> {
    footing: ExecutionMode,
    options: ScanOptions,
    links: &'a [String],
    sensors: Vec<String>,
    /// What the people are called, where there are two.
    people: Option<[String; 2]>,
    strategy: Box<dyn Strategy<Simulation<Hosted>>>,
    simulation: Simulation<Hosted>,
    rng: Rng,
    /// Of what comes behind a first contact: the strategy's chances stay what they are.
    rng_behind: Rng,
    watch: Watch,
    /// What it found.
    pub groups: Groups,
    done: u32,
    interrupted: bool,
    broken: Option<PlantError>,
    /// What the search did, once it is over and something else goes on.
    over: Option<Spent>,
}

/// What a search did.
struct Spent {
    coverage: Coverage,
    motion: Motion,
    faults: Vec<FaultRecord>,
    fmu_steps: u64,
    fmu_states: usize,
}

impl Spent {
    fn of(simulation: &Simulation<Hosted>) -> Self {
        let fault = |f: &Fault| FaultRecord { message: f.message.clone(), actions: f.actions.clone() };
        Self {
            coverage: simulation.coverage().clone(),
            motion: simulation.motion().clone(),
            faults: simulation.faults().iter().map(fault).collect(),
            fmu_steps: simulation.recall().steps(),
            fmu_states: simulation.recall().states(),
        }
    }
}

impl<'a> Quick<'a> {
    /// Before its first sequence.
    pub(crate) fn new(
        prepared: &Prepared,
        footing: ExecutionMode,
        strategy: StrategyName,
        options: ScanOptions,
        links: &'a [String],
    ) -> Result<Self, ScanError> {
        let own = Options { policy: footing.policy(prepared), posture_sweep: options.posture_sweep };
        let (cell, binding) = (Arc::clone(&prepared.cell), Arc::clone(&prepared.binding));
        let simulation =
            Simulation::new(cell, binding, footing.plant(prepared), own).map_err(|cause| ScanError { cause })?;
        Ok(Self {
            footing,
            options,
            links,
            sensors: prepared.cell.sensors.iter().map(|s| s.name.clone()).collect(),
            people: prepared.cell.names().cloned(),
            strategy: strategy.build(),
            simulation,
            rng: Rng::new(options.seed),
            rng_behind: Rng::new(options.seed ^ BEHIND),
            watch: Watch::new(options.iterations),
            groups: Groups::default(),
            done: 0,
            interrupted: false,
            broken: None,
            over: None,
        })
    }

    /// What it did so far, in communication steps, about; the same on every machine.
    pub(crate) fn cost(&self) -> u64 {
        self.simulation.cost()
    }

    /// Whether no further sequence is to be tried.
    pub(crate) fn has_ended(&self) -> bool {
        let enough = self.options.stop_at_first && !self.groups.is_empty();
        self.interrupted || self.broken.is_some() || enough
    }

    /// It was told to stop.
    pub(crate) const fn interrupt(&mut self) {
        self.interrupted = true;
    }

    /// The FMU ended the scan elsewhere.
    pub(crate) fn fail(&mut self, error: PlantError) {
        self.broken.get_or_insert(error);
    }

    /// Tries sequences as long as `goes_on`, which is told how many there were and what they cost, and the budget lasts.
    pub(crate) fn run(
        &mut self,
        goes_on: impl Fn(u32, u64) -> bool,
        tell: &mut dyn FnMut(Progress<'_>) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        while self.done < self.options.iterations && !self.has_ended() && goes_on(self.done, self.cost()) {
            let outcome = self.strategy.iterate(&mut self.simulation, &mut self.rng);
            let findings = self.simulation.take_findings();
            let outcome =
                outcome.and_then(|iteration| self.simulation.look_behind(&mut self.rng_behind).map(|()| iteration));
            if outcome.as_ref().is_err_and(|error| error.stopped) {
                self.interrupted = true;
                break;
            }
            self.done += 1;
            if let Ok(iteration) = &outcome {
                self.watch.after(iteration, &findings, &self.groups, self.links);
            }
            let behind = self.simulation.take_behind();
            for finding in findings.into_iter().chain(behind) {
                let Some(id) = self.groups.add(finding, u64::from(self.done), self.links) else { continue };
                if let Some(group) = self.groups.get(&id) {
                    let hazard = Hazard::new(group, self.links, &self.sensors, self.people.as_ref());
                    self.interrupted |= tell(Progress::Found(&hazard)).is_break();
                }
            }
            if let Err(error) = outcome {
                self.broken = Some(error);
                break;
            }
            let told = Progress::Iteration { done: self.done, hazards: self.groups.len() };
            self.interrupted |= tell(told).is_break();
        }
        if self.interrupted { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    /// Looks for the shortest sequence of each hazard that `wanted` asks for, by trying.
    pub(crate) fn shorten(
        &mut self,
        wanted: impl Fn(&Identity) -> bool,
        tell: &mut dyn FnMut(Progress<'_>) -> ControlFlow<()>,
    ) {
        if self.interrupted || self.broken.is_some() {
            return;
        }
        self.over = Some(Spent::of(&self.simulation));
        let most = self.cost() + self.cost() / 2 + SHORTENING;
        let (simulation, links) = (&mut self.simulation, self.links);
        let of = self.groups.identities().filter(|identity| wanted(identity)).count();
        let wanted = self.groups.iter_mut().filter(|(identity, _)| wanted(identity));
        for (number, (identity, group)) in wanted.enumerate() {
            let go_on = |simulation: &Simulation<Hosted>| simulation.cost() < most;
            if tell(Progress::Shortening { done: number, of }).is_break() {
                self.interrupted = true;
                return;
            }
            // A failure here costs no finding: the sequence stays as it was found.
            match minimise(simulation, &group.shortest, identity, links, go_on) {
                Ok(shorter) => group.shortest = shorter,
                Err(error) => self.interrupted |= error.stopped,
            }
        }
    }

    /// Runs what the FMU did again, plainly. What came out besides the groups.
    pub(crate) fn end(
        mut self,
        plain: &mut Hosted,
        tell: &mut dyn FnMut(Progress<'_>) -> ControlFlow<()>,
    ) -> (Searched, Groups) {
        // A search that ended because of what it met would give figures about itself.
        let stopped = self.has_ended();
        let simulation = &self.simulation;
        let mut doubt = self.broken.as_ref().and_then(Doubt::of_search);
        if self.broken.is_none() && !self.interrupted {
            let (steps, instance) = (self.footing.least_audit(), self.footing.instance());
            let scope = Scope { since: 0, runs: usize::MAX, steps, instance };
            let told = &mut |_, _| tell(Progress::Working).is_continue();
            match audit(plain, simulation.recall(), scope, told) {
                Ok(audited) => {
                    self.interrupted |= audited.stopped;
                    doubt = audited.difference.map(Doubt::of_audit);
                }
                // What was found is told all the same.
                Err(error) => self.broken = Some(error),
            }
        }
        let whole = self.done == self.options.iterations;
        let over = self.over.take();
        let Spent { coverage, motion, faults, fmu_steps, fmu_states } = over.unwrap_or_else(|| Spent::of(simulation));
        let searched = Searched {
            name: self.strategy.name(),
            iterations: u64::from(self.done),
            interrupted: self.interrupted,
            quick_cut: !whole && !stopped || self.interrupted,
            broken: self.broken,
            doubt,
            certificate: None,
            gaps: Vec::new(),
            figures: self.watch.figures().filter(|_| !stopped && whole),
            coverage,
            motion,
            faults,
            fmu_steps,
            fmu_states,
            effort: simulation.recall().effort_of_workers(),
            notes: Vec::new(),
        };
        (searched, self.groups)
    }
}

/// All sequences that the budget allows; then the shortest one of each hazard is looked for, and what the FMU did is run
/// again plainly.
pub(super) fn search(
    prepared: &Prepared,
    (footing, plain): (ExecutionMode, &mut Hosted),
    strategy: StrategyName,
    options: ScanOptions,
    links: &[String],
    groups: &mut Groups,
    tell: &mut dyn FnMut(Progress<'_>) -> ControlFlow<()>,
) -> Result<Searched, ScanError> {
    let mut quick = Quick::new(prepared, footing, strategy, options, links)?;
    let _ = quick.run(|_, _| true, tell);
    quick.shorten(|_| true, tell);
    let (searched, found) = quick.end(plain, tell);
    *groups = found;
    Ok(searched)
}
