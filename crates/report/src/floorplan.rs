//! `floor.svg`: the map of a whole floor to hang on the wall. Where somebody is hit who comes from anywhere and how hard, what is not
//! known, where people can be, with obstacles, sensors and robots, a legend and the worst ways to be hit.

use svg::Document;
use svg::node::element::{Circle, ClipPath, Definitions, Group, Line, Path, Pattern, Polygon, Rectangle, Text, Title};

use super::floor_map::FloorMap;
use super::top_view::Point;
use crate::hazard::Class;
use fmi_hazard_record::reachability::HarmfulPose;

/// The longer side of the map, and the widest scale, pixels and pixels per metre.
const MAP: f64 = 860.0;
const MOST_SCALE: f64 = 260.0;
/// Room for the numbers of the axes, for what is said above the map, and for the legend beside it.
const LEFT: f64 = 58.0;
const TOP: f64 = 116.0;
const LEGEND: f64 = 400.0;
/// Letters in a line of the legend, and in one above the map for each pixel.
const LETTERS: usize = 52;
const LETTERS_PER_PIXEL: f64 = 0.108;
/// Around what is drawn, m; and so far beyond of what may be drawn.
const MARGIN_M: f64 = 0.35;
const AROUND_M: f64 = 1.0;
/// Places that get a number.
const NUMBERED: usize = 6;

const INK: &str = "#1c2430";
const SOFT: &str = "#566273";
const NOWHERE: &str = "#e2e5ea";
const WATCHED: &str = "#d9e6fb";
const UNLOOKED: &str = "url(#unlooked)";
const OBSTACLE: &str = "#5b6675";
const ZONE: &str = "#2563b8";
/// Up to so many times the limit, in words, and its colour: pale to dark, told apart in grey as well.
const HARD: [(f64, &str, &str); 5] = [
    (1.0, "head or throat touched: no contact is allowed", "#fff3b8"),
    (1.25, "hit with up to 1.25 times the limit", "#fed06b"),
    (1.5, "1.25 to 1.5 times", "#fd8d3c"),
    (2.0, "1.5 to 2 times", "#d7261e"),
    (f64::INFINITY, "twice the limit and more", "#7a0024"),
];

/// What stands around, m.
#[derive(Clone, Debug, Default)]
pub struct Plan {
    /// The cell's name.
    pub name: String,
    /// Where the picture comes from.
    pub source: String,
    /// Outlines of obstacles with names.
    pub obstacles: Vec<(String, Vec<Point>)>,
    /// Zones of sensors with names.
    pub zones: Vec<(String, Vec<Point>)>,
    /// Bases of robots with names.
    pub robots: Vec<(String, Point)>,
}

/// Metres to pixels.
struct View {
    low: Point,
    high: Point,
    scale: f64,
}

fn rounded(value: f64) -> f64 {
    (value * 10.0).round() / 10.0
}

impl View {
    fn new(whole: &FloorMap<'_>, plan: &Plan) -> Self {
        let corners = |all: &[[f64; 4]]| all.iter().flat_map(|[a, b, c, d]| [[*a, *b], [*c, *d]]).collect::<Vec<_>>();
        let mut needed = corners(&whole.ground.swept_m);
        needed.extend(whole.floor.iter().map(|cell| cell.xy_m).chain(whole.open_m.iter().copied()));
        needed.extend(plan.robots.iter().map(|(_, base)| *base));
        needed.extend(whole.places.iter().take(NUMBERED).flat_map(|place| [place.xy_m, place.start_m]));
        let mut all = needed.clone();
        all.extend(plan.obstacles.iter().chain(&plan.zones).flat_map(|(_, polygon)| polygon.iter().copied()));
        if needed.is_empty() {
            needed.push([0.0, 0.0]);
        }
        let least = |of: &[Point], axis: usize| of.iter().map(|p| p[axis]).fold(f64::MAX, f64::min);
        let most = |of: &[Point], axis: usize| of.iter().map(|p| p[axis]).fold(f64::MIN, f64::max);
        let low = [0, 1]
            .map(|axis| least(&all, axis).clamp(least(&needed, axis) - AROUND_M, least(&needed, axis)) - MARGIN_M);
        let high =
            [0, 1].map(|axis| most(&all, axis).clamp(most(&needed, axis), most(&needed, axis) + AROUND_M) + MARGIN_M);
        let scale = (MAP / (high[0] - low[0]).max(high[1] - low[1])).min(MOST_SCALE);
        Self { low, high, scale }
    }

