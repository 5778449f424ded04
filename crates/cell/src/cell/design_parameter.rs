//! What in a cell can be turned to make it safer: speeds, lengths, times and truth values that its FMUs have as parameters,
//! sensor zones, heights of fences, and where robots stand. Each turns a cell file, as a TOML table, into another one.

mod fmu_parameter;
mod range;
mod zones;

use toml::{Table, Value};

use self::fmu_parameter::{FmuParameter, Quantity, Setting, parameters};
use self::range::ParameterRange;
use super::binding::BoundUnit;
use super::sensor::mat;
use crate::cell::file::format::ParameterLimits;
use crate::cell::workcell::{Obstacle, Workcell};
use crate::fmi;
use crate::geometry::polygon::widened;
use crate::human::ControlledBy;

/// What is turned.
#[derive(Clone, Debug, PartialEq)]
enum Modification {
    /// A parameter to `value * (1 - amount)`.
    Slower { parameter: String, value: f64, unit: String },
    /// A parameter to `value + sign * amount`.
    Length { parameter: String, value: f64, unit: String, per_m: f64, sign: f64 },
    /// A parameter to `value + steps * step`.
    Time { parameter: String, value: f64, unit: String, step: f64 },
    /// A parameter to the other value.
    Flip { parameter: String, value: bool },
    /// Every edge of a sensor's polygon outwards.
    Wider { sensor: usize },
    /// The upper end of a light curtain up.
    HigherPlane { sensor: usize },
    /// The lower end of a light curtain down to the floor.
    DownToTheFloor { sensor: usize },
    /// A light curtain across its plane, away from the robot.
    FartherPlane { sensor: usize, direction: [f64; 2] },
    /// A mat behind a light curtain or door, from its plane towards the robot, that reports by the same input.
    MatBehind { sensor: usize, direction: [f64; 2] },
    /// The input of a sensor held once it has reported.
    Latched { sensor: usize },
    /// The tops of boxes up.
    Higher { obstacles: Vec<usize> },
    /// The underside of a box down.
    Lower { obstacle: usize },
    /// A robot away from the person.
    FartherRobot { robot: usize, direction: [f64; 2] },
    /// A control to where it is not worked while the person is in the cell.
    NotOperable { control: usize, by: ControlledBy },
}

/// Something to turn, and how far.
#[derive(Clone, Debug, PartialEq)]
pub struct DesignParameter {
    turn: Modification,
    /// Name of the sensor, box or robot, as people know it.
    name: String,
    /// Steps to try at most. One is 0.01 m of a length, a hundredth of a speed. Of a time it is a fiftieth, or 0.02 s if that
    /// is more and the time becomes longer.
    pub steps: u32,
    room: ParameterRange,
}

/// One step of a length, m, or of a speed, as a part of it.
const STEP: f64 = 0.01;

/// Farthest that a length is changed, in steps: 1.5 m.
const FARTHEST: u32 = 150;

/// Most that a speed is reduced, in steps: to nothing.
const SLOWEST: u32 = 100;

/// One step of a time, as a part of it.
const TIME_STEP: f64 = 0.02;

/// Least step of a time that becomes longer, s.
const LEAST_TIME_STEP_S: f64 = 0.02;

/// Farthest that a time is made longer, in steps: to three times what it is, at least 2 s longer.
const LONGEST: u32 = 100;

/// Who could be hit by what: which way is away.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Encounter {
    /// Where the person stands, floor plan, m.
    pub person_m: [f64; 2],
    /// The robot that hits.
    pub robot: usize,
}

/// What can be turned in a cell, and what its file keeps from being turned.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DesignParameters {
    /// What can, the more usual first.
    pub turned: Vec<DesignParameter>,
    /// What cannot, with the reason.
    pub held: Vec<(String, String)>,
}

/// Why something that is `fixed` is not turned.
const FIXED: &str = "the cell file says that it is fixed";

