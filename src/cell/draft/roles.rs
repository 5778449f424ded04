//! What the variables of an FMU are for, guessed from direction, type, unit, name and description: joint angles and speeds,
//! poses of links, payload, programme phase, safety signals, and what the FMU wants to know of the person.
//!
//! There is no standard for such names. The words are those of robot controllers (KUKA, ABB, Fanuc, UR's RTDE), PLCopen
//! safety blocks, OPC UA Robotics, URDF, and FMUs that people have published. A guess is a start for a cell file that a
//! person then checks, never more: its confidence says how much speaks for it.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::fmi::{Causality, ModelDescription, Variable, VariableType};

/// What a variable is for.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case", tag = "role")]
pub enum Role {
    /// Angle of a joint, numbered from 1 within its robot.
    JointAngle {
        /// What stands in front of the joints' names.
        robot: String,
        /// Which joint.
        number: usize,
    },
    /// Speed of a joint.
    JointSpeed {
        /// What stands in front of the joints' names.
        robot: String,
        /// Which joint.
        number: usize,
    },
    /// A part of the pose or velocity of a link: `x`, `qw`, `vx`, `wx` and so on.
    LinkPose {
        /// The link.
        link: String,
        /// Which part.
        part: String,
    },
    /// Mass of tool and workpiece.
    Payload,
    /// Phase of the robot programme, or a mode.
    Phase,
    /// A safety signal that the cell drives.
    SensorInput {
        /// Its value while a person is detected, if the name tells: `false` is usual.
        active: Option<bool>,
    },
    /// What a sensor inside the FMU reports.
    SensorOutput {
        /// Its value while a person is detected, if the name tells.
        active: Option<bool>,
    },
    /// What the FMU wants to know of the person: `x`, `y`, `heading`, `left_foot_x` and so on.
    Human {
        /// Which quantity of the cell file's `[pose]`.
        quantity: String,
    },
    /// A button or another input that is held constant.
    Constant,
}

/// A guess.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Guess {
    /// The variable, or the element of an array, as cell files name it.
    pub variable: String,
    /// What it is for.
    #[serde(flatten)]
    pub role: Role,
    /// How much speaks for it, 0 to 1.
    pub confidence: f64,
}

/// Guesses for all variables that seem to have a role, in the order of the file.
#[must_use]
pub fn guess(description: &ModelDescription) -> Vec<Guess> {
    let candidates: Vec<Candidate<'_>> = description.variables.iter().flat_map(|v| elements(description, v)).collect();
    let mut guesses: BTreeMap<usize, Guess> = BTreeMap::new();
    for (number, candidate) in candidates.iter().enumerate() {
        if let Some((role, confidence)) = alone(candidate) {
            guesses.insert(number, Guess { variable: candidate.name.clone(), role, confidence });
        }
    }
    for (quantity, joints) in [(Motion::Angle, true), (Motion::Speed, false)] {
        for series in series(&candidates, quantity) {
            let count = series.members.len();
            for (place, &member) in series.members.iter().enumerate() {
                let (robot, number) = (series.robot.clone(), place + 1);
                let role = if joints { Role::JointAngle { robot, number } } else { Role::JointSpeed { robot, number } };
                // Robots have six axes or seven; two to five are had by other machines.
                let confidence = if (6..=7).contains(&count) { series.confidence } else { 0.8 * series.confidence };
                let better = guesses.get(&member).is_none_or(|guess| guess.confidence < confidence);
                if better {
                    let variable = candidates[member].name.clone();
                    guesses.insert(member, Guess { variable, role, confidence });
                }
            }
        }
    }
    guesses.into_values().collect()
}

/// A variable, or one element of an array.
struct Candidate<'a> {
    name: String,
    variable: &'a Variable,
    unit: &'a str,
    /// Lower-case words and numbers of the name.
    words: Vec<String>,
    /// Words of the description.
    about: Vec<String>,
}

impl Candidate<'_> {
    fn has(&self, any: &[&str]) -> bool {
        self.words.iter().any(|word| any.contains(&word.as_str()))
    }

    fn is_about(&self, any: &[&str]) -> bool {
        self.about.iter().any(|word| any.contains(&word.as_str()))
    }

    fn is_real(&self) -> bool {
        matches!(self.variable.kind, VariableType::Real { .. })
    }

    fn is_output(&self) -> bool {
        self.variable.causality == Causality::Output
    }

    /// The last word that is no number.
    fn last_word(&self) -> &str {
        let mut words = self.words.iter().rev();
        words.find(|word| !is_number(word)).map_or("", String::as_str)
    }
}

