//! How sensors and robots answer to people who walk about, without looking for contacts; and what a change of these answers
//! says against a change of the cell: the person would start where a sensor sees them, the robot would hardly move, a
//! safeguard would be smaller or slower.

use std::collections::BTreeSet;

use crate::geometry::sampled::surface_points;
use crate::geometry::segment_cuboid::{point_cuboid, segment_cuboid};
use crate::geometry::{Cuboid, Solid, Vec3};
use crate::hazard::STANDSTILL_M_S;
use crate::host::{Hosted, PlantError};
use crate::human::{Action, Repertoire};
use crate::search::Rng;
use crate::sim::Simulation;
use crate::sim::simulation::Instant;

/// What sensors and robots do while a person stands at the start.
#[derive(Clone, Debug)]
pub(super) struct SafeguardResponse {
    /// Where the middles of the robots' links are at the start, m.
    links: Vec<Vec3>,
    /// Whether each sensor ever reports the person who stands there.
    at_start: Vec<bool>,
    /// Highest speed of each robot meanwhile, in the second half, m/s.
    speeds: Vec<f64>,
    /// Obstacles, each with the link that is in it at some time.
    run_into: BTreeSet<(usize, usize)>,
}

/// What parts of a cell are called.
#[derive(Clone, Copy, Debug)]
pub(super) struct Names<'a> {
    /// Sensors.
    pub sensors: &'a [&'a str],
    /// Robots.
    pub robots: &'a [&'a str],
    /// Links.
    pub links: &'a [&'a str],
    /// Obstacles.
    pub obstacles: &'a [&'a str],
}

/// What they answer to walks.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Answers(Vec<WalkResponse>);

/// The answer to one walk: when it is first to be seen, in steps from the start.
#[derive(Clone, Debug, PartialEq)]
struct WalkResponse {
    /// Each sensor reports the person.
    reports: Vec<Option<usize>>,
    /// A robot moves otherwise than if the person had stood still.
    reacts: Option<usize>,
    /// Each robot stands still from then on to the end of the walk, where it would not have if the person had stood still; nothing
    /// if it would have, [`NEVER`] if it moves at the end.
    stands: Vec<Option<usize>>,
}

/// What is said against a change.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Objection {
    /// A safeguard would be smaller or slower.
    Smaller(String),
    /// It would help for a reason that does not count.
    Other(String),
}

/// What a sensor is called that a change adds.
pub(super) const ADDED: &str = "the added sensor";

/// The end of a walk does not see a robot stand.
const NEVER: usize = usize::MAX;

/// Random walks beside those that are known to lead to hazards.
const RANDOM_WALKS: usize = 60;

/// A robot that is left so much of its speed hardly moves.
const HARDLY: f64 = 0.1;

/// A link that is no deeper in an obstacle than this only touches it, m: shapes are about as large as what they stand for.
const TOUCHES_M: f64 = 0.01;

/// No point of a link that is no capsule is farther than this from one that is looked at, m.
const POINTS_M: f64 = 0.02;

/// Links that begin farther off than this begin elsewhere, m.
const ELSEWHERE_M: f64 = 1e-3;

/// Walks that show how a cell answers: those of the known sequences, and random ones.
pub(super) fn probes(known: &[Vec<Action>], actions: usize, repertoire: &Repertoire, seed: u64) -> Vec<Vec<Action>> {
    let mut rng = Rng::new(seed);
    let mut random = || (0..actions).map(|_| repertoire.action(rng.below(repertoire.count()))).collect();
    let mut all: Vec<Vec<Action>> = known.to_vec();
    all.extend((0..RANDOM_WALKS).map(|_| random()));
    all
}

