//! The example cells whose flaw the transient force does not see: each is found by its own criterion and by no other, on the part
//! of the body and against the thing that its README names, and the repaired twin has none, with every sequence looked at.

use std::path::Path;

use serde_json::Value;

use crate::common::{examples, fmi_hazard, scan_json};

/// What the README of a flawed cell says.
struct Flaw {
    cell: &'static str,
    criterion: &'static str,
    /// Body regions, each with the worst that the README computes by hand: force, pressure or distance over its limit.
    worst: &'static [(&'static str, f64)],
    links: &'static [&'static str],
    /// What holds the part of the body.
    against: Option<&'static str>,
    /// In the sentence of a cause.
    words: &'static str,
}

const FLAWS: [Flaw; 4] = [
    Flaw {
        cell: "hand-at-table",
        criterion: "clamping",
        // 0.25 m/s with the empty gripper.
        worst: &[("hand", 2.03)],
        links: &["gripper", "tool"],
        against: Some("table"),
        words: "clamps the hand against table",
    },
    Flaw {
        cell: "wall-behind",
        criterion: "clamping",
        worst: &[("chest", 1.40)],
        links: &["part"],
        against: Some("wall"),
        words: "clamps the chest against wall",
    },
    Flaw {
        cell: "sharp-workpiece",
        criterion: "pressure",
        worst: &[("hand", 1.75), ("lower_arm", 2.38)],
        links: &["sheet"],
        against: None,
        words: "presses the",
    },
    Flaw { cell: "short-zone", criterion: "separation", worst: &[], links: &[], against: None, words: "nears the" },
];
