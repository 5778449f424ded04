//! The map of a whole floor, for people who come from anywhere: what its pictures share, and what they say first.

use std::collections::BTreeSet;

use serde::Serialize;

use fmi_hazard_record::reachability::{Cell, Ground, HarmfulPose, ReachabilityResult, changes_words, presses_words};

/// What a picture of the floor shows.
#[derive(Clone, Debug, Serialize)]
pub struct FloorMap<'a> {
    /// What it says, in a few sentences.
    pub said: String,
    /// How long after the start of the FMU is looked at, s.
    pub until_s: f64,
    /// How often controls are worked at most, if there are any.
    #[serde(skip)]
    pub presses: Option<u32>,
    /// How often what sensors report changed at most, if that was limited.
    #[serde(skip)]
    pub changes: Option<usize>,
    /// Edge of a square, m.
    pub cell_m: f64,
    /// Length of the spans of time of `floor`, s.
    pub span_s: f64,
    /// Whether poses that are hit at some moment were looked at in each span of time.
    pub followed: bool,
    /// Squares in which somebody is hit.
    pub floor: &'a [Cell],
    /// Middles of further squares of which it is not known whether anybody is hit there, m.
    pub open_m: Vec<[f64; 2]>,
    /// How many squares without a hit were not looked at to the end.
    #[serde(skip)]
    pub not_looked_at: usize,
    /// Where those are, and what is farther out, as rectangles by low x and y and high x and y, m.
    pub not_looked_at_m: &'a [[f64; 4]],
    /// Whether of all other floor without a hit that was looked at; else of none.
    pub looked_at: bool,
    /// The floor, and what the robots sweep.
    pub ground: &'a Ground,
    /// Ways to be hit, those first that a run of their own shows, and of them the worst.
    pub places: &'a [HarmfulPose],
    /// Why the absence of further hits is not shown.
    #[serde(skip)]
    pub reasons: &'a [String],
}

impl<'a> From<&'a ReachabilityResult> for FloorMap<'a> {
    fn from(found: &'a ReachabilityResult) -> Self {
        let edge = found.cell_m;
        let known: BTreeSet<[i64; 2]> = found.floor.iter().map(|cell| square(cell.xy_m, edge)).collect();
        let open = found.open_m.iter().chain(&found.between_m);
        let open: BTreeSet<[i64; 2]> = open.map(|at| square(*at, edge)).collect();
        #[expect(clippy::cast_precision_loss, reason = "some thousand squares to a side")]
        let middle = |square: &[i64; 2]| square.map(|at| (((at as f64 + 0.5) * edge) * 1000.0).round() / 1000.0);
        let mut this = Self {
            said: String::new(),
            until_s: found.until_s,
            presses: found.presses,
            changes: found.changes,
            cell_m: edge,
            span_s: found.span_s,
            followed: found.followed,
            floor: &found.floor,
            open_m: open.difference(&known).map(middle).collect(),
            not_looked_at: found.not_looked_at,
            not_looked_at_m: &found.not_looked_at_m,
            looked_at: found.not_looked_at_m.is_empty() && !found.ground.is_empty(),
            ground: &found.ground,
            places: &found.hazards,
            reasons: &found.reasons,
        };
        this.said = this.sentences();
        this
    }
}

impl FloorMap<'_> {
    /// So many squares as an area.
    #[must_use]
    pub(crate) fn area(&self, squares: usize) -> String {
        #[expect(clippy::cast_precision_loss, reason = "some thousand squares")]
        let area = squares as f64 * self.cell_m * self.cell_m;
        if area < 0.095 { format!("{area:.2} m²") } else { format!("{area:.1} m²") }
    }

    fn sentences(&self) -> String {
        let within = format!("within {:.1} s of the start", self.until_s);
        let shown = self.places.iter().find(|place| place.confirmed);
        let unseen = self.floor.iter().filter(|cell| cell.unseen).count();
        let walked = self.floor.len() - unseen;
        let can = |is_shown: bool| if is_shown { "can" } else { "may" };
        let stands = can(self.places.iter().any(|place| place.confirmed && !place.walks_in));
        let walks = can(shown.is_some());
        let mut said = Vec::new();
        match (unseen, walked) {
            (0, 0) if !self.looked_at => said.push(format!(
                "So far no place was found where somebody who comes unseen is hit harder than allowed {within}."
            )),
            (0, 0) => {
                let but = if self.reasons.is_empty() { "" } else { ", and it is not shown that there is none" };
                said.push(format!(
                    "No place was found where somebody who comes unseen is hit harder than allowed {within}{but}."
                ));
            }
            (0, walked) => said.push(format!(
                "On {} of the floor somebody who walks in {walks} be hit harder than allowed {within}, if they get there in time.",
                self.area(walked)
            )),
            (unseen, walked) => {
                said.push(format!(
                    "On {} of the floor somebody whom no sensor sees {stands} be hit harder than allowed {within}.",
                    self.area(unseen)
                ));
                if walked > 0 {
                    said.push(format!(
                        "On {} more, somebody who walks in may be, if they get there in time.",
                        self.area(walked)
                    ));
                }
            }
        }
        said.extend(
            shown.map(|worst| format!("The worst that a run of its own shows is {:.2} times the limit.", worst.ratio)),
        );
        said.extend(self.changes.map(changes_words));
        said.extend(self.presses.map(presses_words));
        if !self.looked_at {
            let unknown = "whether anybody else is hit is not known.";
            said.push(match self.not_looked_at {
                0 => format!("The floor was not looked at to the end: {unknown}"),
                squares => format!("{} of the floor were not looked at to the end: {unknown}", self.area(squares)),
            });
        }
        if !self.open_m.is_empty() {
            said.push(format!("Of {} it is not known.", self.area(self.open_m.len())));
        }
        said.join(" ")
    }
}

