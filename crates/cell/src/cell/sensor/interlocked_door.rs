//! Guard doors whose switch tells that they are open, without locking.

use super::kind::{Change, Drawn, Key, Kind, Picture, Proposed, Recognised, SensorKind, Unseen, Zoned};
use super::rules::{From, Rules, Standing};
use super::zone::line;
use super::{DetectionZone, Placing, written};
use crate::standards::iso_13855 as iso;

/// The kind.
pub const KIND: SensorKind = SensorKind::new(&InterlockedDoor);

struct InterlockedDoor;

impl Kind for InterlockedDoor {
    fn key(&self) -> &'static str {
        "interlocked_door"
    }

    fn doc(&self) -> &'static str {
        "The switch of a guard door (ISO 14119): fires while a part of the body or an arm is in the doorway, an upright plane.\n\
         Whoever has passed has closed the door behind them: no door tells of less."
    }

    fn name(&self) -> &'static str {
        "guard door without locking"
    }

    fn noun(&self) -> &'static str {
        "door"
    }

    fn zone(&self) -> Zoned {
        Zoned::Written(|zone| Ok(DetectionZone::Plane(written::plane(zone, "door")?)))
    }

    fn keys(&self) -> &'static [Key] {
        &[Key::OpeningGap, Key::OpeningTime, Key::Latched, Key::Evaluated]
    }

    fn changes(&self) -> &'static [Change] {
        &[Change::Higher, Change::DownToTheFloor, Change::MatBehind, Change::Farther]
    }

    /// It is taken to be open at once.
    fn unseen(&self, _: &Placing) -> Vec<Unseen> {
        Vec::new()
    }

    fn picture(&self) -> Option<Picture> {
        Some(Picture { called: "door", drawn: Drawn::Door })
    }

    fn recognised(&self) -> Recognised {
        Recognised::Held(&["guard", "door", "gate", "interlock"])
    }

    fn proposed(&self) -> Option<Proposed> {
        Some(Proposed { zone: "{ line_m = [[-1, -1], [1, -1]], heights_m = [0, 2] }", to_do: "the doorway, heights" })
    }

    /// 2010: 9; 2024: 12.
    fn rules(&self, standing: &Standing<'_>) -> Rules {
        let Standing { edition, placing: Placing { opening, supplement_m: z_m, .. }, zone, .. } = *standing;
        let DetectionZone::Plane(plane) = zone else { return Rules::default() };
        let asks = Box::new(move |t_s| iso::door(edition, t_s, z_m, &opening));
        let say_gap = || "say how wide it is open when its switch tells with opening_mm in the cell file".to_owned();
        Rules {
            notes: opening.gap_m.is_none().then(say_gap).into_iter().collect(),
            ..Rules::one("through", From::Line { line_m: line(plane), asks })
        }
    }
}
