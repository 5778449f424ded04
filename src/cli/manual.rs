//! `fmi-hazard manual`: shell completions, manual pages and the reference of the book, made from the same definitions as
//! the command line and the cell file.

use std::path::PathBuf;

use clap::{Command, CommandFactory};
use clap_complete::Shell;

use super::exit::{Failure, NO_HAZARD};
use super::{output, reference};

#[derive(Debug, clap::Args)]
#[group(required = true, multiple = false)]
pub(super) struct Arguments {
    /// Print the completions for this shell; for bash, `source <(fmi-hazard manual --completions bash)`
    #[arg(long, value_name = "SHELL", value_enum)]
    completions: Option<Shell>,
    /// Write the manual pages into this folder: fmi-hazard.1 and one for each command
    #[arg(long, value_name = "DIR")]
    pages: Option<PathBuf>,
    /// Write the reference of the book into this folder: commands.md and cell-file.md
    #[arg(long, value_name = "DIR")]
    book: Option<PathBuf>,
}

pub(super) fn run<C: CommandFactory>(arguments: &Arguments) -> Result<u8, Failure> {
    let mut command = shown(&C::command());
    if let Some(shell) = arguments.completions {
        let name = command.get_name().to_owned();
        let mut script = Vec::new();
        clap_complete::generate(shell, &mut command, name, &mut script);
        // clap_complete up to 4.6.11 spells a name with a hyphen in two ways, so that bash completes nothing behind a
        // command (clap-rs/clap#6421).
        let script = String::from_utf8_lossy(&script).replace("fmi__subcmd__hazard", "fmi__hazard");
        output::script(&script);
    }
    if let Some(folder) = &arguments.pages {
        let cannot = |e: std::io::Error| Failure::unusable(format!("cannot write to {}: {e}", folder.display()));
        std::fs::create_dir_all(folder).map_err(cannot)?;
        clap_mangen::generate_to(command, folder).map_err(cannot)?;
        output::note(&format!("   Wrote   manual pages into {}", folder.display()));
    }
    if let Some(folder) = &arguments.book {
        let cannot = |e: std::io::Error| Failure::unusable(format!("cannot write to {}: {e}", folder.display()));
        std::fs::create_dir_all(folder).map_err(cannot)?;
        output::write_file(&folder.join("commands.md"), &reference::commands(&shown(&C::command())))?;
        output::write_file(&folder.join("cell-file.md"), &reference::cell_file(&crate::cell::json_schema()))?;
        output::note(&format!("   Wrote   commands.md and cell-file.md into {}", folder.display()));
    }
    Ok(NO_HAZARD)
}

/// The command without what is not for people, which completions would list.
fn shown(command: &Command) -> Command {
    let commands = command.get_subcommands().filter(|command| !command.is_hide_set()).cloned();
    Command::new("fmi-hazard")
        .version(env!("CARGO_PKG_VERSION"))
        .about(command.get_about().cloned().unwrap_or_default())
        .after_help(command.get_after_help().cloned().unwrap_or_default())
        .args(command.get_arguments().cloned())
        .subcommands(commands)
}
