//! A first cell file for an FMU or a system: what its variables seem to be for, written down with how sure that is, and
//! a TODO for each thing that no FMU says.
//!
//! - [`roles`]: what the variables of an FMU seem to be for
//! - [`interface`]: those of an FMU or a system by the names that cell files use, with their roles
//!
//! A line with `# GUESS` is to be checked, one with `# TODO` to be filled in; `fmi-hazard check` lists those that are left.

pub mod interface;
pub mod roles;

use std::collections::BTreeMap;
use std::fmt::Write as _;

use self::interface::Interface;
use self::roles::{Guess, Role, words};
use super::sensor::kind::{Proposed, Recognised};
use super::sensor::{KINDS, SensorKind, mat, reported};
use crate::fmi::Causality;
use crate::geometry::kinematics::Motion;

/// Marks what has to be filled in.
pub const TODO: &str = "# TODO";

/// A guess with more confidence than this is not marked.
const SURE: f64 = 0.95;

/// What the draft is of, besides the variables.
#[derive(Clone, Debug, Default)]
pub struct Facts<'a> {
    /// Name of the cell.
    pub name: &'a str,
    /// The FMU, or the system, as the cell file is to name it.
    pub fmu: &'a str,
    /// A robot description.
    pub urdf: Option<Described<'a>>,
    /// Where the robot stands, m.
    pub base_m: Option<[f64; 3]>,
    /// Mass of what moves, kg.
    pub moving_mass_kg: Option<f64>,
    /// Where the person starts, m, and looks, degrees.
    pub start: Option<([f64; 2], f64)>,
}

/// What a robot description says.
#[derive(Clone, Debug)]
pub struct Described<'a> {
    /// As the cell file is to name it.
    pub path: &'a str,
    /// Its joints that move by themselves.
    pub joints: Vec<(String, Motion)>,
    /// Whether it says how heavy what moves is.
    pub has_masses: bool,
    /// Whether its collision shapes can be read.
    pub has_shapes: bool,
    /// Packages that the cell file has to name, and their folders.
    pub packages: &'a [(String, String)],
}

/// One robot of the draft.
#[derive(Default)]
struct Robot<'a> {
    angles: BTreeMap<usize, &'a Guess>,
    speeds: BTreeMap<usize, &'a Guess>,
}

/// The text of a cell file for an FMU or a system.
#[must_use]
pub fn draft(interface: &Interface<'_>, facts: &Facts<'_>) -> String {
    let roles = &interface.roles;
    let mut out = Out(String::new());
    out.line("#:schema ./cell.schema.json");
    out.line(&format!(
        "# The cell around {}. GUESS 0.62: from names and units, 1 is sure; check it and remove the word.",
        facts.fmu
    ));
    out.line(
        "# Fill in what is marked as to do. Then: fmi-hazard check <this file>. World: z up, floor at z = 0, metres.",
    );
    out.line("schema = 1");
    out.line(&format!("name = {}", quoted(facts.name)));
    out.line(&format!("fmu = {}", quoted(facts.fmu)));
    out.line("");
    out.line("[time]");
    let step = step_s(interface.step_size);
    out.line(&format!("step_s = {step} # divides 0.2 s and is at most 0.02 s"));
    robots(&mut out, roles, facts);
    sensors(&mut out, interface);
    inputs(&mut out, interface);
    out.line("");
    out.line("# Fences, tables, machines: nobody walks or reaches through them.");
    out.line("# [[obstacle]]");
    out.line("# name = \"fence\"");
    out.line("# centre_m = [0, -1, 1]");
    out.line("# size_m = [3, 0.02, 2]");
    out.line("");
    out.line("[human]");
    match facts.start {
        Some(([x, y], heading)) => {
            out.line(&format!("start = {{ xy_m = [{x}, {y}], heading_deg = {heading} }}"));
        }
        None => out.line(&format!(
            "start = {{ xy_m = [0, -2], heading_deg = 90 }} {TODO} where the person begins and looks (0: +x, 90: +y)"
        )),
    }
    out.0
}

struct Out(String);

impl Out {
    fn line(&mut self, text: &str) {
        self.0.push_str(text);
        self.0.push('\n');
    }

    /// A line from a guess, marked unless it is sure.
    fn guessed(&mut self, text: &str, confidence: f64) {
        if confidence > SURE {
            self.line(text);
        } else {
            self.line(&format!("{text} # GUESS {confidence:.2}"));
        }
    }
}

