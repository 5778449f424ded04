//! The smallest change of a cell that removes a hazard, for each thing that can be turned. Removed means: this robot does
//! not hit this region of the body beyond its limit any more, by whatever link and wherever the person stands; a change
//! after which the neighbouring link hits would be none.
//!
//! The known sequences decide first: by bisection, the fewest steps of a knob after which none of them leads to the hazard.
//! Then a search tries the changed cell. If it meets the hazard all the same, its sequence joins the known ones and the
//! bisection goes on above (counterexample-guided, as in program synthesis). So what is printed held against every sequence
//! met on the way and against one whole search; it is no proof, which takes an exhaustive scan of the changed cell.
//!
//! Bisection takes for granted that more of a change is never worse, up to the largest of 1, 1/2, 1/4, ... of the range that
//! helps. Where it is worse, the result may be larger than necessary, but it was tried itself, as said. What makes the FMU
//! fail, the robot stand still or a sensor report the person from the start removes nothing.

use std::panic::resume_unwind;
use std::sync::atomic::{AtomicUsize, Ordering};

use super::prepare::{Prepared, StateChoice};
use super::run::StrategyName;
use crate::cell::binding::BoundUnit;
use crate::cell::knob::{Encounter, Knob};
use crate::hazard::Groups;
use crate::hazard::contact::STANDSTILL_M_S;
use crate::host::{Hosted, PlantError};
use crate::human::Action;
use crate::report::explanation::{Outcome, Remedy, Removed};
use crate::report::model::Hazard;
use crate::search::{End, Environment as _, Rng};
use crate::sim::Simulation;
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
///
/// # Errors
/// When the FMU fails in the cell as it is.
pub fn remedies(
    prepared: &Prepared,
    hazard: &Hazard,
    known: &[Hazard],
    effort: Effort,
    tell: &(dyn Fn(usize, usize) + Sync),
) -> Result<Vec<Remedy>, PlantError> {
    let Ok(text) = prepared.text.parse::<toml::Table>() else { return Ok(Vec::new()) };
    let kind = |hazard: &Hazard| {
        let link = prepared.cell.links.iter().find(|link| link.name == hazard.robot_link)?;
        Some(Kind { region: hazard.body_region, robot: link.robot })
    };
    let Some(own) = kind(hazard) else { return Ok(Vec::new()) };
    let at_start = at_start(&mut prepared.simulation(StateChoice::Auto, false)?)?;
    let units = BoundUnit::all(prepared.names.iter().zip(prepared.fmus.iter()));
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
            let trial =
                Trial { prepared, text: &text, knob, kind: own, iterations: effort.iterations, at_start: &at_start };
            mine.push((number, trial.remedy(sequences.clone())));
            tell(done.fetch_add(1, Ordering::Relaxed) + 1, knobs.len());
        }
        mine
    };
    let mut all: Vec<(usize, Remedy)> = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..effort.workers.clamp(1, knobs.len().max(1))).map(|_| scope.spawn(work)).collect();
        let joined = threads.into_iter().map(|thread| thread.join().unwrap_or_else(|panic| resume_unwind(panic)));
        joined.flatten().collect()
    });
    all.sort_by_key(|(number, _)| *number);
    Ok(all.into_iter().map(|(_, remedy)| remedy).collect())
}

/// One knob.
struct Trial<'a> {
    prepared: &'a Prepared,
    text: &'a toml::Table,
    knob: &'a Knob,
    kind: Kind,
    iterations: u32,
    /// What the sensors report at the start of the unchanged cell.
    at_start: &'a [bool],
}

/// What came of known sequences, or of a search, in a changed cell.
enum Met {
    /// The hazard, by this sequence.
    Hazard(Vec<Action>),
    /// Others, if any.
    Others(Groups),
    /// Nothing that counts: why.
    Impossible(String),
}

