//! The keys of a cell file that the cells of this test use. One robot, boxes along the axes, planes along x or y.

use std::path::{Path, PathBuf};

use toml::{Table, Value};

use super::force::Criterion;
use super::geometry::{M3, Solid, V3, add, length, rpy, scaled};

/// What moves a joint: FMU outputs with the sign of each, or nothing.
#[derive(Debug, Clone)]
pub struct Read {
    pub variable: String,
    pub sign: f64,
}

#[derive(Debug, Clone)]
pub struct Joint {
    pub name: String,
    pub origin: (M3, V3),
    pub axis: V3,
    pub slides: bool,
    pub value: Read,
    pub speed: Read,
}

/// A part of which the FMU gives the pose: position, quaternion, velocity, angular velocity.
#[derive(Debug, Clone)]
pub struct Frame {
    pub name: String,
    pub variables: Vec<String>,
}

#[derive(Debug, Clone)]
pub struct Link {
    pub name: String,
    pub on: String,
    pub core: [V3; 2],
    pub radius: f64,
}

#[derive(Debug, Clone)]
pub enum Zone {
    /// Mats and scanner fields: where a foot is seen.
    Floor(Vec<[f64; 2]>),
    /// Light curtains and doors: the ends and the heights.
    Plane([V3; 2]),
}

#[derive(Debug, Clone)]
pub struct Sensor {
    pub name: String,
    pub zone: Zone,
    pub variable: String,
    pub active: bool,
    /// Whether the FMU sees upright bodies itself.
    pub evaluated: bool,
    pub delay: usize,
}

#[derive(Debug, Clone)]
pub struct Cell {
    pub fmu: PathBuf,
    pub step: f64,
    pub actions: usize,
    /// `search.reach_tolerance_m`.
    pub tolerance: f64,
    /// `search.criterion`.
    pub criterion: Criterion,
    pub base: (M3, V3),
    pub joints: Vec<Joint>,
    pub frames: Vec<Frame>,
    pub links: Vec<Link>,
    pub moving_mass: f64,
    pub payload_kg: Option<f64>,
    pub payload: Option<String>,
    pub obstacles: Vec<Solid>,
    pub sensors: Vec<Sensor>,
    /// Inputs that tell where the person is: x (0) or y (1).
    pub pose: Vec<(String, usize)>,
    pub start: [f64; 2],
    pub heading: f64,
    pub lead_in: usize,
    /// How far what is held reaches beyond the finger tips.
    pub held: f64,
    pub inputs: Vec<(String, f64)>,
    pub parameters: Vec<(String, f64)>,
}

fn number(value: &Value) -> f64 {
    match value {
        Value::Float(x) => *x,
        Value::Integer(n) => f64::from(i32::try_from(*n).expect("a small number")),
        Value::Boolean(b) => f64::from(u8::from(*b)),
        other => panic!("no number: {other}"),
    }
}

fn numbers<const N: usize>(value: &Value) -> [f64; N] {
    let all: Vec<f64> = value.as_array().expect("a list").iter().map(number).collect();
    all.try_into().expect("so many numbers")
}

fn text(table: &Value, key: &str) -> String {
    table[key].as_str().expect("a text").to_owned()
}

fn pose(value: Option<&Value>) -> (M3, V3) {
    let part = |key: &str| value.and_then(|v| v.get(key)).map_or([0.0; 3], numbers);
    (rpy(part("rpy_deg")), part("xyz_m"))
}

fn list<'a>(table: &'a Value, key: &str) -> &'a [Value] {
    table.get(key).and_then(Value::as_array).map_or(&[], Vec::as_slice)
}

fn read(table: &Value, key: &str) -> Read {
    Read { variable: text(&table[key], "variable"), sign: table[key].get("sign").map_or(1.0, number) }
}

fn joint(table: &Value) -> Joint {
    let axis = numbers(&table["axis"]);
    let slides = table.get("position").is_some();
    Joint {
        name: text(table, "name"),
        origin: pose(table.get("origin")),
        axis: scaled(axis, 1.0 / length(axis)),
        slides,
        value: read(table, if slides { "position" } else { "angle" }),
        speed: read(table, "speed"),
    }
}

fn frame(table: &Value) -> Frame {
    let variables = ["position", "quaternion", "velocity", "angular_velocity"]
        .iter()
        .flat_map(|key| list(table, key).iter().map(|v| v.as_str().expect("a text").to_owned()))
        .collect();
    Frame { name: text(table, "name"), variables }
}

fn link(table: &Value) -> Link {
    let capsule = &table["capsule"];
    Link {
        name: text(table, "name"),
        on: text(table, if table.get("joint").is_some() { "joint" } else { "frame" }),
        core: [numbers(&capsule["from_m"]), numbers(&capsule["to_m"])],
        radius: number(&capsule["radius_m"]),
    }
}

fn obstacle(table: &Value) -> Solid {
    assert!(table.get("rpy_deg").is_none(), "boxes stand along the axes here");
    let (centre, half) = (numbers(&table["centre_m"]), scaled(numbers(&table["size_m"]), 0.5));
    Solid::Box { low: add(centre, scaled(half, -1.0)), high: add(centre, half) }
}

