//! The smallest change of a cell that removes a hazard, for each thing that can be turned. Removed means: this robot does
//! not hit this region of the body beyond its limit any more, by whatever link and wherever the person stands; a change
//! after which the neighbouring link hits would be none.
//!
//! The known sequences decide first: by bisection, the fewest steps of a knob after which none of them leads to the hazard.
//! Then a search tries the changed cell. If it meets the hazard all the same, its sequence joins the known ones and the
//! bisection goes on above (counterexample-guided, as in program synthesis). So what is printed held against every sequence
//! met on the way and against one whole search; it is no proof, which takes an exhaustive scan of the changed cell.
//!
//! Bisection takes for granted that more of a change is never worse. Where it is, a counterexample may be met later, and the
//! result is larger than necessary, but it holds as said.

use std::sync::atomic::{AtomicUsize, Ordering};

use super::prepare::{PrepareError, Prepared, StateChoice};
use super::run::StrategyName;
use crate::cell::binding::BoundUnit;
use crate::cell::knob::{Encounter, Knob};
use crate::hazard::{Finding, Groups};
use crate::host::PlantError;
use crate::human::Action;
use crate::report::explanation::{Outcome, Remedy, Removed};
use crate::report::model::Hazard;
use crate::search::{Environment as _, Rng};
use crate::standards::BodyRegion;

/// How hard a remedy is tried.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    /// Iterations of the search that tries each candidate.
    pub iterations: u32,
    /// Threads; the result is the same.
    pub workers: usize,
}

/// The same hazard wherever it happens: this region of the body, hit by this robot.
#[derive(Clone, Copy, PartialEq)]
struct Kind {
    region: BodyRegion,
    robot: usize,
}

/// Most sequences of the scan that are tried after each change.
const KNOWN: usize = 24;

/// After so many counterexamples for one knob, steps grow.
const PATIENCE: u32 = 4;

/// Looks for the smallest turn of each knob that removes `hazard`. `known` are all hazards of the scan that it is from.
/// `tell` hears how many knobs are done. Nothing if the cell is not the one that was scanned.
pub fn remedies(
    prepared: &Prepared,
    hazard: &Hazard,
    known: &[Hazard],
    effort: Effort,
    tell: &(dyn Fn(usize, usize) + Sync),
) -> Vec<Remedy> {
    let Ok(text) = prepared.text.parse::<toml::Table>() else { return Vec::new() };
    let kind = |hazard: &Hazard| {
        let link = prepared.cell.links.iter().find(|link| link.name == hazard.robot_link)?;
        Some(Kind { region: hazard.body_region, robot: link.robot })
    };
    let Some(own) = kind(hazard) else { return Vec::new() };
    let names = prepared.names.iter().map(String::as_str).zip(prepared.fmus.iter());
    let units: Vec<BoundUnit<'_>> =
        names.map(|(name, fmu)| BoundUnit { name, description: fmu.description(), file: String::new() }).collect();
    let encounter = Encounter { person_m: hazard.person_xy_m, robot: own.robot };
    let knobs = Knob::all(&prepared.cell, &text, &units, &encounter);
    let alike = known.iter().filter(|other| kind(other) == Some(own));
    // Worst first, as they stand in the scan.
    let mut sequences: Vec<Vec<Action>> = Vec::new();
    for actions in [hazard].into_iter().chain(alike).flat_map(|other| [&other.actions, &other.shortest.actions]) {
        if sequences.len() < KNOWN && !sequences.contains(actions) {
            sequences.push(actions.clone());
        }
    }

    let (next, done) = (AtomicUsize::new(0), AtomicUsize::new(0));
    let work = || {
        let mut mine = Vec::new();
        while let Some((number, knob)) =
            Some(next.fetch_add(1, Ordering::Relaxed)).and_then(|n| Some((n, knobs.get(n)?)))
        {
            let trial = Trial { prepared, text: &text, knob, kind: own, iterations: effort.iterations };
            mine.push((number, trial.remedy(sequences.clone())));
            tell(done.fetch_add(1, Ordering::Relaxed) + 1, knobs.len());
        }
        mine
    };
    let mut all: Vec<(usize, Remedy)> = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..effort.workers.clamp(1, knobs.len().max(1))).map(|_| scope.spawn(work)).collect();
        threads.into_iter().flat_map(|thread| thread.join().unwrap_or_default()).collect()
    });
    all.sort_by_key(|(number, _)| *number);
    all.into_iter().map(|(_, remedy)| remedy).collect()
}

/// One knob.
struct Trial<'a> {
    prepared: &'a Prepared,
    text: &'a toml::Table,
    knob: &'a Knob,
    kind: Kind,
    iterations: u32,
}

/// What a search in a changed cell met.
enum Met {
    /// The hazard, by this sequence.
    Hazard(Vec<Action>),
    /// Others, if any.
    Others(Groups),
}