/// The elements of a variable: itself, or those of a vector.
fn elements<'a>(description: &ModelDescription, variable: &'a Variable) -> Vec<Candidate<'a>> {
    let unit = match &variable.kind {
        VariableType::Real { unit: Some(unit), .. } => unit.as_str(),
        _ => "",
    };
    let candidate =
        |name: String| Candidate { words: words(&name), about: words(&variable.description), name, variable, unit };
    match description.extents(variable).as_deref() {
        Some([]) => vec![candidate(variable.name.clone())],
        Some(&[count]) if count <= MOST_ELEMENTS => {
            (1..=count).map(|i| candidate(format!("{}[{i}]", variable.name))).collect()
        }
        _ => Vec::new(),
    }
}

/// A longer vector is no robot's.
const MOST_ELEMENTS: usize = 64;

/// Words and numbers, lower case: at other characters, between letters and digits, and where capitals begin.
pub(super) fn words(text: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    let mut last = ' ';
    for c in text.chars() {
        let begins = !last.is_alphanumeric()
            || last.is_ascii_digit() != c.is_ascii_digit()
            || (c.is_uppercase() && last.is_lowercase());
        if c.is_alphanumeric() {
            match words.last_mut() {
                Some(word) if !begins => word.extend(c.to_lowercase()),
                _ => words.push(c.to_lowercase().collect()),
            }
        }
        last = c;
    }
    words
}

fn is_number(word: &str) -> bool {
    word.bytes().all(|b| b.is_ascii_digit())
}

const SENSORS: [&str; 26] = [
    "mat",
    "mats",
    "curtain",
    "lightcurtain",
    "barrier",
    "scanner",
    "laser",
    "lidar",
    "field",
    "zone",
    "area",
    "espe",
    "pse",
    "aopd",
    "aopddr",
    "ossd",
    "guard",
    "door",
    "gate",
    "interlock",
    "presence",
    "estop",
    "emergency",
    "twohand",
    "bumper",
    "safety",
];
const DETECTED: [&str; 12] = [
    "occupied",
    "detected",
    "pressed",
    "broken",
    "interrupted",
    "intrusion",
    "violated",
    "triggered",
    "active",
    "tripped",
    "open",
    "opened",
];
const CLEAR: [&str; 7] = ["clear", "ok", "closed", "free", "safe", "released", "ossd"];
const CONSTANTS: [&str; 9] = ["reset", "ack", "acknowledge", "restart", "start", "enable", "confirm", "button", "run"];
const PEOPLE: [&str; 7] = ["human", "person", "operator", "worker", "bill", "people", "pedestrian"];
const PHASES: [&str; 10] =
    ["leg", "phase", "mode", "segment", "programme", "program", "task", "sequence", "step", "waypoint"];
const LOADS: [&str; 6] = ["payload", "load", "flangeload", "mass", "workpiece", "toolmass"];

/// What a variable is by itself.
fn alone(candidate: &Candidate<'_>) -> Option<(Role, f64)> {
    let boolean = matches!(candidate.variable.kind, VariableType::Boolean { .. });
    let whole = matches!(candidate.variable.kind, VariableType::Integer { .. } | VariableType::Enumeration { .. });
    match candidate.variable.causality {
        Causality::Input if candidate.is_real() => human(candidate),
        Causality::Input if boolean => Some(safety_input(candidate)),
        Causality::Input if whole => Some((Role::Constant, 0.3)),
        Causality::Output if boolean && candidate.has(&SENSORS) && candidate.has(&DETECTED) => {
            Some((Role::SensorOutput { active: polarity(candidate) }, 0.8))
        }
        Causality::Output if (boolean || whole) && candidate.has(&PHASES) => {
            let leg = candidate.has(&["leg", "phase", "segment", "waypoint"]);
            Some((Role::Phase, if leg { 0.8 } else { 0.5 }))
        }
        Causality::Output if candidate.is_real() => output(candidate),
        _ => None,
    }
}

