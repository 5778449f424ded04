//! A harm that poses alone make possible is a hazard when a run of its own shows it: somebody stands there, or walks in. It begins where
//! people get to by the rules of a scan from the start: the sets of places that are searched hold others as well.

use std::collections::BTreeMap;

use super::behaviours::Few;
use super::guided_walks::Guided;
use super::random_walks::Seek;
use super::walk_in::{WalkIn, shown_by};
use super::{AnalysisContext, control_walks};
use crate::hazard::{Finding, Identity};
use crate::human::Walk;
use crate::reachability::reading_regions::ReadingTransition;
use crate::reachability::{Harm, History, ReachabilitySearch as Search, known};
use crate::record::hazard::SensorState;
use crate::record::reachability::HarmfulPose;
use crate::scan::prepare::Prepared;

/// Places of one region and link of which a run of their own is tried, at most.
const MOST_WORST: usize = 8;
/// The same of those to which there is most time to walk.
const MOST_EASY: usize = 8;
/// Walks to each that are tried.
const MOST_WALKS: usize = 24;
/// Runs of those of a region and link.
const MOST_RUNS: usize = 200;
/// Walks at random to those of a region and link that are run, in one history and in all together.
const MOST_SOUGHT_AT_ONCE: usize = 100;
const MOST_SOUGHT: usize = 1_000;

impl AnalysisContext<'_> {
    /// Shows with runs of their own what harms there are.
    pub(super) fn show(
        &mut self,
        search: &Search<'_>,
        first: &[bool],
        (history, way): (&History, &ReadingTransition),
        few: Option<(&Few, usize)>,
        harms: Vec<Harm>,
    ) {
        let (prepared, cell) = (self.prepared, &*self.prepared.cell);
        let as_told = sensors(prepared, &history.readings);
        for alike in alike(harms) {
            let shown = match few {
                Some((few, way)) => {
                    let seek = Seek { prepared, search, first, history, any_time: true };
                    Guided { seek, few: Some((few, way)), until: self.steps() }.walk(&alike, 1)
                }
                None => shown(prepared, search, first, (history, way), &alike),
            };
            let shown = shown.or_else(|| self.sought(search, first, history, &alike));
            let (harm, way, finding) = match shown {
                Some((harm, way, finding)) => (harm, way, Some(finding)),
                None => {
                    let step = history.seen[alike[0].instant].step;
                    (alike[0], WalkIn::standing(&alike[0], step, cell.steps_per_action, cell.steps_per_action), None)
                }
            };
            if let Some(finding) = &finding {
                self.rest.shown.add(finding, &way, &self.links);
            }
            let place = self.place(&harm, &way, finding.as_ref(), &as_told, alike.len());
            self.tell_of(place);
        }
    }

    /// A place is told of, or was before.
    pub(super) fn tell_of(&mut self, place: HarmfulPose) {
        // What is told of a contact may be another region or link that is hit as soon and harder.
        let same = |known: &&mut HarmfulPose| {
            known.confirmed
                && (known.body_region, &known.robot_link, known.walks_in)
                    == (place.body_region, &place.robot_link, place.walks_in)
        };
        match self.found.hazards.iter_mut().find(same) {
            Some(known) if place.ratio <= known.ratio || !place.confirmed => known.met_again(&place),
            Some(known) => {
                let before = std::mem::replace(known, place);
                known.met_again(&before);
            }
            None => self.found.hazards.push(place),
        }
    }

    /// A walk of those at random that shows one of some harms: as many are run as are left for their region and link, and none once
    /// harm is shown to these.
    fn sought(
        &mut self,
        search: &Search<'_>,
        first: &[bool],
        history: &History,
        alike: &[Harm],
    ) -> Option<(Harm, WalkIn, Finding)> {
        let (region, link) = (alike[0].contact.region, alike[0].link);
        let shown = |place: &HarmfulPose| {
            place.confirmed && place.body_region == region && place.robot_link == self.links[link]
        };
        if self.found.hazards.iter().any(shown) {
            return None;
        }
        let run = self.sought.entry((region as u8, link)).or_default();
        let most = MOST_SOUGHT.saturating_sub(*run).min(MOST_SOUGHT_AT_ONCE);
        let seek = Seek { prepared: self.prepared, search, first, history, any_time: false };
        let (found, runs) = seek.walk(alike, most, *run as u64);
        *run += runs;
        found
    }

    pub(super) fn place(
        &self,
        harm: &Harm,
        way: &WalkIn,
        finding: Option<&Finding>,
        sensors: &[SensorState],
        cells: usize,
    ) -> HarmfulPose {
        #[expect(clippy::cast_precision_loss, reason = "an hour of small steps at most")]
        let seconds = |steps: usize| steps as f64 * self.prepared.cell.step_s;
        let contact = finding.map_or(&harm.contact, |finding| &finding.contact);
        HarmfulPose {
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
            sensors: finding
                .map_or_else(|| sensors.to_vec(), |finding| self::sensors(self.prepared, &known(&finding.sensors))),
            cells,
            histories: 1,
        }
    }
}

