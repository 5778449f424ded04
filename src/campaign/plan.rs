//! From a campaign file to its plan: the cells that follow from it, their beginnings, and a hash of each scan.

use std::path::Path;

use super::description::Description;
use super::manifest::{CellEntry, MANIFEST, Manifest, SCHEMA, ScanEntry, hash, tool};
use super::variants::{Variant, variants};
use super::{CampaignError, sealed};
use crate::cell::find::open;
use crate::record::begin::InitialConditionRecord;

/// Most scans of a campaign.
const MOST_SCANS: usize = 1_000_000;

/// Plans the campaign of the file at `path` in `folder`. What was planned there before is forgotten; results stay, and count again
/// where nothing that they depend on has changed.
///
/// # Errors
/// When the campaign file or a cell is wrong, or nothing can be written.
pub(crate) fn plan(path: &Path, folder: &Path) -> Result<Manifest, CampaignError> {
    let (description, text) = Description::read(path)?;
    std::fs::create_dir_all(folder).map_err(CampaignError::machine("make the folder", folder))?;
    let tool = tool();
    let (mut cells, mut scans) = (Vec::new(), Vec::new());
    for Variant { path: own, text, at, body, of } in variants(&description, path, folder)? {
        let file = folder.join(&own);
        if let Some(text) = text {
            sealed::write(&file, text.as_bytes())?;
        }
        let opened = open(&file, None)?;
        cells.push(CellEntry::new(&own, &of, at, body, &opened));
        let seeds: Vec<Option<u64>> = match description.search.seeds.as_slice() {
            [] => vec![None],
            seeds => seeds.iter().copied().map(Some).collect(),
        };
        let step_s = opened.cell.step_s;
        for strategy in &description.search.strategies {
            for &seed in &seeds {
                for (number, beginning) in (1..).zip(&opened.cell.beginnings) {
                    let begins = InitialConditionRecord {
                        xy_m: beginning.start.xy_m(),
                        heading_deg: beginning.start.heading_deg(),
                        begins_s: beginning.begins_s(step_s),
                    };
                    let (id, cell, strategy) = (String::new(), cells.len() - 1, strategy.clone());
                    let entry = ScanEntry { id, cell, beginning: number, begins, strategy, seed };
                    scans.push(ScanEntry::new(&tool, &description.search, &cells, entry));
                }
            }
        }
        if scans.len() > MOST_SCANS {
            return Err(CampaignError::Description {
                path: path.to_owned(),
                what: format!("it makes more than {MOST_SCANS} scans"),
                help: "take fewer values, starts or times".to_owned(),
            });
        }
    }
    let sweeps = description.axes().into_iter().map(|axis| (axis.name, axis.unit)).collect();
    let manifest = Manifest {
        schema_version: SCHEMA,
        tool,
        campaign: description.name,
        campaign_sha256: hash(text.as_bytes()),
        sweeps,
        search: description.search,
        cells,
        scans,
    };
    let text = serde_json::to_string_pretty(&manifest).map_err(|e| CampaignError::Ours(e.to_string()))?;
    sealed::write(&folder.join(MANIFEST), (text + "\n").as_bytes())?;
    Ok(manifest)
}
