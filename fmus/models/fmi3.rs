//! The C interface of FMI 3.0 for co-simulation: checks pointers, calls `component`, returns a status.
//!
//! All functions follow `fmi3Functions.h` of FMI 3.0.2. Those that belong to model exchange, scheduled execution or
//! abilities that modelDescription.xml denies exist, as the standard demands, but only return `fmi3Error`. A call that
//! is not carried out leaves one line in the importer's log. No panic crosses the interface: it becomes `fmi3Fatal`.
//!
//! # Safety
//! For every function the caller keeps the rules of the FMI standard: an instance comes from
//! `fmi3InstantiateCoSimulation` and is not freed yet, is used by one thread at a time, arrays have the stated
//! lengths, strings end with a zero byte, and FMU states come from the same instance. Null pointers are refused, as
//! far as they can be told.

#![expect(unsafe_code, reason = "a C interface: raw pointers from the importer, exported symbols")]
#![allow(clippy::missing_safety_doc, reason = "said once, above, for all functions")]

use crate::component::{Answer, Component, Importer, Mode, Saved, error};
use crate::interface::types3;
pub use crate::pointers::Status;
use crate::pointers::{self, ERROR, array, array_mut, call};
use crate::types3::{Datum, Number, Sink, Types3};
use std::ffi::{c_char, c_int, c_void};
use std::panic::catch_unwind;

/// `fmi3LogMessageCallback`: environment, status, category, message.
pub type LogMessage = unsafe extern "C" fn(*mut c_void, Status, *const c_char, *const c_char);
/// `fmi3IntermediateUpdateCallback`: environment, time, four facts about the point, two answers.
pub type IntermediateUpdate = unsafe extern "C" fn(*mut c_void, f64, bool, bool, bool, bool, *mut bool, *mut f64);

/// What an `fmi3Instance` points to.
#[derive(Debug)]
pub struct Instance {
    component: Component,
    /// Only of the model `types3`; the component is its joint then.
    types: Option<Types3>,
    log: Log,
}

/// What an `fmi3FMUState` points to.
#[derive(Debug)]
pub struct State {
    component: Saved,
    types: Option<Types3>,
}

#[derive(Debug)]
struct Log {
    message: Option<LogMessage>,
    environment: *mut c_void,
}

impl Log {
    fn write(&self, status: Status, message: &str) {
        let Some(function) = self.message else { return };
        let text = pointers::line(message);
        // SAFETY: the importer gave this function and its environment for this use and keeps both valid until the
        // instance is freed; both strings end with zero and outlive the call.
        unsafe { function(self.environment, status, pointers::category(status).as_ptr(), text.as_ptr()) }
    }
}

impl pointers::Instance for Instance {
    fn mode(&self) -> Mode {
        self.component.mode()
    }

    fn log(&self, status: Status, message: &str) {
        self.log.write(status, message);
    }
}

impl Instance {
    fn new(token: &str, importer: Importer, log: Log) -> Answer<Self> {
        let types = (token == types3::token()).then(Types3::new);
        let mut component = if types.is_some() { Types3::joint()? } else { Component::new(token)? };
        component.serve(importer)?;
        Ok(Self { component, types, log })
    }

    fn get(&mut self, reference: u32, sink: Sink) -> Answer {
        match &self.types {
            Some(types) => types.get(&mut self.component, place(reference), sink),
            None => sink(&self.component.get(reference)?.into()),
        }
    }

    fn set(&mut self, reference: u32, datum: Datum) -> Answer {
        match (&mut self.types, datum.value()) {
            (Some(types), _) => types.set(&mut self.component, place(reference), datum),
            (None, Some(value)) => self.component.set(reference, value),
            (None, None) => error(format!("value reference {reference} has another type")),
        }
    }

    fn save(&mut self) -> Answer<State> {
        Ok(State { component: self.component.save()?, types: self.types.clone() })
    }

    fn restore(&mut self, state: &State) -> Answer {
        if self.types.is_some() != state.types.is_some() {
            return error("the saved state belongs to another model");
        }
        self.component.restore(&state.component)?;
        self.types.clone_from(&state.types);
        Ok(())
    }

