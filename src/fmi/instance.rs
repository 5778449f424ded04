//! An FMI 2.0 co-simulation slave: its life as types, its values, its saved states.
//!
//! `Instantiated -> Initializing -> Stepping`: a call that FMI does not allow in a state does not compile. States are
//! owned by the instance that made them: dropping a [`State`] gives its handle back for reuse, and all handles are
//! freed before the instance is.
#![expect(unsafe_code, reason = "calls the C functions of a loaded FMU")]

use std::ffi::{CStr, CString, c_char, c_int, c_void};
use std::marker::PhantomData;
use std::ptr;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use super::abi2::{self, Callbacks, Component, FmuState};
use super::error::{CallFailure, Error, Log, Status};
use super::library::Slave;

/// Instantiated, parameters and start values can be set.
#[derive(Debug)]
pub struct Instantiated;
/// In initialisation mode.
#[derive(Debug)]
pub struct Initializing;
/// Initialised: steps, states, results.
#[derive(Debug)]
pub struct Stepping;

/// Log lines kept for error messages.
const LOG_LINES: usize = 10;

/// What the logger callback writes to; lives as long as the instance.
#[derive(Default)]
struct Environment {
    lines: Mutex<Vec<String>>,
}

unsafe extern "C" {
    /// The C shim that formats a log message; passed to FMUs, never called from Rust.
    fn fmi_hazard_logger();
    fn calloc(count: usize, size: usize) -> *mut c_void;
    fn free(memory: *mut c_void);
}

