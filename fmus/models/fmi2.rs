//! The C interface of FMI 2.0 for co-simulation: checks pointers, calls `component`, returns a status.
//!
//! All functions follow `fmi2Functions.h` of FMI 2.0.4. A call that is not carried out leaves one line in the
//! importer's log. No panic crosses the interface: it becomes `fmi2Fatal`.
//!
//! # Safety
//! For every function the caller keeps the rules of the FMI standard: a component comes from `fmi2Instantiate` and
//! is not freed yet, is used by one thread at a time, arrays have the stated lengths, strings end with a zero byte,
//! and FMU states come from the same component. Null pointers are refused, as far as they can be told.

#![expect(unsafe_code, reason = "a C interface: raw pointers from the importer, exported symbols")]
#![allow(clippy::missing_safety_doc, reason = "said once, below, for all functions")]

use crate::component::{Answer, Component, Mode, Refusal, Saved, Severity, error};
use crate::interface::variables::Value;
pub use crate::pointers::Status;
use crate::pointers::{self, ERROR, array, array_mut};
use std::ffi::{CString, c_char, c_int, c_uint, c_void};
use std::panic::catch_unwind;

const CO_SIMULATION: c_int = 1;
/// Values of `fmi2StatusKind`.
const LAST_SUCCESSFUL_TIME: c_int = 2;
const TERMINATED: c_int = 3;

/// `fmi2CallbackLogger`: environment, instance name, status, category, printf format, arguments.
pub type Logger = unsafe extern "C" fn(*mut c_void, *const c_char, Status, *const c_char, *const c_char, ...);

/// `fmi2CallbackFunctions`. Memory comes from Rust's allocator: the importer's is not needed.
#[repr(C)]
#[derive(Debug)]
pub struct CallbackFunctions {
    /// Receives one line per call that was not carried out.
    pub logger: Option<Logger>,
    /// Not used.
    pub allocate_memory: *const c_void,
    /// Not used.
    pub free_memory: *const c_void,
    /// Not used: steps are synchronous.
    pub step_finished: *const c_void,
    /// Handed to the logger.
    pub environment: *mut c_void,
}

/// What an `fmi2Component` points to.
#[derive(Debug)]
pub struct Slave {
    component: Component,
    log: Log,
}

#[derive(Debug)]
struct Log {
    logger: Option<Logger>,
    environment: *mut c_void,
    instance_name: CString,
}

impl Log {
    fn write(&self, status: Status, message: &str) {
        let Some(logger) = self.logger else { return };
        let (category, text) = (pointers::category(status), pointers::line(message));
        // SAFETY: the importer gave this function and its environment for this use and keeps both valid until the
        // instance is freed; all strings end with zero and outlive the call; the format "%s" takes one string.
        unsafe {
            logger(
                self.environment,
                self.instance_name.as_ptr(),
                status,
                category.as_ptr(),
                c"%s".as_ptr(),
                text.as_ptr(),
            );
        }
    }
}

impl pointers::Instance for Slave {
    fn mode(&self) -> Mode {
        self.component.mode()
    }

    fn log(&self, status: Status, message: &str) {
        self.log.write(status, message);
    }
}

/// Runs one call on a component: catches panics, logs refusals, returns the status.
///
/// # Safety
/// See the head of this file.
unsafe fn call(slave: *mut Slave, function: &str, body: impl FnOnce(&mut Component) -> Answer) -> Status {
    // SAFETY: see the head of this file.
    unsafe { pointers::call(slave, function, |slave| body(&mut slave.component)) }
}

/// `fmi2GetTypesPlatform`
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetTypesPlatform() -> *const c_char {
    c"default".as_ptr()
}

/// `fmi2GetVersion`
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetVersion() -> *const c_char {
    c"2.0".as_ptr()
}

/// `fmi2SetDebugLogging`: there is no debug logging; errors are always logged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetDebugLogging(
    c: *mut Slave,
    _logging_on: c_int,
    _count: usize,
    _categories: *const *const c_char,
) -> Status {
    // SAFETY: see the head of this file.
    unsafe { call(c, "fmi2SetDebugLogging", |_| Ok(())) }
}

