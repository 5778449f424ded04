//! The FMI 3.0 C interface: types and the table of functions of a loaded binary, no behaviour.
//!
//! Written from the FMI 3.0 specification, sections 2.2, 2.3 and 4.2. What FMI 2.0 has too is in `abi`. Booleans and
//! clocks are C's `bool`: values that arrive in memory of ours are read as bytes, because a byte other than 0 or 1 in
//! a Rust `bool` would be undefined behaviour, whoever wrote it.

#![expect(unsafe_code, reason = "looks up functions by name, whose types only the standard knows")]

use std::ffi::{c_char, c_void};

use super::abi::{Component, Names, StatusCode, ValueReference, table};

/// `fmi3Boolean` and `fmi3Clock` in memory that the FMU writes: one byte, false if 0.
pub(super) type Byte = u8;

/// `fmi3LogMessageCallback`.
pub(super) type LogMessage = unsafe extern "C" fn(*mut c_void, StatusCode, *const c_char, *const c_char);

pub(super) static NAMES: Names = Names {
    get_version: "fmi3GetVersion",
    free_instance: "fmi3FreeInstance",
    exit_initialization_mode: "fmi3ExitInitializationMode",
    terminate: "fmi3Terminate",
    reset: "fmi3Reset",
    get_state: "fmi3GetFMUState",
    set_state: "fmi3SetFMUState",
    free_state: "fmi3FreeFMUState",
    serialized_size: "fmi3SerializedFMUStateSize",
    serialize_state: "fmi3SerializeFMUState",
    deserialize_state: "fmi3DeserializeFMUState",
};

table! {
    /// The functions of one loaded FMI 3.0 co-simulation binary.
    Functions {
        required {
            // Name, token, resource path, visible, logging on, event mode used, early return allowed, required
            // intermediate variables and their number, environment, log callback, intermediate update callback.
            instantiate: "fmi3InstantiateCoSimulation" = fn(
                *const c_char, *const c_char, *const c_char, bool, bool, bool, bool, *const ValueReference, usize,
                *mut c_void, LogMessage, *const c_void,
            ) -> Component;
            // Tolerance defined, tolerance, start, stop defined, stop.
            enter_initialization_mode: "fmi3EnterInitializationMode" = fn(Component, bool, f64, f64, bool, f64) -> StatusCode;
            // Time, step, no state before this point, event handling needed, terminate, early return, last time.
            do_step: "fmi3DoStep" = fn(
                Component, f64, f64, bool, *mut Byte, *mut Byte, *mut Byte, *mut f64,
            ) -> StatusCode;
        }
        optional {
            get_float64: "fmi3GetFloat64" = fn(Component, *const ValueReference, usize, *mut f64, usize) -> StatusCode;
            get_float32: "fmi3GetFloat32" = fn(Component, *const ValueReference, usize, *mut f32, usize) -> StatusCode;
            get_int8: "fmi3GetInt8" = fn(Component, *const ValueReference, usize, *mut i8, usize) -> StatusCode;
            get_uint8: "fmi3GetUInt8" = fn(Component, *const ValueReference, usize, *mut u8, usize) -> StatusCode;
            get_int16: "fmi3GetInt16" = fn(Component, *const ValueReference, usize, *mut i16, usize) -> StatusCode;
            get_uint16: "fmi3GetUInt16" = fn(Component, *const ValueReference, usize, *mut u16, usize) -> StatusCode;
            get_int32: "fmi3GetInt32" = fn(Component, *const ValueReference, usize, *mut i32, usize) -> StatusCode;
            get_uint32: "fmi3GetUInt32" = fn(Component, *const ValueReference, usize, *mut u32, usize) -> StatusCode;
            get_int64: "fmi3GetInt64" = fn(Component, *const ValueReference, usize, *mut i64, usize) -> StatusCode;
            get_uint64: "fmi3GetUInt64" = fn(Component, *const ValueReference, usize, *mut u64, usize) -> StatusCode;
            get_boolean: "fmi3GetBoolean" = fn(Component, *const ValueReference, usize, *mut Byte, usize) -> StatusCode;
            get_string: "fmi3GetString" = fn(Component, *const ValueReference, usize, *mut *const c_char, usize) -> StatusCode;
            // References, their number, sizes, values, their number.
            get_binary: "fmi3GetBinary" = fn(
                Component, *const ValueReference, usize, *mut usize, *mut *const u8, usize,
            ) -> StatusCode;
            // Clocks are scalars: no number of values.
            get_clock: "fmi3GetClock" = fn(Component, *const ValueReference, usize, *mut Byte) -> StatusCode;
            set_float64: "fmi3SetFloat64" = fn(Component, *const ValueReference, usize, *const f64, usize) -> StatusCode;
            set_float32: "fmi3SetFloat32" = fn(Component, *const ValueReference, usize, *const f32, usize) -> StatusCode;
            set_int8: "fmi3SetInt8" = fn(Component, *const ValueReference, usize, *const i8, usize) -> StatusCode;
            set_uint8: "fmi3SetUInt8" = fn(Component, *const ValueReference, usize, *const u8, usize) -> StatusCode;
            set_int16: "fmi3SetInt16" = fn(Component, *const ValueReference, usize, *const i16, usize) -> StatusCode;
            set_uint16: "fmi3SetUInt16" = fn(Component, *const ValueReference, usize, *const u16, usize) -> StatusCode;
            set_int32: "fmi3SetInt32" = fn(Component, *const ValueReference, usize, *const i32, usize) -> StatusCode;
            set_uint32: "fmi3SetUInt32" = fn(Component, *const ValueReference, usize, *const u32, usize) -> StatusCode;
            set_int64: "fmi3SetInt64" = fn(Component, *const ValueReference, usize, *const i64, usize) -> StatusCode;
            set_uint64: "fmi3SetUInt64" = fn(Component, *const ValueReference, usize, *const u64, usize) -> StatusCode;
            set_boolean: "fmi3SetBoolean" = fn(Component, *const ValueReference, usize, *const Byte, usize) -> StatusCode;
            enter_event_mode: "fmi3EnterEventMode" = fn(Component) -> StatusCode;
            enter_step_mode: "fmi3EnterStepMode" = fn(Component) -> StatusCode;
            // Needs update, terminate, nominals changed, values changed, next event time defined, next event time.
            update_discrete_states: "fmi3UpdateDiscreteStates" = fn(
                Component, *mut Byte, *mut Byte, *mut Byte, *mut Byte, *mut Byte, *mut f64,
            ) -> StatusCode;
        }
    }
}
