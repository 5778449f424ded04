//! Protective fields of laser scanners.

use super::kind::{Change, Drawn, Key, Kind, Picture, Proposed, Recognised, SensorKind, Unseen, Zoned};
use super::rules::{From, Rules, Standing};
use super::written::{self, Written};
use super::{DetectionZone, Placing};
use crate::cell::CellError;
use crate::fmi::number;
use crate::standards::iso_13855 as iso;

/// The kind.
pub const KIND: SensorKind = SensorKind::new(&ScannerField);

/// Height above the floor unless told otherwise, m.
const HEIGHT_M: f64 = 0.2;

/// Fields higher than this above the floor may be crawled under, m (ISO 13855:2010, 6.3).
const UNDER_M: f64 = 0.3;

struct ScannerField;

fn read(zone: &dyn Written) -> Result<DetectionZone, Box<CellError>> {
    let height_m = zone.height_m().unwrap_or(HEIGHT_M);
    if !(0.0..=1.0).contains(&height_m) {
        let message = format!("the height of sensor `{}` is {} m", zone.name(), number(height_m));
        return Err(zone.wrong(message, "ISO 13855 allows 0 to 1 m"));
    }
    written::floor(zone)
}

impl Kind for ScannerField {
    fn key(&self) -> &'static str {
        "scanner_field"
    }

    fn doc(&self) -> &'static str {
        "A scanner field: fires when a leg is in the zone (IEC 61496-3)."
    }

    fn name(&self) -> &'static str {
        "scanner field"
    }

    fn noun(&self) -> &'static str {
        "scanner field"
    }

    fn zone(&self) -> Zoned {
        Zoned::Written(read)
    }

    fn keys(&self) -> &'static [Key] {
        &[Key::Latched, Key::CountsWhile, Key::Resolution]
    }

    fn changes(&self) -> &'static [Change] {
        &[Change::Wider]
    }

    /// A field is at a height, and its zone a polygon.
    fn unseen(&self, placing: &Placing) -> Vec<Unseen> {
        let below = placing.height_m.unwrap_or(HEIGHT_M) > UNDER_M;
        below.then_some(Unseen::LowBelow).into_iter().collect()
    }

    fn picture(&self) -> Option<Picture> {
        Some(Picture { called: "field", drawn: Drawn::Field })
    }

    fn recognised(&self) -> Recognised {
        Recognised::Sensor(&["scanner", "laser", "lidar", "field", "zone", "area", "aopddr"])
    }

    fn proposed(&self) -> Option<Proposed> {
        Some(Proposed { zone: "{ polygon_m = [[-1, -2], [1, -2], [1, -1], [-1, -1]] }", to_do: "corners on the floor" })
    }

    /// 2010: 6.3; 2024: 9.
    fn rules(&self, standing: &Standing<'_>) -> Rules {
        let Standing { edition, placing, .. } = *standing;
        let (height_m, resolution_m) = (placing.height_m.unwrap_or(HEIGHT_M), placing.detection.resolution_m);
        let asks = Box::new(move |t_s| iso::along(edition, t_s, placing.supplement_m, height_m, resolution_m));
        Rules::one("into it", From::Edge { least_depth_m: None, asks })
    }
}
