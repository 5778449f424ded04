//! What in a cell can be turned to make it safer: speeds and lengths that its FMUs have as parameters, sensor zones, heights
//! of fences, and where robots stand. Each turns a cell file, as a TOML table, into another one.

use toml::{Table, Value};

use super::validate::Workcell;
use super::{Zone, binding::BoundUnit};
use crate::fmi::{Causality, Variable, VariableType};
use crate::geometry::Vec3;
use crate::geometry::polygon::widened;

/// What is turned.
#[derive(Clone, Debug, PartialEq)]
enum Turn {
    /// A parameter to `value * (1 - amount)`.
    Slower { parameter: String, value: f64, unit: String },
    /// A parameter to `value + sign * amount`.
    Length { parameter: String, value: f64, unit: String, per_m: f64, sign: f64 },
    /// Every edge of a sensor's polygon outwards.
    Wider { sensor: usize },
    /// The upper end of a light curtain up.
    HigherCurtain { sensor: usize },
    /// A light curtain across its plane, away from the robot.
    FartherCurtain { sensor: usize, direction: [f64; 2] },
    /// The top of a box up.
    Higher { obstacle: usize },
    /// The underside of a box down.
    Lower { obstacle: usize },
    /// A robot away from the person.
    FartherRobot { robot: usize, direction: [f64; 2] },
}

/// Something to turn, and how far.
#[derive(Clone, Debug, PartialEq)]
pub struct Knob {
    turn: Turn,
    /// Name of the sensor, box or robot, as people know it.
    name: String,
    /// Steps to try at most; see [`Knob::amount`].
    pub steps: u32,
}

/// One step of a length, m, or of a speed, as a part of it.
const STEP: f64 = 0.01;

/// Farthest that a length is changed, in steps: 1.5 m.
const FARTHEST: u32 = 150;

/// Most that a speed is reduced, in steps: to nothing.
const SLOWEST: u32 = 100;

/// Who could be hit by what: which way is away.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Encounter {
    /// Where the person stands, floor plan, m.
    pub person_m: [f64; 2],
    /// The robot that hits.
    pub robot: usize,
}

