//! How far safeguards stand from the robots, and how far they have to by ISO 13855: as data, and in words with the formula
//! filled in.
//!
//! Distances that are asked for are rounded up to whole millimetres, those that there are down.

use std::fmt::Write as _;

use schemars::JsonSchema;
use serde::Serialize;

use crate::standards::iso_13855::{Edition, Required, Separation};
use crate::standards::provenance::Table;
use fmi_hazard_record::paragraph::{WIDTH, wrapped_to};
use fmu_self_test::number;

/// All safeguards of a cell.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Distances {
    /// Name of the cell.
    pub cell: String,
    /// Edition of ISO 13855.
    pub edition: Edition,
    /// How long each run was in which stop times and the robots' reach were measured, s.
    pub run_s: f64,
    /// Fastest point of any robot while nobody was detected, m/s.
    pub fastest_m_s: f64,
    /// One for each sensor of the cell.
    pub safeguards: Vec<Safeguard>,
    /// What else there is to know.
    pub warnings: Vec<String>,
    /// Where the figures come from.
    pub tables: Vec<Table>,
}

/// Whether a safeguard stands far enough away.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Placed {
    /// At least as far as S on every way that is known, and nothing is not known.
    FarEnough,
    /// S, or whether it applies, is not known, and the least that it can be is kept.
    NotKnown,
    /// Nearer than S, or than the least that it can be.
    TooNear,
}

/// A safeguard.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Safeguard {
    /// Name of the sensor.
    pub sensor: String,
    /// What it is, in words.
    pub kind: String,
    /// Whether it stands far enough away.
    pub placed: Placed,
    /// Longest time from when the FMU is told until the robots stand still, s, if it stops them whenever it reports.
    pub stop_s: Option<f64>,
    /// What it did at each moment that was tried.
    pub moments: Vec<Stopped>,
    /// Response time of its own before the FMU is told, s.
    pub delay_s: f64,
    /// T: both together, s.
    pub t_s: Option<f64>,
    /// The ways past it, that with the least room first.
    pub ways: Vec<ApproachPath>,
    /// How much farther it is than S on the way with the least room, mm; negative where it is nearer. Where something is not known, S
    /// is the least that it can be.
    pub margin_mm: Option<i64>,
    /// What is not known, and why.
    pub not_known: Vec<String>,
    /// What else there is to say.
    pub notes: Vec<String>,
}

/// What a sensor does that begins to report at some moment.
#[derive(Clone, Copy, Debug, Serialize, JsonSchema)]
pub struct Stopped {
    /// When it begins to report, s after the beginning of the run.
    pub at_s: f64,
    /// Time until the robots stand still, s, if it stops them.
    pub still_after_s: Option<f64>,
}

/// A way past a safeguard to the robots.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct ApproachPath {
    /// How somebody comes: through it, over it, into it and so on.
    pub how: String,
    /// Clause of the standard.
    pub clause: Option<String>,
    /// The formula with its numbers.
    pub formula: Option<String>,
    /// S, mm: rounded up; none for a sensor that does not stop the robots.
    pub s_mm: Option<i64>,
    /// How far the safeguard is from the nearest point that a moving robot reaches, mm: rounded down.
    pub stands_mm: i64,
    /// That less S, mm.
    pub margin_mm: Option<i64>,
    /// Whether S is known, and not only the least that it can be.
    pub known: bool,
    /// The point of the safeguard's edge that is nearest, m.
    pub edge_m: [f64; 2],
    /// The link that comes nearest.
    pub link: String,
    /// When it does, s after the beginning of the run.
    pub at_s: f64,
}

/// A length that is asked for, in whole mm.
#[must_use]
#[expect(clippy::cast_possible_truncation, reason = "some metres")]
pub fn asked_mm(m: f64) -> i64 {
    (m * 1000.0 - 1e-6).ceil() as i64
}

/// A length that there is, in whole mm.
#[must_use]
#[expect(clippy::cast_possible_truncation, reason = "some metres")]
pub fn there_mm(m: f64) -> i64 {
    (m * 1000.0 + 1e-6).floor() as i64
}

/// `S = K T + C = ...` with the numbers.
#[must_use]
pub fn formula(edition: Edition, required: &Required) -> String {
    let Separation { k_m_s, t_s, c_m, z_m, at_least_m } = required.separation;
    let mm = |m: f64| number((m * 1e6).round() / 1e3);
    let (sum_m, s_mm) = (k_m_s * t_s + c_m, asked_mm(required.separation.s_m()));
    let (letters, supplement) = match edition {
        Edition::Of2010 if z_m <= 0.0 => ("K T + C", String::new()),
        Edition::Of2010 => ("K T + C + Z", format!(" + {} mm", mm(z_m))),
        Edition::Of2024 => ("K T + D_DS + Z", format!(" + {} mm", mm(z_m))),
    };
    let is = if required.not_known.is_empty() { "S =" } else { "S, not known, at least" };
    let least = if sum_m + 1e-9 < at_least_m { format!(", not below {} mm:", mm(at_least_m)) } else { " =".to_owned() };
    format!("{is} {letters} = {} mm/s x {t_s:.3} s + {} mm{supplement}{least} {s_mm} mm", mm(k_m_s), mm(c_m))
}

impl Distances {
    /// The worst of all.
    #[must_use]
    pub fn placed(&self) -> Placed {
        self.safeguards.iter().map(|one| one.placed).max().unwrap_or(Placed::NotKnown)
    }