/// A TOML string.
fn quoted(text: &str) -> String {
    toml::Value::String(text.to_owned()).to_string()
}

/// The FMU's own step if a scan can use it, else 0.02 s.
fn step_s(suggested: Option<f64>) -> f64 {
    let own = suggested.unwrap_or(0.02);
    let count = (0.2 / own).round();
    if own > 0.0 && own <= 0.02 && (0.2 / count - own).abs() < 1e-9 && count <= 1000.0 { own } else { 0.02 }
}

fn robots(out: &mut Out, roles: &[Guess], facts: &Facts<'_>) {
    let mut robots: BTreeMap<&str, Robot<'_>> = BTreeMap::new();
    let mut frames: BTreeMap<&str, BTreeMap<&str, &Guess>> = BTreeMap::new();
    for guess in roles {
        match &guess.role {
            Role::JointAngle { robot, number } => {
                let _ = robots.entry(robot).or_default().angles.insert(*number, guess);
            }
            Role::JointSpeed { robot, number } => {
                let _ = robots.entry(robot).or_default().speeds.insert(*number, guess);
            }
            Role::LinkPose { link, part } => {
                let _ = frames.entry(link).or_default().insert(part, guess);
            }
            _ => {}
        }
    }
    // Speeds may have another prefix than the angles they belong to: where there is one robot, they are its.
    let with_angles: Vec<&str> = robots.iter().filter(|(_, r)| !r.angles.is_empty()).map(|(name, _)| *name).collect();
    if let [only] = with_angles[..] {
        let speeds = robots.values_mut().filter(|r| r.angles.is_empty()).map(|r| std::mem::take(&mut r.speeds)).next();
        if let (Some(speeds), Some(robot)) = (speeds, robots.get_mut(only))
            && robot.speeds.is_empty()
        {
            robot.speeds = speeds;
        }
    }
    robots.retain(|_, robot| !robot.angles.is_empty());
    let count = robots.len();
    // Joints say more than poses of some of the links.
    frames.retain(|_, parts| ["x", "y", "z"].iter().all(|part| parts.contains_key(part)));
    // The first robot's is the first, and so on; one that there is once belongs to all.
    let of = |role: &Role, number: usize| {
        let all: Vec<&Guess> = roles.iter().filter(|guess| guess.role == *role).collect();
        let best = || all.iter().copied().max_by(|a, b| a.confidence.total_cmp(&b.confidence));
        if all.len() == count.max(1) { all.get(number).copied() } else { best() }
    };
    let robot_head = |out: &mut Out, name: &str, number: usize| {
        let (payload, phase) = (of(&Role::Payload, number), of(&Role::Phase, number));
        out.line("");
        out.line("[[robot]]");
        out.line(&format!("name = {}", quoted(name)));
        match facts.base_m {
            Some([x, y, z]) => out.line(&format!("base = {{ xyz_m = [{x}, {y}, {z}], rpy_deg = [0, 0, 0] }}")),
            None => {
                out.line(&format!("base = {{ xyz_m = [0, 0, 0], rpy_deg = [0, 0, 0] }} {TODO} where its base stands"))
            }
        }
        let masses = facts.urdf.as_ref().is_some_and(|urdf| urdf.has_masses);
        match (facts.moving_mass_kg, masses) {
            (Some(kg), _) => out.line(&format!("moving_mass_kg = {kg}")),
            (None, true) => out.line("# moving_mass_kg: from the masses in the URDF"),
            (None, false) => {
                out.line(&format!("# moving_mass_kg = 30 {TODO} mass of all moving parts, from its data sheet"));
            }
        }
        match payload {
            Some(guess) => {
                out.guessed(&format!("payload = {{ variable = {} }}", quoted(&guess.variable)), guess.confidence);
            }
            None => out.line(&format!("payload_kg = 0 {TODO} tool and workpiece")),
        }
        if let Some(guess) = phase {
            out.guessed(&format!("phase = {}", quoted(&guess.variable)), guess.confidence);
        }
    };
    for (number, (name, robot)) in robots.iter().enumerate() {
        robot_head(out, if count == 1 || name.is_empty() { "robot" } else { name }, number);
        joints(out, robot, facts.urdf.as_ref());
    }
    if robots.is_empty() && !frames.is_empty() {
        robot_head(out, "robot", 0);
        for (link, parts) in &frames {
            frame(out, link, parts);
        }
        shapes(out, frames.keys().next().unwrap_or(&"tool"), "frame");
    }
    if robots.is_empty() && frames.is_empty() {
        robot_head(out, "robot", 0);
        out.line(&format!("{TODO} no output looks like a joint angle or the pose of a link: say what moves the robot"));
        match &facts.urdf {
            Some(urdf) => joints(out, &Robot::default(), Some(urdf)),
            None => out
                .line("# [[robot.joint]]\n# name = \"joint_1\"\n# axis = [0, 0, 1]\n# angle = { variable = \"...\" }"),
        }
    }
}

