//! Numbers that a cell file cannot mean: lengths in millimetres, masses in grams, angles in radians, zones whose edges cross.
//!
//! What makes the question meaningless is an error, what is odd a warning that stays with the result. Nothing that comes later has a size
//! from a file that was not looked at here.

use std::collections::BTreeMap;
use std::f64::consts::PI;
use std::ops::Range;

use super::checker::Checker;
use super::format::{CellFile, PoseTable, RobotTable, SensorTable};
use crate::cell::CellError;
use crate::cell::workcell::{Kinematics, Link};
use crate::fmi::number;
use crate::geometry::polygon::crossing;
use crate::geometry::{Capsule, Solid, Vec3};

type Result<T> = std::result::Result<T, Box<CellError>>;

/// Nothing of a cell is farther than this from its origin, or larger, m.
const FARTHEST_M: f64 = 200.0;
/// A robot's base is between these heights, m.
const BASE_M: [f64; 2] = [-10.0, 30.0];
/// No link, and no way from joint to joint, is longer than this; one that is longer than the other is odd, m.
const LONGEST_M: f64 = 20.0;
const LONG_M: f64 = 5.0;
/// A robot whose largest link is smaller is odd, m.
const SMALL_M: f64 = 0.01;
/// Most corners of a zone or floor.
const MOST_CORNERS: usize = 1000;
/// What moves of known arms weighs between so many kg a cubic metre of reach cubed, and for each kg of payload as much more.
const DENSITY_KG_M3: [f64; 2] = [2.0, 80.0];
const FOR_PAYLOAD: f64 = 3.0;
/// No arm that is made moves more than this of its own, or carries more, kg.
const HEAVIEST_KG: f64 = 10_000.0;
const MOST_PAYLOAD_KG: f64 = 2_500.0;
/// A response time shorter than this is no time that a safety device has, ms.
const SHORTEST_MS: f64 = 1.0;
/// Angles that people write down in radians are parts of a turn to so many digits.
const DIGITS: f64 = 6e-4;

/// A length that cannot be meant, with the unit that it may be in.
fn in_another_unit(length_m: f64) -> String {
    let told = |unit: &str, by: f64| {
        format!(
            "lengths are in metres: {} {unit} would be {}",
            number(length_m),
            number((length_m / by * 1000.0).round() / 1000.0)
        )
    };
    match length_m.abs() {
        // A hall is no larger, and what is larger in centimetres is more likely in millimetres.
        far if far / 1000.0 >= 0.2 => told("mm", 1000.0),
        _ => told("cm", 100.0),
    }
}

/// The degrees that a number may stand for which is an angle in radians, if it is written as people write those.
fn in_radians(degrees: f64) -> Option<f64> {
    let twelfths = (degrees * 12.0 / PI).round();
    let is_one = twelfths != 0.0 && twelfths.abs() <= 24.0 && (degrees - twelfths * PI / 12.0).abs() < DIGITS;
    // Whole numbers and halves are degrees.
    (is_one && (2.0 * degrees).fract() != 0.0).then_some(twelfths * 15.0)
}

/// The farthest corner of a solid from its frame's origin, at most, and how large it is, m.
fn extent(solid: &Solid) -> (f64, f64) {
    let (centre, radius) = solid.bounding_sphere();
    let size = match solid {
        Solid::Capsule(Capsule { a, b, radius }) => (*b - *a).length() + 2.0 * radius,
        Solid::Hull(_) | Solid::Mesh(_) => 2.0 * radius,
    };
    (centre.length() + radius, size)
}

