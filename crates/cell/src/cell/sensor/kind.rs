//! What a kind of sensor says of itself. All that differs by kind is asked here, and every kind has to answer all of it: a new one does
//! not compile before both searches, `distance`, `explain`, `init` and the pictures know what to do with it.

use std::fmt;
use std::ops::Deref;

use super::rules::{Rules, Standing};
use super::written::Written;
use super::{DetectionZone, Placing};
use crate::cell::CellError;

/// A kind of sensor. No method has a default: whoever adds a kind thinks of each.
pub trait Kind: Sync {
    /// Its `kind` in a cell file.
    fn key(&self) -> &'static str;

    /// What a cell file's author has to know of it: when it reports, by which standard it is made.
    fn doc(&self) -> &'static str;

    /// What `distance` calls it.
    fn name(&self) -> &'static str;

    /// What messages call it, as in "a mat" and "no mat".
    fn noun(&self) -> &'static str;

    /// How it detects people.
    fn zone(&self) -> Zoned;

    /// The keys of a cell file that only some sensors have and this one has, those that are most its own first.
    fn keys(&self) -> &'static [Key];

    /// What `explain` may try to change of its zone, the more usual first.
    fn changes(&self) -> &'static [Change];

    /// What people do unseen by one with these data that its zone does not say.
    fn unseen(&self, placing: &Placing) -> Vec<Unseen>;

    /// How it is shown; none for what is not seen in a cell.
    fn picture(&self) -> Option<Picture>;

    /// How `init` recognises it.
    fn recognised(&self) -> Recognised;

    /// The zone that `init` proposes, and what of it is left to be filled in.
    fn proposed(&self) -> Option<Proposed>;

    /// How far it has to stand from the robots by ISO 13855.
    fn rules(&self, standing: &Standing<'_>) -> Rules;
}

/// How a kind of sensor detects people.
#[derive(Clone, Copy)]
pub enum Zoned {
    /// In the zone that the cell file gives it, read so.
    Written(fn(&dyn Written) -> Result<DetectionZone, Box<CellError>>),
    /// Inside the FMU.
    InFmu,
}

/// A key of a cell file that only some kinds of sensors have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Key {
    /// `latched`: the FMU's input may be held once it has reported.
    Latched,
    /// `evaluated`: the FMU may find out by itself whether it reports, from where the person's feet are.
    Evaluated,
    /// `counts_while`: the FMU may switch it off at times.
    CountsWhile,
    /// `resolution_mm`: how finely it sees.
    Resolution,
    /// `beams`: how many single beams it has.
    Beams,
    /// `opening_mm`: how wide it is open when it reports.
    OpeningGap,
    /// `opening_ms`: how long it then takes until somebody gets through.
    OpeningTime,
}

/// What of a sensor's zone can be changed to make a cell safer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Change {
    /// Every edge of its `polygon_m` outwards.
    Wider,
    /// The upper one of its `heights_m` up.
    Higher,
    /// The lower one of its `heights_m` down to the floor.
    DownToTheFloor,
    /// A mat behind its `line_m` that reports by the same input.
    MatBehind,
    /// Its `line_m` away from the robot.
    Farther,
}

impl Change {
    /// The key of `[explain.sensor]` that says how far.
    pub(in crate::cell) const fn limit(self) -> Option<&'static str> {
        match self {
            Self::Wider => Some("most_wider_m"),
            Self::Higher => Some("most_top_m"),
            Self::Farther => Some("most_farther_m"),
            Self::DownToTheFloor | Self::MatBehind => None,
        }
    }
}

/// What people do unseen by a sensor that its zone does not say.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unseen {
    /// A hand goes through its plane.
    HandsThrough,
    /// Who crouches or crawls is below it.
    LowBelow,
}

/// How a sensor is shown in the report's page.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Picture {
    /// What stands before its name, unless that says it.
    pub called: &'static str,
    /// How it is drawn.
    pub drawn: Drawn,
}

/// How a sensor is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Drawn {
    /// A mat: on the floor, opaque.
    Mat,
    /// A field: on the floor, faint.
    Field,
    /// A light curtain: upright.
    Curtain,
    /// A door: upright.
    Door,
    /// Where an operator stands: on the floor.
    Post,
}

impl Drawn {
    /// What the page's data and style sheet call it.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Mat => "mat",
            Self::Field => "field",
            Self::Curtain => "curtain",
            Self::Door => "door",
            Self::Post => "post",
        }
    }
}

/// How `init` recognises a kind of sensor by the words of an input's name or description, in lower case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Recognised {
    /// By any of these words: a sensor is proposed.
    Sensor(&'static [&'static str]),
    /// By any of these words: its input is held as it is while nobody touches it.
    Held(&'static [&'static str]),
    /// By no word.
    Never,
}

impl Recognised {
    /// The words.
    #[must_use]
    pub const fn words(self) -> &'static [&'static str] {
        match self {
            Self::Sensor(words) | Self::Held(words) => words,
            Self::Never => &[],
        }
    }
}

/// A zone that `init` proposes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Proposed {
    /// As a cell file has it.
    pub zone: &'static str,
    /// What is to be filled in.
    pub to_do: &'static str,
}

/// One of the kinds of [`super::KINDS`].
#[derive(Clone, Copy)]
pub struct SensorKind(&'static dyn Kind);

impl SensorKind {
    /// Of what says it.
    #[must_use]
    pub const fn new(kind: &'static dyn Kind) -> Self {
        Self(kind)
    }

    /// Whether it has a key that only some kinds have.
    #[must_use]
    pub fn has(self, key: Key) -> bool {
        self.keys().contains(&key)
    }

    /// Whether it is inside the FMU.
    #[must_use]
    pub fn is_in_fmu(self) -> bool {
        match self.zone() {
            Zoned::InFmu => true,
            Zoned::Written(_) => false,
        }
    }

    /// Those of `kinds` that have a key, those whose own it is most first.
    pub(in crate::cell) fn all_with(kinds: &[Self], key: Key) -> Vec<Self> {
        let place = |kind: &Self| kind.keys().iter().position(|own| *own == key);
        let mut with: Vec<(usize, Self)> = kinds.iter().filter_map(|kind| Some((place(kind)?, *kind))).collect();
        with.sort_by_key(|(place, _)| *place);
        with.into_iter().map(|(_, kind)| kind).collect()
    }
}

impl Deref for SensorKind {
    type Target = dyn Kind;

    fn deref(&self) -> &Self::Target {
        self.0
    }
}

impl PartialEq for SensorKind {
    fn eq(&self, other: &Self) -> bool {
        self.key() == other.key()
    }
}

impl Eq for SensorKind {}

impl fmt::Debug for SensorKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.key())
    }
}
