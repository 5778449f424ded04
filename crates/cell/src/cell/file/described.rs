//! Robots from a URDF: the tree of its moving joints, the collision shapes of what moves, and its mass.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use toml::Spanned;

use super::checker::{Checker, pose};
use path_clean::clean;

use super::files::named_from;
use super::format::{JointTable, RobotTable, UpAxis};
use super::inertias::Spread;
use crate::cell::CellError;
use crate::cell::error::{Source, nearest};
use crate::cell::foreign::mesh::{self, Mesh};
use crate::cell::foreign::packages::Packages;
use crate::cell::foreign::urdf::{self, Shape, Tensor, Urdf};
use crate::cell::workcell::{Driven, Kinematics, Look};
use crate::geometry::kinematics::{Joint, KinematicTree, Motion};
use crate::geometry::{Capsule, Hull, Inertia, Pose, Solid, Vec3};

type Result<T> = std::result::Result<T, Box<CellError>>;

/// What a URDF says of a robot, with the joints of the cell file.
pub(super) struct Described {
    pub kinematics: Kinematics,
    /// Shapes of what moves.
    pub shapes: Vec<DescribedShape>,
    /// Masses of all links that move, kg; nothing if none is told.
    pub moving_mass_kg: Option<f64>,
    /// What shapes may be attached to: moving joints and links, with the joint that moves them and where they are in its
    /// frame.
    pub places: BTreeMap<String, (usize, Pose)>,
}

/// A shape of a link.
pub(super) struct DescribedShape {
    /// Name of the link.
    pub name: String,
    /// Index of the moving joint.
    pub joint: usize,
    /// Shape in its frame.
    pub shape: Solid,
    /// What the link looks like: on the first of its shapes that turns with it.
    pub looks: Vec<Look>,
}

/// What a URDF says, for a first cell file.
#[derive(Clone, Debug)]
pub struct Summary {
    /// Joints that move by themselves, in the order of the tree.
    pub joints: Vec<(String, Motion)>,
    /// Masses of all links that move, kg; nothing if none is told.
    pub moving_mass_kg: Option<f64>,
    /// Why the collision shapes cannot be used, if so, and what would help.
    pub unreadable: Option<(String, Option<String>)>,
    /// Packages that the cell file has to name, by name, relative to it: found by options or the environment of now.
    pub packages: Vec<(String, String)>,
}

/// Reads what the URDF at `path` says, exactly as a cell file in `folder` would that names it; `packages` are folders that the
/// user named, by package.
///
/// # Errors
/// When it is no robot description, with the line.
pub fn summary(path: &Path, folder: &Path, packages: &[(String, PathBuf)]) -> Result<Summary> {
    let source = Source::new("", "").in_folder(folder);
    let check = Checker::new(&source);
    let named = Spanned::new(0..0, named_from(path, folder));
    let own = packages.iter().map(|(name, package)| (name.clone(), PathBuf::from(named_from(package, folder))));
    let file = check.urdf(&named, Packages::new(own.collect()))?;
    let tree = Tree::of(&file.urdf, Pose::IDENTITY);
    let moving = tree.moving.iter().filter(|joint| joint.mimic.is_none());
    let joints = moving.filter_map(|joint| Some((joint.name.clone(), joint.motion?))).collect();
    let unreadable = match check.shapes(&file, &tree, |_| true) {
        Ok(shapes) if shapes.is_empty() => Some(("no moving link has a collision shape".to_owned(), None)),
        Ok(_) => None,
        Err(error) => Some((error.message, error.help)),
    };
    let packages =
        file.packages.elsewhere().into_iter().map(|(name, package)| (name, named_from(&folder.join(package), folder)));
    Ok(Summary { joints, moving_mass_kg: masses(&file.urdf, &tree).ok(), unreadable, packages: packages.collect() })
}

/// A URDF file.
struct UrdfFile {
    /// As the cell file names it.
    path: PathBuf,
    source: Source,
    urdf: Urdf,
    /// Where its meshes may be.
    packages: Packages,
}

/// Its moving joints as a tree.
struct Tree<'a> {
    tree: KinematicTree,
    /// The joints of the tree.
    moving: Vec<&'a urdf::Joint>,
    /// For each link the joint that moves it, with where it is in that joint's frame.
    movers: Vec<Option<(usize, Pose)>>,
}

