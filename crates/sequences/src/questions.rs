//! Whether the person, so placed, can touch the robots, so placed: each question once, the answers worked out on all
//! threads.

use std::collections::BTreeMap;
use std::sync::atomic::Ordering;

use super::situations::Situation;
use super::{Expander, Pending, Transition};
use crate::host::Plant;
use crate::human::walk::WalkTrace;
use crate::sim::Coverage;
use crate::sim::encounter::Person;
use crate::sim::threads::shared_out;
use crate::sim::world::{Hit, Instant, Occupant, PersonState};

/// A stance, and the numbers of the situations that it is asked about.
pub(super) type ContactQuestion = (PersonState, Vec<usize>);

/// What came out of questions: for each, and each of its situations, what is unsafe; and what was counted for all.
pub(super) type Out = (Vec<Vec<Option<Hit>>>, Coverage);

impl<P: Plant> Expander<P> {
    /// What pending actions ask about after step `i`, each question once: stances, and the situations that each is asked
    /// about. And for each pending action where its answer will be: the number of the stance, and of the situation among those of it.
    pub(super) fn to_ask<'a>(
        &self,
        (depth, i): (usize, usize),
        asked: Vec<Option<usize>>,
        pending: &[Pending],
        transitions: &[Vec<Transition>],
        walked: &dyn Fn(&Pending) -> &'a WalkTrace,
    ) -> (Vec<ContactQuestion>, Vec<Option<(usize, usize)>>) {
        let mut numbers: BTreeMap<&[usize], usize> = BTreeMap::new();
        let mut all: Vec<_> = Vec::new();
        for ((number, p), situation) in pending.iter().enumerate().zip(asked) {
            let Some(situation) = situation else { continue };
            let sensed = &transitions[p.state][p.transition].sensed;
            let next = numbers.len();
            let broken = *numbers.entry(&sensed.broken[i]).or_insert(next);
            let (walked, posture) = (walked(p), p.action.posture());
            all.push((
                (p.who, walked.places[i], posture, Occupant::moved(walked, i), broken, p.struck),
                situation,
                number,
            ));
        }
        all.sort_unstable();
        let mut questions: Vec<ContactQuestion> = Vec::new();
        let mut places = vec![None; pending.len()];
        for alike in all.chunk_by(|a, b| a.0 == b.0) {
            let p = &pending[alike[0].2];
            let own = self.world.of(p.who).unwrap_or(&self.world.first);
            let sensed = &transitions[p.state][p.transition].sensed;
            let stance = own.stance(walked(p), (depth, i), p.action.posture(), sensed);
            let mut situations: Vec<usize> = Vec::new();
            for (_, situation, number) in alike {
                if situations.last() != Some(situation) {
                    situations.push(*situation);
                }
                places[*number] = Some((questions.len(), situations.len() - 1));
            }
            questions.push((PersonState { struck: p.struck, ..stance }, situations));
        }
        (questions, places)
    }

    /// Answers all questions: each stance with the situations it is asked about.
    pub(super) fn answer(
        &mut self,
        questions: &[ContactQuestion],
        situations: &[Situation],
        go_on: &mut dyn FnMut() -> bool,
    ) -> Option<Vec<Vec<Option<Hit>>>> {
        let count = questions.iter().map(|(_, asked)| asked.len() as u64).sum::<u64>();
        self.questions += count;
        let (all, coverage) = if !self.answers.is_used() {
            self.work_out_all(questions, situations, go_on)?
        } else if self.answers.is_shared_out() {
            self.share_out(questions, situations, go_on)?
        } else {
            self.remember(count, questions, situations, go_on)?
        };
        self.coverage.merge(&coverage);
        Some(all)
    }

    /// Works out all answers.
    pub(super) fn work_out_all(
        &self,
        questions: &[ContactQuestion],
        situations: &[Situation],
        go_on: &mut dyn FnMut() -> bool,
    ) -> Option<Out> {
        let questions: Vec<&ContactQuestion> = questions.iter().collect();
        let (mut all, mut total) = (Vec::with_capacity(questions.len()), Coverage::new(self.world.cell.sensors.len()));
        for (answers, coverage) in self.work_out(&questions, false, situations, go_on)? {
            total.merge(&coverage);
            all.extend(answers);
        }
        Some((all, total))
    }

    /// Looks for contacts, on all threads: the answers in order, some together or each `apart`.
    pub(super) fn work_out(
        &self,
        questions: &[&ContactQuestion],
        apart: bool,
        situations: &[Situation],
        go_on: &mut dyn FnMut() -> bool,
    ) -> Option<Vec<Out>> {
        let (world, sensors) = (&self.world, self.world.cell.sensors.len());
        let found = shared_out(self.workers, questions.len(), go_on, |numbers, stopped| {
            let mut outs: Vec<Out> = Vec::new();
            let mut last: Option<(&PersonState, Option<Person>)> = None;
            for (stance, asked) in &questions[numbers] {
                if apart || outs.is_empty() {
                    outs.push((Vec::new(), Coverage::new(sensors)));
                }
                let Some((answers, coverage)) = outs.last_mut() else { break };
                let mut posed = last.take().filter(|(known, _)| known.poses_as(stance)).and_then(|(_, posed)| posed);
                let mut instants = instants_of(asked, situations);
                let Ok(hits) = world.of_person_state(stance).contacts(stance, &mut posed, &mut instants, coverage);
                last = Some((stance, posed));
                // What was under way then says nothing.
                if world.stop().is_due() {
                    stopped.store(true, Ordering::Relaxed);
                    break;
                }
                answers.push(hits);
            }
            outs
        })?;
        Some(found.into_iter().flatten().collect())
    }
}

/// What a stance is asked about.
pub(super) fn instants_of<'a>(asked: &[usize], situations: &'a [Situation]) -> Vec<Instant<'a, &'a Situation>> {
    let instant = |s: &usize| {
        let situation = &situations[*s];
        Instant { frames: &situation.frames, i: situation.i, earlier: situation }
    };
    asked.iter().map(instant).collect()
}
