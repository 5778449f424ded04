//! Where the numbers come from: one record for each table that is derived from a standard or a survey.
//!
//! Reports print these records, so that nobody takes an unverified table for a certified transcription. Who owns the
//! standard's text may compare and set `verified`.

use schemars::JsonSchema;
use serde::Serialize;

use super::{anthropometry, iso_13855, iso_13857, iso_ts_15066};

/// Origin of one table of numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Table {
    /// Stable id in snake case.
    pub id: &'static str,
    /// Standard or survey, edition, clause, and what the table holds.
    pub title: &'static str,
    /// What the numbers were taken from.
    pub source: &'static str,
    /// How sure they are, in words.
    pub confidence: &'static str,
    /// Whether somebody compared the numbers with the purchased text.
    pub verified: bool,
}

/// Every table of this floor.
pub fn tables() -> impl Iterator<Item = Table> {
    iso_ts_15066::TABLES.into_iter().chain(iso_13855::TABLES).chain(iso_13857::TABLES).chain(anthropometry::TABLES)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    /// As long as no purchased text was compared, no table may claim so.
    #[test]
    fn every_table_admits_that_it_is_unverified() {
        assert!(tables().all(|table| !table.verified));
    }

    #[test]
    fn tables_are_told_apart_and_complete() {
        let ids: BTreeSet<_> = tables().map(|table| table.id).collect();
        assert_eq!(ids.len(), tables().count());
        for standard in ["iso_ts_15066", "iso_13855", "iso_13857", "ansur_ii"] {
            assert!(ids.iter().any(|id| id.starts_with(standard)), "{standard}");
        }
        for table in tables() {
            for text in [table.title, table.source, table.confidence] {
                assert!(!text.is_empty() && !text.contains("  "), "{}: {text}", table.id);
            }
        }
    }
}
