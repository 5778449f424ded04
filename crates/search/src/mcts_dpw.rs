//! Monte Carlo tree search with double progressive widening (DPW), as Huck, Ledermann and Kroeger (ICRA 2021) use it,
//! after Lee et al.'s adaptive stress testing.
//!
//! The environment is deterministic, so widening over next states vanishes and widening over actions remains. Each
//! iteration starts at the root: descend by the tree policy, add one node, roll out at random, back up the
//! undiscounted sum of rewards. A node keeps a snapshot, so the prefix is restored instead of simulated again.
//!
//! The paper leaves `k`, `alpha`, `c` and `R_E` open and prints formulas that need reading (no logarithm in the bonus,
//! a widening test that fails at `N = 0`, actions drawn with replacement). [`Profile`] names the readings.

use super::random::rollout;
use super::{End, Environment, Iteration, Rng, Strategy};

/// The exploration bonus.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bonus {
    /// `c * sqrt(N(s) / N(s,a))`, as the paper prints it.
    Paper,
    /// `c * sqrt(ln N(s) / N(s,a))`, as in Lee et al. and in UCB1.
    Logarithmic,
}

/// The open parameters of the method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters {
    /// Widening factor: a state has at most about `k * N(s)^alpha` children.
    pub k: f64,
    /// Widening exponent.
    pub alpha: f64,
    /// Weight of the exploration bonus, on the scale of the rewards.
    pub c: f64,
    /// Form of the bonus.
    pub bonus: Bonus,
    /// Widen also when the number of children *equals* `k * N^alpha` (`<=` instead of the paper's `<`).
    pub widen_when_equal: bool,
    /// Stop widening when every action has a child. Without it, selection turns into pure random choice as soon as
    /// `k * N^alpha` exceeds the number of actions, because drawn actions repeat.
    pub cap_at_actions: bool,
}

/// Named readings of the paper.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Profile {
    /// The paper's formulas made to work: `N` counted before the widening test, capped at the number of actions;
    /// `k = 1`, `alpha = 0.5`, `c = 10`.
    Paper,
    /// The cited algorithm (adaptive stress testing): logarithm, `<=`, `k = 0.5`, `alpha = 0.85`, `c = 100`.
    Lee,
    /// The paper to the letter: as [`Profile::Paper`] but without the cap.
    PaperLiteral,
}

impl Profile {
    /// Its parameters.
    #[must_use]
    pub const fn parameters(self) -> Parameters {
        match self {
            Self::Paper => Parameters {
                k: 1.0,
                alpha: 0.5,
                c: 10.0,
                bonus: Bonus::Paper,
                widen_when_equal: false,
                cap_at_actions: true,
            },
            Self::Lee => Parameters {
                k: 0.5,
                alpha: 0.85,
                c: 100.0,
                bonus: Bonus::Logarithmic,
                widen_when_equal: true,
                cap_at_actions: false,
            },
            Self::PaperLiteral => Parameters { cap_at_actions: false, ..Self::Paper.parameters() },
        }
    }

    /// The strategy name on the command line.
    #[must_use]
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Paper => "mcts-dpw",
            Self::Lee => "mcts-dpw-lee",
            Self::PaperLiteral => "mcts-dpw-literal",
        }
    }
}

/// One action out of a node.
#[derive(Debug)]
struct Edge {
    action: usize,
    visits: u64,
    mean: f64,
    reward: f64,
    end: Option<End>,
    /// Index of the node it leads to, once that was visited a second time; terminal edges have none.
    child: Option<usize>,
}

#[derive(Debug)]
struct Node<S> {
    snapshot: S,
    visits: u64,
    edges: Vec<Edge>,
}

/// The search tree and its parameters.
#[derive(Debug)]
pub struct MctsDpw<S> {
    profile: Profile,
    parameters: Parameters,
    nodes: Vec<Node<S>>,
}

impl<S: Clone> MctsDpw<S> {
    /// A fresh tree with the parameters of `profile`.
    #[must_use]
    pub fn new(profile: Profile) -> Self {
        Self { profile, parameters: profile.parameters(), nodes: Vec::new() }
    }

