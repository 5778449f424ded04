//! The rule that a file is not so long that it holds more than one idea.

use std::collections::BTreeMap;

use crate::exceptions::{Found, add};

/// Lines of a file.
pub const MOST: usize = 500;

/// How many lines each file has, of texts by path.
#[must_use]
pub fn lines(texts: &BTreeMap<String, String>) -> Found {
    let mut found = Found::new();
    for (path, text) in texts {
        add(&mut found, path, "", text.lines().count());
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exceptions::{Exception, wrong};
    use crate::sources::rust;

    /// Files that were too long when the rule was made. Take out what is mended; add nothing.
    const LISTED: [Exception; 32] = [
        ("crates/cell/src/cell/binding.rs", "", 697),
        ("crates/cell/src/cell/design_parameter.rs", "", 674),
        ("crates/fmu-host/src/host/recall.rs", "", 577),
        ("crates/human/src/human/distance_field.rs", "", 526),
        ("crates/human/src/human/floor.rs", "", 542),
        ("crates/human/src/human/reach.rs", "", 741),
        ("crates/human/src/human/reach_tests.rs", "", 782),
        ("crates/reachability/src/history_search.rs", "", 577),
        ("crates/reachability/src/lib.rs", "", 636),
        ("crates/reachability/src/reading_regions.rs", "", 526),
        ("crates/report/src/survey.rs", "", 585),
        ("crates/search/src/exhaustive.rs", "", 634),
        ("crates/sequences/src/lib.rs", "", 658),
        ("crates/simulation/src/encounter.rs", "", 578),
        ("crates/simulation/src/robots.rs", "", 550),
        ("crates/simulation/src/simulation.rs", "", 723),
        ("crates/simulation/src/world/through_plane.rs", "", 556),
        ("fmus/models/c_interface3_tests.rs", "", 572),
        ("fmus/models/cells/workcell.rs", "", 551),
        ("fmus/models/fmi2.rs", "", 540),
        ("fmus/models/fmi3.rs", "", 700),
        ("src/scan/prepare.rs", "", 545),
        ("src/scan/probe.rs", "", 567),
        ("src/scan/reachability.rs", "", 719),
        ("src/scan/risk_reduction/checks.rs", "", 519),
        ("src/scan/risk_reduction/minimal_change.rs", "", 561),
        ("tests/suite/advice.rs", "", 676),
        ("tests/suite/anywhere.rs", "", 721),
        ("tests/suite/common/twin/clamp.rs", "", 674),
        ("tests/suite/hostile_fmus.rs", "", 521),
        ("tests/suite/planted_memories.rs", "", 807),
        ("tests/suite/ssp.rs", "", 544),
    ];

    #[test]
    fn no_file_is_too_long() {
        let found = lines(&rust().unwrap());
        let wrong = wrong(&found, MOST, &LISTED);
        assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    }

    #[test]
    fn a_line_too_many_is_told_and_one_less_is_not() {
        let told = |count: usize| {
            let texts = BTreeMap::from([("a.rs".to_owned(), "// x\n".repeat(count))]);
            wrong(&lines(&texts), MOST, &[])
        };
        assert!(told(500).is_empty());
        assert_eq!(told(501), ["a.rs : 501, and at most 500 are allowed"]);
    }
}
