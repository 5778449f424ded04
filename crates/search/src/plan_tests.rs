//! Planning on a puzzle where imagination is right until a lever is pulled.

use super::*;
use crate::{Random, Step};

/// A token on a ring of 12 fields moves by 0, 1 or -1. A guard walks one field on in each step. They must not meet,
/// but on even fields only. On field 4 lies a lever: from then on the guard stands still.
pub(crate) struct Guarded {
    taken: Vec<usize>,
    steps: usize,
    imagined: usize,
    /// What is left of what imagining may cost, and what it costs.
    budget: u64,
    costs: u64,
    /// Guard's fields of the episodes seen, by the step at which the lever was pulled.
    seen: BTreeMap<usize, Vec<i64>>,
}

const FIELDS: i64 = 12;
const LENGTH: usize = 8;

impl Guarded {
    pub(crate) const fn new() -> Self {
        Self { taken: Vec::new(), steps: 0, imagined: 0, budget: u64::MAX, costs: 1, seen: BTreeMap::new() }
    }

    fn fields(actions: &[usize]) -> Vec<i64> {
        let mut at = 0;
        actions
            .iter()
            .map(|a| [0, 1, -1][*a])
            .map(|by| {
                at = (at + by + FIELDS) % FIELDS;
                at
            })
            .collect()
    }

    fn pulled(fields: &[i64]) -> usize {
        fields.iter().position(|f| *f == 4).unwrap_or(usize::MAX)
    }

    fn guard(pulled: usize, steps: usize) -> Vec<i64> {
        (0..steps).map(|i| (3 + i64::try_from(i.min(pulled)).unwrap()) % FIELDS).collect()
    }

    fn meets(field: i64, guard: i64) -> bool {
        field == guard && field % 2 == 0
    }

    fn is_unsafe(&self) -> bool {
        let fields = Self::fields(&self.taken);
        let guard = Self::guard(Self::pulled(&fields), fields.len());
        fields.last().zip(guard.last()).is_some_and(|(f, g)| Self::meets(*f, *g))
    }
}

impl Environment for Guarded {
    type Snapshot = Vec<usize>;
    type Error = std::convert::Infallible;
    fn actions(&self) -> usize {
        3
    }
    fn horizon(&self) -> usize {
        LENGTH
    }
    fn reset(&mut self) -> Result<(), Self::Error> {
        self.taken.clear();
        Ok(())
    }
    fn step(&mut self, action: usize) -> Result<Step, Self::Error> {
        assert!(self.taken.len() < LENGTH && !self.is_unsafe(), "stepped after the end");
        self.steps += 1;
        self.taken.push(action);
        let end = match () {
            () if self.is_unsafe() => Some(End::Unsafe),
            () if self.taken.len() == LENGTH => Some(End::Horizon),
            () => None,
        };
        if end.is_some() {
            let pulled = Self::pulled(&Self::fields(&self.taken));
            let guard = Self::guard(pulled, self.taken.len());
            let seen = self.seen.entry(pulled).or_default();
            if guard.len() > seen.len() {
                *seen = guard;
            }
        }
        Ok(Step { reward: 0.0, end })
    }
    fn save(&self) -> Self::Snapshot {
        self.taken.clone()
    }
    fn restore(&mut self, snapshot: &Self::Snapshot) -> Result<(), Self::Error> {
        self.taken.clone_from(snapshot);
        Ok(())
    }
}

impl SurrogateModel for Guarded {
    fn calm(&self) -> usize {
        0
    }
    fn begin_imagining(&mut self, budget: u64) {
        self.budget = budget;
    }
    fn is_over_budget(&self) -> bool {
        self.budget == 0
    }
    fn imagine(&mut self, actions: &[usize]) -> Rollout {
        self.imagined += 1;
        self.budget = self.budget.saturating_sub(self.costs);
        if self.is_over_budget() {
            return Rollout::default();
        }
        let fields = Self::fields(actions);
        let pulled = Self::pulled(&fields);
        let exact = self.seen.get(&pulled).is_some_and(|guard| guard.len() == actions.len());
        let calm = Vec::new();
        let guard = self.seen.get(&pulled).or_else(|| self.seen.get(&usize::MAX)).unwrap_or(&calm);
        let meets = fields.iter().zip(guard).position(|(f, g)| Self::meets(*f, *g));
        let vision =
            |i: usize| PredictedHazard { actions: actions[..=i].to_vec(), niche: EndingKind([fields[i], 0, 0, 0, 0]) };
        Rollout { visions: meets.into_iter().map(vision).collect(), exact }
    }
}

fn hits(strategy: &mut impl Strategy<Guarded>, seed: u64, iterations: usize) -> (Vec<bool>, Guarded) {
    let (mut guarded, mut rng) = (Guarded::new(), Rng::new(seed));
    let mut hit = |_| strategy.iterate(&mut guarded, &mut rng).unwrap().end == End::Unsafe;
    let hits = (0..iterations).map(&mut hit).collect();
    (hits, guarded)
}

#[test]
fn stands_still_first_and_meets_the_guard_in_the_second_episode() {
    for seed in 0..20 {
        let (hits, guarded) = hits(&mut Plan::default(), seed, 2);
        // Nobody comes along field 0 within eight steps; what was seen then holds for everyone who leaves the lever.
        assert_eq!(hits, [false, true], "seed {seed}");
        assert!(guarded.imagined > 0 && guarded.steps <= 2 * LENGTH);
    }
}

#[test]
fn needs_far_fewer_episodes_than_random_search() {
    let first = |hits: Vec<bool>| hits.iter().position(|h| *h).unwrap_or(400);
    let random: usize = (0..20).map(|s| first(hits(&mut Random, s, 400).0)).sum();
    let plan: usize = (0..20).map(|s| first(hits(&mut Plan::default(), s, 400).0)).sum();
    assert!(plan * 3 < random, "plan {plan}, random {random}");
}

#[test]
fn promises_of_a_new_kind_come_first_and_nothing_is_run_twice() {
    let (mut guarded, mut rng) = (Guarded::new(), Rng::new(7));
    let (mut planner, mut trodden) = (Planner::default(), EpisodeTree::default());
    let mut promised = Vec::new();
    for _ in 0..40 {
        let proposal = planner.propose(&mut guarded, &trodden, &mut rng);
        assert!(!trodden.is_known(proposal.actions()), "{proposal:?}");
        if let Proposal::Promising(_, times) = proposal {
            promised.push(times);
        }
        trodden.follow(&mut guarded, proposal.actions(), &mut rng).unwrap();
    }
    let new = promised.iter().take_while(|times| **times == 0).count();
    assert!(new >= 2, "{promised:?}");
    assert!(promised.len() > 20, "{promised:?}");
}

#[test]
fn who_cannot_afford_to_imagine_runs_something_new_all_the_same() {
    let (mut guarded, mut rng) = (Guarded { costs: ROLLOUT_BUDGET, ..Guarded::new() }, Rng::new(3));
    let (mut planner, mut trodden) = (Planner::default(), EpisodeTree::default());
    for k in 0..20 {
        let proposal = planner.propose(&mut guarded, &trodden, &mut rng);
        // One sequence each time but the first.
        assert_eq!(guarded.imagined, k);
        assert!(k == 0 || matches!(proposal, Proposal::Unknown(_)), "{proposal:?}");
        trodden.follow(&mut guarded, proposal.actions(), &mut rng).unwrap();
    }
}
