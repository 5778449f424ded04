//! Sensors inside the FMU, which tells what they report.

use super::Placing;
use super::kind::{Change, Key, Kind, Picture, Proposed, Recognised, SensorKind, Unseen, Zoned};
use super::rules::{Rules, Standing};

/// The kind.
pub const KIND: SensorKind = SensorKind::new(&Reported);

struct Reported;

impl Kind for Reported {
    fn key(&self) -> &'static str {
        "reported"
    }

    fn doc(&self) -> &'static str {
        "A sensor inside the FMU, which reports it with a Boolean output."
    }

    fn name(&self) -> &'static str {
        "sensor inside the FMU"
    }

    fn noun(&self) -> &'static str {
        "sensor inside the FMU"
    }

    fn zone(&self) -> Zoned {
        Zoned::InFmu
    }

    fn keys(&self) -> &'static [Key] {
        &[]
    }

    /// The FMU has it where it is.
    fn changes(&self) -> &'static [Change] {
        &[]
    }

    /// The FMU knows.
    fn unseen(&self, _: &Placing) -> Vec<Unseen> {
        Vec::new()
    }

    fn picture(&self) -> Option<Picture> {
        None
    }

    /// It is an output: `init` knows it by that.
    fn recognised(&self) -> Recognised {
        Recognised::Never
    }

    fn proposed(&self) -> Option<Proposed> {
        None
    }

    /// Where it begins to see somebody is not known here.
    fn rules(&self, _: &Standing<'_>) -> Rules {
        Rules::default()
    }
}
