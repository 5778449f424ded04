//! Where and when people begin, in a scan and in a hazard: the cell as its sequence is run in it, and runs of sequences of several hazards.

use std::ops::Deref;
use std::sync::Arc;

use super::hosting::StateChoice;
use super::prepare::{Prepared, initial_condition_record};
use super::prepare_error::PrepareError;
use super::replay;
use crate::cell::Workcell;
use crate::cell::workcell::InitialCondition;
use crate::host::{Hosted, PlantError};
use crate::human::{Body, Start};
use crate::record::begin::InitialConditionRecord;
use crate::record::hazard::Hazard;
use crate::sim::simulation::RecordedRun;
use crate::sim::{Simulation, World};

/// A cell with the beginning of a hazard.
pub(crate) enum AtInitialCondition<'a> {
    /// It begins where the scan did.
    Same(&'a Prepared),
    /// It has a beginning of its own.
    Own(Box<Prepared>),
}

impl Deref for AtInitialCondition<'_> {
    type Target = Prepared;

    fn deref(&self) -> &Prepared {
        match self {
            Self::Same(prepared) => prepared,
            Self::Own(prepared) => prepared,
        }
    }
}

impl Prepared {
    /// Where and when the person begins.
    #[must_use]
    pub(crate) fn begins(&self) -> InitialConditionRecord {
        initial_condition_record(&self.cell, self.cell.beginning).begin()
    }

    /// Where the person begins of a scan that recorded nothing of that: of the only beginning, at once.
    #[must_use]
    pub(crate) fn begins_at_once(&self) -> InitialConditionRecord {
        let at_once = self.cell.beginnings.iter().position(|beginning| beginning.lead_in_steps == 0);
        initial_condition_record(&self.cell, at_once.unwrap_or_default()).begin()
    }

    /// The sensors that see somebody who stands where people begin, by their names. Those inside the FMU are not asked.
    #[must_use]
    pub(crate) fn seen_at_start(&self) -> Vec<String> {
        let seen = World::new(Arc::clone(&self.cell), Arc::clone(&self.binding)).seen_at_start();
        let names = self.cell.sensors.iter().map(|sensor| sensor.name.clone());
        names.zip(seen).filter_map(|(name, seen)| seen.then_some(name)).collect()
    }

    /// The same cell with another start, so long after the FMU's own, for so many actions.
    ///
    /// # Errors
    /// When the person has no room there.
    pub fn standing(&self, start: Start, lead_in_steps: usize, actions: u32) -> Result<Self, PrepareError> {
        self.of_body(None, start, lead_in_steps, actions)
    }

    fn of_body(
        &self,
        body: Option<Body>,
        start: Start,
        lead_in_steps: usize,
        actions: u32,
    ) -> Result<Self, PrepareError> {
        let mut cell = Workcell::clone(&self.cell);
        cell.body = body.unwrap_or(cell.body);
        cell.beginnings = vec![InitialCondition { start, lead_in_steps }];
        cell.search.actions = actions;
        self.with(self.found.clone(), cell, self.text.clone(), 0)
    }

    /// The same cell from where and when a scan of another began, for so many actions at least; with the body that the person had
    /// then, if that is told.
    ///
    /// # Errors
    /// When the person has no room there.
    pub(crate) fn prepared_at(
        &self,
        begins: InitialConditionRecord,
        body: Option<Body>,
        actions: usize,
    ) -> Result<Self, PrepareError> {
        let [x, y] = begins.xy_m;
        let start = Start::new(x, y, begins.heading_deg);
        let actions = self.cell.search.actions.max(u32::try_from(actions).unwrap_or(u32::MAX));
        let lead_in_steps = replay::steps(self, begins.begins_s);
        self.of_body(body, start, lead_in_steps, actions)
    }

    /// The same with another body, if one is given, for runs that begin elsewhere than the cell says.
    #[must_use]
    pub(crate) fn with_body(mut self, body: Option<Body>) -> Self {
        if let Some(body) = body {
            self.cell = Arc::new(Workcell { body, ..Workcell::clone(&self.cell) });
        }
        self
    }

    /// The number of the cell's beginning that begins there and then, if it has one, from 0.
    #[must_use]
    pub(crate) fn initial_condition_at(&self, begins: InitialConditionRecord) -> Option<usize> {
        let is = |number: &usize| initial_condition_record(&self.cell, *number).begin().bits() == begins.bits();
        (0..self.cell.beginnings.len()).find(is)
    }

    /// The cell as the sequences of a hazard are run in it: from its own beginning, if it has one, and for as many actions as
    /// they take.
    ///
    /// # Errors
    /// When the person has no room at the beginning of its own.
    pub(crate) fn of_hazard(&self, hazard: &Hazard) -> Result<AtInitialCondition<'_>, PrepareError> {
        let Some(begins) = hazard.begins else { return Ok(AtInitialCondition::Same(self)) };
        let there = self.prepared_at(begins, None, hazard.actions.len().max(hazard.shortest.actions.len()))?;
        Ok(AtInitialCondition::Own(Box::new(there)))
    }
}

/// Runs of hazards' sequences with everything that there is to see, each from where and when it begins. Hazards that begin
/// where the scan did share a simulation.
pub(crate) struct Runs<'a> {
    prepared: &'a Prepared,
    state: StateChoice,
    shared: Option<Simulation<Hosted>>,
}

impl<'a> Runs<'a> {
    /// Ready to run these, with states brought back so.
    ///
    /// # Errors
    /// When an FMU cannot be started.
    pub(crate) fn new<'h>(
        prepared: &'a Prepared,
        state: StateChoice,
        hazards: impl IntoIterator<Item = &'h Hazard>,
    ) -> Result<Self, PlantError> {
        let share = hazards.into_iter().any(|hazard| hazard.begins.is_none());
        let shared = if share { Some(prepared.simulation(state, false)?) } else { None };
        Ok(Self { prepared, state, shared })
    }

    /// Runs the sequence of one, and keeps everything that there is to see.
    ///
    /// # Errors
    /// When an FMU fails, or the person has no room where it begins.
    pub(crate) fn watch(&mut self, hazard: &Hazard) -> Result<(AtInitialCondition<'a>, RecordedRun), PlantError> {
        let there = self.prepared.of_hazard(hazard).map_err(|error| PlantError::of(error.to_string().as_str()))?;
        let watched = match (&there, &mut self.shared) {
            (AtInitialCondition::Same(prepared), Some(shared)) => replay::watch(shared, prepared, hazard)?,
            _ => replay::watch(&mut there.simulation(self.state, false)?, &there, hazard)?,
        };
        Ok((there, watched))
    }
}