/// `fmi2Instantiate`: picks the model by its GUID; null on any error.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2Instantiate(
    instance_name: *const c_char,
    fmu_type: c_int,
    guid: *const c_char,
    _resource_location: *const c_char,
    functions: *const CallbackFunctions,
    _visible: c_int,
    _logging_on: c_int,
) -> *mut Slave {
    let made = catch_unwind(|| {
        // SAFETY: null is handled; otherwise the importer gives a valid structure.
        let functions = unsafe { functions.as_ref() };
        // SAFETY: the importer gives strings that end with zero.
        let (name, guid) = unsafe { (pointers::text(instance_name), pointers::text(guid)) };
        let log = Log {
            logger: functions.and_then(|functions| functions.logger),
            environment: functions.map_or(std::ptr::null_mut(), |functions| functions.environment),
            instance_name: name.unwrap_or_else(|| c"(no name)".to_owned()),
        };
        let component = if functions.is_none() || instance_name.is_null() {
            error("the callback functions and an instance name are required")
        } else if fmu_type != CO_SIMULATION {
            error("this FMU is for co-simulation only")
        } else {
            match guid {
                Some(guid) => Component::new(&guid.to_string_lossy()),
                None => error("a guid is required"),
            }
        };
        match component {
            Ok(component) => Box::into_raw(Box::new(Slave { component, log })),
            Err(refusal) => {
                log.write(ERROR, &format!("fmi2Instantiate: {}", refusal.message));
                std::ptr::null_mut()
            }
        }
    });
    made.unwrap_or(std::ptr::null_mut())
}

/// `fmi2FreeInstance`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2FreeInstance(c: *mut Slave) {
    if !c.is_null() {
        // SAFETY: made by `Box::into_raw` in `fmi2Instantiate` and not freed yet.
        drop(unsafe { Box::from_raw(c) });
    }
}

/// `fmi2SetupExperiment`: tolerance and stop time play no part.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetupExperiment(
    c: *mut Slave,
    _tolerance_defined: c_int,
    _tolerance: f64,
    start_time: f64,
    _stop_time_defined: c_int,
    _stop_time: f64,
) -> Status {
    // SAFETY: see the head of this file.
    unsafe { call(c, "fmi2SetupExperiment", |component| component.setup(start_time)) }
}

/// `fmi2EnterInitializationMode`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2EnterInitializationMode(c: *mut Slave) -> Status {
    // SAFETY: see the head of this file.
    unsafe { call(c, "fmi2EnterInitializationMode", Component::enter_initialization) }
}

/// `fmi2ExitInitializationMode`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2ExitInitializationMode(c: *mut Slave) -> Status {
    // SAFETY: see the head of this file.
    unsafe { call(c, "fmi2ExitInitializationMode", Component::exit_initialization) }
}

/// `fmi2Terminate`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2Terminate(c: *mut Slave) -> Status {
    // SAFETY: see the head of this file.
    unsafe { call(c, "fmi2Terminate", Component::terminate) }
}

/// `fmi2Reset`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2Reset(c: *mut Slave) -> Status {
    // SAFETY: see the head of this file.
    unsafe { call(c, "fmi2Reset", Component::reset) }
}

/// Reads variables one by one; `convert` refuses values of the wrong type.
///
/// # Safety
/// See the head of this file.
unsafe fn get<T>(
    c: *mut Slave,
    function: &str,
    references: *const c_uint,
    count: usize,
    values: *mut T,
    convert: impl Fn(Value) -> Option<T>,
) -> Status {
    // SAFETY: passed on from the importer, as the head of this file says.
    unsafe {
        call(c, function, |component| {
            let (references, values) = (array(references, count)?, array_mut(values, count)?);
            for (&reference, out) in references.iter().zip(values) {
                match convert(component.get(reference)?) {
                    Some(value) => *out = value,
                    None => return error(format!("value reference {reference} has another type")),
                }
            }
            Ok(())
        })
    }
}

/// Sets variables one by one.
///
/// # Safety
/// See the head of this file.
unsafe fn set<T: Copy>(
    c: *mut Slave,
    function: &str,
    references: *const c_uint,
    count: usize,
    values: *const T,
    convert: impl Fn(T) -> Value,
) -> Status {
    // SAFETY: passed on from the importer, as the head of this file says.
    unsafe {
        call(c, function, |component| {
            let (references, values) = (array(references, count)?, array(values, count)?);
            for (&reference, &value) in references.iter().zip(values) {
                component.set(reference, convert(value))?;
            }
            Ok(())
        })
    }
}

/// `fmi2GetReal`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetReal(c: *mut Slave, vr: *const c_uint, count: usize, values: *mut f64) -> Status {
    let convert = |value| if let Value::Real(x) = value { Some(x) } else { None };
    // SAFETY: see the head of this file.
    unsafe { get(c, "fmi2GetReal", vr, count, values, convert) }
}

