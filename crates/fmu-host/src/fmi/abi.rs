//! What the C interfaces of FMI 2.0 and FMI 3.0 have in common: types, status numbers, the functions that differ in
//! name only, and the macro that makes a table of functions. No behaviour.

#![expect(unsafe_code, reason = "looks up functions by name, whose types only the standard knows")]

use std::ffi::{c_char, c_int, c_void};

use libloading::os::unix::Library;

/// `fmi2Component`, `fmi3Instance`.
pub(super) type Component = *mut c_void;
/// `fmi2FMUstate`, `fmi3FMUState`.
pub(super) type FmuState = *mut c_void;
/// `fmi2Status`, `fmi3Status`; equal numbers mean the same, only FMI 2.0 has [`PENDING`].
pub(super) type StatusCode = c_int;
/// `fmi2ValueReference`, `fmi3ValueReference`.
pub(super) type ValueReference = u32;

pub(super) const OK: StatusCode = 0;
pub(super) const WARNING: StatusCode = 1;
pub(super) const DISCARD: StatusCode = 2;
pub(super) const ERROR: StatusCode = 3;
pub(super) const FATAL: StatusCode = 4;
pub(super) const PENDING: StatusCode = 5;

/// A function that takes the instance only.
pub(super) type Plain = unsafe extern "C" fn(Component) -> StatusCode;

/// Makes a table of functions and its `load`. Functions that an exporter may leave out are `Option`s: they are missed
/// only when they are needed.
macro_rules! table {
    ($(#[$doc:meta])* $name:ident {
        required { $($r:ident : $rsym:literal = fn($($rarg:ty),* $(,)?) -> $rret:ty;)* }
        optional { $($o:ident : $osym:literal = fn($($oarg:ty),* $(,)?) -> $oret:ty;)* }
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
            /// Functions of these names in `library` must have the types of the standard.
            pub(super) unsafe fn load(library: &libloading::os::unix::Library) -> Result<Self, &'static str> {
                Ok(Self {
                    $($r: {
                        // SAFETY: the caller promises the types of the standard.
                        let symbol = unsafe { library.get($rsym) };
                        *symbol.map_err(|_| $rsym)?
                    },)*
                    $($o: {
                        // SAFETY: the caller promises the types of the standard.
                        let symbol = unsafe { library.get($osym) };
                        symbol.ok().map(|s| *s)
                    },)*
                })
            }
        }
    };
}
pub(super) use table;

/// Names of the functions of [`Common`] in one version.
pub(super) struct Names {
    pub(super) get_version: &'static str,
    pub(super) free_instance: &'static str,
    pub(super) exit_initialization_mode: &'static str,
    pub(super) terminate: &'static str,
    pub(super) reset: &'static str,
    pub(super) get_state: &'static str,
    pub(super) set_state: &'static str,
    pub(super) free_state: &'static str,
    pub(super) serialized_size: &'static str,
    pub(super) serialize_state: &'static str,
    pub(super) deserialize_state: &'static str,
}

/// The functions that both versions have with the same types.
pub(super) struct Common {
    pub(super) names: &'static Names,
    pub(super) get_version: Option<unsafe extern "C" fn() -> *const c_char>,
    pub(super) free_instance: unsafe extern "C" fn(Component),
    pub(super) exit_initialization_mode: Plain,
    pub(super) terminate: Option<Plain>,
    pub(super) reset: Option<Plain>,
    pub(super) get_state: Option<unsafe extern "C" fn(Component, *mut FmuState) -> StatusCode>,
    pub(super) set_state: Option<unsafe extern "C" fn(Component, FmuState) -> StatusCode>,
    pub(super) free_state: Option<unsafe extern "C" fn(Component, *mut FmuState) -> StatusCode>,
    pub(super) serialized_size: Option<unsafe extern "C" fn(Component, FmuState, *mut usize) -> StatusCode>,
    pub(super) serialize_state: Option<unsafe extern "C" fn(Component, FmuState, *mut u8, usize) -> StatusCode>,
    pub(super) deserialize_state:
        Option<unsafe extern "C" fn(Component, *const u8, usize, *mut FmuState) -> StatusCode>,
}

impl Common {
    /// Looks every function up.
    ///
    /// # Errors
    /// The name of the first required function that is missing.
    ///
    /// # Safety
    /// Functions of these names in `library` must have the types of the standard.
    pub(super) unsafe fn load(library: &Library, names: &'static Names) -> Result<Self, &'static str> {
        /// One function, if the library has it.
        ///
        /// # Safety
        /// It must be of type `T`.
        unsafe fn find<T: Copy>(library: &Library, name: &str) -> Option<T> {
            // SAFETY: the caller promises the type.
            unsafe { library.get::<T>(name) }.ok().map(|s| *s)
        }
        // SAFETY: the caller promises the types of the standard, which are those of the fields.
        unsafe {
            Ok(Self {
                names,
                get_version: find(library, names.get_version),
                free_instance: find(library, names.free_instance).ok_or(names.free_instance)?,
                exit_initialization_mode: find(library, names.exit_initialization_mode)
                    .ok_or(names.exit_initialization_mode)?,
                terminate: find(library, names.terminate),
                reset: find(library, names.reset),
                get_state: find(library, names.get_state),
                set_state: find(library, names.set_state),
                free_state: find(library, names.free_state),
                serialized_size: find(library, names.serialized_size),
                serialize_state: find(library, names.serialize_state),
                deserialize_state: find(library, names.deserialize_state),
            })
        }
    }
}
