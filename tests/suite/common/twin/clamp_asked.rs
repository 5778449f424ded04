//! The program asked about a scene: a cell whose FMU tells poses and velocities of frames, which here are numbers of the scene.

use std::convert::Infallible;
use std::fmt::Write as _;
use std::path::Path;
use std::sync::Arc;

use fmi_hazard::cell::workcell::Obstacle;
use fmi_hazard::cell::{Binding, Workcell};
use fmi_hazard::geometry::{Capsule, Cuboid, Matrix3, Rotation, Solid, Vec3};
use fmi_hazard::human::{Place, Posture, Start};
use fmi_hazard::scan::prepare::prepare;
use fmi_hazard::sim::Coverage;
use fmi_hazard::sim::robot::RobotFrame;
use fmi_hazard::sim::world::{Frames, Hit, IfSignalled, Instant, PersonState, SignalledRuns, Window, World};

use super::body::Body;
use super::clamp_scenes::{CARRIERS, Case};
use super::geometry::{M3, V3, length, sub, turned_back};

/// Robot and frame of each carrier, and links in their order.
const CELL: [(&str, &[usize]); 2] = [("a", &[0, 1]), ("b", &[2])];

/// A cell with the frames and links of the scenes, what of it is unsafe, and the FMU that has such outputs.
pub struct Asked {
    cell: Workcell,
    binding: Arc<Binding>,
    /// Name of each output.
    outputs: Vec<String>,
}

/// No planes, no other runs.
struct Never;

impl SignalledRuns for Never {
    type Error = Infallible;

    fn told_of(&mut self, _: &[Window]) -> Result<IfSignalled<Frames>, Infallible> {
        unreachable!("there are no planes")
    }
}

fn vec3(v: V3) -> Vec3 {
    Vec3::from_array(v)
}

fn rotation(m: &M3) -> Rotation {
    Rotation::from_mat3(&Matrix3::from_cols_array_2d(m).transpose())
}

const POSTURES: [Posture; 6] =
    [Posture::Upright, Posture::Forward, Posture::Left, Posture::Right, Posture::ForwardLeft, Posture::ForwardRight];

impl Asked {
    /// With these lines of `[criteria]`; `folder` holds the example `head-collision`.
    pub fn new(folder: &Path, criteria: &str) -> Self {
        let mut text = format!(
            "schema = 1\nname = \"clamped\"\nfmu = \"head-collision.fmu\"\n[criteria]\n{criteria}\n[inputs]\n\
             \"plc.reset\" = false\n[human]\nstart = {{ xy_m = [0, -1.9], heading_deg = 90 }}\n"
        );
        for (robot, frames) in CELL {
            write!(text, "[[robot]]\nname = \"{robot}\"\nmoving_mass_kg = 20\npayload_kg = 2\n").unwrap();
            for frame in frames {
                write!(text, "[[robot.frame]]\nname = \"f{frame}\"\n").unwrap();
                let quantities = [
                    ("position", "x y z"),
                    ("quaternion", "qw qx qy qz"),
                    ("velocity", "vx vy vz"),
                    ("angular_velocity", "wx wy wz"),
                ];
                for (key, parts) in quantities {
                    let names = parts.split(' ').map(|part| format!("\"robot.link[{}].{part}\"", frame + 1));
                    writeln!(text, "{key} = [{}]", names.collect::<Vec<_>>().join(", ")).unwrap();
                }
            }
            for (link, _) in CARRIERS.iter().enumerate().filter(|(_, carrier)| frames.contains(carrier)) {
                write!(
                    text,
                    "[[robot.link]]\nname = \"l{link}\"\nframe = \"f{}\"\ncapsule = {{ from_m = [0, 0, 0], to_m = [0, \
                     0, 0.1], radius_m = 0.05 }}\n",
                    CARRIERS[link]
                )
                .unwrap();
            }
        }
        let path = folder.join("clamped.toml");
        std::fs::write(&path, text).unwrap();
        let prepared = prepare(&path, None).unwrap_or_else(|error| panic!("{error}"));
        let outputs = prepared.binding.outputs.iter().map(|port| port.port.name.clone()).collect();
        Self { cell: (*prepared.cell).clone(), binding: prepared.binding.clone(), outputs }
    }