/// `fmi2GetInteger`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetInteger(c: *mut Slave, vr: *const c_uint, count: usize, values: *mut c_int) -> Status {
    let convert = |value| if let Value::Integer(n) = value { Some(n) } else { None };
    // SAFETY: see the head of this file.
    unsafe { get(c, "fmi2GetInteger", vr, count, values, convert) }
}

/// `fmi2GetBoolean`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetBoolean(c: *mut Slave, vr: *const c_uint, count: usize, values: *mut c_int) -> Status {
    let convert = |value| if let Value::Boolean(b) = value { Some(c_int::from(b)) } else { None };
    // SAFETY: see the head of this file.
    unsafe { get(c, "fmi2GetBoolean", vr, count, values, convert) }
}

/// `fmi2GetString`: no model has strings.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetString(
    c: *mut Slave,
    vr: *const c_uint,
    count: usize,
    values: *mut *const c_char,
) -> Status {
    // SAFETY: see the head of this file.
    unsafe { get(c, "fmi2GetString", vr, count, values, |_| None) }
}

/// `fmi2SetReal`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetReal(c: *mut Slave, vr: *const c_uint, count: usize, values: *const f64) -> Status {
    // SAFETY: see the head of this file.
    unsafe { set(c, "fmi2SetReal", vr, count, values, Value::Real) }
}

/// `fmi2SetInteger`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetInteger(
    c: *mut Slave,
    vr: *const c_uint,
    count: usize,
    values: *const c_int,
) -> Status {
    // SAFETY: see the head of this file.
    unsafe { set(c, "fmi2SetInteger", vr, count, values, Value::Integer) }
}

/// `fmi2SetBoolean`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetBoolean(
    c: *mut Slave,
    vr: *const c_uint,
    count: usize,
    values: *const c_int,
) -> Status {
    // SAFETY: see the head of this file.
    unsafe { set(c, "fmi2SetBoolean", vr, count, values, |value| Value::Boolean(value != 0)) }
}

/// `fmi2SetString`: no model has strings.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetString(
    c: *mut Slave,
    _vr: *const c_uint,
    count: usize,
    _values: *const *const c_char,
) -> Status {
    // SAFETY: see the head of this file.
    unsafe { call(c, "fmi2SetString", |_| if count == 0 { Ok(()) } else { error("this model has no strings") }) }
}

/// `fmi2GetFMUstate`: copies the state into the given one, or into a new one if the handle is null.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetFMUstate(c: *mut Slave, state: *mut *mut Saved) -> Status {
    // SAFETY: null is handled; a handle that is not null comes from an earlier call.
    unsafe { call(c, "fmi2GetFMUstate", |component| pointers::hand_out(state, || component.save())) }
}

/// `fmi2SetFMUstate`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetFMUstate(c: *mut Slave, state: *const Saved) -> Status {
    // SAFETY: null is handled; otherwise the state comes from `fmi2GetFMUstate` and is not freed yet.
    unsafe { call(c, "fmi2SetFMUstate", |component| component.restore(pointers::state(state)?)) }
}

/// `fmi2FreeFMUstate`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2FreeFMUstate(c: *mut Slave, state: *mut *mut Saved) -> Status {
    // SAFETY: null is handled; otherwise the state was made by `Box::into_raw` and is not freed yet.
    unsafe {
        call(c, "fmi2FreeFMUstate", |component| {
            component.expect_state_functions()?;
            pointers::release(state);
            Ok(())
        })
    }
}

/// `fmi2SerializedFMUstateSize`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SerializedFMUstateSize(c: *mut Slave, state: *const Saved, size: *mut usize) -> Status {
    // SAFETY: null is handled; see the head of this file.
    unsafe {
        call(c, "fmi2SerializedFMUstateSize", |component| match (state.as_ref(), size.as_mut()) {
            (Some(saved), Some(size)) => {
                *size = component.serialize(saved)?.len();
                Ok(())
            }
            _ => error("a null pointer was given"),
        })
    }
}

/// `fmi2SerializeFMUstate`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SerializeFMUstate(
    c: *mut Slave,
    state: *const Saved,
    bytes: *mut u8,
    size: usize,
) -> Status {
    // SAFETY: null is handled; see the head of this file.
    unsafe {
        call(c, "fmi2SerializeFMUstate", |component| {
            pointers::copy_out(&component.serialize(pointers::state(state)?)?, bytes, size)
        })
    }
}

/// `fmi2DeSerializeFMUstate`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2DeSerializeFMUstate(
    c: *mut Slave,
    bytes: *const u8,
    size: usize,
    state: *mut *mut Saved,
) -> Status {
    // SAFETY: null is handled; a handle that is not null comes from an earlier call.
    unsafe {
        call(c, "fmi2DeSerializeFMUstate", |component| {
            pointers::hand_out(state, || component.deserialize(array(bytes, size)?))
        })
    }
}

