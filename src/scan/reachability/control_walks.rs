//! Walks on which controls are worked: when others work them, and where the person goes to do it. Whether they do lead to harm, a run
//! of its own says.
//!
//! What others work is worked at the beginning of an action, as near as may be to when it was. For what the person works, ways are
//! looked for backwards, action by action: from where somebody is harmed to a place from which a hand gets to the control, and on from
//! there to one where people begin.

use std::collections::BTreeSet;
use std::f64::consts::{FRAC_PI_4, TAU};

use super::walk_in::WalkIn;
use crate::cell::Workcell;
use crate::human::ControlledBy;
use crate::human::action::ACTION_S;
use crate::human::{Action, DistanceField, Posture, Presses, Start, Walk};
use crate::reachability::{Harm, History, ReachabilitySearch, StateOrigin, known};
use crate::scan::prepare::Prepared;
use crate::sim::World;
use crate::standards::iso_13855::WALKING_SPEED_M_S;

/// So much longer than it was harm is waited for, in actions: what is worked a little later comes a little later.
const LONGER: usize = 3;
/// So much later others work a control at most, in communication steps, where the person is not there yet.
const LATER: usize = 40;
/// Most actions from the control to where somebody is harmed, and on the way to the control.
const MOST_AFTER: usize = 5;
const MOST_BEFORE: usize = 10;
/// Most stances of which it is tried whether a hand gets there.
const MOST_TRIED: usize = 300;
/// Most places of which it is tried whether people begin there.
const MOST_BEGINNINGS: usize = 1_000;
/// Ways to a control that are kept.
const MOST_WAYS: usize = 6;
/// Starts of walks that are tried, and how far they are apart, m.
const MOST_STARTS: usize = 6;
const APART_M: f64 = 0.1;
/// Stances that are no farther from each other than this, m, count as one, on the way to a control and on the way from there.
const ALIKE_BEFORE_M: f64 = 0.04;
const ALIKE_AFTER_M: f64 = 0.08;
/// A walk that comes to where sensors see it too early or too late is tried as a whole so many steps farther on, or back.
const MOVED: [i8; 7] = [0, 1, -1, 2, -2, 3, -3];
/// Steps of an action at which there has to be room.
const LOOKED_AT: u32 = 4;

/// Controls that the person works among others.
fn own(pressed: &[(usize, Presses)], cell: &Workcell) -> Option<(usize, Presses)> {
    let is_own = |control: &usize| cell.controls[*control].by == ControlledBy::Person;
    let own =
        |presses: Presses| presses.numbers().filter(is_own).fold(Presses::NONE, |all, c| all.and(Presses::one(c)));
    pressed.iter().map(|(step, presses)| (*step, own(*presses))).rfind(|(_, own)| !own.is_none())
}

/// Walks to a harm, of which `standing` are those of people who are there all the time.
pub(super) fn all(
    prepared: &Prepared,
    of: &ReachabilitySearch<'_>,
    first: &[bool],
    (history, harm): (&History, &Harm),
    standing: impl FnOnce() -> Vec<WalkIn>,
) -> Vec<WalkIn> {
    let cell = &prepared.cell;
    let seen = &history.seen[harm.instant];
    let StateOrigin { changed, pressed } = &*seen.story;
    let ways = Backwards { prepared, of, first, harm, origin: &history.fields[1] };
    let mut others = pressed.clone();
    let walks = match (own(pressed, cell), changed) {
        (None, None) => standing(),
        (None, Some(changed)) => ways.unworked(*changed),
        (Some((step, presses)), changed) => {
            let has = |worked: &Presses| presses.numbers().all(|control| worked.has(control));
            for (_, worked) in others.iter_mut().filter(|(at, worked)| *at == step && has(worked)) {
                *worked = worked.either(presses);
            }
            others.retain(|(_, worked)| !worked.is_none());
            ways.working(presses, step - 1, *changed)
        }
    };
    let walks = walks.iter().filter_map(|walk| {
        // What is worked once sensors have seen them waits until they get to where they are harmed.
        let arrives = walk.lead_in + walk.actions.len() * cell.steps_per_action;
        let later = arrives.saturating_sub(seen.step).min(LATER);
        let after = |step: usize| changed.is_some_and(|changed| step > changed);
        let others = others.iter().map(|(step, presses)| (step + if after(*step) { later } else { 0 }, *presses));
        worked_by_others(walk, &others.collect::<Vec<_>>(), seen.step + later, cell)
    });
    walks.collect()
}

