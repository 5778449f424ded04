//! Anybody whom no sensor sees at first, anywhere, walking in any way: the FMU is stepped along all histories of what sensors
//! then report, sets of poses are searched for harm, and what is found is shown by a run of its own from a place outside.

mod record;
mod walk_in;

use std::collections::BTreeMap;
use std::ops::ControlFlow;

use self::record::Rest;
use self::walk_in::WalkIn;
use super::footing::{Doubt, Footing};
use super::hosting::StateChoice;
use super::options::ScanError;
use super::prepare::Prepared;
use crate::cell::Zone;
use crate::hazard::contact::Criterion;
use crate::hazard::{Finding, Identity};
use crate::host::audit::{Scope, audit};
use crate::host::{Hosted, PlantError, Recall};
use crate::human::{Action, Posture, Start, Walk};
use crate::report::anywhere::{Anywhere, Cell, Place, Spent, Watched};
use crate::report::model::{SCHEMA_VERSION, SensorState, Verdict};
use crate::report::speeds::Speeds;
use crate::search::Environment as _;
use crate::search::tracks::explore;
use crate::sim::anywhere::machine::Machine;
use crate::sim::anywhere::zones::Zones;
use crate::sim::anywhere::{Anywhere as Search, BODY_TOLERANCE_M, CELL_M, Harm, History, Somewhere};
use crate::sim::expansion::Merge;
use crate::sim::robot::RobotFrame;
use crate::standards::iso_13855::WALKING_SPEED_M_S;

/// Most two-hand controls of a cell: with each, what is reported of somebody who is nowhere near doubles.
const MOST_TWO_HAND: usize = 3;

/// Places of one region and link of which a run of their own is tried, at most.
const MOST_SHOWN: usize = 8;

/// Walks to each that are tried.
const MOST_WALKS: usize = 24;
/// Runs of those of a region and link.
const MOST_RUNS: usize = 120;
/// Open places that are told.
const MOST_OPEN: usize = 10_000;

/// What is told while it searches.
#[derive(Clone, Copy, Debug)]
pub enum Told {
    /// States of the FMU so far, of so many at most.
    States(usize, usize),
    /// Runs of the audit, of so many.
    RunAgain(usize, usize),
    /// The share of the floor that is done, and hazards so far.
    Floor(f64, usize),
}

/// Tells it; what it answers may end the search.
pub type Tell<'a> = dyn FnMut(Told) -> ControlFlow<()> + 'a;

/// Why nobody can be looked for anywhere in a cell.
#[must_use]
pub fn refusal(prepared: &Prepared) -> Option<String> {
    let told = !prepared.cell.pose.is_empty();
    let controls = two_hand(prepared).len();
    if told {
        Some(
            "the FMU is told where the person is, so what its robots do is another matter for each place. Use start areas \
             instead: [[human.start_area]] in the cell file"
                .to_owned(),
        )
    } else if controls > MOST_TWO_HAND {
        Some(format!("the cell has {controls} two-hand controls; up to {MOST_TWO_HAND} can be looked at from anywhere"))
    } else {
        None
    }
}

/// Sensors that report whoever is *not* at them.
fn two_hand(prepared: &Prepared) -> Vec<usize> {
    let sensors = prepared.cell.sensors.iter().enumerate();
    sensors.filter(|(_, sensor)| matches!(sensor.zone, Zone::TwoHand { .. })).map(|(n, _)| n).collect()
}

/// Everything that sensors may report of somebody who is seen by none: hands on the buttons of two-hand controls, or not.
fn unseen(prepared: &Prepared) -> Vec<Vec<bool>> {
    let controls = two_hand(prepared);
    (0..1_usize << controls.len())
        .map(|bits| {
            let mut readings = vec![false; prepared.cell.sensors.len()];
            // Nobody at any of them comes first.
            controls.iter().enumerate().for_each(|(n, sensor)| readings[*sensor] = bits >> n & 1 == 0);
            readings
        })
        .collect()
}

/// How far and how hard is looked.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    /// How long after the start of the FMU, s.
    pub until_s: f64,
    /// Threads.
    pub workers: usize,
    /// Most states of the FMU.
    pub most_states: usize,
    /// How the FMU's states are brought back.
    pub state: StateChoice,
}

/// What is being put together.
struct Looking<'a> {
    prepared: &'a Prepared,
    effort: Effort,
    links: Vec<String>,
    found: Anywhere,
    rest: Rest,
    /// Contacts that poses alone make possible, where somebody can be then.
    harms: Vec<Harm>,
}

