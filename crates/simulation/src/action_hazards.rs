//! What befalls people in one action, from what befalls each alone: for all of them it is over for force, pressure and head when one
//! of them is hit; from then on clamping alone is told, of everybody.

use crate::hazard::{Class, Finding};

/// What one of the people meets in an action, as if they were alone, in the order of time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PersonCourse {
    /// What does not end the action, until something does.
    passing: Vec<Finding>,
    /// The first hazard by contact, if none came before the action.
    end: Option<Box<Finding>>,
    /// Clampings from then on, the same instant included; all of the action where a hazard by contact came before it.
    clampings: Vec<Finding>,
}

impl PersonCourse {
    /// Takes in what was met at an instant, where nothing by contact came before it: with a hazard by contact also the worst
    /// clamping of that instant.
    pub fn meets(&mut self, finding: Finding, clamping: Option<Finding>) {
        if finding.class.ends() {
            self.end = Some(Box::new(finding));
            self.clampings.extend(clamping);
        } else {
            self.passing.push(finding);
        }
    }

    /// Takes in a clamping behind a hazard by contact.
    pub fn is_clamped(&mut self, finding: Finding) {
        self.clampings.push(finding);
    }

    /// The same with these actions for all that was met.
    pub(super) fn each(mut self, with: impl Fn(Finding) -> Finding) -> Self {
        let all = |list: Vec<Finding>| list.into_iter().map(&with).collect();
        self.passing = all(self.passing);
        self.clampings = all(self.clampings);
        self.end = self.end.map(|end| Box::new(with(*end)));
        self
    }
}

/// What is told of an action.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ActionHazards {
    /// The first hazards by contact, all at the same step, the first person's first.
    pub ends: Vec<Finding>,
    /// Of those who are not hit, the worst that does not end the action, until something does.
    pub noted: Vec<Finding>,
    /// Clampings behind a hazard by contact, in this action or before it; and whether one is told with the end already, which is a
    /// clamping of the same instant.
    pub clampings: Vec<(Finding, bool)>,
}

impl ActionHazards {
    /// From what each person meets alone.
    pub fn of<'a>(each: impl Iterator<Item = &'a PersonCourse> + Clone) -> Self {
        let ends_at = each.clone().filter_map(|course| course.end.as_ref()).map(|end| end.step).min();
        let mut all = Self::default();
        for PersonCourse { passing, end, clampings } in each {
            let own = end.as_deref().filter(|end| Some(end.step) == ends_at);
            match own {
                Some(own) => all.ends.push(own.clone()),
                None => {
                    let in_time = |finding: &&Finding| ends_at.is_none_or(|at| finding.step <= at);
                    let worst = passing
                        .iter()
                        .filter(in_time)
                        .reduce(|known, other| if known.outweighs(other) { known } else { other });
                    all.noted.extend(worst.cloned());
                }
            }
            all.clampings.extend(clampings.iter().map(|finding| (finding.clone(), is_told(finding, own))));
        }
        all
    }
}

/// Whether a clamping is told with the hazard that ends the action.
pub fn is_told(clamping: &Finding, end: Option<&Finding>) -> bool {
    let no_worse = |end: &Finding| clamping.contact.ratio() <= end.contact.ratio();
    end.is_some_and(|end| end.step == clamping.step && end.class == Class::Clamping && no_worse(end))
}

#[cfg(test)]
#[path = "action_hazards_tests.rs"]
mod tests;
