//! Types and variables as FMI 3.0 writes them: one element for each variable, named after its type, with dimensions,
//! start values of texts, and other names inside.

use super::super::variable::{Causality, Dimension, Scalar, Variability, Variable, VariableType};
use super::attributes::Attributes;
use super::{Inherited, Parser, Problem};

/// Attributes that are known and do not matter here.
const KNOWN: [&str; 25] = [
    "initial",
    "canHandleMultipleSetPerTimeInstant",
    "intermediateUpdate",
    "previous",
    "clocks",
    "quantity",
    "displayUnit",
    "relativeQuantity",
    "unbounded",
    "min",
    "max",
    "nominal",
    "derivative",
    "reinit",
    "mimeType",
    "maxSize",
    "canBeDeactivated",
    "priority",
    "intervalVariability",
    "intervalDecimal",
    "shiftDecimal",
    "supportsFraction",
    "resolution",
    "intervalCounter",
    "shiftCounter",
];

/// A variable that is being read.
pub(super) struct Pending {
    variable: Variable,
    offset: usize,
    /// Name, description and line of the variable's other names.
    aliases: Vec<(String, String, usize)>,
}

impl Pending {
    /// The variable under all its names.
    ///
    /// # Errors
    /// When start values times names are more than anybody means: each name has its own copy.
    pub(super) fn variables(self) -> Result<Vec<Variable>, String> {
        let (starts, names) = (self.variable.kind.starts(), self.aliases.len() + 1);
        if starts.saturating_mul(names) > MOST_STARTS && names > 1 {
            let name = &self.variable.name;
            return Err(format!("`{name}` has {starts} start values under {names} names, which is refused"));
        }
        let mut variables = vec![self.variable];
        for (name, description, line) in self.aliases {
            let original = variables[0].clone();
            variables.push(Variable { name, description, line, ..original });
        }
        Ok(variables)
    }

    /// Where the variable stands.
    pub(super) const fn offset(&self) -> usize {
        self.offset
    }
}

/// Most start values of a variable with all its other names.
const MOST_STARTS: usize = 10_000_000;

fn scalar(element: &str) -> Option<Scalar> {
    Some(match element {
        "Float64" => Scalar::Float64,
        "Float32" => Scalar::Float32,
        "Int8" => Scalar::Int8,
        "UInt8" => Scalar::UInt8,
        "Int16" => Scalar::Int16,
        "UInt16" => Scalar::UInt16,
        "Int32" => Scalar::Int32,
        "UInt32" => Scalar::UInt32,
        "Int64" | "Enumeration" => Scalar::Int64,
        "UInt64" => Scalar::UInt64,
        "Boolean" => Scalar::Boolean,
        "String" => Scalar::String,
        "Binary" => Scalar::Binary,
        "Clock" => Scalar::Clock,
        _ => return None,
    })
}

impl Parser {
    pub(super) fn start3(&mut self, path: &[&str], name: &str, a: &mut Attributes) -> Result<(), Problem> {
        match (path, name) {
            ([_, "TypeDefinitions"], _) => {
                let Some(type_name) = a.take("name") else { return Ok(()) };
                let mut inherited = Inherited { unit: a.take("unit"), ..Inherited::default() };
                if matches!(name, "Float64Type" | "Float32Type") {
                    (inherited.min, inherited.max) = (a.number("min")?, a.number("max")?);
                }
                self.types.insert(type_name, inherited);
            }
            ([_, "ModelVariables"], _) => match scalar(name) {
                Some(scalar) => self.variable3(name, scalar, a)?,
                None => self.warn(a.offset, format!("unknown element <{name}>")),
            },
            ([_, "ModelVariables", variable], "Dimension" | "Start" | "Alias" | "Annotations") => {
                self.part(variable, name, a)?;
            }
            ([_, "ModelVariables", _], other) => self.warn(a.offset, format!("unknown element <{other}>")),
            _ => {}
        }
        Ok(())
    }