/// `fmi2GetDirectionalDerivative`: not provided.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetDirectionalDerivative(
    c: *mut Slave,
    _unknown: *const c_uint,
    _unknown_count: usize,
    _known: *const c_uint,
    _known_count: usize,
    _known_change: *const f64,
    _unknown_change: *mut f64,
) -> Status {
    // SAFETY: see the head of this file.
    unsafe { call(c, "fmi2GetDirectionalDerivative", |_| error("this FMU does not provide derivatives")) }
}

/// `fmi2SetRealInputDerivatives`: not provided.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetRealInputDerivatives(
    c: *mut Slave,
    _vr: *const c_uint,
    _count: usize,
    _order: *const c_int,
    _values: *const f64,
) -> Status {
    // SAFETY: see the head of this file.
    unsafe { call(c, "fmi2SetRealInputDerivatives", |_| error("this FMU does not interpolate its inputs")) }
}

/// `fmi2GetRealOutputDerivatives`: not provided.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetRealOutputDerivatives(
    c: *mut Slave,
    _vr: *const c_uint,
    _count: usize,
    _order: *const c_int,
    _values: *mut f64,
) -> Status {
    // SAFETY: see the head of this file.
    unsafe { call(c, "fmi2GetRealOutputDerivatives", |_| error("this FMU does not provide derivatives")) }
}

/// `fmi2DoStep`: states to go back to are independent of the FMU, so nothing follows from `_no_set_state_before`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2DoStep(c: *mut Slave, time: f64, step: f64, _no_set_state_before: c_int) -> Status {
    // SAFETY: see the head of this file.
    unsafe {
        call(c, "fmi2DoStep", |component| {
            if component.step(time, step)?.terminate {
                let message = "the model ends the simulation (fmi2Terminated)".to_owned();
                return Err(Refusal { severity: Severity::Discard, message });
            }
            Ok(())
        })
    }
}

/// `fmi2CancelStep`: steps never run in the background.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2CancelStep(c: *mut Slave) -> Status {
    // SAFETY: see the head of this file.
    unsafe { call(c, "fmi2CancelStep", |_| error("there is no step to cancel")) }
}

/// `fmi2GetStatus`: steps never run in the background, so there is nothing to ask for.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetStatus(c: *mut Slave, _kind: c_int, _value: *mut Status) -> Status {
    // SAFETY: see the head of this file.
    unsafe { discard(c, "fmi2GetStatus") }
}

/// `fmi2GetRealStatus`: the last communication point that was reached.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetRealStatus(c: *mut Slave, kind: c_int, value: *mut f64) -> Status {
    // SAFETY: null is handled; see the head of this file.
    unsafe {
        match value.as_mut() {
            Some(value) if kind == LAST_SUCCESSFUL_TIME => call(c, "fmi2GetRealStatus", |component| {
                *value = component.time();
                Ok(())
            }),
            _ => discard(c, "fmi2GetRealStatus"),
        }
    }
}

/// `fmi2GetIntegerStatus`: the standard defines no such status.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetIntegerStatus(c: *mut Slave, _kind: c_int, _value: *mut c_int) -> Status {
    // SAFETY: see the head of this file.
    unsafe { discard(c, "fmi2GetIntegerStatus") }
}

/// `fmi2GetBooleanStatus`: whether the FMU has ended the simulation by itself.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetBooleanStatus(c: *mut Slave, kind: c_int, value: *mut c_int) -> Status {
    // SAFETY: null is handled; see the head of this file.
    unsafe {
        match value.as_mut() {
            Some(value) if kind == TERMINATED => call(c, "fmi2GetBooleanStatus", |component| {
                *value = c_int::from(component.mode() == Mode::Ended);
                Ok(())
            }),
            _ => discard(c, "fmi2GetBooleanStatus"),
        }
    }
}

/// `fmi2GetStringStatus`: steps never run in the background.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetStringStatus(c: *mut Slave, _kind: c_int, _value: *mut *const c_char) -> Status {
    // SAFETY: see the head of this file.
    unsafe { discard(c, "fmi2GetStringStatus") }
}

/// Answers a question about a status that this FMU does not have.
///
/// # Safety
/// See the head of this file.
unsafe fn discard(c: *mut Slave, function: &str) -> Status {
    let refusal = || Refusal { severity: Severity::Discard, message: "there is no such status".to_owned() };
    // SAFETY: see the head of this file.
    unsafe { call(c, function, |_| Err(refusal())) }
}
