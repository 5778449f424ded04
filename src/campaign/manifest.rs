//! The plan of a campaign on disk: all its scans, each known by a hash of what its result depends on.

use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use sha2::{Digest as _, Sha256};

use super::CampaignError;
use super::description::Search;
use super::values::Values;
use crate::cell::find::OpenedCell;
use crate::record::begin::InitialConditionRecord;
use crate::record::model::FileSubject;
use crate::sim::answers::Share;

/// Name of the plan in the folder of the campaign.
pub(crate) const MANIFEST: &str = "manifest.json";

/// Version of the format.
pub(super) const SCHEMA: u32 = 1;

/// Letters of a hash that names a scan.
const LETTERS: usize = 16;

/// A plan.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Manifest {
    /// Version of the format.
    pub schema_version: u32,
    /// Name and version of the program that planned it, which is that whose results count.
    pub tool: String,
    /// The campaign's name.
    pub campaign: String,
    /// SHA-256 of the campaign file.
    pub campaign_sha256: String,
    /// What is swept, with units.
    pub sweeps: Vec<(String, String)>,
    /// How scans search.
    pub search: Search,
    /// What is scanned.
    pub cells: Vec<CellEntry>,
    /// All scans, in the order of cells, strategies, seeds, beginnings.
    pub scans: Vec<ScanEntry>,
}

/// A cell.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct CellEntry {
    /// Its name.
    pub name: String,
    /// The one of the campaign file that it comes from.
    pub of: String,
    /// Its file, seen from the folder of the campaign.
    pub path: PathBuf,
    /// SHA-256 of the cell file.
    pub sha256: String,
    /// The files that it extends or names, with theirs.
    pub files: Vec<FileSubject>,
    /// SHA-256 of its FMUs, with the names of the units.
    pub fmus: Vec<(String, String)>,
    /// Values of the sweeps.
    #[serde(default, skip_serializing_if = "Values::is_empty")]
    pub at: Values,
    /// The body, if the campaign has several.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub body: Option<String>,
}

/// A scan.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct ScanEntry {
    /// A hash of all that its result depends on.
    pub id: String,
    /// Number of the cell, from 0.
    pub cell: usize,
    /// Number of the beginning, from 1.
    pub beginning: usize,
    /// Where and when that is.
    pub begins: InitialConditionRecord,
    /// How sequences are chosen.
    pub strategy: String,
    /// Seed; the cell's if there is none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seed: Option<u64>,
}

/// A piece of work that is done in one go: a scan, or a part of one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Task {
    /// Number of the scan, from 0.
    pub scan: usize,
    /// Which part; nothing for all of it.
    pub part: Option<Share>,
}

impl CellEntry {
    /// What of a cell results depend on.
    #[must_use]
    pub(crate) fn new(path: &Path, of: &str, at: Values, body: Option<String>, opened: &OpenedCell) -> Self {
        let OpenedCell { cell, fmus, wiring, .. } = opened;
        let file =
            |path: &Path, sha256: &str| FileSubject { path: path.display().to_string(), sha256: sha256.to_owned() };
        let system = wiring.as_ref().map(|w| file(w.path.file_name().unwrap_or_default().as_ref(), &w.sha256));
        Self {
            name: cell.name.clone(),
            of: of.to_owned(),
            path: path.to_owned(),
            sha256: cell.sha256.clone(),
            files: system.into_iter().chain(cell.files.iter().map(|f| file(&f.path, &f.sha256))).collect(),
            fmus: fmus.iter().map(|(name, fmu)| (name.clone(), fmu.sha256().to_owned())).collect(),
            at,
            body,
        }
    }

    /// Whether it is still the same.
    ///
    /// # Errors
    /// When it is not.
    pub(crate) fn same_as(&self, opened: &OpenedCell) -> Result<(), CampaignError> {
        let now = Self::new(&self.path, &self.of, self.at.clone(), self.body.clone(), opened);
        if now == *self {
            return Ok(());
        }
        let what = if now.sha256 != self.sha256 || now.files != self.files { "its cell file" } else { "its FMU" };
        Err(CampaignError::Changed { what: format!("cell `{}` has changed, {what},", self.name) })
    }
}

impl ScanEntry {
    /// The scan of a cell from one of its beginnings.
    #[must_use]
    pub(crate) fn new(tool: &str, search: &Search, cells: &[CellEntry], of: Self) -> Self {
        let cell = &cells[of.cell];
        // How it is divided, and which other strategies and seeds there are, changes nothing in it.
        let own = Search { strategies: Vec::new(), seeds: Vec::new(), parts: 1, ..search.clone() };
        let depends = (
            (tool, &cell.path, &cell.sha256, &cell.files, &cell.fmus),
            (of.beginning, of.begins, &of.strategy, of.seed, own),
        );
        // Plain data: it can always be written.
        let told = serde_json::to_string(&depends).unwrap_or_default();
        Self { id: hash(told.as_bytes())[..LETTERS].to_owned(), ..of }
    }
}

