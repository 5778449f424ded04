//! The `fmi-hazard` command: parse arguments, call [`fmi_hazard::cli`], set the exit code. Nothing else.

fn main() -> std::process::ExitCode {
    fmi_hazard::cli::main()
}
