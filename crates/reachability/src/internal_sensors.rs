//! What sensors inside the FMU report of people, where it is told where they are.
//!
//! Nothing but the FMU knows where these sensors see somebody. So it is asked: from its start, with a person at the corners of
//! all cells of the floor and at all edges of arcs of headings, for as many steps as its sensors take to tell. What differs at the
//! corners of a cell differs somewhere in it, and both is possible in it; what is narrower than a cell everywhere may be missed.
//! What the robots do then is asked with one such person for each thing that is reported; that it is the same with others, and that
//! sensors report the same later, is tried out (`scan/reachability/trials.rs`, `scan/reachability/internal_sensors_later.rs`): it rests on that.

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::ops::ControlFlow;

use crate::cell::binding::SensorBinding;
use crate::cell::{Binding, Workcell};
use crate::geometry::Vec3;
use crate::host::{Plant, PlantError};
use crate::human::{Floor, Presses};
use crate::sim::sensors::{SensorTarget, input_row};

/// Arcs of headings.
pub const ARCS: u32 = 16;
/// Cells of the floor to a side of the blocks that are asked about first.
const COARSE: usize = 4;
/// Most different things that may be reported together.
const MOST_KINDS: usize = 32;
/// How far apart people are, m, and how many ways they look, of whom is asked how late sensors tell.
const COARSEST_M: f64 = 0.3;
const COARSEST_HEADINGS: u32 = 4;

/// A person somewhere, upright.
pub type StandingPose = ([f64; 2], f64);

/// See the top of this file.
#[derive(Clone, Debug)]
pub struct InternalSensorMap {
    /// What is reported together, by sensor; of those outside of the FMU nothing.
    kinds: Vec<Vec<bool>>,
    /// Of each kind, people of whom it is reported.
    people: Vec<Vec<StandingPose>>,
    /// Of each cell of the floor and arc of headings the kinds that are possible, as bits.
    possible: Vec<u32>,
}

/// Asks an FMU.
pub struct InternalSensorProbe<'a, P: Plant> {
    plant: P,
    cell: &'a Workcell,
    binding: &'a Binding,
    /// Steps for which somebody stays.
    steps: usize,
    /// Where people come: a saved state, where there are some, or what is told from the start on.
    root: Option<P::Checkpoint>,
    before: Vec<f64>,
    kinds: Vec<Vec<bool>>,
    /// Steps that were taken.
    taken: u64,
}

impl<'a, P: Plant> InternalSensorProbe<'a, P> {
    /// With people who stay for so many steps; from a saved state, or from a fresh start each time.
    ///
    /// # Errors
    /// When the FMU cannot be started.
    pub fn new(
        mut plant: P,
        cell: &'a Workcell,
        binding: &'a Binding,
        steps: usize,
        saves: bool,
    ) -> Result<Self, PlantError> {
        plant.restart()?;
        let root = if saves { Some(plant.save()?) } else { None };
        Ok(Self { plant, cell, binding, steps, root, before: Vec::new(), kinds: Vec::new(), taken: 0 })
    }

    /// From now on people come after so many steps from the start, in which somebody was there.
    ///
    /// # Errors
    /// When the FMU fails.
    pub fn after(&mut self, steps: usize, somebody: StandingPose) -> Result<(), PlantError> {
        self.before = self.told(somebody).repeat(steps);
        if self.root.is_some() {
            self.begin()?;
            self.root = Some(self.plant.save()?);
        }
        Ok(())
    }

    /// From the start to where people come. Steps that are taken again for that do not count: with saved states there are none.
    fn begin(&mut self) -> Result<(), PlantError> {
        self.plant.restart()?;
        let steps = self.before.len() / self.plant.input_count().max(1);
        if steps > 0 {
            self.plant.advance(steps, &self.before)?;
        }
        Ok(())
    }

