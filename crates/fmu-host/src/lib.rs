//! Opens an FMU, steps it in a sandboxed process, and brings its states back.
//!
//! Useful alone: it knows nothing of humans, robots or hazards.
//!
//! | floor | what it is |
//! |---|---|
//! | [`host`] | where FMUs run, one or several coupled ones, and how their states are brought back: by the FMU, by copies of its process, by replay of inputs |
//! | [`fmi`] | opening an FMU, its description, FMI 2.0 and 3.0; unsafe code is here and in the few system calls of `host` |
//!
//! A vendor's FMU is native code from outside. [`fmi`] reads it without loading it; [`host::isolation`] loads it in a process of its own, which
//! may read the FMU's own files and no others, and whose crash costs one step.

#[cfg(not(target_os = "linux"))]
compile_error!(
    "FMUs are hosted on Linux only: they are kept apart with means of its kernel (futex, memfd, Landlock, seccomp)"
);

pub mod fmi;
pub mod host;

use fmi_hazard_stop as stop;
