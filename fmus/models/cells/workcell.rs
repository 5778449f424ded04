//! Any workcell: robots that run their programmes at the pace their safety controllers allow.
//!
//! The model knows robots and safety controllers in the robots' base frames, not what stands around them: whether a
//! safeguard is sufficient is a matter of the cell. Only laser scanners that are part of the FMU see the cell's frame.

use crate::bytes::{Reader, Writer};
use crate::drive::{Demands, Drive, Settings};
use crate::interface::WORKCELLS;
use crate::interface::variables::{Interface, Value, Variant};
use crate::interface::workcell::{Role, Safeguard, Spec, conveyor, interface, parameter};
use crate::kinematics::{Vec3, quaternion};
use crate::model::{Model, Outcome};
use crate::path::{Motion, Path};
use std::sync::OnceLock;

/// Most robots in a cell.
const ROBOTS: usize = 2;

/// What all instances of a cell share: the roles of the variables, and the timed programmes.
struct Shared {
    spec: &'static Spec,
    roles: Vec<Role>,
    starts: Vec<Value>,
    paths: Vec<Path>,
    /// Highest programmed speed, m/s: full pace of the speed limits.
    fastest: f64,
}

/// Made by the first instance of each cell.
fn shared(cell: usize) -> &'static Shared {
    static ALL: [OnceLock<Shared>; WORKCELLS.len()] = [const { OnceLock::new() }; WORKCELLS.len()];
    ALL[cell].get_or_init(|| {
        let spec = WORKCELLS[cell];
        let (table, roles) = interface(spec, Variant::Faithful);
        #[expect(clippy::expect_used, reason = "constant programmes, checked by the tests of `path`")]
        let paths = spec.robots.iter().map(|robot| Path::new(robot).expect("the programme is within reach")).collect();
        let speeds = spec.robots.iter().flat_map(|robot| robot.legs).map(|leg| leg.speed);
        Shared { spec, roles, starts: starts(&table), paths, fastest: speeds.fold(0.0, f64::max) }
    })
}

fn starts(table: &Interface) -> Vec<Value> {
    table.variables.iter().map(|variable| variable.kind.start()).collect()
}

/// Parameters, inputs and state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Workcell {
    /// Place in the list of cells.
    cell: usize,
    parameters: [f64; parameter::COUNT],
    /// The safeguard's signal: all is well.
    clear: bool,
    /// Of a door: the same in the step before, and whether an open one is a demand for as long as it is open.
    was_clear: bool,
    hold: bool,
    /// Left foot x, y, right foot x, y.
    feet: [f64; 4],
    reset: bool,
    drives: [Drive; ROBOTS],
    /// Of a conveyor its parameters, whether muting ends with it, and milliseconds since the start.
    conveyor: [f64; conveyor::COUNT],
    until_clear: bool,
    tick: u64,
}

impl Workcell {
    /// The cell whose model identifier, without the ending of a variant, this is; all start values of its table.
    pub fn new(identifier: &str) -> Option<Self> {
        let cell = WORKCELLS
            .iter()
            .position(|spec| Variant::ALL.iter().any(|v| v.names(spec.identifier, spec.name).0 == identifier))?;
        Some(Self::of(cell))
    }

    fn of(cell: usize) -> Self {
        let mut model = Self {
            cell,
            parameters: [0.0; parameter::COUNT],
            clear: true,
            was_clear: true,
            hold: false,
            feet: [0.0; 4],
            reset: false,
            drives: [Drive::running(); ROBOTS],
            conveyor: [0.0; conveyor::COUNT],
            until_clear: false,
            tick: 0,
        };
        for (place, value) in shared(cell).starts.iter().enumerate() {
            model.set(place, *value);
        }
        model
    }

    /// The same cell with all start values.
    pub fn fresh(&self) -> Self {
        Self::of(self.cell)
    }

    /// A restored state in which the latched stops are those of `other`: what a forgetful variant does.
    pub fn forgetting_latches(mut self, other: &Self) -> Self {
        for (drive, other) in self.drives.iter_mut().zip(&other.drives) {
            *drive = drive.with_latch_of(other);
        }
        self
    }

