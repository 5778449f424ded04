//! The parts of the cells `sensor-mat` and `two-operators`, to be coupled by the importer.

use crate::bytes::{Reader, Writer};
use crate::drive::{Demands, Drive, Settings};
use crate::interface::coupled::{controller, kinematics, plc, stations_plc};
use crate::interface::sensor_mat::SPEC;
use crate::interface::variables::Value;
use crate::kinematics::{Joints, Pose, Vec3, scale};
use crate::model::{Model, Outcome};
use crate::path::{Motion, Path};
use std::sync::OnceLock;

/// The safety controller: reaction time and latch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plc {
    t_react: f64,
    mat_clear: bool,
    reset: bool,
    drive: Drive,
}

impl Plc {
    /// All start values of the table.
    pub fn new() -> Self {
        Self { t_react: SPEC.t_react, mat_clear: true, reset: false, drive: Drive::running() }
    }

    /// It cannot see the robot: after the reaction time it takes the robot to stand, so a reset works at once.
    fn settings(&self) -> Settings {
        Settings { t_react: self.t_react, t_ramp: 1e-3, reduced: 1.0 }
    }

    /// Reads what `write` wrote.
    pub fn read(input: &mut Reader) -> Option<Self> {
        Some(Self { t_react: input.f64()?, mat_clear: input.bool()?, reset: input.bool()?, drive: Drive::read(input)? })
    }
}

impl Model for Plc {
    fn set(&mut self, variable: usize, value: Value) {
        match (variable, value) {
            (plc::T_REACT, Value::Real(x)) => self.t_react = x,
            (plc::MAT_CLEAR, Value::Boolean(x)) => self.mat_clear = x,
            (plc::RESET, Value::Boolean(x)) => self.reset = x,
            _ => {}
        }
    }

    fn read_out(&self, values: &mut [Value]) {
        values[plc::T_REACT] = Value::Real(self.t_react);
        values[plc::MAT_CLEAR] = Value::Boolean(self.mat_clear);
        values[plc::RESET] = Value::Boolean(self.reset);
        values[plc::STOP] = Value::Boolean(self.drive.stop_acts(&self.settings()));
    }

    fn step(&mut self, ticks: u64) -> Outcome {
        let demands = Demands { stop: !self.mat_clear, slow: false, reset: self.reset };
        self.drive.advance(ticks, demands, &self.settings());
        Outcome::Done
    }

    fn write(&self, out: &mut Writer) {
        out.f64(self.t_react);
        out.bool(self.mat_clear);
        out.bool(self.reset);
        self.drive.write(out);
    }
}

/// The safety controller with two stations: the field counts for nothing while somebody is at one of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StationsPlc {
    plc: Plc,
    field_clear: bool,
    occupied: [bool; 2],
    mutes: bool,
}

impl StationsPlc {
    /// All start values of the table.
    pub fn new() -> Self {
        Self { plc: Plc::new(), field_clear: true, occupied: [false; 2], mutes: true }
    }

    /// Reads what `write` wrote.
    pub fn read(input: &mut Reader) -> Option<Self> {
        Some(Self {
            plc: Plc::read(input)?,
            field_clear: input.bool()?,
            occupied: [input.bool()?, input.bool()?],
            mutes: input.bool()?,
        })
    }

    fn is_muted(&self) -> bool {
        self.mutes && self.occupied.contains(&true)
    }
}

impl Model for StationsPlc {
    fn set(&mut self, variable: usize, value: Value) {
        match (variable, value) {
            (stations_plc::FIELD_CLEAR, Value::Boolean(x)) => self.field_clear = x,
            (stations_plc::STATION_A, Value::Boolean(x)) => self.occupied[0] = x,
            (stations_plc::STATION_B, Value::Boolean(x)) => self.occupied[1] = x,
            (stations_plc::MUTES, Value::Boolean(x)) => self.mutes = x,
            _ => self.plc.set(variable, value),
        }
    }

    fn read_out(&self, values: &mut [Value]) {
        self.plc.read_out(values);
        values[stations_plc::FIELD_CLEAR] = Value::Boolean(self.field_clear);
        values[stations_plc::STATION_A] = Value::Boolean(self.occupied[0]);
        values[stations_plc::STATION_B] = Value::Boolean(self.occupied[1]);
        values[stations_plc::MUTES] = Value::Boolean(self.mutes);
    }

    fn step(&mut self, ticks: u64) -> Outcome {
        self.plc.mat_clear = self.field_clear || self.is_muted();
        self.plc.step(ticks)
    }

    fn write(&self, out: &mut Writer) {
        self.plc.write(out);
        for value in [self.field_clear, self.occupied[0], self.occupied[1], self.mutes] {
            out.bool(value);
        }
    }
}

/// The timed programme, made by the first instance that needs it.
fn path() -> &'static Path {
    static PATH: OnceLock<Path> = OnceLock::new();
    #[expect(clippy::expect_used, reason = "a constant programme, checked by the tests of `path`")]
    PATH.get_or_init(|| Path::new(&SPEC.robots[0]).expect("the programme is within reach"))
}

/// The robot controller: programme and ramp.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Controller {
    t_ramp: f64,
    speed_scale: f64,
    phase0: f64,
    stop: bool,
    drive: Drive,
}

