//! Hazards that are known, tried again in a cell that was changed.

use std::sync::Arc;

use super::hosting::StateChoice;
use super::prepare::Prepared;
use super::run::criteria;
use crate::cell::Workcell;
use crate::hazard::Finding;
use crate::host::PlantError;
use crate::human::Action;
use crate::report::looks::Looks;
use crate::report::model::Hazard;
use crate::report::people::SecondRecord;
use crate::report::verified::{Outcome, Verified};
use crate::sim::replay::replay;

/// Runs the worst and the shortest sequence of a hazard from a fresh instance each, from where and when it begins. `earlier` is
/// what the scan looked for that knows it.
#[must_use]
pub fn verify(prepared: &Prepared, earlier: Option<&Looks>, hazard: &Hazard) -> Verified {
    // The FMU and its variables are bound already: what can be wrong is the place.
    let Ok(there) = prepared.of_hazard(hazard) else {
        return Verified { hazard: hazard.clone(), outcome: Outcome::NoRoom };
    };
    let looks = looks(&there.cell);
    let judged = earlier.is_some_and(|earlier| {
        looks.judges_as_strictly_as(earlier, hazard.class)
            && looks.reaches_as_fast_as(earlier)
            && looks.does_the_same_as(earlier)
            && looks.works_as_much_as(earlier, hazard)
    });
    if !judged {
        return Verified { hazard: hazard.clone(), outcome: Outcome::NotJudged };
    }
    let run = |actions: &[Action]| -> Result<Option<Finding>, PlantError> {
        let (cell, binding) = (Arc::clone(&there.cell), Arc::clone(&there.binding));
        replay(cell, binding, there.plant(StateChoice::Replay), actions, None)
    };
    let sequences = [&hazard.actions, &hazard.shortest.actions];
    let different = if sequences[0] == sequences[1] { 1 } else { 2 };
    let mut worst: Option<Finding> = None;
    for actions in &sequences[..different] {
        match run(actions) {
            Err(error) => {
                return Verified { hazard: hazard.clone(), outcome: Outcome::NotRun { cause: error.message } };
            }
            Ok(Some(found)) if worst.as_ref().is_none_or(|w| found.contact.ratio() > w.contact.ratio()) => {
                worst = Some(found);
            }
            Ok(_) => {}
        }
    }
    let outcome = worst.map_or(Outcome::Fixed, |found| Outcome::StillThere {
        ratio: found.contact.ratio(),
        force_n: found.contact.deciding_force_n(),
        body_region: found.contact.region.to_string(),
        robot_link: prepared.cell.links[found.contact.link].name.clone(),
        time_s: found.time_s,
    });
    Verified { hazard: hazard.clone(), outcome }
}

/// What a scan of the cell would look for.
fn looks(cell: &Workcell) -> Looks {
    Looks {
        speed_criterion: cell.search.criterion,
        criteria: criteria(cell),
        arm_speed_m_s: cell.arm_speed_m_s,
        held_m: cell.holds_m(),
        also: cell.repertoire.abilities().to_vec(),
        run_m_s: cell.repertoire.run_m_s(),
        second: SecondRecord::of(cell),
        controls: cell.controls.iter().map(Into::into).collect(),
        actions_per_sequence: cell.search.actions,
        contact_check_interval_s: cell.step_s,
        reach_tolerance_m: cell.search.reach_tolerance_m,
        until_s: None,
        presses: None,
    }
}
