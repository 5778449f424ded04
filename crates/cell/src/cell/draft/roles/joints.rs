//! Which variables are the angles and speeds of joints: numbered ones that belong together, or one with its speed.

use std::collections::BTreeMap;

use super::{Candidate, Guess, PEOPLE, Role, is_number, link_pose};

/// Adds the joints among the candidates, each by its number, where they are likelier than what is guessed already.
pub(super) fn add(candidates: &[Candidate<'_>], guesses: &mut BTreeMap<usize, Guess>) {
    for (quantity, joints) in [(Motion::Angle, true), (Motion::Speed, false)] {
        for series in series(candidates, quantity) {
            let count = series.members.len();
            for (place, &member) in series.members.iter().enumerate() {
                let (robot, number) = (series.robot.clone(), place + 1);
                let role = if joints { Role::JointAngle { robot, number } } else { Role::JointSpeed { robot, number } };
                // Robots have six axes or seven; two to five are had by other machines.
                let confidence = if (6..=7).contains(&count) { series.confidence } else { 0.8 * series.confidence };
                let better = guesses.get(&member).is_none_or(|guess| guess.confidence < confidence);
                if better {
                    let variable = candidates[member].name.clone();
                    guesses.insert(member, Guess { variable, role, confidence, local: false });
                }
            }
        }
    }
    if !guesses.values().any(|guess| matches!(guess.role, Role::JointAngle { .. } | Role::JointSpeed { .. })) {
        for (angle, speed, robot, number) in pairs(candidates) {
            let role = |angle: bool| match angle {
                true => Role::JointAngle { robot: robot.clone(), number },
                false => Role::JointSpeed { robot: robot.clone(), number },
            };
            for (member, role) in [(angle, role(true)), (speed, role(false))] {
                let variable = candidates[member].name.clone();
                guesses.insert(member, Guess { variable, role, confidence: 0.6, local: false });
            }
        }
    }
}

/// Whether it is measured or wanted of something, or of what is no joint.
fn is_other(candidate: &Candidate<'_>) -> bool {
    candidate.has(&OTHERS) || candidate.is_about(&["valve", "valves"])
}

/// What moves a joint.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Motion {
    Angle,
    Speed,
}

/// Joints that belong together.
struct Series {
    robot: String,
    members: Vec<usize>,
    confidence: f64,
}

/// Words for angles of numbered joints, and those that are nearly sure.
const ANGLES: [&str; 16] = [
    "q", "joint", "joints", "axis", "a", "j", "rax", "theta", "phi", "angle", "position", "pos", "jpos", "ax",
    "actual", "act",
];
/// The same for speeds.
const SPEEDS: [&str; 12] =
    ["qd", "dq", "qdot", "speed", "velocity", "vel", "omega", "jvel", "w", "der", "rate", "dtheta"];
/// Names of robot joints without numbers (URDF).
const BODY: [&str; 8] = ["shoulder", "elbow", "wrist", "base", "pan", "lift", "upper", "fore"];
/// What is measured or wanted of a robot and no angle of it.
const OTHERS: [&str; 22] = [
    "torque",
    "current",
    "temperature",
    "tau",
    "effort",
    "force",
    "acc",
    "acceleration",
    "limit",
    "limits",
    "lim",
    "min",
    "max",
    "minimum",
    "maximum",
    "valve",
    "valves",
    "error",
    "target",
    "desired",
    "cmd",
    "command",
];

