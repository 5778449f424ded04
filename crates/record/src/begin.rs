//! Where and when a person begins.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Where and when a person begins.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct InitialConditionRecord {
    /// Floor plan, m.
    pub xy_m: [f64; 2],
    /// Heading from +x towards +y, degrees.
    pub heading_deg: f64,
    /// Time from the FMU's own start, s.
    pub begins_s: f64,
}

impl InitialConditionRecord {
    /// For comparisons: to the last bit.
    #[must_use]
    pub fn bits(&self) -> [u64; 4] {
        let Self { xy_m: [x, y], heading_deg, begins_s } = *self;
        [x, y, heading_deg, begins_s].map(f64::to_bits)
    }

    /// For people.
    #[must_use]
    pub fn words(&self) -> String {
        let [x, y] = self.xy_m;
        let heading = self.heading_deg;
        format!(
            "at ({x:.2}, {y:.2}) m, looking towards {heading:.0} degrees, {:.2} s after the FMU's start",
            self.begins_s
        )
    }
}
