//! What the settings in a result say of a cell, however it is searched.

use crate::cell::{Control, Workcell};
use crate::hazard::criterion::separation::Stop;
use crate::human::ControlKind;
use crate::human::action::ACTION_S;
use crate::record::criteria::{ClampingRecord, CriteriaRecord, SeparationTerms, StatedStop};
use crate::record::model::Settings;
use crate::record::operated::ControlRecord;
use crate::record::people::SecondRecord;

/// The settings of a cell, with nothing of a search in them but the cell's own seed.
pub(super) fn of_cell(cell: &Workcell) -> Settings {
    Settings {
        strategy: String::new(),
        seed: cell.search.seed,
        iterations: 0,
        stop_at_first: false,
        posture_sweep: false,
        actions_per_sequence: cell.search.actions,
        action_s: ACTION_S,
        contact_check_interval_s: cell.step_s,
        reach_tolerance_m: cell.search.reach_tolerance_m,
        speed_criterion: cell.criteria.speed(),
        criteria: criteria(cell),
        arm_speed_m_s: cell.arm_speed_m_s,
        held_m: cell.holds_m(),
        also: cell.repertoire.abilities().to_vec(),
        run_m_s: cell.repertoire.run_m_s(),
        second: second(cell),
        controls: controls(cell),
        until_s: None,
        presses: None,
        begins: None,
        seen_at_start: Vec::new(),
        body: Some((&cell.body).into()),
        floor_m: None,
        start_region_m: None,
    }
}

/// The second person, if there is one.
pub(super) fn second(cell: &Workcell) -> Option<SecondRecord> {
    let second = cell.second.as_ref()?;
    Some(SecondRecord {
        names: second.names.clone(),
        xy_m: second.start.xy_m(),
        heading_deg: second.start.heading_deg(),
        also: second.repertoire.abilities().to_vec(),
        run_m_s: second.repertoire.run_m_s(),
        held_m: Some(second.held_m).filter(|held_m| *held_m > 0.0),
        body: Some((&second.body).into()),
    })
}

/// The controls.
pub(super) fn controls(cell: &Workcell) -> Vec<ControlRecord> {
    let one = |Control { name, by, kind, steps, door, place: _ }: &Control| ControlRecord {
        name: name.clone(),
        by: *by,
        kind: *kind,
        pressed_steps: (*kind == ControlKind::Momentary).then_some(*steps),
        door: *door,
    };
    cell.controls.iter().map(one).collect()
}

/// What counts as unsafe, where that is more or other than the transient force.
pub(super) fn criteria(cell: &Workcell) -> Option<CriteriaRecord> {
    (!cell.judges_by_force_alone()).then(|| CriteriaRecord {
        transient_force: cell.criteria.transient_force,
        clamping: cell.criteria.clamping.then(|| ClampingRecord {
            contact_signal: cell.clamping.signal.clone(),
            travel_after_contact_m: cell.travel_after_contact_m.iter().copied().fold(0.0, f64::max),
        }),
        pressure: cell.criteria.pressure,
        moving_contact_faster_than_m_s: cell.criteria.moving_contact_m_s,
        separation: cell.separation.as_ref().map(|separation| SeparationTerms {
            stop: match &separation.stop {
                Stop::Measured(name) => Some(name.clone()),
                Stop::Stated { .. } => None,
            },
            stated: match separation.stop {
                Stop::Measured(_) => None,
                Stop::Stated { reaction_s, stop_time_s, stop_distance_m } => {
                    Some(StatedStop { reaction_s, stop_time_s, stop_distance_m })
                }
            },
            intrusion_m: separation.intrusion_m,
            person_uncertainty_m: separation.person_uncertainty_m,
            robot_uncertainty_m: separation.robot_uncertainty_m,
            approach_m_s: separation.approach_m_s,
        }),
    })
}
