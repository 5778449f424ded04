//! The rule that a function asks for few things. A tuple is no way round it: it counts by its members.

use crate::exceptions::{Found, add};
use crate::functions::functions;
use crate::sources::Source;

/// Parameters of a function, `self` not counted.
pub const MOST: usize = 6;

/// How many parameters each function has; those of C are as C has them, and not counted.
#[must_use]
pub fn counts(sources: &[Source]) -> Found {
    let mut found = Found::new();
    for source in sources {
        for function in functions(&source.file) {
            if let Some(parameters) = function.parameters {
                add(&mut found, &source.path, &function.name, parameters);
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exceptions::{Exception, wrong};
    use crate::sources::workspace;

    /// Functions that asked for more when the rule was made. Take out what is mended; add nothing.
    const LISTED: [Exception; 24] = [
        ("crates/cell/src/cell/file/accepted.rs", "assumption", 7),
        ("crates/fmu-host/src/host/selftest.rs", "restore_test", 7),
        ("crates/reachability/src/history_search.rs", "HistorySearch::ask", 7),
        ("crates/reachability/src/machine.rs", "Machine::new", 7),
        ("crates/reachability/src/of_behaviours.rs", "seen_by", 7),
        ("crates/reachability/src/reading_regions.rs", "ReadingRegions::with", 8),
        ("crates/report/src/page.rs", "render", 7),
        ("crates/sequences/src/lib.rs", "Expander::advance", 7),
        ("crates/sequences/src/lib.rs", "Expander::elsewhere", 7),
        ("crates/simulation/src/encounter.rs", "Encounter::arm_over_box", 8),
        ("crates/simulation/src/simulation.rs", "Simulation::sweep", 7),
        ("fmus/models/fmi3.rs", "get", 7),
        ("fmus/models/fmi3.rs", "set", 7),
        ("research/src/comparison.rs", "Comparison::new", 8),
        ("src/campaign/merge.rs", "merge", 7),
        ("src/campaign/run.rs", "run", 7),
        ("src/cli/reachability.rs", "look", 7),
        ("src/scan/exhaustive.rs", "census", 8),
        ("src/scan/fallback.rs", "once", 8),
        ("src/scan/quick.rs", "search", 8),
        ("src/scan/reachability.rs", "AnalysisContext::follow", 8),
        ("src/scan/reachability/behaviours.rs", "AnalysisContext::behaviours", 7),
        ("src/scan/reachability/trial_instants.rs", "Moments::new", 7),
        ("tests/suite/common/twin/clamp.rs", "Scene::body_at", 7),
    ];

    #[test]
    fn no_function_asks_for_too_much() {
        let found = counts(&workspace().unwrap());
        let wrong = wrong(&found, MOST, &LISTED);
        assert!(found.len() > 3000 && wrong.is_empty(), "{} functions, of which:\n{}", found.len(), wrong.join("\n"));
    }

    #[test]
    fn one_too_many_is_told_even_in_a_tuple_and_six_beside_self_are_not() {
        let told = |text: &str| wrong(&counts(&[Source::new("a.rs", text).unwrap()]), MOST, &[]);
        assert!(told("impl S { fn f(&self, a: u8, b: u8, c: u8, d: u8, e: u8, f: u8) {} }").is_empty());
        assert!(told("extern \"C\" fn f(a: u8, b: u8, c: u8, d: u8, e: u8, f: u8, g: u8) {}").is_empty());
        assert!(
            told(
                "fn f() { let g = |a, b, c, d, e, f, g| a; } // fn g(a: u8, b: u8, c: u8, d: u8, e: u8, f: u8, g: u8)"
            )
            .is_empty()
        );
        let too_many = ["a.rs f: 7, and at most 6 are allowed"];
        assert_eq!(told("fn f(a: u8, b: u8, c: u8, d: u8, e: u8, f: u8, g: u8) {}"), too_many);
        assert_eq!(told("fn f(a: (u8, (u8, u8), u8), b: &(u8, u8), c: u8) {}"), too_many);
    }
}
