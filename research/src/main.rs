//! What the makers of fmi-hazard measure it with, and no user installs: `fmi-hazard-research strategies` compares the strategies of its
//! search, and `fmi-hazard-research step` lets other programs search (`research/peers`).
//!
//! It uses the program as a library, by what that offers everybody; the figures of the book come from it.

mod comparison;
mod growth;
mod runs;
mod step;
mod stepping;
mod strategies;

use std::process::ExitCode;

use clap::Parser as _;

/// Measures fmi-hazard
#[derive(Debug, clap::Parser)]
#[command(version)]
enum Command {
    /// Compare all strategies on the built-in cells: cost of the first hazard, number of hazards found
    Strategies(strategies::Arguments),
    /// Step a cell as another program asks, in lines of JSON: for searches of others, and for learning agents
    Step(step::Arguments),
}

fn main() -> ExitCode {
    let done = match Command::parse() {
        Command::Strategies(arguments) => strategies::run(&arguments).map(|text| tell(&text)),
        Command::Step(arguments) => step::run(&arguments),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            note(&format!("Error: {error}"));
            ExitCode::from(2)
        }
    }
}

/// To standard output.
#[expect(clippy::print_stdout, reason = "the one place where results are printed")]
fn tell(text: &str) {
    print!("{text}");
}

/// To standard error.
#[expect(clippy::print_stderr, reason = "the one place where notes are printed")]
fn note(text: &str) {
    eprintln!("{text}");
}
