//! What robots do while nobody is detected that nobody can mean: angles in another unit, robots through obstacles and the floor, robots that
//! nobody reaches or that stand still, zones that no walk gets to.
//!
//! Each is one sentence with what was seen and the likely cause, a warning that stays with the result.

mod angles;

use self::angles::Turned;
use crate::cell::Workcell;
use crate::cell::binding::MotionBinding;
use crate::fmi::number;
use crate::geometry::polygon::{apart, convex_outline};
use crate::geometry::segment_cuboid::segment_hits_cuboid;
use crate::geometry::{Cuboid, Solid, Vec3};
use crate::human::action::ACTION_S;
use crate::scan::prepare::Prepared;
use crate::sim::motion::Comparison;
use crate::sim::robot::RobotFrame;
use crate::standards::iso_13855::WALKING_SPEED_M_S;

/// So many instants of a run are looked at, at most.
const INSTANTS: usize = 250;
/// Feet are no farther from the middle of the body, m.
const BODY_M: f64 = 0.5;
/// A link that moves by less is mounted on something, m.
const MOVES_M: f64 = 0.05;
/// Part of the way from the middle of a link to a corner that is well inside it.
const INSIDE: f64 = 0.7;
/// So many triangles of a surface are looked at, at most.
const TRIANGLES: usize = 2000;
/// What a link may be in an obstacle, whose shape is told roughly, m.
const ROUGHLY_M: f64 = 0.02;
/// What a link may be in the floor, m.
const IN_FLOOR_M: f64 = 0.05;
/// A zone is beside a robot that is no farther away, and elsewhere from a distance on, m.
const BESIDE_M: f64 = 0.5;
const ELSEWHERE_M: f64 = 2.0;

/// What is seen at an instant.
struct Instant {
    time_s: f64,
    frame: RobotFrame,
}

/// A run with nobody detected.
struct IdleRun<'a> {
    prepared: &'a Prepared,
    instants: Vec<Instant>,
}

/// What is odd about a run with nobody detected, given by its outputs; whether robots stand still is told of long runs.
pub(super) fn odd(prepared: &Prepared, rows: &[f64], is_long: bool) -> Vec<String> {
    let seen = IdleRun::new(prepared, rows);
    let mut told = seen.angles();
    told.extend(seen.through_obstacles());
    told.extend(seen.through_the_floor());
    told.extend(seen.out_of_reach());
    told.extend(seen.zones());
    if is_long {
        told.extend(seen.still());
    }
    told
}

impl<'a> IdleRun<'a> {
    fn new(prepared: &'a Prepared, rows: &[f64]) -> Self {
        let (cell, binding) = (&prepared.cell, &prepared.binding);
        let width = binding.outputs.len();
        let unsettled = Comparison::new(cell, binding).unsettled();
        let every = (rows.len() / width.max(1)).div_ceil(INSTANTS).max(1);
        let instants = rows.chunks(width.max(1)).enumerate().skip(unsettled).step_by(every);
        #[expect(clippy::cast_precision_loss, reason = "thousands of steps")]
        let instant = |(step, row): (usize, &[f64])| Instant {
            time_s: step as f64 * cell.step_s,
            frame: RobotFrame::new(cell, binding, &binding.rows(row, None, cell.step_s)),
        };
        Self { prepared, instants: instants.map(instant).collect() }
    }

    fn cell(&self) -> &Workcell {
        &self.prepared.cell
    }