impl<'a> Tree<'a> {
    fn of(urdf: &'a Urdf, world_from_base: Pose) -> Self {
        let mut tree = KinematicTree { world_from_base, joints: Vec::new() };
        let mut moving = Vec::new();
        // For each link the moving joint behind it, if any, and its pose in that joint's frame or the base.
        let mut placed: Vec<(Option<usize>, Pose)> = vec![(None, Pose::IDENTITY); urdf.links.len()];
        for joint in &urdf.joints {
            let (parent, parent_from_link) = placed[joint.parent];
            let parent_from_joint = parent_from_link * joint.origin;
            placed[joint.child] = match joint.motion {
                None => (parent, parent_from_joint),
                Some(motion) => {
                    tree.joints.push(Joint { parent, parent_from_joint, motion, axis: joint.axis });
                    moving.push(joint);
                    (Some(tree.joints.len() - 1), Pose::IDENTITY)
                }
            };
        }
        let movers = placed.into_iter().map(|(joint, pose)| joint.map(|joint| (joint, pose))).collect();
        Self { tree, moving, movers }
    }

    /// Links that move, with the joint that moves them and where they are in its frame.
    fn links(&self, urdf: &'a Urdf) -> impl Iterator<Item = (&'a urdf::Link, usize, Pose)> {
        urdf.links.iter().zip(&self.movers).filter_map(|(link, mover)| mover.map(|(joint, pose)| (link, joint, pose)))
    }
}

/// Mass of all links that move, kg; else what is told, and the links that miss a mass. Forces follow from it: part of it is
/// worse than none.
fn masses<'a>(urdf: &'a Urdf, tree: &Tree<'a>) -> std::result::Result<f64, (f64, Vec<&'a str>)> {
    let total: f64 = tree.links(urdf).filter_map(|(link, ..)| link.mass_kg).sum();
    let light = tree
        .links(urdf)
        .map(|(link, ..)| link)
        .filter(|link| link.is_there() && link.mass_kg.is_none_or(|kg| kg == 0.0));
    let light: Vec<&str> = light.map(|link| link.name.as_str()).collect();
    if total > 0.0 && light.is_empty() { Ok(total) } else { Err((total, light)) }
}

/// Edges of the prism that stands around a cylinder: at most 1 % of the radius beyond it.
const PRISM_EDGES: u16 = 24;

