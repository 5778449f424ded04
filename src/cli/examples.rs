//! `fmi-hazard examples`: the built-in example cells: list them, write them, scan one. The last is the first minute with the program.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use clap::Subcommand;

use super::exit::{Failure, NO_HAZARD};
use super::{output, scan};
use crate::examples;

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    #[command(subcommand)]
    command: Option<What>,
}

#[derive(Debug, Subcommand)]
enum What {
    /// Write every example (FMU, cell files, description) into a folder
    Export {
        /// The folder; made if it does not exist
        dir: PathBuf,
    },
    /// Export the examples and scan one: what a scan finds within seconds, and changes that help
    Run(ScanExampleArguments),
}

/// Enough for several hazards within seconds; looking at every sequence, as a scan does by default, takes minutes.
const ITERATIONS: u32 = 20;

#[derive(Debug, clap::Args)]
struct ScanExampleArguments {
    /// Name of the example
    #[arg(default_value = "safety-fence")]
    name: String,
    /// Where the examples and the results go
    #[arg(long, default_value = "out/examples")]
    out: PathBuf,
    /// Show the report in the browser
    #[arg(long)]
    open: bool,
}

pub(super) fn run(arguments: &Arguments) -> Result<u8, Failure> {
    let dir = match &arguments.command {
        Some(What::Export { dir }) => dir,
        Some(What::Run(run)) => return scan_one(run),
        None => return Ok(list()),
    };
    let written = export(dir)?;
    let text: String = written.iter().map(|p| format!("{}\n", p.display())).collect();
    output::result(&text);
    Ok(NO_HAZARD)
}

fn list() -> u8 {
    let mut text = String::new();
    for example in examples::all() {
        let _ = writeln!(text, "{:<16} {}", example.name, example.summary);
    }
    output::result(&text);
    output::note("scan one with: fmi-hazard examples run NAME; export them with: fmi-hazard examples export DIR");
    NO_HAZARD
}

fn export(dir: &Path) -> Result<Vec<PathBuf>, Failure> {
    examples::export(dir).map_err(|e| Failure::unusable(format!("cannot write to {}: {e}", dir.display())))
}

fn scan_one(run: &ScanExampleArguments) -> Result<u8, Failure> {
    if examples::by_name(&run.name).is_none() {
        let names: Vec<&str> = examples::all().iter().map(|example| example.name).collect();
        let help = format!("there are {}", names.join(", "));
        return Err(Failure::unusable_with_help(format!("there is no example {}", run.name), help));
    }
    let cells = run.out.join("cells");
    export(&cells)?;
    let cell = cells.join(&run.name).join("cell.toml");
    output::note(&format!("  Exported the example cells to {}", cells.display()));
    let command = format!("fmi-hazard scan {} --strategy hybrid --iterations {ITERATIONS}", cell.display());
    output::note(&format!("   Running {command}"));
    let results = run.out.join(&run.name);
    let code = scan::run(&scan::Arguments::of_example(cell, results.clone(), ITERATIONS))?;
    if run.open {
        let report = results.join("report.html");
        if let Err(error) = open::that_detached(&report) {
            output::warning(&format!("no browser shows {}: {error}", report.display()));
        }
    }
    Ok(code)
}
