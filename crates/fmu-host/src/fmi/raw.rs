//! The living C instance, whichever version: what is alike in FMI 2.0 and FMI 3.0, above all its states and its end.
#![expect(unsafe_code, reason = "calls the C functions of a loaded FMU")]

use std::ffi::{CString, c_int};
use std::ptr;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex};

use super::abi::{self, Component, FmuState, StatusCode};
use super::abi2::Callbacks;
use super::error::{CallFailure, Error, Log, Status};
use super::library::{Slave, Table};
use super::log::{Environment, lock};

/// Handles that no [`State`] holds any more.
#[derive(Default)]
struct FreeList {
    handles: Mutex<Vec<StateHandle>>,
}

/// A serialised state of more bytes is taken for a mistake, or for an attack on our memory.
const MOST_STATE_BYTES: usize = 1 << 30;

/// A raw state handle.
struct StateHandle(FmuState);
// SAFETY: a handle is an opaque pointer that is only ever passed to functions of its own instance, one at a time.
unsafe impl Send for StateHandle {}

/// A saved state of one instance.
pub struct State {
    owner: u64,
    handle: Option<StateHandle>,
    home: Arc<FreeList>,
    now: f64,
    next_event: Option<f64>,
}

impl Drop for State {
    fn drop(&mut self) {
        if let Some(handle) = self.handle.take() {
            lock(&self.home.handles).push(handle);
        }
    }
}

/// The living C instance; frees itself.
pub(super) struct Raw {
    pub(super) slave: Slave,
    pub(super) component: Component,
    /// Initialised and not failed: in Step Mode, where the version has modes.
    pub(super) stepping: bool,
    /// FMI 3.0: events are handled with the FMU.
    pub(super) events: bool,
    /// Communication time, s, for messages.
    pub(super) now: f64,
    /// FMI 3.0: the next event that the FMU announced in Event Mode, s.
    pub(super) next_event: Option<f64>,
    /// Memory for the booleans of FMI 2.0, which are integers, and of FMI 3.0, which are bytes: no allocation per step.
    pub(super) integers: Vec<c_int>,
    pub(super) bytes: Vec<u8>,
    id: u64,
    free_list: Arc<FreeList>,
    /// Every handle ever received, for freeing.
    handles: Vec<FmuState>,
    pub(super) environment: Box<Environment>,
    // FMI 2.0: the callbacks must stay where the FMU was told they are.
    _callbacks: Option<Box<Callbacks>>,
}

// SAFETY: both versions allow an instance to be used from any thread, one at a time; `Raw` is not `Sync` and every call
// takes `&mut self`. The environment is behind a mutex.
unsafe impl Send for Raw {}

impl Drop for Raw {
    fn drop(&mut self) {
        if self.slave.is_poisoned() {
            // After a fatal error no call is allowed, not even the one that frees.
            return;
        }
        let common = self.slave.common();
        if let Some(free_state) = common.free_state {
            for mut handle in self.handles.drain(..) {
                // SAFETY: the handle was given by this instance and is freed once.
                unsafe { free_state(self.component, &raw mut handle) };
            }
        }
        if let Some(terminate) = common.terminate.filter(|_| self.stepping) {
            // SAFETY: the instance is initialised and not fatal.
            unsafe { terminate(self.component) };
        }
        // SAFETY: the component came from the FMU's instantiation and is freed once.
        unsafe { (common.free_instance)(self.component) };
    }
}

static NEXT_ID: AtomicU64 = AtomicU64::new(0);

/// A text as C wants it.
pub(super) fn c_text(text: &str) -> Result<CString, Error> {
    CString::new(text).map_err(|_| Error::Instantiation("a name contains a NUL character".to_owned()))
}