fn joints(out: &mut Out, robot: &Robot<'_>, urdf: Option<&Described<'_>>) {
    if let Some(urdf) = urdf {
        out.line(&format!("urdf = {}", quoted(urdf.path)));
        if !urdf.packages.is_empty() {
            let folders = urdf.packages.iter().map(|(name, folder)| format!("{} = {}", quoted(name), quoted(folder)));
            out.line(&format!("packages = {{ {} }}", folders.collect::<Vec<_>>().join(", ")));
        }
        if !urdf.has_shapes {
            out.line("urdf_shapes = false # they cannot be used (init says why): give shapes below");
        }
    }
    // Joints of the URDF by name where the variables have it, else one after the other.
    let told: Option<Vec<&(String, Motion)>> = urdf.map(|urdf| urdf.joints.iter().collect());
    let numbers: Vec<usize> = robot.angles.keys().copied().collect();
    let named = |name: &str| {
        let wanted: Vec<String> = words(name).into_iter().filter(|word| word != "joint").collect();
        // A number says which one in a row it is, not what it is called.
        let telling = wanted.iter().any(|word| word.parse::<u32>().is_err() && word.len() > 1);
        numbers.iter().copied().find(|n| {
            let has = words(&robot.angles[n].variable);
            telling && wanted.iter().all(|word| has.contains(word))
        })
    };
    let motion = |out: &mut Out, number: usize, slides: bool, most: f64| {
        let key = if slides { "position" } else { "angle" };
        let guess = robot.angles[&number];
        out.guessed(&format!("{key} = {{ variable = {} }}", quoted(&guess.variable)), guess.confidence.min(most));
        match robot.speeds.get(&number) {
            Some(guess) => {
                out.guessed(&format!("speed = {{ variable = {} }}", quoted(&guess.variable)), guess.confidence);
            }
            None => out.line("# no speed among the outputs: it is differentiated"),
        }
    };
    match told {
        Some(joints) => {
            let turning: Vec<&str> =
                joints.iter().filter(|(_, kind)| *kind == Motion::Revolute).map(|(name, _)| name.as_str()).collect();
            for (name, kind) in joints {
                out.line("");
                out.line("[[robot.joint]]");
                out.line(&format!("name = {}", quoted(name)));
                let slides = *kind == Motion::Prismatic;
                // In the order of the tree: to be checked.
                let in_order =
                    || turning.iter().position(|other| other == name).and_then(|at| numbers.get(at).copied());
                match named(name).or_else(in_order) {
                    Some(number) => motion(out, number, slides, 0.9),
                    None if slides => out.line(&format!("held_m = 0 {TODO} or position = {{ variable = \"...\" }}")),
                    None => out.line(&format!("held_deg = 0 {TODO} or angle = {{ variable = \"...\" }}")),
                }
            }
            if urdf.is_some_and(|urdf| !urdf.has_shapes) {
                shapes(out, urdf.and_then(|urdf| urdf.joints.last()).map_or("joint", |(name, _)| name), "joint");
            }
        }
        None => {
            for number in &numbers {
                out.line("");
                out.line("[[robot.joint]]");
                out.line(&format!("name = \"joint_{number}\""));
                out.line("origin = { xyz_m = [0, 0, 0] }");
                out.line(&format!(
                    "# axis = [0, 0, 1] {TODO} axis, and origin in the frame of the joint before; or a `urdf`"
                ));
                motion(out, *number, false, 1.0);
            }
            shapes(out, &format!("joint_{}", numbers.last().unwrap_or(&1)), "joint");
        }
    }
}

fn frame(out: &mut Out, link: &str, parts: &BTreeMap<&str, &Guess>) {
    out.line("");
    out.line("[[robot.frame]]");
    out.line(&format!("name = {}", quoted(link)));
    for (key, wanted) in [
        ("position", &["x", "y", "z"][..]),
        ("quaternion", &["qw", "qx", "qy", "qz"]),
        ("velocity", &["vx", "vy", "vz"]),
        ("angular_velocity", &["wx", "wy", "wz"]),
    ] {
        let found: Vec<&&Guess> = wanted.iter().filter_map(|part| parts.get(part)).collect();
        if found.len() == wanted.len() {
            let names: Vec<String> = found.iter().map(|guess| quoted(&guess.variable)).collect();
            let confidence = found.iter().map(|guess| guess.confidence).fold(1.0, f64::min);
            out.guessed(&format!("{key} = [{}]", names.join(", ")), confidence);
        }
    }
}