impl Checker<'_> {
    fn warn(&self, text: String) {
        self.warnings.borrow_mut().push(text);
    }

    /// Lengths and coordinates are those of a workshop.
    pub(super) fn of_a_workshop(&self, lengths_m: &[f64], span: &Range<usize>, what: &str) -> Result<()> {
        let far =
            lengths_m.iter().copied().fold(0.0_f64, |far, length| if length.abs() > far.abs() { length } else { far });
        self.that(far.abs() <= FARTHEST_M, span.clone(), || {
            (format!("{what} has a length or coordinate of {} m", number(far)), in_another_unit(far))
        })
    }

    /// Corners of a zone or floor are those of a workshop, and its edges do not cross.
    pub(super) fn plain_polygon(&self, corners: &[[f64; 2]], span: &Range<usize>, what: &str) -> Result<()> {
        self.of_a_workshop(&corners.concat(), span, what)?;
        self.that(corners.len() <= MOST_CORNERS, span.clone(), || {
            (format!("{what} has {} corners", corners.len()), format!("give {MOST_CORNERS} at most"))
        })?;
        let crossed = crossing(corners);
        self.that(crossed.is_none(), span.clone(), || {
            let edge = |first: usize| {
                let [from, to] = [corners[first], corners[(first + 1) % corners.len()]];
                let at = |[x, y]: [f64; 2]| format!("({}, {})", number(x), number(y));
                format!("{} to {}", at(from), at(to))
            };
            let (one, other) = crossed.unwrap_or_default();
            let help = "give the corners one after the other around it";
            (format!("{what} crosses itself: its edges {} and {} do", edge(one), edge(other)), help.to_owned())
        })
    }

    /// A link is as long as links are; `unit` says how its file is told to be in millimetres.
    pub(super) fn of_a_robot(&self, solid: &Solid, span: &Range<usize>, what: &str, unit: &str) -> Result<()> {
        let (far, size) = extent(solid);
        self.that(far.max(size) <= LONGEST_M, span.clone(), || {
            let (told, message) = match size > LONGEST_M {
                true => (round(size), "long"),
                false => (round(far), "from its joint"),
            };
            (format!("{what} is {} m {message}", number(told)), format!("{}{unit}", in_another_unit(told)))
        })
    }

    /// The base of a robot, its angles, and the ways from joint to joint.
    pub(super) fn plausible_robot(&self, robot: &RobotTable, span: &Range<usize>) -> Result<()> {
        let name = &robot.name;
        self.of_a_workshop(&robot.base.xyz_m, span, &format!("the base of robot `{name}`"))?;
        let height = robot.base.xyz_m[2];
        self.that((BASE_M[0]..=BASE_M[1]).contains(&height), span.clone(), || {
            let message = format!("the base of robot `{name}` is at a height of {} m", number(height));
            (message, in_another_unit(height))
        })?;
        self.turned(&robot.base, &format!("the base of robot `{name}`"));
        for joint in &robot.joints {
            let what = format!("joint `{}`", joint.name.get_ref());
            if let Some(held) = joint.held_deg {
                self.degrees(&[held], &what);
            }
            let Some(origin) = &joint.origin else { continue };
            self.of_a_chain(Vec3::from_array(origin.get_ref().xyz_m), &origin.span(), &what)?;
            self.turned(origin.get_ref(), &what);
        }
        Ok(())
    }

    /// The way from one joint to the next.
    pub(super) fn of_a_chain(&self, way: Vec3, span: &Range<usize>, what: &str) -> Result<()> {
        let far = round(way.length());
        self.that(far <= LONGEST_M, span.clone(), || {
            (format!("{what} is {} m from the one before", number(far)), in_another_unit(far))
        })
    }

    /// What of a robot fits together: how large its links are, and how heavy it is for its reach.
    pub(super) fn fitting_robot(
        &self,
        robot: &RobotTable,
        kinematics: Option<&Kinematics>,
        links: &[Link],
        mass_kg: f64,
    ) {
        let name = &robot.name;
        let largest = links.iter().map(|link| (extent(&link.shape).1, link)).max_by(|a, b| a.0.total_cmp(&b.0));
        let Some((size, link)) = largest else { return };
        // Of what is too large or too small by far, the mass says nothing.
        if size > LONG_M {
            self.warn(format!(
                "robot `{name}`: link `{}` is {} m long: is it in metres?",
                link.name,
                number(round(size))
            ));
            return;
        }
        if size < SMALL_M {
            self.warn(format!(
                "robot `{name}`: its largest link, `{}`, is {} mm long: are its shapes scaled twice?",
                link.name,
                number(round(size * 1000.0))
            ));
            return;
        }
        let payload = robot.payload_kg.as_ref().map_or(0.0, |kg| *kg.get_ref());
        if mass_kg > HEAVIEST_KG || payload > MOST_PAYLOAD_KG {
            let told = if mass_kg > HEAVIEST_KG { (mass_kg, "move") } else { (payload, "are its payload") };
            self.warn(format!(
                "robot `{name}`: {} kg {}, more than of any arm that is made: is that in kilograms?",
                number(round(told.0)),
                told.1
            ));
            return;
        }
        let Some(kinematics) = kinematics else { return };
        let reach = reach_m(kinematics, links);
        let cubed = reach * reach * reach;
        let [least, most] = [DENSITY_KG_M3[0] * cubed, DENSITY_KG_M3[1] * cubed + FOR_PAYLOAD * payload.min(mass_kg)];
        let why = match mass_kg {
            kg if kg < least => {
                "The less it weighs, the lower the forces: take it from the data sheet, or from a URDF whose inertials are no placeholders"
            }
            kg if kg > most => "Is it in kilograms, and without what does not move?",
            _ if payload > mass_kg.max(most) => {
                self.warn(format!(
                    "robot `{name}`: it carries {} kg and moves {} kg of its own: is the payload in kilograms?",
                    number(payload),
                    number(round(mass_kg))
                ));
                return;
            }
            _ => return,
        };
        self.warn(format!(
            "robot `{name}`: {} kg move, of arms that reach {} m {} to {} kg do. {why}",
            number(round(mass_kg)),
            number(round(reach)),
            number(round(least)),
            number(round(most))
        ));
    }

    /// Masses of links that were never filled in: all the same.
    pub(super) fn filled_in(&self, robot: &str, masses_kg: &[f64]) {
        let mut counts: BTreeMap<u64, usize> = BTreeMap::new();
        masses_kg.iter().filter(|kg| **kg > 0.0).for_each(|kg| *counts.entry(kg.to_bits()).or_default() += 1);
        if let [(kg, count)] = counts.into_iter().collect::<Vec<_>>()[..]
            && count >= 3
        {
            self.warn(format!(
                "robot `{robot}`: all {count} links of its URDF weigh {} kg, as where nobody filled that in: give moving_mass_kg from the data sheet",
                number(f64::from_bits(kg))
            ));
        }
    }

    /// The response time of a sensor is one.
    pub(super) fn plausible_delay(&self, sensor: &SensorTable) {
        let Some(delay) = &sensor.delay_ms else { return };
        let delay = *delay.get_ref();
        if delay > 0.0 && delay < SHORTEST_MS {
            self.warn(format!(
                "sensor `{}`: it tells after {} ms, sooner than any device: is that {} s?",
                sensor.name,
                number(delay),
                number(delay)
            ));
        }
    }

    /// Angles that are told in degrees.
    fn degrees(&self, angles: &[f64], what: &str) {
        if let Some((told, meant)) = angles.iter().find_map(|angle| in_radians(*angle).map(|meant| (*angle, meant))) {
            self.warn(format!(
                "{what} is turned by {} degrees: is that in radians, and {} degrees are meant?",
                number(told),
                number(meant)
            ));
        }
    }

    pub(super) fn turned(&self, pose: &PoseTable, what: &str) {
        self.degrees(&pose.rpy_deg, what);
    }

    /// Angles and heights of what stands about.
    pub(super) fn plausible_surroundings(&self, file: &CellFile) {
        for table in &file.obstacles {
            let what = format!("obstacle `{}`", table.name.get_ref());
            self.degrees(&table.rpy_deg.unwrap_or_default(), &what);
            let (Some(size), Some([_, _, z])) = (table.size_m.as_ref().map(|size| *size.get_ref()), table.centre_m)
            else {
                continue;
            };
            if z + 0.5 * size[2] <= 0.0 && table.rpy_deg.is_none() {
                self.warn(format!("{what} is below the floor, where it is in nobody's way: is z up?"));
            }
        }
        let human = &file.human.first;
        self.degrees(
            &human.start.as_ref().map_or([0.0], |start| [start.get_ref().heading_deg]),
            "where the person starts",
        );
    }
}

/// How far the farthest point of a robot can be from its base at most, m.
fn reach_m(kinematics: &Kinematics, links: &[Link]) -> f64 {
    let joints = &kinematics.tree.joints;
    let mut along: Vec<f64> = Vec::new();
    for joint in joints {
        // What is before the first joint lifts the robot and does not stretch it.
        let own = |parent: usize| along[parent] + joint.parent_from_joint.translation.length();
        along.push(joint.parent.map_or(0.0, own));
    }
    let far = |link: &Link| along.get(link.joint).copied().unwrap_or_default() + extent(&link.shape).0;
    links.iter().map(far).fold(0.0, f64::max)
}

/// To two digits behind the point.
fn round(value: f64) -> f64 {
    (value * 100.0).round() / 100.0
}
