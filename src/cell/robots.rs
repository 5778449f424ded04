//! Checks of the robots in a cell file: kinematics, link shapes, masses.

use std::ops::Range;

use toml::Spanned;

use super::CellError;
use super::error::nearest;
use super::format::{CapsuleTable, CellFile, LinkTable, RobotTable};
use super::validate::{Checker, Link, Robot, pose};
use crate::geometry::chain::{Joint, KinematicChain};
use crate::geometry::{Capsule, Hull, Solid, Vec3};

impl Checker<'_> {
    /// All robots, and their links one robot after the other.
    pub(super) fn robots(&self, file: &CellFile) -> (Vec<Robot>, Vec<Link>) {
        let _ = self.problems.keep(self.that(!file.robots.is_empty(), 0..0, || {
            ("the cell has no robot".to_owned(), "add a [[robot]] table".to_owned())
        }));
        let (mut robots, mut links) = (Vec::new(), Vec::new());
        for (number, table) in file.robots.iter().enumerate() {
            let name = &table.get_ref().name;
            let alone = file.robots[..number].iter().all(|other| other.get_ref().name != *name);
            let _ = self.problems.keep(self.that(alone, table.span(), || {
                (format!("two robots are called `{name}`"), "give each robot its own name".to_owned())
            }));
            robots.extend(self.problems.keep(self.robot(table)));
            for mut link in self.links(table, number) {
                if file.robots.len() > 1 {
                    link.name = format!("{} {}", table.get_ref().name, link.name);
                }
                links.push(link);
            }
        }
        (robots, links)
    }

    fn robot(&self, table: &Spanned<RobotTable>) -> Result<Robot, Box<CellError>> {
        let robot = table.get_ref();
        let mass = &robot.moving_mass_kg;
        self.positive(*mass.get_ref(), &mass.span(), "the moving mass of the robot")?;
        if let Some(payload) = &robot.payload_kg {
            let kg = *payload.get_ref();
            self.that(kg.is_finite() && kg >= 0.0, payload.span(), || {
                (format!("payload_kg is {kg}"), "use zero or more kilograms".to_owned())
            })?;
        }
        self.that(robot.joints.is_empty() != robot.frames.is_empty(), table.span(), || {
            (
                "the robot needs either joints or frames".to_owned(),
                "add [[robot.joint]] tables, base to tool, or [[robot.frame]] tables if the FMU gives link poses"
                    .to_owned(),
            )
        })?;
        for (i, frame) in robot.frames.iter().enumerate() {
            let name = frame.name.get_ref();
            self.that(robot.frames[..i].iter().all(|f| f.name.get_ref() != name), frame.name.span(), || {
                (format!("two frames are called `{name}`"), "give each frame its own name".to_owned())
            })?;
        }
        Ok(Robot {
            name: robot.name.clone(),
            world_from_base: pose(&robot.base),
            chain: if robot.joints.is_empty() { None } else { Some(self.chain(robot)?) },
            moving_mass_kg: *mass.get_ref(),
            mass_line: self.source.line(mass.span().start),
        })
    }

    fn chain(&self, robot: &RobotTable) -> Result<KinematicChain, Box<CellError>> {
        let mut joints = Vec::with_capacity(robot.joints.len());
        for (i, joint) in robot.joints.iter().enumerate() {
            let name = joint.name.get_ref();
            self.that(robot.joints[..i].iter().all(|j| j.name.get_ref() != name), joint.name.span(), || {
                (format!("two joints are called `{name}`"), "give each joint its own name".to_owned())
            })?;
            let axis = Vec3::from_array(*joint.axis.get_ref());
            self.that(axis.is_finite() && axis.length() > 1e-9, joint.axis.span(), || {
                (format!("the axis of joint `{name}` has no direction"), "for instance axis = [0, 0, 1]".to_owned())
            })?;
            joints.push(Joint { parent_from_joint: pose(&joint.origin), axis: axis / axis.length() });
        }
        Ok(KinematicChain { world_from_base: pose(&robot.base), joints })
    }

    fn links(&self, table: &Spanned<RobotTable>, number: usize) -> Vec<Link> {
        let robot = table.get_ref();
        let _ = self.problems.keep(self.that(!robot.links.is_empty(), table.span(), || {
            (
                "the cell has no robot geometry: without link shapes nothing can be hit".to_owned(),
                "add [[robot.link]] tables with a `capsule` or `hull_m` each".to_owned(),
            )
        }));
        let joints = robot.joints.iter().map(|j| j.name.get_ref().as_str());
        let movers: Vec<&str> = joints.chain(robot.frames.iter().map(|f| f.name.get_ref().as_str())).collect();
        self.problems.keep_all(robot.links.iter().map(|link| self.link(link, number, &movers)))
    }

    fn link(&self, link: &LinkTable, robot: usize, movers: &[&str]) -> Result<Link, Box<CellError>> {
        let wanted = link.joint.get_ref();
        let Some(joint) = movers.iter().position(|name| name == wanted) else {
            let help = match nearest(wanted, movers.iter().copied()) {
                Some(name) => format!("did you mean `{name}`?"),
                None => format!("the joints or frames are {}", movers.join(", ")),
            };
            return Err(self.source.error(link.joint.span(), "here", format!("there is no joint `{wanted}`"), Some(help)));
        };
        let span = link.joint.span();
        let shape = match (&link.capsule, &link.hull_m) {
            (Some(capsule), None) => Solid::Capsule(self.capsule(capsule, &span)?),
            (None, Some(points)) => {
                let list: Vec<Vec3> = points.get_ref().iter().map(|p| Vec3::from_array(*p)).collect();
                let hull = Hull::from_points(&list).ok_or_else(|| {
                    let help = "give at least four corner points that are not in one plane".to_owned();
                    self.source.error(points.span(), "here", "these points have no convex hull with volume", Some(help))
                })?;
                Solid::Hull(hull)
            }
            _ => {
                let message = format!("link `{}` needs one shape: either `capsule` or `hull_m`", link.name);
                return Err(self.source.error(span, "in this link", message, None));
            }
        };
        Ok(Link { name: link.name.clone(), robot, joint, shape, line: self.source.line(span.start) })
    }

    fn capsule(&self, table: &CapsuleTable, span: &Range<usize>) -> Result<Capsule, Box<CellError>> {
        self.positive(table.radius_m, span, "the radius of a link")?;
        let (a, b) = (Vec3::from_array(table.from_m), Vec3::from_array(table.to_m));
        self.that(a.is_finite() && b.is_finite(), span.clone(), || {
            ("a capsule end is not finite".to_owned(), "write plain numbers".to_owned())
        })?;
        Ok(Capsule { a, b, radius: table.radius_m })
    }
}