/// Where the shapes of a robot would stand.
fn shapes(out: &mut Out, on: &str, key: &str) {
    out.line("");
    out.line(&format!("{TODO} shapes of the robot's parts, one table each: capsule, hull_m or mesh"));
    out.line("# [[robot.link]]");
    out.line("# name = \"gripper\"");
    out.line(&format!("# {key} = {}", quoted(on)));
    out.line("# capsule = { from_m = [0, 0, 0], to_m = [0, 0, 0.1], radius_m = 0.08 }");
}

fn sensors(out: &mut Out, interface: &Interface<'_>) {
    let roles = &interface.roles;
    for guess in roles {
        let kind = match &guess.role {
            Role::SensorInput { .. } | Role::SensorNumber { .. } => kind(&guess.variable, interface),
            Role::SensorOutput { .. } => Kind::Seeing(reported::KIND, 0.9),
            _ => continue,
        };
        let Kind::Seeing(kind, sure) = kind else { continue };
        out.line("");
        out.line("[[sensor]]");
        out.line(&format!("name = {}", quoted(&guess.variable)));
        out.guessed(&format!("kind = \"{}\"", kind.key()), guess.confidence.min(sure));
        out.guessed(&format!("variable = {}", quoted(&guess.variable)), guess.confidence);
        match &guess.role {
            Role::SensorNumber { clear: Some(clear), detected: Some(detected) } => {
                let values = format!("values = {{ clear = {clear}, detected = {detected} }}");
                out.line(&format!(
                    "{values} # GUESS {:.2}: while nobody and while a person is detected",
                    guess.confidence
                ));
            }
            Role::SensorNumber { clear, .. } => {
                let clear = clear.unwrap_or(1);
                let values = format!("# values = {{ clear = {clear}, detected = {} }}", i64::from(clear == 0));
                out.line(&format!("{values} {TODO} its values while nobody and while a person is detected"));
            }
            Role::SensorInput { active: Some(active) } | Role::SensorOutput { active: Some(active) } => {
                out.line(&format!(
                    "active = {active} # GUESS {:.2}: its value while a person is detected; `fmi-hazard inspect --run` tries it",
                    guess.confidence
                ));
            }
            _ => out.line(&format!(
                "# active = false {TODO} its value while a person is detected; `fmi-hazard inspect --run` tries it"
            )),
        }
        if let Some(Proposed { zone, to_do }) = kind.proposed() {
            out.line(&format!("# zone = {zone} {TODO} {to_do}"));
        }
    }
    let human: Vec<&Guess> = roles.iter().filter(|guess| matches!(guess.role, Role::Human { .. })).collect();
    if !human.is_empty() {
        out.line("");
        out.line("# What the FMU is told of the person.");
        out.line("[pose]");
        for guess in human {
            if let Role::Human { quantity } = &guess.role {
                out.guessed(&format!("{quantity} = {}", quoted(&guess.variable)), guess.confidence);
            }
        }
    }
}

/// What a safety signal is of.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    /// A door, a button and the like, which the person leaves alone.
    Held,
    /// A sensor of this kind, and how much speaks for it at most.
    Seeing(SensorKind, f64),
}

/// The kind that the name of a signal says, else its description; a mat, which is as good as any, if neither does.
fn kind(variable: &str, interface: &Interface<'_>) -> Kind {
    let named = kind_by(&words(variable));
    let described = || {
        let (_, variable) = interface.variables.iter().find(|(name, _)| name == variable)?;
        kind_by(&words(&variable.description))
    };
    named.or_else(described).unwrap_or(Kind::Seeing(mat::KIND, 0.3))
}

fn kind_by(words: &[String]) -> Option<Kind> {
    const SURE: f64 = 0.9;
    let has = |any: &[&str]| words.iter().any(|word| any.contains(&word.as_str()));
    let by_own_words = |kind: &SensorKind| match kind.recognised() {
        Recognised::Held(words) => has(words).then_some(Kind::Held),
        Recognised::Sensor(words) => has(words).then_some(Kind::Seeing(*kind, SURE)),
        Recognised::Never => None,
    };
    if has(&["estop", "emergency"]) {
        return Some(Kind::Held);
    }
    KINDS.iter().rev().find_map(by_own_words)
}