    /// The links of a robot.
    fn links(&self, robot: usize) -> impl Iterator<Item = usize> + '_ {
        let links = self.cell().links.iter().enumerate();
        links.filter(move |(_, link)| link.robot == robot).map(|(number, _)| number)
    }

    /// How far a link gets from where it is at first, at most, m.
    fn moves_m(&self, link: usize) -> f64 {
        let Some(first) = self.instants.first() else { return 0.0 };
        let of = |instant: &Instant| instant.frame.links[link].moved_from(&first.frame.links[link]);
        self.instants.iter().map(of).fold(0.0, f64::max)
    }

    /// Joints whose angles are beyond their URDF's limits, or fit a robot in another unit only.
    fn angles(&self) -> Vec<String> {
        let mut told = Vec::new();
        for (number, (robot, bound)) in self.cell().robots.iter().zip(&self.prepared.binding.robots).enumerate() {
            let (MotionBinding::Joints { positions, .. }, Some(kinematics)) = (&bound.motion, &robot.kinematics) else {
                continue;
            };
            let joints = self.cell().file().robots[number].get_ref();
            let all: Vec<Turned> = positions
                .iter()
                .enumerate()
                .filter_map(|(joint, position)| {
                    let name = joints.joints.get(joint)?.name.get_ref();
                    Turned::new(name, position, (joint, kinematics), &self.instants)
                })
                .collect();
            told.extend(angles::odd(&robot.name, &all));
        }
        told
    }

    /// Links that pass through obstacles which stand where they are, each robot once for each obstacle.
    fn through_obstacles(&self) -> Vec<String> {
        let cell = self.cell();
        let mut told = Vec::new();
        for obstacle in cell.obstacles.iter().filter(|obstacle| obstacle.follows.is_none()) {
            let solid = within(&obstacle.cuboid);
            for robot in 0..cell.robots.len() {
                let through = self.links(robot).filter(|link| self.moves_m(*link) > MOVES_M).find_map(|link| {
                    let is_in = |instant: &&Instant| is_through(&instant.frame.links[link], &solid);
                    let first = self.instants.iter().find(is_in)?;
                    // What it is in all the time it stands on.
                    self.instants.iter().any(|instant| !is_in(&instant)).then_some((link, first.time_s))
                });
                told.extend(through.map(|(link, time_s)| {
                    format!(
                        "`{}` passes through obstacle `{}` at {time_s:.2} s: where one of the two is, or how large it is, is not as in \
                         the cell, unless the robot reaches into it",
                        cell.links[link].name, obstacle.name
                    )
                }));
            }
        }
        told
    }

    /// Robots that pass through the floor.
    fn through_the_floor(&self) -> Vec<String> {
        let cell = self.cell();
        let deepest = |robot: usize| {
            let moving = self.links(robot).filter(|link| self.moves_m(*link) > MOVES_M);
            let at = moving.flat_map(|link| {
                self.instants.iter().map(move |instant| (lowest_m(&instant.frame.links[link]), link, instant.time_s))
            });
            at.min_by(|a, b| a.0.total_cmp(&b.0)).filter(|(low_m, ..)| *low_m < -IN_FLOOR_M)
        };
        let told = |(low_m, link, time_s): (f64, usize, f64)| {
            format!(
                "`{}` is {:.2} m below the floor, which is at a height of 0, at {time_s:.2} s: look at the height of the robot's base, at \
                 which axis of its frames points upwards, and at the signs of its joints",
                cell.links[link].name, -low_m
            )
        };
        (0..cell.robots.len()).filter_map(deepest).map(told).collect()
    }

    /// Nothing of anybody is farther from the point 1 m above where they stand, m: of either person, in any posture, with what is held.
    fn reach_m(&self) -> f64 {
        let cell = self.cell();
        let second = cell.of_second();
        let reach = |cell: &Workcell| cell.body.reach_from_one_metre(cell.arm().reach(), cell.repertoire.low());
        second.as_ref().map_or(0.0, reach).max(reach(cell))
    }

    /// Robots that nobody reaches who stands where people may be.
    fn out_of_reach(&self) -> Vec<String> {
        let (cell, reach_m) = (self.cell(), self.reach_m());
        let mut told = Vec::new();
        for (number, robot) in cell.robots.iter().enumerate() {
            let of = |instant: &Instant| {
                self.links(number).map(|link| instant.frame.links[link].bounds().0.z).fold(f64::INFINITY, f64::min)
            };
            let low_m = self.instants.iter().map(of).fold(f64::INFINITY, f64::min);
            if low_m.is_finite() && low_m > 1.0 + reach_m {
                told.push(format!(
                    "robot `{}` is never lower than {low_m:.2} m while nobody is detected, where nobody on the floor reaches it: look at \
                     the height and the unit of its base",
                    robot.name
                ));
                continue;
            }
            let Some(floor) = cell.floor.as_deref() else { continue };
            let away_m = self.swept(number).map_or(0.0, |swept| apart(floor, &swept));
            if away_m > reach_m {
                told.push(format!(
                    "robot `{}` is never nearer than {away_m:.2} m to the floor that people may be on (human.floor_m), where nobody \
                     reaches it: look at that, and at where its base is",
                    robot.name
                ));
            }
        }
        told
    }

    /// What a robot is over in the run: a convex outline on the floor plan that holds all of it.
    fn swept(&self, robot: usize) -> Option<Vec<[f64; 2]>> {
        let corners = |instant: &Instant| -> Vec<[f64; 2]> {
            let of = |link: usize| {
                let (low, high) = instant.frame.links[link].bounds();
                [[low.x, low.y], [low.x, high.y], [high.x, low.y], [high.x, high.y]]
            };
            self.links(robot).flat_map(of).collect()
        };
        let outline = convex_outline(self.instants.iter().flat_map(corners).collect());
        (!outline.is_empty()).then_some(outline)
    }

    /// Zones in which nobody is ever, and those that are elsewhere than any robot and would not be with x and y exchanged.
    fn zones(&self) -> Vec<String> {
        let cell = self.cell();
        let swept: Vec<_> = (0..cell.robots.len()).filter_map(|robot| self.swept(robot)).collect();
        let walk_m = WALKING_SPEED_M_S * ACTION_S * f64::from(cell.search.actions) + BODY_M;
        let mut told = Vec::new();
        for sensor in &cell.sensors {
            let Some(polygon) = sensor.zone.stepped_on() else { continue };
            let name = &sensor.name;
            if let Some(floor) = cell.floor.as_deref().filter(|floor| apart(floor, polygon) > BODY_M) {
                let away = apart(floor, polygon);
                told.push(format!(
                    "nobody is ever in the zone of `{name}`: it is {away:.2} m from the floor that people may be on (human.floor_m)"
                ));
                continue;
            }
            let from =
                |polygon: &[[f64; 2]]| swept.iter().map(|swept| apart(swept, polygon)).fold(f64::INFINITY, f64::min);
            let exchanged: Vec<[f64; 2]> = polygon.iter().map(|[x, y]| [*y, *x]).collect();
            let away = from(polygon);
            if away.is_finite() && away > ELSEWHERE_M && from(&exchanged) < BESIDE_M {
                told.push(format!(
                    "the zone of `{name}` is {away:.2} m from where any robot moves, and beside one with x and y exchanged: is it written \
                     as [y, x]?"
                ));
                continue;
            }
            let starts = cell.beginnings.iter().map(|beginning| apart(&[beginning.start.xy_m()], polygon));
            let nearest = starts.fold(f64::INFINITY, f64::min);
            if nearest.is_finite() && nearest > walk_m {
                told.push(format!(
                    "no walk of {} actions gets to the zone of `{name}`, which is {nearest:.2} m from the nearest start: from the starts \
                     it reports nobody. Start nearer, or look from anywhere",
                    cell.search.actions
                ));
            }
        }
        told
    }

    /// Robots that stand still all the time.
    fn still(&self) -> Vec<String> {
        let cell = self.cell();
        let moves = |robot: usize| self.links(robot).any(|link| self.moves_m(link) > 1e-3);
        let still: Vec<usize> = (0..cell.robots.len()).filter(|robot| !moves(*robot)).collect();
        // Of a cell in which nothing moves it is told once.
        let Some(last) = self.instants.last().filter(|_| still.len() < cell.robots.len()) else { return Vec::new() };
        let told = |robot: usize| {
            format!(
                "robot `{}` stands still for {} s while nobody is detected: are its variables the right ones, and all [inputs] as they \
                 should be?",
                cell.robots[robot].name,
                number((last.time_s * 100.0).round() / 100.0)
            )
        };
        still.into_iter().map(told).collect()
    }
}

