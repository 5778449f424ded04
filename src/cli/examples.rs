//! `fmi-hazard examples`: the built-in example cells.

use std::fmt::Write as _;
use std::path::PathBuf;

use clap::Subcommand;

use super::exit::{Failure, NO_HAZARD};
use super::output;
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
}

pub(super) fn run(arguments: &Arguments) -> Result<u8, Failure> {
    let Some(What::Export { dir }) = &arguments.command else {
        let mut text = String::new();
        for example in examples::all() {
            let _ = writeln!(text, "{:<16} {}", example.name, example.summary);
        }
        output::result(&text);
        output::note("export them with: fmi-hazard examples export DIR");
        return Ok(NO_HAZARD);
    };
    let written =
        examples::export(dir).map_err(|e| Failure::unusable(format!("cannot write to {}: {e}", dir.display())))?;
    let text: String = written.iter().map(|p| format!("{}\n", p.display())).collect();
    output::result(&text);
    Ok(NO_HAZARD)
}
