//! What a scan looks for, as its settings say: whether a later scan would have told a hazard that an earlier one did. A hazard
//! that is not looked for any more is not fixed.

use serde::Deserialize;

use super::criteria::{CriteriaRecord, judges, tells_all};
use super::model::{Hazard, Settings};
use super::people::SecondRecord;
use super::worked::ControlRecord;
use crate::cell::file::format::{ControlKind, ControlledBy};
use crate::hazard::{Class, Criterion};
use crate::human::Ability;

/// The settings that decide what is told.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub struct Looks {
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
}

impl From<&Settings> for Looks {
    fn from(settings: &Settings) -> Self {
        Self {
            speed_criterion: settings.speed_criterion,
            criteria: settings.criteria.clone(),
            arm_speed_m_s: settings.arm_speed_m_s,
            held_m: settings.held_m,
            also: settings.also.clone(),
            run_m_s: settings.run_m_s,
            second: settings.second.clone(),
            controls: settings.controls.clone(),
            actions_per_sequence: settings.actions_per_sequence,
            contact_check_interval_s: settings.contact_check_interval_s,
            reach_tolerance_m: settings.reach_tolerance_m,
            until_s: settings.until_s,
            presses: settings.presses,
        }
    }
}

impl Looks {
    /// Of the settings in a `scan.json`; none if they do not say.
    #[must_use]
    pub fn of(settings: &serde_json::Map<String, serde_json::Value>) -> Option<Self> {
        serde_json::from_value(serde_json::Value::Object(settings.clone())).ok()
    }

    /// Whether a contact that was a hazard of this class by what `earlier` looked for is one by this. Terms that describe the
    /// machine (how far something gets in unseen, how far a robot goes on) may differ: they are what is changed in a cell.
    #[must_use]
    pub fn judges_as_strictly_as(&self, earlier: &Self, class: Class) -> bool {
        let (mine, its) = (self.criteria.as_ref(), earlier.criteria.as_ref());
        let by_force = |looks: &Self| match &looks.criteria {
            Some(criteria) => criteria.transient_force,
            None => Some(looks.speed_criterion),
        };
        judges(mine, class)
            && match class {
                // The force by the robot's own speed and by the speed of approach: neither is always the larger one.
                Class::Force | Class::HeadContact => by_force(self) == by_force(earlier),
                Class::Clamping | Class::Pressure => true,
                Class::MovingContact => {
                    let from = |of: Option<&CriteriaRecord>| of.and_then(|of| of.moving_contact_faster_than_m_s);
                    from(mine) <= from(its)
                }
                Class::Separation => {
                    let terms = |of: Option<&CriteriaRecord>| of.and_then(|of| of.separation.clone());
                    terms(mine).map(|terms| terms.approach_m_s) >= terms(its).map(|terms| terms.approach_m_s)
                }
            }
    }

    /// Whether all controls that are worked on the way to a hazard of `earlier` are worked here too, under the same numbers, in the
    /// same way, and at least as often: what anyone works at any moment, the person does too.
    #[must_use]
    pub fn works_as_much_as(&self, earlier: &Self, hazard: &Hazard) -> bool {
        let sequences = [&hazard.actions, &hazard.shortest.actions];
        let mut worked = sequences.into_iter().flatten().flat_map(|action| action.presses().numbers()).peekable();
        // From one beginning there is no limit; from anywhere there is.
        let as_often = worked.peek().is_none() || self.until_s.is_none() || self.presses >= earlier.presses;
        as_often && worked.all(|control| self.works(earlier, control))
    }

    /// Whether arms are as fast here, or anywhere at once.
    #[must_use]
    pub fn reaches_as_fast_as(&self, earlier: &Self) -> bool {
        self.arm_speed_m_s.is_none_or(|mine| earlier.arm_speed_m_s.is_some_and(|its| mine >= its))
    }

