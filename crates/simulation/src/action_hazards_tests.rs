//! By hand: what is told of an action in which a chest is hit at one instant and clamped at the next.

use super::*;
use crate::geometry::Vec3;
use crate::hazard::contact::{Against, Clamped, Touch};
use crate::hazard::criterion::Criteria;
use crate::hazard::criterion::pressure::LinkContact;
use crate::hazard::{Contact, Strike};
use crate::human::Who;
use crate::standards::BodyRegion;

/// A chest at a step: the robot is so fast, and closes a gap at this speed, if there is one. 29.1 kg and 12.5 kg: m_R 27.05 kg, so
/// 635.2 N a m/s for somebody who gives way (limit 280 N) and 822.3 N for a chest that cannot (140 N).
fn met(who: Who, step: usize, speed_m_s: f64, closing_m_s: Option<f64>) -> Finding {
    let touch = Touch {
        region: BodyRegion::Chest,
        area: None,
        link: 0,
        on_robot: Vec3::ZERO,
        on_body: Vec3::new(0.0, -0.01, 0.0),
        distance_m: 0.01,
        robot_velocity: Vec3::new(speed_m_s, 0.0, 0.0),
        human_velocity: Vec3::ZERO,
    };
    let clamped = closing_m_s.map(|closing_m_s| Clamped {
        at: Vec3::ZERO,
        toward: Vec3::X,
        against: Against::Obstacle(0),
        gap_m: 0.3,
        travel_m: 0.0,
        closing_m_s,
    });
    let contact = Contact::judged(
        &touch,
        clamped.as_ref(),
        &Strike::new(29.1, 12.5, Criteria::default(), LinkContact::default()),
    );
    Finding {
        class: contact.class().unwrap(),
        contact,
        actions: Vec::new(),
        step,
        time_s: 0.0,
        who,
        person: Vec3::ZERO,
        heading_rad: 0.0,
        bend_sixteenths: 16,
        arm: None,
        sensors: Vec::new(),
        phase: None,
        through: Vec::new(),
    }
}

fn as_clamping(finding: &Finding) -> Finding {
    let contact = finding.contact.as_clamping();
    Finding { class: contact.class().unwrap(), contact, ..finding.clone() }
}

/// Two instants: hit at 4.54x with the gap closing slowly (1.18x clamped), then clamped at 4.70x. The hit ends the action, both
/// clampings are told, and the second is the worst of all.
#[test]
fn a_hit_and_then_a_clamping_are_both_told() {
    let (hit, pressed) = (met(Who::First, 7, 2.0, Some(0.2)), met(Who::First, 8, 0.8, Some(0.8)));
    assert_eq!((hit.class, pressed.class), (Class::Force, Class::Clamping));
    let beside = as_clamping(&hit);
    let ratios = [&hit, &beside, &pressed].map(|finding| finding.contact.ratio());
    for (ratio, by_hand) in ratios.into_iter().zip([4.537, 1.175, 4.699]) {
        assert!((ratio - by_hand).abs() < 2e-3, "{ratios:?}");
    }
    let mut course = PersonCourse::default();
    course.meets(hit.clone(), Some(beside.clone()));
    course.is_clamped(pressed.clone());
    let told = ActionHazards::of(std::iter::once(&course));
    assert_eq!((told.ends, told.noted), (vec![hit], Vec::new()));
    assert_eq!(told.clampings, [(beside, false), (pressed, false)]);
    // What is no clamping is none by another name.
    assert_eq!(met(Who::First, 7, 2.0, None).contact.as_clamping().class(), None);
}

/// A clamping that comes first is told once, and a worse one after it too.
#[test]
fn a_clamping_that_ends_an_action_is_not_told_twice() {
    let (first, worse) = (met(Who::First, 7, 0.4, Some(0.4)), met(Who::First, 8, 0.8, Some(0.8)));
    let mut course = PersonCourse::default();
    course.meets(first.clone(), Some(as_clamping(&first)));
    course.is_clamped(worse.clone());
    let told = ActionHazards::of(std::iter::once(&course));
    assert_eq!(told.ends, std::slice::from_ref(&first));
    assert_eq!(told.clampings, [(first, true), (worse, false)]);
}

/// What one of two meets alone ends with their own hit; together it ends with the other's, which is earlier, and from then on
/// clampings of both are told.
#[test]
fn with_the_hit_of_one_of_two_clamping_alone_is_told_of_both() {
    let (hit, late) = (met(Who::First, 3, 2.0, None), met(Who::Second, 5, 1.0, None));
    let pressed = met(Who::Second, 6, 0.8, Some(0.8));
    let (mut one, mut other) = (PersonCourse::default(), PersonCourse::default());
    one.meets(hit.clone(), None);
    other.meets(late, None);
    other.is_clamped(pressed.clone());
    let told = ActionHazards::of([&one, &other].into_iter());
    assert_eq!((told.ends, told.noted), (vec![hit], Vec::new()));
    assert_eq!(told.clampings, [(pressed, false)]);
}