    fn width(&self) -> f64 {
        (self.high[0] - self.low[0]) * self.scale
    }

    fn height(&self) -> f64 {
        (self.high[1] - self.low[1]) * self.scale
    }

    fn at(&self, [x, y]: Point) -> (f64, f64) {
        (rounded((x - self.low[0]) * self.scale), rounded((self.high[1] - y) * self.scale))
    }

    fn points(&self, all: &[Point]) -> String {
        all.iter().map(|p| self.at(*p)).map(|(x, y)| format!("{x},{y}")).collect::<Vec<_>>().join(" ")
    }

    /// Rectangles as one path.
    fn boxes(&self, all: &[[f64; 4]]) -> Path {
        let one = |[left, low, right, high]: &[f64; 4]| {
            let ((x, y), (to_x, to_y)) = (self.at([*left, *high]), self.at([*right, *low]));
            format!("M{x} {y}H{to_x}V{to_y}H{x}z")
        };
        Path::new().set("d", all.iter().map(one).collect::<String>())
    }

    fn square(&self, [x, y]: Point, edge: f64) -> Rectangle {
        let (px, py) = self.at([x - 0.5 * edge, y + 0.5 * edge]);
        let size = rounded(edge * self.scale);
        Rectangle::new().set("x", px).set("y", py).set("width", size).set("height", size)
    }

    /// A place for a name: the lower left corner of what of an outline is in the picture, if any is.
    fn corner(&self, polygon: &[Point]) -> Option<Point> {
        let part = [0, 1].map(|axis| {
            let low = polygon.iter().map(|p| p[axis]).fold(f64::MAX, f64::min).max(self.low[axis]);
            let high = polygon.iter().map(|p| p[axis]).fold(f64::MIN, f64::max).min(self.high[axis]);
            (low, high)
        });
        part.iter().all(|(low, high)| low <= high).then(|| part.map(|(low, _)| low))
    }
}

fn text(words: impl Into<String>, (x, y): (f64, f64), size: f64, colour: &str) -> Text {
    Text::new(words.into()).set("x", rounded(x)).set("y", rounded(y)).set("font-size", size).set("fill", colour)
}

/// A text that stays readable over what is below it.
fn name(words: &str, at: (f64, f64), colour: &str) -> Text {
    text(words, at, 14.0, colour)
        .set("stroke", "#ffffff")
        .set("stroke-width", 4)
        .set("stroke-linejoin", "round")
        .set("paint-order", "stroke")
}

fn colour(ratio: f64) -> &'static str {
    HARD.iter().find(|(below, ..)| ratio < *below).map_or(HARD[4].2, |(.., colour)| colour)
}

/// The picture.
#[must_use]
pub fn render(whole: &FloorMap<'_>, plan: &Plan) -> String {
    let view = View::new(whole, plan);
    let (legend, below) = legend(whole, plan, LEFT + view.width() + 36.0);
    let width = (LEFT + view.width() + 36.0 + LEGEND).ceil();
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some hundred letters")]
    let said = textwrap::wrap(&whole.said, (width * LETTERS_PER_PIXEL) as usize);
    let height = (TOP + view.height().max(below) + 72.0).ceil();
    let mut document = Document::new()
        .set("viewBox", (0, 0, width, height))
        .set("width", width)
        .set("height", height)
        .set("font-family", "sans-serif")
        .add(definitions(&view))
        .add(Rectangle::new().set("width", "100%").set("height", "100%").set("fill", "#ffffff"))
        .add(text(format!("{}: the floor", plan.name), (24.0, 36.0), 24.0, INK).set("font-weight", 700));
    for (line, y) in said.iter().zip([62.0, 83.0, 104.0]) {
        document = document.add(text(line.as_ref(), (24.0, y), 16.0, INK));
    }
    document = document
        .add(map(whole, plan, &view).set("transform", format!("translate({LEFT} {TOP})")))
        .add(legend.set("transform", format!("translate(0 {TOP})")))
        .add(text(plan.source.as_str(), (24.0, height - 14.0), 11.0, SOFT));
    document.to_string()
}

