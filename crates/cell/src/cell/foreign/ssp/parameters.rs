//! Parameters of a system: `ParameterBindings` with values inline or in `.ssv` files.

use std::ops::Range;

use roxmltree::Node;

use super::inside;
use crate::cell::error::Source;
use crate::cell::file::format::Literal;
use crate::cell::foreign::xml::{Result, Xml, child, children};

/// A parameter of a component's FMU.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Index of the component.
    pub component: usize,
    /// Name of the FMU's variable.
    pub name: String,
    /// Value.
    pub value: Literal,
    /// Its unit, if told.
    pub unit: Option<String>,
    /// The file that says so, and where in it.
    pub source: Source,
    /// The same.
    pub place: Range<usize>,
}

/// A name and a value, before it is known whose it is.
pub(super) struct Named {
    pub name: String,
    pub value: Literal,
    pub unit: Option<String>,
    pub source: Source,
    pub place: Range<usize>,
}

/// The parameters that the `ParameterBindings` of `node` bind, in order: later ones count.
pub(super) fn bound(xml: Xml<'_>, node: Node<'_, '_>) -> Result<Vec<Named>> {
    let mut all = Vec::new();
    let bindings = child(node, "ParameterBindings").into_iter().flat_map(|node| children(node, "ParameterBinding"));
    for binding in bindings {
        if let Some(mapping) = child(binding, "ParameterMapping") {
            return Err(xml.wrong(
                mapping,
                "parameter mappings are not supported",
                "name the parameters as the FMU does",
            ));
        }
        let kind = binding.attribute("type").unwrap_or("application/x-ssp-parameter-set");
        if kind != "application/x-ssp-parameter-set" {
            let message = format!("parameters of type `{kind}` are not supported");
            return Err(xml.wrong(binding, message, "use an SSP parameter set (.ssv)"));
        }
        let prefix = binding.attribute("prefix").unwrap_or_default();
        let set = child(binding, "ParameterValues").and_then(|values| child(values, "ParameterSet"));
        match (binding.attribute("source"), set) {
            (None, Some(set)) => all.extend(values(xml, set, prefix)?),
            (Some(path), None) => {
                let file = inside(path).map(|path| xml.source.folder().join(path));
                let text = file.and_then(|file| std::fs::read_to_string(file).ok()).ok_or_else(|| {
                    let help = "its path is relative to the system structure description, and stays in it";
                    xml.wrong(binding, format!("the parameter set {path} cannot be read"), help)
                })?;
                let source = Source::new(path, &text);
                let own = Xml { source: &source };
                let document = own.parse("it has to be an SSP parameter set")?;
                all.extend(values(own, document.root_element(), prefix)?);
            }
            _ => {
                let help = "give it one of `source` and <ParameterValues> with a <ParameterSet>";
                return Err(xml.wrong(binding, "this binding has no parameter set, or two", help));
            }
        }
    }
    Ok(all)
}

fn values(xml: Xml<'_>, set: Node<'_, '_>, prefix: &str) -> Result<Vec<Named>> {
    let parameters = child(set, "Parameters").into_iter().flat_map(|node| children(node, "Parameter"));
    parameters
        .map(|node| {
            let name = format!("{prefix}{}", xml.text(node, "name")?);
            let Some(value) = node.children().find(Node::is_element) else {
                return Err(xml.wrong(
                    node,
                    format!("parameter `{name}` has no value"),
                    "add <ssv:Real value=\"...\"/>",
                ));
            };
            let kind = value.tag_name().name().to_owned();
            let text = xml.text(value, "value")?;
            let number = || text.trim().parse::<f64>().ok().filter(|v| v.is_finite()).map(Literal::Number);
            let literal = match kind.as_str() {
                "Boolean" => match text.trim() {
                    "true" | "1" => Some(Literal::Bool(true)),
                    "false" | "0" => Some(Literal::Bool(false)),
                    _ => None,
                },
                "Real" | "Integer" => number(),
                other if other.starts_with("Float") || other.starts_with("Int") || other.starts_with("UInt") => {
                    number()
                }
                other => {
                    let help = "numbers and Booleans are";
                    return Err(xml.wrong(value, format!("parameters of type {other} are not supported"), help));
                }
            };
            let unit = value.attribute("unit").map(str::to_owned);
            let value = literal.ok_or_else(|| {
                xml.wrong(value, format!("`{text}` is no {kind} value"), "write one number, or true or false")
            })?;
            Ok(Named { name, value, unit, source: xml.source.clone(), place: node.range() })
        })
        .collect()
}