    /// For people.
    #[must_use]
    pub fn render(&self, path: &str) -> String {
        let mut text = String::new();
        for safeguard in &self.safeguards {
            safeguard.write(&mut text);
        }
        let count = |placed: Placed| self.safeguards.iter().filter(|one| one.placed == placed).count();
        let counted =
            [(Placed::TooNear, "too near"), (Placed::NotKnown, "not known"), (Placed::FarEnough, "far enough")]
                .map(|(placed, words)| format!("{} {words}", count(placed)));
        if self.safeguards.is_empty() {
            let _ = writeln!(text, "{}: no sensor in the cell file, so no safeguard that could be too near", self.cell);
            return text;
        }
        let _ = writeln!(text, "{}: {} by {}", self.cell, counted.join(", "), self.edition.name());
        text += &wrapped_to(
            WIDTH,
            "  ",
            &format!(
                "Stop times and what robots reach were measured in runs of {} s. S is the figure of the textbook. Whether \
                 anybody can be hit, near or far: fmi-hazard scan {path}",
                number(self.run_s)
            ),
        );
        text += &wrapped_to(
            WIDTH,
            "  ",
            "The rules are from makers' manuals and guides (--format json names them), not verified against the purchased standard.",
        );
        text
    }
}

impl Safeguard {
    fn write(&self, text: &mut String) {
        *text += &wrapped_to(WIDTH, &format!("  {:<9} ", self.sensor), &self.stops());
        let mut line = |head: &str, words: &str| *text += &wrapped_to(WIDTH, &format!("            {head:<9} "), words);
        for way in &self.ways {
            if let (Some(formula), Some(clause)) = (&way.formula, &way.clause) {
                line(&way.how, &format!("{formula} ({clause})"));
            }
            // No -0.00.
            let [x, y] = way.edge_m.map(|m| (m * 100.0).round() / 100.0 + 0.0);
            let stands =
                format!("{} mm from {} at {:.2} s (edge at {:.2}, {:.2} m)", way.stands_mm, way.link, way.at_s, x, y);
            let room = way.margin_mm.map_or_else(String::new, |margin| format!(": {}", room(margin)));
            line("stands", &format!("{stands}{room}"));
        }
        for reason in &self.not_known {
            line("not known", reason);
        }
        for note in &self.notes {
            line("note", note);
        }
        let verdict = match (self.placed, self.margin_mm) {
            (Placed::FarEnough, _) => "far enough".to_owned(),
            (Placed::NotKnown, Some(_)) => {
                "not known: it is far enough for the least that S can be, and S may be more".to_owned()
            }
            (Placed::NotKnown, None) => "not known".to_owned(),
            (Placed::TooNear, margin) => format!("TOO NEAR by {} mm", -margin.unwrap_or_default()),
        };
        line("so it is", &verdict);
    }

    /// What it is, and T.
    fn stops(&self) -> String {
        let kind = &self.kind;
        let (Some(stop_s), Some(t_s)) = (self.stop_s, self.t_s) else { return kind.clone() };
        let moments = match self.moments.len() {
            1 => "1 moment".to_owned(),
            count => format!("the longest of {count} moments"),
        };
        let own = match self.delay_s > 0.0 {
            true => {
                format!(", which is {} ms after it sees: T = {t_s:.3} s", number((self.delay_s * 1e6).round() / 1e3))
            }
            false => String::new(),
        };
        format!("{kind}; the robots stand {stop_s:.3} s after the FMU is told ({moments}){own}")
    }
}

fn room(margin_mm: i64) -> String {
    match margin_mm {
        0.. => format!("{margin_mm} mm more than that"),
        _ => format!("{} mm less than that", -margin_mm),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::standards::iso_13855::{Detection, through, two_hand};

    #[test]
    fn the_formula_has_its_numbers() {
        let fine = Detection { resolution_m: Some(0.03), beams: None };
        let of = |t_s, z_m| formula(Edition::Of2010, &through(Edition::Of2010, t_s, z_m, &fine));
        assert_eq!(of(0.45, 0.0), "S = K T + C = 1600 mm/s x 0.450 s + 128 mm = 848 mm");
        assert_eq!(of(0.1, 0.05), "S = K T + C + Z = 2000 mm/s x 0.100 s + 128 mm + 50 mm = 378 mm");
        assert_eq!(of(0.2, 0.0), "S = K T + C = 1600 mm/s x 0.200 s + 128 mm, not below 500 mm: 500 mm");
        let held = two_hand(Edition::Of2024, 0.0631, 0.0);
        assert_eq!(
            formula(Edition::Of2024, &held),
            "S = K T + D_DS + Z = 1600 mm/s x 0.063 s + 550 mm + 0 mm = 651 mm"
        );
        let unknown = through(Edition::Of2010, 0.45, 0.0, &Detection::default());
        assert_eq!(
            formula(Edition::Of2010, &unknown),
            "S, not known, at least K T + C = 1600 mm/s x 0.450 s + 0 mm = 720 mm"
        );
    }

    #[test]
    fn what_is_asked_is_rounded_up_and_what_there_is_down() {
        assert_eq!((asked_mm(0.6304), asked_mm(0.63), there_mm(0.6309), there_mm(0.63)), (631, 630, 630, 630));
    }
}
