//! Types and variables as FMI 2.0 writes them: a `ScalarVariable` with an element of its type inside.

use super::super::variable::{Scalar, Variability, Variable, VariableType};
use super::attributes::Attributes;
use super::{Inherited, Parser, Problem};

impl Parser {
    pub(super) fn start2(&mut self, path: &[&str], name: &str, a: &mut Attributes) -> Result<(), Problem> {
        match (path, name) {
            ([_, "TypeDefinitions"], "SimpleType") => self.type_name = a.take("name"),
            ([_, "TypeDefinitions", "SimpleType"], "Real") => {
                let inherited = Inherited { unit: a.take("unit"), min: a.number("min")?, max: a.number("max")? };
                if let Some(name) = self.type_name.take() {
                    self.types.insert(name, inherited);
                }
            }
            ([_, "ModelVariables"], "ScalarVariable") => self.variable2(a)?,
            ([_, "ModelVariables", "ScalarVariable"], "Real" | "Integer" | "Boolean" | "String" | "Enumeration") => {
                self.variable_type(name, a)?;
            }
            ([_, "ModelVariables"], other) => self.warn(a.offset, format!("unknown element <{other}>")),
            _ => {}
        }
        Ok(())
    }

    fn variable2(&mut self, a: &mut Attributes) -> Result<(), Problem> {
        let name = a.required("name")?;
        let value_reference = a.reference(&name)?;
        let causality = a.causality(&name)?;
        let variability = a.variability(&name)?.unwrap_or(Variability::Continuous);
        let description = a.take("description").unwrap_or_default();
        a.take("initial");
        a.take("canHandleMultipleSetPerTimeInstant");
        self.leftovers(a);
        let variable = Variable {
            name,
            value_reference,
            causality,
            variability,
            kind: VariableType::String { start: Vec::new() },
            scalar: Scalar::String,
            dimensions: Vec::new(),
            description,
            line: self.lines.line(a.offset),
        };
        self.pending = Some((variable, a.offset));
        Ok(())
    }

    fn variable_type(&mut self, name: &str, a: &mut Attributes) -> Result<(), Problem> {
        let Some((mut variable, _)) = self.pending.take() else { return Ok(()) };
        let whole = |a: &mut Attributes| -> Result<Vec<i128>, Problem> {
            Ok(a.number::<i32>("start")?.map(i128::from).into_iter().collect())
        };
        (variable.scalar, variable.kind) = match name {
            "Real" => {
                let inherited = self.inherited(a, &variable.name);
                let (start, min, max): (Option<f64>, Option<f64>, Option<f64>) =
                    (a.number("start")?, a.number("min")?, a.number("max")?);
                let (start, min, max): (Vec<f64>, _, _) =
                    (start.into_iter().collect(), min.or(inherited.min), max.or(inherited.max));
                self.check_limits(a.offset, &variable.name, &start, min, max);
                let kind = VariableType::Real { unit: a.take("unit").or(inherited.unit), start, min, max };
                (Scalar::Float64, kind)
            }
            "Integer" => {
                let start = whole(a)?;
                let numbers: Vec<f64> = start.iter().filter_map(|v| i32::try_from(*v).ok()).map(f64::from).collect();
                let (min, max) = (a.number::<i32>("min")?.map(f64::from), a.number::<i32>("max")?.map(f64::from));
                self.check_limits(a.offset, &variable.name, &numbers, min, max);
                (Scalar::Int32, VariableType::Integer { start })
            }
            "Boolean" => (Scalar::Boolean, VariableType::Boolean { start: a.boolean("start")?.into_iter().collect() }),
            "Enumeration" => (Scalar::Int32, VariableType::Enumeration { start: whole(a)? }),
            _ => (Scalar::String, VariableType::String { start: a.take("start").into_iter().collect() }),
        };
        self.d.variables.push(variable);
        Ok(())
    }
}