impl Raw {
    /// Takes over what the FMU made; an error with its log lines if that is nothing.
    pub(super) fn adopt(
        slave: &Slave,
        component: Component,
        environment: Box<Environment>,
        callbacks: Option<Box<Callbacks>>,
        events: bool,
    ) -> Result<Self, Error> {
        if component.is_null() {
            let lines = environment.lines();
            let about = |word: &str| lines.iter().any(|l| l.to_lowercase().contains(word));
            let hint = if about("guid") || about("token") {
                ": binary and modelDescription.xml come from different exports. Export the FMU again"
            } else if slave.capabilities().once_per_process {
                ": it allows one instance in a process only"
            } else if slave.capabilities().needs_execution_tool {
                ": it needs the tool that made it (needsExecutionTool). Install and license that tool on this machine"
            } else {
                ""
            };
            return Err(Error::Instantiation(format!("the FMU refused to be instantiated{hint}{}", Log(&lines))));
        }
        Ok(Self {
            slave: slave.clone(),
            component,
            stepping: false,
            events,
            now: 0.0,
            next_event: None,
            integers: Vec::new(),
            bytes: Vec::new(),
            id: NEXT_ID.fetch_add(1, Ordering::Relaxed),
            free_list: Arc::default(),
            handles: Vec::new(),
            environment,
            _callbacks: callbacks,
        })
    }

    /// After a fatal error of any instance nothing may be called.
    pub(super) fn callable(&self) -> Result<(), Error> {
        if self.slave.is_poisoned() { Err(Error::AfterFatal) } else { Ok(()) }
    }

    pub(super) fn check(&mut self, function: &'static str, status: StatusCode) -> Result<(), Error> {
        if status == abi::OK || status == abi::WARNING {
            return Ok(());
        }
        Err(self.failure(function, status, None, None))
    }

    /// The error of a call that returned `status`; a fatal one ends all calls.
    pub(super) fn failure(
        &mut self,
        function: &'static str,
        status: StatusCode,
        time_s: Option<f64>,
        last_successful_s: Option<f64>,
    ) -> Error {
        let third = matches!(self.slave.table(), Table::V3(_));
        let status = match status {
            abi::DISCARD => Status::Discard,
            abi::ERROR => Status::Error,
            abi::FATAL => Status::Fatal,
            abi::PENDING if !third => Status::Pending,
            other => Status::Unknown(other),
        };
        if status == Status::Fatal {
            self.slave.poison();
        }
        // FMI 3.0: an error leads to the state Terminated, from where it cannot be terminated once more.
        self.stepping &= !third || status == Status::Discard;
        let note = (third && status == Status::Discard && time_s.is_some())
            .then_some("it is in the same state as before this call, nothing of the step was done");
        let log = self.environment.take();
        Error::Call(Box::new(CallFailure { function, status, time_s, last_successful_s, note, log }))
    }

    /// The error of an FMU that ends the simulation.
    pub(super) fn ended(&self, time_s: f64) -> Error {
        Error::Ended { time_s, log: self.environment.take() }
    }

    /// The error of an FMU that answers OK and nonsense.
    pub(super) fn misbehaved(&self, message: String) -> Error {
        Error::Misbehaved { message, log: self.environment.take() }
    }

    pub(super) fn enter_initialization(&mut self, start: f64, stop: Option<f64>) -> Result<(), Error> {
        self.callable()?;
        match self.slave.table() {
            Table::V2(functions) => self.enter_initialization2(functions, start, stop),
            Table::V3(functions) => self.enter_initialization3(functions, start, stop),
        }
    }

    pub(super) fn do_step(&mut self, time: f64, step: f64) -> Result<(), Error> {
        self.callable()?;
        match self.slave.table() {
            Table::V2(functions) => self.do_step2(functions, time, step),
            Table::V3(functions) => self.do_step3(functions, time, step),
        }
    }

    pub(super) fn exit_initialization(&mut self) -> Result<(), Error> {
        self.callable()?;
        let common = self.slave.common();
        let (function, name) = (common.exit_initialization_mode, common.names.exit_initialization_mode);
        // SAFETY: the instance is alive and in initialisation mode.
        let status = unsafe { function(self.component) };
        self.check(name, status)?;
        self.stepping = true;
        // FMI 3.0 with events: the FMU is in Event Mode now.
        if self.events { self.settle() } else { Ok(()) }
    }

    pub(super) fn reset(&mut self) -> Result<(), Error> {
        self.callable()?;
        let common = self.slave.common();
        let (function, name) = (common.reset, common.names.reset);
        let function = function.ok_or(Error::MissingFunction(name))?;
        // SAFETY: the instance is alive and not fatal.
        let status = unsafe { function(self.component) };
        self.check(name, status)?;
        (self.stepping, self.next_event) = (false, None);
        Ok(())
    }