impl DesignParameters {
    fn add(&mut self, turn: Modification, name: &str, room: ParameterRange) {
        if room.steps > 0 {
            self.turned.push(DesignParameter { turn, name: name.to_owned(), steps: room.steps, room });
        } else if let Some(end) = room.end {
            self.held.push((name.to_owned(), end));
        }
    }

    fn hold(&mut self, name: &str, cause: &str) {
        self.held.push((name.to_owned(), cause.to_owned()));
    }

    /// Everything in a cell that can be turned against `encounter`. `text` is its file.
    #[must_use]
    pub fn of(cell: &Workcell, text: &Table, units: &[BoundUnit<'_>], encounter: &Encounter) -> Self {
        let mut knobs = Self::default();
        let explain = &cell.file().explain;
        let parameters = parameters(text, units);
        let limits = |name: &str| explain.parameters.get(name).map(|limits| *limits.get_ref()).unwrap_or_default();
        for FmuParameter { name, unit, setting } in &parameters {
            let limits = limits(name);
            match *setting {
                _ if limits.fixed => knobs.hold(name, FIXED),
                Setting::Number { value, quantity: Quantity::Speed, .. } if value > 0.0 && limits.never_smaller => {
                    knobs.hold(name, SMALLER);
                }
                Setting::Number { value, quantity: Quantity::Speed, min, .. } if value > 0.0 => {
                    let turn = Modification::Slower { parameter: name.clone(), value, unit: unit.clone() };
                    let allowed = limits.least.map(|least| ((value - least) / value, least_words(least, unit)));
                    knobs.add(turn, name, ParameterRange::new(STEP, (value - min.max(0.0)) / value, SLOWEST, allowed));
                }
                Setting::Number { value, quantity: Quantity::Time { per_s }, min, max } => {
                    knobs.times(name, unit, [value, per_s, min, max], &limits);
                }
                Setting::Flag(value) => {
                    let room = ParameterRange { steps: 1, ..ParameterRange::default() };
                    knobs.add(Modification::Flip { parameter: name.clone(), value }, name, room);
                }
                Setting::Number { .. } => {}
            }
        }
        for (number, control) in cell.controls.iter().enumerate().filter(|(_, c)| c.by != ControlledBy::Nobody) {
            let turn = Modification::NotOperable { control: number, by: control.by };
            knobs.add(turn, &control.name, ParameterRange { steps: 1, ..ParameterRange::default() });
        }
        knobs.sensors(cell, encounter);
        for FmuParameter { name, unit, setting } in &parameters {
            if let Setting::Number { value, quantity: Quantity::Length { per_m }, min, max } = *setting {
                knobs.lengths(name, unit, [value, per_m, min, max], &limits(name));
            }
        }
        for name in explain.parameters.keys().filter(|name| parameters.iter().all(|known| known.name != **name)) {
            knobs.hold(name, "it is no speed, length, time or truth value, and is never changed");
        }
        // What the programme moves is as high as it is.
        let still = cell.obstacles.iter().filter(|obstacle| obstacle.follows.is_none());
        knobs.fences(cell, text);
        for Obstacle { name, table, .. } in still {
            // Meshes are as high as they are.
            let Some(number) = *table else { continue };
            let Some((centre, size)) = upright_box(text, number) else { continue };
            let limits = explain.obstacle.get(name).map(|limits| *limits.get_ref()).unwrap_or_default();
            if limits.fixed {
                knobs.hold(name, FIXED);
                continue;
            }
            let [underside, top] = [-0.5, 0.5].map(|half| centre[2] + half * size[2]);
            let higher = limits.most_top_m.map(|most| (most - top, most_words(most, "m")));
            knobs.add(
                Modification::Higher { obstacles: vec![number] },
                name,
                ParameterRange::new(STEP, f64::INFINITY, FARTHEST, higher),
            );
            let lower = limits.least_underside_m.map(|least| (underside - least, least_words(least, "m")));
            knobs.add(
                Modification::Lower { obstacle: number },
                name,
                ParameterRange::new(STEP, underside, FARTHEST, lower),
            );
        }
        let robot = &cell.robots[encounter.robot];
        let limits = explain.robot.get(&robot.name).map(|limits| *limits.get_ref()).unwrap_or_default();
        if limits.fixed {
            knobs.hold(&robot.name, FIXED);
        } else {
            let world_from_base = robot.world_from_base.translation;
            let [x, y] = encounter.person_m;
            let direction = nearest_axis([world_from_base.x - x, world_from_base.y - y]);
            let turn = Modification::FartherRobot { robot: encounter.robot, direction };
            let allowed = limits.most_farther_m.map(|most| (most, most_words(most, "m")));
            knobs.add(turn, &robot.name, ParameterRange::new(STEP, f64::INFINITY, FARTHEST, allowed));
        }
        knobs
    }

    /// Panels of a fence that are as high as each other: who reaches over one of them reaches over all.
    fn fences(&mut self, cell: &Workcell, text: &Table) {
        let explain = &cell.file().explain.obstacle;
        let mut fences: Vec<(f64, Vec<usize>, Vec<&str>)> = Vec::new();
        for Obstacle { name, table, follows, .. } in &cell.obstacles {
            let limits = explain.get(name).map(|limits| *limits.get_ref()).unwrap_or_default();
            let Some(number) = table.filter(|_| follows.is_none() && !limits.fixed && limits.most_top_m.is_none())
            else {
                continue;
            };
            let Some((centre, size)) = upright_box(text, number) else { continue };
            if size[0].min(size[1]) > PANEL_M || size[2] < size[0].min(size[1]) {
                continue;
            }
            let top = centre[2] + 0.5 * size[2];
            match fences.iter_mut().find(|(known, ..)| (known - top).abs() < 1e-3) {
                Some((_, numbers, names)) => {
                    numbers.push(number);
                    names.push(name);
                }
                None => fences.push((top, vec![number], vec![name])),
            }
        }
        for (_, obstacles, names) in fences.into_iter().filter(|(_, numbers, _)| numbers.len() > 1) {
            let (last, others) = names.split_last().map_or((&"", &[][..]), |(last, others)| (last, others));
            let name = format!("{} and {last}", others.join(", "));
            self.add(
                Modification::Higher { obstacles },
                &name,
                ParameterRange::new(STEP, f64::INFINITY, FARTHEST, None),
            );
        }
    }

    /// A time, shorter and longer: `[value, per_s, min, max]`.
    fn times(&mut self, name: &str, unit: &str, [value, per_s, min, max]: [f64; 4], limits: &ParameterLimits) {
        let never = [limits.never_smaller, limits.never_larger];
        let possible = [value - min.max(0.0), max - value];
        let allowed = [
            limits.least.map(|least| (value - least, least_words(least, unit))),
            limits.most.map(|most| (most - value, most_words(most, unit))),
        ];
        let ways = time_steps(value, per_s, min, max).into_iter().zip(possible).zip(allowed).zip(never);
        for (number, ((((step, usual), possible), allowed), never)) in ways.enumerate() {
            if never {
                self.hold(name, [SMALLER, LARGER][number]);
            } else if step != 0.0 {
                let turn = Modification::Time { parameter: name.to_owned(), value, unit: unit.to_owned(), step };
                self.add(turn, name, ParameterRange::new(step.abs(), possible, usual, allowed));
            }
        }
    }

    /// A length, longer and shorter: `[value, per_m, min, max]`.
    fn lengths(&mut self, name: &str, unit: &str, [value, per_m, min, max]: [f64; 4], limits: &ParameterLimits) {
        // That it is fixed is told already.
        if limits.fixed {
            return;
        }
        let longer = limits.most.map(|most| ((most - value) / per_m, most_words(most, unit)));
        let shorter = limits.least.map(|least| ((value - least) / per_m, least_words(least, unit)));
        for (sign, room, allowed, never) in [
            (1.0, max - value, longer, limits.never_larger.then_some(LARGER)),
            (-1.0, value - min, shorter, limits.never_smaller.then_some(SMALLER)),
        ] {
            if let Some(never) = never {
                self.hold(name, never);
                continue;
            }
            let turn = Modification::Length { parameter: name.to_owned(), value, unit: unit.to_owned(), per_m, sign };
            self.add(turn, name, ParameterRange::new(STEP, room / per_m, FARTHEST, allowed));
        }
    }
}

/// Why something is not turned one way.
const SMALLER: &str = "the cell file says that it is never smaller";
const LARGER: &str = "the cell file says that it is never larger";

fn least_words(least: f64, unit: &str) -> String {
    format!("{} is the least that the cell file allows", with_unit(least, unit))
}

fn most_words(most: f64, unit: &str) -> String {
    format!("{} is the most that the cell file allows", with_unit(most, unit))
}

fn with_unit(value: f64, unit: &str) -> String {
    let value = fmi::number(value);
    if unit.is_empty() { value } else { format!("{value} {unit}") }
}

impl DesignParameter {
    /// What the cell file allows, if the steps end there.
    #[must_use]
    pub fn end(&self) -> Option<&str> {
        self.room.end.as_deref()
    }

