//! What the variables of an FMU are for, guessed from direction, type, unit, name and description: joint angles and speeds,
//! poses of links, payload, programme phase, safety signals, and what the FMU wants to know of the person.
//!
//! There is no standard for such names. The words are those of robot controllers (KUKA, ABB, Fanuc, UR's RTDE), PLCopen
//! safety blocks, OPC UA Robotics, URDF, and FMUs that people have published. A guess is a start for a cell file that a
//! person then checks, never more: its confidence says how much speaks for it. `joints` has what tells a joint.

mod joints;

use std::collections::BTreeMap;

use serde::Serialize;

use crate::cell::sensor::KINDS;
use crate::fmi::{Causality, ModelDescription, Variability, Variable, VariableType};

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
    /// A safety signal that the cell drives and that is a number.
    SensorNumber {
        /// Its value while nobody is detected, if the description, or its start value, tells.
        clear: Option<i64>,
        /// Its value while a person is detected, if the description tells.
        detected: Option<i64>,
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
    /// Whether it is a local variable, which a cell may bind like an output.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub local: bool,
}

/// Guesses for all variables that seem to have a role, in the order of the file: inputs and outputs, and locals for what no
/// output is for.
#[must_use]
pub fn guess(description: &ModelDescription) -> Vec<Guess> {
    let of = |wanted: &dyn Fn(&Variable) -> bool| {
        let variables = description.variables.iter().enumerate().filter(|(_, variable)| wanted(variable));
        let (places, candidates): (Vec<usize>, Vec<Candidate<'_>>) =
            variables.flat_map(|(at, v)| elements(description, v).into_iter().map(move |c| (at, c))).unzip();
        among(&candidates).into_iter().map(move |(number, guess)| (places[number], guess)).collect::<Vec<_>>()
    };
    let mut all = of(&|v| v.causality != Causality::Local);
    let changes = |v: &Variable| !matches!(v.variability, Variability::Constant | Variability::Fixed);
    let inner = of(&|v| v.causality == Causality::Local && changes(v));
    let new = missing_among(&all, inner);
    all.extend(new);
    all.sort_by_key(|(at, _)| *at);
    all.into_iter().map(|(_, guess)| guess).collect()
}

/// What a robot's guesses are told apart by: joints and poses of links both say how it moves.
const fn kind(role: &Role) -> u8 {
    match role {
        Role::JointAngle { .. } | Role::LinkPose { .. } => 0,
        Role::JointSpeed { .. } => 1,
        Role::Payload => 2,
        Role::Phase => 3,
        Role::SensorOutput { .. } => 4,
        Role::SensorInput { .. } | Role::SensorNumber { .. } | Role::Human { .. } | Role::Constant => 5,
    }
}

/// Leaves out locals for what an output of another FMU is for.
pub(super) fn without_locals_beside(guesses: &mut Vec<Guess>) {
    let told: Vec<u8> = guesses.iter().filter(|guess| !guess.local).map(|guess| kind(&guess.role)).collect();
    guesses.retain(|guess| !guess.local || !told.contains(&kind(&guess.role)));
}

/// Those of the locals that say what no output says. Inside an FMU there is much that looks alike: of joints the likeliest
/// robot's are taken.
fn missing_among(known: &[(usize, Guess)], inner: Vec<(usize, Guess)>) -> Vec<(usize, Guess)> {
    let told = |of: u8| known.iter().any(|(_, guess)| kind(&guess.role) == of);
    let best = |of: u8| {
        let robots = inner.iter().filter_map(|(_, guess)| match &guess.role {
            Role::JointAngle { robot, .. } | Role::JointSpeed { robot, .. } if kind(&guess.role) == of => {
                Some((guess.confidence, robot.clone()))
            }
            _ => None,
        });
        robots.reduce(|best, other| if other.0 > best.0 { other } else { best }).map(|(_, robot)| robot)
    };
    let robots = [best(0), best(1)];
    let wanted = |guess: &Guess| {
        !told(kind(&guess.role))
            && match &guess.role {
                Role::JointAngle { robot, .. } => robots[0].as_ref() == Some(robot),
                Role::JointSpeed { robot, .. } => robots[1].as_ref() == Some(robot),
                Role::LinkPose { .. } => robots[0].is_none() && guess.confidence > 0.8,
                // Every model has masses, modes and steps inside.
                Role::Payload => {
                    words(&guess.variable).iter().any(|word| ["payload", "flangeload"].contains(&word.as_str()))
                }
                Role::Phase => guess.confidence > 0.7,
                // What the cell drives is reported inside, too.
                Role::SensorOutput { .. } => {
                    !known.iter().any(|(_, g)| matches!(g.role, Role::SensorInput { .. } | Role::SensorNumber { .. }))
                }
                _ => true,
            }
    };
    let inner: Vec<(usize, Guess)> = inner.into_iter().filter(|(_, guess)| wanted(guess)).collect();
    inner
        .into_iter()
        .map(|(at, guess)| (at, Guess { local: true, confidence: INSIDE * guess.confidence, ..guess }))
        .collect()
}

/// How much less speaks for a local than for an output of the same name.
const INSIDE: f64 = 0.8;

/// Guesses among these candidates, with the number of each.
fn among(candidates: &[Candidate<'_>]) -> BTreeMap<usize, Guess> {
    let mut guesses: BTreeMap<usize, Guess> = BTreeMap::new();
    for (number, candidate) in candidates.iter().enumerate() {
        if let Some((role, confidence)) = alone(candidate) {
            guesses.insert(number, Guess { variable: candidate.name.clone(), role, confidence, local: false });
        }
    }
    joints::add(candidates, &mut guesses);
    guesses
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

    /// Whether its name says that it is a safety signal.
    fn is_safety_signal(&self) -> bool {
        self.words.iter().any(|word| is_of_safety(word))
    }

    /// Whether its description does.
    fn is_about_safety(&self) -> bool {
        self.about.iter().any(|word| is_of_safety(word))
    }

    fn is_real(&self) -> bool {
        matches!(self.variable.kind, VariableType::Real { .. })
    }

    /// Whether it is what the FMU gives: an output, or a local.
    fn is_output(&self) -> bool {
        matches!(self.variable.causality, Causality::Output | Causality::Local)
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

/// Words of safety signals besides those of a kind of sensor.
const SAFETY: [&str; 8] = ["espe", "pse", "ossd", "presence", "estop", "emergency", "bumper", "safety"];
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

/// Whether a word is one of safety signals.
fn is_of_safety(word: &str) -> bool {
    SAFETY.contains(&word) || KINDS.iter().any(|kind| kind.recognised().words().contains(&word))
}

/// What a variable is by itself.
fn alone(candidate: &Candidate<'_>) -> Option<(Role, f64)> {
    let boolean = matches!(candidate.variable.kind, VariableType::Boolean { .. });
    let whole = matches!(candidate.variable.kind, VariableType::Integer { .. } | VariableType::Enumeration { .. });
    match candidate.variable.causality {
        Causality::Input if candidate.is_real() => human(candidate).or_else(|| safety_number(candidate)),
        Causality::Input if boolean => Some(safety_input(candidate)),
        Causality::Input if whole => safety_number(candidate).or(Some((Role::Constant, 0.3))),
        Causality::Output | Causality::Local if boolean && candidate.is_safety_signal() && candidate.has(&DETECTED) => {
            Some((Role::SensorOutput { active: polarity(candidate) }, 0.8))
        }
        Causality::Output | Causality::Local if (boolean || whole) && candidate.has(&PHASES) => {
            let leg = candidate.has(&["leg", "phase", "segment", "waypoint"]);
            Some((Role::Phase, if leg { 0.8 } else { 0.5 }))
        }
        Causality::Output | Causality::Local if candidate.is_real() => output(candidate),
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
    if candidate.has(&CONSTANTS) && !candidate.is_safety_signal() && !plcopen {
        return (Role::Constant, 0.8);
    }
    let (named, described) = (candidate.is_safety_signal(), candidate.is_about_safety());
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

/// Inputs for safety signals that are numbers: what their description says of the values.
fn safety_number(candidate: &Candidate<'_>) -> Option<(Role, f64)> {
    let unit = !candidate.unit.is_empty() && candidate.unit != "1";
    if unit || !(candidate.is_safety_signal() || candidate.is_about_safety()) {
        return None;
    }
    let values = numbered(&candidate.variable.description);
    let of = |names: &[&str]| {
        values
            .iter()
            .find(|(_, words)| words.iter().any(|word| names.contains(&word.as_str())))
            .map(|(value, _)| *value)
    };
    let (told, detected) = (of(&CLEAR), of(&DETECTED));
    #[expect(clippy::cast_possible_truncation, reason = "whole, and small")]
    let start =
        candidate.variable.numeric_start().first().filter(|v| v.fract() == 0.0 && v.abs() < 1e9).map(|v| *v as i64);
    let clear = told.or_else(|| start.filter(|start| Some(*start) != detected));
    let confidence = if told.is_some() && detected.is_some() { 0.8 } else { 0.5 };
    Some((Role::SensorNumber { clear, detected }, confidence))
}

/// The values in a description that means something by each, with the words of it: `1 = free, 0 = interrupted`, `TRUE: clear`.
fn numbered(description: &str) -> Vec<(i64, Vec<String>)> {
    let parts = description.split([',', ';', '(', ')', '/']);
    let split = |part: &str| {
        // `light curtain: 1 = free` names what it is before.
        let (number, meaning) = part.split_once('=').or_else(|| part.split_once(':'))?;
        let value = |word: &str| match word.to_lowercase().as_str() {
            "true" => Some(1),
            "false" => Some(0),
            number => number.parse::<i64>().ok(),
        };
        let as_number = |text: &str| text.split_whitespace().last().and_then(value);
        let told = as_number(number).map(|value| (value, words(meaning)));
        told.or_else(|| Some((value(meaning.trim())?, words(number))))
    };
    // What is not free is anything else.
    let is_plain =
        |(_, words): &(i64, Vec<String>)| !words.iter().any(|word| ["not", "no", "un"].contains(&word.as_str()));
    parts.filter_map(split).filter(is_plain).collect()
}

/// The value while a person is detected, if the name says it, or else the description, for one of the two values.
fn polarity(candidate: &Candidate<'_>) -> Option<bool> {
    let by = |clear: bool, detected: bool| match (clear, detected) {
        (true, false) => Some(false),
        (false, true) => Some(true),
        _ => None,
    };
    let values = numbered(&candidate.variable.description);
    let described = |(value, words): &(i64, Vec<String>)| {
        let has = |any: &[&str]| words.iter().any(|word| any.contains(&word.as_str()));
        // What true means, or the reverse of what false means.
        by(has(&CLEAR), has(&DETECTED)).map(|active| active == (*value != 0))
    };
    by(candidate.has(&CLEAR), candidate.has(&DETECTED)).or_else(|| values.iter().find_map(described))
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
