//! The system structure description (`.ssd`): components, connectors and connections of a flat system.

use std::collections::BTreeMap;
use std::ops::Range;

use roxmltree::Node;

use super::inside;
use super::parameters::{self, Named, Parameter};
use crate::cell::error::{Source, nearest};
use crate::cell::foreign::xml::{Result, Xml, child, children};
use crate::fmi::number;

/// A system.
#[derive(Clone, Debug, Default)]
pub struct Structure {
    /// Its name.
    pub name: String,
    /// Version of the format.
    pub version: String,
    /// The components.
    pub components: Vec<Component>,
    /// Connections between them.
    pub links: Vec<Link>,
    /// Inputs of the system, each with the components' variables that it drives.
    pub inputs: BTreeMap<String, Vec<(usize, String)>>,
    /// Outputs of the system, each with the component's variable that it is.
    pub outputs: BTreeMap<String, (usize, String)>,
    /// Parameters of the components.
    pub parameters: Vec<Parameter>,
    /// What was passed over and may matter.
    pub warnings: Vec<String>,
}

/// An FMU of the system.
#[derive(Clone, Debug)]
pub struct Component {
    /// Its name.
    pub name: String,
    /// The FMU, relative to the description.
    pub source: String,
    /// Where it is described.
    pub place: Range<usize>,
    /// Units of its connectors, where they are told.
    units: BTreeMap<String, String>,
}

/// An output that drives an input: `to = factor * from + offset`.
#[derive(Clone, Debug)]
pub struct Link {
    /// Component and variable.
    pub from: (usize, String),
    /// Component and variable.
    pub to: (usize, String),
    /// Factor.
    pub factor: f64,
    /// Offset.
    pub offset: f64,
    /// Units of the two ends that are still to be converted, where the system tells them.
    pub units: [Option<String>; 2],
    /// Whether units are to be converted at all.
    pub converts: bool,
    /// Where it stands.
    pub place: Range<usize>,
}

/// Elements of a system that would change what it does and are not read, each with what to do instead.
const REFUSED: [(&str, &str); 3] = [
    ("System", "put the components of the inner system into the outer one"),
    ("SignalDictionary", "connect the components directly"),
    ("SignalDictionaryReference", "connect the components directly"),
];

/// Reads a description.
pub(super) fn read(source: &Source) -> Result<Structure> {
    let xml = Xml { source };
    let document =
        xml.parse("a system structure description is an XML file, SystemStructure.ssd in an .ssp archive")?;
    let root = document.root_element();
    if !root.has_tag_name("SystemStructureDescription") {
        let help = "give an .ssp archive, or its SystemStructure.ssd";
        return Err(xml.wrong(root, "this is no system structure description", help));
    }
    let version = xml.text(root, "version")?;
    if !["1.0", "1.0.1", "2.0"].contains(&version) && !version.starts_with("2.0") {
        return Err(xml.wrong(root, format!("SSP {version} is not known"), "1.0 and 2.0 are"));
    }
    let Some(system) = child(root, "System") else {
        return Err(xml.wrong(root, "there is no <System>", "add it"));
    };
    let mut structure = Structure {
        name: system.attribute("name").unwrap_or_default().to_owned(),
        version: version.to_owned(),
        ..Structure::default()
    };
    let start = child(root, "DefaultExperiment").and_then(|node| node.attribute("startTime"));
    if start.is_some_and(|start| start.trim().parse::<f64>().is_ok_and(|start| start != 0.0)) {
        structure
            .warnings
            .push("the system's default experiment does not start at 0; it is run from 0 here".to_owned());
    }
    let own_units = units(xml, root)?;
    let mut named: Vec<(Option<usize>, Named)> = Vec::new();
    for element in child(system, "Elements").into_iter().flat_map(|elements| elements.children()) {
        let name = element.tag_name().name();
        if let Some((_, help)) = REFUSED.iter().find(|(refused, _)| *refused == name) {
            return Err(xml.wrong(element, format!("<{name}> inside a system is not supported"), *help));
        }
        if element.has_tag_name("Component") {
            named.extend(
                parameters::bound(xml, element)?.into_iter().map(|one| (Some(structure.components.len()), one)),
            );
            structure.components.push(component(xml, element, &structure.components)?);
        }
    }
    if structure.components.is_empty() {
        return Err(xml.wrong(system, "the system has no components", "add <Component> elements with FMUs"));
    }
    let system_units = connector_units(xml, system)?;
    for connection in child(system, "Connections").into_iter().flat_map(|all| children(all, "Connection")) {
        connect(xml, connection, &mut structure, &own_units, &system_units)?;
    }
    // What the system binds counts more than what its components do.
    named.extend(parameters::bound(xml, system)?.into_iter().map(|one| (None, one)));
    for (component, one) in named {
        structure.parameters.push(placed(component, one, &structure.components)?);
    }
    Ok(structure)
}

