//! A co-simulation instance: its life as types, over FMI 2.0 and FMI 3.0 alike.
//!
//! `Instantiated -> Initializing -> Stepping`: a call that FMI does not allow in a state does not compile. States are
//! owned by the instance that made them: dropping a [`State`] gives its handle back for reuse, and all handles are
//! freed before the instance is.
//!
//! FMI 3.0's Event Mode has no type of its own: it is entered and left within [`Instance::exit_initialization`],
//! [`Instance::do_step`] and [`Plan::write`](super::Plan::write), so that an instance that can be seen is in Step Mode.

use std::marker::PhantomData;

use super::error::Error;
use super::library::{Slave, Table};
use super::raw::{Raw, State};
use super::{raw2, raw3};

/// Instantiated, parameters and start values can be set.
#[derive(Debug)]
pub struct Instantiated;
/// In initialisation mode.
#[derive(Debug)]
pub struct Initializing;
/// Initialised: steps, states, results.
#[derive(Debug)]
pub struct Stepping;

/// Whether events of an FMI 3.0 FMU are handled with it, in Event Mode. Others handle their events alone.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum EventMode {
    /// If the FMU has an Event Mode and either has clocks to be driven from outside or failed without
    /// ([`Slave::prefer_event_mode`]).
    #[default]
    WhenNeeded,
    /// If the FMU has an Event Mode.
    Used,
    /// Never.
    Unused,
}

/// A co-simulation instance in lifecycle state `S`.
pub struct Instance<S> {
    pub(super) raw: Raw,
    state: PhantomData<S>,
}

impl Slave {
    /// Makes an instance.
    ///
    /// # Errors
    /// When the FMU refuses, with its own log lines.
    pub fn instantiate(&self, name: &str) -> Result<Instance<Instantiated>, Error> {
        self.instantiate_with(name, EventMode::WhenNeeded)
    }

    /// The same, saying whether Event Mode is used.
    ///
    /// # Errors
    /// As [`Slave::instantiate`].
    pub fn instantiate_with(&self, name: &str, events: EventMode) -> Result<Instance<Instantiated>, Error> {
        if self.is_poisoned() {
            return Err(Error::AfterFatal);
        }
        let raw = match self.table() {
            Table::V2(functions) => raw2::instantiate(self, functions, name)?,
            Table::V3(functions) => {
                let events = self.capabilities().has_event_mode
                    && match events {
                        EventMode::WhenNeeded => self.prefers_event_mode(),
                        EventMode::Used => true,
                        EventMode::Unused => false,
                    };
                raw3::instantiate(self, functions, name, events)?
            }
        };
        Ok(Instance { raw, state: PhantomData })
    }
}

impl<S> Instance<S> {
    fn into_state<T>(self) -> Instance<T> {
        Instance { raw: self.raw, state: PhantomData }
    }

    /// Whether Event Mode is used.
    #[must_use]
    pub const fn uses_event_mode(&self) -> bool {
        self.raw.events
    }
}

impl Instance<Instantiated> {
    /// `fmi2SetupExperiment` and `fmi2EnterInitializationMode`, or `fmi3EnterInitializationMode`; times in s.
    ///
    /// # Errors
    /// When the FMU refuses.
    pub fn enter_initialization(mut self, start: f64, stop: Option<f64>) -> Result<Instance<Initializing>, Error> {
        self.raw.enter_initialization(start, stop)?;
        Ok(self.into_state())
    }
}

impl Instance<Initializing> {
    /// `fmi2ExitInitializationMode`, or `fmi3ExitInitializationMode` with the events at the start.
    ///
    /// # Errors
    /// When the FMU refuses, or its events do not come to rest.
    pub fn exit_initialization(mut self) -> Result<Instance<Stepping>, Error> {
        self.raw.exit_initialization()?;
        Ok(self.into_state())
    }
}

impl Instance<Stepping> {
    /// `fmi2DoStep` or `fmi3DoStep` from `time` over `step`, in s. An FMI 3.0 FMU that returns early is called again
    /// until the step is complete. States older than `time` may still be restored, so
    /// `noSetFMUStatePriorToCurrentPoint` is always false.
    ///
    /// # Errors
    /// Discard, error and fatal, with the last successful time where the FMU tells it; [`Error::Ended`] when the FMU
    /// asks for the end of the simulation; [`Error::Misbehaved`] when it makes no progress or leaves the step.
    pub fn do_step(&mut self, time: f64, step: f64) -> Result<(), Error> {
        self.raw.callable()?;
        self.raw.do_step(time, step)
    }

    /// `fmi2GetFMUstate` or `fmi3GetFMUState`, reusing a handle that is no longer held where there is one.
    ///
    /// # Errors
    /// When the FMU has no such function or refuses.
    pub fn save(&mut self) -> Result<State, Error> {
        self.raw.save()
    }

    /// `fmi2SetFMUstate` or `fmi3SetFMUState`.
    ///
    /// # Errors
    /// When the state belongs to another instance, or the FMU refuses.
    pub fn restore(&mut self, state: &State) -> Result<(), Error> {
        self.raw.restore(state)
    }

    /// `fmi2SerializeFMUstate` or `fmi3SerializeFMUState`.
    ///
    /// # Errors
    /// When the state belongs to another instance, or the FMU does not serialise.
    pub fn serialize(&mut self, state: &State) -> Result<Vec<u8>, Error> {
        self.raw.serialize(state)
    }

    /// `fmi2DeSerializeFMUstate` or `fmi3DeserializeFMUState`.
    ///
    /// # Errors
    /// When the FMU refuses.
    pub fn deserialize(&mut self, bytes: &[u8]) -> Result<State, Error> {
        self.raw.deserialize(bytes)
    }

    /// `fmi2Reset` or `fmi3Reset`.
    ///
    /// # Errors
    /// When the FMU refuses.
    pub fn reset(mut self) -> Result<Instance<Instantiated>, Error> {
        self.raw.reset()?;
        Ok(self.into_state())
    }
}
