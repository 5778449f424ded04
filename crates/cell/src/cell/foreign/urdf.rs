//! Robot descriptions in URDF: links with masses and collision shapes, joints that turn, slide or are fixed.
//!
//! Format: the ROS documentation of URDF (`wiki.ros.org/urdf/XML`). What decides where a link is or how heavy it is must
//! be understood. Meshes to look at are kept where they can be read; anything else (materials, transmissions, sensors) is
//! passed over. Lengths in m, angles in rad,
//! masses in kg.

use std::ops::Range;

use roxmltree::Node;

use super::xml::{Result, Xml, child, children};
use crate::cell::error::{Source, nearest};
use crate::fmi::number;
use crate::geometry::kinematics::Motion;
use crate::geometry::{Inertia, Pose, Vec3, roll_pitch_yaw};

/// A robot description.
#[derive(Debug)]
pub(in crate::cell) struct Urdf {
    pub links: Vec<Link>,
    /// Joints, each after the one that carries its parent link.
    pub joints: Vec<Joint>,
}

/// A link.
#[derive(Debug)]
pub(in crate::cell) struct Link {
    pub name: String,
    /// Mass, kg; nothing if it has no inertial.
    pub mass_kg: Option<f64>,
    /// How it is spread.
    pub inertia: Tensor,
    /// Collision shapes in the link's frame.
    pub shapes: Vec<(Pose, Shape)>,
    /// Meshes to look at, in the link's frame.
    pub looks: Vec<(Pose, Look)>,
    /// Whether it can be seen and has no collision shape.
    pub only_seen: bool,
}

impl Link {
    /// Whether it is more than a frame.
    pub(crate) fn is_there(&self) -> bool {
        self.only_seen || !self.shapes.is_empty()
    }
}

/// How the mass of a link is spread.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::cell) enum Tensor {
    /// That is not told, or all of it is 0, as in files that tell masses alone.
    Untold,
    /// As in no body.
    Wrong,
    /// So, in the link's frame.
    Given(Inertia),
}

/// A collision shape.
#[derive(Debug)]
pub(in crate::cell) enum Shape {
    /// Edge lengths.
    Box([f64; 3]),
    /// Around z, centred.
    Cylinder { radius: f64, length: f64 },
    /// Around z, centred, with a half sphere beyond each end (an extension that several readers know).
    Capsule { radius: f64, length: f64 },
    /// Centred.
    Sphere { radius: f64 },
    /// A file, scaled.
    Mesh { file: String, scale: [f64; 3], place: Range<usize> },
}

/// A mesh to look at.
#[derive(Debug)]
pub(in crate::cell) struct Look {
    pub file: String,
    pub scale: [f64; 3],
}

/// A joint.
#[derive(Debug)]
pub(in crate::cell) struct Joint {
    pub name: String,
    /// Nothing for one that is fixed.
    pub motion: Option<Motion>,
    /// Index of the link that carries it.
    pub parent: usize,
    /// Index of the link that it carries.
    pub child: usize,
    /// `parent_from_joint` at zero.
    pub origin: Pose,
    /// Unit axis.
    pub axis: Vec3,
    /// Name of the joint that it follows, factor and offset.
    pub mimic: Option<(String, f64, f64)>,
    /// The fastest that it may move, rad/s or m/s; nothing if it is not told, or told as 0, as many files do that have
    /// no figure.
    pub fastest: Option<f64>,
    /// The least and the greatest position that it may have, rad or m, where both are told and are not the same.
    pub range: Option<[f64; 2]>,
}

/// What to do with a file that is none yet.
const EXPAND: &str = "a xacro file has to be expanded first: `xacro robot.urdf.xacro > robot.urdf`";

/// Reads a URDF file.
///
/// # Errors
/// What is no XML, misses what is needed, or is no tree, with its line.
pub(in crate::cell) fn read(source: &Source) -> Result<Urdf> {
    let reader = Xml { source };
    let document = reader.parse(EXPAND)?;
    let root = document.root_element();
    if !root.has_tag_name("robot") {
        return Err(reader.wrong(root, "the file has no <robot> at its top", "give a URDF file"));
    }
    let is_macro = |node: &Node<'_, '_>| node.tag_name().namespace().is_some_and(|of| of.contains("xacro"));
    if let Some(node) = root.descendants().find(is_macro) {
        return Err(reader.wrong(node, "it is xacro, whose macros have to be expanded first", EXPAND));
    }
    let links: Vec<(Node<'_, '_>, Link)> =
        children(root, "link").map(|node| Ok((node, reader.link(node)?))).collect::<Result<_>>()?;
    for (number, (node, link)) in links.iter().enumerate() {
        if links[..number].iter().any(|(_, other)| other.name == link.name) {
            return Err(reader.wrong(*node, format!("two links are called `{}`", link.name), "rename one of them"));
        }
    }
    let names: Vec<&str> = links.iter().map(|(_, link)| link.name.as_str()).collect();
    let joints: Vec<(Node<'_, '_>, Joint)> =
        children(root, "joint").map(|node| Ok((node, reader.joint(node, &names)?))).collect::<Result<_>>()?;
    let joints = reader.sorted(joints, &names)?;
    Ok(Urdf { links: links.into_iter().map(|(_, link)| link).collect(), joints })
}

