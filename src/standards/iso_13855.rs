//! Approach speeds of ISO 13855: how fast a person walks and a hand moves when safeguards are laid out.

use super::provenance::Table;

/// What stands behind the data of this file.
pub(super) const TABLES: [Table; 1] = [Table {
    id: "iso_13855_approach_speeds",
    title: "ISO 13855:2010 and :2024, approach speeds K: 1600 mm/s walking, 2000 mm/s hand and arm",
    source: "public manuals of safety device makers and guides to both editions",
    confidence: "two independent public sources agree; running, jumping and falling are excluded by the standard",
    verified: false,
}];

/// Walking speed, m/s.
pub const WALKING_SPEED_M_S: f64 = 1.6;

/// Speed of hands and arms, m/s.
pub const HAND_SPEED_M_S: f64 = 2.0;