    fn serialize(&self, state: &State) -> Answer<Vec<u8>> {
        let component = self.component.serialize(&state.component)?;
        Ok(state.types.as_ref().map_or(component.clone(), |types| types.serialize(&component)))
    }

    fn deserialize(&self, bytes: &[u8]) -> Answer<State> {
        let (types, rest) = match &self.types {
            Some(_) => Types3::deserialize(bytes).map(|(types, rest)| (Some(types), rest))?,
            None => (None, bytes),
        };
        Ok(State { component: self.component.deserialize(rest)?, types })
    }

    fn reset(&mut self) -> Answer {
        self.component.reset()?;
        self.types = self.types.take().map(|_| Types3::new());
        Ok(())
    }

    fn configurable(&mut self) -> Answer<&mut Component> {
        match self.types {
            Some(_) => Ok(&mut self.component),
            None => error("this model has no structural parameters"),
        }
    }
}

fn place(reference: u32) -> usize {
    usize::try_from(reference).unwrap_or(usize::MAX)
}

/// `fmi3GetVersion`
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetVersion() -> *const c_char {
    c"3.0".as_ptr()
}

/// `fmi3SetDebugLogging`: there is no debug logging; errors are always logged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetDebugLogging(
    instance: *mut Instance,
    _logging_on: bool,
    _count: usize,
    _categories: *const *const c_char,
) -> Status {
    // SAFETY: see the head of this file.
    unsafe { call(instance, "fmi3SetDebugLogging", |_| Ok(())) }
}

/// `fmi3InstantiateModelExchange`: always null.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3InstantiateModelExchange(
    _instance_name: *const c_char,
    _token: *const c_char,
    _resource_path: *const c_char,
    _visible: bool,
    _logging_on: bool,
    environment: *mut c_void,
    message: Option<LogMessage>,
) -> *mut Instance {
    Log { message, environment }.write(ERROR, "fmi3InstantiateModelExchange: this FMU is for co-simulation only");
    std::ptr::null_mut()
}

/// `fmi3InstantiateScheduledExecution`: always null.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3InstantiateScheduledExecution(
    _instance_name: *const c_char,
    _token: *const c_char,
    _resource_path: *const c_char,
    _visible: bool,
    _logging_on: bool,
    environment: *mut c_void,
    message: Option<LogMessage>,
    _clock_update: *const c_void,
    _lock_preemption: *const c_void,
    _unlock_preemption: *const c_void,
) -> *mut Instance {
    Log { message, environment }.write(ERROR, "fmi3InstantiateScheduledExecution: this FMU is for co-simulation only");
    std::ptr::null_mut()
}

/// `fmi3InstantiateCoSimulation`: picks the model by its token; null on any error. There are no intermediate updates.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3InstantiateCoSimulation(
    instance_name: *const c_char,
    token: *const c_char,
    _resource_path: *const c_char,
    _visible: bool,
    _logging_on: bool,
    event_mode_used: bool,
    early_return_allowed: bool,
    _required_intermediate_variables: *const u32,
    _required_count: usize,
    environment: *mut c_void,
    message: Option<LogMessage>,
    _intermediate_update: Option<IntermediateUpdate>,
) -> *mut Instance {
    let made = catch_unwind(|| {
        // SAFETY: the importer gives strings that end with zero.
        let (name, token) = unsafe { (pointers::text(instance_name), pointers::text(token)) };
        let importer = Importer { uses_events: event_mode_used, allows_early_return: early_return_allowed };
        let made = match (name, token) {
            (Some(_), Some(token)) => Instance::new(&token.to_string_lossy(), importer, Log { message, environment }),
            _ => error("an instance name and an instantiation token are required"),
        };
        match made {
            Ok(instance) => Box::into_raw(Box::new(instance)),
            Err(refusal) => {
                let line = format!("fmi3InstantiateCoSimulation: {}", refusal.message);
                Log { message, environment }.write(ERROR, &line);
                std::ptr::null_mut()
            }
        }
    });
    made.unwrap_or(std::ptr::null_mut())
}

/// `fmi3FreeInstance`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3FreeInstance(instance: *mut Instance) {
    if !instance.is_null() {
        // SAFETY: made by `Box::into_raw` in `fmi3InstantiateCoSimulation` and not freed yet.
        drop(unsafe { Box::from_raw(instance) });
    }
}

