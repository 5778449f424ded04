//! What acceptances in a cell file are bound to.

use crate::cell::sha256;
use crate::record::model::Subject;

/// The SHA-256 of the FMU; of several of them that of all of theirs.
pub(super) fn fmu_digest(subject: &Subject) -> String {
    match &subject.fmus[..] {
        [only] => only.sha256.clone(),
        all => {
            let lines = all.iter().map(|fmu| format!("{} {}\n", fmu.unit, fmu.sha256));
            sha256(lines.collect::<String>().as_bytes())
        }
    }
}
