//! Builds the C part of the FMI floor, and says where work is counted.
#![allow(clippy::print_stdout, reason = "this is how a build script talks to cargo")]

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // Builds for tests count work between looks at the clock: see src/stop/meter.rs.
    println!("cargo::rustc-check-cfg=cfg(metered)");
    if std::env::var("PROFILE")? == "debug" {
        println!("cargo::rustc-cfg=metered");
    }
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-changed=src/fmi/logger.c");
    cc::Build::new().file("src/fmi/logger.c").warnings(true).compile("fmi_hazard_logger");
    Ok(())
}
