//! Opens bytes as an FMU: checking and unpacking the archive, reading what is in it. How to run it: ../README.md.
#![no_main]

#[path = "../checks.rs"]
mod checks;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    checks::archive(bytes);
});