    fn settings(&self) -> Settings {
        let p = &self.parameters;
        let reduced = (p[parameter::V_LIMIT] / shared(self.cell).fastest).min(1.0);
        Settings { t_react: p[parameter::T_REACT], t_ramp: p[parameter::T_RAMP], reduced }
    }

    /// The settings for what a robot carries.
    fn settings_of(&self, robot: usize) -> Settings {
        let settings = self.settings();
        if shared(self.cell).spec.t_ramp_loaded.is_some() && self.motion(robot).carries > 0.0 {
            Settings { t_ramp: self.parameters[parameter::T_RAMP_LOADED], ..settings }
        } else {
            settings
        }
    }

    /// Programme seconds per second at full override.
    fn full_pace(&self) -> f64 {
        let scale = self.parameters[parameter::SPEED_SCALE];
        match shared(self.cell).spec.safeguard {
            Safeguard::AlwaysLimited { .. } => scale * self.settings().reduced,
            _ => scale,
        }
    }

    fn motion(&self, robot: usize) -> Motion {
        let time = self.full_pace() * self.drives[robot].programme_time();
        let shared = shared(self.cell);
        let v_approach = shared.spec.v_approach.map_or(f64::INFINITY, |_| self.parameters[parameter::V_APPROACH]);
        shared.paths[robot].at(self.parameters[parameter::PHASE0] + time, v_approach)
    }

    /// Whether the scanner of `field` (0 or 1) sees a foot.
    fn occupied(&self, field: usize) -> bool {
        let edges = &self.parameters[parameter::FIELDS..];
        let (from, to, near) = (edges[2 * field], edges[2 * field + 1], edges[4]);
        self.feet.chunks(2).any(|foot| from <= foot[0] && foot[0] <= to && near <= foot[1])
    }

    fn has_conveyor(&self) -> bool {
        matches!(shared(self.cell).spec.safeguard, Safeguard::Muted { .. })
    }

    /// Seconds since the start.
    fn now_s(&self) -> f64 {
        #[expect(clippy::cast_precision_loss, reason = "some seconds")]
        let milliseconds = self.tick as f64;
        milliseconds / 1000.0
    }

    /// How far the pallet is on its way, m.
    fn pallet_m(&self) -> f64 {
        let c = &self.conveyor;
        ((self.now_s() - c[conveyor::BEGINS]) * c[conveyor::SPEED]).clamp(0.0, c[conveyor::WAY])
    }

    fn in_entrance(&self) -> bool {
        self.pallet_m() < self.conveyor[conveyor::CLEAR]
    }

    fn muted(&self) -> bool {
        self.now_s() < self.conveyor[conveyor::MUTE] && (!self.until_clear || self.in_entrance())
    }

    fn demands(&self, robot: usize) -> Demands {
        let reset = self.reset;
        match shared(self.cell).spec.safeguard {
            Safeguard::Stop { .. } | Safeguard::AlwaysLimited { .. } => {
                Demands { stop: !self.clear, slow: false, reset }
            }
            Safeguard::Door { .. } => {
                Demands { stop: !self.clear && (self.hold || self.was_clear), slow: false, reset }
            }
            Safeguard::Muted { .. } => Demands { stop: !self.clear && !self.muted(), slow: false, reset },
            Safeguard::Slow { .. } => Demands { stop: false, slow: !self.clear, reset },
            Safeguard::Fields { .. } => Demands { stop: self.occupied(robot), slow: false, reset },
        }
    }

    /// Reads what `write` wrote of a cell of the same kind.
    pub fn read(&self, input: &mut Reader) -> Option<Self> {
        let mut model = *self;
        for value in model.parameters.iter_mut().chain(&mut model.feet) {
            *value = input.f64()?;
        }
        for value in [&mut model.clear, &mut model.was_clear, &mut model.hold] {
            *value = input.bool()?;
        }
        model.reset = input.bool()?;
        for drive in &mut model.drives {
            *drive = Drive::read(input)?;
        }
        if self.has_conveyor() {
            for value in &mut model.conveyor {
                *value = input.f64()?;
            }
            model.until_clear = input.bool()?;
            model.tick = input.u64()?;
        }
        Some(model)
    }

