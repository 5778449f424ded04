//! A scan as it stands in its `scan.json`, read back: what a replay, a comparison and a baseline need of it.

use std::path::{Path, PathBuf};

use path_clean::clean;
use serde::Deserialize;

use super::begin::InitialConditionRecord;
use super::cause::{Cause, CauseAdvice};
use super::hazard::Hazard;
use super::model::{FileSubject, FmuSubject, NumberedInitialCondition, SCHEMA_VERSION, Verdict};
use super::narrower::Narrower;
use super::reachability::REACHABILITY;
use super::scan_question::ScanQuestion;
use crate::obligations::Obligations;

/// A scan that was written to a file.
#[derive(Clone, Debug, Deserialize)]
pub struct Recorded {
    /// Name and version of the tool.
    pub tool: String,
    /// Overall outcome.
    pub verdict: Verdict,
    /// What it rests on; nothing if it does not say.
    #[serde(default)]
    pub obligations: Obligations,
    /// What was scanned.
    pub subject: RecordedSubject,
    /// How it was searched.
    pub settings: serde_json::Map<String, serde_json::Value>,
    /// Hazards that belong together, worst first.
    #[serde(default)]
    pub causes: Vec<Cause>,
    /// Hazards, worst first.
    pub hazards: Vec<Hazard>,
    /// What an exhaustive search covered.
    pub certificate: Option<RecordedCertificate>,
    /// Edition of the limits.
    pub standard_edition: String,
    /// The folder that it was read from.
    #[serde(skip)]
    pub folder: PathBuf,
}

impl Recorded {
    /// What it looked for; none if it does not say.
    #[must_use]
    pub fn looks(&self) -> Option<ScanQuestion> {
        ScanQuestion::of(&self.settings)
    }

    /// Where and when its person begins, of a scan from a start; none if it does not say. Versions that did not always write it
    /// down did so where a cell had several beginnings.
    #[must_use]
    pub fn begins(&self) -> Option<InitialConditionRecord> {
        let of_subject = || self.subject.beginning.as_ref().map(NumberedInitialCondition::begin);
        self.looks().and_then(|looks| looks.begins).or_else(of_subject)
    }

    /// Whether it would have told this hazard of an earlier scan if it were still there.
    #[must_use]
    pub fn would_report(&self, earlier: &Self, hazard: &Hazard) -> bool {
        self.complete() && self.narrower(earlier, hazard).is_none()
    }

    /// Why it may not have told this hazard of an earlier scan though it is still there, if it is complete; nothing if it would have.
    #[must_use]
    pub fn narrower(&self, earlier: &Self, hazard: &Hazard) -> Option<Narrower> {
        if self.standard_edition != earlier.standard_edition {
            return Some(Narrower::Edition);
        }
        let Some((mut mine, mut its)) = self.looks().zip(earlier.looks()) else { return Some(Narrower::NotRecorded) };
        (mine.begins, its.begins) = (self.begins(), earlier.begins());
        if self.subject.is_cell(&earlier.subject.cell_sha256, &earlier.subject.files) {
            // What one of them does not say of the same file, the other does.
            mine.or_of(&its);
            its.or_of(&mine);
        }
        mine.narrower(&its, hazard, self.hazards.iter().map(|hazard| hazard.class))
    }
}

impl RecordedSubject {
    /// Whether it is the same cell file, and all that it extends or names besides FMUs is the same.
    #[must_use]
    pub fn is_cell(&self, sha256: &str, files: &[FileSubject]) -> bool {
        let contents = |files: &[FileSubject]| files.iter().map(|file| file.sha256.clone()).collect::<Vec<_>>();
        self.cell_sha256 == sha256 && contents(&self.files) == contents(files)
    }
}

/// Whether a scan is complete: whatever it did not find is not there, within what it asks. All that calls something gone
/// asks this.
#[must_use]
pub fn is_complete(verdict: Verdict, strategy: &str, certified: bool) -> bool {
    match verdict {
        // Where nothing moved, or nobody was seen, nothing was shown; nor where it was ended.
        Verdict::Inconclusive | Verdict::FmuFailed | Verdict::Interrupted => false,
        // From anywhere the worst of each region and link is told where something is found.
        Verdict::HazardsFound | Verdict::NoneFound(_) if strategy == REACHABILITY => verdict.is_clean(),
        Verdict::HazardsFound | Verdict::NoneFound(_) => certified,
    }
}

