//! Builds the C shim and the example FMUs.
fn main() {}