/// Whose parameter it is: a system's begins with the component's name.
fn placed(component: Option<usize>, one: Named, components: &[Component]) -> Result<Parameter> {
    let Named { name, value, unit, source, place } = one;
    let (component, name) = match component {
        Some(component) => (component, name),
        None => {
            let fits = components.iter().enumerate().filter_map(|(number, component)| {
                Some((number, name.strip_prefix(&component.name)?.strip_prefix('.')?.to_owned()))
            });
            // Of `a` and `a.b`, `a.b.k` is of the latter.
            let found = fits.min_by_key(|(_, rest)| rest.len());
            found.ok_or_else(|| {
                let message = format!("parameter `{name}` is of no component");
                let help = "a system's parameters are named component.variable".to_owned();
                source.error(place.clone(), "here", message, Some(help))
            })?
        }
    };
    Ok(Parameter { component, name, value, unit, source, place })
}

fn component(xml: Xml<'_>, node: Node<'_, '_>, before: &[Component]) -> Result<Component> {
    let name = xml.text(node, "name")?.to_owned();
    if name.contains(':') || before.iter().any(|other| other.name == name) {
        let message = format!("component `{name}` has a colon in its name, or the name of another");
        return Err(xml.wrong(node, message, "give each a name of its own, without a colon"));
    }
    let kind = node.attribute("type").unwrap_or("application/x-fmu-sharedlibrary");
    if kind != "application/x-fmu-sharedlibrary" {
        return Err(xml.wrong(node, format!("component `{name}` is of type `{kind}`"), "components have to be FMUs"));
    }
    if node.attribute("implementation") == Some("ModelExchange") {
        let help = "export it for co-simulation, and say implementation=\"CoSimulation\" or \"any\"";
        return Err(xml.wrong(node, format!("component `{name}` is for model exchange"), help));
    }
    let source = xml.text(node, "source")?;
    let source = inside(source).ok_or_else(|| {
        let message = format!("the FMU of component `{name}` is outside the system: {source}");
        xml.wrong(node, message, "put it into the archive, below resources/")
    })?;
    let units = connector_units(xml, node)?;
    Ok(Component { name, source: source.to_string_lossy().into_owned(), place: tag(xml, node), units })
}

fn tag(xml: Xml<'_>, node: Node<'_, '_>) -> Range<usize> {
    let range = node.range();
    let end = xml.source.text()[range.clone()].find('>').map_or(range.end, |end| range.start + end + 1);
    range.start..end
}

/// Units of the connectors of an element, after a look at what they are.
fn connector_units(xml: Xml<'_>, node: Node<'_, '_>) -> Result<BTreeMap<String, String>> {
    let mut units = BTreeMap::new();
    for connector in child(node, "Connectors").into_iter().flat_map(|all| children(all, "Connector")) {
        let name = xml.text(connector, "name")?;
        if let Some(dimension) = child(connector, "Dimension") {
            let help = "connect the elements of arrays one by one";
            return Err(xml.wrong(dimension, format!("connector `{name}` is an array"), help));
        }
        if let Some(kind) = ["Clock", "Binary"].into_iter().find_map(|kind| child(connector, kind)) {
            let message = format!("connector `{name}` is of type {}", kind.tag_name().name());
            return Err(xml.wrong(kind, message, "numbers, Booleans and enumerations are supported"));
        }
        let unit = connector.children().filter(Node::is_element).find_map(|kind| kind.attribute("unit"));
        units.extend(unit.map(|unit| (name.to_owned(), unit.to_owned())));
    }
    Ok(units)
}

/// Units of the description: factor and offset to their base units, and the exponents of those.
type Units = BTreeMap<String, (f64, f64, Vec<String>)>;

fn units(xml: Xml<'_>, root: Node<'_, '_>) -> Result<Units> {
    let mut all = Units::new();
    for unit in child(root, "Units").into_iter().flat_map(|units| children(units, "Unit")) {
        let name = xml.text(unit, "name")?.to_owned();
        let Some(base) = child(unit, "BaseUnit") else { continue };
        let [factor] = xml.numbers(base, "factor", [1.0])?;
        let [offset] = xml.numbers(base, "offset", [0.0])?;
        if factor == 0.0 {
            return Err(xml.wrong(base, format!("the factor of unit `{name}` is 0"), "a unit is some part of another"));
        }
        let exponents = base.attributes().filter(|a| !["factor", "offset"].contains(&a.name()) && a.value() != "0");
        let mut exponents: Vec<String> = exponents.map(|a| format!("{}{}", a.name(), a.value())).collect();
        exponents.sort();
        let _ = all.insert(name, (factor, offset, exponents));
    }
    Ok(all)
}

