//! Speeds that are true however they are told are taken, and lies are seen, on motions that are calculated here.

use std::f64::consts::{PI, TAU};

use super::*;
use crate::cell::binding::{Derived, Reader};

/// What a drive says of its speed at a row, of its positions.
type Telling<'a> = &'a dyn Fn(&[f64], usize) -> f64;

const STEP_S: f64 = 0.02;

/// Joints of two columns each, angle and speed, with steps of `step_s`; row 0 does not count.
fn joints(count: usize, step_s: f64) -> Comparison {
    let joint = |n: usize| {
        let way = vec![Derived::Rate { of: Reader::output(2 * n, 1.0), turns: true }];
        Signal::new(0, MovingPart::Joint(n), way, &[Reader::output(2 * n + 1, 1.0)], true).unwrap()
    };
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "small")]
    let of = |seconds: f64| (seconds / step_s).round() as usize;
    Comparison {
        signals: (0..count).map(joint).collect(),
        columns: 2 * count,
        step_s,
        span: of(SPAN_S).max(1),
        long: of(0.2) - 2,
        unsettled: 1,
    }
}

/// Rows of a joint whose speed is `speed` over time, s, and told as `told` says from the rows of true speeds; its angle is
/// integrated in a hundred parts of a step.
fn rows(step_s: f64, speed: &dyn Fn(f64) -> f64, told: &dyn Fn(&[f64], usize) -> f64) -> Vec<f64> {
    let steps = 80;
    let (mut angle, mut angles, mut speeds) = (0.3, Vec::new(), Vec::new());
    for step in 0..=steps {
        angles.push(angle);
        speeds.push(speed(f64::from(step) * step_s));
        let part = |n: i32| speed((f64::from(step) + (f64::from(n) + 0.5) / 100.0) * step_s) * step_s / 100.0;
        angle += (0..100).map(part).sum::<f64>();
    }
    angles.iter().enumerate().flat_map(|(n, angle)| [*angle, told(&speeds, n)]).collect()
}

fn look(comparison: &Comparison, rows: &[f64]) -> Motion {
    let mut motion = Motion::default();
    comparison.look(rows, 0, 0, &mut motion);
    motion
}

/// Runs up at 40 rad/s^2, goes on, and is braked at 60 rad/s^2 between two steps; stands; goes back.
fn hard(t: f64) -> f64 {
    match t {
        t if t < 0.105 => 0.0,
        t if t < 0.155 => 40.0 * (t - 0.105),
        t if t < 0.655 => 2.0,
        t if t < 0.688 => (2.0 - 60.0 * (t - 0.655)).max(0.0),
        t if t < 0.9 => 0.0,
        t => -1.2 * (1.0 - libm::cos(8.0 * (t - 0.9))),
    }
}

fn exact(speeds: &[f64], n: usize) -> f64 {
    speeds[n]
}

