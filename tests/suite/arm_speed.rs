//! Arms that take their time: what they reach is part of what arms reach that are anywhere at once.

use fmi_hazard::record::model::ScanReport;
use fmi_hazard::scan::StateChoice;
use fmi_hazard::scan::prepare::{Prepared, prepare};
use fmi_hazard::search::{End, Environment as _};

use crate::common::anywhere::cell;
use crate::common::guarded::{every_sequence, guarded};
use crate::common::write;
use crate::sample;

/// A bar that comes round 0.12 s after the start, before somebody who reaches it with an arm only: at 0.5 m/s no hand gets there in an
/// action, and the faster hands are the more sequences end so, up to those with arms that are anywhere. Every sequence that ends so with
/// arms that take their time ends with these, too, as soon or sooner.
#[test]
fn a_hand_that_cannot_be_there_yet_is_not_hit() {
    if !sample::is_turn(1, 4) {
        return;
    }
    let dir = guarded();
    let prepared = |actions: u32, speed_m_s: Option<f64>| -> Prepared {
        let speed = speed_m_s.map_or(String::new(), |speed| format!("arm_speed_m_s = {speed}\n"));
        let text = cell(1.0, "").replace("xy_m = [0, -3]", "xy_m = [0, -1.15]");
        let text = text.replace("heading_deg = 90 }\n", &format!("heading_deg = 90 }}\n{speed}"));
        let text = text.replace("actions = 2", &format!("actions = {actions}"));
        prepare(&write(dir.path(), "cell.toml", &text), None).unwrap()
    };
    let hazardous = |report: &ScanReport| -> u32 {
        assert!(report.hazards.iter().all(|hazard| hazard.arm.is_some()), "nothing but arms gets there");
        report.certificate.as_ref().unwrap().hazardous.parse().unwrap()
    };
    let mut free = prepared(2, None).simulation(StateChoice::Auto, false).unwrap();
    for actions in [1, 2] {
        let mut before = 0;
        // Of two actions most of the speeds take most of the time.
        let fewer = actions > 1 && !sample::is_whole();
        let speeds = [Some(0.5), Some(1.0), Some(2.0), None];
        for speed in speeds.into_iter().filter(|speed| !fewer || matches!(speed, Some(1.0))) {
            let prepared = prepared(actions, speed);
            let report = every_sequence(&prepared, false);
            let now = hazardous(&report);
            assert!(
                now > before || (before, actions) == (0, 1),
                "{speed:?}: {now} of {actions} actions after {before}"
            );
            assert_eq!(now == 0, (speed, actions) == (Some(0.5), 1));
            assert_eq!(report.settings.arm_speed_m_s, speed);
            before = now;
            for hazard in &report.hazards {
                free.reset().unwrap();
                let ends = hazard.actions.iter().map(|action| free.take(*action).unwrap().end);
                let ends: Vec<Option<End>> = ends.take_while(|end| *end != Some(End::Unsafe)).collect();
                assert!(ends.len() < hazard.actions.len(), "{hazard:?}");
                let sooner = free.take_findings().into_iter().map(|found| found.time_s).fold(f64::INFINITY, f64::min);
                assert!(sooner <= hazard.time_s + 1e-9, "{sooner} {hazard:?}");
            }
        }
    }
}
