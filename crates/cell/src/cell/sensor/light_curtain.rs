//! Light curtains, and rows of single light beams.

use super::guarding::{GAP_M, closed};
use super::kind::{Change, Drawn, Key, Kind, Picture, Proposed, Recognised, SensorKind, Unseen, Zoned};
use super::rules::{Approach, From, Rules, Standing};
use super::zone::{heights, line};
use super::{DetectionZone, Placing, written};
use crate::standards::iso_13855::{self as iso, DRAFT_ASKS_LESS_FROM_M, Detection, Edition, FINE_M};

/// The kind.
pub const KIND: SensorKind = SensorKind::new(&LightCurtain);

struct LightCurtain;

impl Kind for LightCurtain {
    fn key(&self) -> &'static str {
        "light_curtain"
    }

    fn doc(&self) -> &'static str {
        "A light curtain: fires when a part of the body or an arm passes through an upright plane (IEC 61496-2). An arm\n\
         that reaches through it does so at 2.0 m/s (ISO 13855)."
    }

    fn name(&self) -> &'static str {
        "light curtain"
    }

    fn noun(&self) -> &'static str {
        "light curtain"
    }

    fn zone(&self) -> Zoned {
        Zoned::Written(|zone| Ok(DetectionZone::Plane(written::plane(zone, "light curtain")?)))
    }

    fn keys(&self) -> &'static [Key] {
        &[Key::Resolution, Key::Beams, Key::Latched, Key::Evaluated]
    }

    fn changes(&self) -> &'static [Change] {
        &[Change::Higher, Change::DownToTheFloor, Change::MatBehind, Change::Farther]
    }

    /// Its zone is taken to be without gaps.
    fn unseen(&self, placing: &Placing) -> Vec<Unseen> {
        let detection = &placing.detection;
        let says = detection.beams.is_some() || detection.resolution_m.is_some();
        (says && !detection.is_fine()).then_some(Unseen::HandsThrough).into_iter().collect()
    }

    fn picture(&self) -> Option<Picture> {
        Some(Picture { called: "curtain", drawn: Drawn::Curtain })
    }

    fn recognised(&self) -> Recognised {
        Recognised::Sensor(&["curtain", "lightcurtain", "barrier", "aopd"])
    }

    fn proposed(&self) -> Option<Proposed> {
        Some(Proposed {
            zone: "{ line_m = [[-1, -1], [1, -1]], heights_m = [0, 1.8] }",
            to_do: "ends on the floor, heights",
        })
    }

    /// 2010: 6.2 through it, 6.5 over it; 2024: 8.
    fn rules(&self, standing: &Standing<'_>) -> Rules {
        let Standing { edition, placing: Placing { detection, .. }, .. } = *standing;
        Rules { notes: notes(edition, detection.resolution_m), ..past(standing, detection) }
    }
}

/// What is asked of a light curtain or of single beams that see so finely.
pub(super) fn past(standing: &Standing<'_>, detection: Detection) -> Rules {
    let Standing { edition, placing: Placing { supplement_m: z_m, .. }, zone, obstacles } = *standing;
    let DetectionZone::Plane(plane) = zone else { return Rules::default() };
    let [low_m, high_m] = closed(plane, obstacles);
    // What guards it below is in nobody's way to be seen.
    let under = if low_m > GAP_M { iso::under(edition, low_m, &detection) } else { None };
    let heights_of_beams = detection.beams.and_then(|beams| iso::beam_heights(beams, heights(plane)));
    let through =
        From::Line { line_m: line(plane), asks: Box::new(move |t_s| iso::through(edition, t_s, z_m, &detection)) };
    let over = From::Bands {
        line_m: line(plane),
        // Higher or lower parts of the robots may be farther away, and be asked for more.
        bands_m: match edition {
            Edition::Of2010 => iso::heights_for_reaching_over().collect(),
            Edition::Of2024 => vec![[0.0, 2.7]],
        },
        asks: Box::new(move |t_s, heights_m| iso::over(edition, t_s, z_m, &detection, (heights_m, high_m))),
    };
    Rules {
        ways: vec![Approach { how: "through", from: through }, Approach { how: "over", from: over }],
        not_known: under.into_iter().chain(heights_of_beams).collect(),
        notes: Vec::new(),
    }
}

/// What else there is to say.
fn notes(edition: Edition, resolution_m: Option<f64>) -> Vec<String> {
    let mut notes = Vec::new();
    if edition == Edition::Of2024 {
        notes.push("--edition 2010 has a table for reaching over".to_owned());
        if resolution_m.is_some_and(|d| d > DRAFT_ASKS_LESS_FROM_M + 1e-9 && d <= FINE_M + 1e-9) {
            let may_ask_less =
                "D_DS = 8 (d - 14) is that of 2010; the edition of 2024 may ask for less between 20 and 40 mm";
            notes.push(may_ask_less.to_owned());
        }
    }
    notes
}
