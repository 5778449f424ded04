//! What was stepped from states that were brought back, run once more plainly: a fresh instance, all inputs from the start,
//! no restore. A certificate rests on every one of these transitions, and no self-test can excite everything.
//!
//! A [`Recall`] holds a tree of histories. Each leaf of it is run once, and every transition on the way compared in all
//! its outputs, bit for bit (by a digest of 64 bits that stays when the outputs are forgotten). A history that was merged
//! with another one because both led to equal bytes is a leaf; it is run on with the inputs of a continuation of the
//! other one, as deep as there is one, and has to give the same.
//!
//! Where all that is more than the budget allows, leaves are taken in the order of a key made from their inputs: the same
//! on every machine and whichever way states were brought back.

use super::plant::{Plant, PlantError, Unlike};
use super::recall::{self, NodeId, Recall, mixed};

/// Continuations that are tried for a merged history, in the end, if there is time.
const ROUNDS: u64 = 4;

/// How much is looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Scope {
    /// Transitions that were stepped since there were so many nodes.
    pub since: usize,
    /// Most runs.
    pub runs: usize,
    /// Most communication steps.
    pub steps: u64,
    /// What a fresh instance costs, in communication steps.
    pub instance: u64,
}

/// What came out.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Audit {
    /// Transitions of the FMU that there are to compare.
    pub transitions: u64,
    /// Compared with a plain run, before the first difference.
    pub compared: u64,
    /// Histories that were merged with one that went on.
    pub merges: u64,
    /// Of these, run on with the inputs of the other.
    pub merges_compared: u64,
    /// The first difference.
    pub difference: Option<Difference>,
    /// Told to stop before the end.
    pub stopped: bool,
}

/// A history that the FMU goes through differently from what is known of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// What this shows to be wrong.
    pub unlike: Unlike,
    /// In which action, from 1; 0 for the start.
    pub action: usize,
    /// The history: steps, and inputs, row-major.
    pub history: (usize, Vec<f64>),
    /// What the plain run gave, in short; nothing if it failed.
    pub gave: Option<u64>,
}

/// What a plain run gave: the digest of everything, and those of the start and of each transition.
#[derive(Debug, PartialEq)]
struct Given {
    all: u64,
    digests: Vec<u64>,
}

/// The histories of a [`Recall`].
struct Tree<'a, Q: Plant> {
    recall: &'a Recall<Q>,
    /// Of the history of each node.
    keys: Vec<u64>,
    /// Nodes that were stepped from each.
    children: Vec<Vec<NodeId>>,
}

impl<'a, Q: Plant> Tree<'a, Q> {
    fn new(recall: &'a Recall<Q>) -> Self {
        let mut keys: Vec<u64> = Vec::with_capacity(recall.states());
        let mut children = vec![Vec::new(); recall.states()];
        for node in recall.nodes() {
            let parent = recall.parent(node);
            let before = keys.get(parent.index()).copied().unwrap_or_default();
            keys.push(mixed(before, recall.edge_digest(node)));
            if node != NodeId::ROOT && recall.digest(node).is_some() {
                children[parent.index()].push(node);
            }
        }
        Self { recall, keys, children }
    }

    /// Histories that nothing was stepped from, in the order of their keys.
    fn leaves(&self, since: usize) -> Vec<NodeId> {
        let is_leaf = |node: &NodeId| {
            node.index() >= since && self.recall.digest(*node).is_some() && self.children[node.index()].is_empty()
        };
        let mut leaves: Vec<NodeId> = self.recall.nodes().filter(is_leaf).collect();
        leaves.sort_by_key(|leaf| (self.keys[leaf.index()], *leaf));
        leaves
    }

    /// The nodes from the start, which is left out, to `node`.
    fn path(&self, mut node: NodeId) -> Vec<NodeId> {
        let mut path = Vec::with_capacity(self.recall.depth(node));
        while node != NodeId::ROOT {
            path.push(node);
            node = self.recall.parent(node);
        }
        path.reverse();
        path
    }

    /// A continuation of a history that was merged, by number: the nodes that follow.
    fn continuation(&self, leaf: NodeId, round: u64) -> Vec<NodeId> {
        let salt = mixed(self.keys[leaf.index()], round);
        let (mut at, mut on) = (leaf, Vec::new());
        let choice = |node: &&NodeId| (mixed(self.keys[node.index()], salt), **node);
        while let Some(next) = self.children[self.recall.same(at).index()].iter().min_by_key(choice) {
            on.push(*next);
            at = *next;
        }
        on
    }

    /// Steps and inputs of these transitions, one after the other.
    fn history(&self, nodes: &[NodeId]) -> (usize, Vec<f64>) {
        nodes.iter().fold((0, Vec::new()), |(all, mut rows), node| {
            let (steps, inputs) = self.recall.transition(*node);
            rows.extend(inputs);
            (all + steps, rows)
        })
    }

    /// Runs these transitions from the start, plainly. The digests of the outputs at the start and of each of them, or what
    /// the FMU said.
    fn run<P: Plant>(&self, plant: &mut P, nodes: &[NodeId]) -> Result<Result<Given, String>, PlantError> {
        let (steps, inputs) = self.history(nodes);
        let rows = match plain(plant, steps, &inputs)? {
            Ok(rows) => rows,
            Err(said) => return Ok(Err(said)),
        };
        let (start, mut rest) = rows.split_at(plant.output_count());
        let (all, mut digests) = (recall::digest(&rows), vec![recall::digest(start)]);
        for node in nodes {
            let (own, after) = rest.split_at(self.recall.transition(*node).0 * plant.output_count());
            digests.push(recall::digest(own));
            rest = after;
        }
        Ok(Ok(Given { all, digests }))
    }

