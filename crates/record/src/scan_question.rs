//! What a scan looks for, as its settings say: whether a later scan would have told a hazard that an earlier one did. A hazard
//! that is not looked for any more is not fixed.
//!
//! Two kinds of things stand in a cell file. Some **describe the machine**: the FMU and its parameters, robots and their moving mass,
//! shapes, padding and surface of links, obstacles, sensors, what follows the FMU, how far robots go on after a contact or a stop
//! where the FMU itself shows it. These are what a repair changes: they are not compared here, and a hazard that is gone with them
//! is fixed. Others **ask the question**: who the people are, where and when they begin, what they do and work, what counts as
//! unsafe, for how long and how finely it is looked at. Where one of these asks for less than it did, nothing that is not found is
//! fixed. Terms of a criterion that the cell file states, and nothing measures, belong to the question, even those that describe a
//! machine (a stated stopping distance, the uncertainty of a position): nobody sees the machine change with them.
//!
//! Everything that a result says of its settings is taken apart here, so that something new does not build before it is decided
//! which of the two it is.

use serde::Deserialize;

use super::begin::InitialConditionRecord;
use super::criteria::{CriteriaRecord, judges, tells_all};
use super::hazard::Hazard;
use super::model::Settings;
use super::narrower::Narrower;
use super::operated::ControlRecord;
use super::people::{BodyRecord, SecondRecord};
use crate::human::{Ability, ControlKind, ControlledBy};
use fmi_hazard_criteria::{Class, Criterion};

/// The settings that decide what is told.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub struct ScanQuestion {
    /// Which speed makes the force that decides.
    #[serde(default)]
    pub speed_criterion: Criterion,
    /// What counts as unsafe, where that is more or other than the transient force.
    pub criteria: Option<CriteriaRecord>,
    /// How fast hands move, m/s, if arms take their time.
    pub arm_speed_m_s: Option<f64>,
    /// How far what the person holds reaches beyond the finger tips, m.
    pub held_m: Option<f64>,
    /// What the person does besides walking, bending and reaching.
    #[serde(default)]
    pub also: Vec<Ability>,
    /// How fast who runs does so, m/s.
    pub run_m_s: Option<f64>,
    /// A second person beside them.
    pub second: Option<SecondRecord>,
    /// Controls that are worked.
    #[serde(default)]
    pub controls: Vec<ControlRecord>,
    /// Actions in a sequence.
    pub actions_per_sequence: u32,
    /// Communication step and contact-check interval, s.
    pub contact_check_interval_s: f64,
    /// Depth of contact that the arm check may miss, m.
    pub reach_tolerance_m: f64,
    /// Of a scan from anywhere: until when, s.
    pub until_s: Option<f64>,
    /// And how often controls are worked at most.
    pub presses: Option<u32>,
    /// Of a scan from a start: where and when the person begins.
    pub begins: Option<InitialConditionRecord>,
    /// Of such a scan: the sensors that see somebody there already.
    #[serde(default)]
    pub seen_at_start: Vec<String>,
    /// The person's body.
    pub body: Option<BodyRecord>,
    /// Of a scan from anywhere: the floor that people may be on, if that is bounded.
    pub floor_m: Option<Vec<[f64; 2]>>,
    /// And where they come from, if that is not the outside.
    pub start_region_m: Option<Vec<[f64; 2]>>,
}

impl From<&Settings> for ScanQuestion {
    fn from(settings: &Settings) -> Self {
        let Settings {
            // How it was searched: whether that was enough, the certificate says.
            strategy: _,
            seed: _,
            iterations: _,
            stop_at_first: _,
            posture_sweep: _,
            // The same for all.
            action_s: _,
            actions_per_sequence,
            contact_check_interval_s,
            reach_tolerance_m,
            speed_criterion,
            criteria,
            arm_speed_m_s,
            held_m,
            also,
            run_m_s,
            second,
            controls,
            until_s,
            presses,
            begins,
            seen_at_start,
            body,
            floor_m,
            start_region_m,
        } = settings.clone();
        Self {
            speed_criterion,
            criteria,
            arm_speed_m_s,
            held_m,
            also,
            run_m_s,
            second,
            controls,
            actions_per_sequence,
            contact_check_interval_s,
            reach_tolerance_m,
            until_s,
            presses,
            begins,
            seen_at_start,
            body,
            floor_m,
            start_region_m,
        }
    }
}

impl ScanQuestion {
    /// Of the settings in a `scan.json`; none if they do not say.
    #[must_use]
    pub(crate) fn of(settings: &serde_json::Map<String, serde_json::Value>) -> Option<Self> {
        serde_json::from_value(serde_json::Value::Object(settings.clone())).ok()
    }

