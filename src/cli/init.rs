//! `fmi-hazard init`: a first cell file for an FMU or a system of FMUs, with what is guessed marked and what is missing to
//! be filled in.
//!
//! The FMU is not run. Questions are asked only where a person sits at a terminal.

use std::io::{IsTerminal as _, Write as _};
use std::path::{Path, PathBuf};

use super::exit::{Failure, NO_HAZARD};
use super::output;
use crate::cell::draft::interface::Interface;
use crate::cell::draft::{Described, Facts, TODO, draft};
use crate::cell::file::described;
use crate::cell::file::files::plain;
use crate::cell::foreign::ssp::{self, System};
use crate::cell::json_schema;
use crate::fmi::Fmu;

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The FMU, or the system of FMUs (.ssp, .ssd)
    fmu: PathBuf,
    /// A robot description: its kinematics, masses and collision shapes are used
    #[arg(long)]
    urdf: Option<PathBuf>,
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
    let fmu_path = relative(&arguments.fmu, folder);
    let urdf_path = arguments.urdf.as_ref().map(|urdf| relative(urdf, folder));
    let summary = match &arguments.urdf {
        Some(urdf) => Some(described::summary(urdf)?),
        None => None,
    };
    let urdf = urdf_path.as_deref().zip(summary.as_ref()).map(|(path, summary)| Described {
        path,
        joints: summary.joints.clone(),
        has_masses: summary.moving_mass_kg.is_some(),
        has_shapes: summary.unreadable.is_none(),
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
    if let Some(reason) = summary.and_then(|summary| summary.unreadable) {
        output::warning(&format!("{reason}; the cell file takes the kinematics only"));
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

/// What the cell is to be around.
enum Subject {
    Fmu(Box<Fmu>),
    System(Box<System>),
}

impl Subject {
    fn open(path: &Path) -> Result<Self, Failure> {
        Ok(if ssp::is_ssp(path) {
            Self::System(Box::new(ssp::open(path)?))
        } else {
            Self::Fmu(Box::new(Fmu::open(path)?))
        })
    }

    fn interface(&self) -> Interface<'_> {
        match self {
            Self::Fmu(fmu) => Interface::of_fmu(fmu.description()),
            Self::System(system) => Interface::of_system(system),
        }
    }
}

/// `path` as a file in `folder` names it: without the folder if it is inside, else absolute.
fn relative(path: &Path, folder: &Path) -> String {
    let absolute = |path: &Path| {
        let path = if path.as_os_str().is_empty() { Path::new(".") } else { path };
        plain(&std::path::absolute(path).unwrap_or_else(|_| path.to_owned()))
    };
    let (path, folder) = (absolute(path), absolute(folder));
    let shared = path.components().zip(folder.components()).take_while(|(a, b)| a == b).count();
    if shared <= 1 {
        return path.display().to_string();
    }
    let up = folder.components().skip(shared).map(|_| "..");
    let down = path.components().skip(shared).map(|c| c.as_os_str().to_string_lossy().into_owned());
    up.map(str::to_owned).chain(down).collect::<Vec<_>>().join("/")
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
