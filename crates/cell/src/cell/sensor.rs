//! Sensors: what tells the FMU, or what the FMU tells, of people.
//!
//! - [`kind`]: all that differs by kind of sensor, [`kind::Kind`]; one file here has it for each kind
//! - [`zone`]: how a person is detected, whatever by: all that searches, pictures and advice ask
//! - [`rules`]: how far a safeguard has to stand from the robots, as a kind says it; [`guarding`]: what closes the way beside a plane
//! - [`written`]: the `zone` of a sensor in a cell file, as a kind reads it

mod guarding;
pub mod interlocked_door;
pub mod kind;
pub mod light_curtain;
pub mod mat;
pub mod reported;
pub mod rules;
pub mod scanner_field;
mod schema;
pub mod two_hand_control;
pub mod written;
pub mod zone;

pub use kind::SensorKind;
pub use zone::DetectionZone;

use crate::fmi::number;
use crate::standards::iso_13855::{Detection, Opening};

/// All kinds, as the cell file's reference has them. Where words of a name fit several, `init` takes the last.
pub const KINDS: &[SensorKind] = &[
    mat::KIND,
    scanner_field::KIND,
    light_curtain::KIND,
    interlocked_door::KIND,
    two_hand_control::KIND,
    reported::KIND,
];

/// What the FMU variable of a sensor says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Signal {
    /// True or false: this while somebody is detected.
    Boolean {
        /// Its value while somebody is detected.
        active: bool,
    },
    /// A number: one of two.
    Number {
        /// While nobody is detected.
        clear: f64,
        /// While somebody is.
        detected: f64,
    },
}

impl Signal {
    /// Its value, as numbers travel, while somebody is `detected` or not.
    #[must_use]
    pub fn value(self, detected: bool) -> f64 {
        match self {
            Self::Boolean { active } => f64::from(u8::from(detected == active)),
            Self::Number { detected: value, .. } if detected => value,
            Self::Number { clear, .. } => clear,
        }
    }

    /// Whether a value says that somebody is detected. Of a number, all but the one that says that nobody is.
    #[must_use]
    pub(crate) fn detects(self, value: f64) -> bool {
        match self {
            Self::Boolean { active } => (value != 0.0) == active,
            Self::Number { clear, .. } => value.partial_cmp(&clear) != Some(std::cmp::Ordering::Equal),
        }
    }

    /// The keys of a cell file in which it is the other way round.
    #[must_use]
    pub fn turned(self) -> String {
        match self {
            Self::Boolean { active } => format!("active = {}", !active),
            Self::Number { clear, detected } => {
                format!("values = {{ clear = {}, detected = {} }}", number(detected), number(clear))
            }
        }
    }
}

/// Its value while somebody is detected.
impl std::fmt::Display for Signal {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Boolean { active } => write!(f, "{active}"),
            Self::Number { detected, .. } => f.write_str(&number(*detected)),
        }
    }
}

/// A sensor.
#[derive(Clone, Debug, PartialEq)]
pub struct Sensor {
    /// Name used in results.
    pub name: String,
    /// What it is.
    pub kind: SensorKind,
    /// Where it sees.
    pub zone: DetectionZone,
    /// What its FMU variable says.
    pub signal: Signal,
    /// Response time in whole steps.
    pub delay_steps: usize,
    /// Whether the host holds the FMU's input once the sensor has told of somebody.
    pub latched: bool,
}

/// What the cell file says of a safeguard for its safety distance alone.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Placing {
    /// How finely a light curtain or a field sees.
    pub detection: Detection,
    /// Height above the floor, m, if its zone has one.
    pub height_m: Option<f64>,
    /// The line of its zone from above, m, if that has one.
    pub line_m: Option<[[f64; 2]; 2]>,
    /// How a door opens.
    pub opening: Opening,
    /// Supplement to the distance, m.
    pub supplement_m: f64,
}

#[cfg(test)]
mod tests {
    use super::kind::{Change, Key, Zoned};
    use super::rules::{From, Standing};
    use super::*;
    use crate::cell::design_parameter::{DesignParameters, Encounter};
    use crate::cell::error::Source;
    use crate::cell::file::validate::validate;
    use crate::cell::workcell::Workcell;
    use crate::standards::iso_13855::Edition;

