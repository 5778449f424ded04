//! Where the numbers come from: one record for each table that is derived from a standard or a survey.
//!
//! Reports print these records, so that nobody takes an unverified table for a certified transcription. Who owns the
//! standard's text may compare and set `verified`.

use schemars::JsonSchema;
use serde::Serialize;

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
