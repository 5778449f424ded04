//! Pictures of a campaign as SVG: how hard people are hit over the values of a sweep, over the robots' cycle and over the floor.

use svg::Document;
use svg::node::element::{Circle, Group, Line, Path, Rectangle, Text, Title};

use super::survey::{CellRow, Row, State, Survey, line_of};

/// All pictures there may be, by their file names.
pub const NAMES: [&str; 3] = ["sweep.svg", "cycle.svg", "floor.svg"];

/// A picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Chart {
    /// Its file name.
    pub name: &'static str,
    /// What it shows, in a line.
    pub caption: String,
    /// Itself.
    pub svg: String,
}

const INK: &str = "#1c2430";
const SOFT: &str = "#566273";
const FAINT: &str = "#dfe3e9";
const HIT: &str = "#d7261e";
const NONE: &str = "#1a7f4b";
const OPEN: &str = "#8a6d00";
/// Up to so many times the limit, and its colour: pale to dark, told apart in grey as well.
const HARD: [(f64, &str, &str); 4] = [
    (1.25, "up to 1.25 times the limit", "#fdb863"),
    (1.5, "1.25 to 1.5 times", "#fd8d3c"),
    (2.0, "1.5 to 2 times", "#d7261e"),
    (f64::INFINITY, "twice the limit and more", "#7a0024"),
];

/// Of one panel, pixels.
const LEFT: f64 = 64.0;
const WIDTH: f64 = 620.0;
const HEIGHT: f64 = 240.0;
const PANEL: f64 = HEIGHT + 104.0;

/// Metres or seconds to pixels, from a range that is a little wider than the values.
#[derive(Clone, Copy)]
struct Axis {
    low: f64,
    high: f64,
    from: f64,
    to: f64,
}

impl Axis {
    fn around(values: impl Iterator<Item = f64>, (from, to): (f64, f64)) -> Self {
        let (low, high) = values.fold((f64::MAX, f64::MIN), |(low, high), v| (low.min(v), high.max(v)));
        let (low, high) = if low > high { (0.0, 1.0) } else { (low, high) };
        let room = ((high - low) * 0.05).max(1e-3);
        Self { low: low - room, high: high + room, from, to }
    }

    fn at(&self, value: f64) -> f64 {
        rounded(self.from + (value - self.low) / (self.high - self.low) * (self.to - self.from))
    }

    /// Round numbers within it, some six of them.
    fn ticks(&self) -> Vec<f64> {
        let wanted = (self.high - self.low) / 6.0;
        let power = libm::pow(10.0, libm::floor(libm::log10(wanted)));
        let step = [1.0, 2.0, 5.0, 10.0].map(|n| n * power).into_iter().find(|step| *step >= wanted).unwrap_or(wanted);
        let first = libm::ceil(self.low / step);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some six")]
        let count = (libm::floor(self.high / step) - first).clamp(0.0, 20.0) as u32;
        (0..=count).map(|n| ((first + f64::from(n)) * step * 1e6).round() / 1e6).collect()
    }
}

fn rounded(value: f64) -> f64 {
    (value * 10.0).round() / 10.0
}

fn text(words: impl Into<String>, (x, y): (f64, f64), size: f64, colour: &str) -> Text {
    Text::new(words.into()).set("x", rounded(x)).set("y", rounded(y)).set("font-size", size).set("fill", colour)
}

fn line((x, y): (f64, f64), (to_x, to_y): (f64, f64), colour: &str) -> Line {
    Line::new()
        .set("x1", rounded(x))
        .set("y1", rounded(y))
        .set("x2", rounded(to_x))
        .set("y2", rounded(to_y))
        .set("stroke", colour)
}

fn dot((x, y): (f64, f64), radius: f64, colour: &str, words: &str) -> Circle {
    Circle::new().set("cx", x).set("cy", y).set("r", radius).set("fill", colour).add(Title::new(words))
}

fn colour_of(ratio: f64) -> &'static str {
    HARD.iter().find(|(up_to, ..)| ratio < *up_to).map_or("#7a0024", |(_, _, colour)| colour)
}

fn document(height: f64, name: &str) -> Document {
    let width = LEFT + WIDTH + 24.0;
    Document::new()
        .set("viewBox", (0, 0, width, rounded(height)))
        .set("width", width)
        .set("height", rounded(height))
        .set("font-family", "system-ui, sans-serif")
        .set("role", "img")
        .add(Title::new(name))
        .add(Rectangle::new().set("width", "100%").set("height", "100%").set("fill", "#ffffff"))
}