/// Inputs that are held as they are while nothing happens.
fn inputs(out: &mut Out, interface: &Interface<'_>) {
    let roles = &interface.roles;
    let mut lines: Vec<(String, f64)> = Vec::new();
    for guess in roles {
        let value = match &guess.role {
            Role::SensorInput { active } if kind(&guess.variable, interface) == Kind::Held => {
                (!active.unwrap_or(false)).to_string()
            }
            Role::SensorNumber { clear: Some(clear), .. } if kind(&guess.variable, interface) == Kind::Held => {
                clear.to_string()
            }
            Role::Constant if interface.is_boolean(&guess.variable) => "false".to_owned(),
            Role::Constant => interface.start(&guess.variable),
            _ => continue,
        };
        lines.push((format!("{} = {value}", quoted(&guess.variable)), guess.confidence.min(0.9)));
    }
    if !lines.is_empty() {
        out.line("");
        out.line("# Held as they are while nobody touches them: doors closed, no button pressed. A door that the person can open is");
        out.line("# a sensor of kind interlocked_door instead.");
        out.line("[inputs]");
        lines.iter().for_each(|(line, confidence)| out.guessed(line, *confidence));
    }
    let used = |name: &str| {
        roles.iter().any(|guess| guess.variable == name || guess.variable.starts_with(&format!("{name}[")))
    };
    let left = interface.variables.iter().filter(|(name, v)| v.causality == Causality::Input && !used(name));
    let mut text = String::new();
    for (name, _) in left {
        let _ = write!(text, "\n#   {}", name.escape_default());
    }
    if !text.is_empty() {
        out.line("");
        out.line(&format!("# Inputs left at the FMU's start values:{text}"));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Joint and variable of each pair in the draft, with the rest of the line.
    fn pairs(variables: &[&str], joints: &[&str]) -> Vec<(String, String)> {
        let role = |(number, variable): (usize, &&str)| Guess {
            variable: (*variable).to_owned(),
            local: false,
            role: Role::JointAngle { robot: "r".to_owned(), number: number + 1 },
            confidence: 0.97,
        };
        let roles: Vec<Guess> = variables.iter().enumerate().map(role).collect();
        let joints = joints.iter().map(|name| ((*name).to_owned(), Motion::Revolute)).collect();
        let urdf = Described { path: "r.urdf", joints, has_masses: true, has_shapes: true, packages: &[] };
        let facts = Facts { name: "x", fmu: "x.fmu", urdf: Some(urdf), ..Facts::default() };
        let text = draft(&Interface { roles, ..Interface::default() }, &facts);
        let after = |line: &str, key: &str| line.strip_prefix(key).map(str::to_owned);
        let names = text.lines().filter_map(|line| after(line, "name = ")).skip(2);
        let angles = text.lines().filter_map(|line| after(line, "angle = { variable = "));
        names.zip(angles).collect()
    }

    #[test]
    fn a_robot_description_is_used_where_no_output_looks_like_an_angle() {
        let joints = vec![("table".to_owned(), Motion::Revolute)];
        let urdf = Described { path: "r.urdf", joints, has_masses: true, has_shapes: true, packages: &[] };
        let facts = Facts { name: "x", fmu: "x.fmu", urdf: Some(urdf), ..Facts::default() };
        let text = draft(&Interface::default(), &facts);
        assert!(text.contains("urdf = \"r.urdf\"") && text.contains("name = \"table\"\nheld_deg = 0 # TODO"), "{text}");
    }

    #[test]
    fn numbers_in_names_do_not_pair_joints_but_words_do() {
        // The robot's own number is none of a joint; pairs by order are to be checked.
        let variables = ["robot2.q[1]", "robot2.q[2]", "robot2.q[3]"];
        let in_order = pairs(&variables, &["joint_1", "joint_2", "joint_3"]);
        let expected: Vec<(String, String)> =
            (1..=3).map(|n| (format!("\"joint_{n}\""), format!("\"robot2.q[{n}]\" }} # GUESS 0.90"))).collect();
        assert_eq!(in_order, expected);
        let named = pairs(&["elbow_angle", "shoulder_pan_angle"], &["shoulder_pan_joint", "elbow_joint"]);
        assert!(
            named[0].1.starts_with("\"shoulder_pan_angle\"") && named[1].1.starts_with("\"elbow_angle\""),
            "{named:?}"
        );
    }
}
