//! What only FMI 2.0 does its way: instantiation, the experiment, the step.
#![expect(unsafe_code, reason = "calls the C functions of a loaded FMU")]

use std::ffi::c_void;
use std::ptr;

use super::abi;
use super::abi2::{self, Callbacks, Functions};
use super::error::Error;
use super::library::Slave;
use super::log::{Environment, fmi_hazard_logger};
use super::raw::{Raw, c_text};

unsafe extern "C" {
    fn calloc(count: usize, size: usize) -> *mut c_void;
    fn free(memory: *mut c_void);
}

/// `fmi2Instantiate`.
pub(super) fn instantiate(slave: &Slave, functions: &Functions, name: &str) -> Result<Raw, Error> {
    let (name, guid) = (c_text(name)?, c_text(slave.guid())?);
    let resources = c_text(slave.resources().unwrap_or_default())?;
    let environment = Box::<Environment>::default();
    let callbacks = Box::new(Callbacks {
        logger: fmi_hazard_logger as *const c_void,
        allocate_memory: calloc,
        free_memory: free,
        step_finished: ptr::null(),
        environment: environment.address(),
    });
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
    Raw::adopt(slave, component, environment, Some(callbacks), false)
}

impl Raw {
    /// `fmi2SetupExperiment` and `fmi2EnterInitializationMode`.
    pub(super) fn enter_initialization2(&mut self, f: &Functions, start: f64, stop: Option<f64>) -> Result<(), Error> {
        let defined = if stop.is_some() { abi2::TRUE } else { abi2::FALSE };
        // SAFETY: the instance is alive and freshly instantiated or reset.
        let status =
            unsafe { (f.setup_experiment)(self.component, abi2::FALSE, 0.0, start, defined, stop.unwrap_or(0.0)) };
        self.check("fmi2SetupExperiment", status)?;
        // SAFETY: as above, the experiment is set up.
        let status = unsafe { (f.enter_initialization_mode)(self.component) };
        self.check("fmi2EnterInitializationMode", status)
    }

    /// `fmi2DoStep`. A step that is discarded is an error, with how far it came; or the end, if the FMU says so.
    pub(super) fn do_step2(&mut self, f: &Functions, time: f64, step: f64) -> Result<(), Error> {
        // SAFETY: the instance is alive and initialised.
        let status = unsafe { (f.do_step)(self.component, time, step, abi2::FALSE) };
        if status == abi::OK || status == abi::WARNING {
            return Ok(());
        }
        let mut last = None;
        if let (abi::DISCARD, Some(ask)) = (status, f.get_real_status) {
            let mut value = f64::NAN;
            // SAFETY: asking for the status after Discard is what the function is for.
            let answer = unsafe { ask(self.component, abi2::LAST_SUCCESSFUL_TIME, &raw mut value) };
            last = (answer == abi::OK && value.is_finite()).then_some(value);
        }
        if let (abi::DISCARD, Some(ask)) = (status, f.get_boolean_status) {
            let mut terminated = abi2::FALSE;
            // SAFETY: as above.
            let answer = unsafe { ask(self.component, abi2::TERMINATED, &raw mut terminated) };
            if answer == abi::OK && terminated != abi2::FALSE {
                return Err(self.ended(last.unwrap_or(time)));
            }
        }
        Err(self.failure("fmi2DoStep", status, Some(time), last))
    }
}
