//! Behaviours of FMUs that hardly ever come back to just the same: a net of them, within some widths of which everything lies. How far off
//! anything is is measured on walks, and robots are taken to be larger and faster, and people to have come farther, by twice the most that
//! was seen.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::Instant;

use super::behaviours::{BehaviourResult, NotAll, Refused, Stands, because, in_seconds, in_words, seconds};
use super::{AnalysisContext, AnalysisEvent, EventSink, SEED};
use crate::host::Hosted;
use crate::obligations::Assumption;
use crate::reachability::held::HeldReadings;
use crate::reachability::reduced::{MayBeOff, Nearly};
use crate::reachability::widths::Width;
use crate::record::figures::grouped;
use crate::search::Rng;
use crate::search::behaviours::covers::{Covers, Gap, Off, gap};
use crate::search::behaviours::decided::{
    DecisionLimits, LONGER_WALKS, TIMES_HELD, Why, each_walk, held_for, steps_of,
};
use crate::search::behaviours::net::find;
use crate::search::behaviours::{BehaviourSearchEnd, Behaviours, Extent, Machine as _, longest};
use crate::standards::iso_13855::WALKING_SPEED_M_S;

/// Widths that are tried, one after the other.
const WIDTHS: [Width; 2] = [Width { place_m: 0.01, speed_m_s: 0.05 }, Width { place_m: 0.02, speed_m_s: 0.1 }];
/// Most instants of a net.
const MOST: usize = 1_000_000;
/// It is looked for in this part of the time that is left.
const SHARE: u32 = 3;
/// Robots are off by so many times what was seen.
const TIMES: f64 = 2.0;
/// Stays are told apart up to this, s.
const STAYS_S: f64 = 1.0;
/// What is farther off is not nearly there: by place, m, by speed, m/s, and by how far people get, m.
const MOST_OFF: [f64; 3] = [0.05, 0.3, 0.13];
/// Robots that are so fast at most are off alike, m/s. What is at rest moves by what is rounded.
const SPEEDS_M_S: [f64; 6] = [1e-6, 0.1, 0.25, 0.5, 1.0, f64::INFINITY];

/// By speed, how far off anything is at most, as in [`MOST_OFF`].
type Worst = [[f64; 3]; SPEEDS_M_S.len()];

