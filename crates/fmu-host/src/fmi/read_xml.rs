//! Reading modelDescription.xml of FMI 2.0 and FMI 3.0: strict where a wrong value would give wrong results, lenient
//! elsewhere. Unknown attributes and elements are warnings, vendor annotations are skipped.

mod attributes;
mod checks;
mod encoding;
mod fmi2;
mod fmi3;
mod model;

use std::collections::BTreeMap;
use std::fmt;

use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};

use super::description::{MOST_VALUES, ModelDescription};
use super::text::printable;
use super::variable::{Causality, Variable, VariableType};
use super::version::FmiVersion;
use attributes::Attributes;

/// Something odd that does not keep the FMU from being used.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Warning {
    /// What.
    pub message: String,
    /// Line in modelDescription.xml, from 1.
    pub line: usize,
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: {}", self.line, self.message)
    }
}

/// What keeps a modelDescription.xml from being used, and where.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DescriptionError {
    /// Line, from 1.
    pub line: usize,
    /// Column, from 1.
    pub column: usize,
    /// What is wrong and what to do.
    pub message: String,
}

impl DescriptionError {
    fn new(text: &str, offset: usize, message: &str) -> Self {
        let (line, column) = line_and_column(text, offset);
        Self { line, column, message: printable(message) }
    }
}

impl fmt::Display for DescriptionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}, column {}: {}", self.line, self.column, self.message)
    }
}

impl std::error::Error for DescriptionError {}

impl ModelDescription {
    /// Reads the bytes of a modelDescription.xml of FMI 2.0 or FMI 3.0, in UTF-8 or UTF-16. Of other versions only
    /// [`ModelDescription::fmi_version`] is filled in.
    ///
    /// # Errors
    /// The first thing in it that cannot be read or would give wrong results, with its place.
    pub fn from_xml(bytes: &[u8]) -> Result<(Self, Vec<Warning>), DescriptionError> {
        let (text, utf16) = encoding::decode(bytes)?;
        let text = text.as_ref();
        let (description, mut warnings) = read(text).map_err(|p| DescriptionError::new(text, p.offset, &p.message))?;
        if utf16 {
            let message = "the file is UTF-16, FMI asks for UTF-8: other programs may not read it".to_owned();
            warnings.insert(0, Warning { message, line: 1 });
        }
        Ok((description, warnings))
    }
}

/// What keeps a description from being used, and where.
#[derive(Debug)]
struct Problem {
    offset: usize,
    message: String,
}

/// Most warnings kept.
const WARNINGS: usize = 50;

/// Line and column, both from 1, of a byte offset.
fn line_and_column(text: &str, offset: usize) -> (usize, usize) {
    let before = text.get(..offset.min(text.len())).unwrap_or(text);
    let line_start = before.rfind('\n').map_or(0, |i| i + 1);
    (before.matches('\n').count() + 1, before[line_start..].chars().count() + 1)
}

/// Reads the text of modelDescription.xml.
fn read(text: &str) -> Result<(ModelDescription, Vec<Warning>), Problem> {
    let mut parser = Parser {
        d: ModelDescription::default(),
        warnings: Vec::new(),
        types: BTreeMap::new(),
        unit: None,
        references: BTreeMap::new(),
        type_name: None,
        lines: Lines::new(text),
        pending: None,
        array: None,
    };
    let mut reader = Reader::from_str(text);
    reader.config_mut().expand_empty_elements = true;
    let mut path: Vec<String> = Vec::new();
    loop {
        let offset = usize::try_from(reader.buffer_position()).unwrap_or(usize::MAX);
        let event = reader.read_event().map_err(|e| {
            let at = usize::try_from(reader.error_position()).unwrap_or(offset);
            Problem { offset: at, message: format!("this is not well-formed XML: {e}") }
        })?;
        match event {
            Event::Start(element) => {
                let name = element.name().as_ref().to_owned();
                let parent = nearest_root(&path);
                parser.start(&parent, &name, &element, offset)?;
                path.push(name);
            }
            Event::End(_) => {
                path.pop();
                parser.end(&nearest_root(&path))?;
            }
            Event::DocType(_) => {
                let message = "a DOCTYPE, which FMUs never need and which can be abused; refused".to_owned();
                return Err(Problem { offset, message });
            }
            Event::Eof if path.is_empty() => break,
            Event::Eof => {
                return Err(Problem { offset, message: format!("the file ends inside <{}>", path.join("><")) });
            }
            _ => {}
        }
    }
    if parser.d.fmi_version.is_empty() {
        return Err(Problem { offset: 0, message: "there is no <fmiModelDescription> element".to_owned() });
    }
    parser.index()?;
    Ok((parser.d, parser.warnings))
}

/// The first elements of a path: nothing that lies deeper matters, and nesting without end must not cost more and more.
fn nearest_root(path: &[String]) -> Vec<&str> {
    path.iter().take(4).map(String::as_str).collect()
}

/// Byte offsets of line starts, so that a line number costs a binary search.
struct Lines(Vec<usize>);

impl Lines {
    fn new(text: &str) -> Self {
        Self(std::iter::once(0).chain(text.match_indices('\n').map(|(i, _)| i + 1)).collect())
    }

    fn line(&self, offset: usize) -> usize {
        self.0.partition_point(|&start| start <= offset)
    }

    /// Where a line starts.
    fn start(&self, line: usize) -> usize {
        self.0.get(line - 1).copied().unwrap_or(0)
    }
}

/// Attributes that a declared type hands down.
#[derive(Clone, Debug, Default)]
struct Inherited {
    unit: Option<String>,
    min: Option<f64>,
    max: Option<f64>,
}

