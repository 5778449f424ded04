//! MAP-Elites: an archive of the most dangerous sequence of each kind of ending, and variations of its members.
//!
//! What makes endings the same kind is the environment's ([`Niche`]). Danger alone deceives: the way to a hazard may lead
//! away from where danger grows. An archive keeps a sequence for each kind, however harmless, so no way is given up.

use std::collections::BTreeMap;

use super::episode::{Episode, Trodden, random_sequence};
use super::{Environment, Iteration, Niche, Rng, Strategy};

/// Of so many iterations one is random, so that the archive does not only breed from itself.
const ONE_RANDOM_OF: usize = 5;

/// Variations tried for one that is not known yet.
const ATTEMPTS: usize = 20;

/// The best sequence of a niche.
#[derive(Clone, Debug)]
struct Elite {
    actions: Vec<usize>,
    danger: f64,
}

/// The most dangerous sequence of each niche.
#[derive(Clone, Debug, Default)]
pub struct Archive {
    elites: BTreeMap<Niche, Elite>,
}

impl Archive {
    /// Number of niches met.
    #[must_use]
    pub fn len(&self) -> usize {
        self.elites.len()
    }

    /// Whether none was met yet.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.elites.is_empty()
    }

    /// Danger of the elite of a niche.
    #[must_use]
    pub fn danger(&self, niche: Niche) -> Option<f64> {
        self.elites.get(&niche).map(|elite| elite.danger)
    }

    /// Takes in an episode. Of equals the later stays: the archive then drifts instead of standing still.
    pub fn observe(&mut self, episode: &Episode) {
        let Some(ending) = episode.ending else { return };
        let elite = Elite { actions: episode.actions.clone(), danger: ending.danger };
        let kept = self.elites.entry(ending.niche).or_insert_with(|| elite.clone());
        if elite.danger >= kept.danger {
            *kept = elite;
        }
    }

    /// A sequence to try: random, or a variation of an elite; one that is not known, if that is soon found.
    pub fn propose<E: Environment>(
        &self,
        environment: &E,
        trodden: &Trodden<E::Snapshot>,
        rng: &mut Rng,
    ) -> Vec<usize> {
        let mut proposal = random_sequence(environment, rng);
        if self.elites.is_empty() || rng.below(ONE_RANDOM_OF) == 0 {
            return proposal;
        }
        for _ in 0..ATTEMPTS {
            proposal = self.vary(environment, rng);
            if !trodden.is_known(&proposal) {
                break;
            }
        }
        proposal
    }

    fn any<'a>(&'a self, rng: &mut Rng) -> &'a [usize] {
        let number = rng.below(self.elites.len());
        self.elites.values().nth(number).map_or(&[], |elite| &elite.actions)
    }

    /// One of four variations of a random elite; what an elite that ended early lacks is random.
    fn vary<E: Environment>(&self, environment: &E, rng: &mut Rng) -> Vec<usize> {
        let elite = self.any(rng);
        let mut varied = random_sequence(environment, rng);
        let length = elite.len().min(varied.len());
        let at = rng.below(length.max(1));
        let random = varied.clone();
        varied[..length].copy_from_slice(&elite[..length]);
        match rng.below(4) {
            // Another action.
            0 => varied[at] = random[at],
            // Another end.
            1 => varied[at..].copy_from_slice(&random[at..]),
            // The end of another elite.
            2 => {
                let other = self.any(rng);
                let until = other.len().min(varied.len());
                if at < until {
                    varied[at..until].copy_from_slice(&other[at..until]);
                }
            }
            // The same with another choice in one of the two factors of an action.
            _ => {
                let [first, second] = environment.factors();
                let (a, b) = (varied[at] / second, varied[at] % second);
                varied[at] = if second == 1 || (first > 1 && rng.below(2) == 0) {
                    rng.below(first) * second + b
                } else {
                    a * second + rng.below(second)
                };
            }
        }
        varied
    }
}

/// The strategy.
#[derive(Clone, Debug)]
pub struct QualityDiversity<S> {
    archive: Archive,
    trodden: Trodden<S>,
}

impl<S> Default for QualityDiversity<S> {
    fn default() -> Self {
        Self { archive: Archive::default(), trodden: Trodden::default() }
    }
}

impl<S> QualityDiversity<S> {
    /// What it keeps.
    #[must_use]
    pub const fn archive(&self) -> &Archive {
        &self.archive
    }
}

impl<E: Environment> Strategy<E> for QualityDiversity<E::Snapshot> {
    fn name(&self) -> &'static str {
        "quality-diversity"
    }

    fn iterate(&mut self, environment: &mut E, rng: &mut Rng) -> Result<Iteration, E::Error> {
        let actions = self.archive.propose(environment, &self.trodden, rng);
        let episode = self.trodden.follow(environment, &actions, rng)?;
        self.archive.observe(&episode);
        Ok(episode.iteration)
    }
}

#[cfg(test)]
#[path = "quality_diversity_tests.rs"]
mod tests;