impl Controller {
    /// All start values of the table.
    pub fn new() -> Self {
        Self { t_ramp: SPEC.t_ramp, speed_scale: 1.0, phase0: SPEC.phase0, stop: false, drive: Drive::running() }
    }

    /// The stop signal is the state, not a demand to be latched: its end lets the robot go on.
    fn settings(&self) -> Settings {
        Settings { t_react: 0.0, t_ramp: self.t_ramp, reduced: 0.0 }
    }

    fn motion(&self) -> Motion {
        path().at(self.phase0 + self.speed_scale * self.drive.programme_time(), f64::INFINITY)
    }

    /// Reads what `write` wrote.
    pub fn read(input: &mut Reader) -> Option<Self> {
        Some(Self {
            t_ramp: input.f64()?,
            speed_scale: input.f64()?,
            phase0: input.f64()?,
            stop: input.bool()?,
            drive: Drive::read(input)?,
        })
    }
}

fn write_vector(values: &mut [Value], first: usize, vector: &[f64]) {
    for (value, x) in values[first..].iter_mut().zip(vector) {
        *value = Value::Real(*x);
    }
}

impl Model for Controller {
    fn set(&mut self, variable: usize, value: Value) {
        match (variable, value) {
            (controller::T_RAMP, Value::Real(x)) => self.t_ramp = x,
            (controller::SPEED_SCALE, Value::Real(x)) => self.speed_scale = x,
            (controller::PHASE0, Value::Real(x)) => self.phase0 = x,
            (controller::STOP, Value::Boolean(x)) => self.stop = x,
            _ => {}
        }
    }

    fn read_out(&self, values: &mut [Value]) {
        let motion = self.motion();
        let pace = self.drive.pace();
        values[controller::T_RAMP] = Value::Real(self.t_ramp);
        values[controller::SPEED_SCALE] = Value::Real(self.speed_scale);
        values[controller::PHASE0] = Value::Real(self.phase0);
        values[controller::STOP] = Value::Boolean(self.stop);
        write_vector(values, controller::POSITION, &motion.position);
        write_vector(values, controller::VELOCITY, &scale(motion.velocity, self.speed_scale * pace));
        values[controller::OVERRIDE] = Value::Real(pace);
        values[controller::LEG] = Value::Integer(i32::try_from(motion.leg).unwrap_or(i32::MAX));
    }

    fn step(&mut self, ticks: u64) -> Outcome {
        let demands = Demands { stop: false, slow: self.stop, reset: false };
        self.drive.advance(ticks, demands, &self.settings());
        Outcome::Done
    }

    fn write(&self, out: &mut Writer) {
        for value in [self.t_ramp, self.speed_scale, self.phase0] {
            out.f64(value);
        }
        out.bool(self.stop);
        self.drive.write(out);
    }
}

/// The kinematics: joint angles near the last ones that reach the place asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Kinematics {
    position: Vec3,
    velocity: Vec3,
    q: Joints,
}

impl Kinematics {
    /// All start values of the table.
    pub fn new() -> Self {
        let robot = &SPEC.robots[0];
        Self { position: robot.start, velocity: [0.0; 3], q: robot.near }
    }

    fn angles(&self) -> Option<Joints> {
        let robot = &SPEC.robots[0];
        robot.robot.angles(&Pose { position: self.position, rotation: robot.rotation }, &self.q)
    }

    /// Reads what `write` wrote.
    pub fn read(input: &mut Reader) -> Option<Self> {
        let mut model = Self::new();
        for value in model.position.iter_mut().chain(&mut model.velocity).chain(&mut model.q) {
            *value = input.f64()?;
        }
        Some(model)
    }
}

impl Model for Kinematics {
    fn set(&mut self, variable: usize, value: Value) {
        let Value::Real(x) = value else { return };
        match variable {
            kinematics::POSITION..kinematics::VELOCITY => self.position[variable - kinematics::POSITION] = x,
            kinematics::VELOCITY..kinematics::Q => self.velocity[variable - kinematics::VELOCITY] = x,
            _ => {}
        }
    }

    fn read_out(&self, values: &mut [Value]) {
        let robot = &SPEC.robots[0];
        let q = self.angles().unwrap_or([f64::NAN; 6]);
        let qd = robot.robot.place(&q).joint_speeds(self.velocity, [0.0; 3]).unwrap_or([f64::NAN; 6]);
        write_vector(values, kinematics::POSITION, &self.position);
        write_vector(values, kinematics::VELOCITY, &self.velocity);
        write_vector(values, kinematics::Q, &q);
        write_vector(values, kinematics::QD, &qd);
        values[kinematics::PAYLOAD] = Value::Real(robot.tool_kg);
    }

    fn step(&mut self, _ticks: u64) -> Outcome {
        match self.angles() {
            Some(q) => {
                self.q = q;
                Outcome::Done
            }
            None => Outcome::Failed(format!("the arm cannot reach {:?}", self.position)),
        }
    }

    fn write(&self, out: &mut Writer) {
        for value in self.position.iter().chain(&self.velocity).chain(&self.q) {
            out.f64(*value);
        }
    }
}
