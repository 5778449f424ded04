//! A changed cell from anywhere: only what nobody is hit in from anywhere is enough. Whoever is hit becomes one more sequence that changes
//! are tried with.

use std::ops::ControlFlow;

use super::ReachabilityBudget;
use super::checks::{Changed, ExhaustiveBudget, KnownSequence, Witness};
use super::condition::TrialCondition;
use crate::obligations::Need;
use crate::record::advice::ReachabilityCheck;
use crate::record::begin::InitialConditionRecord;
use crate::record::reachability::HarmfulPose;
use crate::scan::hosting::StateChoice;
use crate::scan::reachability::{self, AnalysisEvent, analyse};
use crate::sim::answers::Answers;

impl Changed<'_> {
    /// Looks from anywhere, if that is asked for and the purse has a search left; a way to be hit as soon as there is one.
    pub(crate) fn everywhere(
        &self,
        purse: &mut ExhaustiveBudget,
        workers: usize,
    ) -> Result<Option<ReachabilityCheck>, Box<Witness>> {
        let Some(ReachabilityBudget { until, presses, states, .. }) = purse.everywhere() else { return Ok(None) };
        let own = self.own();
        let not_shown =
            |reason: String| Ok(Some(ReachabilityCheck { until_s: 0.0, reasons: vec![reason], is_close: false }));
        if let Some(reason) = reachability::refusal(own) {
            return not_shown(reason);
        }
        let (answers, state) = (Answers::default(), StateChoice::Auto);
        let effort =
            reachability::AnalysisLimits { until, workers, most_states: states, presses, state, answers: &answers };
        let stop = own.stop();
        let mut tell = |told| match told {
            AnalysisEvent::Floor(_, hazards) if hazards > 0 => ControlFlow::Break(()),
            _ if stop.ends_search() => ControlFlow::Break(()),
            _ => ControlFlow::Continue(()),
        };
        let looked = analyse(own, effort, &mut tell);
        stop.searching();
        let (was_cut_short, found) = match looked {
            Ok(looked) => (looked.was_cut_short(), looked.found),
            Err(error) => return not_shown(format!("the FMU failed: {}", error.cause.message)),
        };
        if let Some(witness) = found.hazards.iter().find_map(|place| self.witness(place)) {
            return Err(Box::new(witness));
        }
        let mut reasons = if found.verdict.is_clean() { Vec::new() } else { found.reasons };
        if !found.verdict.is_clean() && reasons.is_empty() {
            reasons.push("somebody is hit".to_owned());
        }
        let about_floor = |need| matches!(need, Need::Searched | Need::BetweenSteps | Need::Confirmed);
        let is_close = !was_cut_short && found.obligations.open().all(|one| about_floor(one.need));
        Ok(Some(ReachabilityCheck { until_s: found.until_s, reasons, is_close }))
    }

    /// The walk of a way to be hit that is confirmed.
    fn witness(&self, place: &HarmfulPose) -> Option<Witness> {
        let begin = InitialConditionRecord {
            xy_m: place.start_m,
            heading_deg: place.start_heading_deg,
            begins_s: place.begins_s,
        };
        let actions = u32::try_from(place.actions.len()).ok()?;
        let own = self.own();
        Some(Witness {
            known: KnownSequence {
                standpoint: TrialCondition { elsewhere: Some((begin, actions)), ..TrialCondition::own(own) },
                actions: place.actions.clone(),
            },
            class: place.class?,
            region: place.body_region,
            link: own.cell.links.iter().position(|link| link.name == place.robot_link)?,
            ratio: place.ratio,
            time_s: place.time_s.filter(|_| place.confirmed)?,
        })
    }
}