/// Axes with numbers, and what they are of.
fn frame(mut group: Group, (x, y): (&Axis, &Axis), across: &str, up: &str) -> Group {
    for value in x.ticks() {
        let at = x.at(value);
        group = group.add(line((at, y.from), (at, y.to), FAINT));
        group = group.add(text(format!("{value}"), (at, y.from + 17.0), 12.0, SOFT).set("text-anchor", "middle"));
    }
    for value in y.ticks() {
        let at = y.at(value);
        group = group.add(line((x.from, at), (x.to, at), FAINT));
        group = group.add(text(format!("{value}"), (x.from - 8.0, at + 4.0), 12.0, SOFT).set("text-anchor", "end"));
    }
    group = group.add(text(across, (x.to, y.from + 36.0), 12.0, INK).set("text-anchor", "end"));
    group.add(text(up, (x.from - 46.0, y.to - 10.0), 12.0, INK))
}

/// All pictures of which there is something to see.
#[must_use]
pub fn all(survey: &Survey) -> Vec<Chart> {
    [sweep(survey), cycle(survey), floor(survey)].into_iter().flatten().collect()
}

/// Force over limit, over the values of each sweep; a panel for each of its margins.
fn sweep(survey: &Survey) -> Option<Chart> {
    if survey.margins.is_empty() {
        return None;
    }
    let mut drawn = document(PANEL * survey.margins.len() as f64 + 30.0, "How hard over the values of the sweeps");
    for (number, margin) in survey.margins.iter().enumerate() {
        let top = PANEL * number as f64 + 58.0;
        let in_line =
            |cell: &&CellRow| cell.at.contains_key(&margin.sweep) && line_of(cell, &margin.sweep) == margin.with;
        let cells: Vec<&CellRow> = survey.cells.iter().filter(in_line).collect();
        let x = Axis::around(margin.tried.iter().map(|tried| tried.0), (LEFT, LEFT + WIDTH));
        let ratios = cells.iter().filter_map(|cell| cell.worst_ratio).chain([0.0, 1.2]);
        let y = Axis::around(ratios, (top + HEIGHT, top));
        let unit = if margin.unit.is_empty() { String::new() } else { format!(", {}", margin.unit) };
        let mut group = frame(Group::new(), (&x, &y), &format!("{}{unit}", margin.sweep), "worst force / limit");
        group = group.add(text(margin.sentence(), (LEFT - 46.0, top - 32.0), 13.0, INK).set("font-weight", 700));
        if let Some(from) = margin.none_from {
            let at = x.at(from);
            let area =
                Rectangle::new().set("x", at).set("y", top).set("width", rounded(x.to - at)).set("height", HEIGHT);
            group = group.add(area.set("fill", NONE).set("fill-opacity", 0.1));
        }
        group = group.add(line((x.from, y.at(1.0)), (x.to, y.at(1.0)), INK).set("stroke-dasharray", "5 4"));
        let hit: Vec<(f64, f64)> =
            cells.iter().filter_map(|cell| Some((x.at(cell.at[&margin.sweep]), y.at(cell.worst_ratio?)))).collect();
        let path: Vec<String> = hit.iter().map(|(x, y)| format!("{x} {y}")).collect();
        if path.len() > 1 {
            let path = Path::new().set("d", format!("M{}", path.join("L"))).set("fill", "none");
            group = group.add(path.set("stroke", HIT).set("stroke-opacity", 0.4));
        }
        for cell in cells {
            let value = cell.at[&margin.sweep];
            let words = format!(
                "{}: {}, {} of {} scans have hazards",
                cell.cell,
                cell.state.words(),
                cell.hazardous_scans,
                cell.scans
            );
            let at = (x.at(value), y.at(cell.worst_ratio.unwrap_or(0.0)));
            group = group.add(match cell.state {
                State::Hazards => dot(at, 5.0, HIT, &words),
                State::None => dot(at, 6.0, "#ffffff", &words).set("stroke", NONE).set("stroke-width", 3),
                State::Open => dot(at, 6.0, "#ffffff", &words).set("stroke", OPEN).set("stroke-dasharray", "3 2"),
            });
        }
        drawn = drawn.add(group);
    }
    let y = PANEL * survey.margins.len() as f64 + 14.0;
    let key = [
        (0.0, HIT, HIT, "somebody is hit"),
        (140.0, "#ffffff", NONE, "nobody is, every sequence looked at"),
        (390.0, "#ffffff", OPEN, "nobody yet, not complete"),
    ];
    for (right, fill, stroke, words) in key {
        let at = LEFT + right - 30.0;
        drawn = drawn.add(dot((at, y - 4.0), 5.0, fill, words).set("stroke", stroke).set("stroke-width", 2));
        drawn = drawn.add(text(words, (at + 11.0, y), 12.0, INK));
    }
    Some(Chart {
        name: NAMES[0],
        caption: "How hard people are hit, over the values of each sweep".to_owned(),
        svg: drawn.to_string(),
    })
}