/// The same walk with controls worked as others do, at the beginning of the next action, and until after an instant; nothing if it
/// would have to begin before the FMU.
fn worked_by_others(walk: &WalkIn, pressed: &[(usize, Presses)], last: usize, cell: &Workcell) -> Option<WalkIn> {
    let steps = cell.steps_per_action;
    let mut walk = walk.clone();
    let first = pressed.iter().map(|(step, _)| step - 1).min().unwrap_or(walk.lead_in);
    let earlier = walk.lead_in.saturating_sub(first).div_ceil(steps);
    walk.lead_in = walk.lead_in.checked_sub(earlier * steps)?;
    walk.actions.splice(0..0, vec![Action::REST; earlier]);
    let posture = walk.actions.last()?.posture();
    let count = (last.saturating_sub(walk.lead_in).div_ceil(steps) + LONGER).max(walk.actions.len());
    walk.actions.resize(count, Action::new(Walk::Stop, posture));
    for (step, presses) in pressed {
        let action = walk.actions.get_mut((step - 1 - walk.lead_in).div_ceil(steps))?;
        *action = action.pressing(action.presses().and(*presses));
    }
    Some(walk)
}

/// Where somebody stands, and looks.
#[derive(Clone, Copy, Debug)]
struct FloorPose {
    xy_m: [f64; 2],
    /// Where they look at the end of the walk, rad.
    last_rad: f64,
    /// How many eighths of a turn they turn until then.
    eighths: i8,
}

impl FloorPose {
    /// At the end of a walk.
    const fn last(xy_m: [f64; 2], heading_rad: f64) -> Self {
        Self { xy_m, last_rad: heading_rad, eighths: 0 }
    }

    fn heading_rad(&self) -> f64 {
        self.last_rad - f64::from(self.eighths) * FRAC_PI_4
    }

    /// Stances that count as one.
    #[expect(clippy::cast_possible_truncation, reason = "some thousand cells to a side")]
    fn cell(&self, alike_m: f64) -> ([i64; 2], i8) {
        (self.xy_m.map(|at| (at / alike_m).round() as i64), self.eighths)
    }

    /// The same a way ahead, m.
    fn ahead(&self, far_m: f64) -> Self {
        let (sin, cos) = libm::sincos(self.heading_rad());
        Self { xy_m: [self.xy_m[0] + far_m * cos, self.xy_m[1] + far_m * sin], ..*self }
    }

    /// After a turn.
    fn turned(&self, walk: Walk) -> Self {
        Self { eighths: (self.eighths - walk.turn_eighths()).rem_euclid(8), ..*self }
    }

    /// Where an action began that ends here: the same place, or one an action's walk back, looking elsewhere.
    fn before(&self, walk: Walk) -> Self {
        let far_m = if walk == Walk::Stop { 0.0 } else { WALKING_SPEED_M_S * ACTION_S };
        Self { eighths: (self.eighths + walk.turn_eighths()).rem_euclid(8), ..self.ahead(-far_m) }
    }
}

/// How far two places are apart, m.
fn apart_m(a: [f64; 2], b: [f64; 2]) -> f64 {
    libm::hypot(a[0] - b[0], a[1] - b[1])
}

fn walk(start: FloorPose, actions: Vec<Action>, lead_in: usize) -> WalkIn {
    WalkIn { xy_m: start.xy_m, heading_deg: start.heading_rad().rem_euclid(TAU).to_degrees(), lead_in, actions }
}

/// A stance, and what leads on from it, the last action first.
#[derive(Clone, Debug)]
struct Reached {
    at: FloorPose,
    then: Vec<Action>,
}

/// A walk from where people begin, and after how many of its steps sensors report something else, if that matters.
struct ApproachWalk {
    start: FloorPose,
    actions: Vec<Action>,
    entered: usize,
}

/// See the top of this file.
struct Backwards<'a, 'b> {
    prepared: &'a Prepared,
    of: &'a ReachabilitySearch<'b>,
    first: &'a [bool],
    harm: &'a Harm,
    /// How far it is at least from where people are whom no sensor has seen.
    origin: &'a DistanceField,
}

