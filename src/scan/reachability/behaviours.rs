//! Where people may come and go again and again: the few behaviours of an FMU in place of its many histories, which they stand for if
//! it remembers nothing that does not show in time. That is tried out by walks, and is for the user to accept.

use super::super::accepted_for::fmu_digest;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::Instant;

use super::{AnalysisContext, AnalysisEvent, EventSink, SEED};
use crate::host::{Hosted, PlantError, Policy};
use crate::obligations::readings::like;
use crate::obligations::{Assumption, Point};
use crate::reachability::History;
use crate::reachability::ReachabilitySearch as Search;
use crate::reachability::held::{HeldReadings, distinguished};
use crate::reachability::instants::{Instants, RobotGroup};
use crate::reachability::of_behaviours::seen_by;
use crate::reachability::reading_regions::{ReadingRegions, Readings};
use crate::reachability::reduced::{MayBeOff, Nearly};
use crate::record::figures::grouped;
use crate::scan::execution::ExecutionMode;
use crate::scan::prepare::Prepared;
use crate::search::Rng;
use crate::search::behaviours::answers::{STATES, answered_alike};
use crate::search::behaviours::decided::{
    AHEAD_S, Decided, DecisionLimits, Enough, LONGER_WALKS, Now, TIMES_HELD, Why, decide_keeping,
};
use crate::search::behaviours::stays::Stays;
use crate::search::behaviours::{Behaviours, Number, longest};
use crate::sim::motion::Motion;
use crate::sim::sensors::SensorTarget;
use crate::standards::iso_13855::WALKING_SPEED_M_S;

/// Most behaviours, where more states are not asked for.
const MOST: usize = 200_000;
/// They are looked for in this part of the time that is left, and in this one where it is accepted what they rest on.
const SHARE: u32 = 5;
const ACCEPTED_SHARE: u32 = 2;
/// Readings that are answered alike are looked for in this part of it.
const ALIKE_SHARE: u32 = 20;
/// What stands for others is no farther from them, m, slower by no more, m/s, and people have come no less far by more, m.
const NEARLY: Nearly = Nearly { apart_m: 0.01, faster_m_s: 0.03, farther_m: 0.05 };
/// Stays are told apart up to this at least, s.
const STAYS_S: f64 = 1.0;

/// What the robots do whoever comes and goes, in place of histories.
pub(super) struct Few {
    pub zones: ReadingRegions,
    /// By way: at the instants, and with what is between them.
    pub histories: Vec<(History, History)>,
    pub motion: Motion,
    /// Whether they only nearly stand for it.
    pub is_net: bool,
    /// Why they do not stand for all: only hazards follow from them then.
    pub only_hazards: Option<NotAll>,
    /// What was tried out, and whether the cell file accepts what that leaves.
    pub tried: Vec<Point>,
    pub is_accepted: bool,
    /// Which sensors matter.
    matter: Vec<bool>,
    stays: Stays,
}

/// What stands for all that an FMU may do.
pub(super) struct Stands {
    pub found: Behaviours,
    /// What that assumes, and what was tried.
    pub assumption: Assumption,
    pub tried: String,
    /// All may be off by so much.
    pub off: MayBeOff,
    /// Whether what is shown is numbered by what robots do.
    pub is_net: bool,
    /// Why it does not stand for all.
    pub not_all: Option<NotAll>,
}

/// Why some of what an FMU may do does not stand for all.
pub(super) struct NotAll {
    pub why: String,
    /// Whether that is because it remembers something that does not show in time.
    pub remembers: bool,
}

impl Stands {
    /// Some of what it may do: histories all the same, of which some may be hazards.
    pub(super) fn not_all(found: Behaviours, is_net: bool, not_all: NotAll) -> Self {
        let assumption = Assumption::MemoryShows { within_ms: 0 };
        Self { found, assumption, tried: String::new(), off: MayBeOff::default(), is_net, not_all: Some(not_all) }
    }