/// What came out.
pub struct Looked {
    /// Where somebody is hit, and what is not known.
    pub found: Anywhere,
    rest: Rest,
}

/// Looks everywhere.
///
/// # Errors
/// When the FMU cannot be started or fails on its way there.
pub fn anywhere(prepared: &Prepared, effort: Effort, tell: &mut Tell<'_>) -> Result<Looked, ScanError> {
    let cell = &prepared.cell;
    let found = Anywhere {
        schema_version: SCHEMA_VERSION,
        tool: format!("fmi-hazard {}", env!("CARGO_PKG_VERSION")),
        verdict: Verdict::NoneFound,
        subject: prepared.subject.clone(),
        until_s: effort.until_s,
        speed_criterion: cell.search.criterion,
        cell_m: 2.0 * CELL_M,
        body_tolerance_m: BODY_TOLERANCE_M,
        arm_tolerance_m: 2.0 * cell.search.reach_tolerance_m,
        changes: None,
        histories: Vec::new(),
        hazards: Vec::new(),
        floor: Vec::new(),
        open: 0,
        open_m: Vec::new(),
        reasons: Vec::new(),
        warnings: prepared.warnings(),
        spent: Spent::default(),
    };
    let mut looking = Looking {
        prepared,
        effort,
        links: cell.links.iter().map(|link| link.name.clone()).collect(),
        found,
        rest: Rest::new(cell.sensors.len()),
        harms: Vec::new(),
    };
    for first in unseen(prepared) {
        if !looking.from(&first, tell).map_err(|cause| ScanError { cause })? {
            looking.found.reasons.push("it was stopped, or its time was up".to_owned());
            break;
        }
    }
    Ok(looking.conclude())
}

