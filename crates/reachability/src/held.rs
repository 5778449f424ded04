//! The FMU as a machine of readings, for a search of its behaviours: a state is a saved one, with what of readings is on its way to it.
//!
//! A saved state is gone with the process that held it. So each knows how it was come to, and is made again where it is needed.

use std::cell::{Ref, RefCell};
use std::collections::BTreeMap;
use std::rc::Rc;
use std::sync::Arc;

use foldhash::quality::FixedState;
use indexmap::IndexSet;

use super::delayed::{DelayedInputs, DelayedReadings, Lines, Step};
use super::reading_regions::Readings;
use super::widths::{Rows, Width, Widths};
use crate::cell::binding::SensorBinding;
use crate::cell::{Binding, Sensor, Workcell};
use crate::host::{self as plant, Arrived, Leg, Plant, PlantError, Reads, for_all_steps};
use crate::human::Presses;
use crate::search::behaviours::net::{AllRows, Measured};
use crate::search::behaviours::{AllHeld, Begins, Hold, Machine, Others, OutputClass, any};
use crate::sim::robot::RobotFrame;
use crate::sim::sensors::{DelayLine, SensorTarget, input_row};

/// Outputs no farther apart than this show the same, in the unit of each.
const ALIKE: f64 = 1e-9;
/// More than outputs that are rounded alike may be apart by rounding, in [`ALIKE`].
const ROUNDING: u64 = 2;
/// What tells instants apart is measured at so many of them at most.
const MEASURED: usize = 128;

/// Of each of some readings what the FMU is told, by number: the same where sensors share an input, and are told alike late and for as long.
#[must_use]
pub fn distinguished(
    (cell, binding): (&Workcell, &Binding),
    readings: &[Readings],
    people: &[SensorTarget],
) -> Vec<usize> {
    let sensors = || cell.sensors.iter().zip(&binding.sensors);
    // What is on its way, or latched by the host, is remembered sensor by sensor.
    let remembers = |sensor: &Sensor| (sensor.delay_steps, sensor.latched);
    let is_alone = |(sensor, bound): (&Sensor, &SensorBinding)| {
        let mut others = sensors().filter(|(_, other)| other.input() == bound.input());
        others.any(|(other, _)| remembers(other) != remembers(sensor))
    };
    let alone: Vec<bool> = sensors().map(is_alone).collect();
    let mut rows: Vec<Vec<u64>> = Vec::new();
    let mut of = |(reading, person): (&Readings, &SensorTarget)| {
        let mut row = Vec::new();
        input_row(cell, binding, reading, person, Presses::NONE, &mut row);
        let own = reading.iter().zip(&alone).map(|(reading, alone)| u64::from(*reading && *alone));
        let row: Vec<u64> = row.into_iter().map(f64::to_bits).chain(own).collect();
        rows.iter().position(|known| *known == row).unwrap_or_else(|| {
            rows.push(row);
            rows.len() - 1
        })
    };
    readings.iter().zip(people).map(&mut of).collect()
}

/// See the top of this file.
pub struct HeldReadings<'a, P: Plant> {
    plant: P,
    cell: &'a Workcell,
    binding: &'a Binding,
    /// By number, those that are taken for one: the first of them first.
    readings: Vec<Vec<Readings>>,
    /// Whether these have numbers of their own.
    apart: bool,
    /// Which of these may follow each of them.
    others: Others,
    /// A person of whom each of the readings is reported, as far as the FMU is told of people.
    people: Vec<SensorTarget>,
    known: ShownOutputs,
    on_its_way: DelayedReadings,
    /// How far apart outputs are by what robots do, and those that were numbered by that.
    widths: Option<Widths>,
    rows: Rows,
    /// The state at the start.
    start: Option<P::Checkpoint>,
    /// What is shown there.
    first: Option<OutputClass>,
    /// Steps that were taken.
    pub taken: u64,
}

/// A saved state, with what is on its way to it.
pub struct State<C> {
    saved: RefCell<C>,
    lines: Lines,
    came: Rc<Came>,
}

/// See [`HeldReadings::each`].
type Each<C> = Vec<(Vec<f64>, Vec<i64>, State<C>)>;

