//! The list of commands in `--help`: by what one wants to do.

use std::fmt::Write as _;

use clap::Command;

use super::output;

/// What one does with a cell, in this order, and the commands for it.
const GROUPS: [(&str, &[&str]); 4] = [
    ("Begin", &["examples", "inspect", "init", "check", "distance", "pack"]),
    ("Scan", &["scan", "campaign", "bench"]),
    ("Understand what was found, and whether a change helps", &["explain", "replay", "report", "compare"]),
    ("Besides", &["help"]),
];

/// The same command, whose help lists its subcommands in groups.
pub(super) fn grouped(command: Command) -> Command {
    let width = output::view().width;
    let mut text = String::new();
    for (title, names) in GROUPS {
        let _ = writeln!(text, "{title}:");
        for name in names {
            let about = command.find_subcommand(name).and_then(Command::get_about).map(ToString::to_string);
            let about = about.unwrap_or_else(|| "Print this, or the help of a command".to_owned());
            let head = format!("  {name:<10}");
            let options = textwrap::Options::new(width).initial_indent(&head).subsequent_indent("            ");
            let _ = writeln!(text, "{}", textwrap::fill(&about, options));
        }
        text.push('\n');
    }
    // Braces of ours would be taken for tags.
    let text = text.replace(['{', '}'], "");
    command.help_template(format!(
        "{{before-help}}{{about-with-newline}}\n{{usage-heading}} {{usage}}\n\n{text}Options:\n{{options}}{{after-help}}"
    ))
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory as _;

    use super::*;

    #[test]
    fn every_command_is_in_one_group() {
        let command = super::super::Arguments::command();
        let mut listed: Vec<&str> = GROUPS.iter().flat_map(|(_, names)| *names).copied().collect();
        let shown = command.get_subcommands().filter(|command| !command.is_hide_set()).map(Command::get_name);
        let mut all: Vec<&str> = shown.chain(["help"]).collect();
        listed.sort_unstable();
        all.sort_unstable();
        assert_eq!(listed, all);
    }
}
