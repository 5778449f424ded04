//! Runs of the FMU, each on a fresh instance, and where the links are then and how they move.

use std::collections::BTreeMap;
use std::rc::Rc;

use fmi_hazard::fmi::{Fmu, Plan, Slave};

use super::cell::Cell;
use super::geometry::{M3, V3, about, add, between, cross, length, nearest, product, scaled, sub, turned};

/// A capsule of the robot at an instant, with what is needed for velocities of its points.
#[derive(Debug, Clone)]
pub struct Link {
    pub name: String,
    pub core: [V3; 2],
    pub radius: f64,
    origin: V3,
    velocity: V3,
    pub spin: V3,
    /// Pieces of the core, 50 mm at most, and the highest speed of a point of the link around each.
    pub pieces: Vec<([V3; 2], f64)>,
}

impl Link {
    /// The velocity of a point of the link.
    pub fn moves(&self, point: V3) -> V3 {
        add(self.velocity, cross(self.spin, sub(point, self.origin)))
    }

    pub fn speed(&self, point: V3) -> f64 {
        length(self.moves(point))
    }

    pub fn top_speed(&self) -> f64 {
        self.pieces.iter().map(|piece| piece.1).fold(0.0, f64::max)
    }

    /// The point of the surface that is nearest to a segment, and the signed distance between the two.
    pub fn surface(&self, segment: [V3; 2]) -> (V3, f64) {
        let (p, q) = nearest(segment, self.core);
        let d = length(sub(p, q));
        // Cores that cross have no nearest point of the surface: the crossing is taken.
        if d == 0.0 { (q, -self.radius) } else { (add(q, scaled(sub(p, q), self.radius / d)), d - self.radius) }
    }

    fn cut(mut self) -> Self {
        let mut pieces = 1_u32;
        while length(sub(self.core[1], self.core[0])) / f64::from(pieces) > 0.05 {
            pieces += 1;
        }
        let at = |i: u32| between(self.core[0], self.core[1], f64::from(i) / f64::from(pieces));
        self.pieces = (0..pieces)
            .map(|i| {
                let core = [at(i), at(i + 1)];
                let fastest = self.speed(core[0]).max(self.speed(core[1])) + length(self.spin) * self.radius;
                (core, fastest)
            })
            .collect();
        self
    }
}

/// All links at the end of a step.
#[derive(Debug)]
pub struct Robot {
    /// Runs with the same outputs have the same number.
    pub number: usize,
    pub links: Vec<Link>,
    /// m_R = M/2 + m_L, kg.
    pub effective_mass: f64,
}

/// The FMU, and the robot after each history of inputs that was asked for.
pub struct Runs {
    slave: Slave,
    inputs: Vec<String>,
    outputs: Vec<String>,
    fmu: Fmu,
    after: BTreeMap<History, Rc<Robot>>,
    numbers: BTreeMap<Vec<u64>, Rc<Robot>>,
    /// Fresh instances made.
    pub instances: u64,
}

/// Bit `i` is set where the input of sensor `i` reads "person"; and the bits of where the person is.
pub type History = Vec<Input>;
pub type Input = (u8, [u64; 2]);

impl Runs {
    pub fn new(cell: &Cell) -> Self {
        let fmu = Fmu::open(&cell.fmu).expect("the FMU opens");
        let mut inputs: Vec<String> = cell.sensors.iter().map(|s| s.variable.clone()).collect();
        inputs.sort();
        inputs.dedup();
        inputs.extend(cell.pose.iter().map(|(name, _)| name.clone()));
        let of_joints = cell.joints.iter().flat_map(|j| [j.value.variable.clone(), j.speed.variable.clone()]);
        let of_frames = cell.frames.iter().flat_map(|f| f.variables.iter().cloned());
        let outputs = of_joints.chain(of_frames).chain(cell.payload.clone()).collect();
        let slave = fmu.load().expect("the FMU loads");
        Self { slave, inputs, outputs, fmu, after: BTreeMap::new(), numbers: BTreeMap::new(), instances: 0 }
    }

    /// The robot at the end of the last step of a history.
    pub fn after(&mut self, cell: &Cell, history: &[Input]) -> Rc<Robot> {
        if let Some(known) = self.after.get(history) {
            return known.clone();
        }
        self.run(cell, history);
        self.after[history].clone()
    }

    fn plan(&self, names: &[String]) -> Plan {
        let handle = |name: &String| self.fmu.description().handle(name).expect("the FMU has the variable");
        Plan::new(&self.slave, &names.iter().map(handle).collect::<Vec<_>>())
    }

