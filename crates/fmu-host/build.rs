//! Builds the one part in C: the logger that FMUs call with a variable number of arguments.
#![allow(clippy::print_stdout, reason = "this is how a build script talks to cargo")]

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-changed=src/fmi/logger.c");
    cc::Build::new().file("src/fmi/logger.c").warnings(true).compile("fmi_hazard_logger");
}
