//! What befalls two people in one action, from what befalls each alone: it is over for both when one of them is hit.

use crate::hazard::Finding;

/// What is told of an action.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Befallen {
    /// Those with which it ends, all at the same step, the first person's first.
    pub(super) ends: Vec<Finding>,
    /// Of those who are not hit, the worst with which it does not end, until it does.
    pub(super) noted: Vec<Finding>,
}

impl Befallen {
    /// From the findings of each person alone, in the order of time: what ends the action comes last.
    pub(super) fn of<'a>(each: impl Iterator<Item = &'a [Finding]> + Clone) -> Self {
        let own_end = |met: &'a [Finding]| met.last().filter(|finding| finding.class.ends());
        let ends_at = each.clone().filter_map(own_end).map(|finding| finding.step).min();
        let mut all = Self::default();
        for met in each {
            match (own_end(met), ends_at) {
                (Some(own), Some(step)) if own.step == step => all.ends.push(own.clone()),
                _ => {
                    let in_time =
                        |finding: &&Finding| !finding.class.ends() && ends_at.is_none_or(|at| finding.step <= at);
                    let worst = met
                        .iter()
                        .filter(in_time)
                        .reduce(|known, other| if known.outweighs(other) { known } else { other });
                    all.noted.extend(worst.cloned());
                }
            }
        }
        all
    }
}
