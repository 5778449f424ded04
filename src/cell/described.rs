//! Robots from a URDF: the tree of its moving joints, the collision shapes of what moves, and its mass.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use toml::Spanned;

use super::CellError;
use super::error::{Source, nearest};
use super::format::{JointTable, RobotTable, UpAxis};
use super::mesh::vertices;
use super::urdf::{self, Shape, Urdf};
use super::validate::{Checker, Driven, Kinematics, pose};
use crate::geometry::kinematics::{Joint, KinematicTree, Motion};
use crate::geometry::{Capsule, Hull, Pose, Solid, Vec3};

/// What a URDF says of a robot, with the joints of the cell file.
pub(super) struct Described {
    pub kinematics: Kinematics,
    /// Shapes by the name of their link: index of the moving joint, shape in its frame.
    pub shapes: Vec<(String, usize, Solid)>,
    /// Masses of all links that move, kg; nothing if none is told.
    pub moving_mass_kg: Option<f64>,
    /// What shapes may be attached to: moving joints and links, with the joint that moves them and where they are in its
    /// frame.
    pub places: BTreeMap<String, (usize, Pose)>,
}

/// What a URDF says, for a first cell file.
#[derive(Clone, Debug)]
pub struct Summary {
    /// Joints that move by themselves, in the order of the tree.
    pub joints: Vec<(String, Motion)>,
    /// Masses of all links that move, kg; nothing if none is told.
    pub moving_mass_kg: Option<f64>,
    /// Why the collision shapes cannot be used, if so.
    pub unreadable: Option<String>,
}

/// Reads what the URDF at `path` says.
///
/// # Errors
/// When it is no robot description, with the line.
pub fn summary(path: &Path) -> Result<Summary> {
    let (folder, name) = (path.parent().unwrap_or(Path::new("")), path.file_name().unwrap_or_default());
    let held = |name: &str, motion: &Motion| {
        let held = if *motion == Motion::Prismatic { "held_m" } else { "held_deg" };
        format!("[[robot.joint]]\nname = {}\n{held} = 0\n", toml::Value::String(name.to_owned()))
    };
    // As a cell would read it, with every joint held.
    let cell = |joints: &[(String, Motion)], shapes: bool| {
        let mass = "moving_mass_kg = 1\n";
        let joints: String = joints.iter().map(|(name, motion)| held(name, motion)).collect();
        let path = toml::Value::String(name.to_string_lossy().into_owned());
        Source::new(
            &path.to_string(),
            &format!(
                "schema = 1\nname = \"x\"\n[human]\nstart = {{ xy_m = [0, 0], heading_deg = 0 }}\n[[robot]]\nname = \"x\"\n\
                 urdf = {path}\nurdf_shapes = {shapes}\n{mass}{joints}"
            ),
        )
        .in_folder(folder)
    };
    let describe = |joints: &[(String, Motion)], shapes: bool| {
        let source = cell(joints, shapes);
        let file = super::validate::parse(&source)?;
        let robot = file.robots[0].get_ref();
        Checker::new(&source).described(robot, robot.urdf.as_ref().unwrap_or(&Spanned::new(0..0, String::new())))
    };
    let bytes = std::fs::read(path).map_err(|error| {
        Source::new(&path.display().to_string(), "").error(0..0, "", format!("cannot read it: {error}"), None)
    })?;
    let urdf = urdf::read(&Source::new(&path.display().to_string(), &String::from_utf8_lossy(&bytes)))?;
    let moving = urdf.joints.iter().filter(|joint| joint.mimic.is_none());
    let joints: Vec<(String, Motion)> = moving.filter_map(|joint| Some((joint.name.clone(), joint.motion?))).collect();
    let Described { moving_mass_kg, .. } = describe(&joints, false)?;
    let unreadable = match describe(&joints, true) {
        Ok(described) if described.shapes.is_empty() => Some("no moving link has a collision shape".to_owned()),
        Ok(_) => None,
        Err(error) => Some(error.message),
    };
    Ok(Summary { joints, moving_mass_kg, unreadable })
}

/// Edges of the prism that stands around a cylinder: at most 1 % of the radius beyond it.
const PRISM_EDGES: u16 = 24;

type Result<T> = std::result::Result<T, Box<CellError>>;