/// How a state was come to: from another by a reading that was held for some steps. The start comes of none.
struct Came {
    from: Option<Rc<Self>>,
    reading: usize,
    steps: usize,
}

impl Drop for Came {
    /// One after the other: there may be very many.
    fn drop(&mut self) {
        let mut from = self.from.take();
        while let Some(mut before) = from.and_then(Rc::into_inner) {
            from = before.from.take();
        }
    }
}

/// All that was shown so far.
#[derive(Default)]
struct ShownOutputs {
    /// By its number, outputs as they are rounded, and the number of what is on its way.
    all: IndexSet<Box<[i64]>, FixedState>,
    /// Outputs of the first state that showed it, one after the other.
    outputs: Vec<f64>,
    /// What may be on its way, by number.
    lines: BTreeMap<Box<[DelayLine]>, i64>,
    /// What is looked for.
    wanted: Vec<i64>,
    /// Of each output, whether it counts.
    matters: Vec<bool>,
}

impl ShownOutputs {
    /// The number of what is shown with these outputs and that on its way.
    #[expect(
        clippy::cast_possible_truncation,
        reason = "what is too large to be rounded so is told apart by the largest number"
    )]
    fn number(&mut self, outputs: &[f64], lines: i64) -> OutputClass {
        self.wanted.clear();
        let rounded = |(value, matters): (&f64, &bool)| if *matters { (value / ALIKE).round() as i64 } else { 0 };
        self.wanted.extend(outputs.iter().zip(&self.matters).map(rounded));
        self.wanted.push(lines);
        if let Some(known) = self.all.get_index_of(&*self.wanted) {
            return known as OutputClass;
        }
        self.outputs.extend(outputs);
        self.all.insert_full(self.wanted.clone().into()).0 as OutputClass
    }

    #[expect(clippy::cast_possible_wrap, reason = "a few hundred")]
    fn lines(&mut self, lines: &[DelayLine]) -> i64 {
        if let Some(known) = self.lines.get(lines) {
            return *known;
        }
        let next = self.lines.len() as i64;
        self.lines.insert(lines.into(), next);
        next
    }
}

impl<'a, P: Plant> HeldReadings<'a, P> {
    /// Ready to be begun.
    #[must_use]
    pub fn new(
        plant: P,
        (cell, binding): (&'a Workcell, &'a Binding),
        (readings, others): (Vec<Vec<Readings>>, Others),
        people: Vec<SensorTarget>,
    ) -> Self {
        let mut matters = binding.matters();
        matters.resize(plant.output_count(), false);
        let known = ShownOutputs { matters, ..ShownOutputs::default() };
        let rows = Rows::default();
        Self {
            plant,
            cell,
            binding,
            readings,
            apart: false,
            others,
            people,
            known,
            on_its_way: DelayedReadings::default(),
            widths: None,
            rows,
            start: None,
            first: None,
            taken: 0,
        }
    }

    /// Measures how far apart robots are by these links.
    pub fn measure(&mut self, links: &Arc<[bool]>, width: Width) {
        let columns = self.plant.output_count();
        let all = self.known.outputs.chunks(columns.max(1));
        let every = all.len().div_ceil(MEASURED).max(1);
        let rows: Vec<Vec<f64>> = all.step_by(every).map(<[f64]>::to_vec).collect();
        self.widths = Some(Widths::new((self.cell, self.binding), width, links, columns, &rows));
        self.rows = Rows::default();
    }

    /// The outputs of what is shown.
    #[must_use]
    pub fn outputs(&self, shown: OutputClass) -> &[f64] {
        let columns = self.plant.output_count();
        &self.known.outputs[shown as usize * columns..][..columns]
    }

    /// The outputs of what is shown, numbered by what robots do.
    #[must_use]
    pub fn nearly(&self, shown: OutputClass) -> &[f64] {
        &self.rows.row(shown)[..self.plant.output_count()]
    }

    /// The same, rounded, with the number of what is on its way.
    fn rounded(&self, shown: OutputClass) -> &[i64] {
        self.known.all.get_index(shown as usize).map_or(&[], |rounded| rounded)
    }

