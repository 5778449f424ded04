//! What comes behind the first hazard by contact of a sequence that a strategy tried: the strategy's episode is over with it, but the
//! robot may go on and clamp somebody, which is worse.
//!
//! The person stands where they were hit; and does something else that chance chooses. Both are sequences like all others. A search
//! of all sequences follows every one of them instead, see [`exhaustive`](crate::search::exhaustive).

use super::simulation::Simulation;
use crate::host::{Plant, PlantError};
use crate::human::Action;
use crate::search::{End, Environment as _, Rng};

impl<P: Plant> Simulation<P> {
    /// Goes on behind a hazard by contact until the horizon, in two ways, and comes back; does nothing if none came, or clamping does
    /// not count. What is met is there to be taken ([`Self::take_behind`]).
    ///
    /// # Errors
    /// When the FMU fails, or the search has to end.
    pub fn look_behind(&mut self, rng: &mut Rng) -> Result<(), PlantError> {
        let left = self.horizon().saturating_sub(self.taken().len());
        if !self.goes_on() || left == 0 {
            return Ok(());
        }
        let (here, actions) = (self.save(), self.actions());
        let chosen: Vec<usize> = (0..left).map(|_| rng.below(actions)).collect();
        self.go_on(std::iter::repeat_n(Action::REST, left))?;
        self.restore(&here)?;
        let repertoire = self.world.cell.repertoire.clone();
        self.go_on(chosen.into_iter().map(|action| repertoire.action(action)))?;
        self.restore(&here)
    }

    fn go_on(&mut self, actions: impl Iterator<Item = Action>) -> Result<(), PlantError> {
        for action in actions {
            if self.take(action)?.end != Some(End::Unsafe) {
                break;
            }
        }
        Ok(())
    }
}
