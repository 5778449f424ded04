//! What an FMU is, by its description alone, and what of it a scan could use: for people and as JSON.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

use serde::Serialize;

use crate::cell::EXTRA_FOLDER;
use crate::cell::draft::roles::{Guess, Role, guess};
use crate::cell::foreign::ssp::{Link, System};
use crate::fmi::{Causality, FmiVersion, Fmu, ModelDescription, Variable, VariableType, printable};

/// What an FMU is.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Inspection {
    /// The file.
    pub path: String,
    /// SHA-256 of it.
    pub sha256: String,
    /// FMI version.
    pub fmi_version: String,
    /// Model name.
    pub model_name: String,
    /// Exporting tool.
    pub generation_tool: Option<String>,
    /// Platforms that it has a binary for.
    pub platforms: Vec<String>,
    /// Whether one of them is this machine's.
    pub runs_here: bool,
    /// What the co-simulation interface can do.
    pub capabilities: BTreeMap<&'static str, String>,
    /// Whether it carries its cell file.
    pub own_cell: bool,
    /// How many variables it has, by causality.
    pub counts: BTreeMap<String, usize>,
    /// Those that are shown.
    pub variables: Vec<VariableInfo>,
    /// What they are for, guessed.
    pub roles: Vec<Guess>,
    /// What a scan needs and nothing here offers.
    pub missing: Vec<String>,
    /// What is odd in the description.
    pub warnings: Vec<String>,
}

/// A variable.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct VariableInfo {
    /// Its name.
    pub name: String,
    /// Input, output and so on.
    pub causality: String,
    /// Type and shape, for instance `Float64[3]`.
    pub kind: String,
    /// Unit.
    pub unit: Option<String>,
    /// Description.
    pub description: String,
}

/// Which variables to show.
#[derive(Clone, Debug, Default)]
pub(crate) struct Filter {
    /// Local variables and parameters too.
    pub all: bool,
    /// Local variables too: a cell may bind them like outputs.
    pub locals: bool,
    /// Only those whose name or description holds this, whatever the case.
    pub containing: Option<String>,
}

impl Filter {
    fn shows(&self, variable: &Variable) -> bool {
        let wanted = match variable.causality {
            Causality::Input | Causality::Output => true,
            Causality::Local => self.all || self.locals,
            _ => self.all,
        };
        let found = self.containing.as_ref().is_none_or(|part| {
            let part = part.to_lowercase();
            [&variable.name, &variable.description].iter().any(|text| text.to_lowercase().contains(&part))
        });
        wanted && found
    }
}

impl Inspection {
    /// Of an FMU that was opened.
    #[must_use]
    pub(crate) fn new(fmu: &Fmu, filter: &Filter) -> Self {
        let d = fmu.description();
        let own_cell = fmu.file(&format!("{EXTRA_FOLDER}/cell.toml")).is_some();
        let roles = guess(d);
        let mut counts = BTreeMap::new();
        d.variables.iter().for_each(|v| *counts.entry(v.causality.to_string()).or_default() += 1);
        Self {
            path: fmu.path().display().to_string(),
            sha256: fmu.sha256().to_owned(),
            fmi_version: d.fmi_version.clone(),
            model_name: d.model_name.clone(),
            generation_tool: d.generation_tool.clone(),
            platforms: fmu.platforms().to_vec(),
            runs_here: fmu.runs_here(),
            capabilities: capabilities(d),
            own_cell,
            counts,
            variables: d.variables.iter().filter(|v| filter.shows(v)).map(|v| shown(d, v)).collect(),
            missing: missing(&roles, own_cell),
            roles,
            warnings: fmu.warnings().iter().map(ToString::to_string).collect(),
        }
    }

