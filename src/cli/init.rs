//! `fmi-hazard init`: a first cell file for an FMU or a system of FMUs, with what is guessed marked and what is missing to
//! be filled in.
//!
//! The FMU is not run. Questions are asked only where a person sits at a terminal.

use std::io::{IsTerminal as _, Write as _};
use std::path::{Path, PathBuf};

use super::exit::{Failure, NO_HAZARD};
use super::output;
use super::subject::Subject;
use crate::cell::draft::{Described, Facts, TODO, draft};
use crate::cell::file::described;
use crate::cell::file::files::named_from;
use crate::cell::json_schema;

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The FMU, or the system of FMUs (.ssp, .ssd)
    fmu: PathBuf,
    /// A robot description: its kinematics, masses and collision shapes are used
    #[arg(long)]
    urdf: Option<PathBuf>,
    /// Where a package is that the robot description names (package://NAME/...); may be given several times. Without it,
    /// folders above and beside the description are searched, ROS_PACKAGE_PATH and AMENT_PREFIX_PATH
    #[arg(long = "package", value_name = "NAME=DIR", value_parser = package, requires = "urdf")]
    packages: Vec<(String, PathBuf)>,
    /// Where to write the cell file (default: <FMU>.cell.toml beside it)
    #[arg(long, short)]
    out: Option<PathBuf>,
    /// Replace a cell file that is there
    #[arg(long)]
    force: bool,
    /// Ask nothing
    #[arg(long, short)]
    yes: bool,
}

/// A package and its folder.
fn package(text: &str) -> Result<(String, PathBuf), String> {
    let (name, folder) = text
        .split_once('=')
        .filter(|(name, folder)| !name.is_empty() && !folder.is_empty())
        .ok_or("give it as NAME=DIR")?;
    if !Path::new(folder).is_dir() {
        return Err(format!("there is no folder {folder}"));
    }
    Ok((name.to_owned(), folder.into()))
}

/// Name of the schema beside the cell file.
const SCHEMA: &str = "cell.schema.json";

pub(super) fn run(arguments: &Arguments) -> Result<u8, Failure> {
    let subject = Subject::open(&arguments.fmu)?;
    let path = arguments.out.clone().unwrap_or_else(|| arguments.fmu.with_extension("cell.toml"));
    if path.exists() && !arguments.force {
        let help = "another name with --out, or --force to replace it";
        return Err(Failure::unusable_with_help(format!("{} is there already", path.display()), help));
    }
    let folder = path.parent().unwrap_or(Path::new(""));
    let fmu_path = named_from(&arguments.fmu, folder);
    let urdf_path = arguments.urdf.as_ref().map(|urdf| named_from(urdf, folder));
    let summary = match &arguments.urdf {
        Some(urdf) => Some(described::summary(urdf, folder, &arguments.packages)?),
        None => None,
    };
    let urdf = urdf_path.as_deref().zip(summary.as_ref()).map(|(path, summary)| Described {
        path,
        joints: summary.joints.clone(),
        has_masses: summary.moving_mass_kg.is_some(),
        has_shapes: summary.unreadable.is_none(),
        packages: &summary.packages,
    });
    let name = arguments.fmu.file_stem().map_or_else(|| "cell".to_owned(), |stem| stem.to_string_lossy().into_owned());
    let mut facts = Facts { name: &name, fmu: &fmu_path, urdf, ..Facts::default() };
    let asks = !arguments.yes && std::io::stdin().is_terminal() && std::io::stderr().is_terminal();
    if asks {
        ask(&mut facts);
    }
    let text = draft(&subject.interface(), &facts);
    output::write_file(&path, &text)?;
    let schema = folder.join(SCHEMA);
    if !schema.exists() {
        let json = output::pretty(&json_schema())?;
        output::write_file(&schema, &json)?;
    }
    if let Some((reason, help)) = summary.and_then(|summary| summary.unreadable) {
        let help = help.map_or_else(String::new, |help| format!(" ({help})"));
        output::warning(&format!("{reason}; the cell file takes the kinematics only{help}"));
    }
    let count = |of: &str| text.lines().filter(|line| line.contains(of)).count();
    let (guesses, todos) = (count("# GUESS"), count(TODO));
    output::result(&format!("{}\n", path.display()));
    output::note(&format!(
        "   Wrote {} ({guesses} guesses to check, {todos} things to fill in). Next: edit it, then fmi-hazard check {}",
        path.display(),
        path.display()
    ));
    Ok(NO_HAZARD)
}

/// Asks what no FMU says. An empty answer leaves a TODO.
fn ask(facts: &mut Facts<'_>) {
    output::note("An empty answer leaves a TODO in the file.");
    facts.base_m = numbers("Where does the robot's base stand? x y z in m").and_then(|v| <[f64; 3]>::try_from(v).ok());
    if facts.urdf.as_ref().is_none_or(|urdf| !urdf.has_masses) {
        facts.moving_mass_kg =
            numbers("How heavy are the robot's moving parts together? kg").and_then(|v| v.first().copied());
    }
    facts.start = numbers("Where does the person start, and look? x y in m, heading in degrees (90 is +y)")
        .and_then(|v| <[f64; 3]>::try_from(v).ok())
        .map(|[x, y, heading]| ([x, y], heading));
}

fn numbers(question: &str) -> Option<Vec<f64>> {
    let _ = write!(std::io::stderr().lock(), "{question}: ");
    let mut line = String::new();
    std::io::stdin().read_line(&mut line).ok()?;
    let words = line.split(|c: char| c.is_whitespace() || c == ',').filter(|word| !word.is_empty());
    words.map(|word| word.parse().ok().filter(|v: &f64| v.is_finite())).collect::<Option<Vec<_>>>()
}
