//! The turns of the hybrid search, on the puzzle of the planning tests.

use super::*;
use crate::End;
use crate::plan::tests::Guarded;

#[test]
fn every_fifth_episode_is_random_and_said_to_be() {
    let (mut guarded, mut rng) = (Guarded::new(), Rng::new(1));
    let mut hybrid = Hybrid::default();
    let (mut hits, mut random_hits) = (0, 0);
    for i in 1..=200_u64 {
        let iteration = hybrid.iterate(&mut guarded, &mut rng).unwrap();
        assert_eq!(iteration.random, i % 5 == 0);
        let hit = u64::from(iteration.end == End::Unsafe);
        hits += hit;
        random_hits += if iteration.random { hit } else { 0 };
    }
    assert!(hits > 2 * random_hits, "{hits} {random_hits}");
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
