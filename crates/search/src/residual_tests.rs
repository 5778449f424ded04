//! The bounds where the truth is known: groups that are met with given probabilities.

use super::*;
use crate::Rng;

/// Chances out of `OF`; what is left is harmless.
const OF: usize = 1_000_000;

/// Many rare groups and few frequent ones: chance `60_000 / i^1.5`, in all 0.152.
fn chances() -> Vec<usize> {
    (1..=400_u32)
        .map(|i| {
            let chance = 60_000.0 / (f64::from(i) * f64::from(i).sqrt());
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 7 and 60 000")]
            let chance = chance as usize;
            chance
        })
        .collect()
}

fn draw(chances: &[usize], rng: &mut Rng) -> Option<usize> {
    let mut left = rng.below(OF);
    chances.iter().position(|&chance| {
        let here = left < chance;
        left = left.wrapping_sub(chance);
        here
    })
}

fn mass<'a>(chances: impl Iterator<Item = &'a usize>) -> f64 {
    chances.sum::<usize>() as f64 / OF as f64
}

#[test]
fn bounds_hold_as_often_as_they_say_whoever_lengthened_the_list() {
    let chances = chances();
    let share = mass(chances.iter());
    // Besides random sequences, a guided search may meet a group in every turn: here the most frequent one that is still
    // missing, so that the list depends on what was met.
    for (guided, sequences) in [(false, 320), (true, 320), (false, 64), (true, 64)] {
        let searches = 2000;
        let (mut within, mut below, mut unlisted, mut bounds, mut missing, mut estimates) = (0, 0, 0, 0.0, 0.0, 0.0);
        for seed in 0..searches {
            let mut rng = Rng::new(seed);
            let mut sample = RandomSample::default();
            let (mut list, mut by_random) = (BTreeSet::new(), BTreeSet::new());
            for i in 0..sequences {
                if i == sequences / 4 {
                    sample.check_against(list.clone());
                }
                if guided {
                    list.extend((0..chances.len()).find(|group| !list.contains(group)));
                }
                let met = draw(&chances, &mut rng);
                list.extend(met);
                by_random.extend(met);
                sample.observe(met.map_or(SampleEnd::Nothing, SampleEnd::Group));
            }
            let figures = sample.figures().unwrap();
            let not_on = |list: &BTreeSet<usize>| {
                mass(chances.iter().enumerate().filter(|(group, _)| !list.contains(group)).map(|(_, chance)| chance))
            };
            within += u64::from(figures.share.low <= share && share <= figures.share.high);
            below += u64::from(share <= figures.share_below);
            unlisted += u64::from(not_on(&list) <= figures.unlisted_below);
            bounds += figures.unlisted_below;
            missing += not_on(&by_random);
            estimates += figures.good_turing;
        }
        // Bounds may hold more often than 95 %; 1.5 % are three standard deviations of the number of searches.
        let at_least = searches * 935 / 1000;
        let case = format!("{guided} {sequences}: {within} {below} {unlisted} of {searches}");
        assert!(within >= at_least && below >= at_least && unlisted >= at_least, "{case}");
        let mean = |sum: f64| sum / searches as f64;
        // Good's estimate is right on average, and the bound says something.
        assert!((mean(estimates) / mean(missing) - 1.0).abs() < 0.05, "{} {}", mean(estimates), mean(missing));
        assert!(mean(bounds) < if sequences == 320 { 0.1 } else { 0.25 }, "{case}: {}", mean(bounds));
    }
}

#[test]
fn figures_by_hand() {
    let mut sample = RandomSample::default();
    assert_eq!(sample.figures(), None);
    [SampleEnd::Group("a"), SampleEnd::Nothing, SampleEnd::Group("b"), SampleEnd::Group("a")]
        .into_iter()
        .for_each(|m| sample.observe(m));
    sample.check_against(BTreeSet::from(["a", "b", "found otherwise"]));
    for met in [
        SampleEnd::Group("found otherwise"),
        SampleEnd::Nothing,
        SampleEnd::Group("new"),
        SampleEnd::Nothing,
        SampleEnd::Unknown,
        SampleEnd::Nothing,
    ] {
        sample.observe(met);
    }
    let f = sample.figures().unwrap();
    assert_eq!((f.sequences, f.hazardous, f.not_evaluated), (10, 5, 1));
    assert_eq!((f.checked, f.unlisted), (6, 2), "what is not known counts as the worse");
    // "b", "found otherwise" and "new" were met by one random sequence each.
    assert!((f.good_turing - 0.3).abs() < 1e-15);
    assert_eq!(f.share.low.to_bits(), clopper_pearson(5, 10).low.to_bits());
    assert_eq!(f.share.high.to_bits(), clopper_pearson(6, 10).high.to_bits());
    assert_eq!(f.share_below.to_bits(), binomial_upper(6, 10, ALPHA).to_bits());
}