impl AnalysisContext<'_> {
    /// A net of behaviours, if walks show nothing that is farther off; some of what it may do, if they do.
    pub(super) fn nearly(
        &mut self,
        machine: &mut HeldReadings<'_, Hosted>,
        links: &Arc<[bool]>,
        tell: &mut EventSink<'_>,
    ) -> BehaviourResult<Stands> {
        if !self.prepared.binding.derived.is_empty() {
            return because(
                "what is nearly the same was not looked for, as speeds are worked out from positions".to_owned(),
            );
        }
        let question =
            DecisionLimits { step_s: self.prepared.cell.step_s, steps: self.steps(), most: MOST, times_held: 1 };
        let held = match held_for(machine, question, &mut Rng::new(SEED))? {
            Ok((_, held)) => held,
            Err(Why::Asked) => return Ok(Err(Refused::Stopped)),
            Err(why) => return because(in_words(why, question)),
        };
        let (mut widths, mut times_held) = (WIDTHS.into_iter().peekable(), TIMES_HELD.into_iter().peekable());
        let (mut kept, mut why, mut is_remembered) = (None, String::new(), false);
        while let (Some(width), Some(times)) = (widths.peek(), times_held.peek()) {
            machine.measure(links, *width);
            let held: Vec<usize> = held.iter().map(|held| times * held).collect();
            match self.within(machine, &held, (&mut kept, tell))? {
                // What it remembers may show later.
                Err(Refused::Remembers(remembers)) => {
                    (why, is_remembered) = (remembers, true);
                    times_held.next();
                }
                Err(Refused::Because(too_many)) => {
                    (why, is_remembered) = (too_many, false);
                    widths.next();
                }
                outcome => return Ok(outcome),
            }
        }
        // It is of the last width, as are the numbers of what is shown.
        match kept {
            Some(found) => Ok(Ok(Stands::not_all(found, true, NotAll { why, remembers: is_remembered }))),
            None => because(why),
        }
    }

    /// The same of one width.
    fn within(
        &mut self,
        machine: &mut HeldReadings<'_, Hosted>,
        held: &[usize],
        (kept, tell): (&mut Option<Behaviours>, &mut EventSink<'_>),
    ) -> BehaviourResult<Stands> {
        *kept = None;
        let found = match self.net(machine, held, (kept, tell))? {
            Ok(found) => found,
            Err(refused) => return Ok(Err(refused)),
        };
        machine.tell_apart(true);
        let gaps = self.gaps(machine, (&found, longest(held)), &mut Rng::new(SEED), tell);
        machine.tell_apart(false);
        let (walked, worst) = match gaps? {
            Ok(gaps) => gaps,
            Err(refused) => {
                *kept = Some(found);
                return Ok(Err(refused));
            }
        };
        let step_s = self.prepared.cell.step_s;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some seconds")]
        let within_ms = (1000.0 * seconds(longest(held), step_s)).ceil() as u32;
        let most = |n: usize| worst.iter().map(|off| off[n]).fold(0.0, f64::max);
        let tried = format!(
            "{} instants stand for all that the FMU may do, each report was held for {}, and {walked} walks of up to {:.0} s showed nothing that is off by more than \
             {:.0} mm and {:.2} m/s and {:.2} s, of which twice as much is added",
            grouped(&found.count().to_string()),
            in_seconds(held, step_s),
            seconds(LONGER_WALKS * self.steps(), step_s),
            1000.0 * most(0),
            most(1),
            most(2) / WALKING_SPEED_M_S
        );
        // What is faster sweeps more in half a step, too.
        let times = |[place, speed, far]: [f64; 3]| Nearly {
            apart_m: TIMES * (place + 0.5 * speed * step_s),
            faster_m_s: TIMES * speed,
            farther_m: TIMES * far,
        };
        let off = MayBeOff(SPEEDS_M_S.into_iter().zip(worst.map(times)).collect());
        let assumption = Assumption::NearlyAlike { within_ms };
        Ok(Ok(Stands { found, assumption, tried, off, is_net: true, not_all: None }))
    }

    /// The net, if there is time and room for it; what was found of it is kept otherwise.
    fn net(
        &self,
        machine: &mut HeldReadings<'_, Hosted>,
        held: &[usize],
        (kept, tell): (&mut Option<Behaviours>, &mut EventSink<'_>),
    ) -> BehaviourResult<Behaviours> {
        let most = self.effort.most_states.max(MOST);
        let ends_at = self.prepared.stop().left().map(|left| Instant::now() + left / SHARE);
        let is_late = || ends_at.is_some_and(|ends_at| Instant::now() >= ends_at);
        let (mut asked, mut told) = (false, 0_u32);
        let found = find(machine, Extent { held, steps: usize::MAX, most }, &mut |instants| {
            told += 1;
            asked = told.is_multiple_of(8) && tell(AnalysisEvent::Behaviours(instants, most)).is_break();
            if asked || is_late() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        })?;
        let count = grouped(&found.count().to_string());
        let outcome = match found.ended {
            BehaviourSearchEnd::Closed | BehaviourSearchEnd::Steps => return Ok(Ok(found)),
            BehaviourSearchEnd::Most => {
                because(format!("it does more than {} instants nearly stand for", grouped(&most.to_string())))
            }
            BehaviourSearchEnd::Unfinished => because("some steps could not be finished".to_owned()),
            BehaviourSearchEnd::Asked if asked => Ok(Err(Refused::Stopped)),
            BehaviourSearchEnd::Asked => because(format!(
                "a third of the time was not enough for instants that nearly stand for all that it does, {count} so far"
            )),
        };
        *kept = Some(found);
        outcome
    }

    /// How many walks there were, and how far off anything is at most.
    fn gaps(
        &self,
        machine: &mut HeldReadings<'_, Hosted>,
        (found, held): (&Behaviours, usize),
        rng: &mut Rng,
        tell: &mut EventSink<'_>,
    ) -> BehaviourResult<(usize, Worst)> {
        let (step_s, steps) = (self.prepared.cell.step_s, self.steps());
        #[expect(clippy::cast_possible_truncation, reason = "some seconds")]
        let covers = Covers::new(found, steps_of(STAYS_S, step_s) as u32);
        let (mut walked, mut worst, others) = (0, Worst::default(), machine.others());
        for (style, number, long) in each_walk(steps) {
            let drawn = style.drawn(rng, &others, number, (held, long));
            match gap(machine, &covers, &drawn)? {
                Gap::Within(all) => {
                    all.into_iter().for_each(|off| take_in(&mut worst, off, step_s));
                    walked += 1;
                }
                Gap::Unfinished => return because("some steps could not be finished".to_owned()),
                Gap::Nothing { steps, changes } => {
                    return remembers(format!(
                        "in a walk with {changes} changes it did something after {:.2} s that nothing nearly stands for",
                        seconds(steps, step_s)
                    ));
                }
            }
            if tell(AnalysisEvent::Behaviours(found.count(), found.count())).is_break() {
                return Ok(Err(Refused::Stopped));
            }
        }
        if let Some([place, speed, _]) = worst.iter().find(|worst| (0..3).any(|n| worst[n] > MOST_OFF[n])) {
            let place_mm = 1000.0 * place;
            return remembers(format!(
                "what nearly stands for all that it does is off by {place_mm:.0} mm and {speed:.2} m/s"
            ));
        }
        Ok(Ok((walked, worst)))
    }
}

fn remembers<T>(why: String) -> BehaviourResult<T> {
    Ok(Err(Refused::Remembers(why)))
}

/// What was seen of something by how fast it is.
fn take_in(worst: &mut Worst, Off { fast, by, late }: Off, step_s: f64) {
    let speed = SPEEDS_M_S.iter().position(|up_to| fast <= *up_to).unwrap_or_default();
    let off = [by[0], by[1], WALKING_SPEED_M_S * seconds(late, step_s)];
    (0..3).for_each(|n| worst[speed][n] = worst[speed][n].max(off[n]));
}
