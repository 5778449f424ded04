//! FMUs in this process or in a worker, as one [`Plant`].

use super::isolation::{self, Isolated};
use super::plant::{Arrived, Fingerprint, Leg, LegStart, Plant, PlantError, Reads, Stepped, Then};
use super::recall::{FmuUsage, Recall};
use super::system::{self, System};
use crate::stop::Stop;

/// FMUs, wherever they run.
pub enum Hosted {
    /// In this process.
    Here(System),
    /// In a process of their own.
    Apart(Isolated),
}

/// A saved state of a [`Hosted`].
pub enum Checkpoint {
    /// In this process.
    Here(system::Checkpoint),
    /// In a process of their own.
    Apart(isolation::Checkpoint),
}

impl Hosted {
    /// Worker processes that had to be replaced so far.
    #[must_use]
    pub(crate) const fn replaced(&self) -> u64 {
        match self {
            Self::Here(_) => 0,
            Self::Apart(plant) => plant.replaced(),
        }
    }
}

/// What the FMUs behind a tree of states did.
impl Recall<Hosted> {
    /// With the workers that had to be replaced.
    #[must_use]
    pub const fn effort_of_workers(&self) -> FmuUsage {
        FmuUsage { workers_replaced: self.plant().replaced(), ..self.effort() }
    }
}

/// The same of saved states of one kind.
fn legs_of<'a, C>(
    legs: &'a [Leg<'_, Checkpoint>],
    of: impl Fn(&'a Checkpoint) -> Option<&'a C>,
) -> Result<Vec<Leg<'a, C>>, PlantError> {
    let one = |leg: &'a Leg<'_, Checkpoint>| {
        let from = match leg.from {
            LegStart::At(saved) => LegStart::At(of(saved).ok_or_else(|| PlantError::of("a state of another plant"))?),
            LegStart::After(number) => LegStart::After(number),
        };
        Ok(Leg { from, steps: leg.steps, inputs: leg.inputs.clone(), reads: leg.reads })
    };
    legs.iter().map(one).collect()
}

impl Plant for Hosted {
    type Checkpoint = Checkpoint;

    fn input_count(&self) -> usize {
        match self {
            Self::Here(plant) => plant.input_count(),
            Self::Apart(plant) => plant.input_count(),
        }
    }

    fn output_count(&self) -> usize {
        match self {
            Self::Here(plant) => plant.output_count(),
            Self::Apart(plant) => plant.output_count(),
        }
    }

    fn restart(&mut self) -> Result<Vec<f64>, PlantError> {
        match self {
            Self::Here(plant) => plant.restart(),
            Self::Apart(plant) => plant.restart(),
        }
    }

    fn advance(&mut self, steps: usize, inputs: &[f64]) -> Result<Vec<f64>, PlantError> {
        match self {
            Self::Here(plant) => plant.advance(steps, inputs),
            Self::Apart(plant) => plant.advance(steps, inputs),
        }
    }

    fn advance_and(&mut self, steps: usize, inputs: &[f64], then: Then) -> Result<Stepped<Checkpoint>, PlantError> {
        Ok(match self {
            Self::Here(plant) => {
                let (outputs, taken) = plant.advance_and(steps, inputs, then)?;
                (outputs, taken.map(|taken| taken.map(Checkpoint::Here)))
            }
            Self::Apart(plant) => {
                let (outputs, taken) = plant.advance_and(steps, inputs, then)?;
                (outputs, taken.map(|taken| taken.map(Checkpoint::Apart)))
            }
        })
    }

    fn advance_reading(&mut self, steps: usize, inputs: &[f64], reads: Reads) -> Result<Vec<f64>, PlantError> {
        match self {
            Self::Here(plant) => plant.advance_reading(steps, inputs, reads),
            Self::Apart(plant) => plant.advance_reading(steps, inputs, reads),
        }
    }

    fn advance_each(&mut self, legs: &[Leg<'_, Checkpoint>]) -> Result<Vec<Arrived<Checkpoint>>, PlantError> {
        match self {
            Self::Here(plant) => {
                let legs = legs_of(legs, |saved| match saved {
                    Checkpoint::Here(saved) => Some(saved),
                    Checkpoint::Apart(_) => None,
                })?;
                let all = plant.advance_each(&legs)?.into_iter();
                Ok(all.map(|(outputs, saved)| (outputs, Checkpoint::Here(saved))).collect())
            }
            Self::Apart(plant) => {
                let legs = legs_of(legs, |saved| match saved {
                    Checkpoint::Apart(saved) => Some(saved),
                    Checkpoint::Here(_) => None,
                })?;
                let all = plant.advance_each(&legs)?.into_iter();
                Ok(all.map(|(outputs, saved)| (outputs, Checkpoint::Apart(saved))).collect())
            }
        }
    }

    fn save(&mut self) -> Result<Checkpoint, PlantError> {
        match self {
            Self::Here(plant) => plant.save().map(Checkpoint::Here),
            Self::Apart(plant) => plant.save().map(Checkpoint::Apart),
        }
    }

    fn fingerprint(&mut self) -> Result<Option<Fingerprint>, PlantError> {
        match self {
            Self::Here(plant) => plant.fingerprint(),
            Self::Apart(plant) => plant.fingerprint(),
        }
    }

    fn restore(&mut self, checkpoint: &Checkpoint) -> Result<(), PlantError> {
        match (self, checkpoint) {
            (Self::Here(plant), Checkpoint::Here(saved)) => plant.restore(saved),
            (Self::Apart(plant), Checkpoint::Apart(saved)) => plant.restore(saved),
            _ => Err(PlantError::of("this saved state belongs to another plant")),
        }
    }

    fn restore_soon(&mut self, checkpoint: &Checkpoint) -> Result<(), PlantError> {
        match (self, checkpoint) {
            (Self::Apart(plant), Checkpoint::Apart(saved)) => plant.restore_soon(saved),
            (plant, saved) => plant.restore(saved),
        }
    }

    fn holds(&self, checkpoint: &Checkpoint) -> bool {
        match (self, checkpoint) {
            (Self::Here(plant), Checkpoint::Here(saved)) => plant.holds(saved),
            (Self::Apart(plant), Checkpoint::Apart(saved)) => plant.holds(saved),
            _ => false,
        }
    }

    fn stop(&self) -> Stop {
        match self {
            Self::Here(plant) => plant.stop(),
            Self::Apart(plant) => plant.stop(),
        }
    }
}