/// What is well inside an obstacle.
fn within(cuboid: &Cuboid) -> Cuboid {
    let less = |half: f64| half - ROUGHLY_M.min(0.8 * half);
    Cuboid { half: Vec3::new(less(cuboid.half.x), less(cuboid.half.y), less(cuboid.half.z)), ..*cuboid }
}

/// Segments well inside a link: the axis of a capsule, from the middle of another shape to its outermost corners; edges of a surface.
fn spokes(link: &Solid) -> Vec<[Vec3; 2]> {
    match link {
        Solid::Capsule(capsule) => vec![[capsule.a, capsule.b]],
        Solid::Hull(hull) => {
            let middle = link.bounding_sphere().0;
            directions().map(|along| [middle, middle.lerp(hull.outermost(along), INSIDE)]).collect()
        }
        Solid::Mesh(mesh) => {
            let triangles = mesh.surface().triangles();
            let every = triangles.triangles.len().div_ceil(TRIANGLES).max(1);
            let corner = |at: u32| triangles.points.get(at as usize).map_or(Vec3::ZERO, |point| mesh.pose() * *point);
            let edges = |[a, b, c]: &[u32; 3]| [[*a, *b], [*b, *c], [*c, *a]].map(|edge| edge.map(corner));
            triangles.triangles.iter().step_by(every).flat_map(edges).collect()
        }
    }
}

/// Along the axes and between them.
fn directions() -> impl Iterator<Item = Vec3> {
    const ALONG: [f64; 3] = [-1.0, 0.0, 1.0];
    let all = ALONG.into_iter().flat_map(|x| ALONG.into_iter().flat_map(move |y| ALONG.map(|z| Vec3::new(x, y, z))));
    all.filter(|along| *along != Vec3::ZERO)
}

/// Whether the inside of a link is in a box.
fn is_through(link: &Solid, solid: &Cuboid) -> bool {
    let (middle, radius) = link.bounding_sphere();
    (middle - solid.centre).length() <= radius + solid.half.length()
        && spokes(link).into_iter().any(|[a, b]| segment_hits_cuboid(a, b, solid))
}

/// The lowest point of a link, m; of a capsule, which stands for something thinner, that of its axis.
fn lowest_m(link: &Solid) -> f64 {
    match link {
        Solid::Capsule(capsule) => capsule.a.z.min(capsule.b.z),
        Solid::Hull(hull) => -hull.reach_along(-Vec3::Z),
        Solid::Mesh(mesh) => {
            let corners = mesh.surface().triangles().points.iter().map(|point| (mesh.pose() * *point).z);
            corners.fold(f64::INFINITY, f64::min)
        }
    }
}
