//! What an FMU, or a system of FMUs, offers to a cell: variables by the names that cell files use, and guesses what they
//! are for.

use std::collections::BTreeSet;

use super::roles::{Guess, Role, guess, without_locals_beside};
use crate::cell::foreign::ssp::System;
use crate::fmi::{Causality, ModelDescription, Variable, VariableType, number};

/// The variables of an FMU or a system.
#[derive(Clone, Debug, Default)]
pub struct Interface<'a> {
    /// By name; those that connections inside a system drive are left out.
    pub variables: Vec<(String, &'a Variable)>,
    /// What some of them seem to be for.
    pub roles: Vec<Guess>,
    /// The step that is suggested, s: for a system the shortest of its FMUs.
    pub step_size: Option<f64>,
}

/// Whether a variable is `whole`, or an element of it.
fn is_of(variable: &str, whole: &str) -> bool {
    variable.strip_prefix(whole).is_some_and(|rest| rest.is_empty() || rest.starts_with('['))
}

impl<'a> Interface<'a> {
    /// That of an FMU.
    #[must_use]
    pub fn of_fmu(description: &'a ModelDescription) -> Self {
        Self {
            variables: description.variables.iter().map(|variable| (variable.name.clone(), variable)).collect(),
            roles: guess(description),
            step_size: description.default_experiment.step_size,
        }
    }

    /// That of a system: `component:variable`, and inputs of the system by their own names.
    #[must_use]
    pub fn of_system(system: &'a System) -> Self {
        let structure = &system.structure;
        let guesses: Vec<Vec<Guess>> = system.fmus.iter().map(|(_, fmu)| guess(fmu.description())).collect();
        let has_joints = |guesses: &&Vec<Guess>| guesses.iter().any(|g| matches!(g.role, Role::JointAngle { .. }));
        // Robots of different components may have joints of the same names.
        let several = guesses.iter().filter(has_joints).count() > 1;
        let mut all = Self::default();
        let mut told = BTreeSet::new();
        for (unit, ((component, fmu), guesses)) in system.fmus.iter().zip(guesses).enumerate() {
            let description = fmu.description();
            let name = |variable: &str| {
                let is = |end: &(usize, String)| end.0 == unit && is_of(variable, &end.1);
                let own = structure.inputs.iter().find(|(_, targets)| targets.iter().any(is));
                own.map_or_else(|| format!("{component}:{variable}"), |(name, _)| name.clone())
            };
            let driven =
                |variable: &str| structure.links.iter().any(|link| link.to.0 == unit && is_of(variable, &link.to.1));
            let free = |variable: &&Variable| variable.causality != Causality::Input || !driven(&variable.name);
            for variable in description.variables.iter().filter(free) {
                let name = name(&variable.name);
                // One input of the system may drive several variables.
                if told.insert(name.clone()) {
                    all.variables.push((name, variable));
                }
            }
            for mut guess in guesses.into_iter().filter(|guess| !driven(&guess.variable)) {
                guess.variable = name(&guess.variable);
                if let (Role::JointAngle { robot, .. } | Role::JointSpeed { robot, .. }, true) =
                    (&mut guess.role, several)
                {
                    *robot = format!("{component} {robot}").trim_end().to_owned();
                }
                if all.roles.iter().all(|known| known.variable != guess.variable) {
                    all.roles.push(guess);
                }
            }
            let shorter = [all.step_size, description.default_experiment.step_size];
            all.step_size = shorter.into_iter().flatten().reduce(f64::min);
        }
        without_locals_beside(&mut all.roles);
        all
    }

    /// The FMU's start value of a number, as cell files write it; 0 where it has none.
    #[must_use]
    pub(crate) fn start(&self, name: &str) -> String {
        let found = self.variables.iter().find(|(known, _)| is_of(name, known));
        let start = found.and_then(|(_, variable)| variable.numeric_start().first().copied());
        number(start.filter(|start| start.is_finite()).unwrap_or(0.0))
    }

    /// Whether a variable, or the array that it is an element of, is Boolean.
    #[must_use]
    pub(crate) fn is_boolean(&self, name: &str) -> bool {
        let found = self.variables.iter().find(|(known, _)| is_of(name, known));
        found.is_some_and(|(_, variable)| matches!(variable.kind, VariableType::Boolean { .. }))
    }
}