fn definitions(view: &View) -> Definitions {
    let stripes = Pattern::new()
        .set("id", "unknown")
        .set("width", 8)
        .set("height", 8)
        .set("patternUnits", "userSpaceOnUse")
        .set("patternTransform", "rotate(45)")
        .add(Rectangle::new().set("width", 8).set("height", 8).set("fill", "#ffffff"))
        .add(Rectangle::new().set("width", 2.4).set("height", 8).set("fill", SOFT));
    // Paler, and the other way, than what was looked at and is not known.
    let unlooked = Pattern::new()
        .set("id", "unlooked")
        .set("width", 10)
        .set("height", 10)
        .set("patternUnits", "userSpaceOnUse")
        .set("patternTransform", "rotate(-45)")
        .add(Rectangle::new().set("width", 10).set("height", 10).set("fill", "#f4f5f7"))
        .add(Rectangle::new().set("width", 1.2).set("height", 10).set("fill", SOFT));
    let frame = Rectangle::new().set("width", rounded(view.width())).set("height", rounded(view.height()));
    Definitions::new().add(stripes).add(unlooked).add(ClipPath::new().set("id", "frame").add(frame))
}

fn map(whole: &FloorMap<'_>, plan: &Plan, view: &View) -> Group {
    let edge = whole.cell_m;
    let frame = Rectangle::new().set("width", rounded(view.width())).set("height", rounded(view.height()));
    let mut inside = Group::new()
        .set("clip-path", "url(#frame)")
        .add(frame.set("fill", if whole.ground.is_empty() { UNLOOKED } else { NOWHERE }))
        .add(view.boxes(&whole.ground.unseen_m).set("fill", "#ffffff"))
        .add(view.boxes(&whole.ground.watched_m).set("fill", WATCHED));
    if !whole.not_looked_at_m.is_empty() {
        inside = inside.add(view.boxes(whole.not_looked_at_m).set("fill", UNLOOKED));
    }
    inside = inside.add(view.boxes(&whole.ground.swept_m).set("fill", SOFT).set("fill-opacity", 0.18));
    let open = Group::new().set("fill", "url(#unknown)").set("stroke", SOFT).set("stroke-width", 0.8);
    inside = inside.add(whole.open_m.iter().fold(open, |open, at| open.add(view.square(*at, edge))));
    let squares = whole.floor.iter().map(|cell| {
        let [x, y] = cell.xy_m;
        let title = format!("{x:.2}, {y:.2} m: up to {:.2}x, first at {:.2} s", cell.ratio, cell.earliest_s);
        let side = if cell.unseen { edge } else { 0.6 * edge };
        view.square([x, y], side).set("fill", colour(cell.ratio)).add(Title::new(title))
    });
    let hits = Group::new().set("stroke", "#ffffff").set("stroke-width", 0.8);
    inside = inside.add(squares.fold(hits, Group::add));
    for (words, polygon) in &plan.zones {
        let area = Polygon::new().set("points", view.points(polygon)).set("fill", "none").set("stroke", ZONE);
        inside =
            inside.add(area.set("stroke-width", 2.5).set("stroke-dasharray", "9 6").add(Title::new(words.as_str())));
        if let Some(corner) = view.corner(polygon) {
            let (x, y) = view.at(corner);
            inside = inside.add(name(words, (x + 6.0, y - 7.0), ZONE));
        }
    }
    for (words, polygon) in &plan.obstacles {
        let shape = Polygon::new().set("points", view.points(polygon)).set("fill", OBSTACLE);
        // Thin panels are seen at any scale.
        let shape = shape.set("stroke", OBSTACLE).set("stroke-width", 2).add(Title::new(words.as_str()));
        inside = inside.add(shape);
    }
    for (words, base) in &plan.robots {
        let (x, y) = view.at(*base);
        let line =
            |dx: f64, dy: f64| Line::new().set("x1", x - dx).set("x2", x + dx).set("y1", y - dy).set("y2", y + dy);
        let mark = Group::new().set("fill", "none").set("stroke", INK).set("stroke-width", 2.5);
        let mark =
            mark.add(Circle::new().set("cx", x).set("cy", y).set("r", 9)).add(line(14.0, 0.0)).add(line(0.0, 14.0));
        inside = inside.add(mark).add(name(words, (x, y - 19.0), INK).set("text-anchor", "middle"));
    }
    let bar = [view.high[0] - 1.2, view.low[1] + 0.12];
    let ((x, y), (to, _)) = (view.at(bar), view.at([bar[0] + 1.0, bar[1]]));
    let line = Path::new().set("d", format!("M{x} {}V{y}H{to}V{}", y - 7.0, y - 7.0));
    inside = inside
        .add(line.set("fill", "none").set("stroke", INK).set("stroke-width", 2))
        .add(name("1 m", (0.5 * (x + to), y - 8.0), INK).set("text-anchor", "middle"));
    axes(view, Group::new().add(inside)).add(marks(whole, view))
}