/// `fmi3EnterInitializationMode`: tolerance and stop time play no part.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3EnterInitializationMode(
    instance: *mut Instance,
    _tolerance_defined: bool,
    _tolerance: f64,
    start_time: f64,
    _stop_time_defined: bool,
    _stop_time: f64,
) -> Status {
    // SAFETY: see the head of this file.
    unsafe {
        call(instance, "fmi3EnterInitializationMode", |instance| {
            instance.component.setup(start_time)?;
            instance.component.enter_initialization()
        })
    }
}

/// Exports functions that take nothing but the instance.
macro_rules! plain {
    ($($name:ident $body:expr;)*) => {$(
        #[doc = concat!("`", stringify!($name), "`")]
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name(instance: *mut Instance) -> Status {
            // SAFETY: see the head of this file.
            unsafe { call(instance, stringify!($name), $body) }
        }
    )*};
}
plain! {
    fmi3ExitInitializationMode |instance| instance.component.exit_initialization();
    fmi3EnterEventMode |instance| instance.component.enter_event();
    fmi3EnterStepMode |instance| instance.component.enter_step();
    fmi3EnterConfigurationMode |instance| instance.configurable()?.enter_configuration();
    fmi3ExitConfigurationMode |instance| instance.configurable()?.exit_configuration();
    fmi3Terminate |instance| instance.component.terminate();
    fmi3Reset |instance| instance.reset();
    fmi3EvaluateDiscreteStates |_| error("not provided (providesEvaluateDiscreteStates is false)");
    fmi3EnterContinuousTimeMode |_| error("this FMU is for co-simulation only");
}

/// Reads variables, arrays element after element; `put` takes a value with its place, or refuses its type.
fn read(
    instance: &mut Instance,
    references: &[u32],
    room: usize,
    put: &mut dyn FnMut(usize, &Datum) -> Option<()>,
) -> Answer {
    let mut filled = 0;
    for &reference in references {
        instance.get(reference, &mut |datum| {
            if filled == room {
                return error(format!("there is room for {room} values only"));
            }
            if put(filled, datum).is_none() {
                return error(format!("value reference {reference} has another type"));
            }
            filled += 1;
            Ok(())
        })?;
    }
    if filled == room { Ok(()) } else { error(format!("{filled} values for {room} places")) }
}

/// Reads values of one type.
///
/// # Safety
/// See the head of this file.
unsafe fn get<T>(
    instance: *mut Instance,
    function: &str,
    (references, count): (*const u32, usize),
    (values, room): (*mut T, usize),
    convert: impl Fn(&Datum) -> Option<T>,
) -> Status {
    // SAFETY: passed on from the importer, as the head of this file says.
    unsafe {
        call(instance, function, |instance| {
            let (references, values) = (array(references, count)?, array_mut(values, room)?);
            read(instance, references, room, &mut |place, datum| convert(datum).map(|value| values[place] = value))
        })
    }
}

/// Sets variables of one type. Arrays are outputs in all models, so each variable has one value.
///
/// # Safety
/// See the head of this file.
unsafe fn set<T: Copy>(
    instance: *mut Instance,
    function: &str,
    (references, count): (*const u32, usize),
    (values, given): (*const T, usize),
    convert: impl Fn(usize, T) -> Answer<Datum>,
) -> Status {
    // SAFETY: passed on from the importer, as the head of this file says.
    unsafe {
        call(instance, function, |instance| {
            let (references, values) = (array(references, count)?, array(values, given)?);
            if count != given {
                return error(format!("{given} values for {count} variables; no array can be set"));
            }
            for (place, (&reference, &value)) in references.iter().zip(values).enumerate() {
                instance.set(reference, convert(place, value)?)?;
            }
            Ok(())
        })
    }
}