impl Looking<'_> {
    /// Looks from where the sensors report `first`; `false` if it was told to end.
    fn from(&mut self, first: &[bool], tell: &mut Tell<'_>) -> Result<bool, PlantError> {
        let (prepared, cell) = (self.prepared, &*self.prepared.cell);
        // Where somebody is unseen decides nothing but where the person stands: the FMU gets the same inputs everywhere.
        let probe = Search::new(cell, std::iter::empty(), prepared.stop());
        let (xy_m, heading) = match probe.somewhere(first) {
            Somewhere::At(xy_m, heading) => (xy_m, heading),
            Somewhere::Nowhere => return Ok(true),
            Somewhere::Unknown => {
                let words = words(prepared, first);
                self.found.reasons.push(format!("whether sensors ever report {words} is not known"));
                return Ok(true);
            }
        };
        let start = Start::new(xy_m[0], xy_m[1], heading.to_degrees());
        let there = prepared.standing(start, 0, 1).map_err(|error| PlantError::of(error.to_string().as_str()))?;
        let unmoved = self.unmoved(&there)?;
        let search = Search::new(cell, unmoved.iter(), prepared.stop());
        let zones = Zones::new(&search, first, WALKING_SPEED_M_S * cell.step_s);
        if zones.ways.is_empty() {
            self.found.reasons.push("where nobody is seen at the start is not known".to_owned());
            return Ok(true);
        }
        let footing = Footing::asked(&there, self.effort.state, Merge::Auto);
        let mut recall = Recall::new(footing.plant(&there), footing.policy(&there))?;
        recall.ends_at(self.steps());
        if footing.merge == Merge::Auto {
            recall.merge_equal_states()?;
        }
        let mut machine = Machine::new(recall, cell, &there.binding, &zones);
        if !self.explore(&mut machine, tell)? || !self.run_again(&there, footing, &machine, tell)? {
            return Ok(false);
        }
        let histories = machine.histories();
        let all: usize = histories.iter().map(|history| history.seen.len()).sum();
        let mut done = 0;
        for (history, way) in histories.iter().zip(&zones.ways).filter(|(history, _)| !history.seen.is_empty()) {
            #[expect(clippy::cast_precision_loss, reason = "some thousand")]
            let share = |part: f64| (done as f64 + part * history.seen.len() as f64) / all as f64;
            let known = self.found.hazards.len();
            let workers = self.effort.workers;
            let outcome = search
                .search(history, workers, &mut self.rest.coverage, &mut |part| tell(Told::Floor(share(part), known)));
            self.found.histories.push(Watched {
                sensors: sensors(prepared, &history.readings),
                unseen: way.from.is_none(),
                instants: history.seen.len(),
            });
            self.found.spent.boxes += outcome.boxes;
            self.found.open += outcome.open.len();
            self.found.open_m.extend(outcome.open.iter().take(MOST_OPEN.saturating_sub(self.found.open_m.len())));
            // What was found is looked at once more, even where the time is up.
            prepared.stop().finishing();
            self.harms.extend_from_slice(&outcome.harms);
            self.show(&search, first, history, way.from.is_none(), outcome.harms);
            if outcome.stopped {
                return Ok(false);
            }
            prepared.stop().searching();
            done += history.seen.len();
        }
        Ok(true)
    }

    /// Communication steps that are looked at.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "an hour of small steps at most")]
    fn steps(&self) -> usize {
        (self.effort.until_s / self.prepared.cell.step_s).ceil().max(1.0) as usize
    }

    /// What the robots do while somebody stands there; and whether what the FMU tells of their speeds can be relied on.
    fn unmoved(&mut self, there: &Prepared) -> Result<Vec<RobotFrame>, PlantError> {
        let cell = &there.cell;
        let mut simulation = there.simulation(StateChoice::Replay, true)?;
        let still = vec![Action::new(Walk::Stop, Posture::Upright); self.steps().div_ceil(cell.steps_per_action)];
        let watched = simulation.watch(&still, &[])?;
        self.found.spent.fmu_steps += simulation.recall().steps();
        self.rest.did = self.rest.did.and(simulation.recall().effort());
        let speeds = Speeds::new(cell, &self.prepared.binding, simulation.motion());
        self.found.reasons.extend(speeds.refusal());
        self.found.warnings.extend(speeds.sentences());
        self.rest.speeds = speeds.records;
        Ok(watched.instants.into_iter().map(|instant| instant.frame).collect())
    }

    /// Steps the FMU along all histories, with as many changes of what sensors report as its states allow; `false` if it was told to
    /// end.
    fn explore(&mut self, machine: &mut Machine<'_, Hosted>, tell: &mut Tell<'_>) -> Result<bool, PlantError> {
        let (steps, most) = (self.steps(), self.effort.most_states);
        let mut known: Option<usize> = None;
        let (mut changes, mut told, mut is_last) = (1, 0, false);
        loop {
            machine.begin();
            let mut asked = false;
            let outcome = explore(machine, steps, changes, &mut |machine, taken| {
                machine.look(taken);
                told += 1;
                if told % 256 == 0 && tell(Told::States(machine.recall().states(), most)).is_break() {
                    asked = true;
                }
                !asked && (is_last || machine.recall().states() < most)
            })?;
            if asked {
                return Ok(false);
            }
            if outcome.ended {
                // What fewer changes lead to is known already.
                let Some(before) = known else {
                    self.found.reasons.push(format!(
                        "the FMU has more than {most} states within this time while sensors see somebody once. Ask for less \
                         with --until, or more with --max-states"
                    ));
                    break;
                };
                (changes, is_last) = (before, true);
                continue;
            }
            if outcome.left_out == 0 || is_last {
                self.found.changes = (outcome.left_out > 0).then_some(changes);
                break;
            }
            (known, changes) = (Some(changes), changes + 2);
        }
        self.found.spent.fmu_steps += machine.recall().steps();
        self.rest.states += machine.recall().states();
        self.rest.did = self.rest.did.and(machine.recall().effort());
        if let Some(fault) = machine.fault() {
            self.found.reasons.push(format!("the FMU could not finish some steps: {fault}"));
        }
        Ok(true)
    }

    /// Runs what the FMU did again from the start; `false` if it was told to end.
    fn run_again(
        &mut self,
        there: &Prepared,
        footing: Footing,
        machine: &Machine<'_, Hosted>,
        tell: &mut Tell<'_>,
    ) -> Result<bool, PlantError> {
        let steps = footing.least_audit() + machine.recall().steps();
        let scope = Scope { since: 0, runs: usize::MAX, steps, instance: footing.instance() };
        let audited = audit(&mut footing.plain(there), machine.recall(), scope, &mut |done, of| {
            tell(Told::RunAgain(done, of)).is_continue()
        })?;
        if let Some(difference) = audited.difference {
            self.found.reasons.push(Doubt::of_audit(difference).words());
        }
        self.found.spent.run_again += audited.compared;
        Ok(!audited.stopped)
    }

    /// Shows with runs of their own what harms there are.
    fn show(&mut self, search: &Search<'_>, first: &[bool], history: &History, is_unseen: bool, harms: Vec<Harm>) {
        let (prepared, cell) = (self.prepared, &*self.prepared.cell);
        let as_told = sensors(prepared, &history.readings);
        for alike in alike(harms) {
            let ways = |harm: &Harm| {
                let step = history.seen[harm.instant].step;
                if is_unseen {
                    // Standing there for a whole action before; where that is hit otherwise first, for the last step of it.
                    [cell.steps_per_action, 1].map(|before| WalkIn::standing(harm, step, before)).to_vec()
                } else {
                    WalkIn::all(search, cell, first, history, harm)
                }
            };
            let unseen = is_unseen.then_some(first);
            let mut tried = 0;
            let shown = alike.iter().take(MOST_SHOWN).find_map(|harm| {
                ways(harm).into_iter().take(MOST_WALKS).find_map(|way| {
                    tried += 1;
                    (tried <= MOST_RUNS)
                        .then(|| shown(prepared, &way, unseen))
                        .flatten()
                        .map(|finding| (*harm, way, finding))
                })
            });
            let (harm, way, finding) = match shown {
                Some((harm, way, finding)) => (harm, way, Some(finding)),
                None => {
                    let step = history.seen[alike[0].instant].step;
                    (alike[0], WalkIn::standing(&alike[0], step, cell.steps_per_action), None)
                }
            };
            if let Some(finding) = &finding {
                self.rest.shown.add(finding, &way, &self.links);
            }
            let place = self.place(&harm, &way, finding.as_ref(), &as_told, alike.len());
            // What is told of a contact may be another region or link that is hit as soon and harder.
            let same = |known: &&mut Place| {
                known.confirmed
                    && (known.body_region, &known.robot_link, known.walks_in)
                        == (place.body_region, &place.robot_link, place.walks_in)
            };
            match self.found.hazards.iter_mut().find(same) {
                Some(known) if place.ratio <= known.ratio || !place.confirmed => known.cells += place.cells,
                Some(known) => *known = Place { cells: known.cells + place.cells, ..place },
                None => self.found.hazards.push(place),
            }
        }
    }

    fn place(
        &self,
        harm: &Harm,
        way: &WalkIn,
        finding: Option<&Finding>,
        sensors: &[SensorState],
        cells: usize,
    ) -> Place {
        #[expect(clippy::cast_precision_loss, reason = "an hour of small steps at most")]
        let seconds = |steps: usize| steps as f64 * self.prepared.cell.step_s;
        let contact = finding.map_or(&harm.contact, |finding| &finding.contact);
        Place {
            confirmed: finding.is_some(),
            id: finding.map(|finding| Identity::of(finding, &self.links).id()).unwrap_or_default(),
            body_region: contact.region,
            robot_link: self.links[contact.link].clone(),
            class: contact.class(),
            ratio: contact.ratio(),
            force_n: contact.deciding_force_n(),
            limit_n: contact.limit_n,
            speed_m_s: contact.speed_m_s,
            time_s: finding.map(|finding| seconds(way.lead_in + finding.step)),
            xy_m: harm.xy_m,
            heading_deg: harm.heading_rad.to_degrees(),
            posture: harm.posture.words(),
            walks_in: way.actions.iter().any(|action| action.walk() != Walk::Stop),
            start_m: way.xy_m,
            start_heading_deg: way.heading_deg,
            begins_s: seconds(way.lead_in),
            actions: way.actions.clone(),
            sensors: finding.map_or_else(|| sensors.to_vec(), |finding| self::sensors(self.prepared, &finding.sensors)),
            cells,
        }
    }

    /// The verdict, and why.
    fn conclude(mut self) -> Looked {
        let (found, coverage) = (&mut self.found, &self.rest.coverage);
        found.floor = hazardous(&self.harms);
        found.spent.arm_checks = coverage.arm_checks;
        found.spent.arm_boxes = coverage.arm_boxes;
        // What was not confirmed one way may have been another.
        let known: Vec<_> = found.hazards.iter().filter(|place| place.confirmed).cloned().collect();
        found.hazards.retain(|place| {
            let same = |other: &Place| {
                (other.body_region, &other.robot_link, other.walks_in)
                    == (place.body_region, &place.robot_link, place.walks_in)
            };
            place.confirmed || !known.iter().any(same)
        });
        found.hazards.sort_by(|a, b| b.confirmed.cmp(&a.confirmed).then(b.ratio.total_cmp(&a.ratio)));
        if found.histories.is_empty() {
            found.reasons.push("no robot moved that could harm anybody, or no sensor leaves anybody unseen".to_owned());
        }
        if found.open > 0 {
            let open = found.open;
            found
                .reasons
                .push(format!("{open} cells of the floor are open: whether anybody is hit there is not known"));
        }
        let unconfirmed = found.hazards.iter().filter(|place| !place.confirmed).count();
        if unconfirmed > 0 {
            found.reasons.push(format!("of {unconfirmed} ways to be hit, no walk was found that shows them"));
        }
        if coverage.arm_checks_incomplete > 0 {
            found.reasons.push(format!("{} arm searches stopped at their work limit", coverage.arm_checks_incomplete));
        }
        if self.prepared.cell.search.criterion == Criterion::Approach {
            found.reasons.push(
                "with the speed of approach as criterion, who walks comes to the robot faster than looked at: only people who stand are"
                    .to_owned(),
            );
        }
        found.reasons.extend(self.prepared.unsteady());
        found.verdict = if found.hazards.iter().any(|hazard| hazard.confirmed) {
            Verdict::HazardsFound
        } else if self.prepared.stop().is_asked() {
            Verdict::Interrupted
        } else if found.reasons.is_empty() && found.hazards.is_empty() {
            Verdict::NoneFound
        } else {
            Verdict::Inconclusive
        };
        Looked { found: self.found, rest: self.rest }
    }
}

