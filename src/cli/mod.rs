//! The command line: one file a subcommand, thin. Results go to stdout, everything else to stderr.

#![allow(rustdoc::invalid_html_tags, reason = "what is documented of arguments is their help, which is no HTML")]

mod bench;
mod bench_format;
mod campaign;
mod changes;
mod check;
mod compare;
mod distance;
mod earlier;
mod events;
mod examples;
pub(crate) mod exit;
mod explain;
mod from_start;
mod help;
mod hosting;
mod init;
mod initial_conditions;
mod inspect;
mod introduction;
mod manual;
mod merge_by;
mod output;
mod pack;
mod printed;
mod reachability;
mod recording;
mod reference;
mod replay;
mod report;
mod results;
mod resume;
mod run;
mod scan;
mod scan_arguments;
mod schema;
mod search_progress;
mod stopping;
mod subject;

use std::process::ExitCode;

use clap::{CommandFactory as _, FromArgMatches as _, Parser, Subcommand};

/// Puts an adversarial virtual human into a robot workcell that comes as an FMU, and reports every way found to be hit
/// harder than ISO/TS 15066 allows. Loading an FMU runs its code.
#[derive(Debug, Parser)]
#[command(name = "fmi-hazard", version, after_help = exit::HELP)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
    #[command(flatten)]
    verbosity: output::Verbosity,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Search a cell for hazards
    Scan(scan::Arguments),
    /// Simulate recorded hazards again and say whether they reproduce; with --changed, try them in a changed cell
    Replay(replay::Arguments),
    /// Write the report of an earlier scan again, with the replays that are asked for
    Report(report::Arguments),
    /// Explain a hazard in plain words, with its formula, the safe speed, and the smallest changes that remove it
    Explain(explain::Arguments),
    /// Compare two scans: what is fixed, the same, worse, new. Exit code 1 if something is new or worse, 4 if that is not shown
    Compare(compare::Arguments),
    /// Show what an FMU is, without loading it; with --run what it does and which inputs stop it, with --self-test what its state is worth
    Inspect(inspect::Arguments),
    /// Write a first cell file for an FMU, with what is guessed marked and what is missing to be filled in
    Init(init::Arguments),
    /// Find everything that is wrong with a cell, and draw it from above, without searching
    Check(check::Arguments),
    /// Put a cell file and its geometry into a copy of its FMU, which can then be scanned alone
    Pack(pack::Arguments),
    /// Compare how far safeguards stand from the robots with the safety distance of ISO 13855, for the measured stop time
    Distance(distance::Arguments),
    /// Scan many cells, starts, values and bodies, in parts on many machines, and put the results together
    Campaign(campaign::Arguments),
    /// Run many seeds of several strategies, each to its first hazard, and compare them
    Bench(bench::Arguments),
    /// List, export or scan the built-in example cells
    Examples(examples::Arguments),
    #[command(hide = true)]
    /// Print the JSON Schema of the cell file, of scan.json, or of what other commands print
    Schema(schema::Arguments),
    #[command(hide = true)]
    /// Print completions for a shell, or write the manual pages or the reference of the book
    Manual(manual::Arguments),
    /// Serve as a process in which FMUs run: started by this program
    #[command(hide = true)]
    Worker {
        /// File descriptor of the shared memory
        channel: i32,
    },
}

/// Parses the arguments, runs the command, reports an error once; never panics at the user.
#[must_use]
pub fn main() -> ExitCode {
    let parsed = help::grouped(Arguments::command()).try_get_matches();
    let arguments = match parsed.and_then(|matches| Arguments::from_arg_matches(&matches)) {
        Ok(arguments) => arguments,
        Err(error) => {
            // Printing help or version is no failure; a usage error is.
            let code = if error.use_stderr() { exit::UNUSABLE } else { exit::NO_HAZARD };
            let _ = error.print();
            return ExitCode::from(code);
        }
    };
    arguments.verbosity.apply();
    let outcome = match arguments.command {
        Command::Scan(a) => scan::command(&a),
        Command::Replay(a) => replay::run(&a),
        Command::Report(a) => report::run(&a),
        Command::Explain(a) => explain::run(&a),
        Command::Compare(a) => compare::run(&a),
        Command::Inspect(a) => inspect::run(&a),
        Command::Init(a) => init::run(&a),
        Command::Check(a) => check::run(&a),
        Command::Pack(a) => pack::run(&a),
        Command::Distance(a) => distance::run(&a),
        Command::Campaign(a) => campaign::run(&a),
        Command::Bench(a) => bench::run(&a),
        Command::Examples(a) => examples::run(&a),
        Command::Schema(a) => schema::run(&a),
        Command::Manual(a) => manual::run::<Arguments>(&a),
        Command::Worker { channel } => Ok(crate::host::isolation::serve(channel)),
    };
    match outcome {
        Ok(code) => ExitCode::from(code),
        Err(failure) => ExitCode::from(output::failed(&failure)),
    }
}