    fn row(&self, case: &Case) -> Vec<f64> {
        let value = |name: &String| {
            let (number, part) = name.strip_prefix("robot.link[").unwrap().split_once("].").unwrap();
            let frame = &case.frames[number.parse::<usize>().unwrap() - 1];
            let (s, c) = (libm::sin(0.5 * frame.angle), libm::cos(0.5 * frame.angle));
            let axis = |letter: &str| usize::from(letter.as_bytes()[0] - b'x');
            match part.split_at(part.len() - 1) {
                ("", letter) => frame.origin[axis(letter)],
                ("q", "w") => c,
                ("q", letter) => s * frame.axis[axis(letter)],
                ("v", letter) => frame.velocity[axis(letter)],
                ("w", letter) => frame.spin[axis(letter)],
                other => panic!("{other:?}"),
            }
        };
        self.outputs.iter().map(value).collect()
    }

    /// What the program says of a scene, and the body as it has it: bends are cut back by its boxes, which is not what is
    /// looked at here. `any`: not the worst.
    pub fn says(&self, case: &Case, any: bool) -> (Option<Hit>, Body) {
        let mut cell = self.cell.clone();
        cell.start = Start::new(case.xy[0], case.xy[1], case.heading_deg);
        let boxes = case.scene.blocks.iter().enumerate();
        let boxes = boxes.map(|(i, b)| {
            let cuboid = Cuboid { centre: vec3(b.centre), half: vec3(b.half), rotation: rotation(&b.rotation) };
            Obstacle { name: format!("o{i}"), cuboid, table: None, opened_by: None, follows: None }
        });
        cell.obstacles = boxes.collect();
        for (robot, m_r) in cell.robots.iter_mut().zip(case.masses) {
            robot.moving_mass_kg = 2.0 * (m_r - 2.0);
        }
        for (i, link) in cell.links.iter_mut().enumerate() {
            assert!(link.name.ends_with(&format!("l{i}")), "{}", link.name);
            let (frame, one) = (&case.frames[CARRIERS[i]], &case.scene.links[i]);
            let [a, b] = one.core.map(|p| vec3(turned_back(&frame.rotation(), sub(p, frame.origin))));
            link.shape = Solid::Capsule(Capsule { a, b, radius: one.radius });
        }
        let (cell, binding) = (Arc::new(cell), Arc::clone(&self.binding));
        let frame = RobotFrame::new(&cell, &binding, &self.row(case));
        for (link, one) in frame.links.iter().zip(&case.scene.links) {
            let Solid::Capsule(capsule) = link else { panic!("a capsule") };
            assert!((capsule.a - vec3(one.core[0])).length() < 1e-9 && (capsule.b - vec3(one.core[1])).length() < 1e-9);
        }
        let world = World::new(cell, binding);
        let world = if any { world.content_with_any() } else { world };
        let stance = PersonState {
            who: fmi_hazard::human::Who::First,
            place: Place::START,
            posture: POSTURES[case.posture],
            moved: i8::from(case.walks),
            broken: Vec::new(),
            raised: None,
            struck: false,
        };
        let placed = world.first.body_of(&stance);
        let turned = placed.world_from_trunk().rotation;
        let columns = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| (turned * axis).to_array());
        let trunk = [0, 1, 2].map(|i| [0, 1, 2].map(|j: usize| columns[j][i]));
        let body = Body::posed(case.xy, &case.legs(), trunk, 16);
        for ((_, theirs), ours) in placed.parts().iter().zip(&body.parts) {
            let ends = [theirs.a, theirs.b].map(|end| end.to_array());
            let apart = ends.into_iter().zip(ours.core).map(|(a, b)| length(sub(a, b))).fold(0.0, f64::max);
            assert!(apart < 1e-9 && (theirs.radius - ours.radius).abs() < 1e-12, "{theirs:?} {ours:?}");
        }
        let frames: Frames = Arc::from([Arc::new(frame)]);
        let mut coverage = Coverage::new(0);
        let mut instant = Instant { frames: &frames, i: 0, earlier: Never };
        let Ok(hit) = world.first.contact(&stance, &mut instant, &mut coverage);
        assert_eq!(coverage.arm_checks_incomplete, 0);
        (hit, body)
    }
}
