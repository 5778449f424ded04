//! `fmi-hazard schema`: the JSON Schema of the cell file.

use super::exit::{Failure, NO_HAZARD};
use super::output;

pub(super) fn run() -> Result<u8, Failure> {
    output::json(&format!("{:#}\n", crate::cell::json_schema()));
    Ok(NO_HAZARD)
}
