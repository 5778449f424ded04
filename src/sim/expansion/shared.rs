//! Questions of a search that several machines share out: those that are answered here, those that were answered elsewhere, and
//! those that are left to others.

use std::cell::OnceCell;
use std::hash::Hash as _;
use std::sync::atomic::Ordering;

use super::Expander;
use super::questions::{Question, instants_of};
use super::situations::Situation;
use crate::host::Plant;
use crate::human::Who;
use crate::sim::Coverage;
use crate::sim::answers::{Answer, Counted, Digest, Key, Sharing};
use crate::sim::encounter::Person;
use crate::sim::threads::shared_out;
use crate::sim::world::{Hit, Stance};

/// What is done about a question.
enum Done {
    /// It is worked out here, and kept if it has a key.
    Here(Option<Key>),
    /// It was answered: nothing is unsafe.
    Nothing(Counted),
    /// Others answer it.
    Left,
}

/// What came out of a question: for each situation what is unsafe, and what was counted.
type Out = (Vec<Option<Hit>>, Coverage);

impl<P: Plant> Expander<P> {
    /// The answers to questions of which not all are worked out here. Those that are left to others find nothing.
    pub(super) fn share_out(
        &mut self,
        questions: &[Question],
        situations: &[Situation],
        go_on: &mut dyn FnMut() -> bool,
    ) -> Option<(Vec<Vec<Option<Hit>>>, Coverage)> {
        let digests: Vec<OnceCell<Key>> = situations.iter().map(|_| OnceCell::new()).collect();
        let done: Vec<Done> = questions.iter().map(|question| self.about(question, situations, &digests)).collect();
        let here: Vec<usize> = (0..questions.len()).filter(|&q| matches!(done[q], Done::Here(_))).collect();
        let mut found = self.each(questions, &here, situations, go_on)?.into_iter();
        let sensors = self.world.cell.sensors.len();
        let (mut all, mut total) = (Vec::with_capacity(questions.len()), Coverage::new(sensors));
        for ((_, asked), done) in questions.iter().zip(done) {
            let nothing = || vec![None; asked.len()];
            let hits = match done {
                Done::Left => nothing(),
                Done::Nothing(counted) => {
                    total.merge(&counted.coverage(sensors));
                    nothing()
                }
                Done::Here(key) => {
                    let (hits, coverage) = found.next()?;
                    total.merge(&coverage);
                    if let (Some(key), Sharing::Share(share)) = (key, &mut self.journal.sharing) {
                        let unsafe_one = hits.iter().any(Option::is_some);
                        let counted = Counted::of(&coverage).filter(|_| !unsafe_one);
                        share.add(key, counted.map_or(Answer::Something, Answer::Nothing));
                    }
                    hits
                }
            };
            all.push(hits);
        }
        Some((all, total))
    }

    /// What is done about a question.
    fn about(&self, (stance, asked): &Question, situations: &[Situation], digests: &[OnceCell<Key>]) -> Done {
        // Nearly all questions are about robots out of reach, and answered as soon as they are asked.
        let own = self.world.of_stance(stance);
        let near = |s: &usize| own.near(&stance.place, &situations[*s].frames[situations[*s].i]);
        if !asked.iter().any(near) {
            return Done::Here(None);
        }
        let key = || {
            let mut digest = Digest::default();
            stance.hash(&mut digest);
            asked.iter().for_each(|s| digests[*s].get_or_init(|| situations[*s].digest()).hash(&mut digest));
            digest.key()
        };
        match &self.journal.sharing {
            Sharing::Nothing => Done::Here(None),
            Sharing::Share(share) if share.answers(&pose_of(stance)) => Done::Here(Some(key())),
            Sharing::Share(_) => Done::Left,
            Sharing::LookUp(answers) => match answers.get(&key()) {
                Some(Answer::Nothing(counted)) => Done::Nothing(counted),
                Some(Answer::Something) | None => Done::Here(None),
            },
        }
    }

    /// The answers to those of the questions that `here` names, on all threads, each with what was counted for it.
    fn each(
        &self,
        questions: &[Question],
        here: &[usize],
        situations: &[Situation],
        go_on: &mut dyn FnMut() -> bool,
    ) -> Option<Vec<Out>> {
        let (world, sensors) = (&self.world, self.world.cell.sensors.len());
        let found = shared_out(self.workers, here.len(), go_on, |numbers, stopped| {
            let mut answers: Vec<Out> = Vec::with_capacity(numbers.len());
            let mut last: Option<(&Stance, Option<Person>)> = None;
            for &question in &here[numbers] {
                let (stance, asked) = &questions[question];
                let mut posed = last.take().filter(|(known, _)| known.poses_as(stance)).and_then(|(_, posed)| posed);
                let (mut instants, mut coverage) = (instants_of(asked, situations), Coverage::new(sensors));
                let Ok(hits) = world.of_stance(stance).contacts(stance, &mut posed, &mut instants, &mut coverage);
                last = Some((stance, posed));
                // What was under way then says nothing.
                if world.stop().is_due() {
                    stopped.store(true, Ordering::Relaxed);
                    break;
                }
                answers.push((hits, coverage));
            }
            answers
        })?;
        Some(found.into_iter().flatten().collect())
    }
}

/// What decides who answers a question: where the person stands, and how. Questions of one pose follow each other and share much of their
/// work.
fn pose_of(stance: &Stance) -> Key {
    let mut digest = Digest::default();
    (stance.place, stance.posture).hash(&mut digest);
    if stance.who != Who::First {
        stance.who.hash(&mut digest);
    }
    digest.key()
}
