//! Whether the person, so placed, can touch the robots, so placed: each question once, the answers worked out on all
//! threads.

use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hash as _, Hasher as _};
use std::sync::atomic::Ordering;

use super::situations::Situation;
use super::{Expander, Pending, Transition};
use crate::host::Plant;
use crate::human::walk::WalkTrace;
use crate::sim::Coverage;
use crate::sim::answers::Sharing;
use crate::sim::encounter::Person;
use crate::sim::journal::Block;
use crate::sim::threads::shared_out;
use crate::sim::world::{Hit, Instant, Occupant, Stance};

/// A stance, and the numbers of the situations that it is asked about.
pub(super) type Question = (Stance, Vec<usize>);

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
    ) -> (Vec<Question>, Vec<Option<(usize, usize)>>) {
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
        let mut questions: Vec<Question> = Vec::new();
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
            questions.push((Stance { struck: p.struck, ..stance }, situations));
        }
        (questions, places)
    }

    /// Answers all questions: each stance with the situations it is asked about.
    pub(super) fn answer(
        &mut self,
        questions: &[Question],
        situations: &[Situation],
        go_on: &mut dyn FnMut() -> bool,
    ) -> Option<Vec<Vec<Option<Hit>>>> {
        let asked = questions.iter().map(|(_, asked)| asked.len() as u64).sum::<u64>();
        self.questions += asked;
        // Answers stand by their places among the questions, so these have to be the same ones.
        let mut digest = DefaultHasher::new();
        questions.hash(&mut digest);
        let asked = (asked, digest.finish(), self.robots.recall.trail());
        if let Some(block) = self.journal.next(asked) {
            self.coverage.merge(&block.coverage);
            let found = self.found_again(&block, questions, situations);
            // A search that had to end may have missed what is there.
            return (!self.world.stop().is_due()).then_some(found);
        }
        let (all, coverage) = match &self.journal.sharing {
            Sharing::Nothing => self.work_out(questions, situations, go_on)?,
            Sharing::Share(_) | Sharing::LookUp(_) => self.share_out(questions, situations, go_on)?,
        };
        if self.journal.keeps() {
            let number = |i: usize| u32::try_from(i).unwrap_or(u32::MAX);
            let of = |(q, hits): (usize, &Vec<Option<Hit>>)| {
                let found = hits.iter().enumerate().filter(|(_, hit)| hit.is_some());
                found.map(|(s, _)| (number(q), number(s))).collect::<Vec<_>>()
            };
            let found = all.iter().enumerate().flat_map(of).collect();
            self.journal.add(&Block { asked, found, coverage: coverage.clone() });
        }
        self.coverage.merge(&coverage);
        Some(all)
    }

    /// The answers to questions of which is known where something is to be found.
    fn found_again(&self, block: &Block, questions: &[Question], situations: &[Situation]) -> Vec<Vec<Option<Hit>>> {
        let mut all: Vec<Vec<Option<Hit>>> = questions.iter().map(|(_, asked)| vec![None; asked.len()]).collect();
        let mut counted = Coverage::new(self.world.cell.sensors.len());
        for together in block.found.chunk_by(|a, b| a.0 == b.0) {
            let Some((stance, asked)) = together.first().and_then(|(q, _)| questions.get(*q as usize)) else {
                continue;
            };
            // All of the stance, as before: what is found for one may follow from what was found for another.
            let mut instants = instants_of(asked, situations);
            let Ok(hits) = self.world.of_stance(stance).contacts(stance, &mut None, &mut instants, &mut counted);
            all[together[0].0 as usize] = hits;
        }
        all
    }

    /// Looks for contacts, on all threads.
    fn work_out(
        &self,
        questions: &[Question],
        situations: &[Situation],
        go_on: &mut dyn FnMut() -> bool,
    ) -> Option<(Vec<Vec<Option<Hit>>>, Coverage)> {
        let (world, sensors) = (&self.world, self.world.cell.sensors.len());
        let found = shared_out(self.workers, questions.len(), go_on, |numbers, stopped| {
            let (mut answers, mut coverage) = (Vec::new(), Coverage::new(sensors));
            let mut last: Option<(&Stance, Option<Person>)> = None;
            for (stance, asked) in &questions[numbers] {
                let mut posed = last.take().filter(|(known, _)| known.poses_as(stance)).and_then(|(_, posed)| posed);
                let mut instants = instants_of(asked, situations);
                let Ok(hits) = world.of_stance(stance).contacts(stance, &mut posed, &mut instants, &mut coverage);
                last = Some((stance, posed));
                // What was under way then says nothing.
                if world.stop().is_due() {
                    stopped.store(true, Ordering::Relaxed);
                    break;
                }
                answers.push(hits);
            }
            (answers, coverage)
        })?;
        let (mut all, mut total) = (Vec::with_capacity(questions.len()), Coverage::new(sensors));
        for (answers, coverage) in found {
            total.merge(&coverage);
            all.extend(answers);
        }
        Some((all, total))
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
