//! Bringing states back: a tree of FMU states by input history, and the ladder of ways to reach one again.
//!
//! A deterministic FMU's state is a function of the inputs it received, so a node of this tree *is* a state. How a
//! node is reached again is decided here, not by the search: from a saved FMU state, or by a fresh instance that is
//! given the same inputs once more. The outputs are the same either way, only the speed differs; with
//! [`Policy::Replay`] every repetition is compared with what was recorded, and a difference is an error.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::plant::{Plant, PlantError};

/// A state of the FMU, named by its input history. Valid for the [`Recall`] that made it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct NodeId(usize);

impl NodeId {
    /// The state after initialisation.
    pub const ROOT: Self = Self(0);
}

/// How states are brought back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Policy {
    /// Saved FMU states; a transition that was stepped once is remembered and not stepped again.
    States {
        /// At most this many saved states at a time; beyond it, states are reached by replay from the nearest one.
        max_checkpoints: usize,
    },
    /// No saved states and no memory: every sequence starts from a fresh instance and is stepped from the beginning.
    Replay,
}

struct Node<C> {
    parent: NodeId,
    depth: usize,
    steps: usize,
    /// Inputs of the edge from the parent, row-major.
    inputs: Vec<f64>,
    /// Outputs after each step of that edge, row-major; for the root, the outputs after initialisation.
    outputs: Arc<[f64]>,
    checkpoint: Option<C>,
    children: BTreeMap<Vec<u64>, Result<NodeId, Arc<PlantError>>>,
}

/// What an action did.
#[derive(Clone, Debug)]
pub enum Advanced {
    /// The FMU reached this state.
    To(NodeId),
    /// The FMU could not finish the action.
    Fault(Arc<PlantError>),
}

/// A plant with memory.
pub struct Recall<P: Plant> {
    plant: P,
    policy: Policy,
    nodes: Vec<Node<P::Checkpoint>>,
    /// Where the plant really is; `None` after a fault.
    at: Option<NodeId>,
    checkpoints: usize,
    steps: u64,
    restarts: u64,
    restores: u64,
}

impl<P: Plant> Recall<P> {
    /// Starts the plant and remembers its initial state.
    ///
    /// # Errors
    /// When the FMU cannot be started.
    pub fn new(mut plant: P, policy: Policy) -> Result<Self, PlantError> {
        let outputs = plant.restart()?.into();
        let mut checkpoints = 0;
        let checkpoint = match policy {
            Policy::States { max_checkpoints } if max_checkpoints > 0 => {
                checkpoints = 1;
                Some(plant.save()?)
            }
            _ => None,
        };
        let root = Node {
            parent: NodeId::ROOT,
            depth: 0,
            steps: 0,
            inputs: Vec::new(),
            outputs,
            checkpoint,
            children: BTreeMap::new(),
        };
        Ok(Self {
            plant,
            policy,
            nodes: vec![root],
            at: Some(NodeId::ROOT),
            checkpoints,
            steps: 0,
            restarts: 1,
            restores: 0,
        })
    }

    /// Outputs after each step of the transition into `node`, row-major.
    #[must_use]
    pub fn outputs(&self, node: NodeId) -> &Arc<[f64]> {
        &self.nodes[node.0].outputs
    }

    /// The state before the transition into `node`; the root's is the root.
    #[must_use]
    pub fn parent(&self, node: NodeId) -> NodeId {
        self.nodes[node.0].parent
    }

    /// Inputs of the transition into `node`, row-major.
    #[must_use]
    pub fn inputs(&self, node: NodeId) -> &[f64] {
        &self.nodes[node.0].inputs
    }

    /// Communication steps the FMU really took so far.
    #[must_use]
    pub const fn steps(&self) -> u64 {
        self.steps
    }

    /// Number of distinct states met.
    #[must_use]
    pub const fn states(&self) -> usize {
        self.nodes.len()
    }

    /// Fresh instances made, and saved states restored.
    #[must_use]
    pub const fn restarts_and_restores(&self) -> (u64, u64) {
        (self.restarts, self.restores)
    }