impl Xml<'_> {
    /// A number that has to be there and greater than zero.
    fn length(&self, node: Node<'_, '_>, attribute: &str) -> Result<f64> {
        let text = self.text(node, attribute)?;
        let [value] = self.numbers(node, attribute, [0.0])?;
        if value > 0.0 {
            return Ok(value);
        }
        Err(self.wrong(node, format!("`{attribute}` is {text}"), "a length is greater than zero"))
    }

    fn origin(&self, node: Node<'_, '_>) -> Result<Pose> {
        let Some(origin) = child(node, "origin") else { return Ok(Pose::IDENTITY) };
        let xyz = self.numbers(origin, "xyz", [0.0; 3])?;
        let rpy = self.numbers(origin, "rpy", [0.0; 3])?;
        Ok(Pose::from_parts(Vec3::from_array(xyz), roll_pitch_yaw(rpy)))
    }

    fn link(&self, node: Node<'_, '_>) -> Result<Link> {
        let name = self.text(node, "name")?.to_owned();
        let mass = child(node, "inertial").and_then(|inertial| child(inertial, "mass"));
        let mass_kg = mass.map(|mass| {
            let _ = self.text(mass, "value")?;
            let [kg] = self.numbers(mass, "value", [0.0])?;
            if kg < 0.0 {
                return Err(self.wrong(
                    mass,
                    format!("the mass of link `{name}` is {} kg", number(kg)),
                    "zero or more",
                ));
            }
            Ok(kg)
        });
        let mass_kg = mass_kg.transpose()?;
        let inertia = mass_kg.map_or(Tensor::Untold, |kg| self.inertia(node, kg).unwrap_or(Tensor::Untold));
        let shapes = children(node, "collision").map(|node| Ok((self.origin(node)?, self.shape(node)?)));
        let shapes = shapes.collect::<Result<Vec<_>>>()?;
        let only_seen = shapes.is_empty() && child(node, "visual").is_some();
        let looks = children(node, "visual").filter_map(|node| self.look(node)).collect();
        Ok(Link { mass_kg, inertia, shapes, looks, only_seen, name })
    }

    /// How a link's mass is spread. No verdict depends on it: what cannot be read of it is no mistake in the robot.
    fn inertia(&self, link: Node<'_, '_>, mass_kg: f64) -> Option<Tensor> {
        let inertial = child(link, "inertial")?;
        let tensor = child(inertial, "inertia")?;
        let entry = |name| self.numbers(tensor, name, [0.0]).map(|[value]| value);
        let entries = ["ixx", "iyy", "izz", "ixy", "ixz", "iyz"].map(entry);
        let (Ok(link_from_body), [Ok(xx), Ok(yy), Ok(zz), Ok(xy), Ok(xz), Ok(yz)]) = (self.origin(inertial), entries)
        else {
            return Some(Tensor::Wrong);
        };
        if [xx, yy, zz, xy, xz, yz].iter().all(|entry| *entry == 0.0) {
            return None;
        }
        let inertia = Inertia::new(mass_kg, Vec3::ZERO, [xx, yy, zz], [xy, xz, yz]);
        let real = mass_kg > 0.0 && inertia.is_semidefinite() && inertia.is_of_a_body();
        Some(if real { Tensor::Given(inertia.placed(link_from_body)) } else { Tensor::Wrong })
    }

    /// What a visual shows, if that is a mesh. Nothing depends on it: a mistake in it is none of the robot.
    fn look(&self, visual: Node<'_, '_>) -> Option<(Pose, Look)> {
        let mesh = child(child(visual, "geometry")?, "mesh")?;
        let look = Look {
            file: self.text(mesh, "filename").ok()?.to_owned(),
            scale: self.numbers(mesh, "scale", [1.0; 3]).ok()?,
        };
        Some((self.origin(visual).ok()?, look))
    }

    fn shape(&self, collision: Node<'_, '_>) -> Result<Shape> {
        let geometry = child(collision, "geometry");
        let Some(node) = geometry.and_then(|geometry| geometry.children().find(Node::is_element)) else {
            return Err(self.wrong(collision, "this collision has no shape", "add <geometry> with a shape in it"));
        };
        match node.tag_name().name() {
            "box" => {
                let _ = self.text(node, "size")?;
                let size = self.numbers(node, "size", [0.0; 3])?;
                if size.iter().all(|edge| *edge > 0.0) {
                    return Ok(Shape::Box(size));
                }
                Err(self.wrong(node, "an edge of this box has no length", "three lengths greater than zero"))
            }
            "cylinder" => {
                let (radius, length) = (self.length(node, "radius")?, self.length(node, "length")?);
                Ok(Shape::Cylinder { radius, length })
            }
            "capsule" => {
                let (radius, length) = (self.length(node, "radius")?, self.length(node, "length")?);
                Ok(Shape::Capsule { radius, length })
            }
            "sphere" => Ok(Shape::Sphere { radius: self.length(node, "radius")? }),
            "mesh" => Ok(Shape::Mesh {
                file: self.text(node, "filename")?.to_owned(),
                scale: self.numbers(node, "scale", [1.0; 3])?,
                place: node.range(),
            }),
            other => {
                let help = "box, cylinder, capsule, sphere and mesh are known";
                Err(self.wrong(node, format!("the shape <{other}> is not known"), help))
            }
        }
    }

    fn joint(&self, node: Node<'_, '_>, links: &[&str]) -> Result<Joint> {
        let name = self.text(node, "name")?.to_owned();
        let motion = match self.text(node, "type")? {
            "fixed" => None,
            "revolute" | "continuous" => Some(Motion::Revolute),
            "prismatic" => Some(Motion::Prismatic),
            other => {
                let help = "fixed, revolute, continuous and prismatic are known";
                return Err(self.wrong(node, format!("joint `{name}` is of type `{other}`"), help));
            }
        };
        let end = |tag: &'static str| {
            let missing = || self.wrong(node, format!("joint `{name}` has no <{tag}>"), "name a link");
            let end = child(node, tag).ok_or_else(missing)?;
            let wanted = self.text(end, "link")?;
            links.iter().position(|link| *link == wanted).ok_or_else(|| {
                let help = nearest(wanted, links.iter().copied());
                let help = help.map_or_else(|| "add it".to_owned(), |near| format!("did you mean `{near}`?"));
                self.wrong(end, format!("there is no link `{wanted}`"), help)
            })
        };
        let (parent, carried) = (end("parent")?, end("child")?);
        let axis = match child(node, "axis") {
            Some(axis) => Vec3::from_array(self.numbers(axis, "xyz", [1.0, 0.0, 0.0])?),
            None => Vec3::X,
        };
        // The axis of a fixed joint means nothing, and is 0 0 0 in many files.
        let axis = if motion.is_some() { axis.try_normalize() } else { Some(Vec3::X) };
        let Some(axis) = axis else {
            return Err(self.wrong(node, format!("the axis of joint `{name}` has no direction"), "xyz=\"0 0 1\", say"));
        };
        let mimic = child(node, "mimic").map(|mimic| -> Result<_> {
            let of = self.text(mimic, "joint")?.to_owned();
            let [factor] = self.numbers(mimic, "multiplier", [1.0])?;
            let [offset] = self.numbers(mimic, "offset", [0.0])?;
            Ok((of, factor, offset))
        });
        let mimic = mimic.transpose()?;
        // Nothing that decides where a link is: what is no figure here is no mistake.
        let limit =
            |name: &str| child(node, "limit").and_then(|limit| limit.attribute(name)?.trim().parse::<f64>().ok());
        let fastest = limit("velocity").filter(|velocity| velocity.is_finite() && *velocity > 0.0);
        let range = limit("lower").zip(limit("upper")).map(<[f64; 2]>::from);
        let range = range.filter(|[low, high]| low < high && node.attribute("type") != Some("continuous"));
        Ok(Joint { motion, parent, child: carried, origin: self.origin(node)?, axis, mimic, fastest, range, name })
    }

    /// The joints, each after the one that carries it.
    fn sorted(&self, joints: Vec<(Node<'_, '_>, Joint)>, links: &[&str]) -> Result<Vec<Joint>> {
        for (number, (node, joint)) in joints.iter().enumerate() {
            let before = &joints[..number];
            if before.iter().any(|(_, other)| other.name == joint.name) {
                let message = format!("two joints are called `{}`", joint.name);
                return Err(self.wrong(*node, message, "rename one of them"));
            }
            if before.iter().any(|(_, other)| other.child == joint.child) {
                let message = format!("link `{}` is carried by two joints", links[joint.child]);
                return Err(self.wrong(*node, message, "a URDF robot is a tree: remove one of them"));
            }
            if let Some((of, ..)) = &joint.mimic
                && !joints.iter().any(|(_, other)| other.name == *of && other.mimic.is_none() && other.motion.is_some())
            {
                let message = format!("joint `{}` mimics `{of}`, which is no moving joint of its own", joint.name);
                return Err(self.wrong(*node, message, "name a joint that moves"));
            }
        }
        let carried: Vec<usize> = joints.iter().map(|(_, joint)| joint.child).collect();
        let mut reached: Vec<usize> = (0..links.len()).filter(|link| !carried.contains(link)).collect();
        let mut left = joints;
        let mut sorted = Vec::with_capacity(left.len());
        while !left.is_empty() {
            let Some(next) = left.iter().position(|(_, joint)| reached.contains(&joint.parent)) else {
                let (node, joint) = &left[0];
                let message = format!("joint `{}` is part of a loop", joint.name);
                return Err(self.wrong(*node, message, "a URDF robot is a tree"));
            };
            let (_, joint) = left.remove(next);
            reached.push(joint.child);
            sorted.push(joint);
        }
        Ok(sorted)
    }
}