#[test]
fn hard_starts_and_stops_told_late_early_or_in_the_mean_are_true() {
    let ways: [(&str, Telling<'_>); 5] = [
        ("exact", &exact),
        ("a step late", &|speeds, n| speeds[n.saturating_sub(1)]),
        ("a step early", &|speeds, n| speeds[(n + 1).min(speeds.len() - 1)]),
        ("the mean of two", &|speeds, n| f64::midpoint(speeds[n.saturating_sub(1)], speeds[n])),
        ("in single precision, 1 % off", &|speeds, n| {
            #[expect(clippy::cast_possible_truncation, reason = "meant")]
            let rounded = (speeds[n] * 1.01) as f32;
            f64::from(rounded)
        }),
    ];
    for step_s in [STEP_S, 0.01, 0.001] {
        let comparison = joints(1, step_s);
        let speed = |t: f64| hard(t * STEP_S / step_s);
        for (name, told) in ways {
            let motion = look(&comparison, &rows(step_s, &speed, told));
            assert!(!motion.disagrees(), "{name}, {step_s} s: {:?}", motion.seen()[0].worst);
            assert!(motion.moved.contains(&0) && !motion.jumped());
        }
    }
}

#[test]
fn angles_that_are_rounded_or_wrap_are_no_lie() {
    let comparison = joints(1, STEP_S);
    let mut rounded = rows(STEP_S, &hard, &exact);
    let mut wrapped = rows(STEP_S, &|_| 9.0, &exact);
    for row in 0..rounded.len() / 2 {
        // Hundredths of a degree; within half a turn.
        rounded[2 * row] = ((rounded[2 * row]).to_degrees() * 100.0).round() / 100.0 * PI / 180.0;
        wrapped[2 * row] -= TAU * (wrapped[2 * row] / TAU).round();
    }
    assert!(!look(&comparison, &rounded).disagrees());
    let motion = look(&comparison, &wrapped);
    assert!(!motion.disagrees(), "{:?}", motion.seen()[0].worst);
}

#[test]
fn lies_are_seen_however_slow_or_short() {
    let comparison = joints(1, STEP_S);
    let lies: [(&str, Telling<'_>); 5] = [
        ("nothing", &|_, _| 0.0),
        ("sign", &|speeds, n| -speeds[n]),
        ("half", &|speeds, n| speeds[n] / 2.0),
        ("twice", &|speeds, n| speeds[n] * 2.0),
        ("degrees", &|speeds, n| speeds[n].to_degrees()),
    ];
    for (name, told) in lies {
        let seen = look(&comparison, &rows(STEP_S, &hard, told)).seen()[0].clone();
        assert!(seen.steps.len() > 25, "{name}: {seen:?}");
        let [slower, faster] = seen.slower_faster;
        assert_eq!(slower, ["nothing", "half"].contains(&name), "{name}: {seen:?}");
        assert_eq!(faster, ["twice", "degrees"].contains(&name), "{name}: {seen:?}");
    }
    // A joint that creeps, at 0.2 degrees per second.
    let creeps = rows(STEP_S, &|_| 0.0035, &|_, _| 0.0);
    let motion = look(&comparison, &creeps);
    assert!(motion.disagrees() && motion.moved.contains(&0));
    assert!(!look(&comparison, &rows(STEP_S, &|_| 0.0035, &exact)).disagrees());
    // One step, while the joint stands all the time besides: the first that is compared, one in the middle, the last.
    for at in [2, 40, 80] {
        let mut jumps = rows(STEP_S, &|_| 0.0, &exact);
        jumps.iter_mut().step_by(2).skip(at).for_each(|angle| *angle += 0.3);
        let seen = look(&comparison, &jumps).seen()[0].clone();
        assert_eq!(seen.steps.into_iter().collect::<Vec<_>>(), [at]);
        assert!((seen.worst.unwrap().motion - 15.0).abs() < 1e-9);
    }
}

#[test]
fn the_first_step_is_a_jump_where_no_robot_could_have_moved_so() {
    let comparison = joints(1, STEP_S);
    let mut rows = rows(STEP_S, &hard, &exact);
    assert!(!look(&comparison, &rows).jumped());
    (rows[0], rows[1]) = (0.0, 0.0);
    let motion = look(&comparison, &rows);
    assert!(motion.jumped() && !motion.disagrees());
    assert!(motion.seen()[0].fastest[0].0 < 2.5, "the jump is no motion");
    // Where the person begins later the same is a lie.
    let later = Comparison { unsettled: 0, ..comparison };
    assert!(look(&later, &rows).disagrees());
}

#[test]
fn rows_in_pieces_and_in_any_order_give_the_same() {
    let comparison = joints(1, STEP_S);
    let rows = rows(STEP_S, &hard, &|speeds, n| speeds[n] * 1.5);
    let whole = look(&comparison, &rows);
    let action = 10;
    let mut pieces: Vec<Motion> = Vec::new();
    for number in 0..8 {
        // An action with the one before, as a search has it.
        let from = if number == 0 { 0 } else { (number - 1) * action + 1 };
        let to = (number + 1) * action + 1;
        let new = if number == 0 { 1 } else { action };
        let mut motion = Motion::default();
        comparison.look(&rows[2 * from..2 * to], from, new, &mut motion);
        pieces.push(motion);
    }
    let merged = |order: &mut dyn Iterator<Item = &Motion>| {
        let mut all = Motion::default();
        order.for_each(|motion| all.merge(motion));
        all
    };
    let forwards = merged(&mut pieces.iter());
    assert_eq!(forwards, merged(&mut pieces.iter().rev().chain(&pieces)));
    let (pieces, whole) = (&forwards.seen()[0], &whole.seen()[0]);
    assert_eq!((&pieces.worst, &pieces.fastest), (&whole.worst, &whole.fastest));
    assert!(pieces.steps.is_subset(&whole.steps) && pieces.steps.len() * 10 > whole.steps.len() * 9);
}

#[test]
fn the_joint_whose_speed_it_is_is_named() {
    let comparison = joints(3, STEP_S);
    let speed = |n: usize| move |t: f64| [hard(t), 0.8 * libm::sin(6.0 * t), 0.5 * libm::cos(4.0 * t)][n];
    let all: Vec<Vec<f64>> = (0..3).map(|n| rows(STEP_S, &speed(n), &exact)).collect();
    // The second is told as the third.
    let told = |row: usize| {
        [
            all[0][2 * row],
            all[0][2 * row + 1],
            all[1][2 * row],
            all[2][2 * row + 1],
            all[2][2 * row],
            all[2][2 * row + 1],
        ]
    };
    let rows: Vec<f64> = (0..=80).flat_map(told).collect();
    let motion = look(&comparison, &rows);
    let disagree: Vec<bool> = motion.seen().iter().map(|seen| seen.worst.is_some()).collect();
    assert_eq!(disagree, [false, true, false]);
    assert_eq!(motion.seen()[1].of_others().collect::<Vec<_>>(), [2]);
}
