//! A walk that ends where and when somebody may be harmed, for people of whom no sensor knew before: a straight line, or one
//! with a turn at its end. Whether it does lead to harm, a run of its own says.

use std::f64::consts::{FRAC_PI_4, TAU};

use crate::cell::Workcell;
use crate::hazard::Finding;
use crate::human::{Action, Posture, Start, Walk};
use crate::reachability::{Harm, History, ReachabilitySearch, ReachableInstant, known};
use crate::scan::hosting::StateChoice;
use crate::scan::prepare::Prepared;
use crate::search::Environment as _;
use crate::standards::iso_13855::WALKING_SPEED_M_S;

/// Most actions of walking before the last one.
const MOST_WALKING: usize = 7;

/// Where somebody starts and when, and what they do.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct WalkIn {
    /// Where, floor plan, m.
    pub xy_m: [f64; 2],
    /// Where they look there, from +x towards +y, degrees.
    pub heading_deg: f64,
    /// Communication steps after the FMU's own start.
    pub lead_in: usize,
    /// What.
    pub actions: Vec<Action>,
}

impl WalkIn {
    /// Where they start.
    pub(crate) fn start(&self) -> Start {
        let [x, y] = self.xy_m;
        Start::new(x, y, self.heading_deg)
    }

    /// When they start, after the FMU, s.
    #[expect(clippy::cast_precision_loss, reason = "an hour of small steps at most")]
    pub(crate) fn begins_s(&self, step_s: f64) -> f64 {
        self.lead_in as f64 * step_s
    }

    /// Whoever stands there, from so many steps before the instant on; an action has so many.
    pub(crate) fn standing(harm: &Harm, step: usize, before: usize, steps_per_action: usize) -> Self {
        Self {
            xy_m: harm.xy_m,
            heading_deg: harm.heading_rad.to_degrees(),
            lead_in: step.saturating_sub(before),
            actions: vec![Action::new(Walk::Stop, harm.posture); before.div_ceil(steps_per_action)],
        }
    }

    /// Walks to a harm, those first that take the fewest actions; all begin where sensors report `first`. Fewer once the search has
    /// to end.
    pub(crate) fn all(
        of: &ReachabilitySearch<'_>,
        cell: &Workcell,
        first: &[bool],
        history: &History,
        harm: &Harm,
    ) -> Vec<Self> {
        let seen = &history.seen[harm.instant];
        let steps = cell.steps_per_action;
        let mut all = Vec::new();
        for walking in 0..=MOST_WALKING {
            for (last, turn) in
                [(Walk::Forward, 0_i8), (Walk::Left45, 1), (Walk::Right45, -1), (Walk::Left90, 2), (Walk::Right90, -2)]
            {
                for reached in (1..=steps).rev().take_while(|_| !of.is_due()) {
                    let way = StraightWalk { harm, walking, last, turn, reached };
                    all.extend(way.walks(of, cell, first, &history.readings, seen));
                }
            }
        }
        all
    }
}

/// Straight on for some actions, then an action with a turn, in which the place is reached after so many steps.
struct StraightWalk<'a> {
    harm: &'a Harm,
    walking: usize,
    last: Walk,
    turn: i8,
    reached: usize,
}

impl StraightWalk<'_> {
    /// The places and headings after each step, the start first.
    #[expect(clippy::cast_precision_loss, reason = "a few dozen steps")]
    fn places(&self, cell: &Workcell) -> Vec<([f64; 2], f64)> {
        let steps = cell.steps_per_action;
        let length = WALKING_SPEED_M_S * cell.step_s;
        let along = |from: [f64; 2], heading: f64, steps: f64| {
            let (sin, cos) = libm::sincos(heading);
            [from[0] + cos * length * steps, from[1] + sin * length * steps]
        };
        let last = self.harm.heading_rad;
        let before = (last - f64::from(self.turn) * FRAC_PI_4).rem_euclid(TAU);
        let corner = along(self.harm.xy_m, last, -(self.reached as f64));
        let walked = self.walking * steps;
        let first = (0..=walked).map(|step| (along(corner, before, step as f64 - walked as f64), before));
        first.chain((1..=self.reached).map(|step| (along(corner, last, step as f64), last))).collect()
    }

    fn walks(
        &self,
        of: &ReachabilitySearch<'_>,
        cell: &Workcell,
        first: &[bool],
        then: &[Option<bool>],
        seen: &ReachableInstant,
    ) -> Vec<WalkIn> {
        let places = self.places(cell);
        let [(start, heading), ..] = places[..] else { return Vec::new() };
        if !of.may_begin(start, heading, &known(first)) || !places.iter().all(|(at, _)| of.has_room(*at)) {
            return Vec::new();
        }
        // The sample from which on the readings are those of the history.
        let reads = |(at, heading): &([f64; 2], f64)| of.is_possible(*at, *heading, Posture::Upright, then);
        let is_first = then.iter().zip(first).all(|(then, first)| then.is_none_or(|then| then == *first));
        let entered = if is_first { 0 } else { places.iter().position(reads).unwrap_or(places.len()) };
        let arrived = places.len() - 1;
        let posture = self.harm.posture;
        let mut actions = vec![Action::new(Walk::Forward, Posture::Upright); self.walking];
        actions.push(Action::new(self.last, posture));
        // There just at the instant.
        let mut all = Vec::new();
        let (xy_m, heading_deg) = (start, heading.to_degrees());
        if let Some(lead_in) = seen.step.checked_sub(arrived) {
            all.push(WalkIn { xy_m, heading_deg, lead_in, actions: actions.clone() });
        }
        // Seen as long before as told, and there until then.
        let begun = (seen.step - 1).saturating_sub(seen.lasting);
        if self.reached == cell.steps_per_action
            && let Some(lead_in) = begun.checked_sub(entered)
            && seen.step > lead_in + arrived
        {
            let waits = (seen.step - lead_in - arrived).div_ceil(cell.steps_per_action);
            actions.extend(vec![Action::new(Walk::Stop, posture); waits]);
            all.push(WalkIn { xy_m, heading_deg, lead_in, actions });
        }
        all
    }
}

/// The first harm that a walk leads to; while sensors report `readings`, if given.
pub(super) fn shown_by(prepared: &Prepared, way: &WalkIn, readings: Option<&[bool]>) -> Option<Finding> {
    let actions = u32::try_from(way.actions.len()).ok()?;
    let there = prepared.standing(way.start(), way.lead_in, actions).ok()?;
    let mut simulation = there.simulation(StateChoice::Replay, false).ok()?;
    simulation.reset().ok()?;
    let mut findings = Vec::new();
    for action in &way.actions {
        let step = simulation.take(*action).ok()?;
        findings.extend(simulation.take_findings());
        if step.end.is_some() {
            break;
        }
    }
    let as_told = |finding: &Finding| {
        let Some(readings) = readings else { return true };
        let sensors = prepared.cell.sensors.iter().zip(finding.sensors.iter().zip(readings));
        finding.through.is_empty()
            && sensors.into_iter().all(|(sensor, (told, reading))| told == reading || sensor.zone.is_in_fmu())
    };
    findings.into_iter().find(as_told)
}
