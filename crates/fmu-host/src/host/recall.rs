//! Bringing states back: a tree of FMU states by input history, and the ladder of ways to reach one again.
//!
//! A deterministic FMU's state is a function of the inputs it received, so a node of this tree *is* a state. How a
//! node is reached again is decided here, not by the search: from a saved FMU state, or by a fresh instance that is
//! given the same inputs once more. The outputs are the same either way, only the speed differs; with
//! [`Policy::Replay`] every repetition is compared with what was recorded, and a difference is an error.
//!
//! Different histories may lead to the same state. With [`Recall::merge_equal_states`] nodes of the same depth whose
//! serialised states are equal byte for byte are stepped once for all of them; a part of these merges is tried out.

mod restore;

use std::collections::BTreeMap;
use std::sync::Arc;

use serde::Serialize;

use self::restore::not_repeatable;
use super::plant::{Plant, PlantError, StateCopy, Then, Unlike, insist};

/// A state of the FMU, named by its input history. Valid for the [`Recall`] that made it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct NodeId(usize);

impl NodeId {
    /// The state after initialisation.
    pub const ROOT: Self = Self(0);

    /// Its number, in the order in which states were met.
    pub const fn index(self) -> usize {
        self.0
    }
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
    /// Of these outputs, in short, kept when they are forgotten; nothing where they are those of another node's step.
    digest: Option<u64>,
    /// The first node known to be in the same state; itself mostly.
    same: NodeId,
    /// The number of these outputs: equal for equal ones, as long as both are held.
    trace: u32,
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

/// One number more in a digest. For the same beginning, different numbers give different digests.
pub(super) const fn mixed(digest: u64, number: u64) -> u64 {
    // Odd factors and shifts are one to one; the constants are those of SplitMix64 (Steele, Lea, Flood 2014).
    let mut z = (digest.rotate_left(5) ^ number).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// Outputs in short: traces that differ in one number always differ, others but for one in 2^64.
pub(super) fn digest(outputs: &[f64]) -> u64 {
    outputs.iter().fold(outputs.len() as u64, |digest, value| mixed(digest, value.to_bits()))
}

/// What an FMU really did. Depends on how states are brought back and on what happened on the way, so it is no result.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct FmuUsage {
    /// Communication steps.
    pub steps: u64,
    /// Fresh instances.
    pub restarts: u64,
    /// Saved states restored.
    pub restores: u64,
    /// Worker processes that had to be replaced.
    pub workers_replaced: u64,
}

impl FmuUsage {
    /// Both together.
    #[must_use]
    pub const fn and(self, other: Self) -> Self {
        Self {
            steps: self.steps + other.steps,
            restarts: self.restarts + other.restarts,
            restores: self.restores + other.restores,
            workers_replaced: self.workers_replaced + other.workers_replaced,
        }
    }
}

/// What is known of a state that was just reached.
struct Arrival<C> {
    /// Its serialised bytes, in short, with its depth.
    digest: Option<(usize, [u8; 32])>,
    /// A node that is in the same state.
    same: Option<NodeId>,
    checkpoint: Option<C>,
}

impl<C> Default for Arrival<C> {
    fn default() -> Self {
        Self { digest: None, same: None, checkpoint: None }
    }
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
    /// Steps of transitions that were new.
    steps: u64,
    /// All steps that were made.
    steps_made: u64,
    restarts: u64,
    restores: u64,
    restores_lost: u32,
    /// Nothing is stepped from states of this depth: what serves that alone is not asked of them.
    deepest: usize,
    /// Outputs that are held, each once, with their numbers; by what they are in short.
    traces: BTreeMap<u64, (u32, Arc<[f64]>)>,
    next_trace: u32,
}

impl<P: Plant> Recall<P> {
    /// Starts the plant and remembers its initial state.
    ///
    /// # Errors
    /// When the FMU cannot be started.
    pub fn new(mut plant: P, policy: Policy) -> Result<Self, PlantError> {
        let saves = matches!(policy, Policy::States { max_checkpoints } if max_checkpoints > 0);
        let mut begin = || Ok((plant.restart()?.into(), if saves { Some(plant.save()?) } else { None }));
        let (outputs, checkpoint): (Arc<[f64]>, _) = insist(&mut begin)?;
        let checkpoints = usize::from(saves);
        let root = Node {
            parent: NodeId::ROOT,
            depth: 0,
            edge: edge_of(0, &[]),
            digest: Some(digest(&outputs)),
            outputs,
            same: NodeId::ROOT,
            trace: 0,
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
            steps_made: 0,
            restarts: 1,
            restores: 0,
            restores_lost: 0,
            deepest: usize::MAX,
            traces: BTreeMap::new(),
            next_trace: 1,
        })
    }

