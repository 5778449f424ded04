//! Checks of where and when the person begins: starts by themselves, and those on the lattices of start areas.

use std::collections::BTreeSet;
use std::ops::Range;

use toml::Spanned;

use super::checker::Checker;
use super::format::{HumanTable, StartAreaTable, StartTable};
use crate::cell::CellError;
use crate::cell::workcell::{InitialCondition, Obstacle, StartArea};
use crate::fmi::number;
use crate::geometry::Cuboid;
use crate::geometry::polygon::{contains, distance_to_edge};
use crate::human::walk::Walker;
use crate::human::{Body, Place, Posture, Start};

/// Latest that a person may begin, s.
const LATEST_S: f64 = 3600.0;

/// Most beginnings of a cell: each is searched by itself.
const MOST_BEGINNINGS: usize = 10_000;

/// Most places of a lattice around an area that are looked at.
const MOST_PLACES: f64 = 4e6;

/// This far outside the edge of an area is still on it, m.
const ON_EDGE_M: f64 = 1e-9;

/// Starts as tables, and what became of areas.
pub(super) struct Starts {
    pub tables: Vec<StartTable>,
    pub areas: Vec<StartArea>,
}

impl Checker<'_> {
    /// Every start, each once: those by themselves, then those of areas.
    pub(super) fn starts(&self, human: &HumanTable, body: Option<&Body>, obstacles: &[Obstacle]) -> Starts {
        let some =
            self.that(human.start.is_some() || !human.start_areas.is_empty(), self.source.table("human"), || {
                (
                    "the person has no start".to_owned(),
                    "add start = { xy_m = [0, -2], heading_deg = 90 } to [human], or a start_area".to_owned(),
                )
            });
        let _ = self.problems.keep(some);
        let own = human.start.iter().chain(&human.other_starts);
        let mut tables = self.problems.keep_all(own.map(|table| {
            let StartTable { xy_m: [x, y], heading_deg } = *table.get_ref();
            self.finite(&[x, y, heading_deg], &table.span(), "the start pose")?;
            self.of_a_workshop(&[x, y], &table.span(), "the start")?;
            Ok(*table.get_ref())
        }));
        let mut areas = Vec::new();
        // Who stands there is not known: that is told already.
        let Some(body) = body else { return Starts { tables, areas } };
        let obstacles: Vec<Cuboid> =
            obstacles.iter().filter(|obstacle| obstacle.follows.is_none()).map(|obstacle| obstacle.cuboid).collect();
        let bits = |table: &StartTable| [table.xy_m[0], table.xy_m[1], table.heading_deg].map(f64::to_bits);
        let mut known: BTreeSet<[u64; 3]> = tables.iter().map(bits).collect();
        for area in &human.start_areas {
            let Some((places, left_out)) = self.problems.keep(self.places(area, body, &obstacles)) else { continue };
            let StartAreaTable { spacing_m, heading_deg, .. } = area.get_ref();
            let told = StartArea { spacing_m: *spacing_m, headings: heading_deg.len(), places: places.len(), left_out };
            areas.push(told);
            let starts = places
                .iter()
                .flat_map(|&xy_m| heading_deg.iter().map(move |&heading_deg| StartTable { xy_m, heading_deg }));
            tables.extend(starts.filter(|start| known.insert(bits(start))));
        }
        Starts { tables, areas }
    }

    /// Corners of a polygon of the floor, if there is one, which the cell file calls so.
    pub(super) fn floor_polygon(
        &self,
        polygon: Option<&Spanned<Vec<[f64; 2]>>>,
        name: &str,
    ) -> Result<Option<Vec<[f64; 2]>>, Box<CellError>> {
        let Some(floor) = polygon else { return Ok(None) };
        let corners = floor.get_ref();
        self.that(corners.len() >= 3, floor.span(), || {
            (format!("{name} has {} corners", corners.len()), "give at least three".to_owned())
        })?;
        self.finite(&corners.concat(), &floor.span(), &format!("a corner of {name}"))?;
        self.plain_polygon(corners, &floor.span(), name)?;
        Ok(Some(corners.clone()))
    }

    /// Free places of an area's lattice, row after row, and how many are not free.
    fn places(
        &self,
        table: &Spanned<StartAreaTable>,
        body: &Body,
        obstacles: &[Cuboid],
    ) -> Result<(Vec<[f64; 2]>, usize), Box<CellError>> {
        let (span, area) = (table.span(), table.get_ref());
        let StartAreaTable { polygon_m, spacing_m, heading_deg } = area;
        self.that(polygon_m.len() >= 3, span.clone(), || {
            ("the start area needs at least three corners".to_owned(), "[[x, y], ...] in m".to_owned())
        })?;
        self.plain_polygon(polygon_m, &span, "the start area")?;
        self.finite(&polygon_m.concat(), &span, "a corner of the start area")?;
        self.that((0.05..=5.0).contains(spacing_m), span.clone(), || {
            (format!("spacing_m of the start area is {}", number(*spacing_m)), "use 0.05 to 5 m".to_owned())
        })?;
        self.that(!heading_deg.is_empty(), span.clone(), || {
            ("the start area has no heading".to_owned(), "for instance heading_deg = [0, 90, 180, 270]".to_owned())
        })?;
        self.finite(heading_deg, &span, "a heading of the start area")?;
        let bound = |axis: usize| {
            let along = polygon_m.iter().map(|corner| corner[axis]);
            let (low, high) = along.fold((f64::MAX, f64::MIN), |(low, high), v| (low.min(v), high.max(v)));
            // Whole multiples of the spacing: the lattice stays where it is when the area changes.
            (((low - ON_EDGE_M) / spacing_m).ceil(), ((high + ON_EDGE_M) / spacing_m).floor())
        };
        let [(left, right), (front, back)] = [bound(0), bound(1)];
        let around = (right - left + 1.0).max(0.0) * (back - front + 1.0).max(0.0);
        self.that(around <= MOST_PLACES, span.clone(), || {
            let message = format!("a lattice of {} m has {around:.0} places around the start area", number(*spacing_m));
            (message, "look at the corners, which are in m, or take a larger spacing_m".to_owned())
        })?;
        #[expect(clippy::cast_possible_truncation, reason = "checked: a few million")]
        let steps = |low: f64, high: f64| 0..(high - low + 1.0).max(0.0) as i64;
        #[expect(clippy::cast_precision_loss, reason = "a few million")]
        let at = |low: f64, step: i64| (((low + step as f64) * spacing_m) * 1e9).round() / 1e9;
        let (mut free, mut left_out) = (Vec::new(), 0);
        for row in steps(front, back) {
            for column in steps(left, right) {
                let place = [at(left, column), at(front, row)];
                if !contains(polygon_m, place) && distance_to_edge(polygon_m, place) > ON_EDGE_M {
                    continue;
                }
                let start = Start::new(place[0], place[1], 0.0);
                let walker = Walker { body, start: &start, sub_step_len_m: 0.0, obstacles, moving: &[], strides: 1 };
                if walker.is_free(Place::START, Posture::Upright) { free.push(place) } else { left_out += 1 }
            }
        }
        self.that(!free.is_empty(), span, || {
            let message = match left_out {
                0 => format!("no place of a lattice of {} m is in the start area", number(*spacing_m)),
                _ => format!("obstacles are in the way at all {left_out} places of the start area"),
            };
            (message, "make it larger or the spacing smaller; the body needs 0.14 m of room around it".to_owned())
        })?;
        Ok((free, left_out))
    }

    /// Every start at every time, the starts of one time together.
    pub(super) fn beginnings(&self, human: &HumanTable, starts: &[StartTable], step_s: f64) -> Vec<InitialCondition> {
        let times = &human.begins_s;
        let none = self.that(!times.get_ref().is_empty(), times.span(), || {
            ("human.begins_s is empty".to_owned(), "leave it out, or give [0, 1.5, 3]".to_owned())
        });
        let _ = self.problems.keep(none);
        let times = self.problems.keep_all(times.get_ref().iter().map(|&time| {
            self.that((0.0..=LATEST_S).contains(&time), times.span(), || {
                (format!("human.begins_s has {}", number(time)), format!("use times from 0 to {LATEST_S} s"))
            })?;
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "checked: an hour of small steps"
            )]
            Ok((time / step_s).round() as usize)
        }));
        let count = starts.len().saturating_mul(times.len());
        let span: Range<usize> = human.start_areas.first().map_or_else(|| human.begins_s.span(), Spanned::span);
        let few = self.that(count <= MOST_BEGINNINGS, span, || {
            let message = format!("the person has {count} beginnings: {} starts at {} times", starts.len(), times.len());
            let help = format!(
                "each is searched by itself, up to {MOST_BEGINNINGS}: take a larger spacing_m, or fewer headings or times"
            );
            (message, help)
        });
        if self.problems.keep(few).is_none() {
            return Vec::new();
        }
        let starts: Vec<Start> =
            starts.iter().map(|start| Start::new(start.xy_m[0], start.xy_m[1], start.heading_deg)).collect();
        let at = |&lead_in_steps: &usize| starts.iter().map(move |&start| InitialCondition { start, lead_in_steps });
        times.iter().flat_map(at).collect()
    }
}