impl Knob {
    /// Everything in a cell that can be turned against `encounter`, the more usual first. `text` is its file.
    #[must_use]
    pub fn all(cell: &Workcell, text: &Table, units: &[BoundUnit<'_>], encounter: &Encounter) -> Vec<Self> {
        let mut knobs = Vec::new();
        let mut add = |turn, name: &str, steps| {
            if steps > 0 {
                knobs.push(Self { turn, name: name.to_owned(), steps });
            }
        };
        let parameters = parameters(text, units);
        for Parameter { name, value, unit, quantity, min, .. } in &parameters {
            if *quantity == Quantity::Speed && *value > 0.0 {
                let turn = Turn::Slower { parameter: name.clone(), value: *value, unit: unit.clone() };
                add(turn, name, steps_within((value - min.max(0.0)) / value).min(SLOWEST));
            }
        }
        let world_from_base = cell.robots[encounter.robot].world_from_base.translation;
        let away = nearest_axis([world_from_base.x - encounter.person_m[0], world_from_base.y - encounter.person_m[1]]);
        for (number, sensor) in cell.sensors.iter().enumerate() {
            match &sensor.zone {
                Zone::Mat(_) | Zone::Field(_) => add(Turn::Wider { sensor: number }, &sensor.name, FARTHEST),
                Zone::Curtain(plane) | Zone::Door(plane) => {
                    add(Turn::HigherCurtain { sensor: number }, &sensor.name, FARTHEST);
                    let normal = plane.rotation * Vec3::Y;
                    let side = if normal.dot(world_from_base - plane.centre) > 0.0 { -1.0 } else { 1.0 };
                    let direction = [side * normal.x, side * normal.y];
                    add(Turn::FartherCurtain { sensor: number, direction }, &sensor.name, FARTHEST);
                }
                // Its operator would have to move with it.
                Zone::TwoHand { .. } | Zone::Reported => {}
            }
        }
        for Parameter { name, value, unit, quantity, min, max } in &parameters {
            if let Quantity::Length { per_m } = *quantity {
                for (sign, room) in [(1.0, max - value), (-1.0, value - min)] {
                    let (parameter, unit) = (name.clone(), unit.clone());
                    let turn = Turn::Length { parameter, value: *value, unit, per_m, sign };
                    add(turn, name, steps_within(room / per_m));
                }
            }
        }
        for ((name, _), table) in cell.obstacles.iter().zip(&cell.obstacle_tables) {
            // Meshes are as high as they are.
            let Some(number) = *table else { continue };
            let Some((centre, size)) = upright_box(text, number) else { continue };
            add(Turn::Higher { obstacle: number }, name, FARTHEST);
            add(Turn::Lower { obstacle: number }, name, steps_within(centre[2] - size[2] / 2.0));
        }
        let robot = &cell.robots[encounter.robot];
        add(Turn::FartherRobot { robot: encounter.robot, direction: away }, &robot.name, FARTHEST);
        knobs
    }

    /// How far so many steps turn it: m, or for speeds a part of it.
    #[must_use]
    pub fn amount(&self, steps: u32) -> f64 {
        f64::from(steps) * STEP
    }

    /// The cell file with this turned by so many steps; nothing if the file is not as expected.
    #[must_use]
    pub fn turned(&self, text: &Table, steps: u32) -> Option<Table> {
        let amount = self.amount(steps);
        let mut text = text.clone();
        match &self.turn {
            Turn::Slower { parameter, .. } | Turn::Length { parameter, .. } => {
                let parameters = text.entry("parameters").or_insert_with(|| Value::Table(Table::new()));
                parameters.as_table_mut()?.insert(parameter.clone(), self.value(amount)?.into());
            }
            Turn::Wider { sensor } => {
                let polygon = item(&mut text, "sensor", *sensor)?.get_mut("zone")?.get_mut("polygon_m")?;
                let corners: Option<Vec<[f64; 2]>> = polygon.as_array()?.iter().map(numbers).collect();
                *polygon = Value::Array(widened(&corners?, amount).into_iter().map(list).collect());
            }
            Turn::HigherCurtain { sensor } => {
                let heights = item(&mut text, "sensor", *sensor)?.get_mut("zone")?.get_mut("heights_m")?;
                let [from, to] = numbers(heights)?;
                *heights = list([from, to + amount]);
            }
            Turn::FartherCurtain { sensor, direction } => {
                let line = item(&mut text, "sensor", *sensor)?.get_mut("zone")?.get_mut("line_m")?;
                let ends: Option<Vec<[f64; 2]>> = line.as_array()?.iter().map(numbers).collect();
                let moved = |[x, y]: [f64; 2]| list([x + amount * direction[0], y + amount * direction[1]]);
                *line = Value::Array(ends?.into_iter().map(moved).collect());
            }
            Turn::Higher { obstacle } | Turn::Lower { obstacle } => {
                let (mut centre, mut size) = upright_box(&text, *obstacle)?;
                let up = if matches!(self.turn, Turn::Higher { .. }) { 0.5 } else { -0.5 };
                centre[2] += up * amount;
                size[2] += amount;
                let table = item(&mut text, "obstacle", *obstacle)?;
                table.insert("centre_m".to_owned(), list(centre));
                table.insert("size_m".to_owned(), list(size));
            }
            Turn::FartherRobot { robot, direction } => {
                let table = item(&mut text, "robot", *robot)?;
                let base = table.entry("base").or_insert_with(|| Value::Table(Table::new())).as_table_mut()?;
                let [x, y, z] = base.get("xyz_m").map_or(Some([0.0; 3]), numbers)?;
                base.insert("xyz_m".to_owned(), list([x + amount * direction[0], y + amount * direction[1], z]));
            }
        }
        Some(text)
    }

    /// The parameter's value when turned.
    fn value(&self, amount: f64) -> Option<f64> {
        match &self.turn {
            Turn::Slower { value, .. } => Some(round(value * (1.0 - amount))),
            Turn::Length { value, per_m, sign, .. } => Some(round(value + sign * amount * per_m)),
            _ => None,
        }
    }

    /// What turning it by so many steps means, in words.
    #[must_use]
    pub fn words(&self, steps: u32) -> String {
        let (name, amount) = (&self.name, self.amount(steps));
        match &self.turn {
            Turn::Slower { value, unit, .. } | Turn::Length { value, unit, .. } => {
                let new = self.value(amount).unwrap_or(*value);
                let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
                format!("FMU parameter {name} = {new}{unit} instead of {value}{unit}")
            }
            Turn::Wider { .. } => format!("zone of {name} {amount:.2} m wider on every side"),
            Turn::HigherCurtain { .. } => format!("{name} {amount:.2} m higher"),
            Turn::FartherCurtain { .. } => format!("{name} {amount:.2} m farther from the robot"),
            Turn::Higher { .. } => format!("{name} {amount:.2} m higher"),
            Turn::Lower { .. } => format!("{name} {amount:.2} m farther down"),
            Turn::FartherRobot { direction, .. } => {
                format!("{name} {amount:.2} m farther away, towards {}", axis(*direction))
            }
        }
    }
}

/// What a parameter is.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Quantity {
    Speed,
    /// With so many of its units in a metre.
    Length {
        per_m: f64,
    },
}