/// What sensors report, without those of which that is not known.
pub(super) fn sensors(prepared: &Prepared, readings: &[Option<bool>]) -> Vec<SensorState> {
    let state = |(sensor, detected): (&crate::cell::Sensor, &Option<bool>)| {
        detected.map(|person_detected| SensorState { name: sensor.name.clone(), person_detected, since_s: None })
    };
    prepared.cell.sensors.iter().zip(readings).filter_map(state).collect()
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

/// Of harms, the worst first, those that are tried: the worst of them, and those that are farthest within what bounds on the way there
/// allow.
fn shown_first<'h>(history: &History, harms: &'h [Harm]) -> Vec<&'h Harm> {
    let (worst, others) = harms.split_at(harms.len().min(MOST_WORST));
    let left_m = |harm: &&Harm| {
        let within_m = history.seen[harm.instant].within_m;
        (0..2).map(|n| within_m[n] - history.fields[n].least(harm.xy_m, 0.0)).fold(f64::INFINITY, f64::min)
    };
    let mut easy: Vec<&Harm> = others.iter().collect();
    easy.sort_by(|a, b| left_m(b).total_cmp(&left_m(a)));
    worst.iter().chain(easy.into_iter().take(MOST_EASY)).collect()
}

/// One of some harms that a run of its own shows, and the walk to it: from where people get to with no sensor seeing them that the robots
/// heed.
fn shown(
    prepared: &Prepared,
    search: &Search<'_>,
    first: &[bool],
    (history, way): (&History, &ReadingTransition),
    alike: &[Harm],
) -> Option<(Harm, WalkIn, Finding)> {
    let cell = &*prepared.cell;
    let is_unseen = way.unchanged && way.pressed.is_none();
    let heeds: Vec<bool> = history.readings.iter().map(Option::is_some).collect();
    let comes = |xy_m: [f64; 2], heeds: &[bool]| search.comes_to(xy_m, heeds);
    // Who walks in is seen where they are harmed; they do get there.
    let none = vec![false; heeds.len()];
    let there = if is_unseen { &heeds } else { &none };
    let reached: Vec<Harm> = alike.iter().copied().filter(|harm| comes(harm.xy_m, there)).collect();
    let ways = |harm: &Harm| {
        let step = history.seen[harm.instant].step;
        // Standing there until arms are anywhere, for a whole action before, or where that is hit otherwise first for the last step.
        let standing = || {
            let before = cell.raising_steps().into_iter().chain([cell.steps_per_action, 1]);
            before.map(|before| WalkIn::standing(harm, step, before, cell.steps_per_action)).collect()
        };
        if !history.seen[harm.instant].story.pressed.is_empty() {
            control_walks::all(prepared, search, first, (history, harm), standing)
        } else if is_unseen {
            standing()
        } else {
            WalkIn::all(search, cell, first, history, harm)
        }
    };
    let unseen = is_unseen.then_some(first);
    let mut tried = 0;
    for harm in shown_first(history, &reached) {
        let left = MOST_RUNS.saturating_sub(tried).min(MOST_WALKS);
        if left == 0 {
            break;
        }
        let begun = ways(harm).into_iter().filter(|way| comes(way.xy_m, &heeds));
        let found = begun.take(left).find_map(|way| {
            tried += 1;
            shown_by(prepared, &way, unseen).map(|finding| (*harm, way, finding))
        });
        if found.is_some() {
            return found;
        }
    }
    None
}
