//! Reads bytes as a modelDescription.xml. How to run it: ../README.md.
#![no_main]

#[path = "../checks.rs"]
mod checks;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    checks::description(bytes);
});