    /// Runs these transitions and compares; the first `own` of them are a history, the others a continuation of a merged
    /// one.
    fn compare<P: Plant>(&self, plant: &mut P, nodes: &[NodeId], own: usize) -> Result<Option<Difference>, PlantError> {
        let known = |node: NodeId| self.recall.digest(node).unwrap_or_default();
        let expected: Vec<u64> = std::iter::once(NodeId::ROOT).chain(nodes.iter().copied()).map(known).collect();
        let found = self.run(plant, nodes)?;
        if found.as_ref().is_ok_and(|given| given.digests == expected) {
            return Ok(None);
        }
        let history = self.history(nodes);
        let first = |digests: &[u64]| digests.iter().zip(&expected).position(|(a, b)| a != b).unwrap_or(0);
        let action = found.as_ref().map_or(nodes.len(), |given| first(&given.digests));
        let again = self.run(plant, nodes)?;
        let unlike = if again != found {
            Unlike::Plain
        } else if action <= own || found.is_err() {
            Unlike::State
        } else {
            // Either what the other history gave is wrong, or the two are not in the same state.
            let other = self.path(nodes[action - 1]);
            let plainly = self.run(plant, &other)?;
            let right = plainly.is_ok_and(|given| given.digests.last() == Some(&known(nodes[action - 1])));
            if right { Unlike::Merge } else { Unlike::State }
        };
        Ok(Some(Difference { unlike, action, history, gave: found.ok().map(|given| given.all) }))
    }
}

/// One plain run from the start: the outputs at the start and after each step, or what the FMU said.
///
/// # Errors
/// When nothing can be run any more.
pub(crate) fn plain<P: Plant>(
    plant: &mut P,
    steps: usize,
    inputs: &[f64],
) -> Result<Result<Vec<f64>, String>, PlantError> {
    let mut tries = 1;
    loop {
        let run = plant.restart().and_then(|mut rows| {
            rows.extend(plant.advance(steps, inputs)?);
            Ok(rows)
        });
        match run {
            Ok(rows) => return Ok(Ok(rows)),
            Err(error) if error.lost && tries < error.tries() => tries += 1,
            Err(error) if error.fatal => return Err(error),
            Err(error) => return Ok(Err(error.message)),
        }
    }
}

/// What two plain runs of a history give, in short, if they give the same; nothing in it if both failed alike.
///
/// # Errors
/// When nothing can be run any more.
pub fn repeated<P: Plant>(
    plant: &mut P,
    (steps, inputs): &(usize, Vec<f64>),
) -> Result<Option<Option<u64>>, PlantError> {
    let mut bits = || Ok(plain(plant, *steps, inputs)?.map(|rows| recall::digest(&rows)));
    let first: Result<u64, String> = bits()?;
    Ok((first == bits()?).then(|| first.ok()))
}

/// Compares what `recall` holds with plain runs of `plant`, to the first difference. `go_on` is told how many runs are done
/// and how many there are.
///
/// # Errors
/// When nothing can be run any more.
pub fn audit<P: Plant, Q: Plant>(
    plant: &mut P,
    recall: &Recall<Q>,
    scope: Scope,
    go_on: &mut dyn FnMut(usize, usize) -> bool,
) -> Result<Audit, PlantError> {
    let tree = Tree::new(recall);
    let leaves = tree.leaves(scope.since);
    let stepped = |node: &NodeId| node.index() >= scope.since.max(1) && recall.digest(*node).is_some();
    let merged: Vec<NodeId> = leaves.iter().copied().filter(|leaf| !tree.continuation(*leaf, 0).is_empty()).collect();
    let mut audit = Audit {
        transitions: recall.nodes().filter(stepped).count() as u64,
        merges: merged.len() as u64,
        ..Audit::default()
    };
    let mut seen = vec![false; recall.states()];
    let mut spent = 0;
    let all = leaves.iter().map(|leaf| (*leaf, 0));
    let more = (1..ROUNDS).flat_map(|round| merged.iter().map(move |leaf| (*leaf, round)));
    for (number, (leaf, round)) in all.chain(more).take(scope.runs).enumerate() {
        let mut nodes = tree.path(leaf);
        let own = nodes.len();
        nodes.extend(tree.continuation(leaf, round));
        let steps: usize = nodes.iter().map(|node| recall.transition(*node).0).sum();
        spent += scope.instance + steps as u64;
        if spent > scope.steps && number > 0 {
            break;
        }
        if !go_on(number.min(leaves.len()), leaves.len()) {
            audit.stopped = true;
            break;
        }
        match tree.compare(plant, &nodes, own) {
            Ok(None) => {}
            Ok(difference) => {
                audit.difference = difference;
                break;
            }
            Err(error) if error.stopped => {
                audit.stopped = true;
                break;
            }
            Err(error) => return Err(error),
        }
        for node in &nodes[..own] {
            let new = !std::mem::replace(&mut seen[node.index()], true) && stepped(node);
            audit.compared += u64::from(new);
        }
        audit.merges_compared += u64::from(round == 0 && nodes.len() > own);
    }
    Ok(audit)
}

#[cfg(test)]
#[path = "audit_tests.rs"]
mod tests;