/// Called by the C shim with a formatted log message.
#[unsafe(no_mangle)]
extern "C" fn fmi_hazard_log(environment: *mut c_void, status: c_int, category: *const c_char, message: *const c_char) {
    if environment.is_null() || message.is_null() || category.is_null() {
        return;
    }
    // SAFETY: `environment` is the `Environment` whose address was given at instantiation and which outlives the
    // instance; the shim passes NUL-terminated texts that live during the call.
    let (environment, category, message) =
        unsafe { (&*environment.cast::<Environment>(), CStr::from_ptr(category), CStr::from_ptr(message)) };
    // Ordinary chatter is dropped; what comes with a status worse than OK, or an error category, is kept.
    let category = category.to_string_lossy();
    if status == abi2::OK && !category.to_lowercase().contains("err") {
        return;
    }
    let text: String =
        message.to_string_lossy().trim_end().chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    let mut lines = lock(&environment.lines);
    if lines.len() == LOG_LINES {
        lines.remove(0);
    }
    lines.push(if category.is_empty() { text } else { format!("[{category}] {text}") });
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Handles that no [`State`] holds any more.
#[derive(Default)]
struct FreeList {
    handles: Mutex<Vec<Handle>>,
}

/// A raw state handle.
struct Handle(FmuState);
// SAFETY: a handle is an opaque pointer that is only ever passed to functions of its own instance, one at a time.
unsafe impl Send for Handle {}

/// A saved state of one instance.
pub struct State {
    owner: u64,
    handle: Option<Handle>,
    home: Arc<FreeList>,
}

impl Drop for State {
    fn drop(&mut self) {
        if let Some(handle) = self.handle.take() {
            lock(&self.home.handles).push(handle);
        }
    }
}

/// The living C instance; frees itself.
struct Raw {
    slave: Slave,
    component: Component,
    stepping: bool,
    id: u64,
    free_list: Arc<FreeList>,
    /// Every handle ever received, for freeing.
    handles: Vec<FmuState>,
    environment: Box<Environment>,
    // The callbacks must stay where the FMU was told they are.
    _callbacks: Box<Callbacks>,
}

// SAFETY: FMI 2.0 allows an instance to be used from any thread, one at a time; `Raw` is not `Sync` and every call
// takes `&mut self`. The environment is behind a mutex.
unsafe impl Send for Raw {}

impl Drop for Raw {
    fn drop(&mut self) {
        if self.slave.is_poisoned() {
            // After a fatal error no call is allowed, not even the one that frees.
            return;
        }
        let functions = self.slave.functions();
        if let Some(free_state) = functions.free_state {
            for mut handle in self.handles.drain(..) {
                // SAFETY: the handle was given by this instance and is freed once.
                unsafe { free_state(self.component, &raw mut handle) };
            }
        }
        if let Some(terminate) = functions.terminate.filter(|_| self.stepping) {
            // SAFETY: the instance is initialised and not fatal.
            unsafe { terminate(self.component) };
        }
        // SAFETY: the component came from `fmi2Instantiate` and is freed once.
        unsafe { (functions.free_instance)(self.component) };
    }
}

/// An FMI 2.0 co-simulation instance in lifecycle state `S`.
pub struct Instance<S> {
    raw: Raw,
    state: PhantomData<S>,
}

static NEXT_ID: AtomicU64 = AtomicU64::new(0);

impl Slave {
    /// Makes an instance.
    ///
    /// # Errors
    /// When the FMU refuses, with its own log lines.
    pub fn instantiate(&self, name: &str) -> Result<Instance<Instantiated>, Error> {
        if self.is_poisoned() {
            return Err(Error::AfterFatal);
        }
        let text =
            |s: &str| CString::new(s).map_err(|_| Error::Instantiation("a name contains a NUL character".to_owned()));
        let (name, guid, resources) = (text(name)?, text(self.guid())?, text(self.resource_uri())?);
        let environment = Box::<Environment>::default();
        let callbacks = Box::new(Callbacks {
            logger: fmi_hazard_logger as *const c_void,
            allocate_memory: calloc,
            free_memory: free,
            step_finished: ptr::null(),
            environment: (&raw const *environment).cast_mut().cast(),
        });
        let functions = self.functions();
        // SAFETY: all pointers are valid during the call; the callbacks and the environment live in boxes that the
        // instance keeps until it is freed.
        let component = unsafe {
            (functions.instantiate)(
                name.as_ptr(),
                abi2::CO_SIMULATION,
                guid.as_ptr(),
                resources.as_ptr(),
                &raw const *callbacks,
                abi2::FALSE,
                abi2::FALSE,
            )
        };
        if component.is_null() {
            let lines = lock(&environment.lines).clone();
            let hint = if lines.iter().any(|l| l.to_lowercase().contains("guid")) {
                ": binary and modelDescription.xml come from different exports. Export the FMU again"
            } else if self.capabilities().once_per_process {
                ": it allows one instance in a process only"
            } else {
                ""
            };
            return Err(Error::Instantiation(format!("the FMU refused to be instantiated{hint}{}", Log(&lines))));
        }
        let raw = Raw {
            slave: self.clone(),
            component,
            stepping: false,
            id: NEXT_ID.fetch_add(1, Ordering::Relaxed),
            free_list: Arc::default(),
            handles: Vec::new(),
            environment,
            _callbacks: callbacks,
        };
        Ok(Instance { raw, state: PhantomData })
    }
}

macro_rules! access {
    ($get:ident, $set:ident, $type:ty, $get_name:literal, $set_name:literal) => {
        #[doc = concat!("`", $get_name, "`: values of the variables with these references, in their order.")]
        ///
        /// # Errors
        /// When the FMU refuses.
        pub fn $get(&mut self, references: &[u32], values: &mut [$type]) -> Result<(), Error> {
            assert_eq!(references.len(), values.len(), "one value for each reference");
            self.raw.callable()?;
            let function = self.raw.slave.functions().$get.ok_or(Error::MissingFunction($get_name))?;
            let (component, count) = (self.raw.component, references.len());
            // SAFETY: both arrays have the length that is passed, and the instance is alive.
            let status = unsafe { function(component, references.as_ptr(), count, values.as_mut_ptr()) };
            self.raw.check($get_name, status)
        }

        #[doc = concat!("`", $set_name, "`.")]
        ///
        /// # Errors
        /// When the FMU refuses.
        pub fn $set(&mut self, references: &[u32], values: &[$type]) -> Result<(), Error> {
            assert_eq!(references.len(), values.len(), "one value for each reference");
            self.raw.callable()?;
            let function = self.raw.slave.functions().$set.ok_or(Error::MissingFunction($set_name))?;
            let (component, count) = (self.raw.component, references.len());
            // SAFETY: both arrays have the length that is passed, and the instance is alive.
            let status = unsafe { function(component, references.as_ptr(), count, values.as_ptr()) };
            self.raw.check($set_name, status)
        }
    };
}

impl<S> Instance<S> {
    access!(get_real, set_real, f64, "fmi2GetReal", "fmi2SetReal");
    access!(get_integer, set_integer, i32, "fmi2GetInteger", "fmi2SetInteger");

    /// `fmi2GetBoolean`.
    ///
    /// # Errors
    /// When the FMU refuses.
    pub fn get_boolean(&mut self, references: &[u32], values: &mut [bool]) -> Result<(), Error> {
        assert_eq!(references.len(), values.len(), "one value for each reference");
        self.raw.callable()?;
        let function = self.raw.slave.functions().get_boolean.ok_or(Error::MissingFunction("fmi2GetBoolean"))?;
        let mut numbers = vec![abi2::FALSE; values.len()];
        // SAFETY: both arrays have the length that is passed, and the instance is alive.
        let status =
            unsafe { function(self.raw.component, references.as_ptr(), references.len(), numbers.as_mut_ptr()) };
        self.raw.check("fmi2GetBoolean", status)?;
        values.iter_mut().zip(numbers).for_each(|(v, n)| *v = n != abi2::FALSE);
        Ok(())
    }

    /// `fmi2SetBoolean`.
    ///
    /// # Errors
    /// When the FMU refuses.
    pub fn set_boolean(&mut self, references: &[u32], values: &[bool]) -> Result<(), Error> {
        assert_eq!(references.len(), values.len(), "one value for each reference");
        self.raw.callable()?;
        let function = self.raw.slave.functions().set_boolean.ok_or(Error::MissingFunction("fmi2SetBoolean"))?;
        let numbers: Vec<c_int> = values.iter().map(|v| if *v { abi2::TRUE } else { abi2::FALSE }).collect();
        // SAFETY: both arrays have the length that is passed, and the instance is alive.
        let status = unsafe { function(self.raw.component, references.as_ptr(), references.len(), numbers.as_ptr()) };
        self.raw.check("fmi2SetBoolean", status)
    }

    fn into_state<T>(self) -> Instance<T> {
        Instance { raw: self.raw, state: PhantomData }
    }
}

impl Instance<Instantiated> {
    /// `fmi2SetupExperiment` and `fmi2EnterInitializationMode`; times in s.
    ///
    /// # Errors
    /// When the FMU refuses.
    pub fn enter_initialization(mut self, start: f64, stop: Option<f64>) -> Result<Instance<Initializing>, Error> {
        self.raw.callable()?;
        let functions = self.raw.slave.functions();
        let defined = if stop.is_some() { abi2::TRUE } else { abi2::FALSE };
        // SAFETY: the instance is alive and freshly instantiated or reset.
        let status = unsafe {
            (functions.setup_experiment)(self.raw.component, abi2::FALSE, 0.0, start, defined, stop.unwrap_or(0.0))
        };
        self.raw.check("fmi2SetupExperiment", status)?;
        // SAFETY: as above, the experiment is set up.
        let status = unsafe { (self.raw.slave.functions().enter_initialization_mode)(self.raw.component) };
        self.raw.check("fmi2EnterInitializationMode", status)?;
        Ok(self.into_state())
    }
}

impl Instance<Initializing> {
    /// `fmi2ExitInitializationMode`.
    ///
    /// # Errors
    /// When the FMU refuses.
    pub fn exit_initialization(mut self) -> Result<Instance<Stepping>, Error> {
        self.raw.callable()?;
        // SAFETY: the instance is alive and in initialisation mode.
        let status = unsafe { (self.raw.slave.functions().exit_initialization_mode)(self.raw.component) };
        self.raw.check("fmi2ExitInitializationMode", status)?;
        self.raw.stepping = true;
        Ok(self.into_state())
    }
}

impl Instance<Stepping> {
    /// `fmi2DoStep` from `time` over `step`, in s. States older than `time` may still be restored, so
    /// `noSetFMUStatePriorToCurrentPoint` is always false.
    ///
    /// # Errors
    /// Discard, error and fatal, with the last successful time where the FMU tells it.
    pub fn do_step(&mut self, time: f64, step: f64) -> Result<(), Error> {
        self.raw.callable()?;
        let functions = self.raw.slave.functions();
        // SAFETY: the instance is alive and initialised.
        let status = unsafe { (functions.do_step)(self.raw.component, time, step, abi2::FALSE) };
        if status == abi2::OK || status == abi2::WARNING {
            return Ok(());
        }
        let mut last = None;
        if let (abi2::DISCARD, Some(ask)) = (status, functions.get_real_status) {
            let mut value = f64::NAN;
            // SAFETY: asking for the status after Discard is what the function is for.
            let answer = unsafe { ask(self.raw.component, abi2::LAST_SUCCESSFUL_TIME, &raw mut value) };
            last = (answer == abi2::OK && value.is_finite()).then_some(value);
        }
        self.raw.fail("fmi2DoStep", status, Some(time), last)
    }

    /// `fmi2GetFMUstate`, reusing a handle that is no longer held where there is one.
    ///
    /// # Errors
    /// When the FMU has no such function or refuses.
    pub fn save(&mut self) -> Result<State, Error> {
        self.raw.callable()?;
        let function = self.raw.slave.functions().get_state.ok_or(Error::MissingFunction("fmi2GetFMUstate"))?;
        let reused = lock(&self.raw.free_list.handles).pop();
        let fresh = reused.is_none();
        let mut handle = reused.map_or(ptr::null_mut(), |h| h.0);
        // SAFETY: the handle is NULL or one that this instance gave and that has not been freed.
        let status = unsafe { function(self.raw.component, &raw mut handle) };
        if fresh && !handle.is_null() {
            self.raw.handles.push(handle);
        }
        let state = (!handle.is_null()).then(|| self.raw.state(handle));
        self.raw.check("fmi2GetFMUstate", status)?;
        state.ok_or_else(|| self.raw.nothing_given("fmi2GetFMUstate"))
    }

    /// `fmi2SetFMUstate`.
    ///
    /// # Errors
    /// When the state belongs to another instance, or the FMU refuses.
    pub fn restore(&mut self, state: &State) -> Result<(), Error> {
        self.raw.callable()?;
        let function = self.raw.slave.functions().set_state.ok_or(Error::MissingFunction("fmi2SetFMUstate"))?;
        let handle = self.raw.own(state)?;
        // SAFETY: the handle was given by this instance and has not been freed.
        let status = unsafe { function(self.raw.component, handle) };
        self.raw.check("fmi2SetFMUstate", status)
    }

    /// `fmi2SerializeFMUstate`.
    ///
    /// # Errors
    /// When the state belongs to another instance, or the FMU does not serialise.
    pub fn serialize(&mut self, state: &State) -> Result<Vec<u8>, Error> {
        self.raw.callable()?;
        let functions = self.raw.slave.functions();
        let size_of = functions.serialized_size.ok_or(Error::MissingFunction("fmi2SerializedFMUstateSize"))?;
        let serialize = functions.serialize_state.ok_or(Error::MissingFunction("fmi2SerializeFMUstate"))?;
        let handle = self.raw.own(state)?;
        let mut size = 0;
        // SAFETY: the handle was given by this instance; `size` is written during the call.
        let status = unsafe { size_of(self.raw.component, handle, &raw mut size) };
        self.raw.check("fmi2SerializedFMUstateSize", status)?;
        let mut bytes = vec![0_u8; size];
        // SAFETY: the buffer has the size that the FMU asked for.
        let status = unsafe { serialize(self.raw.component, handle, bytes.as_mut_ptr().cast(), size) };
        self.raw.check("fmi2SerializeFMUstate", status)?;
        Ok(bytes)
    }

    /// `fmi2DeSerializeFMUstate`.
    ///
    /// # Errors
    /// When the FMU refuses.
    pub fn deserialize(&mut self, bytes: &[u8]) -> Result<State, Error> {
        self.raw.callable()?;
        let name = "fmi2DeSerializeFMUstate";
        let function = self.raw.slave.functions().deserialize_state.ok_or(Error::MissingFunction(name))?;
        let mut handle = ptr::null_mut();
        // SAFETY: the bytes have the length that is passed; the handle is NULL, so the FMU makes a new one.
        let status = unsafe { function(self.raw.component, bytes.as_ptr().cast(), bytes.len(), &raw mut handle) };
        if !handle.is_null() {
            self.raw.handles.push(handle);
        }
        let state = (!handle.is_null()).then(|| self.raw.state(handle));
        self.raw.check(name, status)?;
        state.ok_or_else(|| self.raw.nothing_given(name))
    }

    /// `fmi2Reset`.
    ///
    /// # Errors
    /// When the FMU refuses.
    pub fn reset(mut self) -> Result<Instance<Instantiated>, Error> {
        self.raw.callable()?;
        let function = self.raw.slave.functions().reset.ok_or(Error::MissingFunction("fmi2Reset"))?;
        // SAFETY: the instance is alive and not fatal.
        let status = unsafe { function(self.raw.component) };
        self.raw.check("fmi2Reset", status)?;
        self.raw.stepping = false;
        Ok(self.into_state())
    }
}

impl Raw {
    /// After a fatal error of any instance nothing may be called.
    fn callable(&self) -> Result<(), Error> {
        if self.slave.is_poisoned() { Err(Error::AfterFatal) } else { Ok(()) }
    }

    fn state(&self, handle: FmuState) -> State {
        State { owner: self.id, handle: Some(Handle(handle)), home: Arc::clone(&self.free_list) }
    }

    fn own(&self, state: &State) -> Result<FmuState, Error> {
        match &state.handle {
            Some(handle) if state.owner == self.id => Ok(handle.0),
            _ => Err(Error::ForeignState),
        }
    }

    fn nothing_given(&self, function: &'static str) -> Error {
        let log = vec!["it returned OK but gave no state".to_owned()];
        Error::Call(Box::new(CallFailure {
            function,
            status: Status::Error,
            time_s: None,
            last_successful_s: None,
            log,
        }))
    }

    fn check(&mut self, function: &'static str, status: abi2::StatusCode) -> Result<(), Error> {
        if status == abi2::OK || status == abi2::WARNING { Ok(()) } else { self.fail(function, status, None, None) }
    }

    fn fail(
        &mut self,
        function: &'static str,
        status: abi2::StatusCode,
        time_s: Option<f64>,
        last_successful_s: Option<f64>,
    ) -> Result<(), Error> {
        let status = match status {
            abi2::DISCARD => Status::Discard,
            abi2::ERROR => Status::Error,
            abi2::FATAL => Status::Fatal,
            abi2::PENDING => Status::Pending,
            other => Status::Unknown(other),
        };
        if status == Status::Fatal {
            self.slave.poison();
        }
        let log = std::mem::take(&mut *lock(&self.environment.lines));
        Err(Error::Call(Box::new(CallFailure { function, status, time_s, last_successful_s, log })))
    }
}