fn sensor(table: &Value, step: f64) -> Sensor {
    let zone = &table["zone"];
    let zone = match table["kind"].as_str().expect("a text") {
        "mat" | "scanner_field" => Zone::Floor(list(zone, "polygon_m").iter().map(numbers).collect()),
        "light_curtain" | "interlocked_door" => {
            let ends: Vec<[f64; 2]> = list(zone, "line_m").iter().map(numbers).collect();
            let [low, high] = numbers(&zone["heights_m"]);
            let along = |i: usize| (ends[0][i].min(ends[1][i]), ends[0][i].max(ends[1][i]));
            let ((x0, x1), (y0, y1)) = (along(0), along(1));
            assert!(x0 == x1 || y0 == y1, "planes stand along the axes here");
            Zone::Plane([[x0, y0, low], [x1, y1, high]])
        }
        other => panic!("no sensor of this kind here: {other}"),
    };
    let delay = table.get("delay_ms").map_or(0.0, number) / 1000.0;
    let delay = (0..64).find(|n| f64::from(*n) * step > delay - 1e-9).expect("63 steps at most");
    Sensor {
        name: text(table, "name"),
        zone,
        variable: text(table, "variable"),
        active: table["active"].as_bool().expect("true or false"),
        evaluated: table.get("evaluated").is_some(),
        delay: usize::try_from(delay).expect("not negative"),
    }
}

fn literals(file: &Table, key: &str) -> Vec<(String, f64)> {
    let table = file.get(key).and_then(Value::as_table);
    table.into_iter().flatten().map(|(name, value)| (name.clone(), number(value))).collect()
}

fn told_of_pose(file: &Table) -> Vec<(String, usize)> {
    let pose = file.get("pose").and_then(Value::as_table);
    let axis = |key: &str| ["x", "y"].iter().position(|axis| *axis == key).expect("x or y");
    pose.into_iter().flatten().map(|(key, name)| (name.as_str().expect("a text").to_owned(), axis(key))).collect()
}

impl Cell {
    pub fn read(path: &Path) -> Self {
        let file: Table = std::fs::read_to_string(path).expect("a file").parse().expect("TOML");
        let whole = Value::Table(file.clone());
        let [robot] = list(&whole, "robot") else { panic!("one robot") };
        let step = file.get("time").and_then(|t| t.get("step_s")).map_or(0.02, number);
        let start = &file["human"]["start"];
        for key in ["sex", "percentile", "radii_m", "bend_forward_deg", "bend_lateral_deg", "other_starts"] {
            assert!(file["human"].get(key).is_none(), "{key}: not written here");
        }
        let begins = list(&file["human"], "begins_s").first().map_or(0.0, number);
        let lead_in = (0..10_000).find(|n| f64::from(*n) * step > begins - 0.5 * step).expect("soon");
        let search = |key: &str| file.get("search").and_then(|s| s.get(key));
        let tolerance = search("reach_tolerance_m").map_or(0.02, number);
        let speed = file.get("criteria").and_then(|criteria| criteria.get("transient_force"));
        let criterion = match speed.map(|speed| speed.as_str().expect("a text")) {
            None | Some("absolute") => Criterion::Absolute,
            Some("approach") => Criterion::Approach,
            Some(other) => panic!("no criterion: {other}"),
        };
        let actions = search("actions").and_then(Value::as_integer).unwrap_or(8);
        Self {
            fmu: path.with_file_name(file["fmu"].as_str().expect("a text")),
            step,
            tolerance,
            criterion,
            actions: usize::try_from(actions).expect("not negative"),
            base: pose(robot.get("base")),
            joints: list(robot, "joint").iter().map(joint).collect(),
            frames: list(robot, "frame").iter().map(frame).collect(),
            links: list(robot, "link").iter().map(link).collect(),
            moving_mass: number(&robot["moving_mass_kg"]),
            payload_kg: robot.get("payload_kg").map(number),
            payload: robot.get("payload").map(|_| text(&robot["payload"], "variable")),
            obstacles: list(&whole, "obstacle").iter().map(obstacle).collect(),
            sensors: list(&whole, "sensor").iter().map(|s| sensor(s, step)).collect(),
            pose: told_of_pose(&file),
            start: numbers(&start["xy_m"]),
            heading: number(&start["heading_deg"]),
            lead_in: usize::try_from(lead_in).expect("not negative"),
            held: file["human"].get("held_m").map_or(0.0, number),
            inputs: literals(&file, "inputs"),
            parameters: literals(&file, "parameters"),
        }
    }

    /// Segments that hold the cores of all links at all times, with radii: where all joints slide between 0 and a stroke that
    /// is a parameter. Else one point, anywhere.
    pub fn sweep(&self) -> Vec<([V3; 2], f64)> {
        let stroke = |i: usize| self.parameters.iter().find(|p| p.0 == format!("axis.stroke[{}]", i + 1)).map(|p| p.1);
        let Some(strokes) = (0..self.joints.len()).map(stroke).collect::<Option<Vec<f64>>>() else {
            return vec![([[0.0; 3]; 2], f64::MAX)];
        };
        let link = |link: &Link| {
            let joints = self.joints.iter().position(|j| j.name == link.on).expect("a joint") + 1;
            let way: f64 = strokes[..joints].iter().sum();
            let [from, to] = link.core.map(|p| add(p, self.base.1));
            ([from, add(to, scaled(self.joints[0].axis, way))], link.radius)
        };
        self.links.iter().map(link).collect()
    }

    /// Communication steps of an action of 0.2 s.
    pub fn steps(&self) -> usize {
        (1..=1000).find(|n| f64::from(*n) * self.step > 0.2 - 1e-9).map_or(1, |n| usize::try_from(n).expect("small"))
    }
}