    /// Takes what it does not say of where the person begins, and of the body, from what another says of the same cell file. Which of
    /// several beginnings it was, both would say.
    pub fn or_of(&mut self, other: &Self) {
        if self.until_s.is_none() {
            self.begins = self.begins.or(other.begins);
        }
        self.body = self.body.or(other.body);
        if let (Some(mine), Some(its)) = (&mut self.second, &other.second) {
            mine.body = mine.body.or(its.body);
        }
        if let (Some(mine), Some(its)) = (&mut self.criteria, &other.criteria)
            && let (Some(mine), Some(its)) = (&mut mine.separation, &its.separation)
        {
            mine.stated = mine.stated.or(its.stated);
        }
    }

    /// Why a hazard of `earlier`, run here again from where it began then with the body that the person had then, may not be told
    /// though it is there; nothing if it would be told.
    #[must_use]
    pub fn judges_less(&self, earlier: &Self, hazard: &Hazard) -> Option<Narrower> {
        let Self {
            speed_criterion: _,
            criteria: _,
            arm_speed_m_s: _,
            held_m: _,
            also: _,
            run_m_s: _,
            second: _,
            controls: _,
            contact_check_interval_s,
            reach_tolerance_m,
            presses: _,
            // Of sequences that are run as they were recorded, from where they were: the same, whatever the cell says.
            actions_per_sequence: _,
            until_s: _,
            begins: _,
            seen_at_start: _,
            body: _,
            floor_m: _,
            start_region_m: _,
        } = self;
        self.judges_more_loosely(earlier, hazard.class)
            .or_else(|| (!self.reaches_as_fast_as(earlier)).then_some(Narrower::Arms))
            .or_else(|| self.does_otherwise(earlier))
            .or_else(|| self.works_less(earlier, hazard))
            .or_else(|| (*contact_check_interval_s > earlier.contact_check_interval_s).then_some(Narrower::Interval))
            .or_else(|| (*reach_tolerance_m > earlier.reach_tolerance_m).then_some(Narrower::Tolerance))
    }

    /// Why a scan that accounted for everything, and found hazards of these classes, may not have told this hazard of an earlier
    /// scan though it is still there; nothing if it would have.
    #[must_use]
    pub fn narrower(&self, earlier: &Self, hazard: &Hazard, found: impl Iterator<Item = Class>) -> Option<Narrower> {
        let when = |narrower: bool, what: Narrower| narrower.then_some(what);
        self.begins_otherwise(earlier)
            .or_else(|| when(!self.is_as_long(earlier, hazard), Narrower::Horizon))
            .or_else(|| when(self.body != earlier.body, Narrower::Body))
            .or_else(|| self.judges_less(earlier, hazard))
            .or_else(|| when(!tells_all(self.criteria.as_ref(), hazard.class, found), Narrower::Hidden))
    }

    /// Where and when people begin, and the floor that they may be on.
    fn begins_otherwise(&self, earlier: &Self) -> Option<Narrower> {
        if self.until_s.is_some() != earlier.until_s.is_some() {
            return Some(Narrower::FromElsewhere);
        }
        // A body is told by every version that tells where people begin.
        let told = |looks: &Self| looks.body.is_some() && (looks.until_s.is_some() || looks.begins.is_some());
        if !told(self) || !told(earlier) {
            return Some(Narrower::NotRecorded);
        }
        let begins = |looks: &Self| looks.begins.map(|begins| begins.bits());
        let floor = |looks: &Self| (looks.floor_m.clone(), looks.start_region_m.clone());
        if begins(self) != begins(earlier) {
            return Some(Narrower::Beginning);
        }
        if floor(self) != floor(earlier) {
            return Some(Narrower::Floor);
        }
        // Who begins on a mat meets a robot that stands, which shows nothing.
        let sensor = self.seen_at_start.iter().find(|sensor| !earlier.seen_at_start.contains(sensor))?;
        Some(Narrower::SeenAtStart { sensor: sensor.clone() })
    }

    fn is_as_long(&self, earlier: &Self, hazard: &Hazard) -> bool {
        match (self.until_s, earlier.until_s) {
            (Some(mine), Some(its)) => mine >= its,
            _ => self.actions_per_sequence as usize >= hazard.shortest.actions.len(),
        }
    }

