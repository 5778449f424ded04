//! How a robot's joints, frames and payload are read.

use toml::Spanned;

use super::lookup::Quantity;
use super::{Binder, Derived, FrameBinding, MotionBinding, Orientation, Reader, RobotBinding};
use crate::cell::CellError;
use crate::cell::file::format::{FrameTable, JointTable, RobotTable};

impl Binder<'_> {
    pub(super) fn robot(&mut self, table: &Spanned<RobotTable>) -> Option<RobotBinding> {
        let (robot, problems) = (table.get_ref(), self.problems);
        let motion = if robot.frames.is_empty() {
            let joints = robot.joints.iter().filter_map(|joint| problems.keep(self.joint(joint)));
            let (positions, speeds) = joints.unzip();
            MotionBinding::Joints { positions, speeds }
        } else {
            MotionBinding::Frames(problems.keep_all(robot.frames.iter().map(|f| self.frame(f))))
        };
        let payload = problems.keep(self.payload(table));
        let phase = robot.phase.as_ref().map(|name| self.whole_number(name, "the programme phase")).transpose();
        Some(RobotBinding { motion, payload: payload?, phase: problems.keep(phase)? })
    }

    fn payload(&mut self, table: &Spanned<RobotTable>) -> Result<Reader, Box<CellError>> {
        let robot = table.get_ref();
        match (&robot.payload_kg, &robot.payload) {
            (Some(kg), None) => Ok(Reader::constant(*kg.get_ref())),
            (None, Some(table)) => self.reader(table, Quantity::Mass),
            _ => {
                let message = "the robot needs either `payload_kg` (a number) or `payload` (an FMU output)";
                let help = Some("a robot that carries nothing has payload_kg = 0".to_owned());
                Err(self.source.error(table.span(), "this robot", message, help))
            }
        }
    }

    /// Position and speed of a joint.
    fn joint(&mut self, joint: &JointTable) -> Result<(Reader, Reader), Box<CellError>> {
        let still = joint.held_deg.map(f64::to_radians).or(joint.held_m);
        if let Some(offset) = still {
            return Ok((Reader::constant(offset), Reader::default()));
        }
        let (table, position, speed) = match (&joint.angle, &joint.position) {
            (Some(angle), _) => (angle, Quantity::Angle, Quantity::AngularSpeed),
            (None, Some(position)) => (position, Quantity::Length, Quantity::Speed),
            // Checked before; what is missing there is told there.
            (None, None) => return Ok((Reader::default(), Reader::default())),
        };
        let reader = self.reader(table, position)?;
        let speed = match &joint.speed {
            Some(table) => self.reader(table, speed)?,
            None => {
                let turns = matches!(position, Quantity::Angle);
                self.differentiated(&format!("the speed of joint `{}`", joint.name.get_ref()));
                let [speed] = self.derive(Derived::Rate { of: reader.clone(), turns });
                speed
            }
        };
        Ok((reader, speed))
    }

    /// Adds what is derived; readers of its columns.
    fn derive<const N: usize>(&mut self, derived: Derived) -> [Reader; N] {
        let first: usize = self.derived.iter().map(Derived::columns).sum();
        self.derived.push(derived);
        std::array::from_fn(|column| Reader::derived(first + column))
    }

    fn differentiated(&mut self, what: &str) {
        self.differentiated.push(what.to_owned());
    }

    fn frame(&mut self, frame: &FrameTable) -> Result<FrameBinding, Box<CellError>> {
        let name = frame.name.get_ref();
        let position = self.readers(&frame.position, Quantity::Length)?;
        let orientation = match (&frame.quaternion, &frame.rotation_matrix) {
            (Some(names), _) => Orientation::Quaternion(Box::new(self.readers(names, Quantity::Number)?)),
            (None, Some([a, b, c])) => Orientation::Matrix(Box::new([
                self.readers(a, Quantity::Number)?,
                self.readers(b, Quantity::Number)?,
                self.readers(c, Quantity::Number)?,
            ])),
            (None, None) => Orientation::Unknown,
        };
        let velocity = if let Some(names) = &frame.velocity {
            self.readers(names, Quantity::Speed)?
        } else {
            self.differentiated(&format!("the velocity of frame `{name}`"));
            position.clone().map(|of| {
                let [speed] = self.derive(Derived::Rate { of, turns: false });
                speed
            })
        };
        let angular_velocity = match (&frame.angular_velocity, &orientation) {
            (Some(names), _) => self.readers(names, Quantity::AngularSpeed)?,
            (None, Orientation::Unknown) => std::array::from_fn(|_| Reader::default()),
            (None, _) => {
                self.differentiated(&format!("the angular velocity of frame `{name}`"));
                self.derive(Derived::Turning { of: orientation.clone() })
            }
        };
        Ok(FrameBinding { position, orientation, velocity, angular_velocity })
    }

    fn readers<const N: usize>(
        &mut self,
        names: &[Spanned<String>; N],
        quantity: Quantity,
    ) -> Result<[Reader; N], Box<CellError>> {
        let mut readers = std::array::from_fn(|_| Reader::default());
        for (reader, name) in readers.iter_mut().zip(names) {
            let factor = self.factor(name, None, quantity)?;
            *reader = Reader::output(self.real_output(name)?, factor);
        }
        Ok(readers)
    }
}
