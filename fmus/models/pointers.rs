//! What both C interfaces share: pointers become references, refusals and panics become a status.
//!
//! # Safety
//! For every function the caller keeps the rules of the FMI standard: an instance comes from the instantiation and is
//! not freed yet, is used by one thread at a time, arrays have the stated lengths, and handles of states come from the
//! same instance. Null pointers are refused, as far as they can be told.

#![expect(unsafe_code, reason = "raw pointers from the importer")]

use crate::component::{Answer, Mode, Refusal, Severity, error};
use std::ffi::{CStr, CString, c_char, c_int};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// `fmi2Status` and `fmi3Status`: the numbers are the same.
pub type Status = c_int;
/// The call was carried out.
pub const OK: Status = 0;
/// The call was not carried out, and nothing has changed.
pub const DISCARD: Status = 2;
/// The call was not carried out.
pub const ERROR: Status = 3;
/// The instance is lost.
pub const FATAL: Status = 4;

/// What an instance handle of either interface points to.
pub trait Instance {
    /// Where the instance is in its life.
    fn mode(&self) -> Mode;

    /// Writes one line to the importer's log.
    fn log(&self, status: Status, message: &str);
}

/// The log category of a status; those are listed in modelDescription.xml.
pub fn category(status: Status) -> &'static CStr {
    match status {
        FATAL => c"logStatusFatal",
        DISCARD => c"logStatusDiscard",
        _ => c"logStatusError",
    }
}

/// A message as C wants it.
pub fn line(message: &str) -> CString {
    CString::new(message.replace('\0', " ")).unwrap_or_default()
}

/// Runs one call on an instance: catches panics, logs refusals, returns the status.
///
/// # Safety
/// See the head of this file.
pub unsafe fn call<I: Instance>(instance: *mut I, function: &str, body: impl FnOnce(&mut I) -> Answer) -> Status {
    // SAFETY: null is handled; otherwise the pointer comes from the instantiation and no other thread uses it.
    let Some(instance) = (unsafe { instance.as_mut() }) else { return ERROR };
    if instance.mode() == Mode::Dead {
        return FATAL;
    }
    let answer = catch_unwind(AssertUnwindSafe(|| body(instance)));
    let Refusal { severity, message } = match answer {
        Ok(Ok(())) => return OK,
        Ok(Err(refusal)) => refusal,
        Err(_) => Refusal { severity: Severity::Fatal, message: "a defect of this FMU: it panicked".to_owned() },
    };
    let status = match severity {
        Severity::Discard => DISCARD,
        Severity::Error => ERROR,
        Severity::Fatal => FATAL,
    };
    instance.log(status, &format!("{function}: {message}"));
    status
}

/// The text behind a pointer; None for null.
///
/// # Safety
/// A pointer that is not null leads to a string that ends with zero.
pub unsafe fn text(pointer: *const c_char) -> Option<CString> {
    // SAFETY: null is handled; the caller vouches for the end.
    (!pointer.is_null()).then(|| unsafe { CStr::from_ptr(pointer) }.to_owned())
}

/// The array behind a pointer and a length.
///
/// # Safety
/// A pointer that is not null leads to `length` valid elements.
pub unsafe fn array<'a, T>(pointer: *const T, length: usize) -> Answer<&'a [T]> {
    if length == 0 {
        return Ok(&[]);
    }
    if pointer.is_null() {
        return error("a null pointer was given for an array");
    }
    // SAFETY: not null; the caller vouches for the elements.
    Ok(unsafe { std::slice::from_raw_parts(pointer, length) })
}

/// The array behind a pointer and a length, to be written.
///
/// # Safety
/// A pointer that is not null leads to `length` valid elements that nobody else uses.
pub unsafe fn array_mut<'a, T>(pointer: *mut T, length: usize) -> Answer<&'a mut [T]> {
    if length == 0 {
        return Ok(&mut []);
    }
    if pointer.is_null() {
        return error("a null pointer was given for an array");
    }
    // SAFETY: not null; the caller vouches for the elements.
    Ok(unsafe { std::slice::from_raw_parts_mut(pointer, length) })
}

/// The state behind a handle.
///
/// # Safety
/// See the head of this file.
pub unsafe fn state<'a, S>(handle: *const S) -> Answer<&'a S> {
    // SAFETY: null is handled; otherwise the handle comes from `hand_out` and is not freed yet.
    match unsafe { handle.as_ref() } {
        Some(state) => Ok(state),
        None => error("the state is a null pointer"),
    }
}

/// Makes a state and puts it into the given handle, or into a new one if the handle is null.
///
/// # Safety
/// See the head of this file.
pub unsafe fn hand_out<S>(place: *mut *mut S, make: impl FnOnce() -> Answer<S>) -> Answer {
    // SAFETY: null is handled.
    let Some(handle) = (unsafe { place.as_mut() }) else { return error("no place for the state was given") };
    let state = make()?;
    // SAFETY: null is handled; a handle that is not null comes from an earlier call.
    match unsafe { handle.as_mut() } {
        Some(old) => *old = state,
        None => *handle = Box::into_raw(Box::new(state)),
    }
    Ok(())
}

/// Frees a state and clears its handle; null is left alone.
///
/// # Safety
/// See the head of this file.
pub unsafe fn release<S>(place: *mut *mut S) {
    // SAFETY: null is handled.
    if let Some(handle) = unsafe { place.as_mut() }
        && !handle.is_null()
    {
        // SAFETY: made by `Box::into_raw` in `hand_out` and not freed yet.
        drop(unsafe { Box::from_raw(*handle) });
        *handle = std::ptr::null_mut();
    }
}

/// Copies a serialized state to where the importer wants it.
///
/// # Safety
/// See the head of this file.
pub unsafe fn copy_out(serialized: &[u8], bytes: *mut u8, size: usize) -> Answer {
    // SAFETY: passed on from the importer.
    match unsafe { array_mut(bytes, size) }?.get_mut(..serialized.len()) {
        Some(room) => room.copy_from_slice(serialized),
        None => return error(format!("{} bytes are needed, {size} were given", serialized.len())),
    }
    Ok(())
}