impl Backwards<'_, '_> {
    /// Walks on which sensors report something else from a communication step on.
    fn unworked(&self, changed: usize) -> Vec<WalkIn> {
        let Harm { xy_m, heading_rad, posture, .. } = *self.harm;
        let ways = self.starts(&FloorPose::last(xy_m, heading_rad), posture, Some(changed));
        ways.into_iter()
            .map(|ApproachWalk { start, actions, entered }| walk(start, actions, changed - 1 - entered))
            .collect()
    }

    /// The same on which the person works controls, `pressed` steps after the start of the FMU or as soon as may be after that:
    /// as much later comes what follows.
    fn working(&self, presses: Presses, pressed: usize, changed: Option<usize>) -> Vec<WalkIn> {
        let steps = self.prepared.cell.steps_per_action;
        let mut all = Vec::new();
        for (after, press) in self.presses_from(presses) {
            for ApproachWalk { start, actions, entered } in self.starts(&press, Posture::Upright, changed) {
                let lead_in = match changed {
                    Some(changed) => Some(changed - 1 - entered),
                    None => pressed.checked_sub(steps * actions.len()),
                };
                let Some(lead_in) = lead_in else { continue };
                let mut walk = walk(start, actions, lead_in);
                let there = walk.lead_in + steps * walk.actions.len();
                let waits = pressed.saturating_sub(there).div_ceil(steps);
                walk.actions.extend(vec![Action::REST; waits]);
                walk.actions.extend(&after);
                all.push(walk);
            }
        }
        all
    }

    /// After how many of its steps a walk comes to where sensors report something else, if after no more than so many.
    fn entered(&self, start: &FloorPose, actions: &[Action], most: usize) -> Option<usize> {
        let cell = &self.prepared.cell;
        let mut at = *start;
        let first = known(self.first);
        let mut taken = 0;
        for action in actions {
            at = at.turned(action.walk());
            for _ in 0..cell.steps_per_action {
                if taken > most {
                    return None;
                }
                if !self.of.is_possible(at.xy_m, at.heading_rad(), Posture::Upright, &first) {
                    return Some(taken);
                }
                taken += 1;
                if action.walk() != Walk::Stop {
                    at = at.ahead(WALKING_SPEED_M_S * cell.step_s);
                }
            }
        }
        // There it is seen at last: where it ends.
        (taken <= most).then_some(taken)
    }

    /// Actions from working the controls to the harm, the calmest first, and from where.
    fn presses_from(&self, presses: Presses) -> Vec<(Vec<Action>, FloorPose)> {
        let harm = FloorPose::last(self.harm.xy_m, self.harm.heading_rad);
        let (mut tried, mut ways) = (0, Vec::new());
        let anywhere = |_: &FloorPose, _: usize| true;
        self.back_from(harm, self.harm.posture, (MOST_AFTER, ALIKE_AFTER_M), &anywhere, &mut |reached| {
            let Some(walk) = reached.then.last().map(|action| action.walk()) else { return true };
            if !self.of.may_work(presses, reached.at.xy_m) {
                return true;
            }
            tried += 1;
            if let Some(posture) = self.hand(presses, &reached.at, walk) {
                let mut after = reached.then.clone();
                after.pop();
                after.push(Action::new(walk, posture).pressing(presses));
                after.reverse();
                ways.push((after, FloorPose::last(reached.at.xy_m, reached.at.heading_rad())));
            }
            tried < MOST_TRIED && ways.len() < MOST_WAYS
        });
        ways
    }

    /// How somebody bends there who gets their hands to the controls.
    fn hand(&self, presses: Presses, at: &FloorPose, walk: Walk) -> Option<Posture> {
        let [x, y] = at.xy_m;
        let there = self.prepared.standing(Start::new(x, y, at.heading_rad().to_degrees()), 0, 1).ok()?;
        let own = World::new(there.cell.clone(), there.binding.clone()).first;
        Posture::USUAL.into_iter().find(|posture| {
            let action = Action::new(walk, *posture).pressing(presses);
            own.worked(&own.walk(own.start(), action), action).presses == presses
        })
    }