    /// Takes `steps` communication steps from `node` with `inputs` (row-major).
    ///
    /// # Errors
    /// Only when the FMU cannot be brought back at all, or is seen not to repeat itself; a failure of the steps
    /// themselves is [`Advanced::Fault`].
    pub fn advance(&mut self, node: NodeId, steps: usize, inputs: &[f64]) -> Result<Advanced, PlantError> {
        let key: Vec<u64> = inputs.iter().map(|v| v.to_bits()).chain([steps as u64]).collect();
        let known = self.nodes[node.0].children.get(&key).cloned();
        if let (Some(known), Policy::States { .. }) = (&known, self.policy) {
            return Ok(match known {
                Ok(child) => Advanced::To(*child),
                Err(fault) => Advanced::Fault(Arc::clone(fault)),
            });
        }
        self.go_to(node)?;
        let outcome = self.plant.advance(steps, inputs);
        self.steps += steps as u64;
        let outputs = match outcome {
            Ok(outputs) => outputs,
            Err(fault) => {
                self.at = None;
                if fault.fatal {
                    return Err(fault);
                }
                let fault = Arc::new(fault);
                if let Some(Ok(_)) = known {
                    return Err(not_repeatable(fault.time_s));
                }
                self.nodes[node.0].children.insert(key, Err(Arc::clone(&fault)));
                return Ok(Advanced::Fault(fault));
            }
        };
        if let Some(known) = known {
            let Ok(child) = known else { return Err(not_repeatable(None)) };
            if !same_bits(&self.nodes[child.0].outputs, &outputs) {
                return Err(not_repeatable(None));
            }
            self.at = Some(child);
            return Ok(Advanced::To(child));
        }
        let child = NodeId(self.nodes.len());
        let checkpoint = match self.policy {
            Policy::States { max_checkpoints } if self.checkpoints < max_checkpoints => {
                self.checkpoints += 1;
                Some(self.plant.save()?)
            }
            _ => None,
        };
        self.nodes.push(Node {
            parent: node,
            depth: self.nodes[node.0].depth + 1,
            steps,
            inputs: inputs.to_vec(),
            outputs: outputs.into(),
            checkpoint,
            children: BTreeMap::new(),
        });
        self.nodes[node.0].children.insert(key, Ok(child));
        self.at = Some(child);
        Ok(Advanced::To(child))
    }

    /// Brings the plant to `node`.
    fn go_to(&mut self, node: NodeId) -> Result<(), PlantError> {
        if self.at == Some(node) {
            return Ok(());
        }
        // The path back to the nearest saved state, or to the start.
        let mut path = Vec::with_capacity(self.nodes[node.0].depth);
        let mut from = node;
        while self.nodes[from.0].checkpoint.is_none() && from != NodeId::ROOT {
            path.push(from);
            from = self.nodes[from.0].parent;
        }
        self.at = None;
        let restored = match &self.nodes[from.0].checkpoint {
            Some(checkpoint) => self.plant.restore(checkpoint).map(|()| true),
            None => Ok(false),
        };
        if restored.as_ref().is_err_and(|e| !e.fatal) {
            // An instance that refuses to come back (after an error, say) is given up with all its saved states.
            self.nodes.iter_mut().for_each(|n| n.checkpoint = None);
            self.checkpoints = usize::MAX;
            return self.go_to(node);
        }
        if restored? {
            self.restores += 1;
        } else {
            let outputs = self.plant.restart()?;
            self.restarts += 1;
            if !same_bits(&self.nodes[from.0].outputs, &outputs) {
                return Err(not_repeatable(Some(0.0)));
            }
        }
        for step in path.into_iter().rev() {
            let Node { steps, inputs, outputs, .. } = &self.nodes[step.0];
            let again = self.plant.advance(*steps, inputs)?;
            self.steps += *steps as u64;
            if !same_bits(outputs, &again) {
                return Err(not_repeatable(None));
            }
        }
        self.at = Some(node);
        Ok(())
    }
}

fn same_bits(a: &[f64], b: &[f64]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(x, y)| x.to_bits() == y.to_bits())
}

fn not_repeatable(time_s: Option<f64>) -> PlantError {
    PlantError {
        message: "the FMU gave different outputs for the same inputs: its results depend on something else, so \
                  findings could not be replayed. Run `fmi-hazard selftest` on it"
            .to_owned(),
        time_s,
        fatal: true,
    }
}

#[cfg(test)]
#[path = "recall_tests.rs"]
mod tests;