impl Manifest {
    /// The plan in the folder of a campaign, made by this version.
    ///
    /// # Errors
    /// When there is none, or one of another version.
    pub(crate) fn read(folder: &Path) -> Result<Self, CampaignError> {
        let none = |what: String| CampaignError::NoPlan { folder: folder.to_owned(), what };
        let path = folder.join(MANIFEST);
        let text = std::fs::read_to_string(&path).map_err(|e| none(format!("cannot read {}: {e}", path.display())))?;
        let manifest: Self = serde_json::from_str(&text).map_err(|e| none(format!("{}: {e}", path.display())))?;
        if manifest.schema_version != SCHEMA || manifest.tool != tool() {
            return Err(none(format!("{} planned it, and this is {}", manifest.tool, tool())));
        }
        let is_sane =
            |scan: &ScanEntry| scan.cell < manifest.cells.len() && scan.beginning > 0 && scan.id.len() == LETTERS;
        if !manifest.scans.iter().all(is_sane) {
            return Err(none(format!("{} is damaged", path.display())));
        }
        Ok(manifest)
    }

    /// Everything that is to be done, in order. Parts of one search are neighbours.
    #[must_use]
    pub(crate) fn tasks(&self) -> Vec<Task> {
        (0..self.scans.len()).flat_map(|scan| self.tasks_of(scan)).collect()
    }

    /// The same of one scan.
    #[must_use]
    pub(crate) fn tasks_of(&self, scan: usize) -> Vec<Task> {
        match self.search.parts {
            0 | 1 => vec![Task { scan, part: None }],
            of => Share::all(of).map(|share| Task { scan, part: Some(share) }).collect(),
        }
    }

    /// The name of a task; of the result of all parts, as that of the whole scan.
    #[must_use]
    pub(crate) fn name(&self, task: Task) -> String {
        let id = &self.scans[task.scan].id;
        task.part.map_or_else(|| id.clone(), |share| format!("{id}.{}of{}", share.number, share.of))
    }

    /// The task of this name.
    ///
    /// # Errors
    /// When there is none.
    pub(crate) fn task(&self, name: &str) -> Result<Task, CampaignError> {
        let found = self.tasks().into_iter().find(|task| self.name(*task) == name);
        found.ok_or_else(|| CampaignError::NoTask { name: name.to_owned() })
    }

    /// A scan in words.
    #[must_use]
    pub(crate) fn words(&self, scan: usize) -> String {
        let entry = &self.scans[scan];
        let seed = entry.seed.map_or_else(String::new, |seed| format!(", seed {seed}"));
        format!("{}, {}, {}{seed}", self.cells[entry.cell].name, entry.begins.words(), entry.strategy)
    }
}

/// Name and version of this program.
pub(super) fn tool() -> String {
    format!("fmi-hazard {}", env!("CARGO_PKG_VERSION"))
}

/// SHA-256, lower-case hex.
pub(super) fn hash(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Results of before are not taken when anything changes that they depend on, also a mesh or a robot description.
    #[test]
    fn a_scan_has_another_name_when_any_file_of_its_cell_changes() {
        let cell = |file: &str, fmu: &str, table: &str| CellEntry {
            name: "cell".to_owned(),
            of: "cell.toml".to_owned(),
            path: "cell.toml".into(),
            sha256: table.to_owned(),
            files: vec![FileSubject { path: "robot.urdf".to_owned(), sha256: file.to_owned() }],
            fmus: vec![(String::new(), fmu.to_owned())],
            at: Values::default(),
            body: None,
        };
        let id = |cell: CellEntry, seed: u64| {
            let begins = InitialConditionRecord { xy_m: [0.0, -2.0], heading_deg: 90.0, begins_s: 0.0 };
            let scan = ScanEntry {
                id: String::new(),
                cell: 0,
                beginning: 1,
                begins,
                strategy: "random".to_owned(),
                seed: Some(seed),
            };
            ScanEntry::new("tool", &Search::default(), &[cell], scan).id
        };
        let one = id(cell("a", "b", "c"), 1);
        assert_eq!(id(cell("a", "b", "c"), 1), one);
        for other in [id(cell("x", "b", "c"), 1), id(cell("a", "x", "c"), 1), id(cell("a", "b", "x"), 1)] {
            assert_ne!(other, one);
        }
        assert_ne!(id(cell("a", "b", "c"), 2), one);
    }
}