    /// What the FMU is told in a step of somebody of whom no other sensor reports anything.
    fn told(&self, at: StandingPose) -> Vec<f64> {
        let (mut inputs, nobody) = (Vec::new(), vec![false; self.cell.sensors.len()]);
        input_row(self.cell, self.binding, &nobody, &sensor_target(self.cell, at), Presses::NONE, &mut inputs);
        inputs
    }

    /// Steps in which the FMU was asked.
    #[must_use]
    pub const fn taken(&self) -> u64 {
        self.taken
    }

    /// What is reported of somebody after each step of their stay: all sensors, nothing of those outside of the FMU.
    ///
    /// # Errors
    /// When the FMU fails.
    pub fn reports(&mut self, at: StandingPose) -> Result<Vec<Vec<bool>>, PlantError> {
        match &self.root {
            Some(root) if self.plant.holds(root) => self.plant.restore(root)?,
            _ => self.begin()?,
        }
        self.taken += self.steps as u64;
        let rows = self.plant.advance(self.steps, &self.told(at).repeat(self.steps))?;
        let told = |row: &[f64]| -> Vec<bool> {
            let sensors = self.cell.sensors.iter().zip(&self.binding.sensors);
            let reads = |(sensor, bound): (&crate::cell::Sensor, &SensorBinding)| bound.reports(row, sensor.signal);
            sensors.map(reads).collect()
        };
        Ok(rows.chunks(self.plant.output_count()).map(told).collect())
    }

    /// From now on people stay for as many steps as it takes until what is reported of somebody who stays stays the same: sensors may
    /// tell late. Seen from people on a coarse lattice of the floor, for as many steps as people have stayed so far. `false` if it was told
    /// to end.
    ///
    /// # Errors
    /// When the FMU fails.
    pub fn settle(&mut self, floor: &Floor, goes_on: &mut dyn FnMut() -> bool) -> Result<bool, PlantError> {
        let [columns, rows] = floor.size();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some ten cells")]
        let every = (COARSEST_M / floor.cell_m()).max(1.0) as usize;
        let mut longest = 1;
        for (row, column) in (0..rows).step_by(every).flat_map(|row| (0..columns).step_by(every).map(move |c| (row, c)))
        {
            if !floor.is_open(row * columns + column) {
                continue;
            }
            if !goes_on() {
                return Ok(false);
            }
            for heading in 0..COARSEST_HEADINGS {
                let reports = self
                    .reports((floor.corner((column, row)), f64::from(heading) * TAU / f64::from(COARSEST_HEADINGS)))?;
                let same = reports.iter().rev().take_while(|report| Some(*report) == reports.last()).count();
                longest = longest.max(reports.len() + 1 - same);
            }
        }
        self.steps = longest;
        Ok(true)
    }

    /// For how many steps people stay.
    #[must_use]
    pub const fn steps(&self) -> usize {
        self.steps
    }

    /// The kind of what is reported in the end; `None` if there are too many.
    fn kind(&mut self, at: StandingPose) -> Result<Option<usize>, PlantError> {
        let Some(last) = self.reports(at)?.pop() else { return Ok(None) };
        let known = self.kinds.iter().position(|kind| *kind == last);
        if known.is_none() {
            self.kinds.push(last);
        }
        Ok(Some(known.unwrap_or(self.kinds.len() - 1)).filter(|kind| *kind < MOST_KINDS))
    }
}

/// The person as the FMU is told.
#[must_use]
pub fn sensor_target(cell: &Workcell, (xy_m, heading_rad): StandingPose) -> SensorTarget {
    let position = Vec3::new(xy_m[0], xy_m[1], 0.0);
    SensorTarget { feet: cell.body.feet(position, heading_rad), besides: None, body: None, position, heading_rad }
}