impl SafeguardResponse {
    /// What they do while the person stands for `actions`.
    ///
    /// # Errors
    /// When the FMU fails.
    pub(crate) fn observe(simulation: &mut Simulation<Hosted>, actions: usize) -> Result<Self, PlantError> {
        let rest = simulation.watch(&vec![Action::REST; actions], &[])?.instants;
        let cell = &simulation.world().cell;
        let (sensors, robot_of) = (cell.sensors.len(), cell.links.iter().map(|link| link.robot).collect::<Vec<_>>());
        let mut speeds = vec![0.0_f64; cell.robots.len()];
        for instant in &rest[rest.len() / 2..] {
            for (robot, speed) in robot_of.iter().zip(&instant.frame.speed_bounds) {
                speeds[*robot] = speeds[*robot].max(*speed);
            }
        }
        let mut run_into = BTreeSet::new();
        for (number, obstacle) in cell.obstacles.iter().enumerate() {
            for link in 0..cell.links.len() {
                let there = |instant: &Instant| cell.amid(obstacle, instant.arrangement);
                if rest.iter().any(|i| there(i).is_some_and(|cuboid| is_in(&i.frame.links[link], &cuboid))) {
                    run_into.insert((number, link));
                }
            }
        }
        Ok(Self {
            run_into,
            links: rest[0].frame.links.iter().map(|link| link.bounding_sphere().0).collect(),
            at_start: (0..sensors).map(|sensor| rest.iter().any(|instant| instant.readings[sensor])).collect(),
            speeds,
        })
    }

    /// A sensor that reports whoever stands there after a change, and did not before.
    pub(crate) fn reported_anew(&self, after: &Self) -> Option<usize> {
        // A sensor that the change adds comes last, and reported nobody before.
        let before = self.at_start.iter().copied().chain(std::iter::repeat(false));
        after.at_start.iter().zip(before).position(|(now, before)| *now && !before)
    }

    /// What a change from this to `after` says against it.
    pub(crate) fn objection(&self, after: &Self, is_time: bool, names: Names<'_>) -> Option<Objection> {
        let Names { sensors, robots, links, obstacles } = names;
        let other = |text: String| Some(Objection::Other(text));
        if let Some(sensor) = self.reported_anew(after) {
            let name = sensors.get(sensor).unwrap_or(&ADDED);
            return other(format!("{name} then reports the person at the start already"));
        }
        for (robot, (before, now)) in self.speeds.iter().zip(&after.speeds).enumerate() {
            if *before > STANDSTILL_M_S && *now < HARDLY * before {
                let left = 100.0 * now / before;
                let name = robots[robot];
                return other(format!(
                    "{name} then hardly moves while the person is at the start: {left:.0} % of its speed is left"
                ));
            }
        }
        if let Some((obstacle, link)) = after.run_into.difference(&self.run_into).next() {
            return other(format!("{} then runs into {}", links[*link], obstacles[*obstacle]));
        }
        let moved = |(a, b): (&Vec3, &Vec3)| (*a - *b).length() > ELSEWHERE_M;
        if is_time && self.links.iter().zip(&after.links).any(moved) {
            return other("it only changes where the robot is when the person begins".to_owned());
        }
        None
    }
}

/// Whether a link is in an obstacle, not only at it.
fn is_in(link: &Solid, obstacle: &Cuboid) -> bool {
    let (centre, radius) = link.bounding_sphere();
    if point_cuboid(centre, obstacle).distance > radius - TOUCHES_M {
        return false;
    }
    match link {
        Solid::Capsule(c) => segment_cuboid(c.a, c.b, obstacle).distance < c.radius - TOUCHES_M,
        Solid::Hull(_) | Solid::Mesh(_) => {
            let points = surface_points(link, POINTS_M);
            points.iter().any(|point| point_cuboid(point.at, obstacle).distance < -TOUCHES_M)
        }
    }
}