    pub(super) fn save(&mut self) -> Result<State, Error> {
        self.callable()?;
        let common = self.slave.common();
        let (function, name) = (common.get_state, common.names.get_state);
        let function = function.ok_or(Error::MissingFunction(name))?;
        let reused = lock(&self.free_list.handles).pop();
        let fresh = reused.is_none();
        let mut handle = reused.map_or(ptr::null_mut(), |h| h.0);
        // SAFETY: the handle is NULL or one that this instance gave and that has not been freed.
        let status = unsafe { function(self.component, &raw mut handle) };
        self.received(name, handle, fresh, (self.next_event, status))
    }

    pub(super) fn restore(&mut self, state: &State) -> Result<(), Error> {
        self.callable()?;
        let common = self.slave.common();
        let (function, name) = (common.set_state, common.names.set_state);
        let function = function.ok_or(Error::MissingFunction(name))?;
        let handle = self.own(state)?;
        // SAFETY: the handle was given by this instance and has not been freed.
        let status = unsafe { function(self.component, handle) };
        self.check(name, status)?;
        // States are saved while stepping, and the mode is part of a state.
        self.stepping = true;
        (self.now, self.next_event) = (state.now, state.next_event);
        Ok(())
    }

    pub(super) fn serialize(&mut self, state: &State) -> Result<Vec<u8>, Error> {
        self.callable()?;
        let common = self.slave.common();
        let names = common.names;
        let size_of = common.serialized_size.ok_or(Error::MissingFunction(names.serialized_size))?;
        let serialize = common.serialize_state.ok_or(Error::MissingFunction(names.serialize_state))?;
        let handle = self.own(state)?;
        let mut size = 0;
        // SAFETY: the handle was given by this instance; `size` is written during the call.
        let status = unsafe { size_of(self.component, handle, &raw mut size) };
        self.check(names.serialized_size, status)?;
        if size > MOST_STATE_BYTES {
            let name = names.serialized_size;
            return Err(self.misbehaved(format!("{name} says that a state has {size} bytes, which cannot be")));
        }
        let mut bytes = vec![0_u8; size];
        // SAFETY: the buffer has the size that the FMU asked for.
        let status = unsafe { serialize(self.component, handle, bytes.as_mut_ptr(), size) };
        self.check(names.serialize_state, status)?;
        if self.events {
            // What the FMU announced belongs to its state, and it does not tell it again.
            bytes.extend(state.next_event.unwrap_or(f64::INFINITY).to_le_bytes());
        }
        Ok(bytes)
    }

    pub(super) fn deserialize(&mut self, bytes: &[u8]) -> Result<State, Error> {
        self.callable()?;
        let common = self.slave.common();
        let (function, name) = (common.deserialize_state, common.names.deserialize_state);
        let function = function.ok_or(Error::MissingFunction(name))?;
        let mut handle = ptr::null_mut();
        let (bytes, next_event) = match bytes.split_last_chunk() {
            Some((rest, next)) if self.events => {
                (rest, Some(f64::from_le_bytes(*next)).filter(|next| next.is_finite()))
            }
            _ => (bytes, None),
        };
        // SAFETY: the bytes have the length that is passed; the handle is NULL, so the FMU makes a new one.
        let status = unsafe { function(self.component, bytes.as_ptr(), bytes.len(), &raw mut handle) };
        self.received(name, handle, true, (next_event, status))
    }

    /// A handle as the FMU left it: owned whatever the status, so that it is freed.
    fn received(
        &mut self,
        function: &'static str,
        handle: FmuState,
        fresh: bool,
        (next_event, status): (Option<f64>, StatusCode),
    ) -> Result<State, Error> {
        if fresh && !handle.is_null() {
            self.handles.push(handle);
        }
        let state = (!handle.is_null()).then(|| State {
            owner: self.id,
            handle: Some(StateHandle(handle)),
            home: Arc::clone(&self.free_list),
            now: self.now,
            next_event,
        });
        self.check(function, status)?;
        state.ok_or_else(|| self.misbehaved(format!("{function} returned OK but gave no state")))
    }

    fn own(&self, state: &State) -> Result<FmuState, Error> {
        match &state.handle {
            Some(handle) if state.owner == self.id => Ok(handle.0),
            _ => Err(Error::ForeignState),
        }
    }
}