    /// For people.
    #[must_use]
    pub(crate) fn render(&self) -> String {
        let mut text = String::new();
        let _ = writeln!(text, "{}  FMI {}  \"{}\"", self.path, self.fmi_version, printable(&self.model_name));
        let tool = self.generation_tool.as_deref().unwrap_or("unknown");
        let _ = writeln!(text, "  exported by  {}", printable(tool));
        let _ = writeln!(text, "  sha256       {}", self.sha256);
        let here = if self.runs_here { "this machine's is among them" } else { "NOT FOR THIS MACHINE" };
        let _ = writeln!(text, "  platforms    {} ({here})", printable(&self.platforms.join(", ")));
        let capabilities: Vec<String> = self.capabilities.iter().map(|(what, how)| format!("{what} {how}")).collect();
        let _ = writeln!(text, "  can          {}", capabilities.join(", "));
        let _ = writeln!(text, "  own cell     {}", if self.own_cell { "yes" } else { "no" });
        self.roles_for_people(&mut text);
        for missing in &self.missing {
            let _ = writeln!(text, "  missing      {missing}");
        }
        let count = |of: &str| self.counts.get(of).copied().unwrap_or(0);
        let _ = writeln!(
            text,
            "  variables    {} ({} inputs, {} outputs, {} parameters, {} locals)",
            self.counts.values().sum::<usize>(),
            count("input"),
            count("output"),
            count("parameter"),
            count("local")
        );
        if count("local") > 0 && !self.variables.iter().any(|v| v.causality == Causality::Local.to_string()) {
            let _ = writeln!(text, "               locals are listed with --locals; a cell may bind them like outputs");
        }
        for v in &self.variables {
            let unit = v.unit.as_ref().map_or_else(String::new, |unit| format!(" {unit}"));
            // What comes from the vendor may be of any length; its control characters are escaped where it is printed.
            let _ = writeln!(
                text,
                "    {:<12} {:<28} {:<10} {}",
                v.causality,
                printable(&v.name),
                printable(&format!("{}{unit}", v.kind)),
                printable(&v.description)
            );
        }
        text
    }

    /// One line for what belongs together.
    fn roles_for_people(&self, text: &mut String) {
        let mut lines: BTreeMap<String, (Vec<&str>, f64)> = BTreeMap::new();
        for guess in &self.roles {
            let what = kind(&guess.role) + if guess.local { ", local" } else { "" };
            let (names, confidence) = lines.entry(what).or_insert_with(|| (Vec::new(), 1.0));
            names.push(&guess.variable);
            *confidence = confidence.min(guess.confidence);
        }
        if lines.is_empty() {
            let _ =
                writeln!(text, "  roles        none guessed: no name, unit or description says what a variable is for");
        }
        for (number, (what, (names, confidence))) in lines.iter().enumerate() {
            let head = if number == 0 { "roles" } else { "" };
            let names = match names.as_slice() {
                [first, .., last] if names.len() > 3 => format!("{first} ... {last} ({})", names.len()),
                few => few.join(", "),
            };
            let _ = writeln!(text, "  {head:<12} {what:<26} {confidence:.2}  {}", printable(&names));
        }
    }
}

/// What a system of FMUs is.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct SystemInspection {
    /// The file.
    pub path: String,
    /// SHA-256 of it.
    pub sha256: String,
    /// SSP version.
    pub ssp_version: String,
    /// Name of the system.
    pub name: String,
    /// Inputs of the system, each with the variables that it drives.
    pub inputs: BTreeMap<String, Vec<String>>,
    /// Outputs of the system, each with the variable that it is.
    pub outputs: BTreeMap<String, String>,
    /// Connections between components, in words.
    pub connections: Vec<String>,
    /// Parameters that the system sets, by variable.
    pub parameters: Vec<String>,
    /// Its components, by name.
    pub components: Vec<(String, Inspection)>,
    /// What was passed over and may matter.
    pub warnings: Vec<String>,
}

impl SystemInspection {
    /// What `system`, read from `path`, is.
    #[must_use]
    pub(crate) fn new(path: &Path, system: &System, components: Vec<(String, Inspection)>) -> Self {
        let structure = &system.structure;
        let shown =
            |(component, variable): &(usize, String)| format!("{}:{variable}", structure.components[*component].name);
        let link = |link: &Link| {
            let (from, to) = (shown(&link.from), shown(&link.to));
            match (link.factor == 1.0, link.offset == 0.0) {
                (true, true) => format!("{from} -> {to}"),
                _ => format!("{from} -> {to} (x {} + {})", link.factor, link.offset),
            }
        };
        Self {
            path: path.display().to_string(),
            sha256: system.sha256.clone(),
            ssp_version: structure.version.clone(),
            name: structure.name.clone(),
            inputs: structure.inputs.iter().map(|(name, to)| (name.clone(), to.iter().map(shown).collect())).collect(),
            outputs: structure.outputs.iter().map(|(name, from)| (name.clone(), shown(from))).collect(),
            connections: structure.links.iter().map(link).collect(),
            parameters: structure.parameters.iter().map(|p| shown(&(p.component, p.name.clone()))).collect(),
            components,
            warnings: structure.warnings.clone(),
        }
    }

