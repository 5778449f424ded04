//! The hazards as SARIF 2.1.0, for services that show findings beside the files of a change: each points to the line of
//! the robot link in the cell file.

use serde_json::{Value, json};

use super::baseline::{Baseline, Standing};
use crate::hazard::Class;
use fmi_hazard_record::hazard::Hazard;
use fmi_hazard_record::model::ScanReport;

/// What of the cell file a finding points to.
#[derive(Clone, Debug)]
pub struct CellFile {
    /// Its path as a URI reference: relative where the scan was given a relative one.
    pub uri: String,
    /// Line of each link, from 1, with the file that it is in if that is one that the cell file extends.
    pub lines: std::collections::BTreeMap<String, (Option<String>, usize)>,
}

/// The log.
#[must_use]
pub fn render(report: &ScanReport, file: &CellFile, baseline: Option<&Baseline>) -> Value {
    let mut others: Vec<Class> = report.hazards.iter().map(|hazard| hazard.class).collect();
    others.retain(|class| class.beside_force().is_some());
    others.sort_unstable();
    others.dedup();
    let (name, version) = report.tool.split_once(' ').unwrap_or((&report.tool, ""));
    let rule = |class: Class, short: &str, full: &str| {
        json!({
            "id": rule_id(class),
            "shortDescription": { "text": short },
            "fullDescription": { "text": full },
            "defaultConfiguration": { "level": "error" },
        })
    };
    let rules: Vec<Value> = [
        rule(
            Class::Force,
            "A person can be hit harder than allowed",
            &format!(
                "The potential collision force exceeds the limit of the body region, {}.",
                report.standard_edition
            ),
        ),
        rule(
            Class::HeadContact,
            "A moving robot can touch the head or the throat",
            "Contact of a moving robot with skull, forehead or face is not permissible whatever the force.",
        ),
    ]
    .into_iter()
    .chain(others.into_iter().map(|class| {
        let (short, full) = other_rule(class);
        rule(class, short, full)
    }))
    .collect();
    json!({
        "$schema": "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json",
        "version": "2.1.0",
        "runs": [{
            "tool": { "driver": {
                "name": name,
                "semanticVersion": version,
                "rules": rules,
            } },
            "automationDetails": { "id": format!("fmi-hazard/{}/", report.subject.title()) },
            "artifacts": [{ "location": { "uri": file.uri }, "hashes": { "sha-256": report.subject.cell_sha256 } }],
            "results": report.hazards.iter().map(|hazard| result(report, hazard, file, baseline)).collect::<Vec<_>>(),
        }],
    })
}

const fn rule_id(class: Class) -> &'static str {
    match class {
        Class::Force => "force-limit",
        Class::HeadContact => "head-contact",
        Class::Clamping => "clamping",
        Class::Pressure => "pressure-limit",
        Class::MovingContact => "moving-contact",
        Class::Separation => "separation-distance",
    }
}

/// What a rule of another criterion than the transient force is.
const fn other_rule(class: Class) -> (&'static str, &'static str) {
    match class {
        Class::Clamping => (
            "A part of the body can be clamped",
            "Between the robot and something that does not give way, the quasi-static limit of the body region is exceeded.",
        ),
        Class::Pressure => {
            ("A person can be hit by something too small", "The pressure exceeds the limit of the body area.")
        }
        Class::MovingContact => {
            ("A robot that moves can be touched", "No contact with a robot that moves is allowed in this cell.")
        }
        Class::Separation => (
            "A robot moves too near to a person",
            "The distance is shorter than the protective separation distance (ISO/TS 15066, 5.5.4).",
        ),
        Class::Force | Class::HeadContact => ("", ""),
    }
}

fn result(report: &ScanReport, hazard: &Hazard, file: &CellFile, baseline: Option<&Baseline>) -> Value {
    let cause = report.causes.iter().find(|cause| cause.hazards.contains(&hazard.id)).map(|cause| &cause.id);
    let place = || {
        let mut place = json!({ "artifactLocation": { "uri": file.uri, "index": 0 } });
        if let Some((base, line)) = file.lines.get(&hazard.robot_link) {
            place["region"] = json!({ "startLine": line });
            if let Some(base) = base {
                place["artifactLocation"] = json!({ "uri": base });
            }
        }
        place
    };
    // Some services refuse a whole file for one location without a file.
    let steps: Vec<Value> = hazard
        .actions
        .iter()
        .map(|action| {
            let who = if action.is_of_two() { "both people" } else { "the person" };
            json!({ "location": { "physicalLocation": place(), "message": { "text": format!("{who}: {action}") } } })
        })
        .collect();
    let mut out = json!({
        "ruleId": rule_id(hazard.class),
        "level": "error",
        "message": { "text": hazard.sentence() },
        "locations": [{
            "physicalLocation": place(),
            "logicalLocations": [
                { "name": hazard.robot_link, "fullyQualifiedName": format!("robot/{}", hazard.robot_link), "kind": "object" },
                { "name": hazard.body_region.to_string(), "fullyQualifiedName": format!("person/{}", hazard.body_region), "kind": "object" },
            ],
        }],
        "partialFingerprints": { "hazardId/v1": hazard.id },
        "codeFlows": [{ "threadFlows": [{ "locations": steps }] }],
        "properties": {
            "id": hazard.id,
            "cause": cause,
            "force_n": hazard.deciding_force_n(),
            "limit_n": hazard.deciding_limit_n(),
            "ratio": hazard.ratio,
            "time_s": hazard.time_s,
            "confirmed": hazard.confirmed,
        },
    });
    if let Some(baseline) = baseline {
        out["baselineState"] = json!(match baseline.standing(hazard) {
            Standing::New => "new",
            Standing::Worse { .. } => "updated",
            Standing::Known => "unchanged",
        });
    }
    out
}
