//! The way back to a state: restored, or by the same inputs again, and again with a fresh process where one was lost.

use std::sync::Arc;

use super::{Arrival, Node, NodeId, Recall, digest, same_bits, values_of};
use crate::host::plant::{Plant, PlantError, Then, Unlike};

/// Restores and saves in a row that may end the process before saved states are given up.
const RESTORES_LOST: u32 = 3;

impl<P: Plant> Recall<P> {
    /// Brings the plant to `node`, steps it, and takes stock of the state it reaches if that is `new`. When the process
    /// of the FMU is gone this is done again with a fresh one: whether the FMU or something else ended it shows in
    /// whether it happens again.
    pub(super) fn step_from(
        &mut self,
        node: NodeId,
        edge: &Arc<[u64]>,
        steps: usize,
        inputs: &[f64],
        new: bool,
    ) -> Result<(Vec<f64>, Arrival<P::Checkpoint>), PlantError> {
        let (mut tries, mut stocktakings) = (0, 0);
        loop {
            // What went well before must go well again.
            if let Err(error) = self.go(node, true) {
                tries += 1;
                if error.lost && tries < error.tries() {
                    continue;
                }
                let message = format!("what the FMU did before cannot be repeated: {}", error.message);
                return Err(PlantError { message, fatal: true, ..error });
            }
            self.at = None;
            self.steps_made += steps as u64;
            let depth = self.nodes[node.0].depth + 1;
            let then = if new { self.wanted(depth) } else { Then::Nothing };
            let (outputs, taken) = match self.plant.advance_and(steps, inputs, then) {
                Ok(stepped) => stepped,
                Err(error) if error.restoring => continue,
                Err(error) if error.lost && tries + 1 < error.tries() => {
                    tries += 1;
                    continue;
                }
                Err(error) => return Err(error),
            };
            if !new {
                return Ok((outputs, Arrival::default()));
            }
            match taken.and_then(|taken| self.arrive(depth, edge, taken)) {
                Ok(arrival) => return Ok((outputs, arrival)),
                Err(error) if error.fatal => return Err(error),
                // The action itself went well: what cannot be saved is reached by replay.
                Err(error) => {
                    stocktakings += 1;
                    if !error.lost || stocktakings >= error.tries() {
                        self.give_up_states();
                        self.known = None;
                    }
                }
            }
        }
    }

    /// From now on states are reached by replay.
    fn give_up_states(&mut self) {
        self.nodes.iter_mut().for_each(|n| n.checkpoint = None);
        self.checkpoints = usize::MAX;
    }

    /// Brings the plant to `node`.
    pub(super) fn go_to(&mut self, node: NodeId) -> Result<(), PlantError> {
        self.go(node, false)
    }

    /// The same; where it is to step on at once, restoring may be put off until then.
    fn go(&mut self, node: NodeId, to_step: bool) -> Result<(), PlantError> {
        let node = self.nodes[node.0].same;
        if self.at == Some(node) {
            return Ok(());
        }
        // The path back to the nearest saved state, or to the start.
        let mut path = Vec::with_capacity(self.nodes[node.0].depth);
        let mut from = node;
        while !self.holds(from) && from != NodeId::ROOT {
            path.push(from);
            from = self.nodes[self.nodes[from.0].parent.0].same;
        }
        self.at = None;
        let restored = match &self.nodes[from.0].checkpoint {
            Some(checkpoint) if self.plant.holds(checkpoint) => match to_step && path.is_empty() {
                true => self.plant.restore_soon(checkpoint).map(|()| true),
                false => self.plant.restore(checkpoint).map(|()| true),
            },
            _ => Ok(false),
        };
        match &restored {
            Ok(done) => self.restores_lost *= u32::from(!done),
            Err(error) if error.fatal => {}
            Err(error) => {
                self.restores_lost += 1;
                if !error.lost || self.restores_lost >= RESTORES_LOST {
                    // Who refuses to come back (after an error, say) is given up with all saved states.
                    self.give_up_states();
                }
                return self.go_to(node);
            }
        }
        if restored? {
            self.restores += 1;
        } else {
            let outputs = self.plant.restart()?;
            self.restarts += 1;
            if !same_bits(&self.nodes[from.0].outputs, &outputs) {
                return Err(not_repeatable(Some(0.0)));
            }
            self.save_again(from)?;
        }
        for step in path.into_iter().rev() {
            let Node { edge, digest: known, .. } = &self.nodes[step.0];
            let (steps, inputs) = values_of(edge);
            let again = self.plant.advance(steps, &inputs)?;
            self.steps_made += steps as u64;
            // Traces of long ago may have been forgotten, but not this.
            if known.is_some_and(|known| known != digest(&again)) {
                return Err(not_repeatable(None));
            }
            self.save_again(step)?;
        }
        self.at = Some(node);
        Ok(())
    }

    /// Whether `node` has a saved state that can be restored.
    fn holds(&self, node: NodeId) -> bool {
        self.nodes[node.0].checkpoint.as_ref().is_some_and(|checkpoint| self.plant.holds(checkpoint))
    }

    /// Saves the present state for `node`, which is in it, if its saved state was lost with a process.
    fn save_again(&mut self, node: NodeId) -> Result<(), PlantError> {
        if self.nodes[node.0].checkpoint.is_some() && !self.holds(node) {
            match self.plant.save() {
                Ok(saved) => {
                    self.nodes[node.0].checkpoint = Some(saved);
                    self.restores_lost = 0;
                }
                Err(error) if error.fatal => return Err(error),
                Err(error) => {
                    self.restores_lost += 1;
                    if !error.lost || error.ended_by_us || self.restores_lost >= RESTORES_LOST {
                        self.give_up_states();
                    }
                    // Who failed to save may be in any state.
                    return Err(PlantError { lost: true, ..error });
                }
            }
        }
        Ok(())
    }
}

pub(super) fn not_repeatable(time_s: Option<f64>) -> PlantError {
    let error = PlantError::of(
        "the FMU gave different outputs for the same inputs: its results depend on something else, so \
                  findings could not be replayed",
    )
    .unlike(Unlike::State)
    .fatal();
    PlantError { time_s, ..error }
}