impl Trial<'_> {
    fn remedy(&self, known: Vec<Vec<Action>>) -> Remedy {
        match self.smallest(known) {
            Ok(Some((steps, removed))) => Remedy { change: self.knob.words(steps), outcome: Outcome::Removed(removed) },
            Ok(None) => Remedy { change: self.knob.words(self.knob.steps), outcome: Outcome::NoHelp },
            // A parameter that the FMU does not bear, for instance.
            Err(error) => {
                Remedy { change: self.knob.words(self.knob.steps), outcome: Outcome::NotTried { cause: error.message } }
            }
        }
    }

    fn smallest(&self, mut known: Vec<Vec<Action>>) -> Result<Option<(u32, Removed)>, PlantError> {
        let known_sequences = known.len();
        // A change can be too much for the cell: the person's start in a wall, for instance.
        let mut most = self.knob.steps;
        while most > 0 && self.changed(most).is_none() {
            most /= 2;
        }
        let (mut low, mut counterexamples) = (0, 0);
        while low < most && !self.leads_there(most, &mut known)? {
            // With `high` steps no known sequence leads to the hazard, with `low` steps some do.
            let mut high = most;
            while high - low > 1 {
                let middle = low + (high - low) / 2;
                if self.leads_there(middle, &mut known)? { low = middle } else { high = middle }
            }
            let patient = u32::saturating_sub(counterexamples, PATIENCE).min(6);
            let candidate = if patient > 0 { (high + (1 << patient)).min(most) } else { high };
            match self.search(candidate)? {
                Met::Hazard(sequence) => {
                    known.push(sequence);
                    low = candidate;
                    counterexamples += 1;
                }
                Met::Others(others) => {
                    let worst_other = others.ranked().first().map(|group| {
                        let contact = &group.worst.contact;
                        let link = &self.prepared.cell.links[contact.link].name;
                        format!("{:.2}x {} <- {link}", contact.ratio(), contact.region)
                    });
                    let removed = Removed {
                        known_sequences,
                        counterexamples,
                        searched: self.iterations,
                        others: others.len(),
                        worst_other,
                    };
                    return Ok(Some((candidate, removed)));
                }
            }
        }
        Ok(None)
    }

    /// The cell turned so far, if that is a cell.
    fn changed(&self, steps: u32) -> Option<Result<Prepared, PrepareError>> {
        let text = toml::to_string(&self.knob.turned(self.text, steps)?).ok()?;
        match self.prepared.changed(&text) {
            Err(PrepareError::Bind(_) | PrepareError::StartBlocked { .. }) => None,
            other => Some(other),
        }
    }

    fn cell(&self, steps: u32) -> Result<Option<Prepared>, PlantError> {
        let failed = |error: PrepareError| PlantError { message: error.to_string(), ..PlantError::default() };
        self.changed(steps).transpose().map_err(failed)
    }

    /// Whether one of the sequences leads to the hazard; it then stands first, as it is likely to do so again. A change that
    /// is no cell helps nobody.
    fn leads_there(&self, steps: u32, sequences: &mut [Vec<Action>]) -> Result<bool, PlantError> {
        let Some(prepared) = self.cell(steps)? else { return Ok(true) };
        let mut simulation = prepared.simulation(StateChoice::Auto, false)?;
        for number in 0..sequences.len() {
            simulation.reset()?;
            for action in &sequences[number] {
                if simulation.step(action.index())?.end.is_some() {
                    break;
                }
            }
            if simulation.take_findings().iter().any(|finding| self.is_it(&prepared, finding)) {
                sequences[..=number].rotate_right(1);
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// A whole search, which ends when it meets the hazard.
    fn search(&self, steps: u32) -> Result<Met, PlantError> {
        let mut others = Groups::default();
        let Some(prepared) = self.cell(steps)? else { return Ok(Met::Others(others)) };
        let links: Vec<String> = prepared.cell.links.iter().map(|link| link.name.clone()).collect();
        let mut simulation = prepared.simulation(StateChoice::Auto, true)?;
        let mut strategy = StrategyName::Hybrid.build();
        let mut rng = Rng::new(prepared.cell.search.seed);
        for iteration in 1..=self.iterations {
            strategy.iterate(&mut simulation, &mut rng)?;
            for finding in simulation.take_findings() {
                if self.is_it(&prepared, &finding) {
                    return Ok(Met::Hazard(finding.actions));
                }
                others.add(finding, u64::from(iteration), &links);
            }
        }
        Ok(Met::Others(others))
    }

    fn is_it(&self, prepared: &Prepared, finding: &Finding) -> bool {
        let robot = prepared.cell.links[finding.contact.link].robot;
        Kind { region: finding.contact.region, robot } == self.kind
    }
}