/// A parameter of an FMU.
struct Parameter {
    /// With the unit's name in front, as in cell files.
    name: String,
    /// As the cell file sets it, else its start.
    value: f64,
    unit: String,
    quantity: Quantity,
    /// Limits that the FMU states.
    min: f64,
    max: f64,
}

/// Speeds and lengths among the parameters that a cell can set.
fn parameters(text: &Table, units: &[BoundUnit<'_>]) -> Vec<Parameter> {
    let set = text.get("parameters").and_then(Value::as_table);
    let mut found = Vec::new();
    for unit in units {
        for variable in &unit.description.variables {
            let name =
                if unit.name.is_empty() { variable.name.clone() } else { format!("{}:{}", unit.name, variable.name) };
            let VariableType::Real { min, max, .. } = &variable.kind else { continue };
            let (min, max) = (min.unwrap_or(f64::NEG_INFINITY), max.unwrap_or(f64::INFINITY));
            let Some((quantity, of)) = quantity(variable) else { continue };
            let own = set.and_then(|set| set.get(&name)).and_then(number);
            if let Some(value) = own.or_else(|| variable.numeric_start().first().copied()) {
                found.push(Parameter { name, value, unit: of, quantity, min, max });
            }
        }
    }
    found
}

/// Whether a parameter is a speed or a length: by its unit, or, for factors and percentages, by its words.
fn quantity(variable: &Variable) -> Option<(Quantity, String)> {
    let VariableType::Real { unit, .. } = &variable.kind else { return None };
    if variable.causality != Causality::Parameter || !variable.dimensions.is_empty() {
        return None;
    }
    let unit = unit.as_deref().unwrap_or_default();
    let words = format!("{} {}", variable.name, variable.description).to_lowercase();
    match unit {
        "m/s" | "mm/s" | "rad/s" | "deg/s" => Some((Quantity::Speed, unit.to_owned())),
        "m" => Some((Quantity::Length { per_m: 1.0 }, unit.to_owned())),
        "mm" => Some((Quantity::Length { per_m: 1000.0 }, unit.to_owned())),
        "" | "1" | "%" if ["speed", "velocity", "override"].iter().any(|word| words.contains(word)) => {
            Some((Quantity::Speed, if unit == "%" { unit.to_owned() } else { String::new() }))
        }
        _ => None,
    }
}

/// Centre and size of a box that is not tilted.
fn upright_box(text: &Table, number: usize) -> Option<([f64; 3], [f64; 3])> {
    let table = text.get("obstacle")?.as_array()?.get(number)?;
    let [roll, pitch, _] = table.get("rpy_deg").map_or(Some([0.0; 3]), numbers)?;
    (roll == 0.0 && pitch == 0.0).then_some(())?;
    Some((numbers(table.get("centre_m")?)?, numbers(table.get("size_m")?)?))
}

fn item<'a>(text: &'a mut Table, list: &str, number: usize) -> Option<&'a mut Table> {
    text.get_mut(list)?.as_array_mut()?.get_mut(number)?.as_table_mut()
}

#[expect(clippy::cast_precision_loss, reason = "a person wrote it")]
fn number(value: &Value) -> Option<f64> {
    value.as_float().or_else(|| value.as_integer().map(|whole| whole as f64))
}

fn numbers<const N: usize>(value: &Value) -> Option<[f64; N]> {
    let numbers: Option<Vec<f64>> = value.as_array()?.iter().map(number).collect();
    numbers?.try_into().ok()
}

fn list<const N: usize>(numbers: [f64; N]) -> Value {
    Value::Array(numbers.map(|number| Value::Float(round(number))).to_vec())
}

/// To the nanometre, or its like: sums of decimal fractions are written as people would.
fn round(value: f64) -> f64 {
    (value * 1e9).round() / 1e9
}

/// The axis of the floor plan that a direction is nearest to.
fn nearest_axis([x, y]: [f64; 2]) -> [f64; 2] {
    if x.abs() > y.abs() { [x.signum(), 0.0] } else { [0.0, y.signum()] }
}

fn axis(direction: [f64; 2]) -> &'static str {
    match direction {
        [x, _] if x > 0.0 => "+x",
        [x, _] if x < 0.0 => "-x",
        [_, y] if y > 0.0 => "+y",
        _ => "-y",
    }
}