fn axes(view: &View, mut group: Group) -> Group {
    let (width, height) = (rounded(view.width()), rounded(view.height()));
    let mut path = format!("M0 0V{height}H{width}");
    #[expect(clippy::cast_possible_truncation, reason = "some metres")]
    let whole = |axis: usize| view.low[axis].ceil() as i32..=view.high[axis].floor() as i32;
    for metre in whole(0) {
        let (x, _) = view.at([f64::from(metre), view.low[1]]);
        path += &format!("M{x} {height}v7");
        group = group.add(text(format!("{metre} m"), (x, height + 22.0), 13.0, SOFT).set("text-anchor", "middle"));
    }
    for metre in whole(1) {
        let (_, y) = view.at([view.low[0], f64::from(metre)]);
        path += &format!("M0 {y}h-7");
        group = group.add(text(format!("{metre} m"), (-11.0, y + 4.5), 13.0, SOFT).set("text-anchor", "end"));
    }
    group.add(Path::new().set("d", path).set("fill", "none").set("stroke", INK).set("stroke-width", 2))
}

/// The worst ways to be hit, by number.
fn marks(whole: &FloorMap<'_>, view: &View) -> Group {
    let mut group = Group::new();
    let places: Vec<_> = whole.places.iter().take(NUMBERED).collect();
    // Nothing of one is over another.
    let mut taken: Vec<(f64, f64)> = places.iter().map(|place| view.at(place.xy_m)).collect();
    for (number, place) in (1..).zip(places) {
        let (x, y) = view.at(place.xy_m);
        let around = [34.0, 52.0, 74.0, 100.0].into_iter().flat_map(|far| {
            (0..12).map(move |turn| {
                let (sin, cos) = libm::sincos(f64::from(turn) * std::f64::consts::FRAC_PI_6);
                (rounded(x + far * cos), rounded(y - far * sin))
            })
        });
        let is_free = |(u, v): &(f64, f64)| {
            let inside = *u > 14.0 && *v > 14.0 && *u < view.width() - 14.0 && *v < view.height() - 14.0;
            inside && taken.iter().all(|(s, t)| libm::hypot(u - s, v - t) > 27.0)
        };
        let (u, v) = around.clone().find(is_free).unwrap_or((x, y));
        taken.push((u, v));
        if place.walks_in {
            let (from_x, from_y) = view.at(place.start_m);
            let way = Line::new().set("x1", from_x).set("y1", from_y).set("x2", x).set("y2", y);
            group = group.add(way.set("stroke", INK).set("stroke-width", 2.5).set("stroke-dasharray", "6 4")).add(
                Circle::new().set("cx", from_x).set("cy", from_y).set("r", 5).set("fill", "none").set("stroke", INK),
            );
        }
        let lead = Line::new().set("x1", u).set("y1", v).set("x2", x).set("y2", y).set("stroke", INK);
        let dot = Circle::new().set("cx", x).set("cy", y).set("r", 3.5).set("fill", INK).set("stroke", "#ffffff");
        let disc = Circle::new().set("cx", u).set("cy", v).set("r", 12).set("fill", "#12161b").set("stroke", "#ffffff");
        let digit = text(number.to_string(), (u, v + 5.0), 14.0, "#ffffff").set("text-anchor", "middle");
        group = group
            .add(lead.set("stroke-width", 1.6))
            .add(dot)
            .add(disc.set("stroke-width", 2).add(Title::new(way(place))))
            .add(digit.set("font-weight", 700));
    }
    group
}