    /// The outputs of what a behaviour shows.
    fn outputs<'a>(&self, machine: &'a HeldReadings<'_, Hosted>, number: Number) -> &'a [f64] {
        let shown = self.found.shown(number);
        if self.is_net { machine.nearly(shown) } else { machine.outputs(shown) }
    }
}

/// Why there are none.
pub(super) enum Refused {
    /// Told to end.
    Stopped,
    /// In words.
    Because(String),
    /// It remembers something that does not show in time, in words.
    Remembers(String),
}

impl Few {
    /// A history that leads to a behaviour on a way with such a stay: what the FMU is told, by number, and for how many steps each.
    pub(crate) fn history(&self, number: Number, way: usize, steps: usize) -> Vec<(usize, usize)> {
        let ways = self.stays.history(number, way, steps);
        ways.into_iter().map(|(way, steps)| (self.zones.ways[way].to, steps)).collect()
    }

    /// The number of what the FMU is told of these readings, if they are among those that people can come to.
    pub(crate) fn told(&self, readings: &Readings) -> Option<usize> {
        let first = &self.zones.readings[0];
        let as_first = |((own, matters), first): ((&bool, &bool), &bool)| if *matters { *own } else { *first };
        self.zones.number(&readings.iter().zip(&self.matter).zip(first).map(as_first).collect())
    }
}

