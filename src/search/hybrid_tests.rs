//! The turns of the hybrid search, on the puzzle of the planning tests.

use super::*;
use crate::search::plan::tests::Guarded;

#[test]
fn every_fifth_episode_is_random_and_counted_apart() {
    let (mut guarded, mut rng) = (Guarded::new(), Rng::new(1));
    let mut hybrid = Hybrid::default();
    let mut hits = 0;
    for i in 1..=200_u64 {
        let before = Strategy::<Guarded>::random_share(&hybrid).unwrap();
        let hit = hybrid.iterate(&mut guarded, &mut rng).unwrap().end == End::Unsafe;
        let after = Strategy::<Guarded>::random_share(&hybrid).unwrap();
        let random = i % 5 == 0;
        assert_eq!(after.random_iterations - before.random_iterations, u64::from(random));
        assert_eq!(after.random_hits - before.random_hits, u64::from(random && hit));
        hits += u64::from(hit);
    }
    let share = Strategy::<Guarded>::random_share(&hybrid).unwrap();
    assert_eq!(share.random_iterations, 40);
    assert!(hits > 2 * share.random_hits, "{hits} {share:?}");
}

#[test]
fn begins_as_planning_does() {
    for seed in 0..10 {
        let (mut guarded, mut rng) = (Guarded::new(), Rng::new(seed));
        let mut hybrid = Hybrid::default();
        let ends = [0; 2].map(|_| hybrid.iterate(&mut guarded, &mut rng).unwrap().end);
        assert_eq!(ends, [End::Horizon, End::Unsafe], "seed {seed}");
    }
}
