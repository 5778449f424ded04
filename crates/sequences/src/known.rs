//! Questions of a search whose answers are kept: many together where one machine goes on with it, each by itself where
//! several share it out. Those that were answered before are looked up; what was found is worked out again, for what it
//! is. Those of other shares are left out: taken for harmless, they lead to every state that the whole search comes to,
//! and to some more.

use std::hash::{Hash as _, Hasher as _};

use super::Expander;
use super::questions::{ContactQuestion, Out, instants_of};
use super::situations::Situation;
use crate::host::Plant;
use crate::sim::Coverage;
use crate::sim::answers::{Digest, Key};
use crate::sim::world::{Hit, PersonState};

/// What is done about a question.
enum Done {
    /// It is worked out here, and kept if it has a key.
    Here(Option<Key>),
    /// It was answered: nothing is unsafe, and this was counted.
    Nothing(Coverage),
    /// Others answer it.
    Left,
}

impl<P: Plant> Expander<P> {
    /// The answers to so many questions, which are known together or not at all.
    pub(super) fn remember(
        &self,
        count: u64,
        questions: &[ContactQuestion],
        situations: &[Situation],
        go_on: &mut dyn FnMut() -> bool,
    ) -> Option<Out> {
        let key = key_of(questions, situations);
        if let Some((found, coverage)) = self.answers.get::<Vec<u32>>(&key, count) {
            let all = self.found_again(&found, questions, situations);
            // A search that had to end may have missed what is there.
            return (!self.world.stop().is_due()).then_some((all, coverage));
        }
        let (all, coverage) = self.work_out_all(questions, situations, go_on)?;
        self.answers.keep(&key, &found_something(&all), &coverage);
        Some((all, coverage))
    }

    /// The answers to questions of which is known which of them find something.
    fn found_again(
        &self,
        found: &[u32],
        questions: &[ContactQuestion],
        situations: &[Situation],
    ) -> Vec<Vec<Option<Hit>>> {
        let mut all: Vec<Vec<Option<Hit>>> = questions.iter().map(|(_, asked)| vec![None; asked.len()]).collect();
        let mut counted = Coverage::new(self.world.cell.sensors.len());
        for number in found.iter().map(|number| *number as usize) {
            let Some((stance, asked)) = questions.get(number) else { continue };
            // All of the stance, as before: what is found for one may follow from what was found for another.
            let mut instants = instants_of(asked, situations);
            let Ok(hits) = self.world.of_person_state(stance).contacts(stance, &mut None, &mut instants, &mut counted);
            all[number] = hits;
        }
        all
    }

    /// The answers to questions of which not all are worked out here. Those that are left to others find nothing.
    pub(super) fn share_out(
        &self,
        questions: &[ContactQuestion],
        situations: &[Situation],
        go_on: &mut dyn FnMut() -> bool,
    ) -> Option<Out> {
        let done: Vec<Done> = questions.iter().map(|question| self.about(question, situations)).collect();
        let here = questions.iter().zip(&done).filter(|(_, done)| matches!(done, Done::Here(_)));
        let here: Vec<&ContactQuestion> = here.map(|(question, _)| question).collect();
        let mut worked_out = self.work_out(&here, true, situations, go_on)?.into_iter();
        let (mut all, mut total) = (Vec::with_capacity(questions.len()), Coverage::new(self.world.cell.sensors.len()));
        for ((_, asked), done) in questions.iter().zip(done) {
            match done {
                Done::Left => all.push(vec![None; asked.len()]),
                Done::Nothing(coverage) => {
                    total.merge(&coverage);
                    all.push(vec![None; asked.len()]);
                }
                Done::Here(key) => {
                    let (hits, coverage) = worked_out.next()?;
                    total.merge(&coverage);
                    if let Some(key) = key {
                        self.answers.keep(&key, &found_something(&hits), &coverage);
                    }
                    all.extend(hits);
                }
            }
        }
        Some((all, total))
    }

    /// What is done about a question.
    fn about(&self, question: &ContactQuestion, situations: &[Situation]) -> Done {
        let (stance, asked) = question;
        // Nearly all questions are about robots out of reach, and answered as soon as they are asked.
        let own = self.world.of_person_state(stance);
        let near = |s: &usize| own.near(&stance.place, &situations[*s].frames[situations[*s].i]);
        if !asked.iter().any(near) {
            return Done::Here(None);
        }
        if self.answers.share().is_some_and(|share| !share.owns(&pose_of(stance))) {
            return Done::Left;
        }
        let key = key_of(std::slice::from_ref(question), situations);
        match self.answers.get::<Vec<u32>>(&key, 1) {
            Some((found, coverage)) if found.is_empty() => Done::Nothing(coverage),
            _ => Done::Here(Some(key)),
        }
    }
}

/// What answers to these questions follow from: how the person stands, and where and how fast the robots are.
fn key_of(questions: &[ContactQuestion], situations: &[Situation]) -> Key {
    let mut digest = Digest::default();
    for (stance, asked) in questions {
        (stance, asked.len()).hash(&mut digest);
        asked.iter().for_each(|s| digest.write(situations[*s].key()));
    }
    digest.key()
}

/// What decides who answers a question: where the person stands, and how. Questions of one pose follow each other and
/// share much of their work.
fn pose_of(stance: &PersonState) -> Key {
    let mut digest = Digest::default();
    (stance.who, stance.place, stance.posture).hash(&mut digest);
    digest.key()
}

/// The numbers of the questions that find something.
fn found_something(answers: &[Vec<Option<Hit>>]) -> Vec<u32> {
    (0..).zip(answers).filter(|(_, hits)| hits.iter().any(Option::is_some)).map(|(number, _)| number).collect()
}
