//! MCTS-DPW on puzzles with known answers, and the details of the reference algorithm that are easy to get wrong.

use super::*;
use crate::{Random, Step};

/// A lock: `horizon` digits out of `actions`; only the right sequence opens it. The reward at the end counts the
/// right digits, so there is a slope to climb.
struct Lock {
    code: Vec<usize>,
    actions: usize,
    entered: Vec<usize>,
    steps: usize,
}

impl Lock {
    fn new(code: &[usize], actions: usize) -> Self {
        Self { code: code.to_vec(), actions, entered: Vec::new(), steps: 0 }
    }
}

impl Environment for Lock {
    type Snapshot = Vec<usize>;
    type Error = std::convert::Infallible;
    fn actions(&self) -> usize {
        self.actions
    }
    fn horizon(&self) -> usize {
        self.code.len()
    }
    fn reset(&mut self) -> Result<(), Self::Error> {
        self.entered.clear();
        Ok(())
    }
    fn step(&mut self, action: usize) -> Result<Step, Self::Error> {
        assert!(self.entered.len() < self.code.len(), "stepped after the end");
        self.steps += 1;
        self.entered.push(action);
        if self.entered.len() < self.code.len() {
            return Ok(Step { reward: 0.0, end: None });
        }
        let wrong = self.entered.iter().zip(&self.code).filter(|(a, b)| a != b).count();
        let end = if wrong == 0 { End::Unsafe } else { End::Horizon };
        Ok(Step { reward: -f64::from(u32::try_from(wrong).unwrap()) * 10.0, end: Some(end) })
    }
    fn save(&self) -> Self::Snapshot {
        self.entered.clone()
    }
    fn restore(&mut self, snapshot: &Self::Snapshot) -> Result<(), Self::Error> {
        self.entered.clone_from(snapshot);
        Ok(())
    }
}

fn iterations_to_open(mut strategy: impl Strategy<Lock>, seed: u64, cap: usize) -> usize {
    let mut lock = Lock::new(&[2, 0, 3, 1], 4);
    let mut rng = Rng::new(seed);
    (1..=cap).find(|_| strategy.iterate(&mut lock, &mut rng).unwrap().end == End::Unsafe).unwrap_or(cap)
}

#[test]
fn climbs_a_slope_that_random_search_cannot_see() {
    let mean = |f: &dyn Fn(u64) -> usize| (0..100).map(f).sum::<usize>() / 100;
    let random = mean(&|s| iterations_to_open(Random, s, 2000));
    let mcts = mean(&|s| iterations_to_open(MctsDpw::new(Profile::Paper), s, 2000));
    // 4^4 = 256 sequences: random needs 256 on average, sigma of the mean about 26.
    assert!((180..340).contains(&random), "random {random}");
    assert!(mcts * 3 < random * 2, "mcts {mcts}, random {random}");
}

#[test]
fn the_first_iteration_only_inserts_the_root() {
    let mut lock = Lock::new(&[0, 0, 0], 3);
    let mut mcts = MctsDpw::new(Profile::Paper);
    mcts.iterate(&mut lock, &mut Rng::new(1)).unwrap();
    assert_eq!(mcts.nodes.len(), 1);
    assert!(mcts.nodes[0].edges.is_empty());
    mcts.iterate(&mut lock, &mut Rng::new(2)).unwrap();
    assert_eq!(mcts.nodes[0].visits, 1);
    assert_eq!(mcts.nodes[0].edges.len(), 1);
}

#[test]
fn width_follows_k_n_alpha_and_the_cap() {
    for profile in [Profile::Paper, Profile::PaperLiteral, Profile::Lee] {
        let p = profile.parameters();
        let mut lock = Lock::new(&[9; 2], 10);
        let mut mcts = MctsDpw::new(profile);
        let mut rng = Rng::new(5);
        for _ in 0..400 {
            mcts.iterate(&mut lock, &mut rng).unwrap();
            for node in &mcts.nodes {
                #[expect(clippy::cast_precision_loss, reason = "small numbers")]
                let (children, width) = (node.edges.len() as f64, p.k * libm::pow(node.visits as f64, p.alpha));
                assert!(children <= width.max(0.0) + 1.0 + 1e-9, "{children} children, width {width}");
                assert!(node.edges.len() <= 10);
            }
        }
    }
}

#[test]
fn backup_is_the_mean_of_the_returns() {
    let mut lock = Lock::new(&[1], 2);
    let mut mcts = MctsDpw::new(Profile::Paper);
    let mut rng = Rng::new(11);
    for _ in 0..50 {
        mcts.iterate(&mut lock, &mut rng).unwrap();
    }
    for edge in &mcts.nodes[0].edges {
        let expected = if edge.action == 1 { 0.0 } else { -10.0 };
        assert!((edge.mean - expected).abs() < 1e-12);
    }
    assert_eq!(mcts.nodes[0].edges.iter().map(|e| e.visits).sum::<u64>(), mcts.nodes[0].visits);
}

#[test]
fn a_restored_prefix_is_not_simulated_again() {
    let mut lock = Lock::new(&[0; 8], 2);
    let mut mcts = MctsDpw::new(Profile::Paper);
    let mut rng = Rng::new(3);
    for _ in 0..200 {
        mcts.iterate(&mut lock, &mut rng).unwrap();
    }
    assert!(lock.steps < 200 * 8, "{} steps", lock.steps);
}
