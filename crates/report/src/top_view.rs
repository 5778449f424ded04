//! A hazard seen from above, as SVG: obstacles, sensor zones, the robot at the contact, the person's way there.

use svg::Document;
use svg::node::element::{Circle, Group, Line, Polygon, Polyline, Rectangle, Text, Title};

/// Pixels per metre.
const SCALE: f64 = 160.0;
/// Floor on which nobody is seen.
const UNSEEN: &str = "#7cc47c";
/// Most starts that have their names beside them.
const NAMED: usize = 20;
/// Free margin around what is drawn, m.
const MARGIN: f64 = 0.35;

/// A point on the floor plan, m.
pub type Point = [f64; 2];

/// What is drawn, all in metres on the floor plan.
#[derive(Clone, Debug, Default)]
pub struct Scene {
    /// Line at the top.
    pub title: String,
    /// Obstacle outlines with names and the height of their top, m.
    pub obstacles: Vec<(String, Vec<Point>, f64)>,
    /// Sensor zones with names.
    pub zones: Vec<(String, Vec<Point>)>,
    /// Floor on which people may be whom no sensor has seen, as rectangles: low x and y, high x and y.
    pub unseen: Vec<[f64; 4]>,
    /// Where the person may come to.
    pub reachable: Vec<Point>,
    /// The robot's shapes, for some instants, the last being the contact.
    pub robot: Vec<Vec<LinkFootprint>>,
    /// The person's way, one point a step.
    pub path: Vec<Point>,
    /// Where else the person may start.
    pub other_starts: Vec<Point>,
    /// Body outline at the contact: capsules.
    pub body: Vec<(Point, Point, f64)>,
    /// Shoulder, elbow, wrist of the touching arm.
    pub arm: Vec<Point>,
    /// Contact point.
    pub contact: Option<Point>,
}

/// A part of a robot from above.
#[derive(Clone, Debug, PartialEq)]
pub enum LinkFootprint {
    /// A capsule: the ends of its core, and its radius.
    Capsule(Point, Point, f64),
    /// A convex outline.
    Outline(Vec<Point>),
}

impl LinkFootprint {
    /// Points that the view has to hold.
    fn ends(&self) -> Vec<Point> {
        match self {
            Self::Capsule(a, b, _) => vec![*a, *b],
            Self::Outline(points) => points.clone(),
        }
    }
}

struct View {
    min: Point,
    height: f64,
}

impl View {
    /// World metres to picture pixels: x right, y up.
    fn at(&self, p: Point) -> (f64, f64) {
        let round = |v: f64| (v * 10.0).round() / 10.0;
        (round((p[0] - self.min[0]) * SCALE), round(self.height - (p[1] - self.min[1]) * SCALE))
    }

    fn points(&self, all: &[Point]) -> String {
        all.iter().map(|p| self.at(*p)).map(|(x, y)| format!("{x},{y}")).collect::<Vec<_>>().join(" ")
    }

    fn stroke(&self, a: Point, b: Point, radius: f64, colour: &str, opacity: f64) -> Line {
        let ((x1, y1), (x2, y2)) = (self.at(a), self.at(b));
        Line::new()
            .set("x1", x1)
            .set("y1", y1)
            // A zero-length line draws no round cap everywhere; a hair's breadth does.
            .set("x2", if (x1, y1) == (x2, y2) { x2 + 0.1 } else { x2 })
            .set("y2", y2)
            .set("stroke", colour)
            .set("stroke-opacity", opacity)
            .set("stroke-linecap", "round")
            .set("stroke-width", (radius * 2.0 * SCALE).max(1.0))
    }

    fn label(&self, p: Point, text: &str, colour: &str, size: f64) -> Text {
        let (x, y) = self.at(p);
        Text::new(text).set("x", x).set("y", y).set("fill", colour).set("font-size", size)
    }
}

