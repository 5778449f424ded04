//! What commands print for programs, as one schema: with `--format json`, and with `--progress json`.

use schemars::JsonSchema;
use schemars::generate::SchemaSettings;
use serde::Serialize;

use super::{check, events, replay};
use crate::record::model::ScanReport;
use crate::record::reachability::ReachabilityResult;
use crate::report::difference::Difference;
use crate::report::distance::Distances;
use crate::report::explanation::Explanation;
use crate::report::verified;

/// Each property is what the command of this name prints with `--format json`, but for the last three.
#[derive(Serialize, JsonSchema)]
struct Commands<'a> {
    /// `scan`: scan.json, as in the schema of its own.
    scan: ScanReport,
    /// `check`.
    check: check::CheckOutput,
    /// `distance`.
    distance: Distances,
    /// `explain`.
    explain: Explanation,
    /// `compare`.
    compare: Difference,
    /// `replay --changed`: a row a hazard.
    replay_changed: Vec<verified::Row>,
    /// `replay`: an entry a hazard.
    replay: Vec<replay::Replayed>,
    /// A line on standard error of any command with `--progress json`.
    progress: events::Event<'a>,
    /// anywhere.json, which a scan from anywhere writes, and prints when it is asked for nothing else.
    anywhere: ReachabilityResult,
}

/// Their schema.
pub(super) fn schema() -> serde_json::Value {
    let settings = SchemaSettings::draft2020_12().for_serialize();
    settings.into_generator().into_root_schema_for::<Commands<'_>>().to_value()
}
