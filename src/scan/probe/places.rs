//! Sensors and where the person stands: sensors inside the FMU are tried with a person at many places, planes that it evaluates
//! itself with one in them, and starts that a sensor reports at once are told.

use std::collections::BTreeSet;
use std::f64::consts::FRAC_PI_2;

use schemars::JsonSchema;
use serde::Serialize;

use crate::cell::binding::SensorBinding;
use crate::cell::sensor::Signal;
use crate::cell::{Binding, Workcell};
use crate::geometry::Vec3;
use crate::host::{Plant, PlantError};
use crate::human::Presses;
use crate::scan::hosting::StateChoice;
use crate::scan::prepare::Prepared;
use crate::sim::World;
use crate::sim::robot::RobotFrame;
use crate::sim::sensors::{SensorTarget, input_row};

/// Places along each side of the area in which the person is put.
const ALONG: u8 = 5;

/// How far beyond the robots that area goes, m: farther than a walking person gets while a robot stops.
const BEYOND_M: f64 = 1.5;

/// Where nobody is near, m beyond the area.
const FAR_M: f64 = 20.0;

/// How long the person stands at each place, s: longer than scanners and their controllers take to tell.
const STAY_S: f64 = 0.4;

/// Where nobody is in a plane any more, m from it.
const AWAY_M: f64 = 3.0;

/// Half of what is at least as wide as people are, m.
const HALF_BODY_M: f64 = 0.3;

/// What a sensor inside the FMU did while the person stood at many places, one after the other.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Reported {
    /// The sensor.
    pub sensor: String,
    /// Places in and around the cell at which it reported the person.
    pub at: usize,
    /// Such places that were tried.
    pub of: usize,
    /// Whether it reported a person far away from the cell.
    pub far_away: bool,
}

impl Reported {
    /// What seems to be wrong.
    pub(super) fn warning(&self, signal: Signal) -> Option<String> {
        let (name, of) = (&self.sensor, self.of);
        let meaning = if self.at == 0 {
            format!(
                "sensor `{name}` inside the FMU never fired while the person stood at {of} places in and around the cell"
            )
        } else if self.far_away {
            format!("sensor `{name}` inside the FMU reports a person who is {FAR_M} m away")
        } else {
            return None;
        };
        Some(format!(
            "{meaning}. Either the cell file is wrong ([pose] names other variables, or the polarity is the other way round: \
             then {}), or the FMU's sensor really does that, which is a flaw of the cell: look at its description before you \
             change the file",
            signal.turned()
        ))
    }
}

/// The middle of the robots' links on the floor plan over a run: least and greatest x and y, m.
fn area(cell: &Workcell, binding: &Binding, rows: &[f64]) -> [f64; 4] {
    let frames = rows.chunks(binding.outputs.len()).step_by(10);
    let frame = |row: &[f64]| RobotFrame::new(cell, binding, &binding.rows(row, None, cell.step_s));
    let middles =
        frames.flat_map(|row| frame(row).links.iter().map(|link| link.bounding_sphere().0).collect::<Vec<_>>());
    middles.fold([f64::INFINITY, f64::NEG_INFINITY, f64::INFINITY, f64::NEG_INFINITY], |[x, to_x, y, to_y], at| {
        [x.min(at.x), to_x.max(at.x), y.min(at.y), to_y.max(at.y)]
    })
}

/// Communication steps for which somebody stands at a place.
fn stay(cell: &Workcell) -> usize {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "hundreds")]
    let steps = (STAY_S / cell.step_s).round().max(1.0) as usize;
    steps
}

/// What the FMU is told while somebody stands there of whom no sensor outside of it tells.
fn standing(prepared: &Prepared, position: Vec3, heading_rad: f64) -> Vec<f64> {
    let (cell, binding) = (&prepared.cell, &prepared.binding);
    let feet = cell.body.feet(position, heading_rad);
    let seen = SensorTarget { feet, besides: None, body: None, position, heading_rad };
    let mut row = Vec::new();
    input_row(cell, binding, &vec![false; cell.sensors.len()], &seen, Presses::NONE, &mut row);
    row
}

/// What is odd about planes that the FMU evaluates itself: somebody stands in each as the cell file has it, facing along it or
/// across, whom it has to report; and well away from it, whom it has not. Where the FMU fails in that, it is told too.
pub(super) fn evaluated(prepared: &Prepared) -> Vec<String> {
    misplaced(prepared).unwrap_or_else(|failed| {
        vec![format!(
            "whether the FMU has its planes where the cell file does could not be tried: it failed meanwhile: {failed}"
        )]
    })
}

fn misplaced(prepared: &Prepared) -> Result<Vec<String>, PlantError> {
    let (cell, binding) = (&prepared.cell, &prepared.binding);
    let mut told = Vec::new();
    for (sensor, bound) in cell.sensors.iter().zip(&binding.sensors) {
        let (SensorBinding::Both { active, .. }, Some((plane, _))) = (bound, sensor.zone.plane()) else { continue };
        let [along, across] = [Vec3::X, Vec3::Y].map(|axis| plane.rotation * axis);
        let middle = plane.centre.with_z(0.0);
        let heading_rad = libm::atan2(across.y, across.x);
        let away = [-AWAY_M, AWAY_M].map(|by| (middle + across * by, heading_rad, false));
        // Whole bodies, as far as there is room for them between its ends.
        let to_end = (plane.half.x - HALF_BODY_M).max(0.0);
        let within = [-1.0, 0.0, 1.0].map(|part| middle + along * (part * to_end));
        let within = within.into_iter().flat_map(|at| [0.0, FRAC_PI_2].map(|turn| (at, heading_rad + turn, true)));
        for (at, heading_rad, is_in) in away.into_iter().chain(within) {
            let (inputs, stay) = (standing(prepared, at, heading_rad), stay(cell));
            let mut plant = prepared.plant_from(StateChoice::Replay, &inputs);
            let _ = plant.restart()?;
            let rows = plant.advance(stay, &inputs.repeat(stay))?;
            let reports = bound.reports(&rows[rows.len() - binding.outputs.len()..], sensor.signal);
            if reports != is_in {
                let (name, does) = (&sensor.name, if is_in { "does not report" } else { "reports" });
                let place = if is_in { "in its plane".to_owned() } else { format!("{AWAY_M} m away from it") };
                told.push(format!(
                    "sensor `{name}`: the FMU {does} a person who stands {place}, at ({:.2}, {:.2}) m. Either the cell file is wrong \
                     (its zone is not where the FMU has it, [pose] names other variables, or the polarity is the other way round: then \
                     evaluated.active = {}), or the FMU's sensor really does that, which is a flaw of the cell",
                    at.x, at.y, !active
                ));
                break;
            }
        }
    }
    Ok(told)
}