/// Draws the scene.
#[must_use]
pub fn render(scene: &Scene) -> String {
    let everything = || {
        let obstacles = scene.obstacles.iter().flat_map(|(_, p, _)| p.iter().copied());
        let zones = scene.zones.iter().flat_map(|(_, p)| p.iter().copied());
        let robot = scene.robot.iter().flatten().flat_map(LinkFootprint::ends);
        obstacles
            .chain(zones)
            .chain(robot)
            .chain(scene.reachable.iter().copied())
            .chain(scene.path.iter().chain(&scene.other_starts).copied())
            .chain(scene.contact)
    };
    let bound = |axis: usize, pick: fn(f64, f64) -> f64, start: f64| everything().map(|p| p[axis]).fold(start, pick);
    let min = [bound(0, f64::min, f64::MAX) - MARGIN, bound(1, f64::min, f64::MAX) - MARGIN];
    let max = [bound(0, f64::max, f64::MIN) + MARGIN, bound(1, f64::max, f64::MIN) + MARGIN];
    let (width, height) = ((max[0] - min[0]) * SCALE, (max[1] - min[1]) * SCALE);
    let view = View { min, height };
    let mut document = Document::new()
        .set("viewBox", (0, -40, width.ceil(), (height + 40.0).ceil()))
        .set("width", width.ceil())
        .set("height", (height + 40.0).ceil())
        .set("font-family", "sans-serif")
        .add(Rectangle::new().set("y", -40).set("width", "100%").set("height", "100%").set("fill", "#ffffff"))
        .add(Text::new(scene.title.as_str()).set("x", 10).set("y", -14).set("font-size", 17).set("fill", "#222222"));
    let dots = scene.reachable.iter().map(|p| {
        let (x, y) = view.at(*p);
        Circle::new().set("cx", x).set("cy", y).set("r", 14).set("fill", "#d6ebfa")
    });
    document = document.add(dots.fold(Group::new(), Group::add));
    let unseen = scene.unseen.iter().map(|[left, low, right, high]| {
        // What is seen of it.
        let part = |a: f64, b: f64, most: f64| (a.clamp(0.0, most), b.clamp(0.0, most));
        let ((x, y), (to_x, to_y)) = (view.at([*left, *high]), view.at([*right, *low]));
        let ((x, to_x), (y, to_y)) = (part(x, to_x, width), part(y, to_y, height));
        Rectangle::new().set("x", x).set("y", y).set("width", to_x - x).set("height", to_y - y)
    });
    if !scene.unseen.is_empty() {
        let title = Title::new("floor on which people can be whom no sensor has seen");
        let floor = Group::new().set("fill", UNSEEN).set("fill-opacity", 0.35).set("shape-rendering", "crispEdges");
        document = document.add(unseen.fold(floor.add(title), Group::add));
    }
    for (name, polygon) in &scene.zones {
        document = document.add(
            Polygon::new()
                .set("points", view.points(polygon))
                .set("fill", "#f2c230")
                .set("fill-opacity", 0.25)
                .set("stroke", "#b38600")
                .set("stroke-dasharray", "6 4")
                .add(Title::new(name.as_str())),
        );
    }
    let mut obstacles: Vec<_> = scene.obstacles.iter().collect();
    obstacles.sort_by(|a, b| a.2.total_cmp(&b.2));
    for (name, polygon, top) in obstacles {
        let shade = if *top > 1.4 { "#4a5568" } else { "#a9b4c2" };
        document = document.add(
            Polygon::new()
                .set("points", view.points(polygon))
                .set("fill", shade)
                .set("fill-opacity", 0.8)
                .add(Title::new(format!("{name}, top at {top:.2} m"))),
        );
    }
    let last = scene.robot.len().saturating_sub(1);
    for (i, frame) in scene.robot.iter().enumerate() {
        let opacity = if i == last { 0.85 } else { 0.08 };
        let draw = |group: Group, part: &LinkFootprint| match part {
            LinkFootprint::Capsule(a, b, r) => group.add(view.stroke(*a, *b, *r, "#dd6b20", opacity)),
            LinkFootprint::Outline(points) => group.add(
                Polygon::new().set("points", view.points(points)).set("fill", "#dd6b20").set("fill-opacity", opacity),
            ),
        };
        document = document.add(frame.iter().fold(Group::new(), draw));
    }
    let way = Polyline::new()
        .set("points", view.points(&scene.path))
        .set("fill", "none")
        .set("stroke", "#2b6cb0")
        .set("stroke-width", 3)
        .set("stroke-dasharray", "2 5")
        .set("stroke-linecap", "round");
    document = document.add(way);
    for (number, &start) in (1..).zip(scene.path.first().into_iter().chain(&scene.other_starts)) {
        let (x, y) = view.at(start);
        let name = if number == 1 { "start".to_owned() } else { format!("start {number}") };
        // Many have no room for their numbers.
        let many = scene.other_starts.len() > NAMED;
        let dot = Circle::new().set("cx", x).set("cy", y).set("fill", "#2b6cb0").set("r", if many { 3 } else { 6 });
        document = document.add(dot.add(Title::new(name.as_str())));
        if !many {
            document = document.add(view.label([start[0] + 0.07, start[1] - 0.03], &name, "#2b6cb0", 14.0));
        }
    }
    let body = scene.body.iter().map(|(a, b, r)| view.stroke(*a, *b, *r, "#2b6cb0", 0.35));
    document = document.add(body.fold(Group::new(), Group::add));
    for pair in scene.arm.windows(2) {
        document = document.add(view.stroke(pair[0], pair[1], 0.05, "#1a4e8a", 0.9));
    }
    if let Some(contact) = scene.contact {
        let (x, y) = view.at(contact);
        let ring = Circle::new().set("cx", x).set("cy", y).set("r", 9).set("fill", "none");
        document = document.add(ring.set("stroke", "#c53030").set("stroke-width", 4)).add(view.label(
            [contact[0] + 0.09, contact[1] + 0.05],
            "contact",
            "#c53030",
            15.0,
        ));
    }
    if !scene.unseen.is_empty() {
        let told = "green: people can be here whom no sensor has seen; --from anywhere lets them begin here";
        document = document
            .add(Text::new(told).set("x", 10).set("y", height - 6.0).set("font-size", 13).set("fill", "#2f6b3c"));
    }
    // One metre, for the eye.
    let origin = [min[0] + 0.15, min[1] + 0.12];
    document = document.add(view.stroke(origin, [origin[0] + 1.0, origin[1]], 0.008, "#222222", 1.0)).add(view.label(
        [origin[0] + 0.42, origin[1] + 0.04],
        "1 m",
        "#222222",
        13.0,
    ));
    document.to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_escaped_and_y_points_up() {
        let scene = Scene {
            title: "a < b".into(),
            path: vec![[0.0, 0.0], [0.0, 1.0]],
            contact: Some([0.5, 1.0]),
            ..Scene::default()
        };
        let text = render(&scene);
        assert!(text.contains("a &lt; b"), "{text}");
        let view = View { min: [0.0, 0.0], height: 320.0 };
        assert!(view.at([0.0, 2.0]).1 < view.at([0.0, 1.0]).1);
    }
}