    /// Says that nothing will be stepped from states of this depth: they are not saved, and not compared with others.
    /// Should something be stepped from one all the same, it is reached by replay.
    pub const fn ends_at(&mut self, depth: usize) {
        self.deepest = depth;
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

    /// A number for the outputs of the transition into `node`: those of equal number are equal to the last bit.
    #[must_use]
    pub fn trace(&self, node: NodeId) -> u32 {
        self.nodes[node.0].trace
    }

    /// The first node known to be in the same state as `node`.
    #[must_use]
    pub fn same(&self, node: NodeId) -> NodeId {
        self.nodes[node.0].same
    }

    /// Steps and inputs of the transition into `node`, row-major.
    #[must_use]
    pub(crate) fn transition(&self, node: NodeId) -> (usize, Vec<f64>) {
        values_of(&self.nodes[node.0].edge)
    }

    /// All nodes, the start first, each after its parent.
    pub(crate) fn nodes(&self) -> impl Iterator<Item = NodeId> + use<P> {
        (0..self.nodes.len()).map(NodeId)
    }

    /// The outputs after each step of the transition into `node`, in short, if the FMU was really stepped for it: else they
    /// were taken from a node in the same state.
    #[must_use]
    pub(crate) fn digest(&self, node: NodeId) -> Option<u64> {
        self.nodes[node.0].digest
    }

    /// What tells the inputs of the transition into `node` from others.
    pub(super) fn edge_digest(&self, node: NodeId) -> u64 {
        self.nodes[node.0].edge.iter().fold(0, |digest, bits| mixed(digest, *bits))
    }

    /// From now on, nodes of the same depth with equal serialised states are taken as one state. Returns whether that is
    /// possible: it needs serialised states.
    ///
    /// # Errors
    /// When the FMU cannot be brought back to its start.
    pub fn merge_equal_states(&mut self) -> Result<bool, PlantError> {
        let print = insist(&mut || {
            self.go_to(NodeId::ROOT)?;
            self.plant.fingerprint()
        });
        // An FMU that refuses to serialise is no failure: then histories are told apart.
        let Ok(Some(print)) = print else { return Ok(false) };
        self.state_bytes = print.bytes;
        self.known = Some(BTreeMap::from([((0, print.digest), NodeId::ROOT)]));
        Ok(true)
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
        self.traces = BTreeMap::new();
        self.bytes = self.nodes.iter().map(|n| self.bytes_of(n)).sum();
    }

    fn bytes_of(&self, node: &Node<P::Checkpoint>) -> usize {
        let state = if node.checkpoint.is_some() { self.state_bytes.max(256) } else { 0 };
        NODE_BYTES + 8 * node.edge.len() + 8 * node.outputs.len() + state
    }

    /// Communication steps of all different transitions so far, however often they were repeated to come back to a
    /// state: the same on every rung of the ladder.
    #[must_use]
    pub const fn steps(&self) -> u64 {
        self.steps
    }

    /// What the FMU really did so far.
    #[must_use]
    pub const fn effort(&self) -> FmuUsage {
        FmuUsage { steps: self.steps_made, restarts: self.restarts, restores: self.restores, workers_replaced: 0 }
    }

    /// The plant, to ask it something.
    #[must_use]
    pub(crate) const fn plant(&self) -> &P {
        &self.plant
    }

    /// Number of distinct states met.
    #[must_use]
    pub const fn states(&self) -> usize {
        self.nodes.len()
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
        self.steps += if known.is_none() { steps as u64 } else { 0 };
        let stepped = self.step_from(node, &edge, steps, inputs, known.is_none());
        let (outputs, arrival) = match stepped {
            Ok(reached) => reached,
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
        Ok(Advanced::To(self.add(node, edge, outputs.into(), arrival)))
    }

    /// What is wanted of a state that is met for the first time.
    fn wanted(&self, depth: usize) -> Then {
        match self.policy {
            _ if depth >= self.deepest => Then::Nothing,
            _ if self.known.is_some() => Then::Fingerprint,
            Policy::States { max_checkpoints } if self.checkpoints < max_checkpoints => Then::Save,
            _ => Then::Nothing,
        }
    }

    /// Takes stock of the state that the plant has just reached with its `depth`th action, of which this is known.
    fn arrive(
        &mut self,
        depth: usize,
        edge: &[u64],
        taken: StateCopy<P::Checkpoint>,
    ) -> Result<Arrival<P::Checkpoint>, PlantError> {
        let print = match taken {
            StateCopy::Nothing => return Ok(Arrival::default()),
            StateCopy::Saved(state) => return Ok(Arrival { checkpoint: Some(state), ..Arrival::default() }),
            StateCopy::Fingerprint(print) => print,
        };
        let digest = print.map(|print| (depth, print.digest));
        let same = digest.and_then(|digest| self.known.as_ref()?.get(&digest).copied());
        let mut checkpoint = None;
        if let Some(same) = same {
            let merged = self.merges.merged + 1;
            if merged <= FIRST_TRIED_OUT || merged.is_power_of_two() {
                self.try_out(same, edge)?;
            }
        } else if matches!(self.policy, Policy::States { max_checkpoints } if self.checkpoints < max_checkpoints) {
            checkpoint = Some(self.plant.save()?);
        }
        Ok(Arrival { digest, same, checkpoint })
    }

    /// A node below `parent` for a state that was reached.
    fn add(
        &mut self,
        parent: NodeId,
        edge: Arc<[u64]>,
        outputs: Arc<[f64]>,
        arrival: Arrival<P::Checkpoint>,
    ) -> NodeId {
        let child = NodeId(self.nodes.len());
        let Arrival { digest: state, same, checkpoint } = arrival;
        if let (Some(state), Some(known)) = (state, &mut self.known) {
            known.entry(state).or_insert(child);
        }
        self.merges.merged += u64::from(same.is_some());
        self.checkpoints += usize::from(checkpoint.is_some());
        let same = same.unwrap_or(child);
        let depth = self.nodes[parent.0].depth + 1;
        let own = digest(&outputs);
        let (trace, outputs) = self.held(own, outputs);
        let node = Node {
            parent,
            depth,
            edge: Arc::clone(&edge),
            outputs,
            digest: Some(own),
            same,
            trace,
            checkpoint,
            children: BTreeMap::new(),
        };
        self.bytes += self.bytes_of(&node);
        self.nodes.push(node);
        self.nodes[parent.0].children.insert(edge, Ok(child));
        self.at = Some(same);
        child
    }

    /// These outputs, which are `short` in short, with their number: as they are held already, if they are.
    fn held(&mut self, short: u64, outputs: Arc<[f64]>) -> (u32, Arc<[f64]>) {
        if let Some((number, held)) = self.traces.get(&short)
            && same_bits(held, &outputs)
        {
            return (*number, Arc::clone(held));
        }
        let number = self.next_trace;
        self.next_trace += 1;
        self.traces.insert(short, (number, Arc::clone(&outputs)));
        (number, outputs)
    }

    /// Steps on from where the plant is and from `other`, which is said to be the same state, with the inputs of
    /// `edge`. The plant is in that state afterwards.
    fn try_out(&mut self, other: NodeId, edge: &[u64]) -> Result<(), PlantError> {
        let here = self.ahead(edge)?;
        self.go_to(other)?;
        let there = self.ahead(edge)?;
        self.go_to(other)?;
        let equal = match (&here, &there) {
            (Ok(a), Ok(b)) => same_bits(a, b),
            (a, b) => a == b,
        };
        if !equal {
            return Err(PlantError::of(
                "two states of the FMU have the same serialised bytes but went on differently: its serialised \
                          state does not hold everything, so equal states cannot be told by it. Use `--merge history`",
            )
            .unlike(Unlike::Merge)
            .fatal());
        }
        self.merges.tried_out += 1;
        Ok(())
    }

    /// Steps the plant on with the inputs of an edge; nothing when its process is gone.
    fn ahead(&mut self, edge: &[u64]) -> Result<Result<Vec<f64>, String>, PlantError> {
        let (steps, inputs) = values_of(edge);
        self.at = None;
        self.steps_made += steps as u64;
        match self.plant.advance(steps, &inputs) {
            Err(error) if error.lost => Err(error),
            stepped => Ok(stepped.map_err(|e| e.message)),
        }
    }

    /// A node below `parent` for the transition that led to `child` from the same state.
    fn alias(&mut self, parent: NodeId, child: NodeId) -> NodeId {
        let Node { depth, edge, outputs, same, trace, .. } = &self.nodes[child.0];
        let node = Node {
            parent,
            depth: *depth,
            edge: Arc::clone(edge),
            outputs: Arc::clone(outputs),
            digest: None,
            same: *same,
            trace: *trace,
            checkpoint: None,
            children: BTreeMap::new(),
        };
        self.bytes += NODE_BYTES;
        self.nodes.push(node);
        NodeId(self.nodes.len() - 1)
    }
}

fn same_bits(a: &[f64], b: &[f64]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(x, y)| x.to_bits() == y.to_bits())
}

#[cfg(test)]
#[path = "recall_tests.rs"]
mod tests;