impl Checker<'_> {
    /// The robot that the URDF of `robot` describes.
    pub(super) fn described(&self, robot: &RobotTable, named: &Spanned<String>) -> Result<Described> {
        let path = PathBuf::from(named.get_ref());
        let bytes = self.files.read(self.source.folder(), &path).map_err(|error| {
            let help = "the path is relative to the cell file".to_owned();
            self.source.error(
                named.span(),
                "named here",
                format!("cannot read {}: {error}", path.display()),
                Some(help),
            )
        })?;
        let text = String::from_utf8_lossy(&bytes);
        let shown = self.source.folder().join(&path);
        let source = Source::new(&shown.display().to_string(), &text);
        let urdf = urdf::read(&source)?;
        self.mentioned(robot, &urdf)?;
        let (kinematics, movers) = self.kinematics(robot, named, &urdf)?;
        let mut shapes = Vec::new();
        for (link, mover) in urdf.links.iter().zip(&movers) {
            let Some((joint, joint_from_link)) = mover else { continue };
            if !robot.urdf_shapes || robot.ignore_links.iter().any(|name| *name.get_ref() == link.name) {
                continue;
            }
            if link.only_seen {
                let text = "can be seen and has no collision shape: it cannot be hit";
                self.warnings.borrow_mut().push(format!("{}: link `{}` {text}", path.display(), link.name));
            }
            for (link_from_shape, shape) in &link.shapes {
                let solid = self.solid(shape, &path, &source)?;
                shapes.push((link.name.clone(), *joint, solid.placed(*joint_from_link * *link_from_shape)));
            }
        }
        let moving: Vec<f64> = urdf
            .links
            .iter()
            .zip(&movers)
            .filter(|(_, mover)| mover.is_some())
            .filter_map(|(link, _)| link.mass_kg)
            .collect();
        let total: f64 = moving.iter().sum();
        // Forces follow from the mass: part of it is worse than none.
        let light: Vec<&str> = urdf
            .links
            .iter()
            .zip(&movers)
            .filter(|(link, mover)| mover.is_some() && (link.only_seen || !link.shapes.is_empty()))
            .filter(|(link, _)| link.mass_kg.is_none_or(|kg| kg == 0.0))
            .map(|(link, _)| link.name.as_str())
            .collect();
        let told = total > 0.0 && light.is_empty();
        if total > 0.0 && !told && robot.moving_mass_kg.is_none() {
            let message = format!("the URDF does not say how heavy {} is", light.join(", "));
            let help = format!(
                "the links with a mass add up to {total:.1} kg, which is too little: add moving_mass_kg, from the robot's \
                 data sheet"
            );
            return Err(self.source.error(named.span(), "of this robot", message, Some(help)));
        }
        let links = urdf.links.iter().zip(&movers);
        let mut places: BTreeMap<String, (usize, Pose)> =
            links.filter_map(|(link, mover)| Some((link.name.clone(), (*mover)?))).collect();
        let moved = urdf.joints.iter().filter(|joint| joint.motion.is_some());
        places.extend(moved.enumerate().map(|(number, joint)| (joint.name.clone(), (number, Pose::IDENTITY))));
        Ok(Described { kinematics, shapes, moving_mass_kg: told.then_some(total), places })
    }

    /// Whether the joints and links that the cell file names are there.
    fn mentioned(&self, robot: &RobotTable, urdf: &Urdf) -> Result<()> {
        let missing = |what: &str, name: &Spanned<String>, all: Vec<&str>| {
            let known = all.join(", ");
            let help = nearest(name.get_ref(), all)
                .map_or_else(|| format!("the URDF has {known}"), |near| format!("did you mean `{near}`?"));
            self.source.error(name.span(), "here", format!("the URDF has no {what} `{}`", name.get_ref()), Some(help))
        };
        let joints = || urdf.joints.iter().filter(|joint| joint.motion.is_some()).map(|joint| joint.name.as_str());
        let links = || urdf.links.iter().map(|link| link.name.as_str());
        for JointTable { name, .. } in &robot.joints {
            if !joints().any(|joint| joint == name.get_ref()) {
                return Err(missing("moving joint", name, joints().collect()));
            }
        }
        for name in &robot.ignore_links {
            if !links().any(|link| link == name.get_ref()) {
                return Err(missing("link", name, links().collect()));
            }
        }
        Ok(())
    }

    /// The moving joints, and for each link the one that moves it, with where it is in that joint's frame.
    #[expect(clippy::type_complexity, reason = "one place")]
    fn kinematics(
        &self,
        robot: &RobotTable,
        named: &Spanned<String>,
        urdf: &Urdf,
    ) -> Result<(Kinematics, Vec<Option<(usize, Pose)>>)> {
        let mut tree = KinematicTree { world_from_base: pose(&robot.base), joints: Vec::new() };
        let mut driven = Vec::new();
        let mut unnamed = Vec::new();
        // For each link the moving joint behind it, if any, and its pose in that joint's frame or the base.
        let mut placed: Vec<(Option<usize>, Pose)> = vec![(None, Pose::IDENTITY); urdf.links.len()];
        for joint in &urdf.joints {
            let (parent, parent_from_link) = placed[joint.parent];
            let parent_from_joint = parent_from_link * joint.origin;
            let Some(motion) = joint.motion else {
                placed[joint.child] = (parent, parent_from_joint);
                continue;
            };
            placed[joint.child] = (Some(tree.joints.len()), Pose::IDENTITY);
            tree.joints.push(Joint { parent, parent_from_joint, motion, axis: joint.axis });
            let at = |name: &str| robot.joints.iter().position(|table| table.name.get_ref() == name);
            // What the cell file says of a joint counts, also of one that follows another.
            let found = at(&joint.name).map(|named| Driven { named, factor: 1.0, offset: 0.0 }).or_else(|| {
                let (of, factor, offset) = joint.mimic.as_ref()?;
                Some(Driven { named: at(of)?, factor: *factor, offset: *offset })
            });
            if let Some(table) = at(&joint.name).map(|at| &robot.joints[at]) {
                let slides = table.position.is_some() || table.held_m.is_some();
                if slides != (motion == Motion::Prismatic) {
                    let (does, keys) = match motion {
                        Motion::Revolute => ("turns", "`angle` or `held_deg`"),
                        Motion::Prismatic => ("slides", "`position` or `held_m`"),
                    };
                    let message = format!("joint `{}` of the URDF {does}", joint.name);
                    let help = format!("use {keys}");
                    return Err(self.source.error(table.name.span(), "here", message, Some(help)));
                }
            }
            match found {
                Some(one) => driven.push(one),
                None if joint.mimic.is_none() => unnamed.push((joint.name.as_str(), motion)),
                None => {}
            }
        }
        if let Some((name, motion)) = unnamed.first() {
            let all: Vec<&str> = unnamed.iter().map(|(name, _)| *name).collect();
            let message = format!("nothing says where joint{} {} of the URDF are", plural(&all), all.join(", "));
            let (by, held) = match motion {
                Motion::Revolute => ("angle", "held_deg = 0"),
                Motion::Prismatic => ("position", "held_m = 0"),
            };
            let help = format!(
                "add [[robot.joint]] with name = \"{name}\" and {by} = {{ variable = \"...\" }}, or {held} if it never \
                 moves"
            );
            return Err(self.source.error(named.span(), "of this robot", message, Some(help)));
        }
        let movers = placed.into_iter().map(|(joint, pose)| joint.map(|joint| (joint, pose))).collect();
        Ok((Kinematics { tree, driven }, movers))
    }

    fn solid(&self, shape: &Shape, urdf: &Path, source: &Source) -> Result<Solid> {
        match shape {
            Shape::Box(size) => {
                let [x, y, z] = size.map(|edge| 0.5 * edge);
                let corner = |n: u8| {
                    let side = |bit: u8, half: f64| if n & bit == 0 { -half } else { half };
                    Vec3::new(side(1, x), side(2, y), side(4, z))
                };
                self.hull(&(0..8).map(corner).collect::<Vec<_>>(), source, &(0..0))
            }
            Shape::Cylinder { radius, length } => self.hull(&prism(*radius, *length), source, &(0..0)),
            Shape::Capsule { radius, length } => {
                let end = Vec3::Z * (0.5 * length);
                Ok(Solid::Capsule(Capsule { a: -end, b: end, radius: *radius }))
            }
            Shape::Sphere { radius } => Ok(Solid::Capsule(Capsule { a: Vec3::ZERO, b: Vec3::ZERO, radius: *radius })),
            Shape::Mesh { file, scale, place } => {
                let scale = Vec3::from_array(*scale);
                let points = self
                    .mesh_of(file, urdf)
                    .map_err(|(message, help)| source.error(place.clone(), "named here", message, Some(help)))?;
                let scaled: Vec<Vec3> = points.into_iter().map(|point| point * scale).collect();
                self.hull(&scaled, source, place)
            }
        }
    }

    fn hull(&self, points: &[Vec3], source: &Source, place: &std::ops::Range<usize>) -> Result<Solid> {
        let hull = Hull::from_points(points).ok_or_else(|| {
            let help = "its corners have to span a volume; a flat part needs a box".to_owned();
            source.error(place.clone(), "of this shape", "a shape has no convex hull with volume", Some(help))
        })?;
        Ok(Solid::Hull(hull))
    }

    /// Corners of a mesh that a URDF names: `package://` is looked for beside the cell file and upwards of the URDF.
    fn mesh_of(&self, named: &str, urdf: &Path) -> std::result::Result<Vec<Vec3>, (String, String)> {
        let beside = urdf.parent().unwrap_or(Path::new(""));
        let candidates: Vec<PathBuf> = match named.split_once("://") {
            None => vec![beside.join(named)],
            Some(("file", path)) => vec![PathBuf::from(path)],
            Some(("package" | "model", path)) => {
                let (package, rest) = path.split_once('/').unwrap_or((path, ""));
                let up = urdf.ancestors().skip(1);
                let own = up.clone().filter(|a| a.file_name().is_some_and(|n| n == package)).map(|a| a.join(rest));
                own.chain(up.map(|a| a.join(path))).chain([PathBuf::from(path)]).collect()
            }
            Some((scheme, _)) => {
                let help = "a path, file:// or package://".to_owned();
                return Err((format!("`{scheme}://` is not known"), help));
            }
        };
        let folder = self.source.folder();
        let Some(path) = candidates.iter().find(|path| folder.join(path).is_file()) else {
            let looked: Vec<String> = candidates.iter().map(|path| folder.join(path).display().to_string()).collect();
            let help = format!(
                "put it where it is looked for ({}), or take the kinematics only, with urdf_shapes = false, and give shapes \
                 in [[robot.link]] tables",
                looked.join(", ")
            );
            return Err((format!("the mesh {named} is not there"), help));
        };
        self.points(path).map_err(|message| (message, "convex hulls are made of STL and OBJ files".to_owned()))
    }

    /// Corners of the mesh at `path`, relative to the cell file.
    pub(super) fn points(&self, path: &Path) -> std::result::Result<Vec<Vec3>, String> {
        let bytes = self.files.read(self.source.folder(), path);
        let bytes = bytes.map_err(|error| format!("cannot read {}: {error}", path.display()))?;
        vertices(path, &bytes).map_err(|error| format!("{}: {error}", path.display()))
    }
}