/// The square of the floor in which a place is.
#[expect(clippy::cast_possible_truncation, reason = "some thousand squares to a side")]
fn square(xy_m: [f64; 2], edge: f64) -> [i64; 2] {
    xy_m.map(|at| (at / edge).floor() as i64)
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// Some squares of a floor: hit unseen or not, with ratios.
    pub(crate) fn squares(all: &[(bool, f64)]) -> Vec<Cell> {
        let cell = |(number, (unseen, ratio)): (u32, &(bool, f64))| Cell {
            xy_m: [0.05 + 0.1 * f64::from(number), 0.05],
            ratio: *ratio,
            unseen: *unseen,
            earliest_s: 0.4,
            spans: vec![(3, *ratio)],
        };
        (0..).zip(all).map(cell).collect()
    }

    pub(crate) fn whole<'a>(floor: &'a [Cell], open_m: Vec<[f64; 2]>, ground: &'a Ground) -> FloorMap<'a> {
        let mut whole = FloorMap {
            said: String::new(),
            until_s: 2.0,
            presses: None,
            changes: None,
            cell_m: 0.1,
            span_s: 0.1,
            followed: true,
            floor,
            open_m,
            not_looked_at: 0,
            not_looked_at_m: &[],
            looked_at: true,
            ground,
            places: &[],
            reasons: &[],
        };
        whole.said = whole.sentences();
        whole
    }

    #[test]
    fn what_is_said_first_tells_who_is_unseen_from_who_walks_in_and_what_is_open() {
        let ground = Ground::default();
        let floor = squares(&[(true, 1.2), (true, 1.1), (false, 3.0)]);
        let said = whole(&floor, vec![[1.05, 0.05]], &ground).said;
        // No run shows any of it here.
        assert_eq!(
            said,
            "On 0.02 m² of the floor somebody whom no sensor sees may be hit harder than allowed within 2.0 s of the start. On 0.01 \
             m² more, somebody who walks in may be, if they get there in time. Of 0.01 m² it is not known."
        );
        assert!(whole(&[], Vec::new(), &ground).said.starts_with("No place was found"));
    }

    #[test]
    fn floor_that_was_not_looked_at_is_said_and_so_is_how_often_readings_change() {
        let (ground, floor) = (Ground::default(), squares(&[(true, 1.2)]));
        let mut unlooked =
            FloorMap { looked_at: false, not_looked_at: 130, changes: Some(1), ..whole(&[], Vec::new(), &ground) };
        assert_eq!(
            unlooked.sentences(),
            "So far no place was found where somebody who comes unseen is hit harder than allowed within 2.0 s of the start. What the \
             sensors report changes at most once then. 1.3 m² of the floor were not looked at to the end: whether anybody else is hit \
             is not known."
        );
        (unlooked.floor, unlooked.not_looked_at) = (&floor, 0);
        let said = unlooked.sentences();
        assert!(said.contains("The floor was not looked at to the end") && !said.contains("So far"), "{said}");
    }

    #[test]
    fn areas_are_read_at_a_glance() {
        let ground = Ground::default();
        let whole = whole(&[], Vec::new(), &ground);
        assert_eq!([whole.area(1), whole.area(10), whole.area(118)], ["0.01 m²", "0.1 m²", "1.2 m²"]);
    }
}
