//! Two-hand controls: they report unless somebody stands at their post with both hands on them.

use super::kind::{Change, Drawn, Key, Kind, Picture, Proposed, Recognised, SensorKind, Unseen, Zoned};
use super::rules::{From, Rules, Standing};
use super::written::Written;
use super::zone::{line, upright};
use super::{DetectionZone, Placing};
use crate::cell::CellError;
use crate::geometry::{Cuboid, Vec3};
use crate::standards::iso_13855 as iso;

/// The kind.
pub const KIND: SensorKind = SensorKind::new(&TwoHandControl);

/// How far the plane of the buttons goes on beside them, and half its height, m: more than any arm is long.
const ASIDE_M: f64 = 3.0;

struct TwoHandControl;

fn read(zone: &dyn Written) -> Result<DetectionZone, Box<CellError>> {
    let post = zone.polygon_m()?;
    let plane = buttons(zone, &post)?;
    Ok(DetectionZone::Post { post, plane })
}

/// The plane of the buttons: farther to all sides than an arm gets past it.
fn buttons(zone: &dyn Written, post: &[[f64; 2]]) -> Result<Cuboid, Box<CellError>> {
    let name = zone.name();
    let Some(line) = zone.line_m() else {
        return Err(zone.wrong(
            format!("two-hand control `{name}` does not say where its buttons are"),
            "beside polygon_m, where its operator stands, add line_m: two points on the line of the buttons",
        ));
    };
    if zone.heights_m().is_some() {
        let message = format!("two-hand control `{name}` has heights_m, which are not read");
        return Err(zone.wrong(message, "remove them: hands that hold it are nowhere behind it"));
    }
    let narrow = upright(line, [0.0, 2.0 * ASIDE_M]);
    if !(narrow.half.x.is_finite() && narrow.half.x > 0.0) {
        let message = format!("the line of two-hand control `{name}` has no length");
        return Err(zone.wrong(message, "two different points, in m"));
    }
    let side = |[x, y]: &[f64; 2]| (narrow.rotation * Vec3::Y).dot(Vec3::new(*x, *y, 0.0) - narrow.centre);
    let one_side = post.iter().all(|p| side(p) > 0.0) || post.iter().all(|p| side(p) < 0.0);
    if !one_side {
        return Err(zone.wrong(
            format!("the line of two-hand control `{name}` goes through its operator's post"),
            "the buttons are in front of the operator: all corners of polygon_m on one side of line_m",
        ));
    }
    Ok(Cuboid { half: narrow.half.with_x(narrow.half.x + ASIDE_M), ..narrow })
}

impl Kind for TwoHandControl {
    fn key(&self) -> &'static str {
        "two_hand_control"
    }

    fn doc(&self) -> &'static str {
        "A two-hand control (ISO 13851): fires unless the person stands at its post with both hands on it. A hand may let go\n\
         at any time; behind the plane of the buttons it is then as far as it gets at 2.0 m/s."
    }

    fn name(&self) -> &'static str {
        "two-hand control"
    }

    fn noun(&self) -> &'static str {
        "two-hand control"
    }

    fn zone(&self) -> Zoned {
        Zoned::Written(read)
    }

    fn keys(&self) -> &'static [Key] {
        &[]
    }

    /// Its operator would have to move with it.
    fn changes(&self) -> &'static [Change] {
        &[]
    }

    fn unseen(&self, _: &Placing) -> Vec<Unseen> {
        Vec::new()
    }

    fn picture(&self) -> Option<Picture> {
        Some(Picture { called: "post", drawn: Drawn::Post })
    }

    fn recognised(&self) -> Recognised {
        Recognised::Held(&["twohand"])
    }

    fn proposed(&self) -> Option<Proposed> {
        Some(Proposed {
            zone: "{ polygon_m = [[-0.3, -2], [0.3, -2], [0.3, -1.5], [-0.3, -1.5]], line_m = [[-0.3, -1.3], [0.3, -1.3]] }",
            to_do: "where its operator stands, and the line of its buttons",
        })
    }

    /// 2010: 8, from the nearest of its buttons.
    fn rules(&self, standing: &Standing<'_>) -> Rules {
        let Standing { edition, placing: Placing { line_m, supplement_m: z_m, .. }, zone, .. } = *standing;
        let DetectionZone::Post { plane, .. } = zone else { return Rules::default() };
        let asks = Box::new(move |t_s| iso::two_hand(edition, t_s, z_m));
        Rules::one("from it", From::Line { line_m: line_m.unwrap_or_else(|| line(plane)), asks })
    }
}