/// Readings of two-hand controls in words.
fn words(prepared: &Prepared, readings: &[bool]) -> String {
    let of = |n: usize| {
        let hands = if readings[n] { "nobody at" } else { "both hands at" };
        format!("{hands} {}", prepared.cell.sensors[n].name)
    };
    two_hand(prepared).into_iter().map(of).collect::<Vec<_>>().join(" and ")
}

fn sensors(prepared: &Prepared, readings: &[bool]) -> Vec<SensorState> {
    let state = |(sensor, detected): (&crate::cell::Sensor, &bool)| SensorState {
        name: sensor.name.clone(),
        person_detected: *detected,
        since_s: None,
    };
    prepared.cell.sensors.iter().zip(readings).map(state).collect()
}

/// Those of each region and link together, the worst first.
fn alike(harms: Vec<Harm>) -> Vec<Vec<Harm>> {
    let mut by: BTreeMap<(u8, usize), Vec<Harm>> = BTreeMap::new();
    for harm in harms {
        by.entry((harm.contact.region as u8, harm.link)).or_default().push(harm);
    }
    for alike in by.values_mut() {
        alike.sort_by(|a, b| b.contact.ratio().total_cmp(&a.contact.ratio()));
    }
    by.into_values().collect()
}

/// The cells of the floor in which somebody is harmed, with the worst that was tried there.
fn hazardous(harms: &[Harm]) -> Vec<Cell> {
    let mut by: BTreeMap<[i64; 2], f64> = BTreeMap::new();
    for harm in harms {
        #[expect(clippy::cast_possible_truncation, reason = "some thousand cells to a side")]
        let cell = harm.xy_m.map(|at| (at / (2.0 * CELL_M)).floor() as i64);
        let worst = by.entry(cell).or_insert(0.0);
        *worst = worst.max(harm.contact.ratio());
    }
    #[expect(clippy::cast_precision_loss, reason = "some thousand cells to a side")]
    let middle = |cell: [i64; 2]| cell.map(|at| (at as f64 + 0.5) * 2.0 * CELL_M);
    by.into_iter().map(|(cell, ratio)| Cell { xy_m: middle(cell), ratio }).collect()
}

/// The first harm that a walk leads to; while sensors report `readings`, if given.
fn shown(prepared: &Prepared, way: &WalkIn, readings: Option<&[bool]>) -> Option<Finding> {
    let actions = u32::try_from(way.actions.len()).ok()?;
    let there = prepared.standing(way.start(), way.lead_in, actions).ok()?;
    let mut simulation = there.simulation(StateChoice::Replay, false).ok()?;
    simulation.reset().ok()?;
    let mut findings = Vec::new();
    for action in &way.actions {
        let step = simulation.step(action.index()).ok()?;
        findings.extend(simulation.take_findings());
        if step.end.is_some() {
            break;
        }
    }
    let as_told = |finding: &Finding| {
        let Some(readings) = readings else { return true };
        let sensors = prepared.cell.sensors.iter().zip(finding.sensors.iter().zip(readings));
        finding.through.is_empty()
            && sensors
                .into_iter()
                .all(|(sensor, (told, reading))| told == reading || matches!(sensor.zone, Zone::Reported))
    };
    findings.into_iter().find(as_told)
}