    /// Walks to a stance from where people begin, the last action bent so; sensors report something else of them for the first time no
    /// later than at a step after the FMU's start, if one is given.
    fn starts(&self, to: &FloorPose, posture: Posture, changed: Option<usize>) -> Vec<ApproachWalk> {
        let stride_m = WALKING_SPEED_M_S * self.prepared.cell.step_s;
        let moves_m = f64::from(MOVED.into_iter().max().unwrap_or(0)) * stride_m;
        let near = |at: &FloorPose, far_m: f64| self.origin.least(at.xy_m, 0.0) <= far_m + moves_m;
        let in_reach = |at: &FloorPose, left: usize| {
            #[expect(clippy::cast_precision_loss, reason = "a few actions")]
            let far_m = left as f64 * WALKING_SPEED_M_S * ACTION_S;
            near(at, far_m)
        };
        let (mut tried, mut found): (usize, Vec<(usize, ApproachWalk)>) = (0, Vec::new());
        self.back_from(*to, posture, (MOST_BEFORE, ALIKE_BEFORE_M), &in_reach, &mut |reached| {
            let is_other = |(_, begun): &(usize, ApproachWalk)| apart_m(begun.start.xy_m, reached.at.xy_m) > APART_M;
            if near(&reached.at, 0.0) && found.iter().all(is_other) {
                tried += 1;
                let actions: Vec<Action> = reached.then.iter().rev().copied().collect();
                let ahead = actions.first().map_or(reached.at, |action| reached.at.turned(action.walk()));
                let moved = MOVED.into_iter().enumerate().find_map(|(number, steps)| {
                    let start = FloorPose { xy_m: ahead.ahead(f64::from(steps) * stride_m).xy_m, ..reached.at };
                    if !self.of.may_begin(start.xy_m, start.heading_rad(), &known(self.first)) {
                        return None;
                    }
                    let entered = match changed {
                        Some(changed) => self.entered(&start, &actions, changed - 1)?,
                        None => 0,
                    };
                    Some((number, ApproachWalk { start, actions: actions.clone(), entered }))
                });
                found.extend(moved);
            }
            found.len() < MOST_STARTS && tried < MOST_BEGINNINGS && !self.of.is_due()
        });
        // Those first that end where they were to end.
        found.sort_by_key(|(moved, _)| *moved);
        found.into_iter().map(|(_, begun)| begun).collect()
    }

    /// Stances from which actions lead to one, those first from which the fewest do, where so many actions that are left `may` lead
    /// on; `visit` says whether to go on.
    fn back_from(
        &self,
        to: FloorPose,
        posture: Posture,
        (most, alike_m): (usize, f64),
        may: &dyn Fn(&FloorPose, usize) -> bool,
        visit: &mut dyn FnMut(&Reached) -> bool,
    ) {
        let mut known = BTreeSet::from([to.cell(alike_m)]);
        let mut layer = vec![Reached { at: to, then: Vec::new() }];
        if !visit(&layer[0]) {
            return;
        }
        for number in 0..most {
            let mut next = Vec::new();
            for reached in layer {
                for walk in Walk::USUAL {
                    // Who waits does so at the end.
                    if walk == Walk::Stop && number > 0 {
                        continue;
                    }
                    let at = reached.at.before(walk);
                    if !may(&at, most - number - 1)
                        || !self.has_room(&at, &reached.at)
                        || (walk != Walk::Stop && !known.insert(at.cell(alike_m)))
                    {
                        continue;
                    }
                    // The last one ends bent as somebody is harmed.
                    let bent = if number == 0 { posture } else { Posture::Upright };
                    let then = reached.then.iter().copied().chain([Action::new(walk, bent)]).collect();
                    let before = Reached { at, then };
                    if !visit(&before) {
                        return;
                    }
                    if walk != Walk::Stop {
                        next.push(before);
                    }
                }
            }
            layer = next;
        }
    }

    fn has_room(&self, from: &FloorPose, to: &FloorPose) -> bool {
        (0..=LOOKED_AT).all(|part| {
            let share = f64::from(part) / f64::from(LOOKED_AT);
            self.of.has_room([0, 1].map(|axis| from.xy_m[axis] + share * (to.xy_m[axis] - from.xy_m[axis])))
        })
    }
}