/// Colours and what they say.
fn legend(mut drawn: Document, y: f64) -> Document {
    for (number, (_, words, colour)) in HARD.into_iter().enumerate() {
        let at = LEFT + 166.0 * number as f64 - 30.0;
        drawn = drawn.add(dot((at, y - 4.0), 5.0, colour, words));
        drawn = drawn.add(text(words, (at + 10.0, y), 12.0, INK));
    }
    drawn
}

/// The cells, each with its scans.
fn by_cell(survey: &Survey) -> Vec<&[Row]> {
    let all = survey.scans.chunk_by(|a, b| a.cell == b.cell);
    all.filter(|rows| rows.iter().any(|row| !row.outcome.met.is_empty())).take(MOST_PANELS).collect()
}

/// Most cells with a panel of their own.
const MOST_PANELS: usize = 12;

/// When people are hit, after the FMU's start; a panel for each cell with hazards. Nothing if all begin at once.
fn cycle(survey: &Survey) -> Option<Chart> {
    let begins = |row: &Row| row.begins.begins_s;
    let several = survey.scans.iter().any(|row| begins(row).total_cmp(&begins(&survey.scans[0])).is_ne());
    let cells = by_cell(survey);
    if !several || cells.is_empty() {
        return None;
    }
    let mut drawn = document(PANEL * cells.len() as f64 + 30.0, "When people are hit");
    let times = survey.scans.iter().flat_map(|row| row.outcome.met.iter().map(|spot| spot.time_s).chain([begins(row)]));
    let x = Axis::around(times, (LEFT, LEFT + WIDTH));
    for (number, rows) in cells.iter().enumerate() {
        let top = PANEL * number as f64 + 58.0;
        let ratios = rows.iter().flat_map(|row| &row.outcome.met).map(|spot| spot.ratio).chain([1.0]);
        let y = Axis::around(ratios, (top + HEIGHT, top));
        let mut group = frame(Group::new(), (&x, &y), "time after the FMU's start, s", "force / limit");
        group = group.add(text(&rows[0].cell, (LEFT - 46.0, top - 32.0), 13.0, INK).set("font-weight", 700));
        for row in *rows {
            let at = x.at(begins(row));
            let colour = if row.outcome.hazards > 0 { HIT } else { NONE };
            let words = format!("{}: {}", row.begins.words(), row.outcome.state.words());
            let tick = line((at, y.from), (at, y.from - 9.0), colour).set("stroke-width", 3).add(Title::new(words));
            group = group.add(tick);
            for spot in &row.outcome.met {
                let at = (x.at(spot.time_s), y.at(spot.ratio));
                let words =
                    format!("{} in scan {}: {:.2}x after {:.2} s", spot.id, row.number, spot.ratio, spot.time_s);
                group = group.add(dot(at, 3.5, colour_of(spot.ratio), &words).set("fill-opacity", 0.75));
            }
        }
        drawn = drawn.add(group);
    }
    drawn = legend(drawn, PANEL * cells.len() as f64 + 14.0);
    let caption = "When people are hit, by the time after the FMU's start. Ticks below: when people begin".to_owned();
    Some(Chart { name: NAMES[1], caption, svg: drawn.to_string() })
}