/// Whole steps in a length, at most [`FARTHEST`].
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "bounded")]
fn steps_within(length: f64) -> u32 {
    ((length / STEP + 1e-9).floor().clamp(0.0, f64::from(FARTHEST))) as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    const CELL: &str = r#"
        [[robot]]
        [[robot]]
        base = { xyz_m = [1, 0.9, 0.6], rpy_deg = [0, 0, -90] }
        [[obstacle]]
        centre_m = [0, 0, 1.6]
        size_m = [0.6, 0.02, 0.8]
        rpy_deg = [0, 0, 30]
        [[sensor]]
        zone = { polygon_m = [[-1, -1.2], [1, -1.2], [1, 2], [-1, 2]] }
        [[sensor]]
        zone = { line_m = [[-1, 0], [1, 0]], heights_m = [0.3, 1.5] }
        [parameters]
        "plc:mode" = true
    "#;

    /// The cell after so many steps of a turn, and the words for it.
    fn turned(turn: Turn, steps: u32) -> (Table, String) {
        let table = CELL.parse().expect("it is TOML");
        let knob = Knob { turn, name: "it".to_owned(), steps: 150 };
        (knob.turned(&table, steps).expect("it can be turned"), knob.words(steps))
    }

    fn at<const N: usize>(table: &Table, list: &str, number: usize, path: &[&str]) -> [f64; N] {
        let item = &table[list].as_array().expect("a list")[number];
        numbers(path.iter().fold(item, |value, key| &value[*key])).expect("numbers")
    }

    #[test]
    fn parameters_are_set_beside_those_that_are() {
        let slower = |value| Turn::Slower { parameter: "plc:v".to_owned(), value, unit: "m/s".to_owned() };
        let (cell, words) = turned(slower(0.48), 8);
        assert_eq!(cell["parameters"]["plc:v"].as_float(), Some(0.4416));
        assert_eq!(cell["parameters"]["plc:mode"].as_bool(), Some(true));
        assert_eq!(words, "FMU parameter it = 0.4416 m/s instead of 0.48 m/s");
        assert_eq!(turned(slower(0.25), 100).0["parameters"]["plc:v"].as_float(), Some(0.0));
        let length = |per_m, sign| Turn::Length {
            parameter: "x".to_owned(),
            value: -2.4 * per_m,
            unit: String::new(),
            per_m,
            sign,
        };
        assert_eq!(turned(length(1.0, -1.0), 30).0["parameters"]["x"].as_float(), Some(-2.7));
        assert_eq!(turned(length(1000.0, 1.0), 30).0["parameters"]["x"].as_float(), Some(-2100.0));
    }

    #[test]
    fn shapes_and_places_change_as_the_words_say() {
        let (cell, words) = turned(Turn::Wider { sensor: 0 }, 60);
        let corners = cell["sensor"][0]["zone"]["polygon_m"].as_array().expect("a list");
        let corners: Vec<[f64; 2]> = corners.iter().map(|corner| numbers(corner).expect("numbers")).collect();
        assert_eq!(corners, [[-1.6, -1.8], [1.6, -1.8], [1.6, 2.6], [-1.6, 2.6]]);
        assert_eq!(words, "zone of it 0.60 m wider on every side");
        let (cell, _) = turned(Turn::HigherCurtain { sensor: 1 }, 25);
        assert_eq!(at(&cell, "sensor", 1, &["zone", "heights_m"]), [0.3, 1.75]);
        let (cell, words) = turned(Turn::FartherCurtain { sensor: 1, direction: [0.0, -1.0] }, 25);
        let line = cell["sensor"][1]["zone"]["line_m"].as_array().expect("a list");
        assert_eq!([numbers(&line[0]), numbers(&line[1])], [Some([-1.0, -0.25]), Some([1.0, -0.25])]);
        assert_eq!(words, "it 0.25 m farther from the robot");
        // A box of 0.8 m around 1.6 m: from 1.2 m to 2.0 m.
        for (turn, centre, size) in [(Turn::Higher { obstacle: 0 }, 1.7, 1.0), (Turn::Lower { obstacle: 0 }, 1.5, 1.0)]
        {
            let (cell, _) = turned(turn, 20);
            assert_eq!(at(&cell, "obstacle", 0, &["centre_m"]), [0.0, 0.0, centre]);
            assert_eq!(at(&cell, "obstacle", 0, &["size_m"]), [0.6, 0.02, size]);
        }
        let (cell, words) = turned(Turn::FartherRobot { robot: 1, direction: [1.0, 0.0] }, 35);
        assert_eq!(at(&cell, "robot", 1, &["base", "xyz_m"]), [1.35, 0.9, 0.6]);
        assert_eq!(words, "it 0.35 m farther away, towards +x");
        let (cell, _) = turned(Turn::FartherRobot { robot: 0, direction: [0.0, 1.0] }, 1);
        assert_eq!(at(&cell, "robot", 0, &["base", "xyz_m"]), [0.0, 0.01, 0.0]);
    }

    #[test]
    fn tilted_boxes_have_no_height_to_change() {
        let tilted: Table = CELL.replace("[0, 0, 30]", "[0, 5, 30]").parse().expect("it is TOML");
        assert_eq!(upright_box(&tilted, 0), None);
    }
}
