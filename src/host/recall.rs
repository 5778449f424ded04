//! Bringing states back: a tree of FMU states by input history, and the ladder of ways to reach one again.
//!
//! A deterministic FMU's state is a function of the inputs it received, so a node of this tree *is* a state. How a
//! node is reached again is decided here, not by the search: from a saved FMU state, or by a fresh instance that is
//! given the same inputs once more. The outputs are the same either way, only the speed differs; with
//! [`Policy::Replay`] every repetition is compared with what was recorded, and a difference is an error.
//!
//! Different histories may lead to the same state. With [`Recall::merge_equal_states`] nodes of the same depth whose
//! serialised states are equal byte for byte are stepped once for all of them; a part of these merges is tried out.

use std::collections::BTreeMap;
use std::sync::Arc;

use serde::Serialize;

use super::plant::{Fingerprint, Plant, PlantError};

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
    /// Inputs of the edge from the parent, row-major, as bits; the last entry is the number of steps.
    edge: Arc<[u64]>,
    /// Outputs after each step of that edge, row-major; for the root, the outputs after initialisation.
    outputs: Arc<[f64]>,
    /// The first node known to be in the same state; itself mostly.
    same: NodeId,
    checkpoint: Option<C>,
    children: BTreeMap<Arc<[u64]>, Result<NodeId, Arc<PlantError>>>,
}

/// Bytes that a node takes besides its values, about.
const NODE_BYTES: usize = 200;

fn edge_of(steps: usize, inputs: &[f64]) -> Arc<[u64]> {
    inputs.iter().map(|v| v.to_bits()).chain([steps as u64]).collect()
}

fn values_of(edge: &[u64]) -> (usize, Vec<f64>) {
    let (steps, inputs) = edge.split_last().map_or((0, &[][..]), |(steps, inputs)| (*steps, inputs));
    (usize::try_from(steps).unwrap_or(0), inputs.iter().map(|bits| f64::from_bits(*bits)).collect())
}

/// What merging equal states did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Merges {
    /// Histories that led to a state known already.
    pub merged: u64,
    /// Merges tried out: both states were stepped on with the same inputs and gave the same outputs to the last bit.
    pub tried_out: u64,
}