/// The ending of "joint" for several.
fn plural(all: &[&str]) -> &'static str {
    if all.len() == 1 { "" } else { "s" }
}

/// The corners of a prism that stands around a cylinder.
fn prism(radius: f64, length: f64) -> Vec<Vec3> {
    let part = std::f64::consts::TAU / f64::from(PRISM_EDGES);
    let outer = radius / libm::cos(0.5 * part);
    let corner = |n: u16| {
        let (sin, cos) = libm::sincos(f64::from(n) * part);
        [-0.5, 0.5].map(|side| Vec3::new(outer * cos, outer * sin, side * length))
    };
    (0..PRISM_EDGES).flat_map(corner).collect()
}

/// A point of a mesh in metres, z up.
pub(super) fn upright(point: Vec3, metres_per_unit: f64, up: UpAxis) -> Vec3 {
    let point = point * metres_per_unit;
    match up {
        UpAxis::Z => point,
        UpAxis::Y => Vec3::new(point.x, -point.z, point.y),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_prism_stands_around_its_cylinder() {
        let corners = prism(0.1, 0.4);
        assert_eq!(corners.len(), 48);
        let hull = Solid::Hull(Hull::from_points(&corners).unwrap());
        for n in 0..100 {
            let (sin, cos) = libm::sincos(0.0628 * f64::from(n));
            let on_cylinder = Vec3::new(0.1 * cos, 0.1 * sin, 0.2);
            let distance = hull.point_distance(on_cylinder).distance;
            assert!((-0.001..1e-9).contains(&distance), "{distance}");
        }
    }

    #[test]
    fn up_may_be_y() {
        let up = upright(Vec3::new(1.0, 2.0, 3.0), 0.001, UpAxis::Y);
        assert!((up - Vec3::new(0.001, -0.003, 0.002)).length() < 1e-15);
    }
}