impl Answers {
    /// The answers to `probes`.
    ///
    /// # Errors
    /// When the FMU fails.
    pub(crate) fn observe(simulation: &mut Simulation<Hosted>, probes: &[Vec<Action>]) -> Result<Self, PlantError> {
        let longest = probes.iter().map(Vec::len).max().unwrap_or(0);
        let rest = simulation.watch(&vec![Action::REST; longest], &[])?.instants;
        let cell = &simulation.world().cell;
        let (sensors, robots) = (cell.sensors.len(), cell.robots.len());
        let robot_of: Vec<usize> = cell.links.iter().map(|link| link.robot).collect();
        let first = |instants: &[Instant], is: &dyn Fn(usize, &Instant) -> bool| {
            instants.iter().enumerate().position(|(i, instant)| is(i, instant))
        };
        let mut walks = Vec::with_capacity(probes.len());
        for probe in probes {
            let instants = simulation.watch(probe, &[])?.instants;
            let reports = (0..sensors).map(|sensor| first(&instants, &|_, instant| instant.readings[sensor])).collect();
            let bits = |instant: &Instant| instant.frame.speed_bounds.iter().map(|v| v.to_bits()).collect::<Vec<_>>();
            let reacts = first(&instants, &|i, instant| bits(instant) != bits(&rest[i]));
            let stands = |robot: usize| {
                let fast = |instant: &Instant| {
                    let own = robot_of.iter().zip(&instant.frame.speed_bounds).filter(|(of, _)| **of == robot);
                    own.map(|(_, speed)| *speed).fold(0.0, f64::max)
                };
                let moves = |instant: &Instant| fast(instant) > STANDSTILL_M_S;
                let stands = reacts?.max(instants.iter().rposition(moves).map_or(0, |last| last + 1));
                if stands == instants.len() {
                    return Some(NEVER);
                }
                // It is no pause of the programme if the robot would move later had nobody come.
                rest[stands..instants.len()].iter().any(moves).then_some(stands)
            };
            let stands = (0..robots).map(stands).collect();
            walks.push(WalkResponse { reports, reacts, stands });
        }
        Ok(Self(walks))
    }