/// The first so many merges are tried out, then every one whose number is a power of two.
const FIRST_TRIED_OUT: u64 = 64;

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
    /// Nodes by depth and serialised state; nothing unless equal states are merged.
    known: Option<BTreeMap<(usize, [u8; 32]), NodeId>>,
    merges: Merges,
    /// Bytes of one serialised state, where known.
    state_bytes: usize,
    bytes: usize,
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
            edge: edge_of(0, &[]),
            outputs,
            same: NodeId::ROOT,
            checkpoint,
            children: BTreeMap::new(),
        };
        Ok(Self {
            plant,
            policy,
            nodes: vec![root],
            at: Some(NodeId::ROOT),
            checkpoints,
            known: None,
            merges: Merges::default(),
            state_bytes: 0,
            bytes: 0,
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
    pub fn inputs(&self, node: NodeId) -> Vec<f64> {
        values_of(&self.nodes[node.0].edge).1
    }

    /// Actions between the start and `node`.
    #[must_use]
    pub fn depth(&self, node: NodeId) -> usize {
        self.nodes[node.0].depth
    }

    /// The first node known to be in the same state as `node`.
    #[must_use]
    pub fn same(&self, node: NodeId) -> NodeId {
        self.nodes[node.0].same
    }

    /// From now on, nodes of the same depth with equal serialised states are taken as one state. Returns whether that is
    /// possible: it needs serialised states, and saved states to try merges out.
    ///
    /// # Errors
    /// When the FMU cannot be brought back to its start.
    pub fn merge_equal_states(&mut self) -> Result<bool, PlantError> {
        self.go_to(NodeId::ROOT)?;
        // An FMU that refuses to serialise is no failure: then histories are told apart.
        let Ok(Some(print)) = self.plant.fingerprint() else { return Ok(false) };
        if self.nodes[0].checkpoint.is_some() {
            self.state_bytes = print.bytes;
            self.known = Some(BTreeMap::from([((0, print.digest), NodeId::ROOT)]));
        }
        Ok(self.known.is_some())
    }

    /// What merging equal states did so far.
    #[must_use]
    pub const fn merges(&self) -> Merges {
        self.merges
    }

    /// Memory held for states and their traces, bytes, about.
    #[must_use]
    pub const fn bytes(&self) -> usize {
        self.bytes
    }

    /// Forgets saved states, traces and transitions of nodes of less than `depth`, except the start. They can still be
    /// stepped on, by replay.
    pub fn release_before(&mut self, depth: usize) {
        for node in self.nodes.iter_mut().skip(1).filter(|n| n.depth < depth) {
            self.checkpoints -= usize::from(node.checkpoint.take().is_some());
            node.children = BTreeMap::new();
            node.outputs = Arc::default();
        }
        if let Some(known) = &mut self.known {
            known.retain(|(at, _), _| *at >= depth || *at == 0);
        }
        self.bytes = self.nodes.iter().map(|n| self.bytes_of(n)).sum();
    }

    fn bytes_of(&self, node: &Node<P::Checkpoint>) -> usize {
        let state = if node.checkpoint.is_some() { self.state_bytes.max(256) } else { 0 };
        NODE_BYTES + 8 * node.edge.len() + 8 * node.outputs.len() + state
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

    /// Where `steps` communication steps from `node` with `inputs` (row-major) lead, if they were taken before; nothing
    /// is simulated.
    #[must_use]
    pub fn known(&self, node: NodeId, steps: usize, inputs: &[f64]) -> Option<NodeId> {
        self.nodes[node.0].children.get(&edge_of(steps, inputs)).and_then(|child| child.as_ref().ok()).copied()
    }

    /// Takes `steps` communication steps from `node` with `inputs` (row-major).
    ///
    /// # Errors
    /// Only when the FMU cannot be brought back at all, or is seen not to repeat itself; a failure of the steps
    /// themselves is [`Advanced::Fault`].
    pub fn advance(&mut self, node: NodeId, steps: usize, inputs: &[f64]) -> Result<Advanced, PlantError> {
        let edge = edge_of(steps, inputs);
        let known = self.nodes[node.0].children.get(&edge).cloned();
        if let (Some(known), Policy::States { .. }) = (&known, self.policy) {
            return Ok(match known {
                Ok(child) => Advanced::To(*child),
                Err(fault) => Advanced::Fault(Arc::clone(fault)),
            });
        }
        let same = self.nodes[node.0].same;
        if same != node {
            // The same state under another history: the transition is that of the first one.
            let advanced = self.advance(same, steps, inputs)?;
            let child = match &advanced {
                Advanced::To(child) => Ok(self.alias(node, *child)),
                Advanced::Fault(fault) => Err(Arc::clone(fault)),
            };
            self.nodes[node.0].children.insert(edge, child.clone());
            return Ok(child.map_or_else(Advanced::Fault, Advanced::To));
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
                self.nodes[node.0].children.insert(edge, Err(Arc::clone(&fault)));
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
        let child = self.arrive(node, edge, outputs.into())?;
        Ok(Advanced::To(child))
    }

    /// Takes in the state that the plant has just reached from `parent`.
    fn arrive(&mut self, parent: NodeId, edge: Arc<[u64]>, outputs: Arc<[f64]>) -> Result<NodeId, PlantError> {
        let child = NodeId(self.nodes.len());
        let depth = self.nodes[parent.0].depth + 1;
        let print = if self.known.is_some() { self.plant.fingerprint()? } else { None };
        let mut same = child;
        if let (Some(Fingerprint { digest, .. }), Some(known)) = (print, &mut self.known) {
            same = *known.entry((depth, digest)).or_insert(child);
        }
        let mut checkpoint = None;
        if same == child {
            checkpoint = match self.policy {
                Policy::States { max_checkpoints } if self.checkpoints < max_checkpoints => {
                    self.checkpoints += 1;
                    Some(self.plant.save()?)
                }
                _ => None,
            };
        } else {
            self.merges.merged += 1;
            if self.merges.merged <= FIRST_TRIED_OUT || self.merges.merged.is_power_of_two() {
                self.try_out(same, &edge)?;
            }
        }
        let node =
            Node { parent, depth, edge: Arc::clone(&edge), outputs, same, checkpoint, children: BTreeMap::new() };
        self.bytes += self.bytes_of(&node);
        self.nodes.push(node);
        self.nodes[parent.0].children.insert(edge, Ok(child));
        self.at = Some(same);
        Ok(child)
    }

    /// Steps on from where the plant is and from `other`, which is said to be the same state, with the inputs of
    /// `edge`. The plant is in that state afterwards.
    fn try_out(&mut self, other: NodeId, edge: &[u64]) -> Result<(), PlantError> {
        if self.nodes[other.0].checkpoint.is_none() {
            return Ok(());
        }
        let here = self.ahead(edge);
        self.back_to(other)?;
        let there = self.ahead(edge);
        self.back_to(other)?;
        let equal = match (&here, &there) {
            (Ok(a), Ok(b)) => same_bits(a, b),
            (a, b) => a == b,
        };
        if !equal {
            return Err(PlantError {
                message:
                    "two states of the FMU have the same serialised bytes but went on differently: its serialised \
                          state does not hold everything, so equal states cannot be told by it. Use `--merge history`"
                        .to_owned(),
                time_s: None,
                fatal: true,
            });
        }
        self.merges.tried_out += 1;
        Ok(())
    }

    /// Steps the plant on with the inputs of an edge.
    fn ahead(&mut self, edge: &[u64]) -> Result<Vec<f64>, String> {
        let (steps, inputs) = values_of(edge);
        self.at = None;
        self.steps += steps as u64;
        self.plant.advance(steps, &inputs).map_err(|e| e.message)
    }

    /// Restores the saved state of `node`, if it has one.
    fn back_to(&mut self, node: NodeId) -> Result<(), PlantError> {
        if let Some(checkpoint) = &self.nodes[node.0].checkpoint {
            self.plant.restore(checkpoint)?;
            self.restores += 1;
        }
        Ok(())
    }

    /// A node below `parent` for the transition that led to `child` from the same state.
    fn alias(&mut self, parent: NodeId, child: NodeId) -> NodeId {
        let Node { depth, edge, outputs, same, .. } = &self.nodes[child.0];
        let node = Node {
            parent,
            depth: *depth,
            edge: Arc::clone(edge),
            outputs: Arc::clone(outputs),
            same: *same,
            checkpoint: None,
            children: BTreeMap::new(),
        };
        self.bytes += NODE_BYTES;
        self.nodes.push(node);
        NodeId(self.nodes.len() - 1)
    }

    /// Brings the plant to `node`.
    fn go_to(&mut self, node: NodeId) -> Result<(), PlantError> {
        let node = self.nodes[node.0].same;
        if self.at == Some(node) {
            return Ok(());
        }
        // The path back to the nearest saved state, or to the start.
        let mut path = Vec::with_capacity(self.nodes[node.0].depth);
        let mut from = node;
        while self.nodes[from.0].checkpoint.is_none() && from != NodeId::ROOT {
            path.push(from);
            from = self.nodes[self.nodes[from.0].parent.0].same;
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
            let Node { edge, outputs, .. } = &self.nodes[step.0];
            let (steps, inputs) = values_of(edge);
            let again = self.plant.advance(steps, &inputs)?;
            self.steps += steps as u64;
            // Traces of long ago may have been forgotten.
            if !outputs.is_empty() && !same_bits(outputs, &again) {
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
