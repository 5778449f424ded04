//! What a scan has without its FMU: the people, the obstacles, the sensors, the contact rules. From these follow where a
//! walk leads, what the sensors then read, and whether a robot can be touched as it stands at some instant.
//!
//! Nothing here changes over a scan, so threads may share it.

mod behind;
mod contacts;
mod following;
mod instant;
mod near;
mod occupant;
mod operating;
mod passing;
mod people;
mod sensing;
mod through_plane;
mod walking;

use std::sync::Arc;

pub use self::instant::{Frames, Hit, IfSignalled, Instant, PersonState, SignalledRuns, Window};
pub use self::occupant::Occupant;
pub use self::operating::OperatedControls;
pub use self::people::{Places, Walks};
pub use self::sensing::{InputTrace, RawReadings};
pub use self::through_plane::Asked;
use crate::cell::{Binding, Workcell};
use crate::hazard::criterion::separation::{Separation, Stop};
use crate::human::Who;
use crate::stop::Stop as WorkStop;

/// See the module's text.
#[derive(Debug)]
pub struct World {
    /// The cell.
    pub cell: Arc<Workcell>,
    /// Its variables.
    pub binding: Arc<Binding>,
    /// The person, or the first of two.
    pub first: Occupant,
    /// The second person, if there is one. Planes are then not looked at.
    pub second: Option<Occupant>,
    /// What stops the robots, where separation counts.
    pub(super) stop_command: Option<Command>,
}

/// An input of the FMU that is set to a value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Command {
    /// Its column.
    pub(super) column: usize,
    /// The value.
    pub(super) value: f64,
    /// So many steps after there is reason to: the response time of a sensor that sets it.
    pub(super) delay_steps: usize,
}

impl World {
    /// What follows from a cell and its variables.
    #[must_use]
    pub fn new(cell: Arc<Workcell>, binding: Arc<Binding>) -> Self {
        let one = |who: Who, cell: Arc<Workcell>| Occupant::new(who, cell, Arc::clone(&binding));
        Self {
            first: one(Who::First, Arc::clone(&cell)),
            second: cell.of_second().map(|cell| one(Who::Second, Arc::new(cell))),
            stop_command: Command::that_stops(&cell, &binding),
            cell,
            binding,
        }
    }

    /// The same, but its searches end when `stop` says so: then what they find says nothing.
    #[must_use]
    pub fn heeding(self, stop: &WorkStop) -> Self {
        let Self { first, second, .. } = self;
        Self { first: first.heeding(stop), second: second.map(|second| second.heeding(stop)), ..self }
    }

    /// When searches have to end.
    pub fn stop(&self) -> &WorkStop {
        self.first.stop()
    }

    /// The same, but where there is an unsafe arm contact any such is told, not the worst: whether there is one, is the
    /// same, and much sooner known. What comes behind a hazard by contact is not looked for.
    #[must_use]
    pub fn content_with_any(self) -> Self {
        let Self { first, second, .. } = self;
        Self { first: first.content_with_any(), second: second.map(Occupant::content_with_any), ..self }
    }
}

impl Command {
    /// The one that the cell measures stops by.
    fn that_stops(cell: &Workcell, binding: &Binding) -> Option<Self> {
        let Some(Separation { stop: Stop::Measured(name), .. }) = &cell.separation else { return None };
        let sensor = cell.sensors.iter().find(|sensor| sensor.name == *name);
        let delay_steps = sensor.map_or(0, |sensor| sensor.delay_steps);
        binding.command(cell, name).map(|(column, value)| Self { column, value, delay_steps })
    }
}