    /// Whether it is a parameter of an FMU that may be about a safeguard: no speed.
    #[must_use]
    pub const fn may_set_a_safeguard(&self) -> bool {
        matches!(self.turn, Modification::Length { .. } | Modification::Time { .. } | Modification::Flip { .. })
    }

    /// Whether it is a time.
    #[must_use]
    pub const fn is_time(&self) -> bool {
        matches!(self.turn, Modification::Time { .. })
    }

    /// How much slower it makes something: the part of its speed that is left after so many steps.
    #[must_use]
    pub fn speed_left(&self, steps: u32) -> Option<f64> {
        matches!(self.turn, Modification::Slower { .. }).then(|| 1.0 - self.amount(steps))
    }

    /// How much farther away so many steps move a robot, m; nothing for other knobs.
    #[must_use]
    pub fn farther_m(&self, steps: u32) -> f64 {
        if matches!(self.turn, Modification::FartherRobot { .. }) { self.amount(steps) } else { 0.0 }
    }

    /// How far so many steps turn it: m, or for speeds a part of it.
    fn amount(&self, steps: u32) -> f64 {
        self.room.amount(steps, STEP)
    }

    /// The cell file with this turned by so many steps; nothing if the file is not as expected.
    #[must_use]
    pub fn turned(&self, text: &Table, steps: u32) -> Option<Table> {
        let amount = self.amount(steps);
        let mut text = text.clone();
        match &self.turn {
            Modification::Slower { parameter, .. }
            | Modification::Length { parameter, .. }
            | Modification::Time { parameter, .. }
            | Modification::Flip { parameter, .. } => {
                let parameters = text.entry("parameters").or_insert_with(|| Value::Table(Table::new()));
                parameters.as_table_mut()?.insert(parameter.clone(), self.value(steps)?);
            }
            Modification::Wider { sensor } => {
                let polygon = item(&mut text, "sensor", *sensor)?.get_mut("zone")?.get_mut("polygon_m")?;
                let corners: Option<Vec<[f64; 2]>> = polygon.as_array()?.iter().map(numbers).collect();
                *polygon = Value::Array(widened(&corners?, amount).into_iter().map(list).collect());
            }
            Modification::HigherPlane { sensor } => {
                let heights = item(&mut text, "sensor", *sensor)?.get_mut("zone")?.get_mut("heights_m")?;
                let [from, to] = numbers(heights)?;
                *heights = list([from, to + amount]);
            }
            Modification::DownToTheFloor { sensor } => {
                let heights = item(&mut text, "sensor", *sensor)?.get_mut("zone")?.get_mut("heights_m")?;
                let [_, to] = numbers(heights)?;
                *heights = list([0.0, to]);
            }
            Modification::FartherPlane { sensor, direction } => {
                let line = item(&mut text, "sensor", *sensor)?.get_mut("zone")?.get_mut("line_m")?;
                let ends: Option<Vec<[f64; 2]>> = line.as_array()?.iter().map(numbers).collect();
                let moved = |[x, y]: [f64; 2]| list([x + amount * direction[0], y + amount * direction[1]]);
                *line = Value::Array(ends?.into_iter().map(moved).collect());
            }
            Modification::Higher { obstacles } => {
                obstacles.iter().try_for_each(|obstacle| longer(&mut text, *obstacle, amount, 0.5))?;
            }
            Modification::Lower { obstacle } => longer(&mut text, *obstacle, amount, -0.5)?,
            Modification::Latched { sensor } => {
                item(&mut text, "sensor", *sensor)?.insert("latched".to_owned(), true.into());
            }
            Modification::MatBehind { sensor, direction } => {
                let plane = item(&mut text, "sensor", *sensor)?.clone();
                text.get_mut("sensor")?.as_array_mut()?.push(Value::Table(mat_behind(&plane, *direction, amount)?));
            }
            Modification::NotOperable { control, .. } => {
                item(&mut text, "control", *control)?.insert("by".to_owned(), "nobody".into());
            }
            Modification::FartherRobot { robot, direction } => {
                let table = item(&mut text, "robot", *robot)?;
                let base = table.entry("base").or_insert_with(|| Value::Table(Table::new())).as_table_mut()?;
                let [x, y, z] = base.get("xyz_m").map_or(Some([0.0; 3]), numbers)?;
                base.insert("xyz_m".to_owned(), list([x + amount * direction[0], y + amount * direction[1], z]));
            }
        }
        Some(text)
    }

