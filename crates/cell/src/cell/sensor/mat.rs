//! A pressure-sensitive mat as a kind of sensor.

use super::kind::{Change, Drawn, Key, Kind, Picture, Proposed, Recognised, SensorKind, Unseen, Zoned};
use super::rules::{From, Rules, Standing};
use super::{Placing, written};
use crate::standards::iso_13855::{self as iso, MAT_DEPTH_M};

/// The kind.
pub const KIND: SensorKind = SensorKind::new(&Mat);

struct Mat;

impl Kind for Mat {
    fn key(&self) -> &'static str {
        "mat"
    }

    fn doc(&self) -> &'static str {
        "A pressure-sensitive mat: fires when a foot stands on the zone (ISO 13856-1)."
    }

    fn name(&self) -> &'static str {
        "pressure-sensitive mat"
    }

    fn noun(&self) -> &'static str {
        "mat"
    }

    fn zone(&self) -> Zoned {
        Zoned::Written(written::floor)
    }

    fn keys(&self) -> &'static [Key] {
        &[Key::Latched, Key::CountsWhile]
    }

    fn changes(&self) -> &'static [Change] {
        &[Change::Wider]
    }

    fn unseen(&self, _: &Placing) -> Vec<Unseen> {
        Vec::new()
    }

    fn picture(&self) -> Option<Picture> {
        Some(Picture { called: "mat", drawn: Drawn::Mat })
    }

    fn recognised(&self) -> Recognised {
        Recognised::Sensor(&["mat", "mats"])
    }

    fn proposed(&self) -> Option<Proposed> {
        Some(Proposed { zone: "{ polygon_m = [[-1, -2], [1, -2], [1, -1], [-1, -1]] }", to_do: "corners on the floor" })
    }

    /// 2010: 7; it must not be stepped over.
    fn rules(&self, standing: &Standing<'_>) -> Rules {
        let (edition, z_m) = (standing.edition, standing.placing.supplement_m);
        let asks = Box::new(move |t_s| iso::mat(edition, t_s, z_m, 0.0));
        Rules::one("into it", From::Edge { least_depth_m: Some(MAT_DEPTH_M), asks })
    }
}