impl Trial<'_> {
    fn remedy(&self, mut known: Vec<Vec<Action>>) -> Remedy {
        let (steps, outcome) = match self.smallest(&mut known) {
            Ok(found) => found,
            Err(error) => (self.knob.steps, Outcome::NotTried { cause: error.message }),
        };
        Remedy { change: self.knob.words(steps), outcome }
    }

    /// The fewest steps that help, and what stands behind them; else the most that were tried.
    fn smallest(&self, known: &mut Vec<Vec<Action>>) -> Result<(u32, Outcome), PlantError> {
        let known_sequences = known.len();
        // The largest change that helps: a smaller one may where a larger does not, because it is too much for the cell (the
        // person would start in it, the FMU refuses it) or leads past the person.
        let (mut most, mut tried, mut impossible) = (None, None, String::new());
        let mut steps = self.knob.steps;
        while steps > 0 && most.is_none() {
            match self.known(steps, known)? {
                Met::Others(_) => most = Some(steps),
                Met::Hazard(_) => tried = tried.or(Some(steps)),
                Met::Impossible(why) => impossible = why,
            }
            steps /= 2;
        }
        let no_help = |tried: Option<u32>| match tried {
            Some(steps) => (steps, Outcome::NoHelp),
            None => (self.knob.steps, Outcome::NotTried { cause: impossible.clone() }),
        };
        let Some(most) = most else { return Ok(no_help(tried)) };
        let (mut low, mut counterexamples) = (0, 0_u32);
        while low < most {
            // With `high` steps no known sequence leads to the hazard, with `low` steps some do.
            let mut high = most;
            while high - low > 1 {
                let middle = low + (high - low) / 2;
                if matches!(self.known(middle, known)?, Met::Others(_)) { high = middle } else { low = middle }
            }
            let patience = counterexamples.saturating_sub(PATIENCE).min(6);
            let candidate = if patience > 0 { (high + (1 << patience)).min(most) } else { high };
            let Met::Others(others) = self.known(candidate, known)? else {
                low = candidate;
                continue;
            };
            match self.search(candidate, others)? {
                Met::Hazard(sequence) => {
                    known.push(sequence);
                    low = candidate;
                    counterexamples += 1;
                }
                Met::Impossible(cause) => return Ok((candidate, Outcome::NotTried { cause })),
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
                    return Ok((candidate, Outcome::Removed(removed)));
                }
            }
        }
        Ok(no_help(Some(most)))
    }

    /// The cell turned so far, with its simulation; or why it is none.
    fn changed(&self, steps: u32, posture_sweep: bool) -> Result<(Prepared, Simulation<Hosted>), String> {
        let text = self.knob.turned(self.text, steps).and_then(|table| toml::to_string(&table).ok());
        let text = text.ok_or("the cell file cannot be changed so")?;
        let prepared = self.prepared.changed(&text).map_err(|error| error.to_string())?;
        let mut simulation = prepared.simulation(StateChoice::Auto, posture_sweep).map_err(|error| error.message)?;
        let at_start = at_start(&mut simulation).map_err(|error| error.message)?;
        if at_start.iter().zip(self.at_start).any(|(now, before)| *now && !before) {
            return Err("a sensor reports the person at the start already".to_owned());
        }
        Ok((prepared, simulation))
    }

    /// What the known sequences lead to. One that leads to the hazard then stands first: it is likely to do so again.
    fn known(&self, steps: u32, known: &mut [Vec<Action>]) -> Result<Met, PlantError> {
        let (prepared, mut simulation) = match self.changed(steps, false) {
            Ok(changed) => changed,
            Err(why) => return Ok(Met::Impossible(why)),
        };
        let mut others = Groups::default();
        for number in 0..known.len() {
            simulation.reset()?;
            for action in &known[number] {
                match simulation.step(action.index())?.end {
                    Some(End::NotEvaluated) => return Ok(Met::Impossible(simulation.not_evaluated().message)),
                    Some(_) => break,
                    None => {}
                }
            }
            if let Some(sequence) = self.sort(&prepared, &mut simulation, &mut others) {
                known[..=number].rotate_right(1);
                return Ok(Met::Hazard(sequence));
            }
        }
        Ok(Met::Others(others))
    }

    /// A whole search, which ends when it meets the hazard; what it meets else joins `others`.
    fn search(&self, steps: u32, mut others: Groups) -> Result<Met, PlantError> {
        let (prepared, mut simulation) = match self.changed(steps, true) {
            Ok(changed) => changed,
            Err(why) => return Ok(Met::Impossible(why)),
        };
        let mut strategy = StrategyName::Hybrid.build();
        let mut rng = Rng::new(prepared.cell.search.seed);
        for _ in 0..self.iterations {
            if strategy.iterate(&mut simulation, &mut rng)?.end == End::NotEvaluated {
                return Ok(Met::Impossible(simulation.not_evaluated().message));
            }
            if let Some(sequence) = self.sort(&prepared, &mut simulation, &mut others) {
                return Ok(Met::Hazard(sequence));
            }
        }
        if simulation.coverage().robot_top_speed_m_s <= STANDSTILL_M_S {
            return Ok(Met::Impossible("it helps only because the robot does not move at all then".to_owned()));
        }
        Ok(Met::Others(others))
    }

    /// The sequence of the first finding that is the hazard; other findings join `others`.
    fn sort(
        &self,
        prepared: &Prepared,
        simulation: &mut Simulation<Hosted>,
        others: &mut Groups,
    ) -> Option<Vec<Action>> {
        let links: Vec<String> = prepared.cell.links.iter().map(|link| link.name.clone()).collect();
        for finding in simulation.take_findings() {
            let robot = prepared.cell.links[finding.contact.link].robot;
            if (Kind { region: finding.contact.region, robot }) == self.kind {
                return Some(finding.actions);
            }
            others.add(finding, 0, &links);
        }
        None
    }
}

/// What the sensors report at the start.
fn at_start(simulation: &mut Simulation<Hosted>) -> Result<Vec<bool>, PlantError> {
    let watched = simulation.watch(&[], &[])?;
    Ok(watched.instants[0].readings.clone())
}
