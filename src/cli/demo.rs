//! `fmi-hazard demo`: the first minute with the tool. Exports an example cell and scans it.

use std::path::PathBuf;

use super::exit::Failure;
use super::{output, scan};
use crate::examples;

/// Enough for several hazards within seconds; looking at every sequence, as a scan does by default, takes minutes.
const ITERATIONS: u32 = 20;

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// Where the example and the results go
    #[arg(long, default_value = "out/demo")]
    out: PathBuf,
    /// Show the report in the browser
    #[arg(long)]
    open: bool,
}

pub(super) fn run(arguments: &Arguments) -> Result<u8, Failure> {
    let cells = arguments.out.join("cells");
    examples::export(&cells).map_err(|e| Failure::unusable(format!("cannot write to {}: {e}", cells.display())))?;
    let fmu = cells.join("safety-fence/safety-fence.fmu");
    output::note(&format!("  Exported the example cells to {}", cells.display()));
    let command = format!("fmi-hazard scan {} --strategy hybrid --iterations {ITERATIONS}", fmu.display());
    output::note(&format!("   Running {command}"));
    let results = arguments.out.join("safety-fence");
    let code = scan::run(&scan::Arguments::for_demo(fmu, results.clone(), ITERATIONS))?;
    if arguments.open {
        let report = results.join("report.html");
        if let Err(error) = open::that_detached(&report) {
            output::warning(&format!("no browser shows {}: {error}", report.display()));
        }
    }
    Ok(code)
}