/// What was scanned.
#[derive(Clone, Debug, Deserialize)]
pub struct RecordedSubject {
    /// Name of the cell.
    pub cell: String,
    /// Path that was scanned, seen from the folder of the result.
    pub path: PathBuf,
    /// The cell file, if one was named beside the path; seen from there, too.
    pub cell_file: Option<PathBuf>,
    /// SHA-256 of the cell file.
    pub cell_sha256: String,
    /// The system of FMUs, robot descriptions, meshes.
    #[serde(default)]
    pub files: Vec<FileSubject>,
    /// The FMUs.
    pub fmus: Vec<FmuSubject>,
    /// Which of the cell's beginnings it was.
    #[serde(default)]
    pub beginning: Option<NumberedInitialCondition>,
}

/// What an exhaustive search covered.
#[derive(Clone, Debug, Deserialize)]
pub struct RecordedCertificate {
    /// Whether every sequence was accounted for.
    pub complete: bool,
}

/// Why a recorded scan cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum RecordedError {
    /// The file cannot be read.
    #[error("cannot read {}: {cause}", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// Why.
        cause: std::io::Error,
    },
    /// It is something else.
    #[error("{} is not a scan result: {cause}", path.display())]
    NotAScan {
        /// The file.
        path: PathBuf,
        /// Why.
        cause: serde_json::Error,
    },
    /// Another version wrote it.
    #[error("{} has format {version}, this version reads {SCHEMA_VERSION}", path.display())]
    Version {
        /// The file.
        path: PathBuf,
        /// Its format.
        version: u64,
    },
}

impl RecordedError {
    /// What to do about it.
    #[must_use]
    pub const fn help(&self) -> &'static str {
        match self {
            Self::Unreadable { .. } | Self::NotAScan { .. } => {
                "give the scan.json of a scan, or the folder with its results"
            }
            Self::Version { .. } => "scan again with this version",
        }
    }
}

impl Recorded {
    /// What the scan found against the cause of a hazard, if it looked and found something.
    #[must_use]
    pub fn advice_for(&self, hazard: &str) -> Option<&CauseAdvice> {
        let cause = self.causes.iter().find(|cause| cause.hazards.iter().any(|id| id == hazard))?;
        cause.advice.as_ref().filter(|advice| !advice.changes.is_empty())
    }

    /// Reads a `scan.json`, or the one in a folder.
    ///
    /// # Errors
    /// When it cannot be read, is no scan, or has another format.
    pub fn read(path: &Path) -> Result<Self, RecordedError> {
        let path = if path.is_dir() { path.join("scan.json") } else { path.to_owned() };
        let text =
            std::fs::read_to_string(&path).map_err(|cause| RecordedError::Unreadable { path: path.clone(), cause })?;
        let not_a_scan = |cause| RecordedError::NotAScan { path: path.clone(), cause };
        let value: serde_json::Value = serde_json::from_str(&text).map_err(not_a_scan)?;
        // Another format may lack what is read below; its version says so better.
        if let Some(version) = value["schema_version"].as_u64().filter(|&v| v != u64::from(SCHEMA_VERSION)) {
            return Err(RecordedError::Version { path, version });
        }
        let recorded: Self = serde_json::from_value(value).map_err(not_a_scan)?;
        Ok(Self { folder: path.parent().unwrap_or(Path::new("")).to_owned(), ..recorded })
    }

    /// Where what was scanned is, if it is still beside the result as it was.
    #[must_use]
    pub fn subject_path(&self) -> PathBuf {
        found(&self.subject.path, &self.folder)
    }

    /// The same of the cell file, if one was named beside it.
    #[must_use]
    pub fn cell_file(&self) -> Option<PathBuf> {
        self.subject.cell_file.as_ref().map(|file| found(file, &self.folder))
    }

    /// Whether it is about people from anywhere, and none of the cell's beginnings.
    #[must_use]
    pub fn is_from_anywhere(&self) -> bool {
        self.strategy() == REACHABILITY
    }

    fn strategy(&self) -> &str {
        self.settings.get("strategy").and_then(serde_json::Value::as_str).unwrap_or_default()
    }

    /// Whether it is complete, see [`is_complete`].
    #[must_use]
    pub fn complete(&self) -> bool {
        let certified = self.certificate.as_ref().is_some_and(|certificate| certificate.complete);
        // One of an earlier version does not say what it rests on.
        is_complete(self.verdict, self.strategy(), certified) && self.obligations.clean().is_some()
    }
}

/// What a result in `folder` names with `path`. Results of earlier versions name it as it was given, from the folder in which
/// the scan was started.
#[must_use]
pub fn found(path: &Path, folder: &Path) -> PathBuf {
    let beside = clean(folder.join(path));
    // Where `..` goes through a link, the system knows better.
    let ways = [beside.clone(), folder.join(path), path.to_owned()];
    ways.into_iter().find(|way| way.exists()).unwrap_or(beside)
}