    /// Why a contact that was a hazard of this class by what `earlier` looked for may be none by this.
    fn judges_more_loosely(&self, earlier: &Self, class: Class) -> Option<Narrower> {
        let (mine, its) = (self.criteria.as_ref(), earlier.criteria.as_ref());
        if !judges(mine, class) {
            return Some(Narrower::Criterion { class });
        }
        let by_force = |looks: &Self| match &looks.criteria {
            Some(criteria) => criteria.transient_force,
            None => Some(looks.speed_criterion),
        };
        match class {
            // The force by the robot's own speed and by the speed of approach: neither is always the larger one.
            Class::Force | Class::HeadContact => (by_force(self) != by_force(earlier)).then_some(Narrower::Speed),
            Class::Pressure => None,
            Class::Clamping => {
                let clamping = |of: Option<&CriteriaRecord>| of.and_then(|of| of.clamping.clone());
                let shorter = clamping(mine).zip(clamping(its)).is_some_and(|(mine, its)| mine.is_looser_than(&its));
                shorter.then_some(Narrower::Travel)
            }
            Class::MovingContact => {
                let from = |of: Option<&CriteriaRecord>| of.and_then(|of| of.moving_contact_faster_than_m_s);
                (from(mine) > from(its)).then_some(Narrower::MovingContact)
            }
            Class::Separation => {
                let terms = |of: Option<&CriteriaRecord>| of.and_then(|of| of.separation.clone());
                let term = terms(mine)?.looser_than(&terms(its)?)?;
                Some(Narrower::Separation { term: term.to_owned() })
            }
        }
    }

    /// Which of the controls that are worked on the way to a hazard of `earlier` is missing here, is another under its number, or is
    /// worked otherwise, or less often: what anyone works at any moment, the person does too.
    fn works_less(&self, earlier: &Self, hazard: &Hazard) -> Option<Narrower> {
        let sequences = [&hazard.actions, &hazard.shortest.actions];
        let mut worked = sequences.into_iter().flatten().flat_map(|action| action.presses().numbers()).peekable();
        // From one beginning there is no limit; from anywhere there is.
        let as_often = worked.peek().is_none() || self.until_s.is_none() || self.presses >= earlier.presses;
        if !as_often {
            return Some(Narrower::Presses);
        }
        let other = worked.find(|control| !self.works(earlier, *control))?;
        let its = earlier.controls.get(other);
        let control = its.map_or_else(|| (other + 1).to_string(), |its| its.name.clone());
        let there =
            self.controls.get(other).is_some_and(|mine| mine.name == control && mine.by != ControlledBy::Nobody);
        Some(if there { Narrower::ControlOtherwise { control } } else { Narrower::ControlMissing { control } })
    }

    /// Whether arms are as fast here, or anywhere at once.
    #[must_use]
    pub(crate) fn reaches_as_fast_as(&self, earlier: &Self) -> bool {
        self.arm_speed_m_s.is_none_or(|mine| earlier.arm_speed_m_s.is_some_and(|its| mine >= its))
    }

    /// Whether the people do something else here, or a second one begins elsewhere. What somebody can do matters for every hazard,
    /// not only for those on the way to which it is done: who may be below a light curtain is not held back by it.
    fn does_otherwise(&self, earlier: &Self) -> Option<Narrower> {
        let beside = match (&self.second, &earlier.second) {
            (Some(mine), Some(its)) => mine.does_the_same_as(its),
            (None, None) => true,
            _ => false,
        };
        if !beside {
            return Some(Narrower::Second);
        }
        let own = |looks: &Self| (looks.also.clone(), looks.run_m_s, looks.held_m);
        (own(self) != own(earlier)).then_some(Narrower::Abilities)
    }

    fn works(&self, earlier: &Self, control: usize) -> bool {
        let [mine, its] = [self, earlier].map(|looks| looks.controls.get(control));
        mine.zip(its).is_some_and(|(mine, its)| {
            let as_often = mine.by == its.by || mine.by == ControlledBy::Anyone;
            // An input that waits for an edge, or for it to last, tells a shorter press from a longer one.
            #[expect(clippy::cast_precision_loss, reason = "at most 200")]
            let lasts = |looks: &Self, control: &ControlRecord| {
                control.pressed_steps.map(|steps| steps as f64 * looks.contact_check_interval_s)
            };
            let as_long = match (lasts(self, mine), lasts(earlier, its)) {
                (Some(mine), Some(its)) => (mine - its).abs() < 1e-6,
                (None, None) => mine.kind != ControlKind::Momentary,
                _ => false,
            };
            (&mine.name, mine.kind) == (&its.name, its.kind) && as_often && as_long
        })
    }
}

#[cfg(test)]
#[path = "scan_question_tests.rs"]
mod tests;
