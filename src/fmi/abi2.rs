//! The FMI 2.0 C interface: types and the table of functions of a loaded binary, no behaviour.
//!
//! Written from the FMI 2.0.4 specification, sections 2.1 and 4.2. Functions that an exporter may leave out are
//! `Option`s: they are missed only when they are needed.

#![expect(unsafe_code, reason = "looks up functions by name, whose types only the standard knows")]

use std::ffi::{c_char, c_int, c_void};

/// `fmi2Component`.
pub(super) type Component = *mut c_void;
/// `fmi2FMUstate`.
pub(super) type FmuState = *mut c_void;
/// `fmi2Boolean`.
pub(super) type Boolean = c_int;
/// `fmi2Status`.
pub(super) type StatusCode = c_int;
/// `fmi2ValueReference`.
pub(super) type ValueReference = u32;

pub(super) const TRUE: Boolean = 1;
pub(super) const FALSE: Boolean = 0;
/// `fmi2CoSimulation`.
pub(super) const CO_SIMULATION: c_int = 1;
/// `fmi2LastSuccessfulTime`.
pub(super) const LAST_SUCCESSFUL_TIME: c_int = 2;

pub(super) const OK: StatusCode = 0;
pub(super) const WARNING: StatusCode = 1;
pub(super) const DISCARD: StatusCode = 2;
pub(super) const ERROR: StatusCode = 3;
pub(super) const FATAL: StatusCode = 4;
pub(super) const PENDING: StatusCode = 5;

/// `fmi2CallbackFunctions`. The logger is C-variadic, so it is only ever passed on as a pointer.
#[repr(C)]
pub(super) struct Callbacks {
    pub(super) logger: *const c_void,
    pub(super) allocate_memory: unsafe extern "C" fn(usize, usize) -> *mut c_void,
    pub(super) free_memory: unsafe extern "C" fn(*mut c_void),
    pub(super) step_finished: *const c_void,
    pub(super) environment: *mut c_void,
}

macro_rules! table {
    ($(#[$doc:meta])* $name:ident {
        required { $($r:ident : $rsym:literal = fn($($rarg:ty),*) -> $rret:ty;)* }
        optional { $($o:ident : $osym:literal = fn($($oarg:ty),*) -> $oret:ty;)* }
    }) => {
        $(#[$doc])*
        pub(super) struct $name {
            $(pub(super) $r: unsafe extern "C" fn($($rarg),*) -> $rret,)*
            $(pub(super) $o: Option<unsafe extern "C" fn($($oarg),*) -> $oret>,)*
        }

        impl $name {
            /// Looks every function up.
            ///
            /// # Errors
            /// The name of the first required function that is missing.
            ///
            /// # Safety
            /// Functions of these names in `library` must have the types of FMI 2.0.
            pub(super) unsafe fn load(library: &libloading::os::unix::Library) -> Result<Self, &'static str> {
                Ok(Self {
                    $($r: {
                        // SAFETY: the caller promises the types of FMI 2.0.
                        let symbol = unsafe { library.get($rsym) };
                        *symbol.map_err(|_| $rsym.to_str().unwrap_or("a function"))?
                    },)*
                    $($o: {
                        // SAFETY: the caller promises the types of FMI 2.0.
                        let symbol = unsafe { library.get($osym) };
                        symbol.ok().map(|s| *s)
                    },)*
                })
            }
        }
    };
}

table! {
    /// The functions of one loaded FMI 2.0 co-simulation binary.
    Functions {
        required {
            instantiate: c"fmi2Instantiate" = fn(*const c_char, c_int, *const c_char, *const c_char, *const Callbacks, Boolean, Boolean) -> Component;
            free_instance: c"fmi2FreeInstance" = fn(Component) -> ();
            setup_experiment: c"fmi2SetupExperiment" = fn(Component, Boolean, f64, f64, Boolean, f64) -> StatusCode;
            enter_initialization_mode: c"fmi2EnterInitializationMode" = fn(Component) -> StatusCode;
            exit_initialization_mode: c"fmi2ExitInitializationMode" = fn(Component) -> StatusCode;
            do_step: c"fmi2DoStep" = fn(Component, f64, f64, Boolean) -> StatusCode;
        }
        optional {
            get_version: c"fmi2GetVersion" = fn() -> *const c_char;
            get_types_platform: c"fmi2GetTypesPlatform" = fn() -> *const c_char;
            terminate: c"fmi2Terminate" = fn(Component) -> StatusCode;
            reset: c"fmi2Reset" = fn(Component) -> StatusCode;
            get_real: c"fmi2GetReal" = fn(Component, *const ValueReference, usize, *mut f64) -> StatusCode;
            get_integer: c"fmi2GetInteger" = fn(Component, *const ValueReference, usize, *mut c_int) -> StatusCode;
            get_boolean: c"fmi2GetBoolean" = fn(Component, *const ValueReference, usize, *mut Boolean) -> StatusCode;
            set_real: c"fmi2SetReal" = fn(Component, *const ValueReference, usize, *const f64) -> StatusCode;
            set_integer: c"fmi2SetInteger" = fn(Component, *const ValueReference, usize, *const c_int) -> StatusCode;
            set_boolean: c"fmi2SetBoolean" = fn(Component, *const ValueReference, usize, *const Boolean) -> StatusCode;
            get_state: c"fmi2GetFMUstate" = fn(Component, *mut FmuState) -> StatusCode;
            set_state: c"fmi2SetFMUstate" = fn(Component, FmuState) -> StatusCode;
            free_state: c"fmi2FreeFMUstate" = fn(Component, *mut FmuState) -> StatusCode;
            serialized_size: c"fmi2SerializedFMUstateSize" = fn(Component, FmuState, *mut usize) -> StatusCode;
            serialize_state: c"fmi2SerializeFMUstate" = fn(Component, FmuState, *mut c_char, usize) -> StatusCode;
            deserialize_state: c"fmi2DeSerializeFMUstate" = fn(Component, *const c_char, usize, *mut FmuState) -> StatusCode;
            get_real_status: c"fmi2GetRealStatus" = fn(Component, c_int, *mut f64) -> StatusCode;
        }
    }
}
