//! Builds for tests count work between looks at the clock: see `src/meter.rs`.
#![allow(clippy::print_stdout, reason = "this is how a build script talks to cargo")]

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("cargo::rustc-check-cfg=cfg(metered)");
    if std::env::var("PROFILE")? == "debug" {
        println!("cargo::rustc-cfg=metered");
    }
    println!("cargo:rerun-if-changed=build.rs");
    Ok(())
}