/// Exports the functions of the number types.
macro_rules! numbers {
    ($($get:ident $set:ident $number:ty;)*) => {$(
        #[doc = concat!("`", stringify!($get), "`")]
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $get(
            instance: *mut Instance,
            vr: *const u32,
            count: usize,
            values: *mut $number,
            room: usize,
        ) -> Status {
            // SAFETY: see the head of this file.
            unsafe { get(instance, stringify!($get), (vr, count), (values, room), <$number>::unwrap) }
        }

        #[doc = concat!("`", stringify!($set), "`")]
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $set(
            instance: *mut Instance,
            vr: *const u32,
            count: usize,
            values: *const $number,
            given: usize,
        ) -> Status {
            // SAFETY: see the head of this file.
            unsafe { set(instance, stringify!($set), (vr, count), (values, given), |_, value| Ok(value.wrap())) }
        }
    )*};
}
numbers! {
    fmi3GetFloat32 fmi3SetFloat32 f32;
    fmi3GetFloat64 fmi3SetFloat64 f64;
    fmi3GetInt8 fmi3SetInt8 i8;
    fmi3GetUInt8 fmi3SetUInt8 u8;
    fmi3GetInt16 fmi3SetInt16 i16;
    fmi3GetUInt16 fmi3SetUInt16 u16;
    fmi3GetInt32 fmi3SetInt32 i32;
    fmi3GetUInt32 fmi3SetUInt32 u32;
    fmi3GetInt64 fmi3SetInt64 i64;
    fmi3GetUInt64 fmi3SetUInt64 u64;
}

/// `fmi3GetBoolean`. The importer's memory is treated as bytes: it need not hold a `bool` yet.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetBoolean(
    instance: *mut Instance,
    vr: *const u32,
    count: usize,
    values: *mut bool,
    room: usize,
) -> Status {
    let convert = |datum: &Datum| if let Datum::Boolean(x) = datum { Some(u8::from(*x)) } else { None };
    // SAFETY: see the head of this file; a C `bool` is one byte.
    unsafe { get(instance, "fmi3GetBoolean", (vr, count), (values.cast(), room), convert) }
}

/// `fmi3SetBoolean`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetBoolean(
    instance: *mut Instance,
    vr: *const u32,
    count: usize,
    values: *const bool,
    given: usize,
) -> Status {
    let convert = |_, byte: u8| Ok(Datum::Boolean(byte != 0));
    // SAFETY: see the head of this file; a C `bool` is one byte.
    unsafe { set(instance, "fmi3SetBoolean", (vr, count), (values.cast(), given), convert) }
}

/// `fmi3GetClock`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetClock(
    instance: *mut Instance,
    vr: *const u32,
    count: usize,
    values: *mut bool,
) -> Status {
    let convert = |datum: &Datum| if let Datum::Clock(x) = datum { Some(u8::from(*x)) } else { None };
    // SAFETY: see the head of this file; a C `bool` is one byte.
    unsafe { get(instance, "fmi3GetClock", (vr, count), (values.cast(), count), convert) }
}

/// `fmi3SetClock`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetClock(
    instance: *mut Instance,
    vr: *const u32,
    count: usize,
    values: *const bool,
) -> Status {
    let convert = |_, byte: u8| Ok(Datum::Clock(byte != 0));
    // SAFETY: see the head of this file; a C `bool` is one byte.
    unsafe { set(instance, "fmi3SetClock", (vr, count), (values.cast(), count), convert) }
}

/// `fmi3GetString`: the texts are valid until the next call of a function of this instance.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetString(
    instance: *mut Instance,
    vr: *const u32,
    count: usize,
    values: *mut *const c_char,
    room: usize,
) -> Status {
    let convert = |datum: &Datum| if let Datum::String(text) = datum { Some(text.as_ptr()) } else { None };
    // SAFETY: see the head of this file.
    unsafe { get(instance, "fmi3GetString", (vr, count), (values, room), convert) }
}

/// `fmi3SetString`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetString(
    instance: *mut Instance,
    vr: *const u32,
    count: usize,
    values: *const *const c_char,
    given: usize,
) -> Status {
    // SAFETY: null is handled; otherwise the importer gives a string that ends with zero.
    let convert = |_, pointer| match unsafe { pointers::text(pointer) } {
        Some(text) => Ok(Datum::String(text)),
        None => error("a null pointer was given for a string"),
    };
    // SAFETY: see the head of this file.
    unsafe { set(instance, "fmi3SetString", (vr, count), (values, given), convert) }
}

