//! The attributes of one XML element, with the errors that wrong ones deserve.

use std::collections::BTreeMap;
use std::fmt;

use quick_xml::XmlVersion;
use quick_xml::events::BytesStart;

use super::super::variable::{Causality, Variability};
use super::Problem;

/// The attributes of one element, taken out one by one; what is left is unknown.
pub(super) struct Attributes {
    pub(super) element: String,
    pub(super) offset: usize,
    pub(super) values: BTreeMap<String, String>,
}

impl Attributes {
    pub(super) fn new(element: &BytesStart<'_>, name: &str, offset: usize) -> Result<Self, Problem> {
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

    pub(super) fn take(&mut self, name: &str) -> Option<String> {
        self.values.remove(name)
    }

    pub(super) fn problem(&self, message: impl fmt::Display) -> Problem {
        Problem { offset: self.offset, message: format!("in <{}>: {message}", self.element) }
    }

    pub(super) fn required(&mut self, name: &str) -> Result<String, Problem> {
        self.take(name).ok_or_else(|| self.problem(format_args!("the attribute `{name}` is missing")))
    }

    pub(super) fn boolean(&mut self, name: &str) -> Result<Option<bool>, Problem> {
        self.take(name).map(|text| self.truth(name, &text)).transpose()
    }

    pub(super) fn number<T: std::str::FromStr>(&mut self, name: &str) -> Result<Option<T>, Problem> {
        let Some(text) = self.take(name) else { return Ok(None) };
        text.trim()
            .parse()
            .map(Some)
            .map_err(|_| self.problem(format_args!("`{name}` is \"{text}\", which is no such number")))
    }

    /// A whole number within `range`.
    pub(super) fn whole(&self, name: &str, text: &str, range: (i128, i128)) -> Result<i128, Problem> {
        let value = text.parse::<i128>().ok().filter(|v| (range.0..=range.1).contains(v));
        value.ok_or_else(|| {
            self.problem(format_args!(
                "`{name}` is \"{text}\", it must be a whole number from {} to {}",
                range.0, range.1
            ))
        })
    }

    /// The words of an attribute, each made a value by `parse`; none if it is missing.
    pub(super) fn list<T>(
        &mut self,
        name: &str,
        parse: impl Fn(&Self, &str) -> Result<T, Problem>,
    ) -> Result<Vec<T>, Problem> {
        let Some(text) = self.take(name) else { return Ok(Vec::new()) };
        text.split_whitespace().map(|word| parse(self, word)).collect()
    }

    /// `true` or `false`.
    pub(super) fn truth(&self, name: &str, text: &str) -> Result<bool, Problem> {
        match text.trim() {
            "true" | "1" => Ok(true),
            "false" | "0" => Ok(false),
            other => Err(self.problem(format_args!("`{name}` is \"{other}\", it must be true or false"))),
        }
    }

    /// A number.
    pub(super) fn real(&self, name: &str, text: &str) -> Result<f64, Problem> {
        text.trim().parse().map_err(|_| self.problem(format_args!("`{name}` is \"{text}\", which is no such number")))
    }

    /// The value reference of variable `name`.
    pub(super) fn reference(&mut self, name: &str) -> Result<u32, Problem> {
        self.number("valueReference")?
            .ok_or_else(|| self.problem(format_args!("variable `{name}` has no valueReference")))
    }

    /// The causality of variable `name`; structural parameters are of FMI 3.0.
    pub(super) fn causality(&mut self, name: &str) -> Result<Causality, Problem> {
        Ok(match self.take("causality").as_deref() {
            None | Some("local") => Causality::Local,
            Some("parameter") => Causality::Parameter,
            Some("structuralParameter") => Causality::StructuralParameter,
            Some("calculatedParameter") => Causality::CalculatedParameter,
            Some("input") => Causality::Input,
            Some("output") => Causality::Output,
            Some("independent") => Causality::Independent,
            Some(other) => return Err(self.problem(format_args!("causality \"{other}\" of `{name}` is unknown"))),
        })
    }

    /// The variability of variable `name`, if it is given.
    pub(super) fn variability(&mut self, name: &str) -> Result<Option<Variability>, Problem> {
        Ok(match self.take("variability").as_deref() {
            None => None,
            Some("continuous") => Some(Variability::Continuous),
            Some("constant") => Some(Variability::Constant),
            Some("fixed") => Some(Variability::Fixed),
            Some("tunable") => Some(Variability::Tunable),
            Some("discrete") => Some(Variability::Discrete),
            Some(other) => return Err(self.problem(format_args!("variability \"{other}\" of `{name}` is unknown"))),
        })
    }
}
