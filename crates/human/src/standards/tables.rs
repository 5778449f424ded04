//! Every table of this floor with its origin: those that scans rest on, and those of separation distances.

use super::provenance::Table;
use super::{anthropometry, body_area, iso_13849, iso_13854, iso_13855, iso_13857, iso_ts_15066};

/// The tables that every scan uses.
pub fn of_every_scan() -> impl Iterator<Item = Table> {
    iso_ts_15066::TABLES
        .into_iter()
        .chain(iso_13849::TABLES)
        .chain(iso_13855::TABLES)
        .chain(iso_13857::TABLES)
        .chain(anthropometry::TABLES)
}

/// Those that clamping adds.
pub fn of_clamping() -> impl Iterator<Item = Table> {
    iso_13854::TABLES.into_iter()
}

/// Those that pressure adds.
pub fn of_pressure() -> impl Iterator<Item = Table> {
    body_area::TABLES.into_iter()
}

/// Every table of this floor.
pub fn tables() -> impl Iterator<Item = Table> {
    of_every_scan().chain(of_clamping()).chain(of_pressure())
}

/// Every table that separation distances rest on.
pub fn distance_tables() -> impl Iterator<Item = Table> {
    iso_13855::TABLES.into_iter().chain(iso_13855::DISTANCE_TABLES).chain(iso_13857::OPENING_TABLES)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    /// As long as no purchased text was compared, no table may claim so.
    #[test]
    fn every_table_admits_that_it_is_unverified() {
        assert!(tables().chain(distance_tables()).all(|table| !table.verified));
    }

    #[test]
    fn tables_are_told_apart_and_complete() {
        let ids: BTreeSet<_> = tables().map(|table| table.id).collect();
        assert_eq!(ids.len(), tables().count());
        for standard in ["iso_ts_15066", "iso_13849", "iso_13855", "iso_13857", "ansur_ii"] {
            assert!(ids.iter().any(|id| id.starts_with(standard)), "{standard}");
        }
        let more: BTreeSet<_> = distance_tables().map(|table| table.id).collect();
        assert!(more.len() == distance_tables().count() && more.intersection(&ids).count() == 1);
        for table in tables().chain(distance_tables()) {
            for text in [table.title, table.source, table.confidence] {
                assert!(!text.is_empty() && !text.contains("  "), "{}: {text}", table.id);
            }
        }
    }
}