/// Tries the sensors inside the FMU; `idle_rows` tell where the robots are. None are told where the FMU does not know where
/// the person is. No run is longer than `run_s`.
pub(super) fn reported(prepared: &Prepared, idle_rows: &[f64], run_s: f64) -> Result<Vec<Reported>, PlantError> {
    let (cell, binding) = (&prepared.cell, &prepared.binding);
    let inside = |sensor: &usize| matches!(binding.sensors[*sensor], SensorBinding::Output(_));
    let inside: Vec<usize> = (0..cell.sensors.len()).filter(inside).collect();
    if inside.is_empty() || cell.pose.is_empty() {
        return Ok(Vec::new());
    }
    let [x, to_x, y, to_y] = area(cell, binding, idle_rows);
    let part = |from: f64, to: f64, n: u8| {
        let share = f64::from(n) / f64::from(ALONG - 1);
        from - BEYOND_M + share * (to - from + 2.0 * BEYOND_M)
    };
    let grid = (0..ALONG).flat_map(|i| (0..ALONG).map(move |j| (i, j)));
    let mut places: Vec<Vec3> = grid.map(|(i, j)| Vec3::new(part(x, to_x, i), part(y, to_y, j), 0.0)).collect();
    places.push(Vec3::new(to_x + BEYOND_M + FAR_M, to_y + BEYOND_M + FAR_M, 0.0));
    let heading_rad = cell.start.heading_deg().to_radians();
    let inputs: Vec<Vec<f64>> = places.iter().map(|place| standing(prepared, *place, heading_rad)).collect();
    let stay = stay(cell);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "tens")]
    let in_a_run = (run_s / STAY_S + 1e-6).floor().max(1.0) as usize;
    let mut plant = prepared.plant_from(StateChoice::Replay, &inputs[0]);
    let mut fired: Vec<BTreeSet<usize>> = vec![BTreeSet::new(); inside.len()];
    for (place, inputs) in inputs.iter().enumerate() {
        if place % in_a_run == 0 {
            let _ = plant.restart()?;
        }
        let rows = plant.advance(stay, &inputs.repeat(stay))?;
        // What is told at the end of the stay, so that the place before does not count.
        let last = &rows[rows.len() - binding.outputs.len()..];
        for (fired, &sensor) in fired.iter_mut().zip(&inside) {
            if binding.sensors[sensor].reports(last, cell.sensors[sensor].signal) {
                fired.insert(place);
            }
        }
    }
    let of = places.len() - 1;
    let told = |(fired, &sensor): (&BTreeSet<usize>, &usize)| Reported {
        sensor: cell.sensors[sensor].name.clone(),
        at: fired.iter().filter(|place| **place < of).count(),
        of,
        far_away: fired.contains(&of),
    };
    Ok(fired.iter().zip(&inside).map(told).collect())
}

/// The person's starts that sensors report at once. What they guard is then never come into, and they may hold the robots
/// from the beginning.
pub(super) fn starts_seen(prepared: &Prepared, idle_rows: &[f64]) -> Vec<String> {
    let cell = &prepared.cell;
    let mut told = Vec::new();
    for number in 0..cell.beginnings.len() {
        let world = if number == cell.beginning {
            World::new(cell.clone(), prepared.binding.clone())
        } else {
            let Ok(other) = prepared.beginning(number) else { continue };
            World::new(other.cell.clone(), other.binding.clone())
        };
        let readings = world.readings_at_start();
        let by: Vec<String> = (0..cell.sensors.len())
            .filter(|&sensor| match &prepared.binding.sensors[sensor] {
                // Who begins elsewhere has not let go of anything.
                _ if cell.sensors[sensor].zone.is_post() => false,
                SensorBinding::Input(_) => readings[sensor],
                bound => {
                    // Some steps on, where the person of this run still stands.
                    let row = idle_rows.chunks(prepared.binding.outputs.len()).nth(cell.steps_per_action * 2);
                    let says = |row: &[f64]| bound.reports(row, cell.sensors[sensor].signal);
                    number == cell.beginning && row.is_some_and(says)
                }
            })
            .map(|sensor| format!("`{}`", cell.sensors[sensor].name))
            .collect();
        if by.is_empty() {
            continue;
        }
        let [x, y] = cell.beginnings[number].start.xy_m();
        let two = cell.names().is_some();
        let who = if two { "two people start, the first of them" } else { "the person starts" };
        let sentence = format!(
            "{who} at ({x:.2}, {y:.2}) m where {} reports {}at once: how somebody comes there is not tried, and \
             robots that it stops may never move. Start outside, unless that is what you ask",
            by.join(" and "),
            if two { "either " } else { "" },
        );
        if !told.contains(&sentence) {
            told.push(sentence);
        }
    }
    told
}