/// `fmi3GetBinary`: the bytes are valid until the next call of a function of this instance.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetBinary(
    instance: *mut Instance,
    vr: *const u32,
    count: usize,
    sizes: *mut usize,
    values: *mut *const u8,
    room: usize,
) -> Status {
    // SAFETY: passed on from the importer, as the head of this file says.
    unsafe {
        call(instance, "fmi3GetBinary", |instance| {
            let references = array(vr, count)?;
            let (sizes, values) = (array_mut(sizes, room)?, array_mut(values, room)?);
            read(instance, references, room, &mut |place, datum| {
                let Datum::Binary(bytes) = datum else { return None };
                (sizes[place], values[place]) = (bytes.len(), bytes.as_ptr());
                Some(())
            })
        })
    }
}

/// `fmi3SetBinary`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetBinary(
    instance: *mut Instance,
    vr: *const u32,
    count: usize,
    sizes: *const usize,
    values: *const *const u8,
    given: usize,
) -> Status {
    // SAFETY: the importer gives as many sizes as values, and as many bytes as each size says.
    let convert = |place: usize, pointer| unsafe {
        let size = array(sizes, given)?[place];
        Ok(Datum::Binary(array(pointer, size)?.to_vec()))
    };
    // SAFETY: see the head of this file.
    unsafe { set(instance, "fmi3SetBinary", (vr, count), (values, given), convert) }
}

/// `fmi3GetFMUState`: copies the state into the given one, or into a new one if the handle is null.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetFMUState(instance: *mut Instance, state: *mut *mut State) -> Status {
    // SAFETY: see the head of this file.
    unsafe { call(instance, "fmi3GetFMUState", |instance| pointers::hand_out(state, || instance.save())) }
}

/// `fmi3SetFMUState`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetFMUState(instance: *mut Instance, state: *const State) -> Status {
    // SAFETY: see the head of this file.
    unsafe { call(instance, "fmi3SetFMUState", |instance| instance.restore(pointers::state(state)?)) }
}

/// `fmi3FreeFMUState`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3FreeFMUState(instance: *mut Instance, state: *mut *mut State) -> Status {
    // SAFETY: see the head of this file.
    unsafe {
        call(instance, "fmi3FreeFMUState", |instance| {
            instance.component.expect_state_functions()?;
            pointers::release(state);
            Ok(())
        })
    }
}

/// `fmi3SerializedFMUStateSize`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SerializedFMUStateSize(
    instance: *mut Instance,
    state: *const State,
    size: *mut usize,
) -> Status {
    // SAFETY: see the head of this file.
    unsafe {
        call(instance, "fmi3SerializedFMUStateSize", |instance| {
            array_mut(size, 1)?[0] = instance.serialize(pointers::state(state)?)?.len();
            Ok(())
        })
    }
}

/// `fmi3SerializeFMUState`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SerializeFMUState(
    instance: *mut Instance,
    state: *const State,
    bytes: *mut u8,
    size: usize,
) -> Status {
    // SAFETY: see the head of this file.
    unsafe {
        call(instance, "fmi3SerializeFMUState", |instance| {
            pointers::copy_out(&instance.serialize(pointers::state(state)?)?, bytes, size)
        })
    }
}

/// `fmi3DeserializeFMUState`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3DeserializeFMUState(
    instance: *mut Instance,
    bytes: *const u8,
    size: usize,
    state: *mut *mut State,
) -> Status {
    // SAFETY: see the head of this file.
    unsafe {
        call(instance, "fmi3DeserializeFMUState", |instance| {
            pointers::hand_out(state, || instance.deserialize(array(bytes, size)?))
        })
    }
}

/// `fmi3UpdateDiscreteStates`: one call handles everything.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3UpdateDiscreteStates(
    instance: *mut Instance,
    need_update: *mut bool,
    terminate: *mut bool,
    nominals_changed: *mut bool,
    values_changed: *mut bool,
    next_event_defined: *mut bool,
    next_event_time: *mut f64,
) -> Status {
    // SAFETY: see the head of this file; a C `bool` is one byte.
    unsafe {
        call(instance, "fmi3UpdateDiscreteStates", |instance| {
            for answer in [need_update, terminate, nominals_changed, values_changed, next_event_defined] {
                array_mut(answer.cast::<u8>(), 1)?[0] = 0;
            }
            array_mut(next_event_time, 1)?[0] = 0.0;
            if let Some(next) = instance.component.update_discrete()? {
                array_mut(next_event_defined.cast::<u8>(), 1)?[0] = 1;
                array_mut(next_event_time, 1)?[0] = next;
            }
            if let Some(types) = &mut instance.types {
                types.stop_clocks();
            }
            Ok(())
        })
    }
}

