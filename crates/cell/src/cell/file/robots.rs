//! Checks of the robots in a cell file: kinematics, link shapes, masses.

use std::ops::Range;
use std::sync::Arc;

use toml::Spanned;

use super::checker::{Checker, pose};
use super::described::{Described, DescribedShape, upright};
use super::format::{CapsuleTable, CellFile, FrameTable, JointTable, LinkTable, MeshTable, RobotTable};
use super::inertias::Places;
use crate::cell::CellError;
use crate::cell::error::nearest;
use crate::cell::workcell::{Driven, FileLine, Kinematics, Link, Robot};
use crate::fmi::number;
use crate::geometry::kinematics::{Joint, KinematicTree, Motion};
use crate::geometry::surface::{Flaw, Triangles};
use crate::geometry::{Capsule, Hull, Mesh, Pose, Solid, Surface, Vec3};
use crate::hazard::criterion::pressure::LinkContact;
use path_clean::clean;

/// Most triangles of a mesh that is taken exactly: arm searches ask for distances from it all the time, and reports carry
/// it.
const MOST_TRIANGLES: usize = 20_000;

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
            let Some((robot, own)) = self.robot(table, number) else { continue };
            robots.push(robot);
            for mut link in own {
                if file.robots.len() > 1 {
                    link.name = format!("{} {}", table.get_ref().name, link.name);
                }
                links.push(link);
            }
        }
        (robots, links)
    }

    fn robot(&self, table: &Spanned<RobotTable>, number: usize) -> Option<(Robot, Vec<Link>)> {
        let robot = table.get_ref();
        let alone = robot.joints.iter().map(|j| &j.name).chain(robot.frames.iter().map(|f| &f.name));
        self.named_once(&alone.collect::<Vec<_>>());
        for joint in &robot.joints {
            let _ = self.problems.keep(self.joint(joint, robot.urdf.is_some()));
        }
        for frame in &robot.frames {
            let _ = self.problems.keep(self.frame(frame));
        }
        let _ = self.problems.keep(self.payload(robot));
        self.problems.keep(self.plausible_robot(robot, &table.span()))?;
        let described = match &robot.urdf {
            Some(path) => Some(self.problems.keep(self.described(robot, path))?),
            None => None,
        };
        let moves = self.that(robot.joints.is_empty() != robot.frames.is_empty(), table.span(), || {
            (
                "the robot needs either joints or frames".to_owned(),
                "add [[robot.joint]] tables, base to tool, or [[robot.frame]] tables if the FMU gives link poses"
                    .to_owned(),
            )
        });
        self.problems.keep(moves)?;
        let mass = self.problems.keep(self.mass(table, described.as_ref()));
        let (shapes, places, mut kinematics) = match described {
            Some(Described { kinematics, shapes, places, .. }) => (shapes, places, Some(kinematics)),
            None => (Vec::new(), places(robot), self.chain(robot)),
        };
        let place = robot.urdf.as_ref().map(|path| self.place(path.span())).unwrap_or_default();
        let of_urdf = |DescribedShape { name, joint, shape, looks }| Link {
            name,
            robot: number,
            joint,
            shape,
            place: place.clone(),
            looks,
            contact: LinkContact::default(),
        };
        let mut links: Vec<Link> = shapes.into_iter().map(of_urdf).collect();
        if let Some(path) = &robot.urdf {
            let hint = "; then a <mesh> has scale=\"0.001 0.001 0.001\"";
            let fits = links.iter().try_for_each(|link| {
                self.of_a_robot(&link.shape, &path.span(), &format!("link `{}`", link.name), hint)
            });
            self.problems.keep(fits)?;
        }
        links.extend(self.problems.keep_all(robot.links.iter().map(|link| self.link(link, number, &places))));
        let _ = self.problems.keep(self.spheres(robot));
        let payload_at = self.problems.keep(self.payload_at(robot, &places, &links));
        if let Some((kinematics, at)) = kinematics.as_mut().zip(payload_at) {
            kinematics.payload_at = at;
        }
        if robot.links.is_empty() && links.is_empty() {
            let (message, help) = match robot.urdf {
                Some(_) if !robot.urdf_shapes => (
                    "the robot has no shapes, and those of the URDF are not used: nothing can be hit",
                    "add [[robot.link]] tables, for instance capsules, to its joints or links",
                ),
                Some(_) => (
                    "no moving link of the URDF has a collision shape: nothing can be hit",
                    "add [[robot.link]] tables, for instance capsules, to its joints or links",
                ),
                None => (
                    "the cell has no robot geometry: without link shapes nothing can be hit",
                    "add [[robot.link]] tables with a `capsule`, `hull_m` or `mesh` each, or name a `urdf`",
                ),
            };
            let error = self.source.error(table.span(), "this robot", message, Some(help.to_owned()));
            self.problems.tell(error);
        }
        let (moving_mass_kg, mass_place) = mass?;
        self.fitting_robot(robot, kinematics.as_ref(), &links, moving_mass_kg);
        let (world_from_base, kinematics) = (pose(&robot.base), kinematics.map(Arc::new));
        Some((Robot { name: robot.name.clone(), world_from_base, kinematics, moving_mass_kg, mass_place }, links))
    }

    fn named_once(&self, names: &[&Spanned<String>]) {
        for (number, name) in names.iter().enumerate() {
            let alone = names[..number].iter().all(|other| other.get_ref() != name.get_ref());
            let _ = self.problems.keep(self.that(alone, name.span(), || {
                let message = format!("two joints or frames are called `{}`", name.get_ref());
                (message, "give each its own name".to_owned())
            }));
        }
    }

    fn payload(&self, robot: &RobotTable) -> Result<(), Box<CellError>> {
        let Some(payload) = &robot.payload_kg else { return Ok(()) };
        let kg = *payload.get_ref();
        self.that(kg.is_finite() && kg >= 0.0, payload.span(), || {
            (format!("payload_kg is {}", number(kg)), "use zero or more kilograms".to_owned())
        })
    }

    fn place(&self, span: Range<usize>) -> FileLine {
        let base = self.source.base_at(span.start).map(|base| base.path.clone());
        FileLine { base, line: self.source.line(span.start) }
    }

    /// The moving mass, kg, and the line that says so.
    fn mass(
        &self,
        table: &Spanned<RobotTable>,
        described: Option<&Described>,
    ) -> Result<(f64, FileLine), Box<CellError>> {
        let robot = table.get_ref();
        if let Some(mass) = &robot.moving_mass_kg {
            self.positive(*mass.get_ref(), &mass.span(), "the moving mass of the robot")?;
            return Ok((*mass.get_ref(), self.place(mass.span())));
        }
        let told = described.and_then(|urdf| urdf.moving_mass_kg).zip(robot.urdf.as_ref());
        if let Some((kg, path)) = told {
            return Ok((kg, self.place(path.span())));
        }
        let message = match robot.urdf {
            Some(_) => "the URDF does not say how heavy what moves is",
            None => "the robot has no moving mass",
        };
        let help = "add moving_mass_kg: the mass of all moving parts, from the robot's data sheet".to_owned();
        Err(self.source.error(table.span(), "this robot", message, Some(help)))
    }

    /// What a joint's table says, whatever moves it.
    fn joint(&self, joint: &JointTable, in_urdf: bool) -> Result<(), Box<CellError>> {
        let name = joint.name.get_ref();
        let held = [joint.held_deg, joint.held_m];
        let ways = [joint.angle.is_some(), joint.position.is_some(), held[0].is_some(), held[1].is_some()];
        self.that(ways.iter().filter(|way| **way).count() == 1, joint.name.span(), || {
            (
                format!("joint `{name}` needs one of angle, position, held_deg and held_m"),
                "angle = { variable = \"...\" } for a joint that turns, position for a slide, held_deg or held_m for one \
                 that stays where it is"
                    .to_owned(),
            )
        })?;
        self.that(held.iter().flatten().all(|v| v.is_finite()), joint.name.span(), || {
            (format!("joint `{name}` is held nowhere"), "write a plain number".to_owned())
        })?;
        let still = held.iter().any(Option::is_some);
        self.that(!still || joint.speed.is_none(), joint.name.span(), || {
            (format!("joint `{name}` is held and has a speed"), "remove one of the two".to_owned())
        })?;
        if let Some(span) = joint.axis.as_ref().map(Spanned::span).or(joint.origin.as_ref().map(Spanned::span)) {
            self.that(!in_urdf, span, || {
                (
                    format!("the URDF says where joint `{name}` is and how it moves"),
                    "remove `axis` and `origin` here".to_owned(),
                )
            })?;
        }
        match &joint.axis {
            Some(axis) => {
                let direction = Vec3::from_array(*axis.get_ref());
                self.that(direction.is_finite() && direction.length() > 1e-9, axis.span(), || {
                    (format!("the axis of joint `{name}` has no direction"), "for instance axis = [0, 0, 1]".to_owned())
                })
            }
            None => self.that(in_urdf, joint.name.span(), || {
                (format!("joint `{name}` has no axis"), "for instance axis = [0, 0, 1]".to_owned())
            }),
        }
    }

    fn frame(&self, frame: &FrameTable) -> Result<(), Box<CellError>> {
        let name = frame.name.get_ref();
        self.that(frame.quaternion.is_none() || frame.rotation_matrix.is_none(), frame.name.span(), || {
            (format!("frame `{name}` has a quaternion and a rotation matrix"), "keep one of the two".to_owned())
        })?;
        let oriented = frame.quaternion.is_some() || frame.rotation_matrix.is_some();
        self.that(oriented || frame.angular_velocity.is_none(), frame.name.span(), || {
            (
                format!("frame `{name}` has an angular velocity and no orientation"),
                "add `quaternion` or `rotation_matrix`, or remove `angular_velocity`".to_owned(),
            )
        })
    }

    /// The joints of the cell file, each on the one before; none if there are frames.
    fn chain(&self, robot: &RobotTable) -> Option<Kinematics> {
        let mut tree = KinematicTree { world_from_base: pose(&robot.base), joints: Vec::new() };
        let mut driven = Vec::new();
        for (number, joint) in robot.joints.iter().enumerate() {
            let axis = Vec3::from_array(*joint.axis.as_ref()?.get_ref());
            let slides = joint.position.is_some() || joint.held_m.is_some();
            tree.joints.push(Joint {
                parent: number.checked_sub(1),
                parent_from_joint: joint.origin.as_ref().map_or(Pose::IDENTITY, |origin| pose(origin.get_ref())),
                motion: if slides { Motion::Prismatic } else { Motion::Revolute },
                axis: axis / axis.length(),
            });
            driven.push(Driven { named: number, factor: 1.0, offset: 0.0 });
        }
        let spread = robot.joints.iter().map(|joint| self.spread(joint)).collect();
        let masses = self.masses(robot, spread, &driven);
        let (fastest, ranges) = (vec![None; driven.len()], vec![None; driven.len()]);
        let payload_at = (0, Vec3::ZERO);
        (!robot.joints.is_empty()).then_some(Kinematics { tree, driven, fastest, ranges, masses, payload_at })
    }

    /// What moves that is named so.
    pub(super) fn carrier(&self, named: &Spanned<String>, places: &Places) -> Result<(usize, Pose), Box<CellError>> {
        let wanted = named.get_ref();
        places.get(wanted).copied().ok_or_else(|| {
            let names = || places.keys().map(String::as_str);
            let help = match nearest(wanted, names()) {
                Some(name) => format!("did you mean `{name}`?"),
                None => format!("what moves is {}", names().collect::<Vec<_>>().join(", ")),
            };
            let message = format!("there is no joint `{wanted}` that moves");
            self.source.error(named.span(), "here", message, Some(help))
        })
    }

    fn link(&self, link: &LinkTable, robot: usize, places: &Places) -> Result<Link, Box<CellError>> {
        let (joint, joint_from_place) = self.carrier(&link.joint, places)?;
        let span = link.joint.span();
        let shape = match (&link.capsule, &link.hull_m, &link.mesh) {
            (Some(capsule), None, None) => Solid::Capsule(self.capsule(capsule, &span)?),
            (None, Some(points), None) => {
                let list: Vec<Vec3> = points.get_ref().iter().map(|p| Vec3::from_array(*p)).collect();
                self.hull_of(&list, &points.span())?
            }
            (None, None, Some(mesh)) => self.mesh(mesh)?,
            _ => {
                let message = format!("link `{}` needs one shape: `capsule`, `hull_m` or `mesh`", link.name);
                let help = "several shapes of one link are several [[robot.link]] tables of one name".to_owned();
                return Err(self.source.error(span, "in this link", message, Some(help)));
            }
        };
        let shape = if joint_from_place == Pose::IDENTITY { shape } else { shape.placed(joint_from_place) };
        self.of_a_robot(&shape, &span, &format!("link `{}`", link.name), "")?;
        let contact = match &link.contact {
            Some(table) => self.link_contact(table)?,
            None => LinkContact::default(),
        };
        let (name, place) = (link.name.clone(), self.place(span));
        Ok(Link { name, robot, joint, shape, place, looks: Vec::new(), contact })
    }

    /// Whether shapes of parts that are known by a point alone are spheres around it.
    fn spheres(&self, robot: &RobotTable) -> Result<(), Box<CellError>> {
        let turned = |frame: &&FrameTable| frame.quaternion.is_some() || frame.rotation_matrix.is_some();
        for frame in robot.frames.iter().filter(|frame| !turned(frame)) {
            for link in robot.links.iter().filter(|link| link.joint.get_ref() == frame.name.get_ref()) {
                let centred = |capsule: &CapsuleTable| capsule.from_m == [0.0; 3] && capsule.to_m == [0.0; 3];
                self.that(link.capsule.as_ref().is_some_and(centred), link.joint.span(), || {
                    let message = format!("how frame `{}` is turned is not known", frame.name.get_ref());
                    let help = "give it a sphere: capsule = { from_m = [0, 0, 0], to_m = [0, 0, 0], radius_m = ... }; or \
                                give the frame a `quaternion` or `rotation_matrix`";
                    (message, help.to_owned())
                })?;
            }
        }
        Ok(())
    }

    fn hull_of(&self, points: &[Vec3], span: &Range<usize>) -> Result<Solid, Box<CellError>> {
        let hull = Hull::from_points(points).ok_or_else(|| {
            let help = "give at least four corner points that are not in one plane".to_owned();
            self.source.error(span.clone(), "here", "these points have no convex hull with volume", Some(help))
        })?;
        Ok(Solid::Hull(hull))
    }

    fn mesh(&self, mesh: &MeshTable) -> Result<Solid, Box<CellError>> {
        let span = mesh.file.span();
        self.positive(mesh.metres_per_unit, &span, "metres_per_unit")?;
        let read = self.mesh_file(&clean(mesh.file.get_ref())).map_err(|message| {
            let help = "the path is relative to the cell file; STL and OBJ are read".to_owned();
            self.source.error(span.clone(), "named here", message, Some(help))
        })?;
        let corner = |point: &Vec3| pose(&mesh.at) * upright(*point, mesh.metres_per_unit, mesh.up);
        let points: Vec<Vec3> = read.points.iter().map(corner).collect();
        let [low, high] = [Vec3::min, Vec3::max].map(|end| points.iter().copied().reduce(end).unwrap_or_default());
        let ends = Solid::Capsule(Capsule { a: low, b: high, radius: 0.0 });
        self.of_a_robot(&ends, &span, "this mesh", "; then metres_per_unit is 0.001")?;
        if mesh.exact { self.exactly(&points, &read.triangles, &span) } else { self.hull_of(&points, &span) }
    }

    /// A mesh as it is, which has to be closed.
    fn exactly(&self, points: &[Vec3], triangles: &[[u32; 3]], span: &Range<usize>) -> Result<Solid, Box<CellError>> {
        let triangles = Triangles::merged(points, triangles);
        let count = triangles.triangles.len();
        self.that(count <= MOST_TRIANGLES, span.clone(), || {
            let message = format!("the mesh has {count} triangles; exactly taken it may have {MOST_TRIANGLES}");
            (message, "make it coarser in CAD, or leave out `exact`: then its convex hull is taken".to_owned())
        })?;
        let surface = Surface::new(triangles).map_err(|flaw| {
            let message = match flaw {
                Flaw::Open(edges) => {
                    format!("the mesh is not closed: {edges} of its edges have a triangle on one side only")
                }
                Flaw::Turned(edges) => format!("the mesh is turned inside out in parts, at {edges} of its edges"),
                Flaw::Flat => "the mesh holds no volume".to_owned(),
            };
            let help =
                "what is inside is not known then: mend it in CAD, or leave out `exact`: then its convex hull is taken";
            self.source.error(span.clone(), "named here", message, Some(help.to_owned()))
        })?;
        Ok(Solid::Mesh(Mesh::new(Arc::new(surface), Pose::IDENTITY)))
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

/// What shapes may be attached to without a URDF: joints, or frames.
fn places(robot: &RobotTable) -> Places {
    let joints = robot.joints.iter().map(|joint| &joint.name).enumerate();
    let frames = robot.frames.iter().map(|frame| &frame.name).enumerate();
    joints.chain(frames).map(|(number, name)| (name.get_ref().clone(), (number, Pose::IDENTITY))).collect()
}