    /// The parameter's value when turned.
    fn value(&self, steps: u32) -> Option<Value> {
        let amount = self.amount(steps);
        Some(match &self.turn {
            Modification::Slower { value, .. } => round(value * (1.0 - amount)).into(),
            Modification::Length { value, per_m, sign, .. } => round(value + sign * amount * per_m).into(),
            Modification::Time { value, step, .. } => {
                round(value + step.signum() * self.room.amount(steps, step.abs())).into()
            }
            Modification::Flip { value, .. } => (*value == (steps == 0)).into(),
            _ => return None,
        })
    }

    /// What turning it by so many steps means, in words.
    #[must_use]
    pub fn words(&self, steps: u32) -> String {
        let (name, amount) = (&self.name, self.amount(steps));
        match &self.turn {
            Modification::Slower { unit, .. } | Modification::Length { unit, .. } | Modification::Time { unit, .. } => {
                let told = |steps| self.value(steps).as_ref().and_then(number).unwrap_or_default();
                let (new, old) = (told(steps), told(0));
                let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
                format!("FMU parameter {name} = {new}{unit} instead of {old}{unit}")
            }
            Modification::Flip { value, .. } => format!("FMU parameter {name} = {} instead of {value}", !value),
            Modification::Wider { .. } => format!("zone of {name} {amount:.2} m wider on every side"),
            Modification::HigherPlane { .. } => format!("{name} {amount:.2} m higher"),
            Modification::DownToTheFloor { .. } => format!("{name} reaching down to the floor"),
            Modification::FartherPlane { .. } => format!("{name} {amount:.2} m farther from the robot"),
            Modification::Latched { .. } => {
                format!("{name} held once it has reported, until somebody resets it (stands for a change in the PLC)")
            }
            Modification::MatBehind { .. } => {
                format!("a mat behind {name}, {amount:.2} m deep, that reports by the same input")
            }
            Modification::Higher { .. } => format!("{name} {amount:.2} m higher"),
            Modification::Lower { .. } => format!("{name} {amount:.2} m farther down"),
            Modification::NotOperable { by: ControlledBy::Anyone, .. } => {
                format!("{name} has no effect while the person is in the cell")
            }
            Modification::NotOperable { .. } => format!("{name} out of reach of whoever is in the cell"),
            Modification::FartherRobot { direction, .. } => {
                format!("{name} {amount:.2} m farther away, towards {}", axis(*direction))
            }
        }
    }
}

/// Boxes that are no thicker than this are panels of a fence, m.
const PANEL_M: f64 = 0.15;

/// Makes a box longer, upwards with `half` 0.5 and downwards with -0.5.
fn longer(text: &mut Table, obstacle: usize, amount: f64, half: f64) -> Option<()> {
    let (mut centre, mut size) = upright_box(text, obstacle)?;
    centre[2] += half * amount;
    size[2] += amount;
    let table = item(text, "obstacle", obstacle)?;
    table.insert("centre_m".to_owned(), list(centre));
    table.insert("size_m".to_owned(), list(size));
    Some(())
}

/// A mat as wide as a plane, so deep behind it.
fn mat_behind(plane: &Table, direction: [f64; 2], deep_m: f64) -> Option<Table> {
    let line = plane.get("zone")?.get("line_m")?.as_array()?;
    let [a, b]: [[f64; 2]; 2] = [numbers(line.first()?)?, numbers(line.get(1)?)?];
    let behind = |at: [f64; 2]| [0, 1].map(|axis| at[axis] + deep_m * direction[axis]);
    let corners = [a, b, behind(b), behind(a)].map(list).to_vec();
    let name = format!("mat behind {}", plane.get("name")?.as_str()?);
    let mut mat = Table::from_iter([
        ("name".to_owned(), name.into()),
        ("kind".to_owned(), mat::KIND.key().into()),
        ("zone".to_owned(), Value::Table(Table::from_iter([("polygon_m".to_owned(), Value::Array(corners))]))),
    ]);
    for key in ["variable", "active", "delay_ms"] {
        if let Some(value) = plane.get(key) {
            mat.insert(key.to_owned(), value.clone());
        }
    }
    Some(mat)
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

/// The steps of a time, in its own unit, and how many there are: shorter, then longer.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "bounded")]
fn time_steps(value: f64, per_s: f64, min: f64, max: f64) -> [(f64, u32); 2] {
    let within = |room: f64, step: f64| (room / step + 1e-9).floor().clamp(0.0, f64::from(LONGEST)) as u32;
    let part = TIME_STEP * value.max(0.0);
    let longer = part.max(LEAST_TIME_STEP_S * per_s);
    let shorter = if part > 0.0 { within(value - min.max(0.0), part) } else { 0 };
    [(-part, shorter), (longer, within(max - value, longer))]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::error::Source;
    use crate::cell::file::validate::validate;

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
        name = "light"
        variable = "clear"
        zone = { line_m = [[-1, 0], [1, 0]], heights_m = [0.3, 1.5] }
        [[control]]
        [[control]]
        by = "anyone"
        [parameters]
        "plc:mode" = true
    "#;

    /// The cell after so many steps of a turn, and the words for it.
    fn turned(turn: Modification, steps: u32) -> (Table, String) {
        let table = CELL.parse().expect("it is TOML");
        let knob = DesignParameter { turn, name: "it".to_owned(), steps: 150, room: ParameterRange::default() };
        (knob.turned(&table, steps).expect("it can be turned"), knob.words(steps))
    }

    fn at<const N: usize>(table: &Table, list: &str, number: usize, path: &[&str]) -> [f64; N] {
        let item = &table[list].as_array().expect("a list")[number];
        numbers(path.iter().fold(item, |value, key| &value[*key])).expect("numbers")
    }

    #[test]
    fn parameters_are_set_beside_those_that_are() {
        let slower = |value| Modification::Slower { parameter: "plc:v".to_owned(), value, unit: "m/s".to_owned() };
        let (cell, words) = turned(slower(0.48), 8);
        assert_eq!(cell["parameters"]["plc:v"].as_float(), Some(0.4416));
        assert_eq!(cell["parameters"]["plc:mode"].as_bool(), Some(true));
        assert_eq!(words, "FMU parameter it = 0.4416 m/s instead of 0.48 m/s");
        assert_eq!(turned(slower(0.25), 100).0["parameters"]["plc:v"].as_float(), Some(0.0));
        let length = |per_m, sign| Modification::Length {
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
        let (cell, words) = turned(Modification::Wider { sensor: 0 }, 60);
        let corners = cell["sensor"][0]["zone"]["polygon_m"].as_array().expect("a list");
        let corners: Vec<[f64; 2]> = corners.iter().map(|corner| numbers(corner).expect("numbers")).collect();
        assert_eq!(corners, [[-1.6, -1.8], [1.6, -1.8], [1.6, 2.6], [-1.6, 2.6]]);
        assert_eq!(words, "zone of it 0.60 m wider on every side");
        let (cell, _) = turned(Modification::HigherPlane { sensor: 1 }, 25);
        assert_eq!(at(&cell, "sensor", 1, &["zone", "heights_m"]), [0.3, 1.75]);
        let (cell, words) = turned(Modification::DownToTheFloor { sensor: 1 }, 1);
        assert_eq!(at(&cell, "sensor", 1, &["zone", "heights_m"]), [0.0, 1.5]);
        assert_eq!(words, "it reaching down to the floor");
        let (cell, words) = turned(Modification::FartherPlane { sensor: 1, direction: [0.0, -1.0] }, 25);
        let line = cell["sensor"][1]["zone"]["line_m"].as_array().expect("a list");
        assert_eq!([numbers(&line[0]), numbers(&line[1])], [Some([-1.0, -0.25]), Some([1.0, -0.25])]);
        assert_eq!(words, "it 0.25 m farther from the robot");
        // A box of 0.8 m around 1.6 m: from 1.2 m to 2.0 m.
        for (turn, centre, size) in
            [(Modification::Higher { obstacles: vec![0] }, 1.7, 1.0), (Modification::Lower { obstacle: 0 }, 1.5, 1.0)]
        {
            let (cell, _) = turned(turn, 20);
            assert_eq!(at(&cell, "obstacle", 0, &["centre_m"]), [0.0, 0.0, centre]);
            assert_eq!(at(&cell, "obstacle", 0, &["size_m"]), [0.6, 0.02, size]);
        }
        let (cell, words) = turned(Modification::Latched { sensor: 1 }, 1);
        assert_eq!(cell["sensor"][1]["latched"].as_bool(), Some(true));
        assert!(words.starts_with("it held once it has reported"), "{words}");
        let (cell, words) = turned(Modification::MatBehind { sensor: 1, direction: [0.0, 1.0] }, 60);
        let mat = &cell["sensor"].as_array().expect("a list")[2];
        let corners = mat["zone"]["polygon_m"].as_array().expect("a list");
        let corners: Vec<[f64; 2]> = corners.iter().map(|corner| numbers(corner).expect("numbers")).collect();
        assert_eq!(corners, [[-1.0, 0.0], [1.0, 0.0], [1.0, 0.6], [-1.0, 0.6]]);
        assert_eq!((mat["name"].as_str(), mat["variable"].as_str()), (Some("mat behind light"), Some("clear")));
        assert_eq!(words, "a mat behind it, 0.60 m deep, that reports by the same input");
        let (cell, words) = turned(Modification::FartherRobot { robot: 1, direction: [1.0, 0.0] }, 35);
        assert_eq!(at(&cell, "robot", 1, &["base", "xyz_m"]), [1.35, 0.9, 0.6]);
        assert_eq!(words, "it 0.35 m farther away, towards +x");
        for (by, says) in [
            (ControlledBy::Person, "it out of reach of whoever is in the cell"),
            (ControlledBy::Anyone, "it has no effect while the person is in the cell"),
        ] {
            let (cell, words) = turned(Modification::NotOperable { control: 1, by }, 1);
            assert_eq!((cell["control"][1]["by"].as_str(), words.as_str()), (Some("nobody"), says));
        }
        let (cell, _) = turned(Modification::FartherRobot { robot: 0, direction: [0.0, 1.0] }, 1);
        assert_eq!(at(&cell, "robot", 0, &["base", "xyz_m"]), [0.0, 0.01, 0.0]);
    }

    #[test]
    fn times_go_both_ways_and_truth_values_to_the_other_one() {
        let time = |step| Modification::Time { parameter: "t".to_owned(), value: 0.5, unit: "s".to_owned(), step };
        let (cell, words) = turned(time(-0.01), 20);
        assert_eq!(cell["parameters"]["t"].as_float(), Some(0.3));
        assert_eq!(words, "FMU parameter it = 0.3 s instead of 0.5 s");
        assert_eq!(time_steps(0.5, 1.0, 0.0, 1.0), [(-0.01, 50), (0.02, 25)]);
        assert_eq!(time_steps(3000.0, 1000.0, 2400.0, 1e9), [(-60.0, 10), (60.0, 100)]);
        assert_eq!(time_steps(0.0, 1.0, 0.0, 5.0), [(0.0, 0), (0.02, 100)]);
        let flip = Modification::Flip { parameter: "plc:mode".to_owned(), value: true };
        let (cell, words) = turned(flip, 1);
        assert_eq!(cell["parameters"]["plc:mode"].as_bool(), Some(false));
        assert_eq!(words, "FMU parameter it = false instead of true");
    }

    #[test]
    fn a_robot_goes_no_farther_than_the_cell_file_allows() {
        let farthest = |limits: &str| {
            let text = format!(
                "schema = 1\nname = \"t\"\nfmu = \"t.fmu\"\n[[robot]]\nname = \"r\"\nmoving_mass_kg = 40\n\
                 payload_kg = 3\n[[robot.joint]]\nname = \"table\"\naxis = [0, 0, 1]\n\
                 angle = {{ variable = \"q\", unit = \"rad\" }}\nspeed = {{ variable = \"qd\", unit = \"rad/s\" }}\n\
                 [[robot.link]]\nname = \"bar\"\njoint = \"table\"\n\
                 capsule = {{ from_m = [0, 0, 1], to_m = [0.8, 0, 1], radius_m = 0.05 }}\n\
                 [human]\nstart = {{ xy_m = [0, -3], heading_deg = 90 }}\n{limits}"
            );
            let cell = validate(&Source::new("t.toml", &text)).expect("it is a cell");
            let table: Table = text.parse().expect("it is TOML");
            let knobs = DesignParameters::of(&cell, &table, &[], &Encounter { person_m: [0.0, -3.0], robot: 0 });
            let robot = knobs.turned.iter().find(|knob| matches!(knob.turn, Modification::FartherRobot { .. }));
            let robot = robot.expect("it can be moved");
            (robot.farther_m(robot.steps), robot.end().map(str::to_owned))
        };
        // 150 steps of 0.01 m, unless the file says less.
        assert_eq!(farthest(""), (1.5, None));
        let words = "0.25 m is the most that the cell file allows".to_owned();
        assert_eq!(farthest("[explain.robot]\nr = { most_farther_m = 0.25 }\n"), (0.25, Some(words)));
    }

    #[test]
    fn tilted_boxes_have_no_height_to_change() {
        let tilted: Table = CELL.replace("[0, 0, 30]", "[0, 5, 30]").parse().expect("it is TOML");
        assert_eq!(upright_box(&tilted, 0), None);
    }
}
