//! What people decided about hazards: a file of theirs beside the cell file, which scans read and never write.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

/// Name of the file.
pub(crate) const FILE: &str = "assessments.json";

/// Format of the file that is read.
const FORMAT: u32 = 1;

/// The file.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize)]
struct File {
    format: u32,
    assessments: BTreeMap<String, Assessment>,
}

/// One cause or hazard assessed, fields as in ISO 12100 (5.5, 5.6, 6); empty where nobody wrote anything.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Assessment {
    /// Who does what there: the task (ISO 12100, 5.3).
    #[serde(skip_serializing_if = "String::is_empty")]
    pub task: String,
    /// Severity of harm.
    pub severity: String,
    /// Exposure of persons.
    pub exposure: String,
    /// Possibility of avoiding or limiting harm.
    pub avoidance: String,
    /// Protective measure.
    pub measure: String,
    /// Residual risk.
    pub residual: String,
    /// What was decided.
    pub decision: String,
    /// By whom.
    pub by: String,
    /// When.
    pub date: String,
}

/// Assessments by the id of a cause, which then hold for all its hazards, or of a hazard.
pub type Assessments = BTreeMap<String, Assessment>;

/// Why the file cannot be used.
#[derive(Debug, thiserror::Error)]
#[error("{} cannot be used: {cause}", path.display())]
pub struct AssessmentError {
    path: PathBuf,
    cause: String,
}

/// The assessments beside the cell that `path` (a cell file or an FMU) names; none without a file.
///
/// # Errors
/// When there is a file that cannot be read or is something else: then decisions would silently be ignored.
pub fn beside(path: &Path) -> Result<Assessments, AssessmentError> {
    let path = path.with_file_name(FILE);
    let failed = |cause: String| AssessmentError { path: path.clone(), cause };
    let text = match std::fs::read_to_string(&path) {
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(Assessments::new()),
        text => text.map_err(|error| failed(error.to_string()))?,
    };
    let file: File = serde_json::from_str(&text).map_err(|error| failed(error.to_string()))?;
    if file.format != FORMAT {
        return Err(failed(format!("it has format {}, this version reads {FORMAT}", file.format)));
    }
    Ok(file.assessments)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_there_is_read_and_what_is_wrong_is_told() {
        let dir = tempfile::TempDir::new().unwrap();
        let cell = dir.path().join("cell.toml");
        assert_eq!(beside(&cell).unwrap(), Assessments::new());
        let write = |text: &str| std::fs::write(dir.path().join(FILE), text).unwrap();
        write(r#"{"format":1,"cell":"c","assessments":{"H-000001":{"severity":"S2","decision":"reduce"}}}"#);
        let read = beside(&cell).unwrap();
        assert_eq!((read["H-000001"].severity.as_str(), read["H-000001"].by.as_str()), ("S2", ""));
        for (text, cause) in [("{", "EOF"), (r#"{"format":2,"assessments":{}}"#, "it has format 2")] {
            write(text);
            assert!(beside(&cell).unwrap_err().to_string().contains(cause), "{text}");
        }
    }
}
