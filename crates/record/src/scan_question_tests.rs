//! Tests of `scan_question`.

use super::*;
use crate::criteria::{ClampingRecord, SeparationTerms, StatedStop};
use crate::fixtures;
use crate::human::Radii;
use crate::standards::anthropometry::Sex;

fn looks() -> ScanQuestion {
    let separation = SeparationTerms {
        stop: None,
        stated: Some(StatedStop { reaction_s: 0.1, stop_time_s: 0.3, stop_distance_m: 0.2 }),
        intrusion_m: 0.2,
        person_uncertainty_m: 0.0,
        robot_uncertainty_m: 0.0,
        approach_m_s: 1.6,
    };
    ScanQuestion {
        speed_criterion: Criterion::Absolute,
        criteria: Some(CriteriaRecord {
            transient_force: Some(Criterion::Absolute),
            clamping: Some(ClampingRecord { contact_signal: None, travel_after_contact_m: 0.05 }),
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
        begins: Some(InitialConditionRecord { xy_m: [0.2, -1.9], heading_deg: 90.0, begins_s: 0.0 }),
        seen_at_start: Vec::new(),
        body: Some(BodyRecord {
            sex: Sex::Man,
            percentile: 50,
            bend_forward_deg: 45.0,
            bend_lateral_deg: 30.0,
            radii_m: Radii::default(),
        }),
        floor_m: None,
        start_region_m: None,
    }
}

#[test]
fn whoever_does_other_things_is_another_person() {
    let with = |also: &[Ability], run_m_s| ScanQuestion { also: also.to_vec(), run_m_s, ..looks() };
    let (walks, crawls) = (with(&[], None), with(&[Ability::Crawl], None));
    let runs = |fast| with(&[Ability::Run], Some(fast));
    for (after, before, same) in [
        (&walks, &walks, true),
        (&crawls, &crawls, true),
        (&walks, &crawls, false),
        (&crawls, &walks, false),
        (&runs(3.2), &runs(3.2), true),
        (&runs(4.8), &runs(3.2), false),
        (&ScanQuestion { held_m: Some(0.3), ..looks() }, &walks, false),
    ] {
        assert_eq!(after.does_otherwise(before).is_none(), same, "{after:?} {before:?}");
    }
}

#[test]
fn slower_arms_reach_less() {
    let with = |arm_speed_m_s| ScanQuestion { arm_speed_m_s, ..looks() };
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
    let with = |name: &str, by, kind| ScanQuestion {
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
        let mut after = ScanQuestion { contact_check_interval_s: step_s, ..momentary(Person) };
        after.controls[0].pressed_steps = pressed_steps;
        assert_eq!(after.works(&momentary(Person), 0), works, "{pressed_steps:?} {step_s}");
    }
    assert!(with("mode", Person, ControlKind::Held).works(&with("mode", Person, ControlKind::Held), 0));
    assert!(!looks().works(&momentary(Person), 0) && !momentary(Person).works(&momentary(Person), 1));
}

/// Each criterion, loosened by itself, says nothing of its own hazards any more and as much as before of the others; what the FMU
/// shows may change.
#[test]
fn what_is_judged_more_loosely_is_not_told() {
    const ALL: [Class; 6] =
        [Class::Force, Class::HeadContact, Class::Clamping, Class::Pressure, Class::MovingContact, Class::Separation];
    const FORCE: &[Class] = &[Class::Force, Class::HeadContact];
    const DISTANCE: &[Class] = &[Class::Separation];
    fn terms(criteria: &mut CriteriaRecord) -> &mut SeparationTerms {
        criteria.separation.as_mut().unwrap()
    }
    fn clamping(signal: Option<&str>, travel_after_contact_m: f64) -> Option<ClampingRecord> {
        Some(ClampingRecord { contact_signal: signal.map(str::to_owned), travel_after_contact_m })
    }
    type Loosen = fn(&mut CriteriaRecord);
    let cases: [(Loosen, &[Class]); 17] = [
        (|c| c.transient_force = Some(Criterion::Approach), FORCE),
        (|c| c.transient_force = None, FORCE),
        (|c| c.pressure = false, &[Class::Pressure]),
        (|c| c.clamping = None, &[Class::Clamping]),
        (|c| c.clamping = clamping(None, 0.04), &[Class::Clamping]),
        (|c| c.clamping = clamping(None, 0.06), &[]),
        (|c| c.clamping = clamping(Some("stop"), 0.01), &[]),
        (|c| c.moving_contact_faster_than_m_s = Some(0.5), &[Class::MovingContact]),
        (|c| terms(c).approach_m_s = 0.5, DISTANCE),
        (|c| terms(c).intrusion_m = 0.1, DISTANCE),
        (|c| terms(c).person_uncertainty_m = -0.01, DISTANCE),
        (|c| terms(c).robot_uncertainty_m = -0.01, DISTANCE),
        (|c| terms(c).stated.as_mut().unwrap().stop_distance_m = 0.1, DISTANCE),
        (|c| terms(c).stated.as_mut().unwrap().reaction_s = 0.05, DISTANCE),
        (|c| terms(c).stated = None, DISTANCE),
        (|c| terms(c).stop = Some("field".to_owned()), &[]),
        (|c| terms(c).intrusion_m = 0.3, &[]),
    ];
    let before = looks();
    for (loosen, lost) in cases {
        let mut after = looks();
        loosen(after.criteria.as_mut().unwrap());
        for class in ALL {
            let looser = after.judges_more_loosely(&before, class);
            assert_eq!(looser.is_some(), lost.contains(&class), "{class:?} {looser:?} {after:?}");
        }
    }
    // Stricter is strict enough, without a record as with one.
    let mut after = looks();
    after.criteria.as_mut().unwrap().moving_contact_faster_than_m_s = Some(0.0);
    assert!(ALL.iter().all(|class| after.judges_more_loosely(&before, *class).is_none()));
    let plain = |speed_criterion| ScanQuestion { criteria: None, speed_criterion, ..looks() };
    let [absolute, approach] = [Criterion::Absolute, Criterion::Approach].map(plain);
    assert_eq!(absolute.judges_more_loosely(&before, Class::Force), None);
    assert_eq!(approach.judges_more_loosely(&before, Class::Force), Some(Narrower::Speed));
    assert_eq!(approach.judges_more_loosely(&absolute, Class::HeadContact), Some(Narrower::Speed));
    assert_eq!(
        absolute.judges_more_loosely(&before, Class::Pressure),
        Some(Narrower::Criterion { class: Class::Pressure })
    );
    // What a measured stop was, a stated one may be or not.
    let measured = |looks: &mut ScanQuestion| terms(looks.criteria.as_mut().unwrap()).stop = Some("field".to_owned());
    let mut by_field = looks();
    measured(&mut by_field);
    assert!(looks().judges_more_loosely(&by_field, Class::Separation).is_some());
}

/// A later scan of another question does not tell what an earlier one did, and says which part of it is narrower; one of a wider
/// question does. The same hazard run again from where it began is asked less.
#[test]
fn a_narrower_question_says_which_part_of_it_is() {
    type Change = fn(&mut ScanQuestion);
    let hazard = fixtures::hazard("H-000001", 1.2);
    let begins = InitialConditionRecord { xy_m: [0.2, -6.0], heading_deg: 90.0, begins_s: 0.0 };
    let moved = ScanQuestion { begins: Some(begins), ..looks() };
    assert_eq!(moved.narrower(&looks(), &hazard, std::iter::empty()), Some(Narrower::Beginning));
    let seen = || Narrower::SeenAtStart { sensor: "mat".to_owned() };
    let cases: [(Change, Option<Narrower>, bool); 14] = [
        (|l| l.seen_at_start = vec!["mat".to_owned()], Some(seen()), false),
        (|_| (), None, false),
        (|l| l.begins.as_mut().unwrap().begins_s = 0.4, Some(Narrower::Beginning), false),
        (|l| l.begins = None, Some(Narrower::NotRecorded), false),
        (|l| l.body = None, Some(Narrower::NotRecorded), false),
        (|l| l.body.as_mut().unwrap().percentile = 5, Some(Narrower::Body), false),
        (|l| l.body.as_mut().unwrap().radii_m.head = Some(0.1), Some(Narrower::Body), false),
        (|l| l.actions_per_sequence = 0, Some(Narrower::Horizon), false),
        (|l| l.until_s = Some(4.0), Some(Narrower::FromElsewhere), false),
        (|l| l.contact_check_interval_s = 0.04, Some(Narrower::Interval), true),
        (|l| l.reach_tolerance_m = 0.05, Some(Narrower::Tolerance), true),
        (|l| l.arm_speed_m_s = Some(1.0), Some(Narrower::Arms), true),
        (|l| l.also = vec![Ability::Crawl], Some(Narrower::Abilities), true),
        (|l| (l.reach_tolerance_m, l.actions_per_sequence, l.arm_speed_m_s) = (0.01, 20, None), None, false),
    ];
    for (change, narrower, also_again) in cases {
        let mut after = looks();
        change(&mut after);
        assert_eq!(after.narrower(&looks(), &hazard, std::iter::empty()), narrower, "{after:?}");
        assert_eq!(after.judges_less(&looks(), &hazard), narrower.filter(|_| also_again), "{after:?}");
    }
}

/// From anywhere: for as long, on the same floor.
#[test]
fn from_anywhere_the_floor_and_the_time_count() {
    type Change = fn(&mut ScanQuestion);
    let hazard = fixtures::hazard("H-000001", 1.2);
    let anywhere = || ScanQuestion { until_s: Some(4.0), begins: None, ..looks() };
    let cases: [(Change, Option<Narrower>); 6] = [
        (|_| (), None),
        (|l| l.until_s = Some(5.0), None),
        (|l| l.until_s = Some(3.0), Some(Narrower::Horizon)),
        (|l| l.until_s = None, Some(Narrower::FromElsewhere)),
        (|l| l.floor_m = Some(vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]), Some(Narrower::Floor)),
        (|l| l.start_region_m = Some(vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]), Some(Narrower::Floor)),
    ];
    for (change, narrower) in cases {
        let mut after = anywhere();
        change(&mut after);
        assert_eq!(after.narrower(&anywhere(), &hazard, std::iter::empty()), narrower, "{after:?}");
    }
}
