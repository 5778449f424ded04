//! Hazards, causes and scans made up for tests of what is written of them.

use serde_json::json;

use super::cause::Cause;
use super::hazard::Hazard;
use super::model::{Headline, SCHEMA_VERSION, STANDARD_EDITION, ScanReport, Settings, Spent, Subject, Verdict};
use crate::coverage::Coverage;
use crate::obligations::verdict::SearchEnd;
use crate::obligations::{Engine, Need, Obligations, Point, Reply};
use fmi_hazard_criteria::Criterion;
use fmu_self_test::{Agreement, Motion, SelfTest};

/// A hand is hit by so many times its limit, which is 100 N here.
pub fn hazard(id: &str, ratio: f64) -> Hazard {
    let force_n = 100.0 * ratio;
    let told = json!({
        "id": id,
        "confirmed": true,
        "class": "force",
        "body_region": "hand",
        "robot_link": "gripper",
        "force_n": force_n,
        "limit_n": 100.0,
        "ratio": ratio,
        "directed_force_n": force_n,
        "directed_ratio": ratio,
        "speed_m_s": 0.5,
        "approach_m_s": 0.5,
        "safe_below_m_s": 0.4,
        "effective_mass_kg": 10.0,
        "time_s": 0.2,
        "contact_point_m": [0.0, 0.0, 1.0],
        "body_point_m": [0.0, 0.0, 1.0],
        "distance_m": 0.0,
        "person_xy_m": [0.5, 0.0],
        "person_heading_deg": 180.0,
        "bend_fraction": 0.0,
        "sensors": [],
        "actions": ["stop/upright"],
        "first_iteration": 1,
        "times_found": 1,
        "earliest_time_s": 0.2,
        "shortest": { "actions": ["stop/upright"], "time_s": 0.2, "force_n": force_n, "ratio": ratio },
    });
    serde_json::from_value(told).expect("made up here")
}

/// What hazards of these ids have in common.
pub fn cause(id: &str, hazards: &[&str]) -> Cause {
    let told = json!({
        "id": id,
        "sentence": "No sensor reports the person.",
        "robot": "robot",
        "part": "arm",
        "sensors": [],
        "worst": hazards[0],
        "class": "force",
        "force_n": 150.0,
        "limit_n": 100.0,
        "ratio": 1.5,
        "earliest_time_s": 0.2,
        "confirmed": hazards.len(),
        "hazards": hazards,
        "lines": [],
    });
    serde_json::from_value(told).expect("made up here")
}

/// A cell without FMUs.
pub fn subject() -> Subject {
    Subject {
        cell: "made up".to_owned(),
        cell_found: "cell.toml".to_owned(),
        cell_sha256: String::new(),
        files: Vec::new(),
        path: "cell.toml".to_owned(),
        cell_file: None,
        fmus: Vec::new(),
        couplings: Vec::new(),
        beginning: None,
    }
}

/// A scan that found these.
pub fn report(hazards: Vec<Hazard>, causes: Vec<Cause>) -> ScanReport {
    ScanReport {
        schema_version: SCHEMA_VERSION,
        tool: "fmi-hazard".to_owned(),
        verdict: Verdict::of(SearchEnd { found: !hazards.is_empty(), ..SearchEnd::default() }, &all_shown()),
        headline: Headline::default(),
        subject: subject(),
        settings: settings(),
        causes,
        hazards,
        certificate: None,
        residual: None,
        coverage: Coverage::new(0),
        cycle: None,
        spent: Spent { iterations: 1, actions: 1, fmu_steps: 10, fmu_states: 1, contact_checks: 10, arm_checks: 10 },
        speeds: Vec::new(),
        faults: Vec::new(),
        self_test: self_test(),
        standard_edition: STANDARD_EDITION,
        tables: Vec::new(),
        obligations: all_shown(),
        warnings: Vec::new(),
    }
}

fn settings() -> Settings {
    Settings {
        strategy: "random".to_owned(),
        seed: 1,
        iterations: 1,
        stop_at_first: false,
        posture_sweep: true,
        actions_per_sequence: 1,
        action_s: 0.2,
        contact_check_interval_s: 0.02,
        reach_tolerance_m: 0.02,
        speed_criterion: Criterion::Absolute,
        criteria: None,
        arm_speed_m_s: None,
        held_m: None,
        also: Vec::new(),
        run_m_s: None,
        second: None,
        controls: Vec::new(),
        until_s: None,
        presses: None,
        begins: None,
        seen_at_start: Vec::new(),
        body: None,
        floor_m: None,
        start_region_m: None,
    }
}

fn self_test() -> SelfTest {
    SelfTest {
        steps: 10,
        step_s: 0.02,
        inputs: 0,
        outputs: 1,
        deterministic: Agreement::Exact,
        second_instance: Agreement::NotOffered,
        restore: Agreement::NotOffered,
        fork: Agreement::NotOffered,
        fresh_process: Agreement::NotOffered,
        reset: Agreement::NotOffered,
        serialize: Agreement::NotOffered,
        half_steps: Motion::default(),
        event_mode: Motion::default(),
        uses_event_mode: false,
        remarks: Vec::new(),
        bytes_per_state: None,
        output_range: 1.0,
    }
}

/// As if everything were shown.
fn all_shown() -> Obligations {
    struct Everything;
    impl Engine for Everything {
        fn reply(&self, _: Need) -> Reply {
            Reply::Points(vec![Point::shown("all of it")])
        }
    }
    Obligations::of(&Everything)
}