    /// Whether the people do the same here, and a second one begins at the same place. What somebody can do matters for every hazard,
    /// not only for those on the way to which it is done: who may be below a light curtain is not held back by it.
    #[must_use]
    pub fn does_the_same_as(&self, earlier: &Self) -> bool {
        let beside = match (&self.second, &earlier.second) {
            (Some(mine), Some(its)) => mine.does_the_same_as(its),
            (None, None) => true,
            _ => false,
        };
        let own = |looks: &Self| (looks.run_m_s, looks.held_m);
        beside && self.also == earlier.also && own(self) == own(earlier)
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

    /// Whether a scan that accounted for every sequence, and found hazards of these classes, would have told this hazard of an
    /// earlier scan if it were still there.
    #[must_use]
    pub fn would_tell(&self, earlier: &Self, hazard: &Hazard, found: impl Iterator<Item = Class>) -> bool {
        let long_enough = match (self.until_s, earlier.until_s) {
            (None, None) => self.actions_per_sequence as usize >= hazard.shortest.actions.len(),
            (Some(mine), Some(its)) => mine >= its,
            // One is about people from anywhere, the other about one beginning.
            _ => false,
        };
        long_enough
            && self.contact_check_interval_s <= earlier.contact_check_interval_s
            && self.reach_tolerance_m <= earlier.reach_tolerance_m
            && self.reaches_as_fast_as(earlier)
            && self.does_the_same_as(earlier)
            && self.works_as_much_as(earlier, hazard)
            && self.judges_as_strictly_as(earlier, hazard.class)
            && tells_all(self.criteria.as_ref(), hazard.class, found)
    }
}

#[cfg(test)]
mod tests {
    use super::super::criteria::SeparationTerms;
    use super::*;

    fn looks() -> Looks {
        let separation = SeparationTerms {
            stop: None,
            intrusion_m: 0.2,
            person_uncertainty_m: 0.0,
            robot_uncertainty_m: 0.0,
            approach_m_s: 1.6,
        };
        Looks {
            speed_criterion: Criterion::Absolute,
            criteria: Some(CriteriaRecord {
                transient_force: Some(Criterion::Absolute),
                clamping: None,
                pressure: true,
                moving_contact_faster_than_m_s: Some(0.1),
                separation: Some(separation),
            }),
            arm_speed_m_s: Some(2.0),
            held_m: None,
            also: Vec::new(),
            run_m_s: None,
            second: None,
            controls: Vec::new(),
            actions_per_sequence: 8,
            contact_check_interval_s: 0.02,
            reach_tolerance_m: 0.02,
            until_s: None,
            presses: None,
        }
    }

    #[test]
    fn whoever_does_other_things_is_another_person() {
        let with = |also: &[Ability], run_m_s| Looks { also: also.to_vec(), run_m_s, ..looks() };
        let (walks, crawls) = (with(&[], None), with(&[Ability::Crawl], None));
        let runs = |fast| with(&[Ability::Run], Some(fast));
        for (after, before, same) in [
            (&walks, &walks, true),
            (&crawls, &crawls, true),
            (&walks, &crawls, false),
            (&crawls, &walks, false),
            (&runs(3.2), &runs(3.2), true),
            (&runs(4.8), &runs(3.2), false),
            (&Looks { held_m: Some(0.3), ..looks() }, &walks, false),
        ] {
            assert_eq!(after.does_the_same_as(before), same, "{after:?} {before:?}");
        }
    }

    #[test]
    fn slower_arms_reach_less() {
        let with = |arm_speed_m_s| Looks { arm_speed_m_s, ..looks() };
        for (after, before, as_fast) in [
            (None, None, true),
            (None, Some(2.0), true),
            (Some(2.0), Some(2.0), true),
            (Some(3.0), Some(2.0), true),
            (Some(1.6), Some(2.0), false),
            (Some(2.0), None, false),
        ] {
            assert_eq!(with(after).reaches_as_fast_as(&with(before)), as_fast, "{after:?} {before:?}");
        }
    }

