//! What follows outputs of the FMU, stepped by hand: one plain instance, a communication step at a time, with rules and geometry of the
//! tests' own. Outputs are read after each step and in effect in the next one.

use std::path::Path;

use fmi_hazard::fmi::{Fmu, Plan};
use fmi_hazard::scan::Prepared;
use toml::{Table, Value};

use super::twin::body::{self, Body, Place, WALKS};
use super::twin::cell::Cell;
use super::twin::geometry::{Solid, V3, add, length, scaled};
use super::twin::planes::seen as seen_by;

/// While this output is in a range.
struct Band {
    output: usize,
    from: f64,
    to: f64,
}

impl Band {
    fn read(table: &Value, names: &[String]) -> Self {
        let [is, from, to] = ["is", "from", "to"].map(|key| table.get(key).map(number));
        let is = if from.is_some() || to.is_some() { None } else { Some(is.unwrap_or(1.0)) };
        let [from, to] = [is.or(from).unwrap_or(f64::MIN), is.or(to).unwrap_or(f64::MAX)];
        Self { output: output(table, names), from, to }
    }

    fn holds(&self, row: &[f64]) -> bool {
        row[self.output] >= self.from && row[self.output] <= self.to
    }
}

fn number(value: &Value) -> f64 {
    let whole = value.as_integer().or(value.as_bool().map(i64::from)).map(|n| f64::from(i32::try_from(n).unwrap()));
    value.as_float().or(whole).unwrap()
}

fn output(table: &Value, names: &[String]) -> usize {
    let name = table["variable"].as_str().unwrap();
    names.iter().position(|known| known == name).unwrap()
}

/// An obstacle where the cell file has it, when it stands, and the output that it moves with, to which of these places.
struct Thing {
    solid: Solid,
    stands: Option<Band>,
    moves: Option<(usize, V3, Vec<f64>)>,
}

impl Thing {
    fn read(solid: &Solid, table: &Value, names: &[String]) -> Self {
        let moves = table.get("moves_with").map(|way| {
            let along: Vec<f64> = way["direction"].as_array().unwrap().iter().map(number).collect();
            let along: V3 = along.try_into().unwrap();
            let [from, to] = ["from_m", "to_m"].map(|key| number(&way[key]));
            let every = way.get("every_m").map_or(0.05, number);
            let pieces = (1..).find(|n| (to - from) / f64::from(*n) <= every + 1e-9).unwrap();
            let at = |n: u32| from + (to - from) * f64::from(n) / f64::from(pieces);
            (output(way, names), scaled(along, 1.0 / length(along)), (0..=pieces).map(at).collect())
        });
        let stands = table.get("stands_while").map(|band| Band::read(band, names));
        Self { solid: solid.clone(), stands, moves }
    }

    /// Where it is, if it is there.
    fn now(&self, row: &[f64]) -> Option<Solid> {
        let (true, Solid::Box { low, high }) = (self.stands.as_ref().is_none_or(|band| band.holds(row)), &self.solid)
        else {
            return None;
        };
        let by = self.moves.as_ref().map_or([0.0; 3], |(output, along, places)| {
            let mut near: Vec<(f64, f64)> = places.iter().map(|at| ((at - row[*output]).abs(), *at)).collect();
            near.sort_by(|a, b| a.0.total_cmp(&b.0));
            assert!(near[1].0 - near[0].0 > 1e-6, "which place is nearest, rounding decides");
            scaled(*along, near[0].1)
        });
        Some(Solid::Box { low: add(*low, by), high: add(*high, by) })
    }
}

/// How far outside a box a place is, seen from above; inside less than 0.
fn outside(solid: &Solid, at: [f64; 2]) -> f64 {
    let Solid::Box { low, high } = solid else { return f64::INFINITY };
    let of = |axis: usize| (low[axis] - at[axis]).max(at[axis] - high[axis]);
    of(0).max(of(1))
}

/// What happened within an action, that would not have, had things stayed as they were at its beginning or sensors always counted.
#[derive(Default, Debug, Clone, Copy, PartialEq)]
pub struct Mattered {
    pub stopped: u32,
    pub let_through: u32,
    pub walked_out: u32,
    pub held: u32,
    pub unheeded: u32,
}

impl Mattered {
    pub fn add(&mut self, other: Self) {
        self.stopped += other.stopped;
        self.let_through += other.let_through;
        self.walked_out += other.walked_out;
        self.held += other.held;
        self.unheeded += other.unheeded;
    }
}

/// A sequence as it went, a row a communication step.
#[derive(Default)]
pub struct Went {
    pub places: Vec<[f64; 2]>,
    pub heads: Vec<V3>,
    pub readings: Vec<Vec<bool>>,
    pub inputs: Vec<f64>,
    pub outputs: Vec<f64>,
    pub mattered: Mattered,
}

/// One plain instance of the FMU, stepped with rules of the tests' own.
pub struct ByHand {
    cell: Cell,
    things: Vec<Thing>,
    counts: Vec<Option<Band>>,
    /// Columns of the library's rows.
    inputs: Vec<String>,
    outputs: Vec<String>,
    fmu: Fmu,
}

