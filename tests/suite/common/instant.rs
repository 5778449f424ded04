//! One instant of a cell with the bar of `guarded`, as the search from anywhere is asked about it.

use std::sync::Arc;

use super::anywhere::cell;
use super::guarded::guarded;
use super::write;
use fmi_hazard::geometry::Vec3;
use fmi_hazard::host::Plant as _;
use fmi_hazard::human::{DistanceField, Presses};
use fmi_hazard::reachability::{History, ReachabilitySearch as Search, ReachableInstant as AnInstant};
use fmi_hazard::scan::StateChoice;
use fmi_hazard::scan::prepare::{Prepared, prepare};
use fmi_hazard::search::Rng;
use fmi_hazard::sim::robot::RobotFrame;
use fmi_hazard::sim::sensors::{SensorTarget, input_row};
use fmi_hazard::stop::Stop;
use tempfile::TempDir;

/// People are anywhere.
pub const ANYWHERE: (&dyn Fn([f64; 2]) -> bool, f64) = (&|_| true, 1.0);

/// The bar, so slow that it harms no arm, without bends or with them.
pub fn slow(z: f64, parts: &str, bends: bool) -> String {
    let text = cell(z, parts).replace("\"drive.speed\" = 5", "\"drive.speed\" = 2");
    let straight = "[human]\nbend_forward_deg = 0\nbend_lateral_deg = 0\n";
    if bends { text } else { text.replace("[human]\n", straight) }
}

pub fn uniform(rng: &mut Rng, low: f64, high: f64) -> f64 {
    low + (high - low) * f64::from(u32::try_from(rng.below(1 << 20)).unwrap()) / f64::from(1 << 20)
}

/// A cell, and the bar in it after so many steps.
pub struct Instant {
    pub prepared: Prepared,
    pub frame: Arc<RobotFrame>,
    _dir: TempDir,
}

impl Instant {
    pub fn of(text: &str, steps: usize) -> Self {
        let dir = guarded();
        let prepared = prepare(&write(dir.path(), "cell.toml", text), None).unwrap();
        let (cell, binding) = (&prepared.cell, &prepared.binding);
        let nobody = seen(&prepared, [9.0, 9.0], 0.0);
        let mut inputs = Vec::new();
        for _ in 0..steps {
            input_row(cell, binding, &vec![false; cell.sensors.len()], &nobody, Presses::NONE, &mut inputs);
        }
        let mut plant = prepared.plant(StateChoice::Replay);
        plant.restart().unwrap();
        let outputs = plant.advance(steps, &inputs).unwrap();
        let frame = Arc::new(RobotFrame::new(cell, binding, outputs.chunks(binding.columns()).last().unwrap()));
        assert!(frame.may_harm);
        Self { prepared, frame, _dir: dir }
    }

    /// A history of this instant, of people who walked so far at most from places where `from` is.
    pub fn history(
        &self,
        search: &Search<'_>,
        reading: Option<bool>,
        (from, within_m): (&dyn Fn([f64; 2]) -> bool, f64),
    ) -> History {
        let floor = search.floor();
        let open: Vec<bool> = (0..floor.cells()).map(|cell| floor.is_open(cell)).collect();
        let sources: Vec<bool> = (0..floor.cells()).map(|cell| from(floor.middle(cell))).collect();
        let frame = Arc::clone(&self.frame);
        let within_m = [within_m, f64::MAX];
        History {
            readings: vec![reading; self.prepared.cell.sensors.len()],
            links: vec![true].into(),
            fields: [
                DistanceField::from(floor, &sources, &open, f64::INFINITY, &Stop::default()).unwrap(),
                DistanceField::at_once(floor, &open),
            ]
            .map(Arc::new),
            seen: vec![AnInstant {
                step: 1,
                lasting: 0,
                frame,
                within_m,
                depth_m: f64::INFINITY,
                story: Arc::default(),
                came: None,
            }],
        }
    }
}

pub fn seen(prepared: &Prepared, [x, y]: [f64; 2], heading_rad: f64) -> SensorTarget {
    let position = Vec3::new(x, y, 0.0);
    SensorTarget {
        feet: prepared.cell.body.feet(position, heading_rad),
        besides: None,
        body: None,
        position,
        heading_rad,
    }
}