/// A way to be hit, in words.
fn way(place: &HarmfulPose) -> String {
    // No place is at minus zero.
    let hundredths = |at: Point| at.map(|value| (value * 100.0).round() / 100.0 + 0.0);
    let [x, y] = hundredths(place.xy_m);
    let when = place.time_s.map_or(String::new(), |time_s| format!(" after {time_s:.2} s"));
    let region = place.body_region.words();
    let how = if place.walks_in {
        let [from_x, from_y] = hundredths(place.start_m);
        format!("walks from {from_x:.2}, {from_y:.2} m to {x:.2}, {y:.2} m")
    } else {
        format!("stands at {x:.2}, {y:.2} m")
    };
    let sure = if place.confirmed { "" } else { "; not confirmed" };
    // Below 1 the ratio would read as harmless.
    let hit = if place.class == Some(Class::HeadContact) {
        format!("No contact allowed: {region} touched by")
    } else {
        format!("{:.2}x: {region} hit by", place.ratio)
    };
    format!("{hit} {}{when}; {how}, {}{sure}", place.robot_link, place.posture)
}

/// What everything means, and the worst ways; how far down it gets.
fn legend(whole: &FloorMap<'_>, plan: &Plan, left: f64) -> (Group, f64) {
    let mut group = Group::new();
    let mut y = 6.0;
    let row = |group: Group, y: &mut f64, box_: Rectangle, words: &str| {
        let box_ = box_.set("x", left).set("y", *y).set("width", 26).set("height", 18);
        *y += 25.0;
        group.add(box_).add(text(words, (left + 36.0, *y - 11.0), 14.0, INK))
    };
    let plain = |colour: &str| Rectangle::new().set("fill", colour).set("stroke", SOFT).set("stroke-width", 0.8);
    for (below, words, colour) in HARD {
        // The lowest only where a square is in it.
        if below > 1.0 || whole.floor.iter().any(|cell| cell.ratio < 1.0) {
            group = row(group, &mut y, plain(colour), words);
        }
    }
    if whole.floor.iter().any(|cell| !cell.unseen) {
        let small = Rectangle::new().set("x", left + 7.0).set("y", y + 3.0).set("width", 12).set("height", 12);
        group = row(group, &mut y, plain("#ffffff"), "small: only who walks in, if in time")
            .add(small.set("fill", HARD[2].2));
    }
    if !whole.open_m.is_empty() {
        group = row(group, &mut y, plain("url(#unknown)"), "not known whether anybody is hit there");
    }
    if whole.looked_at {
        group = row(group, &mut y, plain("#ffffff"), "people come here unseen; no hit found");
        if !whole.ground.watched_m.is_empty() {
            group = row(group, &mut y, plain(WATCHED), "watched by sensors; no hit found");
        }
    } else {
        group = row(group, &mut y, plain(UNLOOKED), "not looked at to the end");
    }
    if !whole.ground.is_empty() {
        group = row(group, &mut y, plain(NOWHERE), "nobody can stand here, or gets here");
    }
    if !whole.ground.swept_m.is_empty() {
        group = row(group, &mut y, plain("#c4c9d0"), "below what the robots sweep");
    }
    if !plan.obstacles.is_empty() {
        group = row(group, &mut y, plain(OBSTACLE), "obstacle");
    }
    if !plan.zones.is_empty() {
        let zone = Rectangle::new().set("fill", "none").set("stroke", ZONE).set("stroke-width", 2.5);
        group = row(group, &mut y, zone.set("stroke-dasharray", "9 6"), "where sensors see");
    }
    let paragraph = |mut group: Group, y: &mut f64, head: &str, words: &str, colour: &str| {
        for (number, line) in textwrap::wrap(words, LETTERS).iter().enumerate() {
            *y += 17.0;
            if number == 0 && !head.is_empty() {
                group = group.add(text(head, (left, *y), 13.0, colour).set("font-weight", 700));
            }
            let from = if head.is_empty() { left } else { left + 20.0 };
            group = group.add(text(line.as_ref(), (from, *y), 13.0, colour));
        }
        *y += 5.0;
        group
    };
    let tried = "Colours tell the worst that was tried in each square; it may be worse.";
    group = paragraph(group, &mut y, "", tried, SOFT);
    if !whole.places.is_empty() {
        y += 24.0;
        group = group.add(text("Worst ways to be hit", (left, y), 15.0, INK).set("font-weight", 700));
        for (number, place) in (1..).zip(whole.places.iter().take(NUMBERED)) {
            group = paragraph(group, &mut y, &number.to_string(), &way(place), INK);
        }
        let more = whole.places.len().saturating_sub(NUMBERED);
        if more > 0 {
            group = paragraph(group, &mut y, "", &format!("And {more} more, less bad or not confirmed."), SOFT);
        }
    }
    for reason in whole.reasons {
        group = paragraph(group, &mut y, "", &format!("Not complete: {reason}."), SOFT);
    }
    (group, y)
}