fn output(candidate: &Candidate<'_>) -> Option<(Role, f64)> {
    let named = candidate.has(&LOADS);
    if named && candidate.unit == "kg" {
        return Some((Role::Payload, 0.9));
    }
    if named && candidate.unit.is_empty() && candidate.has(&["payload", "flangeload"]) {
        return Some((Role::Payload, 0.6));
    }
    link_pose(candidate)
}

/// Inputs for safety signals and buttons.
fn safety_input(candidate: &Candidate<'_>) -> (Role, f64) {
    // PLCopen's safety blocks call every safe input S_...
    let plcopen = candidate.words.first().is_some_and(|word| word == "s") || candidate.name.contains(".S_");
    if candidate.has(&CONSTANTS) && !candidate.has(&SENSORS) && !plcopen {
        return (Role::Constant, 0.8);
    }
    let (named, described) = (candidate.has(&SENSORS), candidate.is_about(&SENSORS));
    let confidence = match (plcopen, named, described) {
        (true, true, _) | (_, true, true) => 0.93,
        (true, ..) => 0.85,
        (_, true, _) => 0.75,
        (_, _, true) => 0.6,
        _ if candidate.has(&CLEAR) || candidate.has(&DETECTED) => 0.5,
        // Who else would give a Boolean to a cell?
        _ => 0.3,
    };
    // Safety signals are there for demands: false is one.
    let active = polarity(candidate).or_else(|| plcopen.then_some(false));
    (Role::SensorInput { active }, confidence)
}

/// The value while a person is detected, if the name says it.
fn polarity(candidate: &Candidate<'_>) -> Option<bool> {
    match (candidate.has(&CLEAR), candidate.has(&DETECTED)) {
        (true, false) => Some(false),
        (false, true) => Some(true),
        _ => None,
    }
}

fn human(candidate: &Candidate<'_>) -> Option<(Role, f64)> {
    if !candidate.has(&PEOPLE) && !candidate.is_about(&PEOPLE) {
        return None;
    }
    let axis = match candidate.last_word() {
        "x" | "px" => "x",
        "y" | "py" => "y",
        "heading" | "yaw" | "theta" | "orientation" | "phi" => "heading",
        _ => return None,
    };
    let side = |name: &str| candidate.has(&[name]) && candidate.has(&["foot", "feet", "leg"]);
    let quantity = match (side("left"), side("right"), axis) {
        (true, _, "x" | "y") => format!("left_foot_{axis}"),
        (_, true, "x" | "y") => format!("right_foot_{axis}"),
        _ => axis.to_owned(),
    };
    Some((Role::Human { quantity }, if candidate.has(&PEOPLE) { 0.9 } else { 0.6 }))
}

/// A part of a link's pose: the last word says which, a number or the words before say of what.
fn link_pose(candidate: &Candidate<'_>) -> Option<(Role, f64)> {
    const PARTS: [(&str, &[&str]); 13] = [
        ("x", &["m", "mm"]),
        ("y", &["m", "mm"]),
        ("z", &["m", "mm"]),
        ("qw", &["1"]),
        ("qx", &["1"]),
        ("qy", &["1"]),
        ("qz", &["1"]),
        ("vx", &["m/s"]),
        ("vy", &["m/s"]),
        ("vz", &["m/s"]),
        ("wx", &["rad/s"]),
        ("wy", &["rad/s"]),
        ("wz", &["rad/s"]),
    ];
    let part = candidate.last_word();
    let (part, units) = PARTS.iter().find(|(name, _)| *name == part)?;
    let cut = candidate.name.to_lowercase().rfind(part)?;
    let link = candidate.name[..cut].trim_end_matches(['.', '_', '/']).to_owned();
    if link.is_empty() || candidate.has(&PEOPLE) {
        return None;
    }
    let unit = units.contains(&candidate.unit);
    let named = candidate.has(&["link", "frame", "body", "tcp", "tool", "flange", "robot", "shape"]);
    let confidence = match (unit, named) {
        (true, true) => 0.9,
        (true, false) | (false, true) => 0.5,
        _ => return None,
    };
    Some((Role::LinkPose { link, part: (*part).to_owned() }, confidence))
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
const OTHERS: [&str; 14] = [
    "torque",
    "current",
    "temperature",
    "tau",
    "effort",
    "force",
    "acc",
    "acceleration",
    "limit",
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
        if !candidate.is_output() || !candidate.is_real() || candidate.has(&OTHERS) {
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
