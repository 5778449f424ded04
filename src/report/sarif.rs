//! The hazards as SARIF 2.1.0, for services that show findings beside the files of a change: each points to the line of
//! the robot link in the cell file.

use serde_json::{Value, json};

use super::baseline::{Baseline, Standing};
use super::model::{Hazard, ScanReport};
use crate::hazard::Class;

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
    let (name, version) = report.tool.split_once(' ').unwrap_or((&report.tool, ""));
    let rule = |class: Class, short: &str, full: &str| {
        json!({
            "id": rule_id(class),
            "shortDescription": { "text": short },
            "fullDescription": { "text": full },
            "defaultConfiguration": { "level": "error" },
        })
    };
    json!({
        "$schema": "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json",
        "version": "2.1.0",
        "runs": [{
            "tool": { "driver": {
                "name": name,
                "semanticVersion": version,
                "rules": [
                    rule(
                        Class::Force,
                        "A person can be hit harder than allowed",
                        &format!("The potential collision force exceeds the limit of the body region, {}.", report.standard_edition),
                    ),
                    rule(
                        Class::HeadContact,
                        "A moving robot can touch the head or the throat",
                        "Contact of a moving robot with skull, forehead or face is not permissible whatever the force.",
                    ),
                ],
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
            json!({ "location": { "physicalLocation": place(), "message": { "text": format!("the person: {action}") } } })
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
            "limit_n": hazard.limit_n,
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
