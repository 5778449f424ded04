//! The FMU as a machine of readings, for a search of its behaviours: a state is a saved one, with what of readings is on its way to it.

use std::cmp::Ordering;

use super::zones::Readings;
use crate::cell::{Binding, Workcell};
use crate::host::{Plant, PlantError, Taken, Then};
use crate::human::Presses;
use crate::search::behaviours::{Held, Machine};
use crate::sim::sensors::{DelayLine, Seen, input_row};

/// Outputs no farther apart than this show the same, in the unit of each.
const ALIKE: f64 = 1e-9;
/// More than outputs that are rounded alike may be apart by rounding, in [`ALIKE`].
const ROUNDING: u64 = 2;

/// See the top of this file.
pub struct HeldReadings<'a, P: Plant> {
    plant: P,
    cell: &'a Workcell,
    binding: &'a Binding,
    readings: &'a [Readings],
    /// A person of whom each of the readings is reported, as far as the FMU is told of people.
    people: &'a [Seen],
    /// Steps that were taken.
    pub taken: u64,
}

/// A saved state, with what is on its way to it.
pub struct State<C> {
    saved: C,
    lines: Box<[DelayLine]>,
}

/// What the FMU shows, and what is on its way to it.
#[derive(Clone, Debug)]
pub struct Shown {
    /// Outputs, rounded.
    rounded: Box<[i64]>,
    lines: Box<[DelayLine]>,
    /// The outputs of the first state that showed it.
    pub outputs: Box<[f64]>,
}

impl PartialEq for Shown {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Shown {}

impl PartialOrd for Shown {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Shown {
    fn cmp(&self, other: &Self) -> Ordering {
        (&self.rounded, &self.lines).cmp(&(&other.rounded, &other.lines))
    }
}

impl Shown {
    fn new(outputs: &[f64], lines: &[DelayLine]) -> Self {
        #[expect(
            clippy::cast_possible_truncation,
            reason = "what is too large to be rounded so is told apart by the largest number"
        )]
        let rounded = outputs.iter().map(|value| (value / ALIKE).round() as i64).collect();
        Self { rounded, lines: lines.into(), outputs: outputs.into() }
    }
}

impl<'a, P: Plant> HeldReadings<'a, P> {
    /// Ready to be begun.
    #[must_use]
    pub const fn new(
        plant: P,
        (cell, binding): (&'a Workcell, &'a Binding),
        readings: &'a [Readings],
        people: &'a [Seen],
    ) -> Self {
        Self { plant, cell, binding, readings, people, taken: 0 }
    }
}

impl<P: Plant> Machine for HeldReadings<'_, P> {
    type State = State<P::Checkpoint>;
    type Shown = Shown;
    type Error = PlantError;

    fn readings(&self) -> usize {
        self.readings.len()
    }

    fn alike(&self, one: &Shown, other: &Shown) -> bool {
        let near = |(one, other): (&i64, &i64)| one.abs_diff(*other) <= ROUNDING;
        one.lines == other.lines && one.rounded.iter().zip(&other.rounded).all(near)
    }

    fn begin(&mut self) -> Result<(Self::State, Shown), PlantError> {
        let outputs = self.plant.restart()?;
        let sensors = self.cell.sensors.iter().zip(&self.readings[0]);
        let lines: Box<[DelayLine]> = sensors
            .map(|(sensor, raw)| {
                DelayLine::settled(*raw, sensor.delay_steps).latching(sensor.latched, *raw).on_its_way()
            })
            .collect();
        let shown = Shown::new(&outputs, &lines);
        Ok((State { saved: self.plant.save()?, lines }, shown))
    }

    fn hold(&mut self, state: &Self::State, reading: usize, steps: usize) -> Result<Held<Self>, PlantError> {
        let (mut lines, mut inputs, mut on_their_way) = (state.lines.clone(), Vec::new(), Vec::with_capacity(steps));
        for _ in 0..steps {
            let sensors = self.cell.sensors.iter().zip(lines.iter_mut()).zip(&self.readings[reading]);
            let told: Vec<bool> = sensors.map(|((sensor, line), raw)| line.push(*raw, sensor.delay_steps)).collect();
            lines.iter_mut().for_each(|line| *line = line.on_its_way());
            input_row(self.cell, self.binding, &told, &self.people[reading], Presses::NONE, &mut inputs);
            on_their_way.push(lines.clone());
        }
        self.plant.restore_soon(&state.saved)?;
        self.taken += steps as u64;
        let (outputs, taken) = match self.plant.advance_and(steps, &inputs, Then::Save) {
            Ok(stepped) => stepped,
            Err(error) if error.stopped => return Err(error),
            Err(_) => return Ok(None),
        };
        let Taken::Saved(saved) = taken? else { return Ok(None) };
        let rows = outputs.chunks(self.plant.output_count()).zip(&on_their_way);
        Ok(Some((rows.map(|(row, lines)| Shown::new(row, lines)).collect(), State { saved, lines })))
    }
}