/// `fmi3DoStep`: states to go back to are independent of the FMU, so nothing follows from `_no_set_state_before`. A
/// step that is discarded leaves the instance as it was.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3DoStep(
    instance: *mut Instance,
    time: f64,
    step: f64,
    _no_set_state_before: bool,
    event_needed: *mut bool,
    terminate: *mut bool,
    early_return: *mut bool,
    last_successful_time: *mut f64,
) -> Status {
    // SAFETY: see the head of this file; a C `bool` is one byte.
    unsafe {
        call(instance, "fmi3DoStep", |instance| {
            let event_needed = &mut array_mut(event_needed.cast::<u8>(), 1)?[0];
            let terminate = &mut array_mut(terminate.cast::<u8>(), 1)?[0];
            let early_return = &mut array_mut(early_return.cast::<u8>(), 1)?[0];
            let last_successful_time = &mut array_mut(last_successful_time, 1)?[0];
            // What holds if the step is not made.
            (*event_needed, *terminate, *early_return) = (0, 0, 0);
            *last_successful_time = instance.component.time();
            let end = instance.component.step(time, step)?;
            (*event_needed, *terminate) = (u8::from(end.event), u8::from(end.terminate));
            (*early_return, *last_successful_time) = (u8::from(end.early), end.time);
            Ok(())
        })
    }
}

/// Exports functions that no model provides.
macro_rules! denied {
    ($why:literal: $($name:ident($($argument:ty),*);)*) => {$(
        #[doc = concat!("`", stringify!($name), "`: ", $why, ".")]
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name(instance: *mut Instance $(, _: $argument)*) -> Status {
            // SAFETY: see the head of this file.
            unsafe { call(instance, stringify!($name), |_| error($why)) }
        }
    )*};
}
denied! { "this FMU does not provide derivatives":
    fmi3GetDirectionalDerivative(
        *const u32, usize, *const u32, usize, *const f64, usize, *mut f64, usize
    );
    fmi3GetAdjointDerivative(
        *const u32, usize, *const u32, usize, *const f64, usize, *mut f64, usize
    );
    fmi3GetOutputDerivatives(*const u32, usize, *const i32, *mut f64, usize);
}
denied! { "this FMU does not tell dependencies per element":
    fmi3GetNumberOfVariableDependencies(u32, *mut usize);
    fmi3GetVariableDependencies(
        u32, *mut usize, *mut u32, *mut usize, *mut c_int, usize
    );
}
denied! { "this FMU has no clock with an interval":
    fmi3GetIntervalDecimal(*const u32, usize, *mut f64, *mut c_int);
    fmi3GetIntervalFraction(*const u32, usize, *mut u64, *mut u64, *mut c_int);
    fmi3GetShiftDecimal(*const u32, usize, *mut f64);
    fmi3GetShiftFraction(*const u32, usize, *mut u64, *mut u64);
    fmi3SetIntervalDecimal(*const u32, usize, *const f64);
    fmi3SetIntervalFraction(*const u32, usize, *const u64, *const u64);
    fmi3SetShiftDecimal(*const u32, usize, *const f64);
    fmi3SetShiftFraction(*const u32, usize, *const u64, *const u64);
}
denied! { "this FMU is for co-simulation only":
    fmi3CompletedIntegratorStep(bool, *mut bool, *mut bool);
    fmi3SetTime(f64);
    fmi3SetContinuousStates(*const f64, usize);
    fmi3GetContinuousStateDerivatives(*mut f64, usize);
    fmi3GetEventIndicators(*mut f64, usize);
    fmi3GetContinuousStates(*mut f64, usize);
    fmi3GetNominalsOfContinuousStates(*mut f64, usize);
    fmi3GetNumberOfEventIndicators(*mut usize);
    fmi3GetNumberOfContinuousStates(*mut usize);
    fmi3ActivateModelPartition(u32, f64);
}
