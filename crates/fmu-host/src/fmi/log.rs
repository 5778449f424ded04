//! What FMUs say: the log callbacks of both versions, and the last lines kept for error messages.
#![expect(unsafe_code, reason = "callbacks that FMUs call with C pointers")]

use std::ffi::{CStr, c_char, c_int, c_void};
use std::sync::{Mutex, MutexGuard, OnceLock, PoisonError};

use super::abi::{self, StatusCode};
use super::text::escaped;

/// Log lines kept for error messages.
const LOG_LINES: usize = 10;

/// Characters of a line that are kept.
const LONGEST: usize = 2000;

/// What the log callbacks write to; lives as long as the instance.
#[derive(Default)]
pub(super) struct Environment {
    lines: Mutex<Vec<String>>,
}

impl Environment {
    /// As the FMU is given it.
    pub(super) fn address(&self) -> *mut c_void {
        (&raw const *self).cast_mut().cast()
    }

    /// The lines so far.
    pub(super) fn lines(&self) -> Vec<String> {
        lock(&self.lines).clone()
    }

    /// The lines since they were last taken.
    pub(super) fn take(&self) -> Vec<String> {
        std::mem::take(&mut *lock(&self.lines))
    }
}

/// Who is told every message, also those that are not kept.
static LISTENER: OnceLock<fn(&str)> = OnceLock::new();

/// From now on `listener` is told every message of every FMU in this process, in one line each; the first one stays. An FMU
/// that ends its process takes its last lines with it otherwise.
pub fn on_log(listener: fn(&str)) {
    let _ = LISTENER.set(listener);
}

/// A lock that a panic elsewhere does not close.
pub(super) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

unsafe extern "C" {
    /// The C shim that formats a log message of FMI 2.0; passed to FMUs, never called from Rust.
    pub(super) fn fmi_hazard_logger();
}

/// Called by the C shim with a formatted log message.
#[unsafe(no_mangle)]
extern "C" fn fmi_hazard_log(environment: *mut c_void, status: c_int, category: *const c_char, message: *const c_char) {
    // SAFETY: the shim passes on what an FMU was given at instantiation, and NUL-terminated texts.
    unsafe { record(environment, status, category, message) };
}

/// `fmi3LogMessageCallback`. Not variadic, so no C is needed.
///
/// # Safety
/// As [`record`]; the standard asks the same of FMUs.
pub(super) unsafe extern "C" fn log_message(
    environment: *mut c_void,
    status: StatusCode,
    category: *const c_char,
    message: *const c_char,
) {
    // SAFETY: as the caller promises.
    unsafe { record(environment, status, category, message) };
}

/// Keeps one line.
///
/// # Safety
/// `environment` must be NULL or from [`Environment::address`] of one that still lives; the texts must be NULL or
/// NUL-terminated and live during the call.
unsafe fn record(environment: *mut c_void, status: StatusCode, category: *const c_char, message: *const c_char) {
    if environment.is_null() || message.is_null() {
        return;
    }
    // SAFETY: not NULL, and an `Environment` as the caller promises; only shared references to it exist.
    let environment = unsafe { &*environment.cast::<Environment>() };
    // SAFETY: not NULL, and NUL-terminated as the caller promises.
    let message = unsafe { CStr::from_ptr(message) };
    let category = if category.is_null() {
        String::new()
    } else {
        // SAFETY: as for the message.
        unsafe { CStr::from_ptr(category) }.to_string_lossy().into_owned()
    };
    // Ordinary chatter is dropped; what comes with a status worse than OK, or an error category, is kept.
    let kept = status != abi::OK || category.to_lowercase().contains("err");
    let listener = LISTENER.get();
    if !kept && listener.is_none() {
        return;
    }
    let text = message.to_string_lossy();
    let text: String = escaped(text.trim_end()).chars().take(LONGEST).collect();
    let line = if category.is_empty() { text } else { format!("[{}] {text}", escaped(&category)) };
    if let Some(tell) = listener {
        tell(&line);
    }
    if !kept {
        return;
    }
    let mut lines = lock(&environment.lines);
    if lines.len() == LOG_LINES {
        lines.remove(0);
    }
    lines.push(line);
}

#[cfg(test)]
mod tests {
    use std::ffi::CString;

    use super::*;

    /// Of twelve lines the first two are dropped: what an FMU said last is nearest to why it failed.
    #[test]
    fn the_last_ten_lines_are_kept() {
        let environment = Environment::default();
        for number in 1..=12 {
            let message = CString::new(format!("line {number}")).unwrap();
            // SAFETY: the environment lives longer than the call, and so does the NUL-terminated text.
            unsafe { record(environment.address(), abi::ERROR, std::ptr::null(), message.as_ptr()) };
        }
        let last: Vec<String> = (3..=12).map(|number| format!("line {number}")).collect();
        assert_eq!(environment.lines(), last);
    }
}