    /// What the FMU is told in some steps of a reading, and what is on its way after each of them.
    fn told(&mut self, lines: Lines, reading: usize, steps: usize) -> DelayedInputs {
        let (number, own) = self.given(reading);
        let (cell, binding, known) = (self.cell, self.binding, &mut self.known);
        let (readings, person) = (&self.readings[number], &self.people[number]);
        self.on_its_way.told(lines, (number, own), steps, &mut |all, lines| {
            let mut lines = all.lines(lines).to_vec();
            let (first, of_given) = lines.split_at_mut(cell.sensors.len());
            push(cell, first, &readings[0]);
            let told = push(cell, of_given, &readings[own]);
            let mut row = Vec::new();
            input_row(cell, binding, &told, person, Presses::NONE, &mut row);
            Step { row: row.into(), counts: known.lines(first), after: all.number(&lines) }
        })
    }

    /// What a reading is taken for, and which of these it is.
    fn given(&self, reading: usize) -> (usize, usize) {
        let all = || self.readings.iter().enumerate().flat_map(|(n, alike)| (0..alike.len()).map(move |own| (n, own)));
        if self.apart { all().nth(reading).unwrap_or_default() } else { (reading, 0) }
    }

    /// The legs that holds are.
    fn legs(
        &mut self,
        holds: &[Hold<'_, State<P::Checkpoint>>],
        told: &[DelayedInputs],
    ) -> Result<Vec<Arrived<P::Checkpoint>>, PlantError> {
        let saved: Vec<Option<Ref<'_, P::Checkpoint>>> = holds
            .iter()
            .map(|hold| match hold.from {
                Begins::At(state) => Some(state.saved.borrow()),
                Begins::After(_) => None,
            })
            .collect();
        let mut legs = Vec::with_capacity(holds.len());
        for ((hold, told), saved) in holds.iter().zip(told).zip(&saved) {
            let from = match (&hold.from, saved) {
                (Begins::After(number), _) => plant::LegStart::After(*number),
                (Begins::At(_), Some(saved)) => plant::LegStart::At(&**saved),
                (Begins::At(_), None) => continue,
            };
            let reads = if hold.last { Reads::Last } else { Reads::Each };
            legs.push(Leg { from, steps: hold.steps, inputs: told.inputs.clone(), reads });
            self.taken += hold.steps as u64;
        }
        self.plant.advance_each(&legs)
    }

    /// Outputs after each step of each hold, row-major, what is on its way after each of them, and the state after the last.
    fn each(&mut self, holds: &[Hold<'_, State<P::Checkpoint>>]) -> Result<Option<Each<P::Checkpoint>>, PlantError> {
        let mut told: Vec<DelayedInputs> = Vec::with_capacity(holds.len());
        for hold in holds {
            let lines = match hold.from {
                Begins::At(state) => state.lines,
                Begins::After(number) => told[number].lines,
            };
            told.push(self.told(lines, hold.reading, hold.steps));
        }
        // Where the process ends meanwhile, once more from the start, one by one.
        let arrived = match self.legs(holds, &told) {
            Err(error) if error.lost && !error.stopped => {
                for hold in holds {
                    if let Begins::At(state) = hold.from {
                        self.bring_back(state)?;
                    }
                }
                self.legs(holds, &told)
            }
            outcome => outcome,
        };
        let arrived = match arrived {
            Ok(arrived) => arrived,
            Err(error) if error.stopped => return Err(error),
            Err(_) => return Ok(None),
        };
        let mut all: Each<P::Checkpoint> = Vec::with_capacity(holds.len());
        for ((hold, told), (outputs, saved)) in holds.iter().zip(told).zip(arrived) {
            let from = match hold.from {
                Begins::At(state) => Rc::clone(&state.came),
                Begins::After(number) => Rc::clone(&all[number].2.came),
            };
            let came = Rc::new(Came { from: Some(from), reading: hold.reading, steps: hold.steps });
            let mut on_their_way = told.counts;
            if hold.last {
                on_their_way.drain(..on_their_way.len().saturating_sub(1));
            }
            all.push((outputs, on_their_way, State { saved: RefCell::new(saved), lines: told.lines, came }));
        }
        Ok(Some(all))
    }

    /// What is on its way at the start: of the first readings of those that are taken for one, and of those that are given.
    fn first_lines(&self) -> Vec<DelayLine> {
        let sensors = self.cell.sensors.iter().zip(&self.readings[0][0]);
        let settled = |(sensor, raw): (&Sensor, &bool)| {
            DelayLine::steady(*raw, sensor.delay_steps).latching(sensor.latched, *raw).on_its_way()
        };
        let first: Vec<DelayLine> = sensors.map(settled).collect();
        first.repeat(2)
    }

    /// Begins again, without anything being lost that is saved.
    fn at_start(&mut self) -> Result<(), PlantError> {
        if let Some(start) = self.start.as_ref().filter(|start| self.plant.holds(start)) {
            match self.plant.restore(start) {
                Err(error) if error.lost && !error.stopped => {}
                outcome => return outcome,
            }
        }
        self.plant.restart()?;
        self.start = Some(self.plant.save()?);
        Ok(())
    }

    /// Makes a state again from the start, if it is gone.
    fn bring_back(&mut self, state: &State<P::Checkpoint>) -> Result<(), PlantError> {
        if self.plant.holds(&state.saved.borrow()) {
            return Ok(());
        }
        let mut way = Vec::new();
        let mut came = Some(&state.came);
        while let Some(Came { from: Some(from), reading, steps }) = came.map(|came| &**came) {
            way.push((*reading, *steps));
            came = Some(from);
        }
        let (first, mut inputs) = (self.first_lines(), Vec::new());
        let mut lines = self.on_its_way.number(&first);
        for (reading, steps) in way.iter().rev() {
            let told = self.told(lines, *reading, *steps);
            inputs.extend(for_all_steps(&told.inputs, self.plant.input_count(), *steps).iter());
            lines = told.lines;
        }
        self.at_start()?;
        let steps = way.iter().map(|(_, steps)| steps).sum();
        self.taken += steps as u64;
        if steps > 0 {
            self.plant.advance(steps, &inputs)?;
        }
        state.saved.replace(self.plant.save()?);
        Ok(())
    }
}

impl<P: Plant> Machine for HeldReadings<'_, P> {
    type State = State<P::Checkpoint>;
    type Error = PlantError;

    fn readings(&self) -> usize {
        if self.apart { self.readings.iter().map(Vec::len).sum() } else { self.readings.len() }
    }

    fn others(&self) -> Others {
        if !self.apart {
            return self.others.clone();
        }
        let mut others = any(self.readings());
        for (reading, others) in others.iter_mut().enumerate() {
            let mine = self.taken_for(reading);
            let follows = |other: &usize| {
                let its = self.taken_for(*other);
                its == mine || self.others[mine].contains(&its)
            };
            others.retain(follows);
        }
        others
    }

    fn tell_apart(&mut self, apart: bool) {
        self.apart = apart;
    }

    fn taken_for(&self, reading: usize) -> usize {
        self.given(reading).0
    }

    fn alike(&self, one: OutputClass, other: OutputClass) -> bool {
        self.rounded(one).last() == self.rounded(other).last() && self.look_alike(one, other)
    }

    fn look_alike(&self, one: OutputClass, other: OutputClass) -> bool {
        let outputs = self.plant.output_count();
        let (one, other) = (self.rounded(one), self.rounded(other));
        one.iter().zip(other).take(outputs).all(|(one, other)| one.abs_diff(*other) <= ROUNDING)
    }

    fn switches(&self, one: OutputClass, among: [OutputClass; 3]) -> bool {
        let mine = self.rounded(one).iter().enumerate();
        let among = among.map(|shown| self.rounded(shown));
        mine.into_iter().all(|(column, mine)| among.iter().any(|its| mine.abs_diff(its[column]) <= ROUNDING))
    }

    fn begin(&mut self) -> Result<(Self::State, OutputClass), PlantError> {
        let shown = match self.first {
            Some(shown) => {
                self.at_start()?;
                shown
            }
            None => {
                let outputs = self.plant.restart()?;
                self.start = Some(self.plant.save()?);
                let lines = self.first_lines();
                let number = self.known.lines(&lines[..self.cell.sensors.len()]);
                *self.first.insert(self.known.number(&outputs, number))
            }
        };
        let came = Rc::new(Came { from: None, reading: 0, steps: 0 });
        let lines = self.on_its_way.number(&self.first_lines());
        Ok((State { saved: RefCell::new(self.plant.save()?), lines, came }, shown))
    }

    fn hold_each(&mut self, holds: &[Hold<'_, Self::State>]) -> Result<AllHeld<Self::State>, PlantError> {
        let columns = self.plant.output_count();
        let number = |(outputs, told): (&[f64], &i64), known: &mut ShownOutputs| known.number(outputs, *told);
        let Some(all) = self.each(holds)? else { return Ok(None) };
        let all = all.into_iter().map(|(outputs, lines, state)| {
            let rows = outputs.chunks(columns).zip(&lines);
            (rows.map(|row| number(row, &mut self.known)).collect(), state)
        });
        Ok(Some(all.collect()))
    }
}

impl<P: Plant> Measured for HeldReadings<'_, P> {
    fn begin_rows(&mut self) -> Result<(Self::State, Vec<f64>), PlantError> {
        let (state, shown) = self.begin()?;
        let row = with_lines(self.outputs(shown), &[*self.rounded(shown).last().unwrap_or(&0)]);
        Ok((state, row))
    }

    fn rows_each(&mut self, holds: &[Hold<'_, Self::State>]) -> Result<Option<AllRows<Self::State>>, PlantError> {
        let Some(all) = self.each(holds)? else { return Ok(None) };
        Ok(Some(all.into_iter().map(|(outputs, lines, state)| (with_lines(&outputs, &lines), state)).collect()))
    }

    fn columns(&self) -> usize {
        self.plant.output_count() + 1
    }

    fn traits(&self, row: &[f64]) -> Vec<f32> {
        self.widths.as_ref().map_or_else(Vec::new, |widths| widths.traits((self.cell, self.binding), row))
    }

    fn place(&self, traits: &[f32]) -> [f32; 3] {
        self.widths.as_ref().map_or([0.0; 3], |widths| widths.place(traits))
    }

    fn number(&mut self, row: &[f64], traits: &[f32]) -> OutputClass {
        self.widths.as_ref().map_or(0, |widths| self.rows.number(row, traits, widths))
    }

    fn nearest(&self, traits: &[f32], widths: f32, counts: &dyn Fn(OutputClass) -> bool) -> Option<(OutputClass, f32)> {
        self.rows.least_beyond(traits, widths, self.widths.as_ref()?, counts)
    }

    fn off(&self, row: &[f64], shown: OutputClass) -> Option<(f64, [f64; 2])> {
        let (columns, widths) = (self.plant.output_count(), self.widths.as_ref()?);
        let frame = |row: &[f64]| RobotFrame::new(self.cell, self.binding, &row[..columns]);
        let stands = frame(self.rows.row(shown));
        Some((widths.fastest(&stands), widths.between(&frame(row), &stands)?))
    }
}

/// What the FMU is told of sensors that report this.
fn push(cell: &Workcell, lines: &mut [DelayLine], readings: &[bool]) -> Vec<bool> {
    let sensors = cell.sensors.iter().zip(lines.iter_mut()).zip(readings);
    let told = sensors.map(|((sensor, line), raw)| line.push(*raw, sensor.delay_steps)).collect();
    lines.iter_mut().for_each(|line| *line = line.on_its_way());
    told
}

/// Rows of outputs, each with the number of what is on its way.
#[expect(clippy::cast_precision_loss, reason = "a few hundred")]
fn with_lines(outputs: &[f64], lines: &[i64]) -> Vec<f64> {
    let columns = outputs.len() / lines.len().max(1);
    let rows = outputs.chunks(columns.max(1)).zip(lines);
    rows.flat_map(|(row, lines)| row.iter().copied().chain([*lines as f64])).collect()
}