    /// A control counts as worked if it is the same, and whoever worked it before may still.
    #[test]
    fn what_is_worked_less_is_not_told() {
        use ControlledBy::{Anyone, Nobody, Person};
        let with = |name: &str, by, kind| Looks {
            controls: vec![ControlRecord {
                name: name.to_owned(),
                by,
                kind,
                pressed_steps: (kind == ControlKind::Momentary).then_some(10),
                door: false,
            }],
            ..looks()
        };
        let momentary = |by| with("reset", by, ControlKind::Momentary);
        for (before, after, works) in [
            (Person, Person, true),
            (Person, Anyone, true),
            (Anyone, Anyone, true),
            (Anyone, Person, false),
            (Person, Nobody, false),
            (Anyone, Nobody, false),
        ] {
            assert_eq!(momentary(after).works(&momentary(before), 0), works, "{before:?} {after:?}");
        }
        assert!(!with("mode", Person, ControlKind::Momentary).works(&momentary(Person), 0));
        assert!(!with("reset", Person, ControlKind::Held).works(&momentary(Person), 0));
        // The same time in half as long steps is the same; a shorter one is not, nor one of which nothing is said.
        for (pressed_steps, step_s, works) in
            [(Some(10), 0.02, true), (Some(20), 0.01, true), (Some(10), 0.01, false), (None, 0.02, false)]
        {
            let mut after = Looks { contact_check_interval_s: step_s, ..momentary(Person) };
            after.controls[0].pressed_steps = pressed_steps;
            assert_eq!(after.works(&momentary(Person), 0), works, "{pressed_steps:?} {step_s}");
        }
        assert!(with("mode", Person, ControlKind::Held).works(&with("mode", Person, ControlKind::Held), 0));
        assert!(!looks().works(&momentary(Person), 0) && !momentary(Person).works(&momentary(Person), 1));
    }

    /// Each criterion, loosened by itself, says nothing of its own hazards any more and as much as before of the others.
    #[test]
    fn what_is_judged_more_loosely_is_not_told() {
        const ALL: [Class; 6] = [
            Class::Force,
            Class::HeadContact,
            Class::Clamping,
            Class::Pressure,
            Class::MovingContact,
            Class::Separation,
        ];
        type Loosen = fn(&mut CriteriaRecord);
        let cases: [(Loosen, &[Class]); 6] = [
            (|c| c.transient_force = Some(Criterion::Approach), &[Class::Force, Class::HeadContact]),
            (|c| c.transient_force = None, &[Class::Force, Class::HeadContact]),
            (|c| c.pressure = false, &[Class::Pressure]),
            (|c| c.moving_contact_faster_than_m_s = Some(0.5), &[Class::MovingContact]),
            (|c| c.separation.as_mut().unwrap().approach_m_s = 0.5, &[Class::Separation]),
            (|c| c.separation.as_mut().unwrap().intrusion_m = 0.1, &[]),
        ];
        let before = looks();
        for (loosen, lost) in cases {
            let mut after = looks();
            loosen(after.criteria.as_mut().unwrap());
            for class in ALL.into_iter().filter(|class| *class != Class::Clamping) {
                assert_eq!(after.judges_as_strictly_as(&before, class), !lost.contains(&class), "{class:?} {after:?}");
            }
        }
        // Stricter is strict enough, without a record as with one.
        let mut after = looks();
        after.criteria.as_mut().unwrap().moving_contact_faster_than_m_s = Some(0.0);
        assert!(ALL.iter().all(|class| after.judges_as_strictly_as(&before, *class) || *class == Class::Clamping));
        let plain = |speed_criterion| Looks { criteria: None, speed_criterion, ..looks() };
        let [absolute, approach] = [Criterion::Absolute, Criterion::Approach].map(plain);
        assert!(absolute.judges_as_strictly_as(&before, Class::Force));
        assert!(!approach.judges_as_strictly_as(&before, Class::Force));
        assert!(!approach.judges_as_strictly_as(&absolute, Class::HeadContact));
    }
}