    fn run(&mut self, cell: &Cell, history: &[Input]) {
        self.instances += 1;
        let of = |list: &[(String, f64)]| -> (Vec<String>, Vec<f64>) { list.iter().cloned().unzip() };
        let (names, values) = of(&cell.parameters);
        let mut instance = self.slave.instantiate("twin").expect("an instance");
        self.plan(&names).write(&mut instance, &values).expect("parameters");
        let instance = instance.enter_initialization(0.0, None).expect("initialisation");
        let mut instance = instance.exit_initialization().expect("initialisation");
        let (names, values) = of(&cell.inputs);
        self.plan(&names).write(&mut instance, &values).expect("constant inputs");
        let (mut write, mut read) = (self.plan(&self.inputs), self.plan(&self.outputs));
        let mut row = vec![0.0; self.outputs.len()];
        let mut time = 0.0;
        let of_sensors = self.inputs.len() - cell.pose.len();
        for (i, (told, at)) in history.iter().enumerate() {
            let sensors = self.inputs[..of_sensors].iter().map(|name| value(cell, name, *told));
            let pose = cell.pose.iter().map(|(_, axis)| f64::from_bits(at[*axis]));
            let values: Vec<f64> = sensors.chain(pose).collect();
            write.write(&mut instance, &values).expect("inputs");
            instance.do_step(time, cell.step).expect("a step");
            time = f64::from(u32::try_from(i + 1).expect("few steps")) * cell.step;
            read.read(&mut instance, &mut row).expect("outputs");
            let bits: Vec<u64> = row.iter().map(|x| x.to_bits()).collect();
            let number = self.numbers.len();
            let robot = self.numbers.entry(bits).or_insert_with(|| Rc::new(robot(cell, &self.outputs, &row, number)));
            self.after.insert(history[..=i].to_vec(), robot.clone());
        }
    }
}

/// An input is active while any of its sensors reports.
fn value(cell: &Cell, name: &str, seen: u8) -> f64 {
    let of_it = cell.sensors.iter().enumerate().filter(|(_, s)| s.variable == name);
    let (mut active, mut reports) = (false, false);
    for (i, sensor) in of_it {
        active = sensor.active;
        reports |= seen & (1 << i) != 0;
    }
    f64::from(u8::from(reports == active))
}

fn robot(cell: &Cell, names: &[String], row: &[f64], number: usize) -> Robot {
    let get = |name: &str| row[names.iter().position(|n| n == name).expect("an output")];
    // Of each moving part: name, pose, velocity of its origin, angular velocity.
    let mut parts: Vec<(&str, (M3, V3), V3, V3)> = Vec::new();
    let (mut rotation, mut origin) = cell.base;
    let (mut velocity, mut spin) = ([0.0; 3], [0.0; 3]);
    for joint in &cell.joints {
        let arm = turned(&rotation, joint.origin.1);
        velocity = add(velocity, cross(spin, arm));
        origin = add(origin, arm);
        rotation = product(&rotation, &joint.origin.0);
        let axis = turned(&rotation, joint.axis);
        let (q, qd) = (joint.value.sign * get(&joint.value.variable), joint.speed.sign * get(&joint.speed.variable));
        if joint.slides {
            origin = add(origin, scaled(axis, q));
            velocity = add(add(velocity, cross(spin, scaled(axis, q))), scaled(axis, qd));
        } else {
            rotation = product(&rotation, &about(joint.axis, q));
            spin = add(spin, scaled(axis, qd));
        }
        parts.push((&joint.name, (rotation, origin), velocity, spin));
    }
    for frame in &cell.frames {
        let v: Vec<f64> = frame.variables.iter().map(|name| get(name)).collect();
        let world = |i: usize| turned(&cell.base.0, [v[i], v[i + 1], v[i + 2]]);
        let rotation = product(&cell.base.0, &of_quaternion([v[3], v[4], v[5], v[6]]));
        parts.push((&frame.name, (rotation, add(cell.base.1, world(0))), world(7), world(10)));
    }
    let link = |link: &super::cell::Link| {
        let (_, (rotation, origin), velocity, spin) = parts.iter().find(|p| p.0 == link.on).expect("a joint");
        let core = link.core.map(|p| add(*origin, turned(rotation, p)));
        let (origin, velocity, spin) = (*origin, *velocity, *spin);
        Link { name: link.name.clone(), core, radius: link.radius, origin, velocity, spin, pieces: Vec::new() }.cut()
    };
    let payload = cell.payload.as_ref().map(|name| get(name)).or(cell.payload_kg).expect("a payload");
    Robot { number, links: cell.links.iter().map(link).collect(), effective_mass: 0.5 * cell.moving_mass + payload }
}

fn of_quaternion([w, x, y, z]: [f64; 4]) -> M3 {
    [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ]
}