/// An end of a connection: a component's variable, or one of the system itself.
enum End {
    Component(usize, String),
    System(String),
}

fn end(xml: Xml<'_>, node: Node<'_, '_>, structure: &Structure, side: &str) -> Result<End> {
    let connector = xml.text(node, &format!("{side}Connector"))?.to_owned();
    let Some(element) = node.attribute(format!("{side}Element").as_str()).filter(|element| !element.is_empty()) else {
        return Ok(End::System(connector));
    };
    let names = || structure.components.iter().map(|component| component.name.as_str());
    match names().position(|name| name == element) {
        Some(component) => Ok(End::Component(component, connector)),
        None => {
            let help = nearest(element, names()).map_or_else(
                || format!("the components are {}", names().collect::<Vec<_>>().join(", ")),
                |near| format!("did you mean `{near}`?"),
            );
            Err(xml.wrong(node, format!("there is no component `{element}`"), help))
        }
    }
}

fn connect(
    xml: Xml<'_>,
    node: Node<'_, '_>,
    structure: &mut Structure,
    own: &Units,
    system: &BTreeMap<String, String>,
) -> Result<()> {
    for mapping in ["BooleanMappingTransformation", "IntegerMappingTransformation", "EnumerationMappingTransformation"]
    {
        if let Some(mapping) = child(node, mapping) {
            let name = mapping.tag_name().name().to_owned();
            return Err(xml.wrong(mapping, format!("<{name}> is not supported"), "linear transformations are"));
        }
    }
    let mut transformation = [1.0, 0.0];
    if let Some(linear) = child(node, "LinearTransformation") {
        let [factor] = xml.numbers(linear, "factor", [1.0])?;
        let [offset] = xml.numbers(linear, "offset", [0.0])?;
        transformation = [factor, offset];
    }
    let mut converts = node.attribute("suppressUnitConversion") != Some("true");
    let (from, to) = (end(xml, node, structure, "start")?, end(xml, node, structure, "end")?);
    let unit = |end: &End| match end {
        End::Component(component, name) => structure.components[*component].units.get(name).cloned(),
        End::System(name) => system.get(name).cloned(),
    };
    let mut units = [unit(&from), unit(&to)];
    if let ([Some(a), Some(b)], true) = (&units, converts) {
        // The description's own units; others are left to who knows the FMUs' units.
        if let (Some((fa, oa, ea)), Some((fb, ob, eb))) = (own.get(a), own.get(b)) {
            if ea != eb {
                return Err(xml.wrong(node, format!("`{a}` cannot be converted to `{b}`"), "connect like with like"));
            }
            // base = fa * from + oa = fb * to + ob, then the transformation.
            let (factor, offset) = (fa / fb, (oa - ob) / fb);
            if !factor.is_finite() || !offset.is_finite() {
                let message = format!("`{a}` to `{b}`: a factor of {} cannot be", number(factor));
                return Err(xml.wrong(node, message, "correct the factors of both in <Units>"));
            }
            transformation = [transformation[0] * factor, transformation[0] * offset + transformation[1]];
            units = [None, None];
            converts = false;
        }
    }
    let [factor, offset] = transformation;
    let plain = factor == 1.0 && offset == 0.0 && (units[0] == units[1] || units.iter().any(Option::is_none));
    let transformed = || {
        let help = "a system's own connectors are used as they are: transform between components, or name the \
                    component's variable in the cell file, with its unit";
        xml.wrong(node, "a connector of the system itself is transformed or converted", help)
    };
    match (from, to) {
        (End::Component(a, from), End::Component(b, to)) => structure.links.push(Link {
            from: (a, from),
            to: (b, to),
            factor,
            offset,
            units,
            converts,
            place: tag(xml, node),
        }),
        (End::System(_), End::Component(..)) | (End::Component(..), End::System(_)) if !plain => {
            return Err(transformed());
        }
        (End::System(name), End::Component(component, variable)) => {
            structure.inputs.entry(name).or_default().push((component, variable));
        }
        (End::Component(component, variable), End::System(name)) => {
            if structure.outputs.insert(name.clone(), (component, variable)).is_some() {
                return Err(xml.wrong(node, format!("output `{name}` of the system is driven twice"), "remove one"));
            }
        }
        (End::System(_), End::System(_)) => {
            return Err(xml.wrong(node, "the system is connected with itself", "remove this connection"));
        }
    }
    Ok(())
}