impl AnalysisContext<'_> {
    /// The behaviours of the FMU that matter to the robots of one part.
    pub(super) fn behaviours(
        &mut self,
        (there, footing): (&Prepared, ExecutionMode),
        (search, part, first): (&Search<'_>, &RobotGroup, &[bool]),
        person: &dyn Fn(&Readings) -> SensorTarget,
        tell: &mut EventSink<'_>,
    ) -> BehaviourResult<Few> {
        let (cell, binding) = (&there.cell, &there.binding);
        if self.found.presses.is_some_and(|presses| presses > 0) {
            return because("controls are worked".to_owned());
        }
        if matches!(footing.policy(there), Policy::Replay | Policy::States { max_checkpoints: 0 }) {
            return because("the FMU cannot save its states".to_owned());
        }
        let step_m = WALKING_SPEED_M_S * cell.step_s;
        let told = |all: &[Readings]| {
            let people: Vec<SensorTarget> = all.iter().map(person).collect();
            distinguished((cell, binding), all, &people)
        };
        let by_sides = |told: &dyn Fn(&[Readings]) -> Vec<usize>| {
            ReadingRegions::by_sides(search, first, &part.sensors, step_m, told)
        };
        let Some(zones) = by_sides(&told) else { return Ok(Err(Refused::Stopped)) };
        // Of these readings those that count as one.
        let of_zones = |zones: &ReadingRegions, all: &[Readings]| {
            let people = zones.readings.iter().map(person).collect();
            let mut alike: Vec<Vec<Readings>> = vec![Vec::new(); zones.readings.len()];
            for readings in all {
                alike[zones.number(readings).unwrap_or_default()].push(readings.clone());
            }
            HeldReadings::new(footing.plant(there), (cell, binding), (alike, zones.others()), people)
        };
        let mut machine = of_zones(&zones, &zones.readings);
        let alike = self.answered_alike(&mut machine)?;
        if let Some(alike) = alike.filter(|_| cell.pose.is_empty()) {
            let number = |readings: &Readings| zones.number(readings).map_or(usize::MAX, |number| alike[number]);
            let told = |all: &[Readings]| all.iter().map(number).collect();
            let all = zones.readings.clone();
            let Some(zones) = by_sides(&told) else { return Ok(Err(Refused::Stopped)) };
            let fewer = Some(self.are_alike(&all, &alike));
            let found = self.few((there, part), (&zones, fewer, &mut of_zones(&zones, &all)), tell)?;
            // Where walks show that not all are answered alike after all, they are told apart.
            if !matches!(
                &found,
                Err(Refused::Remembers(_)) | Ok(Few { only_hazards: Some(NotAll { remembers: true, .. }), .. })
            ) {
                return Ok(found);
            }
        }
        self.few((there, part), (&zones, None, &mut machine), tell)
    }

    /// Readings that the FMU answers alike, by the first of them; nothing where there are none, or no time to see that.
    fn answered_alike(&self, machine: &mut HeldReadings<'_, Hosted>) -> Result<Option<Vec<usize>>, PlantError> {
        let ahead = steps_of(AHEAD_S[0], self.prepared.cell.step_s);
        let ends_at = self.prepared.stop().left().map(|left| Instant::now() + left / ALIKE_SHARE);
        let mut goes_on = || ends_at.is_none_or(|ends_at| Instant::now() < ends_at);
        let alike = answered_alike(machine, &mut Rng::new(SEED), (self.steps(), ahead), &mut goes_on)?;
        Ok(alike.filter(|alike| alike.iter().enumerate().any(|(own, first)| own != *first)))
    }

    /// Which readings are answered alike, and what was tried of it.
    fn are_alike(&self, all: &[Readings], alike: &[usize]) -> (Assumption, String) {
        let sensors = &self.prepared.cell.sensors;
        let named = |readings: &Readings| {
            let names = sensors.iter().zip(readings).filter(|(_, reports)| **reports);
            names.map(|(sensor, _)| sensor.name.as_str()).collect::<Vec<_>>()
        };
        let others = alike.iter().enumerate().filter(|(own, first)| own != *first);
        let others: Vec<String> = others.map(|(own, first)| like(&named(&all[own]), &named(&all[*first]))).collect();
        let tried = format!(
            "of {} that may come together {} are told apart ({}), from {STATES} states it did the same for {:.0} s, and in all walks",
            all.len(),
            all.len() - others.len(),
            others.join(", "),
            AHEAD_S[0]
        );
        (Assumption::ReadingsAlike { readings: others }, tried)
    }

    /// The behaviours in these zones; what was tried out of readings that are answered alike, where some are.
    fn few(
        &mut self,
        (there, part): (&Prepared, &RobotGroup),
        (zones, alike, machine): (&ReadingRegions, Option<(Assumption, String)>, &mut HeldReadings<'_, Hosted>),
        tell: &mut EventSink<'_>,
    ) -> BehaviourResult<Few> {
        let (cell, binding) = (&there.cell, &there.binding);
        let step_m = WALKING_SPEED_M_S * cell.step_s;
        let before = machine.taken;
        let found = self.find(machine, &part.links, tell)?;
        self.found.spent.fmu_steps += machine.taken - before;
        let stands = match found {
            Ok(stands) => stands,
            Err(refused) => return Ok(Err(refused)),
        };
        let longest = zones.longest(step_m).max(steps_of(STAYS_S, cell.step_s));
        let stays = Stays::find(&stands.found, zones, u32::try_from(longest).unwrap_or(u32::MAX));
        let mut instants = Instants::new((cell, binding), zones, part).that_are_off(stands.off.clone());
        let stop = self.prepared.stop();
        let outputs = |number: Number| stands.outputs(machine, number);
        let seen = seen_by(&mut instants, &stands.found, (&stays, zones), (&outputs, !stands.is_net), &stop);
        if seen.is_none() {
            return Ok(Err(Refused::Stopped));
        }
        let Some(histories) = instants.reduced(NEARLY, &stop) else { return Ok(Err(Refused::Stopped)) };
        let motion = instants.motion().clone();
        let (accepted, fmu) = (&self.prepared.cell.accepted, fmu_digest(&self.prepared.subject));
        let tried: Vec<(Assumption, String)> = [(stands.assumption, stands.tried)].into_iter().chain(alike).collect();
        let is_accepted = tried.iter().all(|(assumption, _)| self.accepts(|one| one.covers(assumption)));
        let tried = tried.iter().map(|(assumption, tried)| Point::tried(assumption, tried, accepted, &fmu)).collect();
        Ok(Ok(Few {
            zones: zones.clone(),
            histories,
            motion,
            tried,
            is_accepted,
            matter: part.sensors.clone(),
            stays,
            is_net: stands.is_net,
            only_hazards: stands.not_all,
        }))
    }

    fn accepts(&self, is: impl Fn(&Assumption) -> bool) -> bool {
        self.prepared.cell.accepted.iter().any(|one| is(&one.assumption))
    }

    fn accepts_memory(&self) -> bool {
        self.accepts(|one| matches!(one, Assumption::MemoryShows { .. }))
    }

    /// All behaviours, if walks show no others; what that assumes, and what was tried. Some of them, where there are some, if they do.
    fn find(
        &mut self,
        machine: &mut HeldReadings<'_, Hosted>,
        links: &Arc<[bool]>,
        tell: &mut EventSink<'_>,
    ) -> BehaviourResult<Stands> {
        // Whoever accepts the one and not the other has seen that it takes that.
        if self.accepts(|one| matches!(one, Assumption::NearlyAlike { .. })) && !self.accepts_memory() {
            match self.nearly(machine, links, tell)? {
                Ok(Stands { not_all: Some(_), .. }) | Err(Refused::Because(_) | Refused::Remembers(_)) => {}
                outcome => return Ok(outcome),
            }
        }
        let mut kept = None;
        let some = |kept: Option<Behaviours>, why: String, remembers: bool| match kept {
            Some(found) => Ok(Ok(Stands::not_all(found, false, NotAll { why, remembers }))),
            None => because(why),
        };
        let exactly = match self.exactly(machine, (&mut kept, tell))? {
            Err(Refused::Because(why)) => why,
            // What is nearly the same does not stand for it either.
            Err(Refused::Remembers(why)) => return some(kept, why, true),
            outcome => return Ok(outcome),
        };
        Ok(match self.nearly(machine, links, tell)? {
            Err(Refused::Because(why)) => return some(kept, format!("{exactly}; and {why}"), false),
            Ok(mut stands) => {
                if let Some(not_all) = &mut stands.not_all {
                    not_all.why = format!("{exactly}; and {}", not_all.why);
                }
                Ok(stands)
            }
            outcome => outcome,
        })
    }

    /// The same of behaviours that are just the same.
    fn exactly(
        &mut self,
        machine: &mut HeldReadings<'_, Hosted>,
        (kept, tell): (&mut Option<Behaviours>, &mut EventSink<'_>),
    ) -> BehaviourResult<Stands> {
        let mut outcome = because(String::new());
        for times_held in TIMES_HELD {
            let most = self.effort.most_states.max(MOST);
            let question = DecisionLimits { step_s: self.prepared.cell.step_s, steps: self.steps(), most, times_held };
            let before = std::mem::replace(&mut outcome, self.held_for(machine, question, (kept, tell)));
            match (&outcome, before) {
                // What it remembers may show later.
                (Ok(Err(Refused::Remembers(_))), _) => {}
                // There is no room or time for that: what is nearly the same may do.
                (Ok(Err(Refused::Because(why))), Ok(Err(Refused::Remembers(before)))) => {
                    return because(format!("{before}; where each report is held {times_held} times as long, {why}"));
                }
                _ => break,
            }
        }
        outcome
    }

    /// The same of readings that are held for so long.
    fn held_for(
        &mut self,
        machine: &mut HeldReadings<'_, Hosted>,
        question: DecisionLimits,
        (kept, tell): (&mut Option<Behaviours>, &mut EventSink<'_>),
    ) -> BehaviourResult<Stands> {
        let DecisionLimits { step_s, most, .. } = question;
        let (mut told, mut ends_at) = (0_u32, None);
        let share = if self.accepts_memory() { ACCEPTED_SHARE } else { SHARE };
        let mut tell = |now| {
            let mut asked = false;
            match now {
                Now::Held => ends_at = self.prepared.stop().left().map(|left| Instant::now() + left / share),
                Now::Behaviours(count) => {
                    told += 1;
                    asked = told.is_multiple_of(8) && tell(AnalysisEvent::Behaviours(count, most)).is_break();
                    if !asked && ends_at.is_some_and(|ends_at| Instant::now() >= ends_at) {
                        return ControlFlow::Break(Enough::NotInTime);
                    }
                }
                Now::Walked(count) => asked = tell(AnalysisEvent::Behaviours(count, count)).is_break(),
            }
            if asked { ControlFlow::Break(Enough::Asked) } else { ControlFlow::Continue(()) }
        };
        let decided = decide_keeping(machine, question, &mut Rng::new(SEED), (kept, &mut tell))?;
        let Decided { behaviours, shows, held, walks } = match decided {
            Ok(decided) => decided,
            Err(Why::Asked) => return Ok(Err(Refused::Stopped)),
            Err(why @ (Why::RemembersMore { .. } | Why::ShowsLate)) => {
                return Ok(Err(Refused::Remembers(in_words(why, question))));
            }
            Err(why) => return because(in_words(why, question)),
        };
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some seconds")]
        let within_ms = (1000.0 * seconds(longest(&held), step_s)).ceil() as u32;
        let tried = format!(
            "{} behaviours stand for all histories, what shows latest shows after {:.2} s, each report was held for {}, and {walks} walks of \
             up to {:.0} s showed nothing else",
            grouped(&behaviours.count().to_string()),
            seconds(longest(&shows.steps), step_s),
            in_seconds(&held, step_s),
            seconds(LONGER_WALKS * self.steps(), step_s)
        );
        Ok(Ok(Stands {
            found: behaviours,
            assumption: Assumption::MemoryShows { within_ms },
            tried,
            off: MayBeOff::default(),
            is_net: false,
            not_all: None,
        }))
    }
}

/// Why behaviours do not stand for all histories.
pub(super) fn in_words(why: Why, DecisionLimits { step_s, most, .. }: DecisionLimits) -> String {
    match why {
        Why::ShowsLate => format!("what it remembers shows only after {:.1} s or later", AHEAD_S[1]),
        Why::HardlyEverSame { different, ends } => format!(
            "it seldom shows the same again once it was stopped: {different} of {ends} histories of what the sensors report ended in \
             different places"
        ),
        Why::TooMany => format!("it has more than {} behaviours", grouped(&most.to_string())),
        Why::NotInTime(count) => {
            format!("there was not time enough to find them, {} so far", grouped(&count.to_string()))
        }
        Why::Unfinished => "some steps could not be finished".to_owned(),
        Why::Asked => "it was to end".to_owned(),
        Why::RemembersMore { held, steps, changes, .. } => format!(
            "it remembers something that does not show within {:.2} s while what the sensors report stays the same: in a walk with {changes} \
             changes it did something else after {:.2} s",
            seconds(held, step_s),
            seconds(steps, step_s)
        ),
    }
}

/// What there is, or why there is none; an error of the FMU ends everything.
pub(super) type BehaviourResult<T> = Result<Result<T, Refused>, PlantError>;

pub(super) fn because<T>(why: String) -> BehaviourResult<T> {
    Ok(Err(Refused::Because(why)))
}

/// For how long reports are held, in words.
pub(super) fn in_seconds(held: &[usize], step_s: f64) -> String {
    let (least, most) = (held.iter().copied().min().unwrap_or_default(), longest(held));
    if least == most {
        return format!("{:.2} s", seconds(most, step_s));
    }
    format!("{:.2} to {:.2} s", seconds(least, step_s), seconds(most, step_s))
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some seconds")]
pub(super) fn steps_of(time_s: f64, step_s: f64) -> usize {
    (time_s / step_s - 1e-9).ceil().max(1.0) as usize
}

#[expect(clippy::cast_precision_loss, reason = "some thousand")]
pub(super) fn seconds(steps: usize, step_s: f64) -> f64 {
    steps as f64 * step_s
}