/// The series of joints among the outputs.
fn series(candidates: &[Candidate<'_>], motion: Motion) -> Vec<Series> {
    let mut stems: BTreeMap<Vec<String>, Vec<(u32, usize)>> = BTreeMap::new();
    let mut named: BTreeMap<Vec<String>, Vec<usize>> = BTreeMap::new();
    for (place, candidate) in candidates.iter().enumerate() {
        if !candidate.is_output() || !candidate.is_real() || is_other(candidate) {
            continue;
        }
        let link = link_pose(candidate).is_some_and(|(_, confidence)| confidence > 0.8);
        if link || of_motion(candidate, motion) == 0.0 {
            continue;
        }
        // The last number counts the joints, but for those whose names say what they are.
        let number = candidate.words.iter().rposition(|word| is_number(word));
        if candidate.has(&["joint"]) && candidate.has(&BODY) {
            let before = candidate.words.iter().position(|word| BODY.contains(&word.as_str())).unwrap_or(0);
            named.entry(candidate.words[..before].to_vec()).or_default().push(place);
        } else if let Some(at) = number {
            let mut stem = candidate.words.clone();
            if let Ok(count) = stem[at].parse() {
                stem[at] = "#".to_owned();
                stems.entry(stem).or_default().push((count, place));
            }
        }
    }
    let mut all = Vec::new();
    for mut numbered in stems.into_values() {
        numbered.sort_unstable();
        let first = numbered[0].0;
        let consecutive = numbered.iter().zip(first..).all(|((number, _), expected)| *number == expected);
        if first <= 1 && consecutive && (2..=9).contains(&numbered.len()) {
            all.push(numbered.into_iter().map(|(_, place)| place).collect());
        }
    }
    all.extend(named.into_values().filter(|members| members.len() >= 2));
    all.into_iter()
        .map(|members: Vec<usize>| {
            let confidence = members.iter().map(|&m| of_motion(&candidates[m], motion)).fold(1.0, f64::min);
            Series { robot: robot(&candidates[members[0]].name), members, confidence }
        })
        .collect()
}

/// Joints without a number, each with its speed: what is left of both names is the same, and so is the unit but for `/s`.
/// Angle, speed, robot, and which of its joints.
fn pairs(candidates: &[Candidate<'_>]) -> Vec<(usize, usize, String, usize)> {
    let left = |candidate: &Candidate<'_>| -> Vec<String> {
        let says = |word: &String| ANGLES.contains(&word.as_str()) || SPEEDS.contains(&word.as_str());
        candidate.words.iter().filter(|word| !says(word)).cloned().collect()
    };
    let usable = |candidate: &Candidate<'_>| {
        let numbered = candidate.words.iter().any(|word| is_number(word));
        candidate.is_output() && candidate.is_real() && !numbered && !is_other(candidate) && !candidate.has(&PEOPLE)
    };
    let fits = |angle: &Candidate<'_>, speed: &Candidate<'_>| {
        let units = matches!((angle.unit, speed.unit), ("rad", "rad/s") | ("deg", "deg/s"));
        units && angle.has(&ANGLES) && !angle.has(&SPEEDS) && speed.has(&SPEEDS) && left(angle) == left(speed)
    };
    let usable: Vec<usize> = (0..candidates.len()).filter(|&at| usable(&candidates[at])).collect();
    let mut joints: BTreeMap<String, usize> = BTreeMap::new();
    let mut pairs = Vec::new();
    for &angle in &usable {
        let speeds: Vec<usize> =
            usable.iter().copied().filter(|&speed| fits(&candidates[angle], &candidates[speed])).collect();
        let [speed] = speeds[..] else { continue };
        // Two angles with one speed: which of them it belongs to is not told.
        if usable.iter().filter(|&&other| fits(&candidates[other], &candidates[speed])).count() > 1 {
            continue;
        }
        let robot = robot(&candidates[angle].name);
        let number = joints.entry(robot.clone()).or_default();
        *number += 1;
        pairs.push((angle, speed, robot, *number));
    }
    pairs
}

/// How much speaks for a motion of a joint.
fn of_motion(candidate: &Candidate<'_>, motion: Motion) -> f64 {
    let speed = candidate.has(&SPEEDS) || candidate.is_about(&["speed", "velocity"]);
    let angle = candidate.has(&ANGLES) || candidate.has(&BODY);
    match (motion, candidate.unit) {
        (Motion::Angle, "rad" | "deg") => {
            if angle && !speed {
                0.97
            } else {
                0.7
            }
        }
        (Motion::Speed, "rad/s" | "deg/s") => {
            if speed {
                0.97
            } else {
                0.75
            }
        }
        // Without a unit it takes a word.
        (Motion::Angle, "") if angle && !speed => {
            if candidate.has(&["q", "joint", "axis", "rax", "j"]) {
                0.7
            } else {
                0.5
            }
        }
        (Motion::Speed, "") if speed => 0.6,
        _ => 0.0,
    }
}

/// What stands in front of the joints' own name: the robot's.
fn robot(name: &str) -> String {
    name.rsplit_once(['.', '/']).map_or_else(String::new, |(before, _)| before.to_owned())
}