    /// The text of a cell with a sensor of this kind where `init` proposes it.
    fn text(kind: SensorKind) -> String {
        let zone = kind.proposed().map_or_else(String::new, |proposed| format!("zone = {}\n", proposed.zone));
        format!(
            "schema = 1\nname = \"t\"\nfmu = \"t.fmu\"\n[time]\nstep_s = 0.02\n[[robot]]\nname = \"r\"\n\
             moving_mass_kg = 40\npayload_kg = 3\n[[robot.joint]]\nname = \"table\"\naxis = [0, 0, 1]\n\
             angle = {{ variable = \"q\", unit = \"rad\" }}\nspeed = {{ variable = \"qd\", unit = \"rad/s\" }}\n\
             [[robot.link]]\nname = \"bar\"\njoint = \"table\"\n\
             capsule = {{ from_m = [0, 0, 1], to_m = [0.8, 0, 1], radius_m = 0.05 }}\n\
             [[sensor]]\nname = \"safeguard\"\nkind = \"{}\"\nvariable = \"seen\"\nactive = true\n{zone}\
             [human]\nstart = {{ xy_m = [0, -3], heading_deg = 90 }}\n",
            kind.key()
        )
    }

    fn cell(text: &str) -> Workcell {
        validate(&Source::new("t.toml", text)).unwrap_or_else(|error| panic!("{error:?} in {text}"))
    }

    #[test]
    fn each_kind_is_read_where_init_proposes_it() {
        for kind in KINDS {
            let cell = cell(&text(*kind));
            assert_eq!(cell.sensors[0].kind, *kind);
            let in_fmu = cell.sensors[0].zone.is_in_fmu();
            assert_eq!((in_fmu, kind.proposed().is_none()), (matches!(kind.zone(), Zoned::InFmu), in_fmu), "{kind:?}");
            // Whatever is somewhere in the cell is drawn.
            assert_eq!(kind.picture().is_none(), in_fmu, "{kind:?}");
            assert_eq!(KINDS.iter().filter(|other| *other == kind).count(), 1, "{kind:?}");
        }
    }

    /// What cannot be changed in the file would be no change, and found to help nothing.
    #[test]
    fn what_a_kind_says_can_be_changed_can_be() {
        for kind in KINDS {
            let (text, encounter) = (text(*kind), Encounter { person_m: [0.0, -3.0], robot: 0 });
            let table: toml::Table = text.parse().unwrap();
            let knobs = DesignParameters::of(&cell(&text), &table, &[], &encounter).turned;
            let words: Vec<String> = knobs.iter().map(|knob| knob.words(1)).collect();
            let of_it = words.iter().filter(|words| words.contains("safeguard")).count();
            // What begins on the floor is down there.
            let changes = kind.changes().iter().filter(|change| **change != Change::DownToTheFloor).count();
            assert_eq!(of_it, changes + usize::from(kind.has(Key::Latched)), "{kind:?}: {words:?}");
            for knob in &knobs {
                let turned = knob.turned(&table, 1).unwrap_or_else(|| panic!("{kind:?}: {}", knob.words(1)));
                let sensors = cell(&turned.to_string()).sensors;
                assert!(sensors.len() > 1 || sensors[0].kind == *kind);
            }
        }
    }

    #[test]
    fn each_kind_asks_for_a_distance_by_both_editions_unless_the_fmu_has_it() {
        for (kind, edition) in KINDS.iter().flat_map(|kind| [(kind, Edition::Of2010), (kind, Edition::Of2024)]) {
            let cell = cell(&text(*kind));
            let (zone, placing) = (&cell.sensors[0].zone, cell.placings[0]);
            let rules = kind.rules(&Standing { edition, placing, zone, obstacles: &[] });
            assert_eq!(rules.ways.is_empty(), zone.is_in_fmu(), "{kind:?}");
            for way in rules.ways {
                let asked = match way.from {
                    From::Edge { asks, .. } | From::Line { asks, .. } => vec![asks(0.5)],
                    From::Bands { bands_m, asks, .. } => {
                        bands_m.iter().filter_map(|heights_m| asks(0.5, *heights_m)).collect()
                    }
                };
                // Nobody is slower than who walks.
                assert!(!asked.is_empty(), "{kind:?} {}", way.how);
                assert!(asked.iter().all(|required| required.separation.s_m() >= 0.8 - 1e-9), "{kind:?} {}", way.how);
            }
        }
    }

    #[test]
    fn messages_name_the_kind_first_whose_own_a_key_is_most() {
        let some = [mat::KIND, scanner_field::KIND, light_curtain::KIND, interlocked_door::KIND];
        let named = |key| SensorKind::all_with(&some, key).iter().map(|kind| kind.noun()).collect::<Vec<_>>();
        assert_eq!(named(Key::Resolution), ["light curtain", "scanner field"]);
        assert_eq!(named(Key::Latched), ["mat", "scanner field", "light curtain", "door"]);
        assert_eq!(named(Key::CountsWhile), ["mat", "scanner field"]);
    }
}