    fn value(&self, motions: &[Option<Moving>; ROBOTS], role: Role) -> Value {
        let pace = |robot: usize| self.full_pace() * self.drives[robot].pace();
        let robot_value = |robot: usize, of: &dyn Fn(&Motion, f64) -> f64| {
            Value::Real(motions[robot].as_ref().map_or(f64::NAN, |moving| of(&moving.motion, pace(robot))))
        };
        match role {
            Role::Time => Value::Real(f64::NAN),
            Role::Parameter(place) => Value::Real(self.parameters[place]),
            Role::Hold => Value::Boolean(self.hold),
            Role::Conveyor(place) => Value::Real(self.conveyor[place]),
            Role::UntilClear => Value::Boolean(self.until_clear),
            Role::Pallet => Value::Real(self.pallet_m()),
            Role::InEntrance => Value::Boolean(self.in_entrance()),
            Role::Muted => Value::Boolean(self.muted()),
            Role::Clear => Value::Boolean(self.clear),
            Role::Foot(place) => Value::Real(self.feet[place]),
            Role::Reset => Value::Boolean(self.reset),
            Role::Q(robot, joint) => robot_value(robot, &|motion, _| motion.q[joint]),
            Role::Qd(robot, joint) => robot_value(robot, &|motion, pace| motion.qd[joint] * pace),
            Role::Link(robot, link, component) => Value::Real(motions[robot].as_ref().map_or(f64::NAN, |moving| {
                let Moving { motion, twists, turned } = moving;
                let (velocity, angular) = twists[link];
                match component {
                    0..3 => motion.chain.origins[link][component],
                    3..7 => turned[link][component - 3],
                    7..10 => velocity[component - 7] * pace(robot),
                    _ => angular[component - 10] * pace(robot),
                }
            })),
            Role::TcpSpeed(robot) => robot_value(robot, &|motion, pace| motion.tcp_speed * pace),
            Role::Override(robot) => Value::Real(self.drives[robot].pace()),
            Role::Leg(robot) => {
                let leg = motions[robot].as_ref().map_or(0, |moving| moving.motion.leg);
                Value::Integer(i32::try_from(leg).unwrap_or(i32::MAX))
            }
            Role::StopState(robot) => Value::Integer(self.drives[robot].state()),
            Role::Payload(robot) => {
                let tool = shared(self.cell).spec.robots[robot].tool_kg;
                robot_value(robot, &|motion, _| tool + motion.carries)
            }
            Role::Occupied(field) => Value::Boolean(self.occupied(field)),
        }
    }
}

/// Where a robot is, with what many variables are parts of: worked out once.
struct Moving {
    motion: Motion,
    /// Velocity and angular velocity of each joint's moving side at full pace.
    twists: [(Vec3, Vec3); 6],
    /// Their unit quaternions.
    turned: [[f64; 4]; 6],
}

impl Moving {
    fn new(motion: Motion) -> Self {
        let turned = std::array::from_fn(|link| quaternion(&motion.chain.rotations[link]));
        Self { twists: motion.chain.twists(&motion.qd), turned, motion }
    }
}

impl Model for Workcell {
    fn set(&mut self, variable: usize, value: Value) {
        match (shared(self.cell).roles.get(variable), value) {
            (Some(&Role::Parameter(place)), Value::Real(x)) => self.parameters[place] = x,
            (Some(&Role::Foot(place)), Value::Real(x)) => self.feet[place] = x,
            (Some(Role::Hold), Value::Boolean(x)) => self.hold = x,
            (Some(&Role::Conveyor(place)), Value::Real(x)) => self.conveyor[place] = x,
            (Some(Role::UntilClear), Value::Boolean(x)) => self.until_clear = x,
            (Some(Role::Clear), Value::Boolean(x)) => self.clear = x,
            (Some(Role::Reset), Value::Boolean(x)) => self.reset = x,
            _ => {}
        }
    }

