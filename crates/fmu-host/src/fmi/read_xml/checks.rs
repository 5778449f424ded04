//! Things in modelDescription.xml that are wrong, or at least odd, and do not keep the FMU from being used: warnings.

use std::collections::{BTreeMap, BTreeSet};

use super::super::variable::{Causality, VariableType};
use super::attributes::Attributes;
use super::{Parser, Problem};
use fmu_self_test::number;

impl Parser {
    /// The suggested experiment; what makes no sense is left out.
    pub(super) fn experiment(&mut self, a: &mut Attributes) -> Result<(), Problem> {
        let start: Option<f64> = a.number("startTime")?;
        let stop: Option<f64> = a.number("stopTime")?;
        let step: Option<f64> = a.number("stepSize")?;
        a.take("tolerance");
        let mut ignored = |message: String| {
            self.warn(a.offset, format!("{message}; ignored"));
        };
        let mut finite = |name: &str, value: Option<f64>| {
            if let Some(v) = value.filter(|v| !v.is_finite()) {
                ignored(format!("{name} is {v}, which is no time"));
            }
            value.filter(|v| v.is_finite())
        };
        let (start, mut stop, mut step) =
            (finite("startTime", start), finite("stopTime", stop), finite("stepSize", step));
        if let Some(end) = stop.filter(|end| *end < start.unwrap_or(0.0)) {
            ignored(format!("stopTime {} is before startTime {}", number(end), number(start.unwrap_or(0.0))));
            stop = None;
        }
        if let Some(h) = step.filter(|h| *h <= 0.0) {
            ignored(format!("stepSize {} is not greater than zero", number(h)));
            step = None;
        }
        if let (Some(h), Some(end)) = (step, stop)
            && h > end - start.unwrap_or(0.0)
        {
            ignored(format!("stepSize {} is longer than the experiment", number(h)));
            step = None;
        }
        let experiment = &mut self.d.default_experiment;
        (experiment.start_time, experiment.stop_time, experiment.step_size) = (start, stop, step);
        Ok(())
    }

    /// What a unit is in its base units. One that makes no sense keeps no FMU from being used whose variables in it nobody
    /// asks for, so it is kept as what it is.
    pub(super) fn base_unit(&mut self, a: &mut Attributes) {
        let Some(unit) = self.unit.take() else { return };
        let read = |text: Option<String>, or: f64| text.map_or(or, |text| text.trim().parse().unwrap_or(f64::NAN));
        let (factor, offset) = (read(a.take("factor"), 1.0), read(a.take("offset"), 0.0));
        let usable = factor.is_finite() && factor != 0.0 && offset.is_finite();
        if !usable {
            let message = format!(
                "unit `{unit}` has the factor {} and the offset {}: nothing can be converted with it",
                number(factor),
                number(offset)
            );
            self.warn(a.offset, message);
        }
        self.d.units.insert(unit, if offset.is_finite() { factor } else { f64::NAN });
    }

    /// Start values and limits of one variable.
    pub(super) fn check_limits(
        &mut self,
        offset: usize,
        name: &str,
        start: &[f64],
        min: Option<f64>,
        max: Option<f64>,
    ) {
        if start.iter().any(|v| !v.is_finite()) {
            self.warn(offset, format!("the start value of `{name}` is not finite"));
        }
        let (low, high) = (min.unwrap_or(f64::NEG_INFINITY), max.unwrap_or(f64::INFINITY));
        if low.is_nan() || high.is_nan() || low > high {
            self.warn(
                offset,
                format!("the limits of `{name}` make no sense: min {}, max {}", number(low), number(high)),
            );
        } else if let Some(v) = start.iter().find(|v| **v < low || **v > high) {
            let [v, low, high] = [*v, low, high].map(number);
            self.warn(offset, format!("the start value {v} of `{name}` is outside its limits, {low} to {high}"));
        }
    }

    /// What only shows when all variables are known.
    pub(super) fn look_for_oddities(&mut self) {
        let mut found: Vec<(usize, String)> = Vec::new();
        let mut undefined: BTreeSet<&str> = BTreeSet::new();
        let mut inputs = BTreeMap::new();
        for v in self.d.variables.iter().filter(|v| v.causality == Causality::Input) {
            inputs.insert((v.value_reference, v.scalar), v);
        }
        for v in &self.d.variables {
            let offset = self.lines.start(v.line);
            if let VariableType::Real { unit: Some(unit), .. } = &v.kind
                && !self.d.units.contains_key(unit)
                && undefined.insert(unit)
            {
                found.push((offset, format!("`{}` is in `{unit}`, a unit that the file does not define", v.name)));
            }
            if let Some(input) = inputs.get(&(v.value_reference, v.scalar)).filter(|_| v.causality == Causality::Output)
            {
                let message = format!(
                    "output `{}` and input `{}` are one variable (value reference {}): reading it gives what was \
                     written",
                    v.name, input.name, v.value_reference
                );
                found.push((offset, message));
            }
        }
        found.into_iter().for_each(|(offset, message)| self.warn(offset, message));
    }
}
