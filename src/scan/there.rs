//! Where and when a hazard begins: the cell as its sequence is run in it, and runs of sequences of several hazards.

use std::ops::Deref;

use super::film;
use super::hosting::StateChoice;
use super::prepare::Prepared;
use super::prepare_error::PrepareError;
use crate::host::{Hosted, PlantError};
use crate::human::Start;
use crate::report::model::Hazard;
use crate::sim::Simulation;
use crate::sim::simulation::Watched;

/// A cell with the beginning of a hazard.
pub enum There<'a> {
    /// It begins where the scan did.
    Same(&'a Prepared),
    /// It has a beginning of its own.
    Own(Box<Prepared>),
}

impl Deref for There<'_> {
    type Target = Prepared;

    fn deref(&self) -> &Prepared {
        match self {
            Self::Same(prepared) => prepared,
            Self::Own(prepared) => prepared,
        }
    }
}

impl Prepared {
    /// The cell as the sequences of a hazard are run in it: from its own beginning, if it has one, and for as many actions as
    /// they take.
    ///
    /// # Errors
    /// When the person has no room at the beginning of its own.
    pub fn of_hazard(&self, hazard: &Hazard) -> Result<There<'_>, PrepareError> {
        let Some(begins) = &hazard.begins else { return Ok(There::Same(self)) };
        let [x, y] = begins.xy_m;
        let start = Start::new(x, y, begins.heading_deg);
        let longest = hazard.actions.len().max(hazard.shortest.actions.len());
        let actions = self.cell.search.actions.max(u32::try_from(longest).unwrap_or(u32::MAX));
        let there = self.standing(start, film::steps(self, begins.begins_s), actions)?;
        Ok(There::Own(Box::new(there)))
    }
}

/// Runs of hazards' sequences with everything that there is to see, each from where and when it begins. Hazards that begin
/// where the scan did share a simulation.
pub struct Runs<'a> {
    prepared: &'a Prepared,
    state: StateChoice,
    shared: Option<Simulation<Hosted>>,
}

impl<'a> Runs<'a> {
    /// Ready to run these, with states brought back so.
    ///
    /// # Errors
    /// When an FMU cannot be started.
    pub fn new<'h>(
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
    pub fn watch(&mut self, hazard: &Hazard) -> Result<(There<'a>, Watched), PlantError> {
        let there = self.prepared.of_hazard(hazard).map_err(|error| PlantError::of(error.to_string().as_str()))?;
        let watched = match (&there, &mut self.shared) {
            (There::Same(prepared), Some(shared)) => film::watch(shared, prepared, hazard)?,
            _ => film::watch(&mut there.simulation(self.state, false)?, &there, hazard)?,
        };
        Ok((there, watched))
    }
}