impl Checker<'_> {
    /// Reads the URDF that is named.
    fn urdf(&self, named: &Spanned<String>, packages: Packages) -> Result<UrdfFile> {
        let path = PathBuf::from(named.get_ref());
        let bytes = self.files.read(self.source.folder(), &path).map_err(|error| {
            let message = format!("cannot read {}: {error}", path.display());
            let help = "the path is relative to the cell file".to_owned();
            self.source.error(named.span(), "named here", message, Some(help))
        })?;
        let shown = clean(self.source.folder().join(&path)).display().to_string();
        let source = Source::new(&shown, &String::from_utf8_lossy(&bytes));
        let urdf = urdf::read(&source)?;
        Ok(UrdfFile { path, source, urdf, packages })
    }

    /// The robot that the URDF of `robot` describes.
    pub(super) fn described(&self, robot: &RobotTable, named: &Spanned<String>) -> Result<Described> {
        let packages = robot.packages.iter().map(|(name, folder)| (name.clone(), PathBuf::from(folder.get_ref())));
        let file = self.urdf(named, Packages::new(packages.collect()))?;
        self.mentioned(robot, &file.urdf)?;
        let tree = Tree::of(&file.urdf, pose(&robot.base));
        let driven = self.driven(robot, named, &tree)?;
        let used = |link: &str| robot.urdf_shapes && robot.ignore_links.iter().all(|name| name.get_ref() != link);
        let shapes = self.shapes(&file, &tree, used)?;
        let moving_mass_kg = match masses(&file.urdf, &tree) {
            Err((told, missing)) if told > 0.0 && robot.moving_mass_kg.is_none() => {
                let message = format!("the URDF does not say how heavy {} is", missing.join(", "));
                let help = format!(
                    "the links with a mass add up to {told:.1} kg, which is too little: add moving_mass_kg, from the \
                     robot's data sheet"
                );
                return Err(self.source.error(named.span(), "of this robot", message, Some(help)));
            }
            other => other.ok(),
        };
        if robot.moving_mass_kg.is_none() {
            let masses: Vec<f64> = tree.links(&file.urdf).filter_map(|(link, ..)| link.mass_kg).collect();
            self.filled_in(&robot.name, &masses);
        }
        for (joint, placed) in tree.moving.iter().zip(&tree.tree.joints) {
            self.of_a_chain(
                placed.parent_from_joint.translation,
                &named.span(),
                &format!("joint `{}` of the URDF", joint.name),
            )?;
        }
        let links = tree.links(&file.urdf).map(|(link, joint, pose)| (link.name.clone(), (joint, pose)));
        let joints = tree.moving.iter().enumerate().map(|(at, joint)| (joint.name.clone(), (at, Pose::IDENTITY)));
        let places = links.chain(joints).collect();
        let masses = self.masses(robot, self.spreads(robot, &file, &tree), &driven);
        let fastest = tree.moving.iter().map(|joint| joint.fastest).collect();
        let ranges = tree.moving.iter().map(|joint| joint.range).collect();
        let kinematics = Kinematics { tree: tree.tree, driven, fastest, ranges, masses, payload_at: (0, Vec3::ZERO) };
        Ok(Described { kinematics, shapes, moving_mass_kg, places })
    }

    /// How the mass of what each joint moves is spread: by the cell file, else by the links that it moves with.
    fn spreads(&self, robot: &RobotTable, file: &UrdfFile, tree: &Tree<'_>) -> Vec<Spread> {
        let own = |joint: &urdf::Joint| {
            let table = robot.joints.iter().find(|table| *table.name.get_ref() == joint.name)?;
            self.problems.keep(self.inertia(table)).flatten()
        };
        let of_links = |at: usize| {
            let (mut body, mut reasons, mut any) = (Inertia::NONE, Vec::new(), false);
            for (link, _, joint_from_link) in tree.links(&file.urdf).filter(|(_, joint, _)| *joint == at) {
                any |= link.inertia != Tensor::Untold;
                match link.inertia {
                    Tensor::Given(inertia) => body = body.with(&inertia.placed(joint_from_link)),
                    Tensor::Wrong => reasons.push(format!("link `{}` has one that no body has", link.name)),
                    Tensor::Untold if link.is_there() || link.mass_kg.is_some_and(|kg| kg > 0.0) => {
                        reasons.push(format!("link `{}` has none", link.name));
                    }
                    Tensor::Untold => {}
                }
            }
            if reasons.is_empty() { Spread::Given(body) } else { Spread::Unknown(reasons, any) }
        };
        let moving = tree.moving.iter().enumerate();
        moving.map(|(at, joint)| own(joint).map_or_else(|| of_links(at), Spread::Given)).collect()
    }

    /// Collision shapes of the links that move and are `used`.
    fn shapes(&self, file: &UrdfFile, tree: &Tree<'_>, used: impl Fn(&str) -> bool) -> Result<Vec<DescribedShape>> {
        let mut shapes = Vec::new();
        for (link, joint, joint_from_link) in tree.links(&file.urdf).filter(|(link, ..)| used(&link.name)) {
            if link.only_seen {
                let text = "can be seen and has no collision shape: it cannot be hit";
                self.warnings.borrow_mut().push(format!("{}: link `{}` {text}", file.path.display(), link.name));
            }
            let mut seen = false;
            for (link_from_shape, shape) in &link.shapes {
                let solid = self.solid(shape, file)?;
                // A capsule is told by its two ends, which say nothing of how it is turned.
                let looks = if seen || matches!(solid, Solid::Capsule(_)) {
                    Vec::new()
                } else {
                    seen = true;
                    self.looks(link, file, link_from_shape.inverse())
                };
                let shape = solid.placed(joint_from_link * *link_from_shape);
                shapes.push(DescribedShape { name: link.name.clone(), joint, shape, looks });
            }
        }
        Ok(shapes)
    }

    /// What a link looks like, where its meshes are found.
    fn looks(&self, link: &urdf::Link, file: &UrdfFile, shape_from_link: Pose) -> Vec<Look> {
        let found = |(link_from_mesh, look): &(Pose, urdf::Look)| {
            if !mesh::is_read(Path::new(&look.file)) {
                return None;
            }
            let path = self.source.folder().join(self.mesh_path(&look.file, file).ok()?);
            Some(Look { path, scale: Vec3::from_array(look.scale), pose: shape_from_link * *link_from_mesh })
        };
        link.looks.iter().filter_map(found).collect()
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

    /// What moves each joint of the tree: a joint of the cell file, or one that it mimics.
    fn driven(&self, robot: &RobotTable, named: &Spanned<String>, tree: &Tree<'_>) -> Result<Vec<Driven>> {
        let at = |name: &str| robot.joints.iter().position(|table| table.name.get_ref() == name);
        let mut driven = Vec::new();
        let mut unnamed = Vec::new();
        for (joint, Joint { motion, .. }) in tree.moving.iter().zip(&tree.tree.joints) {
            // What the cell file says of a joint counts, also of one that follows another.
            let own = at(&joint.name);
            if let Some(table) = own.map(|own| &robot.joints[own]) {
                self.fits(table, *motion)?;
            }
            let found = own.map(|named| Driven { named, factor: 1.0, offset: 0.0 }).or_else(|| {
                let (of, factor, offset) = joint.mimic.as_ref()?;
                Some(Driven { named: at(of)?, factor: *factor, offset: *offset })
            });
            match found {
                Some(one) => driven.push(one),
                None if joint.mimic.is_none() => unnamed.push((joint.name.as_str(), *motion)),
                None => {}
            }
        }
        let Some((name, motion)) = unnamed.first() else { return Ok(driven) };
        let all: Vec<&str> = unnamed.iter().map(|(name, _)| *name).collect();
        let message = format!("nothing says where joint{} {} of the URDF are", plural(&all), all.join(", "));
        let (by, held) = match motion {
            Motion::Revolute => ("angle", "held_deg = 0"),
            Motion::Prismatic => ("position", "held_m = 0"),
        };
        let help = format!(
            "add [[robot.joint]] with name = \"{name}\" and {by} = {{ variable = \"...\" }}, or {held} if it never moves"
        );
        Err(self.source.error(named.span(), "of this robot", message, Some(help)))
    }

    /// Whether a joint's keys are those of how it moves.
    fn fits(&self, table: &JointTable, motion: Motion) -> Result<()> {
        let slides = table.position.is_some() || table.held_m.is_some();
        let (does, keys) = match motion {
            Motion::Revolute => ("turns", "`angle` or `held_deg`"),
            Motion::Prismatic => ("slides", "`position` or `held_m`"),
        };
        self.that(slides == (motion == Motion::Prismatic), table.name.span(), || {
            (format!("joint `{}` of the URDF {does}", table.name.get_ref()), format!("use {keys}"))
        })
    }

    fn solid(&self, shape: &Shape, urdf: &UrdfFile) -> Result<Solid> {
        let source = &urdf.source;
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

    /// Corners of a mesh that a URDF names.
    fn mesh_of(&self, named: &str, urdf: &UrdfFile) -> std::result::Result<Vec<Vec3>, (String, String)> {
        let mesh = self.mesh_file(&self.mesh_path(named, urdf)?);
        mesh.map(|mesh| mesh.points)
            .map_err(|message| (message, "convex hulls are made of STL and OBJ files".to_owned()))
    }

    /// Where a mesh is that a URDF names, relative to the cell file; else why not, and what helps.
    fn mesh_path(&self, named: &str, urdf: &UrdfFile) -> std::result::Result<PathBuf, (String, String)> {
        let folder = self.source.folder();
        let kinematics =
            "or take the kinematics only, with urdf_shapes = false, and give shapes in [[robot.link]] tables";
        let missing = |help: String| (format!("the mesh {named} is not there"), help);
        match named.split_once("://") {
            Some(("package" | "model", path)) => {
                let (package, rest) = path.split_once('/').unwrap_or((path, ""));
                urdf.packages.find(package, rest, folder, &urdf.path).map_err(|not_found| {
                    missing(format!(
                        "looked at: {}. Say where the package is: packages = {{ {package} = \"folder\" }} in the [[robot]] \
                         table, which `init --package {package}=FOLDER` writes; {kinematics}",
                        not_found.looked
                    ))
                })
            }
            Some((scheme, _)) if scheme != "file" => {
                let help = "a path, file:// or package://".to_owned();
                Err((format!("`{scheme}://` is not known"), help))
            }
            other => {
                let beside = urdf.path.parent().unwrap_or(Path::new(""));
                let path = other.map_or_else(|| beside.join(named), |(_, path)| PathBuf::from(path));
                if !folder.join(&path).is_file() {
                    let looked = folder.join(&path).display().to_string();
                    return Err(missing(format!("put it where it is looked for ({looked}), {kinematics}")));
                }
                Ok(path)
            }
        }
    }

    /// The mesh at `path`, relative to the cell file.
    pub(super) fn mesh_file(&self, path: &Path) -> std::result::Result<Mesh, String> {
        let bytes = self.files.read(self.source.folder(), path);
        let bytes = bytes.map_err(|error| format!("cannot read {}: {error}", path.display()))?;
        mesh::read(path, &bytes).map_err(|error| format!("{}: {error}", path.display()))
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
