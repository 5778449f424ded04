//! Figures of robots by hand: how two runs come together, and what is said of a robot that nobody met.

use super::*;

/// A robot that moved and that somebody was near.
fn met() -> RobotCoverage {
    RobotCoverage {
        name: String::new(),
        top_speed_m_s: 0.8,
        moved: true,
        reachable: true,
        instants_to_walk_to: 9,
        instants_in_reach: 4,
        closest_approach_m: 0.3,
    }
}

/// Some actions with these robots.
fn seen(robots: &[RobotCoverage]) -> Coverage {
    Coverage { actions: 5, contact_checks: 50, robots: robots.to_vec(), ..Coverage::new(1) }
}

#[test]
fn robots_and_controls_of_two_runs_come_together_each_by_itself() {
    let still = RobotCoverage { reachable: true, ..RobotCoverage::default() };
    let mut one = seen(&[met(), still.clone()]);
    one.robots[1].name = "R2".to_owned();
    one.control_actions = vec![2, 0];
    let mut other = seen(&[
        RobotCoverage { top_speed_m_s: 1.5, moved: false, closest_approach_m: 0.7, instants_in_reach: 1, ..met() },
        RobotCoverage { top_speed_m_s: 0.1, moved: true, instants_to_walk_to: 3, ..RobotCoverage::default() },
    ]);
    other.control_actions = vec![1, 1];
    let mut both = one.clone();
    both.merge(&other);
    assert_eq!(both.control_actions, [3, 1]);
    let first = RobotCoverage { top_speed_m_s: 1.5, instants_to_walk_to: 18, instants_in_reach: 5, ..met() };
    let name = "R2".to_owned();
    let second = RobotCoverage { name, top_speed_m_s: 0.1, moved: true, instants_to_walk_to: 3, ..still };
    assert_eq!(both.robots, [first.clone(), second.clone()]);
    // The other way round, and after a question that knew of no robots but the second.
    other.merge(&one);
    assert_eq!(other, both);
    let mut question = Coverage::new(1);
    question.robot(1).closest_approach_m = -0.1;
    assert_eq!(question.robots.len(), 2, "that of the first is there, and nothing in it");
    both.merge(&question);
    assert_eq!(both.robots, [first, RobotCoverage { closest_approach_m: -0.1, ..second }]);
    let mut none = Coverage::new(1);
    none.merge(&both);
    assert_eq!((none.robots, none.control_actions), (both.robots, both.control_actions));
}

#[test]
fn each_robot_is_judged_by_itself() {
    let never = |robot: RobotCoverage, change: &dyn Fn(&mut Coverage)| {
        // Beside one that was met.
        let mut coverage = seen(&[met(), robot]);
        change(&mut coverage);
        let of_first = coverage.no_contact_reason(0);
        assert!(coverage.actions == 0 || of_first.is_none(), "{of_first:?}");
        coverage.no_contact_reason(1)
    };
    let as_it_is = |_: &mut Coverage| {};
    let still = RobotCoverage { top_speed_m_s: 0.0, moved: false, ..met() };
    let away = RobotCoverage { instants_in_reach: 0, closest_approach_m: f64::MAX, ..met() };
    let far = RobotCoverage { instants_to_walk_to: 0, ..away.clone() };
    assert_eq!(never(met(), &as_it_is), None);
    assert_eq!(never(still.clone(), &as_it_is), Some(NoContactReason::NeverMoved { controls_worked: false }));
    // Told to be fast, or seen to move: either is enough, whichever of the two is wrong.
    assert_eq!(never(RobotCoverage { moved: true, ..still.clone() }, &as_it_is), None);
    assert_eq!(never(RobotCoverage { top_speed_m_s: 0.5, ..still.clone() }, &as_it_is), None);
    let worked = |coverage: &mut Coverage| coverage.control_actions = vec![0, 3];
    assert_eq!(never(still, &worked), Some(NoContactReason::NeverMoved { controls_worked: true }));
    assert_eq!(never(away.clone(), &as_it_is), Some(NoContactReason::NeverNear));
    assert_eq!(never(away, &|coverage| coverage.walks_blocked = 1), Some(NoContactReason::KeptOut));
    assert_eq!(
        never(far.clone(), &|coverage| coverage.walks_blocked = 1),
        Some(NoContactReason::TooFar),
        "no obstacle is why"
    );
    // What is too far to be touched is so whether it moves or not.
    assert_eq!(
        never(RobotCoverage { moved: false, top_speed_m_s: 0.0, ..far }, &worked),
        Some(NoContactReason::TooFar)
    );
    // An exhaustive search that drops its only state has simulated nothing, and knows why.
    let nothing = |coverage: &mut Coverage| coverage.actions = 0;
    assert_eq!(never(RobotCoverage::default(), &nothing), Some(NoContactReason::TooFar));
    let only_lengths = RobotCoverage { reachable: true, ..RobotCoverage::default() };
    assert_eq!(never(only_lengths, &nothing), Some(NoContactReason::NotSimulated));
    assert_eq!(
        Coverage::new(1).no_contact_reason(0),
        Some(NoContactReason::NotSimulated),
        "nothing is known of robots at all"
    );
}

#[test]
fn a_guard_and_a_prevented_start_are_answers_and_the_rest_is_not() {
    let all = [
        (NoContactReason::NotSimulated, false, "no action with R1 was simulated"),
        (NoContactReason::TooFar, false, "R1 was never near enough to be touched"),
        (NoContactReason::NeverMoved { controls_worked: false }, false, "R1 never moved."),
        (NoContactReason::NeverMoved { controls_worked: true }, true, "R1 never moved, though controls"),
        (NoContactReason::NeverNear, false, "nobody was ever near enough to touch R1"),
        (NoContactReason::KeptOut, true, "obstacles kept everybody away"),
    ];
    for (never, shown, words) in all {
        assert_eq!(never.is_shown(), shown, "{never:?}");
        assert!(never.words("R1").contains(words), "{}", never.words("R1"));
    }
}