    fn variable3(&mut self, element: &str, scalar: Scalar, a: &mut Attributes) -> Result<(), Problem> {
        let name = a.required("name")?;
        let value_reference = a.reference(&name)?;
        let line = self.lines.line(a.offset);
        if let Some((other, line)) = self.references.insert(value_reference, (name.clone(), line)) {
            return Err(a.problem(format_args!(
                "`{name}` has the value reference {value_reference} of `{other}` (line {line}), in FMI 3.0 each variable \
                 has its own"
            )));
        }
        let causality = a.causality(&name)?;
        let float = matches!(scalar, Scalar::Float64 | Scalar::Float32);
        let variability = a.variability(&name)?.unwrap_or(match causality {
            Causality::Parameter | Causality::CalculatedParameter | Causality::StructuralParameter => {
                Variability::Tunable
            }
            _ if float => Variability::Continuous,
            _ => Variability::Discrete,
        });
        let description = a.take("description").unwrap_or_default();
        let inherited = self.inherited(a, &name);
        let kind = match scalar {
            Scalar::Float64 | Scalar::Float32 => {
                let (min, max) = (a.number("min")?.or(inherited.min), a.number("max")?.or(inherited.max));
                let start = a.list("start", |a, word| a.real("start", word))?;
                self.check_limits(a.offset, &name, &start, min, max);
                VariableType::Real { unit: a.take("unit").or(inherited.unit), start, min, max }
            }
            Scalar::Boolean => VariableType::Boolean { start: a.list("start", |a, word| a.truth("start", word))? },
            Scalar::String => VariableType::String { start: Vec::new() },
            Scalar::Binary => VariableType::Binary { start: Vec::new() },
            Scalar::Clock => VariableType::Clock,
            _ => {
                let range = scalar.range().unwrap_or_default();
                let start = a.list("start", |a, word| a.whole("start", word, range))?;
                if element == "Enumeration" {
                    VariableType::Enumeration { start }
                } else {
                    VariableType::Integer { start }
                }
            }
        };
        for known in KNOWN {
            a.take(known);
        }
        self.leftovers(a);
        let dimensions = Vec::new();
        let variable =
            Variable { name, value_reference, causality, variability, kind, scalar, dimensions, description, line };
        self.array = Some(Pending { variable, offset: a.offset, aliases: Vec::new() });
        Ok(())
    }

    /// An element inside a variable.
    fn part(&mut self, element: &str, name: &str, a: &mut Attributes) -> Result<(), Problem> {
        let line = self.lines.line(a.offset);
        let Some(pending) = &mut self.array else { return Ok(()) };
        match name {
            "Dimension" => {
                let dimension = match (a.number("start")?, a.number("valueReference")?) {
                    (Some(extent), None) => Dimension::Fixed(extent),
                    (None, Some(reference)) => Dimension::Parameter(reference),
                    _ => {
                        let name = &pending.variable.name;
                        return Err(
                            a.problem(format_args!("a dimension of `{name}` needs either start or valueReference"))
                        );
                    }
                };
                pending.variable.dimensions.push(dimension);
            }
            "Start" => match &mut pending.variable.kind {
                VariableType::String { start } => start.push(a.required("value")?),
                VariableType::Binary { start } => {
                    let text = a.required("value")?;
                    let bytes = bytes(&text).ok_or_else(|| {
                        a.problem(format_args!(
                            "`value` is \"{text}\", it must be bytes as two hexadecimal digits each"
                        ))
                    })?;
                    start.push(bytes);
                }
                _ => {
                    let message = format!("unknown element <Start> in <{element}>, whose start is an attribute");
                    self.warn(a.offset, message);
                    return Ok(());
                }
            },
            "Alias" => {
                let alias = a.required("name")?;
                let description = a.take("description").unwrap_or_default();
                a.take("displayUnit");
                pending.aliases.push((alias, description, line));
            }
            _ => return Ok(()),
        }
        self.leftovers(a);
        Ok(())
    }
}

/// Bytes written as hexadecimal digits.
fn bytes(text: &str) -> Option<Vec<u8>> {
    let digits: Vec<u32> =
        text.split_whitespace().flat_map(str::chars).map(|c| c.to_digit(16)).collect::<Option<_>>()?;
    if !digits.len().is_multiple_of(2) {
        return None;
    }
    digits.chunks(2).map(|pair| u8::try_from(pair[0] * 16 + pair[1]).ok()).collect()
}