impl ByHand {
    pub fn new(file: &Path, prepared: &Prepared) -> Self {
        let cell = Cell::read(file);
        let table: Table = std::fs::read_to_string(file).unwrap().parse().unwrap();
        let [inputs, outputs] = [&prepared.binding.inputs, &prepared.binding.outputs]
            .map(|ports| ports.iter().map(|port| port.port.name.clone()).collect::<Vec<_>>());
        let list = |key: &str| table.get(key).and_then(Value::as_array).cloned().unwrap_or_default();
        let things = cell.obstacles.iter().zip(list("obstacle")).map(|(o, table)| Thing::read(o, &table, &outputs));
        let (things, sensors) = (things.collect(), list("sensor"));
        let counts = sensors.iter().map(|table| table.get("counts_while").map(|band| Band::read(band, &outputs)));
        let (counts, fmu) = (counts.collect(), Fmu::open(&cell.fmu).unwrap());
        Self { things, counts, inputs, outputs, fmu, cell }
    }

    /// What is where, as an FMU says it that has these outputs.
    fn standing(&self, row: &[f64]) -> Vec<Solid> {
        self.things.iter().filter_map(|thing| thing.now(row)).collect()
    }

    /// Inputs of the FMU while these sensors report.
    fn told(&self, reported: &[bool]) -> Vec<f64> {
        let told = |name: &String| {
            let mut sensors = self.cell.sensors.iter().zip(reported).filter(|(sensor, _)| sensor.variable == *name);
            let constant = || self.cell.inputs.iter().find(|input| input.0 == *name).unwrap().1;
            let active = sensors.clone().next().map(|(sensor, _)| sensor.active);
            active.map_or_else(constant, |active| f64::from(u8::from(sensors.any(|(_, on)| *on) == active)))
        };
        self.inputs.iter().map(told).collect()
    }

    /// Each action by the numbers of its walk and of its posture.
    pub fn walk(&self, actions: &[(usize, usize)]) -> Went {
        let slave = self.fmu.load().unwrap();
        let handle = |name: &String| self.fmu.description().handle(name).unwrap();
        let plan = |names: &[String]| Plan::new(&slave, &names.iter().map(handle).collect::<Vec<_>>());
        let (names, values): (Vec<String>, Vec<f64>) = self.cell.parameters.iter().cloned().unzip();
        let mut instance = slave.instantiate("by hand").unwrap();
        plan(&names).write(&mut instance, &values).unwrap();
        let mut instance = instance.enter_initialization(0.0, None).unwrap().exit_initialization().unwrap();
        let (mut write, mut read) = (plan(&self.inputs), plan(&self.outputs));
        let mut row = vec![0.0; self.outputs.len()];
        read.read(&mut instance, &mut row).unwrap();
        let mut steps = 0_u32;
        let mut step = |inputs: &[f64], row: &mut [f64]| {
            write.write(&mut instance, inputs).unwrap();
            instance.do_step(f64::from(steps) * self.cell.step, self.cell.step).unwrap();
            steps += 1;
            read.read(&mut instance, row).unwrap();
        };
        let bit = |seen: u8, sensor: usize| seen & (1 << sensor) != 0;
        let sensors = 0..self.cell.sensors.len();
        // Before the first sample all sensors have long read what they see at the start, and count.
        let mut place = Place::START;
        let at_start = seen_by(&self.cell, &Body::new(&self.cell, place, 0));
        let mut seen = vec![at_start; 64];
        let at_first: Vec<bool> = sensors.clone().map(|sensor| bit(at_start, sensor)).collect();
        for _ in 0..self.cell.lead_in {
            step(&self.told(&at_first), &mut row);
        }
        let mut went = Went::default();
        for &(walk, posture) in actions {
            let (_, eighths, mut free) = WALKS[walk];
            place = place.turned(eighths);
            let begun = self.standing(&row);
            for _ in 0..self.cell.steps() {
                // What stands on the person lets them out, of several out of what they are deepest in; bends pass it.
                let standing = self.standing(&row);
                let (on, obstacles): (Vec<Solid>, Vec<Solid>) =
                    standing.iter().cloned().partition(|solid| place.is_in(&self.cell, solid));
                let now = Cell { obstacles, ..self.cell.clone() };
                let sees = seen_by(&now, &Body::new(&now, place, posture));
                let counts = |sensor: &usize| self.counts[*sensor].as_ref().is_none_or(|band| band.holds(&row));
                let counted = sensors.clone().filter(counts).map(|sensor| sees & (1 << sensor)).sum();
                seen.push(counted);
                went.mattered.unheeded += u32::from(counted != sees);
                let in_effect = |sensor: usize| bit(seen[seen.len() - 1 - self.cell.sensors[sensor].delay], sensor);
                let readings: Vec<bool> = sensors.clone().map(in_effect).collect();
                let inputs = self.told(&readings);
                step(&inputs, &mut row);
                if free {
                    let next = place.ahead();
                    let deepest = |at: [f64; 2]| on.iter().map(|o| outside(o, at)).fold(f64::INFINITY, f64::min);
                    let still_on = on.iter().any(|solid| next.is_in(&now, solid));
                    let others = now.obstacles.iter().any(|solid| next.is_in(&now, solid));
                    let out = deepest(next.xy(&now)) > deepest(place.xy(&now)) - 1e-9;
                    free = !others && (!still_on || out);
                    let as_begun = begun.iter().any(|o| !place.is_in(&now, o) && next.is_in(&now, o));
                    went.mattered.stopped += u32::from(!free && !as_begun);
                    went.mattered.let_through += u32::from(free && as_begun);
                    went.mattered.walked_out += u32::from(free && still_on);
                    went.mattered.held += u32::from(!free && !others);
                    place = if free { next } else { place };
                }
                went.places.push(place.xy(&now));
                went.heads.push(body::head(&Body::new(&now, place, posture)));
                went.readings.push(readings);
                went.inputs.extend(inputs);
                went.outputs.extend(&row);
            }
        }
        went
    }
}