    /// A fresh tree with other parameters (for sensitivity studies).
    #[must_use]
    pub fn with_parameters(profile: Profile, parameters: Parameters) -> Self {
        Self { profile, parameters, nodes: Vec::new() }
    }

    /// The tree policy at `node`: an existing edge, or a drawn action (which may or may not have an edge yet).
    fn choose(&self, node: &Node<S>, actions: usize, rng: &mut Rng) -> usize {
        let p = &self.parameters;
        #[expect(clippy::cast_precision_loss, reason = "visit counts are far below 2^53")]
        let (children, n) = (node.edges.len() as f64, node.visits as f64);
        let width = p.k * libm::pow(n, p.alpha);
        let widen = if p.widen_when_equal { children <= width } else { children < width };
        let full = p.cap_at_actions && node.edges.len() >= actions;
        if node.edges.is_empty() || (widen && !full) {
            return rng.below(actions);
        }
        let mut best = (f64::NEG_INFINITY, 0);
        for edge in &node.edges {
            #[expect(clippy::cast_precision_loss, reason = "visit counts are far below 2^53")]
            let m = edge.visits as f64;
            let bonus = match p.bonus {
                Bonus::Paper => (n / m).sqrt(),
                Bonus::Logarithmic => (libm::log(n) / m).sqrt(),
            };
            let value = edge.mean + p.c * bonus;
            // The first of equals wins: edges are in order of creation, so this is deterministic.
            if value > best.0 {
                best = (value, edge.action);
            }
        }
        best.1
    }
}

impl<E: Environment> Strategy<E> for MctsDpw<E::Snapshot> {
    fn name(&self) -> &'static str {
        self.profile.name()
    }

    fn iterate(&mut self, environment: &mut E, rng: &mut Rng) -> Result<Iteration, E::Error> {
        environment.reset()?;
        if self.nodes.is_empty() {
            // The first iteration only inserts the root and rolls out, as in the reference algorithm.
            self.nodes.push(Node { snapshot: environment.save(), visits: 0, edges: Vec::new() });
            return rollout(environment, rng);
        }
        let mut path: Vec<(usize, usize)> = Vec::with_capacity(environment.horizon());
        let mut at = 0;
        let leaf = loop {
            self.nodes[at].visits += 1;
            let action = self.choose(&self.nodes[at], environment.actions(), rng);
            let known = self.nodes[at].edges.iter().position(|e| e.action == action);
            let Some(edge) = known else {
                // A new edge: simulate it, then roll out from where it leads.
                environment.restore(&self.nodes[at].snapshot)?;
                let step = environment.step(action)?;
                let node = &mut self.nodes[at];
                node.edges.push(Edge { action, visits: 0, mean: 0.0, reward: step.reward, end: step.end, child: None });
                path.push((at, node.edges.len() - 1));
                break match step.end {
                    Some(end) => Iteration { end, total_reward: 0.0, random: false },
                    None => {
                        let snapshot = environment.save();
                        let child = self.nodes.len();
                        self.nodes.push(Node { snapshot, visits: 0, edges: Vec::new() });
                        if let Some(last) = self.nodes[at].edges.last_mut() {
                            last.child = Some(child);
                        }
                        rollout(environment, rng)?
                    }
                };
            };
            path.push((at, edge));
            let edge = &self.nodes[at].edges[edge];
            match (edge.end, edge.child) {
                (None, Some(child)) => at = child,
                (end, _) => break Iteration { end: end.unwrap_or(End::Horizon), total_reward: 0.0, random: false },
            }
        };
        // Backup: q is the undiscounted reward from each edge on.
        let mut q = leaf.total_reward;
        for &(node, edge) in path.iter().rev() {
            let edge = &mut self.nodes[node].edges[edge];
            q += edge.reward;
            edge.visits += 1;
            #[expect(clippy::cast_precision_loss, reason = "visit counts are far below 2^53")]
            let n = edge.visits as f64;
            edge.mean += (q - edge.mean) / n;
        }
        Ok(Iteration { end: leaf.end, total_reward: q, random: false })
    }
}

#[cfg(test)]
#[path = "mcts_dpw_tests.rs"]
mod tests;