impl InternalSensorMap {
    /// Asks about all of a floor; `None` if it was told to end, or if what is reported is of too many kinds. `tell` hears of the
    /// share that is done.
    ///
    /// # Errors
    /// When the FMU fails.
    pub fn ask<P: Plant>(
        asking: &mut InternalSensorProbe<'_, P>,
        floor: &Floor,
        tell: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> Result<Option<Self>, PlantError> {
        let mut people: Vec<Vec<StandingPose>> = Vec::new();
        let mut kind = |at: StandingPose| {
            let kind = asking.kind(at)?;
            if let Some(kind) = kind {
                people.resize(people.len().max(kind + 1), Vec::new());
                people[kind].push(at);
            }
            Ok(kind)
        };
        let Some(possible) = possible(floor, &mut kind, tell)? else { return Ok(None) };
        Ok(Some(Self { kinds: asking.kinds.clone(), people, possible }))
    }

    /// Some of the people that were asked about, of each kind about as many, and what is reported of them.
    #[must_use]
    pub fn some(&self, most: usize) -> Vec<(StandingPose, &[bool])> {
        let of_each = (most / self.kinds.len().max(1)).max(1);
        let each = self.kinds.iter().zip(&self.people);
        each.flat_map(|(kind, people)| {
            let every = people.len().div_ceil(of_each).max(1);
            people.iter().step_by(every).map(move |person| (*person, kind.as_slice()))
        })
        .collect()
    }

    /// What may be reported together of people in a cell who look into an arc: by sensor, nothing of those outside of the FMU.
    pub fn kinds(&self, cell: usize, arc: u32) -> impl Iterator<Item = &[bool]> {
        let bits = self.possible[cell * ARCS as usize + (arc % ARCS) as usize];
        let is = move |(kind, _): &(usize, &Vec<bool>)| bits >> kind & 1 == 1;
        self.kinds.iter().enumerate().filter(is).map(|(_, kind)| kind.as_slice())
    }

    /// People of whom just this is reported, as far as `matters` says.
    pub fn people(&self, readings: &[bool], matters: impl Fn(usize) -> bool) -> impl Iterator<Item = StandingPose> {
        let same =
            move |kind: &[bool]| (0..kind.len()).all(|sensor| !matters(sensor) || kind[sensor] == readings[sensor]);
        let kinds = self.kinds.iter().zip(&self.people).filter(move |(kind, _)| same(kind));
        kinds.flat_map(|(_, people)| people.iter().copied())
    }
}

/// Of each cell of a floor and arc of headings the kinds that are possible, as bits, where `kind` says of a person what is reported of
/// them; nothing if it was told to end, or if there are too many kinds.
fn possible(
    floor: &Floor,
    kind: &mut dyn FnMut(StandingPose) -> Result<Option<usize>, PlantError>,
    tell: &mut dyn FnMut(f64) -> ControlFlow<()>,
) -> Result<Option<Vec<u32>>, PlantError> {
    let [columns, rows] = floor.size();
    let mut known: BTreeMap<(usize, usize, u32), usize> = BTreeMap::new();
    let mut possible = vec![0_u32; columns * rows * ARCS as usize];
    let blocks: Vec<(usize, usize)> = (0..rows)
        .step_by(COARSE)
        .flat_map(|row| (0..columns).step_by(COARSE).map(move |column| (column, row)))
        .collect();
    for (number, &(column, row)) in blocks.iter().enumerate() {
        #[expect(clippy::cast_precision_loss, reason = "some thousand blocks")]
        if tell(number as f64 / blocks.len() as f64).is_break() {
            return Ok(None);
        }
        let (to_column, to_row) = ((column + COARSE).min(columns), (row + COARSE).min(rows));
        let cells = || (row..to_row).flat_map(move |row| (column..to_column).map(move |column| (column, row)));
        if !cells().any(|(column, row)| floor.is_open(row * columns + column)) {
            continue;
        }
        let mut kind_at = |corner: (usize, usize), heading: u32| -> Result<Option<usize>, PlantError> {
            let heading = heading % ARCS;
            if let Some(kind) = known.get(&(corner.0, corner.1, heading)) {
                return Ok(Some(*kind));
            }
            let at = (floor.corner(corner), TAU * (f64::from(heading) - 0.5) / f64::from(ARCS));
            let Some(kind) = kind(at)? else { return Ok(None) };
            known.insert((corner.0, corner.1, heading), kind);
            Ok(Some(kind))
        };
        // Corners of the block, its middle, and all headings.
        let (middle_column, middle_row) = ((column + to_column) / 2, (row + to_row) / 2);
        let corners =
            [(column, row), (to_column, row), (column, to_row), (to_column, to_row), (middle_column, middle_row)];
        let mut bits = 0_u32;
        for corner in corners {
            for heading in 0..ARCS {
                let Some(kind) = kind_at(corner, heading)? else { return Ok(None) };
                bits |= 1 << kind;
            }
        }
        for (column, row) in cells() {
            let cell = row * columns + column;
            for arc in 0..ARCS {
                let mut own = bits;
                if bits.count_ones() > 1 {
                    own = 0;
                    for corner in [(column, row), (column + 1, row), (column, row + 1), (column + 1, row + 1)] {
                        for heading in [arc, arc + 1] {
                            let Some(kind) = kind_at(corner, heading)? else { return Ok(None) };
                            own |= 1 << kind;
                        }
                    }
                }
                possible[cell * ARCS as usize + arc as usize] = own;
            }
        }
    }
    Ok(Some(possible))
}

/// The number of the arc that holds a heading: the first is around that along x.
#[must_use]
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some ten arcs")]
pub fn arc(heading_rad: f64) -> u32 {
    (heading_rad.rem_euclid(TAU) / TAU * f64::from(ARCS)).round() as u32 % ARCS
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::human::{Anthropometry, Body};
    use crate::search::Rng;
    use crate::stop::Stop;

    /// Fields that see a point somewhat before people on one side of a line: what is reported of anybody is among what is possible in
    /// their cell and arc, but for those nearer to the line than the point moves between the edges of an arc.
    #[test]
    fn what_is_reported_of_anybody_is_possible_where_they_are() {
        const BEFORE_M: f64 = 0.3;
        let mut rng = Rng::new(17);
        let mut uniform = |low: f64, high: f64| {
            low + (high - low) * f64::from(u32::try_from(rng.below(1 << 20)).unwrap()) / f64::from(1 << 20)
        };
        let body = Body::new(&Anthropometry::default()).unwrap();
        let floor = Floor::new(&body, &[], ([-1.0, -1.0], [1.0, 1.1]), 0.05, &Stop::default()).unwrap();
        let (sin, cos) = (libm::sin, libm::cos);
        let moves_m = BEFORE_M * (1.0 - cos(TAU / f64::from(ARCS) / 2.0));
        let (mut looked_at, mut both) = (0, 0);
        for _ in 0..40 {
            let lines = [0; 2].map(|_: i32| (uniform(0.0, TAU), uniform(-0.8, 0.8)));
            let beyond = |(way, far): (f64, f64), ([x, y], heading): StandingPose| {
                (x + BEFORE_M * cos(heading)) * cos(way) + (y + BEFORE_M * sin(heading)) * sin(way) - far
            };
            let kind = |at: StandingPose| {
                usize::from(beyond(lines[0], at) > 0.0) + 2 * usize::from(beyond(lines[1], at) > 0.0)
            };
            let asked = possible(&floor, &mut |at| Ok(Some(kind(at))), &mut |_| ControlFlow::Continue(()));
            let told = asked.unwrap().unwrap();
            both += told.iter().filter(|kinds| kinds.count_ones() > 1).count();
            for _ in 0..2000 {
                let at = ([uniform(-1.0, 1.0), uniform(-1.0, 1.1)], uniform(0.0, TAU));
                if lines.iter().any(|line| beyond(*line, at).abs() <= moves_m) {
                    continue;
                }
                looked_at += 1;
                let cells = floor.within(at.0, 0.0);
                let is = |cell: usize| told[cell * ARCS as usize + arc(at.1) as usize] >> kind(at) & 1 == 1;
                assert!(cells.into_iter().any(is), "{} of {at:?} with {lines:?}", kind(at));
            }
        }
        assert!(looked_at > 50_000 && both > 1000, "{looked_at} {both}");
    }
}