    /// For people.
    #[must_use]
    pub(crate) fn render(&self) -> String {
        let mut text = String::new();
        let _ = writeln!(
            text,
            "{}: SSP {}, {} with {} components, {} connections",
            printable(&self.path),
            self.ssp_version,
            printable(&self.name),
            self.components.len(),
            self.connections.len()
        );
        for (name, driven) in &self.inputs {
            let _ = writeln!(text, "  input        {} -> {}", printable(name), printable(&driven.join(", ")));
        }
        for (name, from) in &self.outputs {
            let _ = writeln!(text, "  output       {} = {}", printable(name), printable(from));
        }
        for connection in &self.connections {
            let _ = writeln!(text, "  connection   {}", printable(connection));
        }
        if !self.parameters.is_empty() {
            let _ = writeln!(text, "  parameters   {}", printable(&self.parameters.join(", ")));
        }
        for (name, component) in &self.components {
            let _ = write!(text, "\ncomponent {}: {}", printable(name), component.render());
        }
        text
    }
}

/// What a role is called on a line of its own.
fn kind(role: &Role) -> String {
    let of = |robot: &str| if robot.is_empty() { String::new() } else { format!(" of {}", printable(robot)) };
    let polarity = |active: &Option<bool>| match active {
        Some(value) => format!(" ({value} = person)"),
        None => " (polarity unknown)".to_owned(),
    };
    match role {
        Role::JointAngle { robot, .. } => format!("joint angles{}", of(robot)),
        Role::JointSpeed { robot, .. } => format!("joint speeds{}", of(robot)),
        Role::LinkPose { .. } => "poses of links".to_owned(),
        Role::Payload => "payload".to_owned(),
        Role::Phase => "phase or mode".to_owned(),
        Role::SensorInput { active } => format!("safety input{}", polarity(active)),
        Role::SensorNumber { detected, .. } => match detected {
            Some(value) => format!("safety input ({value} = person)"),
            None => "safety input (values unknown)".to_owned(),
        },
        Role::SensorOutput { active } => format!("sensor inside{}", polarity(active)),
        Role::Human { .. } => "person's pose".to_owned(),
        Role::Constant => "held constant".to_owned(),
    }
}

fn missing(roles: &[Guess], own_cell: bool) -> Vec<String> {
    let any = |of: fn(&Role) -> bool| roles.iter().any(|guess| of(&guess.role));
    let mut missing = Vec::new();
    if !any(|role| matches!(role, Role::JointAngle { .. } | Role::LinkPose { .. })) {
        missing
            .push("how the robot moves: no joint angles and no poses of links among the outputs and locals".to_owned());
    }
    let tells = |role: &Role| {
        use Role::{Human, SensorInput, SensorNumber, SensorOutput};
        matches!(role, SensorInput { .. } | SensorNumber { .. } | SensorOutput { .. } | Human { .. })
    };
    if !any(tells) {
        missing.push("what the cell is told of a person: no safety signal and no person among the inputs".to_owned());
    }
    if !own_cell {
        missing.push(
            "a cell file: shapes of the robot, obstacles, zones of sensors, the person's start (`fmi-hazard schema`; \
             `fmi-hazard examples export DIR`)"
                .to_owned(),
        );
    }
    missing
}

fn capabilities(d: &ModelDescription) -> BTreeMap<&'static str, String> {
    let yes = |b: bool| if b { "yes" } else { "no" }.to_owned();
    let Some(cs) = &d.co_simulation else { return BTreeMap::new() };
    let c = &cs.capabilities;
    let mut all = BTreeMap::from([
        ("state get/set", yes(c.can_get_and_set_state)),
        ("state serialise", yes(c.can_serialize_state)),
        ("variable step", yes(c.can_handle_variable_step)),
        ("once per process", yes(c.once_per_process)),
        ("needs its tool", yes(c.needs_execution_tool)),
    ]);
    if d.version() == Some(FmiVersion::V3) {
        all.insert("event mode", yes(c.has_event_mode));
        all.insert("might return early", yes(c.might_return_early));
        all.insert("intermediate update", yes(c.provides_intermediate_update));
        all.insert("fixed internal step", c.fixed_internal_step.map_or_else(|| yes(false), |h| format!("{h} s")));
    }
    all
}

fn shown(d: &ModelDescription, v: &Variable) -> VariableInfo {
    let mut kind = d.version().map_or_else(|| v.scalar.to_string(), |version| v.type_name(version));
    if let Some(extents) = d.extents(v).filter(|e| !e.is_empty()) {
        let extents: Vec<String> = extents.iter().map(ToString::to_string).collect();
        let _ = write!(kind, "[{}]", extents.join(","));
    }
    let unit = match &v.kind {
        VariableType::Real { unit, .. } => unit.clone(),
        _ => None,
    };
    VariableInfo {
        name: v.name.clone(),
        causality: v.causality.to_string(),
        kind,
        unit,
        description: v.description.clone(),
    }
}