#[cfg(test)]
mod tests {
    use super::super::floor_map::tests::{squares, whole};
    use super::*;
    use fmi_hazard_record::reachability::Ground;

    #[test]
    fn names_are_escaped_and_every_square_is_drawn_in_its_colour() {
        let floor = squares(&[(true, 0.7), (true, 1.1), (true, 1.3), (false, 1.9), (true, 2.0)]);
        let ground = Ground { unseen_m: vec![[-1.0, -1.0, 1.0, 1.0]], ..Ground::default() };
        let plan = Plan {
            name: "a < b".to_owned(),
            obstacles: vec![("<script>".to_owned(), vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]])],
            ..Plan::default()
        };
        let drawn = render(&whole(&floor, vec![[0.55, 0.05]], &ground), &plan);
        assert!(drawn.contains("a &lt; b: the floor") && !drawn.contains("<script>"), "{drawn}");
        for cell in &floor {
            let [x, y] = cell.xy_m;
            let title = format!("{x:.2}, {y:.2} m: up to {:.2}x, first at 0.40 s", cell.ratio);
            assert_eq!(drawn.matches(&title).count(), 1, "{title}");
        }
        for (_, words, colour) in HARD {
            // Once in the legend and once on the floor; that of small squares is in the legend once more.
            assert!(drawn.matches(colour).count() >= 2, "{colour}");
            assert!(drawn.contains(words), "{words}");
        }
        assert!(drawn.contains("not known whether") && !drawn.contains("where sensors see"));
        assert_eq!(drawn, render(&whole(&floor, vec![[0.55, 0.05]], &ground), &plan));
    }

    /// Where not all was looked at, nothing is drawn as floor without a hit, however large it is; nor where no floor is known.
    #[test]
    fn floor_that_was_not_looked_at_is_not_drawn_as_floor_without_a_hit() {
        let floor = squares(&[(true, 1.1)]);
        let ground = Ground {
            unseen_m: vec![[-10.0, -10.0, 10.0, 9.0]],
            watched_m: vec![[-10.0, 9.0, 10.0, 10.0]],
            ..Ground::default()
        };
        let drawn = |not_looked_at_m: &[[f64; 4]], ground: &Ground| {
            let looked_at = not_looked_at_m.is_empty() && !ground.is_empty();
            render(&FloorMap { not_looked_at_m, looked_at, ..whole(&floor, Vec::new(), ground) }, &Plan::default())
        };
        let whole = drawn(&[], &ground);
        assert!(
            whole.contains("no hit found") && !whole.contains("not looked at") && !whole.contains("=\"url(#unlooked)")
        );
        let short = drawn(&[[-10.0, -10.0, 10.0, 10.0]], &ground);
        // In the legend and on the floor.
        assert!(!short.contains("no hit found") && short.contains("not looked at to the end"), "{short}");
        assert_eq!(short.matches("=\"url(#unlooked)").count(), 2, "{short}");
        let none = drawn(&[], &Ground::default());
        assert!(!none.contains("no hit found") && !none.contains("nobody can stand here"), "{none}");
        assert_eq!(none.matches("=\"url(#unlooked)").count(), 2, "{none}");
    }

    #[test]
    fn an_empty_floor_has_a_picture_too() {
        let ground = Ground::default();
        let drawn = render(&whole(&[], Vec::new(), &ground), &Plan::default());
        assert!(drawn.contains("No place was found") && !drawn.contains("NaN") && !drawn.contains("inf"), "{drawn}");
    }
}
