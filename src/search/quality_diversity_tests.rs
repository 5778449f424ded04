//! The archive on a corridor whose end is only reached by going away from the danger.

use super::*;
use crate::search::{End, Ending, Random, Step};

/// A token on a line starts at 0 and moves by -1, 0 or 1 (the first factor), with a colour (the second). Danger grows
/// to the right until 3, a dead end; unsafe is only field -6 with colour 1.
struct Corridor {
    taken: Vec<usize>,
    steps: usize,
}

impl Corridor {
    const LENGTH: usize = 8;

    const fn new() -> Self {
        Self { taken: Vec::new(), steps: 0 }
    }

    fn field(&self) -> i64 {
        self.taken.iter().fold(0, |at, a| (at + [-1, 0, 1][a / 2]).min(3))
    }
}

impl Environment for Corridor {
    type Snapshot = Vec<usize>;
    type Error = std::convert::Infallible;
    fn actions(&self) -> usize {
        6
    }
    fn factors(&self) -> [usize; 2] {
        [3, 2]
    }
    fn ending(&self) -> Option<Ending> {
        let field = self.field();
        let danger = if self.is_unsafe() { 10.0 } else { f64::from(i32::try_from(field).unwrap()) };
        Some(Ending { niche: Niche([field, 0, 0, 0, 0]), danger })
    }
    fn horizon(&self) -> usize {
        Self::LENGTH
    }
    fn reset(&mut self) -> Result<(), Self::Error> {
        self.taken.clear();
        Ok(())
    }
    fn step(&mut self, action: usize) -> Result<Step, Self::Error> {
        assert!(self.taken.len() < Self::LENGTH && !self.is_unsafe(), "stepped after the end");
        self.steps += 1;
        self.taken.push(action);
        let end = match () {
            () if self.is_unsafe() => Some(End::Unsafe),
            () if self.taken.len() == Self::LENGTH => Some(End::Horizon),
            () => None,
        };
        Ok(Step { reward: if end == Some(End::Horizon) { -1.0 } else { 0.0 }, end })
    }
    fn save(&self) -> Self::Snapshot {
        self.taken.clone()
    }
    fn restore(&mut self, snapshot: &Self::Snapshot) -> Result<(), Self::Error> {
        self.taken.clone_from(snapshot);
        Ok(())
    }
}

impl Corridor {
    fn is_unsafe(&self) -> bool {
        self.field() == -6 && self.taken.last().is_some_and(|a| a % 2 == 1)
    }
}

fn iterations_to_hit(mut strategy: impl Strategy<Corridor>, seed: u64) -> usize {
    let (mut corridor, mut rng) = (Corridor::new(), Rng::new(seed));
    let mut hit = || strategy.iterate(&mut corridor, &mut rng).unwrap().end == End::Unsafe;
    (1..=2000).find(|_| hit()).unwrap_or(2000)
}

#[test]
fn finds_what_lies_away_from_the_danger_sooner_than_random_search() {
    let mean = |f: &dyn Fn(u64) -> usize| (0..40).map(f).sum::<usize>() / 40;
    let random = mean(&|s| iterations_to_hit(Random, s));
    let varied = mean(&|s| iterations_to_hit(QualityDiversity::default(), s));
    assert!(varied * 4 < random * 3, "quality diversity {varied}, random {random}");
}

#[test]
fn an_elite_is_the_most_dangerous_of_its_niche() {
    let (mut corridor, mut rng) = (Corridor::new(), Rng::new(2));
    let mut strategy = QualityDiversity::default();
    for _ in 0..200 {
        strategy.iterate(&mut corridor, &mut rng).unwrap();
    }
    // Fields from -8 to 3 can be ended on; every one met holds its own danger.
    assert!(strategy.archive().len() >= 8, "{}", strategy.archive().len());
    for field in -5..=3 {
        let danger = strategy.archive().danger(Niche([field, 0, 0, 0, 0]));
        assert!(danger.is_none_or(|d| (d - f64::from(i32::try_from(field).unwrap())).abs() < 1e-12));
    }
}

#[test]
fn variations_stay_within_the_actions_and_are_new_as_long_as_there_are_any() {
    let (mut corridor, mut rng) = (Corridor::new(), Rng::new(3));
    let (mut archive, mut trodden) = (Archive::default(), Trodden::default());
    let mut known = 0;
    for _ in 0..300 {
        let actions = archive.propose(&corridor, &trodden, &mut rng);
        assert!(actions.len() == Corridor::LENGTH && actions.iter().all(|a| *a < 6), "{actions:?}");
        known += usize::from(trodden.is_known(&actions));
        archive.observe(&trodden.follow(&mut corridor, &actions, &mut rng).unwrap());
    }
    assert!(known <= 3, "{known} of 300 known");
    // Known beginnings were restored instead of simulated again.
    assert!(corridor.steps < 250 * Corridor::LENGTH, "{} steps", corridor.steps);
}
