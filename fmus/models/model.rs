//! What the FMI layer asks of a model.

use crate::bytes::Writer;
use crate::interface::variables::Value;

/// How a communication step ended.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Outcome {
    /// The step was made.
    Done,
    /// Nothing was computed; the importer may try again.
    Discarded(String),
    /// The step failed.
    Failed(String),
    /// Nothing can be done with this FMU any more.
    Fatal(String),
}

/// What a model will do in the next step besides stepping; only the faulty model does anything.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Special {
    /// Nothing.
    None,
    /// It stops halfway, if the importer allows that.
    EarlyReturn,
    /// It ends the simulation after the step.
    Terminate,
    /// It has an event at the end of the step, which waits for `handle_event`.
    Event,
    /// It makes the step, but says that it has come only halfway.
    WrongTime,
    /// It has an event halfway and stops there, if the importer allows that, and leaves the event to it; even one that told it no
    /// Event Mode is used.
    EventHalfway,
    /// It has an event at the end of the step and leaves it to the importer, even one that told it no Event Mode is used.
    EventLeft,
}

/// A model: a small value that holds parameters, inputs and state, and nothing else. Copying it saves the state.
///
/// Values that arrive have the type of their variable and lie within its bounds.
pub trait Model {
    /// Sets a parameter or an input by its place in the interface's table.
    fn set(&mut self, variable: usize, value: Value);

    /// Writes the values of all variables but `time` to their places in the table.
    fn read_out(&self, values: &mut [Value]);

    /// Lets `ticks` milliseconds pass with the inputs held.
    fn step(&mut self, ticks: u64) -> Outcome;

    /// Writes all fields.
    fn write(&self, out: &mut Writer);
}
