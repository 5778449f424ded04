//! What the page says of a cause.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::standards::BodyRegion;
use fmi_hazard_record::cause::{Cause, CauseAdvice, Change, NO_CHANGE, capitalised};
use fmi_hazard_record::hazard::Hazard;
use fmi_hazard_record::headline::confirmed_of;
use fmi_hazard_record::judged::ratio_words;

/// Of one cause.
#[derive(Serialize)]
pub(super) struct CauseWords {
    /// How bad it is, and by what figures.
    severity: [String; 2],
    /// The force that does not decide, where it is far from the one that does.
    #[serde(skip_serializing_if = "Option::is_none")]
    other: Option<String>,
    /// How many of all sequences, where they were counted.
    #[serde(skip_serializing_if = "Option::is_none")]
    share: Option<String>,
    /// From when on.
    earliest: String,
    /// How many ways, and how many of them are confirmed.
    ways: String,
    /// Of each of its lines what is hit, and how hard.
    lines: Vec<[String; 2]>,
    /// Of each region, worst first: its id, and how hard it is hit.
    regions: Vec<(&'static str, String)>,
    /// Of each change what is left with it, and what it was held against.
    changes: Vec<[String; 2]>,
    /// What to change, in a few words, where no change is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    no_change: Option<String>,
}

impl CauseWords {
    /// Of a cause with its worst hazard.
    pub(super) fn of(cause: &Cause, worst: Option<&Hazard>) -> Self {
        let by_force = cause.class.beside_force().is_none();
        let size = |region: BodyRegion, ratio: f64| match by_force {
            true => ratio_words(region, ratio),
            false => format!("{ratio:.2}x"),
        };
        let begins = worst.and_then(|worst| Some(worst.begins_words(worst.begins?)));
        let ways = confirmed_of(cause.confirmed, cause.hazards.len());
        let changes = |advice: &CauseAdvice| advice.changes.iter().map(change).collect();
        Self {
            severity: cause.measured().worst_first(),
            other: worst.and_then(Hazard::other_force).map(|other| format!("{}.", capitalised(&other))),
            share: cause.share_words(),
            earliest: begins.unwrap_or_else(|| cause.earliest_words()),
            ways: format!("{}, {ways}", cause.ways_words()),
            lines: cause
                .lines
                .iter()
                .map(|line| [line.words().to_owned(), size(line.body_region, line.ratio)])
                .collect(),
            regions: regions(cause),
            changes: cause.advice.as_ref().map_or_else(Vec::new, changes),
            no_change: match &cause.advice {
                None => Some("not looked for".to_owned()),
                Some(advice) if advice.changes.is_empty() => Some(NO_CHANGE.to_owned()),
                Some(_) => None,
            },
        }
    }
}

fn change(change: &Change) -> [String; 2] {
    [change.effect(), change.checked_words()]
}

/// Each region with the worst ratio of its lines, worst first.
fn regions(cause: &Cause) -> Vec<(&'static str, String)> {
    let mut worst: BTreeMap<BodyRegion, f64> = BTreeMap::new();
    for line in &cause.lines {
        let ratio = worst.entry(line.body_region).or_insert(0.0);
        *ratio = ratio.max(line.ratio);
    }
    let mut worst: Vec<(BodyRegion, f64)> = worst.into_iter().collect();
    worst.sort_by(|(_, a), (_, b)| b.total_cmp(a));
    let told = |(region, ratio): (BodyRegion, f64)| {
        let size = ratio_words(region, ratio);
        let stop = if size.ends_with(')') { ":" } else { "" };
        (region.id(), format!("{}{stop} {size}", region.words()))
    };
    worst.into_iter().map(told).collect()
}