struct Parser {
    d: ModelDescription,
    warnings: Vec<Warning>,
    types: BTreeMap<String, Inherited>,
    /// The unit that is being defined.
    unit: Option<String>,
    /// FMI 3.0: the variable of each value reference, and its line.
    references: BTreeMap<u32, (String, usize)>,
    type_name: Option<String>,
    lines: Lines,
    /// FMI 2.0: a `ScalarVariable` whose type element has not come yet.
    pending: Option<(Variable, usize)>,
    /// FMI 3.0: a variable whose dimensions, starts and aliases may still come.
    array: Option<fmi3::Pending>,
}

impl Parser {
    fn warn(&mut self, offset: usize, message: String) {
        if self.warnings.len() < WARNINGS {
            let message = printable(&message);
            self.warnings.push(Warning { message, line: self.lines.line(offset) });
        }
    }

    fn leftovers(&mut self, attributes: &Attributes) {
        for name in attributes.values.keys() {
            if !name.starts_with("xmlns") && !name.contains(':') {
                self.warn(attributes.offset, format!("unknown attribute `{name}` in <{}>", attributes.element));
            }
        }
    }

    fn start(&mut self, path: &[&str], name: &str, element: &BytesStart<'_>, offset: usize) -> Result<(), Problem> {
        let mut a = Attributes::new(element, name, offset)?;
        if !path.is_empty() && self.d.version().is_none() {
            // Other versions name other things differently: the caller says so before anything is misread.
            return Ok(());
        }
        match (path, name) {
            ([], "fmiModelDescription") if self.d.fmi_version.is_empty() => {
                self.root(&mut a)?;
                self.leftovers(&a);
            }
            ([], "fmiModelDescription") => {
                return Err(a.problem("a second root element, the file must have one"));
            }
            ([], other) => {
                let message = format!("the root element is <{other}>, it must be <fmiModelDescription>");
                return Err(Problem { offset, message });
            }
            (["fmiModelDescription"], "CoSimulation") => {
                self.co_simulation(&mut a)?;
                self.leftovers(&a);
            }
            (["fmiModelDescription"], "ModelExchange") => self.d.has_model_exchange = true,
            (["fmiModelDescription"], "DefaultExperiment") => {
                self.experiment(&mut a)?;
                self.leftovers(&a);
            }
            (["fmiModelDescription", "UnitDefinitions"], "Unit") => {
                self.unit = a.take("name");
                self.d.units.extend(self.unit.clone().map(|name| (name, 1.0)));
            }
            (["fmiModelDescription", "UnitDefinitions", "Unit"], "BaseUnit") => self.base_unit(&mut a),
            (
                ["fmiModelDescription"],
                "TypeDefinitions" | "UnitDefinitions" | "LogCategories" | "VendorAnnotations" | "Annotations"
                | "ModelVariables" | "ModelStructure" | "ScheduledExecution",
            ) => {}
            (["fmiModelDescription"], other) => self.warn(offset, format!("unknown element <{other}>")),
            _ if self.d.version() == Some(FmiVersion::V3) => self.start3(path, name, &mut a)?,
            _ => self.start2(path, name, &mut a)?,
        }
        Ok(())
    }

    fn end(&mut self, path: &[&str]) -> Result<(), Problem> {
        if !matches!(path, [_, "ModelVariables"]) {
            return Ok(());
        }
        if let Some((variable, offset)) = self.pending.take() {
            let message = format!("variable `{}` has no type element and is left out", variable.name);
            self.warn(offset, message);
        }
        if let Some(done) = self.array.take() {
            let line = self.lines.line(done.offset());
            let offset = self.lines.start(line);
            self.d.variables.extend(done.variables().map_err(|message| Problem { offset, message })?);
        }
        Ok(())
    }

    /// Unit and limits of the type that a variable declares, if it does.
    fn inherited(&mut self, a: &mut Attributes, variable: &str) -> Inherited {
        let Some(declared) = a.take("declaredType") else { return Inherited::default() };
        if let Some(found) = self.types.get(&declared) {
            return found.clone();
        }
        self.warn(a.offset, format!("`{variable}` is of the undefined type `{declared}`"));
        Inherited::default()
    }

    /// The indices by name and of array sizes; a name that stands twice is an error, and so is an array whose size
    /// cannot be told.
    fn index(&mut self) -> Result<(), Problem> {
        for (i, variable) in self.d.variables.iter().enumerate() {
            if let Some(first) = self.d.by_name.insert(variable.name.clone(), i) {
                let other = self.d.variables[first].line;
                let message = format!("two variables are called `{}` (the other is in line {other})", variable.name);
                return Err(Problem { offset: self.lines.start(variable.line), message });
            }
            if let (Causality::StructuralParameter, VariableType::Integer { start }) =
                (variable.causality, &variable.kind)
                && let Some(size) = start.first().and_then(|s| usize::try_from(*s).ok())
            {
                self.d.sizes.insert(variable.value_reference, size);
            }
        }
        let mut odd = Vec::new();
        for variable in self.d.variables.iter().filter(|v| !v.dimensions.is_empty()) {
            let offset = self.lines.start(variable.line);
            let Some(count) = self.d.count(variable) else {
                let message = format!(
                    "the size of the array `{}` cannot be told: a dimension names no structural parameter with a \
                     start value, or there would be more than {MOST_VALUES} values",
                    variable.name
                );
                return Err(Problem { offset, message });
            };
            let starts = variable.kind.starts();
            if starts > 1 && starts != count {
                odd.push((offset, format!("`{}` has {count} values, but {starts} start values", variable.name)));
            }
        }
        odd.into_iter().for_each(|(offset, message)| self.warn(offset, message));
        self.look_for_oddities();
        Ok(())
    }
}

#[cfg(test)]
#[path = "read_xml_tests.rs"]
mod tests;