    /// What says that a safeguard is smaller or slower if these answers become those in `after`. `sensors` are their names.
    pub(crate) fn smaller(&self, after: &Self, sensors: &[&str]) -> Option<Objection> {
        let smaller = |text: String| Some(Objection::Smaller(text));
        for (before, now) in self.0.iter().zip(&after.0) {
            let later =
                |(before, now): (&Option<usize>, &Option<usize>)| before.is_some_and(|b| now.is_none_or(|n| n > b));
            if let Some(sensor) = before.reports.iter().zip(&now.reports).position(later) {
                let name = sensors[sensor];
                return smaller(format!(
                    "it makes a safeguard smaller: {name} then reports the person later or not at all"
                ));
            }
            if later((&before.reacts, &now.reacts)) {
                return smaller(
                    "it makes a safeguard smaller or slower: the robot then answers to the person later or not at all"
                        .to_owned(),
                );
            }
            let stops_later =
                |(before, now): (&Option<usize>, &Option<usize>)| before.zip(*now).is_some_and(|(b, n)| n > b);
            if before.stands.iter().zip(&now.stands).any(stops_later) {
                return smaller("it makes a safeguard slower: the robot then stops later or not at all".to_owned());
            }
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn answers(reports: Option<usize>, reacts: Option<usize>) -> Answers {
        stopping(reports, reacts, None)
    }

    fn stopping(reports: Option<usize>, reacts: Option<usize>, stands: Option<usize>) -> Answers {
        Answers(vec![WalkResponse { reports: vec![reports], reacts, stands: vec![stands] }])
    }

    /// At the start a sensor reports the person that did not before, also one that the change adds.
    #[test]
    fn who_starts_where_a_sensor_then_sees_them_is_told() {
        let at_start = |at_start: &[bool]| SafeguardResponse {
            links: Vec::new(),
            at_start: at_start.to_vec(),
            speeds: Vec::new(),
            run_into: BTreeSet::new(),
        };
        let names = Names { sensors: &["mat", "door"], robots: &[], links: &[], obstacles: &[] };
        let said = |after: &[bool]| at_start(&[true, false]).objection(&at_start(after), false, names);
        assert_eq!((said(&[true, false]), said(&[false, false]), said(&[true, false, false])), (None, None, None));
        for (after, name) in [(&[true, true][..], "door"), (&[true, false, true], ADDED)] {
            let words = format!("{name} then reports the person at the start already");
            assert_eq!(said(after), Some(Objection::Other(words)));
        }
    }

    #[test]
    fn later_is_smaller_and_sooner_is_not() {
        let before = answers(Some(5), Some(9));
        let smaller = |before: &Answers, after: &Answers| before.smaller(after, &["mat"]);
        assert_eq!(smaller(&before, &answers(Some(4), Some(9))), None);
        for after in
            [answers(Some(6), Some(9)), answers(None, Some(9)), answers(Some(5), Some(10)), answers(Some(5), None)]
        {
            assert!(matches!(smaller(&before, &after), Some(Objection::Smaller(_))), "{after:?}");
        }
        // It reacts as soon, and takes longer to stand still.
        let before = stopping(Some(5), Some(9), Some(20));
        assert_eq!(smaller(&before, &stopping(Some(5), Some(9), Some(19))), None);
        assert_eq!(smaller(&before, &stopping(Some(5), Some(9), None)), None);
        for stands in [Some(21), Some(NEVER)] {
            let said = smaller(&before, &stopping(Some(5), Some(9), stands));
            assert!(matches!(said, Some(Objection::Smaller(_))), "{stands:?}");
        }
        // Nobody was reported before.
        assert_eq!(smaller(&answers(None, None), &answers(Some(3), Some(7))), None);
    }

    fn objection(before: &SafeguardResponse, after: &SafeguardResponse, is_time: bool) -> Option<Objection> {
        let names = Names { sensors: &["mat"], robots: &["robot"], links: &["tool"], obstacles: &["fence", "table"] };
        before.objection(after, is_time, names)
    }

    #[test]
    fn a_link_at_an_obstacle_is_not_in_it_and_one_of_corners_is_where_its_surface_is() {
        let table = Cuboid {
            centre: Vec3::new(0.0, 0.0, 0.4),
            half: Vec3::new(0.5, 0.4, 0.4),
            rotation: crate::geometry::Rotation::IDENTITY,
        };
        let ball = |z: f64| {
            let at = Vec3::new(0.2, 0.1, z);
            Solid::Capsule(crate::geometry::Capsule { a: at, b: at + Vec3::X * 0.1, radius: 0.1 })
        };
        let corners = |low: f64| {
            let corner = |bits: u8| {
                let side = |bit: u8| if bits >> bit & 1 == 1 { 0.1 } else { -0.1 };
                Vec3::new(side(0), side(1), low + 0.1 + side(2))
            };
            Solid::Hull(crate::geometry::Hull::from_points(&(0..8).map(corner).collect::<Vec<_>>()).unwrap())
        };
        for (link, is) in [
            (ball(0.905), false),
            (ball(0.895), false),
            (ball(0.885), true),
            (corners(0.805), false),
            (corners(0.795), false),
            (corners(0.785), true),
        ] {
            assert_eq!(is_in(&link, &table), is, "{link:?}");
        }
    }

    #[test]
    fn who_starts_in_a_field_or_before_a_robot_that_stands_has_learnt_nothing() {
        let run_into = BTreeSet::from([(0, 0)]);
        let before = SafeguardResponse { links: vec![Vec3::ZERO], at_start: vec![false], speeds: vec![1.0], run_into };
        let says = |after: &SafeguardResponse, is_time| match objection(&before, after, is_time) {
            Some(Objection::Other(text)) => text,
            other => panic!("{other:?}"),
        };
        let inside = SafeguardResponse { at_start: vec![true], ..before.clone() };
        assert_eq!(says(&inside, false), "mat then reports the person at the start already");
        assert_eq!(objection(&inside, &inside, false), None);
        let slow = SafeguardResponse { speeds: vec![0.04], ..before.clone() };
        assert_eq!(
            says(&slow, false),
            "robot then hardly moves while the person is at the start: 4 % of its speed is left"
        );
        let through = SafeguardResponse { run_into: BTreeSet::from([(0, 0), (1, 0)]), ..before.clone() };
        assert_eq!(says(&through, false), "tool then runs into table");
        assert_eq!(objection(&through, &before, false), None);
        let elsewhere = SafeguardResponse { links: vec![Vec3::X], ..before.clone() };
        assert!(says(&elsewhere, true).contains("where the robot is when"));
        assert_eq!(objection(&before, &elsewhere, false), None);
    }
}