    fn read_out(&self, values: &mut [Value]) {
        let shared = shared(self.cell);
        let motions =
            std::array::from_fn(|robot| (robot < shared.paths.len()).then(|| Moving::new(self.motion(robot))));
        for (value, role) in values.iter_mut().zip(&shared.roles) {
            *value = self.value(&motions, *role);
        }
    }

    fn step(&mut self, ticks: u64) -> Outcome {
        // Muting may end in any millisecond.
        if self.has_conveyor() && ticks > 1 {
            (0..ticks).for_each(|_| _ = self.step(1));
            return Outcome::Done;
        }
        self.tick = self.tick.saturating_add(ticks);
        for robot in 0..shared(self.cell).paths.len() {
            let (demands, settings) = (self.demands(robot), self.settings_of(robot));
            self.drives[robot].advance(ticks, demands, &settings);
        }
        if let Safeguard::Door { .. } = shared(self.cell).spec.safeguard {
            self.was_clear = self.clear;
        }
        Outcome::Done
    }

    fn write(&self, out: &mut Writer) {
        for value in self.parameters.iter().chain(&self.feet) {
            out.f64(*value);
        }
        for value in [self.clear, self.was_clear, self.hold] {
            out.bool(value);
        }
        out.bool(self.reset);
        for drive in &self.drives {
            drive.write(out);
        }
        if self.has_conveyor() {
            for value in self.conveyor {
                out.f64(value);
            }
            out.bool(self.until_clear);
            out.u64(self.tick);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kinematics::{add, norm, scale};

    /// A cell by name, with its values by variable name.
    struct Bench {
        model: Workcell,
        table: Interface,
    }

    impl Bench {
        fn new(name: &str) -> Self {
            let spec = WORKCELLS.into_iter().find(|spec| spec.name == name).unwrap();
            Self { model: Workcell::new(spec.identifier).unwrap(), table: interface(spec, Variant::Faithful).0 }
        }

        fn get(&self, name: &str) -> Value {
            let mut values = starts(&self.table);
            self.model.read_out(&mut values);
            values[self.table.place(name).unwrap()]
        }

        fn real(&self, name: &str) -> f64 {
            match self.get(name) {
                Value::Real(x) => x,
                other => panic!("{name} is {other:?}"),
            }
        }

        fn set(&mut self, name: &str, value: Value) {
            self.model.set(self.table.place(name).unwrap(), value);
        }

        fn angles(&self, name: &str) -> [f64; 6] {
            std::array::from_fn(|k| self.real(&format!("{name}[{}]", k + 1)))
        }
    }

    #[test]
    fn every_cell_starts_where_its_programme_does_and_moves() {
        for spec in WORKCELLS {
            let mut bench = Bench::new(spec.name);
            bench.set("ctrl.phase0", Value::Real(0.0));
            for (number, robot) in spec.robots.iter().enumerate() {
                let motion = bench.model.motion(number);
                assert!(norm(add(motion.chain.origins[6], scale(robot.start, -1.0))) < 1e-9, "{}", spec.name);
            }
            bench.model.step(20);
            for robot in spec.robots {
                assert!(bench.real(&format!("robot{}.tcp_speed", robot.suffix)) > 0.1, "{}", spec.name);
            }
        }
    }

    #[test]
    fn speeds_are_the_derivatives_of_the_angles_also_while_stopping() {
        for scale in [1.0, 0.4] {
            let mut bench = Bench::new("safety-fence");
            bench.set("ctrl.speed_scale", Value::Real(scale));
            let mut worst: f64 = 0.0;
            for tick in 0..1500_u32 {
                bench.set("plc.guard_closed", Value::Boolean(!(450..460).contains(&tick)));
                bench.set("plc.reset", Value::Boolean(tick >= 1000));
                // Over 1 ms: the trapezoid of the speeds against the difference of the angles.
                let (q, qd) = (bench.angles("robot.q"), bench.angles("robot.qd"));
                bench.model.step(1);
                let (next_q, next_qd) = (bench.angles("robot.q"), bench.angles("robot.qd"));
                for joint in 0..6 {
                    let by_speed = (qd[joint] + next_qd[joint]) / 2.0 * 1e-3;
                    worst = worst.max((next_q[joint] - q[joint] - by_speed).abs());
                }
            }
            // The trapezoid is off by a jump of the acceleration within the millisecond.
            assert!(worst < 2.3e-5, "speeds and angles disagree by {worst:e} rad in 1 ms");
        }
    }

    #[test]
    fn link_poses_are_those_of_the_joint_angles() {
        let mut bench = Bench::new("head-collision");
        for _ in 0..40 {
            bench.model.step(33);
            let motion = bench.model.motion(0);
            let chain = crate::interface::robots::UR5E.place(&motion.q);
            for link in 0..6 {
                for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
                    let value = bench.real(&format!("robot.link[{}].{name}", link + 1));
                    assert!((value - chain.origins[link][axis]).abs() < 1e-12);
                }
            }
            // The flange turns with the tool, which keeps its orientation.
            let spin = ["wx", "wy", "wz"].map(|name| bench.real(&format!("robot.link[6].{name}")));
            assert!(norm(spin) < 1e-9, "{spin:?}");
            let speed = norm(["vx", "vy", "vz"].map(|name| bench.real(&format!("robot.link[6].{name}"))));
            assert!((speed - bench.real("robot.tcp_speed")).abs() < 1e-9);
        }
    }

    #[test]
    fn the_scanner_field_slows_the_robot_down_and_lets_it_go_again() {
        let mut bench = Bench::new("head-collision");
        // The fastest leg is 1.0 m/s: reduced to 0.25 m/s the override is 0.25.
        bench.set("plc.field_clear", Value::Boolean(false));
        bench.model.step(120 + 375);
        assert!((bench.real("ctrl.override") - 0.25).abs() < 1e-12);
        assert_eq!(bench.get("plc.stop_state"), Value::Integer(1));
        bench.set("plc.field_clear", Value::Boolean(true));
        bench.model.step(375);
        assert!((bench.real("ctrl.override") - 1.0).abs() < 1e-12);
    }

    #[test]
    fn each_scanner_stops_its_own_robot_only() {
        let mut bench = Bench::new("two-scanners");
        // Left foot in field A (x -2.4 to 0, y from -1.6).
        bench.set("human.left_foot.x", Value::Real(-0.5));
        bench.set("human.left_foot.y", Value::Real(-1.5));
        bench.model.step(1000);
        assert_eq!(bench.get("scanner.a.occupied"), Value::Boolean(true));
        assert_eq!(bench.get("scanner.b.occupied"), Value::Boolean(false));
        assert_eq!((bench.real("robot_a.tcp_speed"), bench.real("ctrl_a.override")), (0.0, 0.0));
        assert_eq!(bench.real("ctrl_b.override"), 1.0);
        // Out of it again: latched.
        bench.set("human.left_foot.y", Value::Real(-1.7));
        bench.model.step(1000);
        assert_eq!(bench.get("scanner.a.occupied"), Value::Boolean(false));
        assert_eq!(bench.get("plc_a.stop_state"), Value::Integer(3));
    }

    #[test]
    fn the_workpiece_weighs_from_the_grasp_on_and_the_limit_does_not_know() {
        let mut bench = Bench::new("heavy-workpiece");
        let mut seen = Vec::new();
        for _ in 0..200 {
            let load = bench.real("gripper.payload");
            if seen.last() != Some(&load) {
                seen.push(load);
            }
            assert!(bench.real("robot.tcp_speed") <= 0.48 + 1e-9);
            bench.model.step(10);
        }
        assert_eq!(seen, [1.5, 12.5]);
        let mut slow = Bench::new("heavy-workpiece");
        slow.set("plc.v_limit", Value::Real(0.24));
        slow.model.step(400);
        assert!((slow.real("robot.tcp_speed") - 0.24).abs() < 1e-9);
    }

    /// Milliseconds from the demand on until the robot stands.
    fn stop_takes(bench: &mut Bench) -> u32 {
        bench.set("plc.field_clear", Value::Boolean(false));
        let mut milliseconds = 0;
        while bench.get("plc.stop_state") != Value::Integer(3) {
            bench.model.step(1);
            milliseconds += 1;
        }
        milliseconds
    }

    #[test]
    fn a_stop_with_a_casting_takes_longer_even_if_it_is_put_down_meanwhile() {
        let mut bench = Bench::new("short-zone");
        bench.set("ctrl.phase0", Value::Real(0.3));
        assert_eq!((bench.real("gripper.payload"), stop_takes(&mut bench)), (2.0, 100 + 300));
        let mut bench = Bench::new("short-zone");
        bench.set("ctrl.phase0", Value::Real(1.6));
        assert_eq!((bench.real("gripper.payload"), stop_takes(&mut bench)), (10.0, 100 + 700));
        // 0.15 s before the end of the leg: the ramp is that of its beginning, and the speed has no jump.
        let mut bench = Bench::new("short-zone");
        bench.set("ctrl.phase0", Value::Real(2.0 * (1.1 / 0.9 + 0.9 / 15.0) - 0.15));
        assert_eq!((bench.real("gripper.payload"), stop_takes(&mut bench)), (10.0, 100 + 700));
        assert_eq!(bench.real("gripper.payload"), 2.0);
    }

    #[test]
    fn approaches_are_as_slow_as_they_are_told_and_the_rest_is_not() {
        for (v_approach, told) in [(0.25, 0.25), (0.09, 0.09), (9.0, 0.5)] {
            let mut bench = Bench::new("hand-at-table");
            bench.set("ctrl.phase0", Value::Real(0.0));
            bench.set("ctrl.v_approach", Value::Real(v_approach));
            let (mut fastest, mut before) = ([0.0_f64; 7], bench.angles("robot.q"));
            let mut speeds = bench.angles("robot.qd");
            for _ in 0..8000 {
                bench.model.step(1);
                let Value::Integer(leg) = bench.get("ctrl.leg") else { panic!("no number") };
                let leg = usize::try_from(leg).unwrap();
                fastest[leg] = fastest[leg].max(bench.real("robot.tcp_speed"));
                let (q, qd) = (bench.angles("robot.q"), bench.angles("robot.qd"));
                for joint in 0..6 {
                    let by_speed = (speeds[joint] + qd[joint]) / 2.0 * 1e-3;
                    assert!((q[joint] - before[joint] - by_speed).abs() < 5e-5, "joint {joint} in leg {leg}");
                }
                (before, speeds) = (q, qd);
            }
            let expected = [0.5, told, 0.5, 0.5, 0.5, told, 0.5];
            for (leg, (fastest, expected)) in fastest.iter().zip(expected).enumerate() {
                assert!((fastest - expected).abs() < 2e-3, "leg {leg}: {fastest} m/s, expected {expected} m/s");
            }
        }
    }

    #[test]
    fn half_speed_takes_twice_the_time_and_the_phase_shifts() {
        let mut slow = Bench::new("safety-fence");
        slow.set("ctrl.speed_scale", Value::Real(0.5));
        let mut full = Bench::new("safety-fence");
        slow.model.step(1200);
        full.model.step(600);
        let mut late = Bench::new("safety-fence");
        late.set("ctrl.phase0", Value::Real(0.6));
        for other in [&slow, &late] {
            for (a, b) in other.angles("robot.q").iter().zip(full.angles("robot.q")) {
                assert!((a - b).abs() < 1e-9);
            }
        }
        assert!((slow.real("robot.tcp_speed") - full.real("robot.tcp_speed") / 2.0).abs() < 1e-9);
    }
}