/// Where people are hit, and where they begin; a panel for each cell with hazards.
fn floor(survey: &Survey) -> Option<Chart> {
    let cells = by_cell(survey);
    if cells.is_empty() {
        return None;
    }
    let places =
        || survey.scans.iter().flat_map(|row| row.outcome.met.iter().map(|spot| spot.xy_m).chain([row.begins.xy_m]));
    let x = Axis::around(places().map(|p| p[0]), (LEFT, LEFT + WIDTH));
    let deep = Axis::around(places().map(|p| p[1]), (0.0, 1.0));
    // The same scale both ways.
    let height = rounded((deep.high - deep.low) / (x.high - x.low) * WIDTH).clamp(60.0, 900.0);
    let panel = height + PANEL - HEIGHT;
    let mut drawn = document(panel * cells.len() as f64 + 30.0, "Where people are hit");
    for (number, rows) in cells.iter().enumerate() {
        let top = panel * number as f64 + 58.0;
        let y = Axis { from: top + height, to: top, ..deep };
        let mut group = frame(Group::new(), (&x, &y), "x, m", "y, m");
        group = group.add(text(&rows[0].cell, (LEFT - 46.0, top - 32.0), 13.0, INK).set("font-weight", 700));
        for row in *rows {
            let (at, up) = (x.at(row.begins.xy_m[0]), y.at(row.begins.xy_m[1]));
            let colour = if row.outcome.hazards > 0 { HIT } else { NONE };
            let cross = Path::new().set("d", format!("M{} {up}h10M{at} {}v10", at - 5.0, up - 5.0));
            let words = format!("begins {}: {}", row.begins.words(), row.outcome.state.words());
            group = group.add(cross.set("stroke", colour).set("stroke-width", 2).add(Title::new(words)));
        }
        // The worst last, so that it lies on top.
        let mut spots: Vec<_> =
            rows.iter().flat_map(|row| row.outcome.met.iter().map(move |spot| (row, spot))).collect();
        spots.sort_by(|a, b| a.1.ratio.total_cmp(&b.1.ratio));
        for (row, spot) in spots {
            let at = (x.at(spot.xy_m[0]), y.at(spot.xy_m[1]));
            let words = format!("{} in scan {}: {:.2}x", spot.id, row.number, spot.ratio);
            group = group.add(dot(at, 4.5, colour_of(spot.ratio), &words));
        }
        drawn = drawn.add(group);
    }
    drawn = legend(drawn, panel * cells.len() as f64 + 14.0);
    let caption =
        "Where people stand when they are hit. Crosses: where they begin, green without hazards from there".to_owned();
    Some(Chart { name: NAMES[2], caption, svg: drawn.to_string() })
}

#[cfg(test)]
mod tests {
    use super::super::survey::tests::{scanned, survey};
    use super::*;

    #[test]
    fn every_value_is_drawn_where_its_axis_says_and_the_shown_part_begins_at_the_smallest_value() {
        let drawn = all(&survey(&[State::Hazards, State::Open, State::None, State::None]));
        assert_eq!(drawn.iter().map(|picture| picture.name).collect::<Vec<_>>(), ["sweep.svg", "floor.svg"]);
        let svg = &drawn[0].svg;
        // By hand: 0.1 to 0.4 m with a twentieth of room at each side, over 620 pixels from 64 on.
        let at = |value: f64| rounded(64.0 + (value - 0.085) / 0.33 * 620.0);
        for (value, words) in [(0.1, "hazards"), (0.2, "no hazard, not complete"), (0.3, "no hazard, complete")] {
            let title = format!("c-w-{value}: {words}");
            let circle = svg.split("<circle").find(|part| part.contains(&title)).unwrap();
            assert!(circle.contains(&format!("cx=\"{}\"", at(value))), "{circle}");
        }
        assert!(svg.contains(&format!("width=\"{}\" x=\"{}\"", rounded(684.0 - at(0.3)), at(0.3))), "{svg}");
        assert!(!svg.contains("NaN") && !svg.contains("inf"));
    }

    #[test]
    fn the_cycle_is_drawn_where_people_begin_at_several_times() {
        let rows = [(1, State::Hazards), (2, State::None)].map(|(b, state)| scanned(0.1, b, state, 1.7));
        let drawn = all(&Survey::new("n", "t", &[], rows.to_vec()));
        assert_eq!(drawn.iter().map(|picture| picture.name).collect::<Vec<_>>(), ["cycle.svg", "floor.svg"]);
        assert!(drawn[0].svg.contains("H-1 in scan 1: 1.70x after 1.00 s"));
        assert!(all(&survey(&[State::None])).is_empty(), "nothing to see");
    }

    #[test]
    fn ticks_are_round_and_within() {
        let axis = Axis { low: 0.13, high: 1.02, from: 0.0, to: 1.0 };
        assert_eq!(axis.ticks(), [0.2, 0.4, 0.6, 0.8, 1.0]);
        let axis = Axis { low: -3.0, high: 3.0, from: 0.0, to: 1.0 };
        assert_eq!(axis.ticks(), [-3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0]);
    }
}
