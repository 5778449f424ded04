//! Reading modelDescription.xml: strict where a wrong value would give wrong results, lenient elsewhere. Unknown
//! attributes and elements are warnings, vendor annotations are skipped.

use std::collections::BTreeMap;
use std::fmt;

use quick_xml::Reader;
use quick_xml::XmlVersion;
use quick_xml::events::{BytesStart, Event};

use super::description::{
    Capabilities, Causality, CoSimulation, ModelDescription, Variability, Variable, VariableType,
};

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

/// What keeps a description from being used, and where.
#[derive(Debug)]
pub(super) struct Problem {
    pub(super) offset: usize,
    pub(super) message: String,
}

/// Most warnings kept.
const WARNINGS: usize = 50;

/// Line and column, both from 1, of a byte offset.
pub(super) fn line_and_column(text: &str, offset: usize) -> (usize, usize) {
    let before = text.get(..offset.min(text.len())).unwrap_or(text);
    let line_start = before.rfind('\n').map_or(0, |i| i + 1);
    (before.matches('\n').count() + 1, before[line_start..].chars().count() + 1)
}

/// Reads the text of modelDescription.xml.
pub(super) fn read(text: &str) -> Result<(ModelDescription, Vec<Warning>), Problem> {
    let mut parser = Parser {
        d: ModelDescription::default(),
        warnings: Vec::new(),
        types: BTreeMap::new(),
        type_name: None,
        lines: Lines::new(text),
        pending: None,
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
                let parent = path.iter().map(String::as_str).collect::<Vec<_>>();
                parser.start(&parent, &name, &element, offset)?;
                path.push(name);
            }
            Event::End(_) => {
                path.pop();
                parser.end(&path.iter().map(String::as_str).collect::<Vec<_>>());
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

/// Byte offsets of line starts, so that a line number costs a binary search.
struct Lines(Vec<usize>);

impl Lines {
    fn new(text: &str) -> Self {
        Self(std::iter::once(0).chain(text.match_indices('\n').map(|(i, _)| i + 1)).collect())
    }

    fn line(&self, offset: usize) -> usize {
        self.0.partition_point(|&start| start <= offset)
    }
}

/// Attributes that a declared type hands down.
#[derive(Clone, Default)]
struct Inherited {
    unit: Option<String>,
    min: Option<f64>,
    max: Option<f64>,
}

struct Parser {
    d: ModelDescription,
    warnings: Vec<Warning>,
    types: BTreeMap<String, Inherited>,
    type_name: Option<String>,
    lines: Lines,
    /// A `ScalarVariable` whose type element has not come yet.
    pending: Option<(Variable, usize)>,
}

/// The attributes of one element, taken out one by one; what is left is unknown.
struct Attributes {
    element: String,
    offset: usize,
    values: BTreeMap<String, String>,
}

impl Attributes {
    fn new(element: &BytesStart<'_>, name: &str, offset: usize) -> Result<Self, Problem> {
        let mut values = BTreeMap::new();
        for attribute in element.attributes() {
            let wrong = |e: &dyn fmt::Display| Problem { offset, message: format!("in <{name}>: {e}") };
            let attribute = attribute.map_err(|e| wrong(&e))?;
            let key = attribute.key.as_ref().to_owned();
            let value = attribute.normalized_value(XmlVersion::Explicit1_0).map_err(|e| wrong(&e))?.into_owned();
            values.insert(key, value);
        }
        Ok(Self { element: name.to_owned(), offset, values })
    }

    fn take(&mut self, name: &str) -> Option<String> {
        self.values.remove(name)
    }

    fn problem(&self, message: impl fmt::Display) -> Problem {
        Problem { offset: self.offset, message: format!("in <{}>: {message}", self.element) }
    }

    fn required(&mut self, name: &str) -> Result<String, Problem> {
        self.take(name).ok_or_else(|| self.problem(format_args!("the attribute `{name}` is missing")))
    }

    fn boolean(&mut self, name: &str) -> Result<Option<bool>, Problem> {
        match self.take(name).as_deref().map(str::trim) {
            None => Ok(None),
            Some("true" | "1") => Ok(Some(true)),
            Some("false" | "0") => Ok(Some(false)),
            Some(other) => Err(self.problem(format_args!("`{name}` is \"{other}\", it must be true or false"))),
        }
    }

    fn number<T: std::str::FromStr>(&mut self, name: &str) -> Result<Option<T>, Problem> {
        let Some(text) = self.take(name) else { return Ok(None) };
        text.trim()
            .parse()
            .map(Some)
            .map_err(|_| self.problem(format_args!("`{name}` is \"{text}\", which is no such number")))
    }
}

impl Parser {
    fn warn(&mut self, offset: usize, message: String) {
        if self.warnings.len() < WARNINGS {
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
        match (path, name) {
            ([], "fmiModelDescription") => {
                self.root(&mut a)?;
                self.leftovers(&a);
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
                self.d.default_experiment.start_time = a.number("startTime")?;
                self.d.default_experiment.stop_time = a.number("stopTime")?;
                self.d.default_experiment.step_size = a.number("stepSize")?;
                a.take("tolerance");
                self.leftovers(&a);
            }
            (
                ["fmiModelDescription"],
                "TypeDefinitions" | "UnitDefinitions" | "LogCategories" | "VendorAnnotations" | "ModelVariables"
                | "ModelStructure",
            ) => {}
            (["fmiModelDescription"], other) => self.warn(offset, format!("unknown element <{other}>")),
            ([_, "TypeDefinitions"], "SimpleType") => self.type_name = a.take("name"),
            ([_, "TypeDefinitions", "SimpleType"], "Real") => {
                let inherited = Inherited { unit: a.take("unit"), min: a.number("min")?, max: a.number("max")? };
                if let Some(name) = self.type_name.take() {
                    self.types.insert(name, inherited);
                }
            }
            ([_, "ModelVariables"], "ScalarVariable") => self.variable(&mut a)?,
            ([_, "ModelVariables", "ScalarVariable"], "Real" | "Integer" | "Boolean" | "String" | "Enumeration") => {
                self.variable_type(name, &mut a)?;
            }
            ([_, "ModelVariables"], other) => self.warn(offset, format!("unknown element <{other}>")),
            _ => {}
        }
        Ok(())
    }

    fn end(&mut self, path: &[&str]) {
        if let ([_, "ModelVariables"], Some((variable, offset))) = (path, self.pending.take_if(|_| path.len() == 2)) {
            let message = format!("variable `{}` has no type element and is left out", variable.name);
            self.warn(offset, message);
        }
    }

    fn root(&mut self, a: &mut Attributes) -> Result<(), Problem> {
        self.d.fmi_version = a.required("fmiVersion")?;
        // Other versions name other things differently: the caller says so before anything is missed.
        if self.d.fmi_version.starts_with("2.") {
            self.d.model_name = a.required("modelName")?;
            self.d.guid = a.required("guid")?;
        }
        self.d.generation_tool = a.take("generationTool");
        for known in [
            "description",
            "author",
            "version",
            "copyright",
            "license",
            "generationDateAndTime",
            "variableNamingConvention",
            "numberOfEventIndicators",
        ] {
            a.take(known);
        }
        if !self.d.fmi_version.starts_with("2.") {
            a.values.clear();
        }
        Ok(())
    }

    fn co_simulation(&mut self, a: &mut Attributes) -> Result<(), Problem> {
        let model_identifier = a.required("modelIdentifier")?;
        let letter = |c: char| c.is_ascii_alphabetic() || c == '_';
        let is_identifier =
            model_identifier.starts_with(letter) && model_identifier.chars().all(|c| letter(c) || c.is_ascii_digit());
        if !is_identifier {
            return Err(a.problem(format_args!(
                "modelIdentifier \"{}\" is not a C identifier and could name a file outside the FMU; refused",
                model_identifier.escape_debug()
            )));
        }
        let mut flag = |name: &str| Ok::<bool, Problem>(a.boolean(name)?.unwrap_or(false));
        let capabilities = Capabilities {
            can_get_and_set_state: flag("canGetAndSetFMUstate")?,
            can_serialize_state: flag("canSerializeFMUstate")?,
            can_handle_variable_step: flag("canHandleVariableCommunicationStepSize")?,
            once_per_process: flag("canBeInstantiatedOnlyOncePerProcess")?,
            needs_execution_tool: flag("needsExecutionTool")?,
            model_identifier,
        };
        for known in [
            "canInterpolateInputs",
            "maxOutputDerivativeOrder",
            "canRunAsynchronuously",
            "canNotUseMemoryManagementFunctions",
            "providesDirectionalDerivative",
        ] {
            a.take(known);
        }
        self.d.co_simulation = Some(CoSimulation { capabilities });
        Ok(())
    }

    fn variable(&mut self, a: &mut Attributes) -> Result<(), Problem> {
        let name = a.required("name")?;
        let value_reference = a
            .number("valueReference")?
            .ok_or_else(|| a.problem(format_args!("variable `{name}` has no valueReference")))?;
        let causality = match a.take("causality").as_deref() {
            None | Some("local") => Causality::Local,
            Some("parameter") => Causality::Parameter,
            Some("calculatedParameter") => Causality::CalculatedParameter,
            Some("input") => Causality::Input,
            Some("output") => Causality::Output,
            Some("independent") => Causality::Independent,
            Some(other) => return Err(a.problem(format_args!("causality \"{other}\" of `{name}` is unknown"))),
        };
        let variability = match a.take("variability").as_deref() {
            None | Some("continuous") => Variability::Continuous,
            Some("constant") => Variability::Constant,
            Some("fixed") => Variability::Fixed,
            Some("tunable") => Variability::Tunable,
            Some("discrete") => Variability::Discrete,
            Some(other) => return Err(a.problem(format_args!("variability \"{other}\" of `{name}` is unknown"))),
        };
        let description = a.take("description").unwrap_or_default();
        a.take("initial");
        a.take("canHandleMultipleSetPerTimeInstant");
        self.leftovers(a);
        let kind = VariableType::Real { unit: None, start: None, min: None, max: None };
        let line = self.lines.line(a.offset);
        let variable = Variable { name, value_reference, causality, variability, kind, description, line };
        self.pending = Some((variable, a.offset));
        Ok(())
    }

    fn variable_type(&mut self, name: &str, a: &mut Attributes) -> Result<(), Problem> {
        let Some((mut variable, _)) = self.pending.take() else { return Ok(()) };
        let declared = a.take("declaredType");
        variable.kind = match name {
            "Real" => {
                let mut inherited = Inherited::default();
                if let Some(declared) = declared {
                    match self.types.get(&declared) {
                        Some(found) => inherited.clone_from(found),
                        None => {
                            self.warn(a.offset, format!("`{}` is of the undefined type `{declared}`", variable.name))
                        }
                    }
                }
                let (start, min, max): (Option<f64>, Option<f64>, Option<f64>) =
                    (a.number("start")?, a.number("min")?, a.number("max")?);
                if start.is_some_and(|v| !v.is_finite()) {
                    self.warn(a.offset, format!("the start value of `{}` is not finite", variable.name));
                }
                VariableType::Real {
                    unit: a.take("unit").or(inherited.unit),
                    start,
                    min: min.or(inherited.min),
                    max: max.or(inherited.max),
                }
            }
            "Integer" => VariableType::Integer { start: a.number("start")? },
            "Boolean" => VariableType::Boolean { start: a.boolean("start")? },
            "Enumeration" => VariableType::Enumeration { start: a.number("start")? },
            _ => VariableType::String { start: a.take("start") },
        };
        self.d.variables.push(variable);
        Ok(())
    }

    /// The index by name; a name that stands twice is an error.
    fn index(&mut self) -> Result<(), Problem> {
        for (i, variable) in self.d.variables.iter().enumerate() {
            if let Some(first) = self.d.by_name.insert(variable.name.clone(), i) {
                let offset = self.lines.0.get(variable.line - 1).copied().unwrap_or(0);
                let other = self.d.variables[first].line;
                let message = format!("two variables are called `{}` (the other is in line {other})", variable.name);
                return Err(Problem { offset, message });
            }
        }
        Ok(())
    }
}

#[cfg(test)]
#[path = "read_xml_tests.rs"]
mod tests;
