//! The FMI 2.0 C interface: types and the table of functions of a loaded binary, no behaviour.
//!
//! Written from the FMI 2.0.4 specification, sections 2.1 and 4.2. What FMI 3.0 has too is in `abi`.

#![expect(unsafe_code, reason = "looks up functions by name, whose types only the standard knows")]

use std::ffi::{c_char, c_int, c_void};

use super::abi::{Component, Names, StatusCode, ValueReference, table};

/// `fmi2Boolean`.
pub(super) type Boolean = c_int;

pub(super) const TRUE: Boolean = 1;
pub(super) const FALSE: Boolean = 0;
/// `fmi2CoSimulation`.
pub(super) const CO_SIMULATION: c_int = 1;
/// `fmi2Terminated`.
pub(super) const TERMINATED: c_int = 3;
/// `fmi2LastSuccessfulTime`.
pub(super) const LAST_SUCCESSFUL_TIME: c_int = 2;

/// `fmi2CallbackFunctions`. The logger is C-variadic, so it is only ever passed on as a pointer.
#[repr(C)]
pub(super) struct Callbacks {
    pub(super) logger: *const c_void,
    pub(super) allocate_memory: unsafe extern "C" fn(usize, usize) -> *mut c_void,
    pub(super) free_memory: unsafe extern "C" fn(*mut c_void),
    pub(super) step_finished: *const c_void,
    pub(super) environment: *mut c_void,
}

pub(super) static NAMES: Names = Names {
    get_version: "fmi2GetVersion",
    free_instance: "fmi2FreeInstance",
    exit_initialization_mode: "fmi2ExitInitializationMode",
    terminate: "fmi2Terminate",
    reset: "fmi2Reset",
    get_state: "fmi2GetFMUstate",
    set_state: "fmi2SetFMUstate",
    free_state: "fmi2FreeFMUstate",
    serialized_size: "fmi2SerializedFMUstateSize",
    serialize_state: "fmi2SerializeFMUstate",
    deserialize_state: "fmi2DeSerializeFMUstate",
};

table! {
    /// The functions of one loaded FMI 2.0 co-simulation binary.
    Functions {
        required {
            instantiate: "fmi2Instantiate" = fn(*const c_char, c_int, *const c_char, *const c_char, *const Callbacks, Boolean, Boolean) -> Component;
            setup_experiment: "fmi2SetupExperiment" = fn(Component, Boolean, f64, f64, Boolean, f64) -> StatusCode;
            enter_initialization_mode: "fmi2EnterInitializationMode" = fn(Component) -> StatusCode;
            do_step: "fmi2DoStep" = fn(Component, f64, f64, Boolean) -> StatusCode;
        }
        optional {
            get_types_platform: "fmi2GetTypesPlatform" = fn() -> *const c_char;
            get_real: "fmi2GetReal" = fn(Component, *const ValueReference, usize, *mut f64) -> StatusCode;
            get_integer: "fmi2GetInteger" = fn(Component, *const ValueReference, usize, *mut c_int) -> StatusCode;
            get_boolean: "fmi2GetBoolean" = fn(Component, *const ValueReference, usize, *mut Boolean) -> StatusCode;
            get_string: "fmi2GetString" = fn(Component, *const ValueReference, usize, *mut *const c_char) -> StatusCode;
            set_real: "fmi2SetReal" = fn(Component, *const ValueReference, usize, *const f64) -> StatusCode;
            set_integer: "fmi2SetInteger" = fn(Component, *const ValueReference, usize, *const c_int) -> StatusCode;
            set_boolean: "fmi2SetBoolean" = fn(Component, *const ValueReference, usize, *const Boolean) -> StatusCode;
            get_real_status: "fmi2GetRealStatus" = fn(Component, c_int, *mut f64) -> StatusCode;
            get_boolean_status: "fmi2GetBooleanStatus" = fn(Component, c_int, *mut Boolean) -> StatusCode;
        }
    }
}
