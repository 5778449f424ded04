//! The rule that a function fits on a screen.

use crate::exceptions::{Found, add};
use crate::functions::functions;
use crate::sources::Source;

/// Lines of a function, from `fn` to its closing brace.
pub const MOST: usize = 70;

/// How many lines each function has, tests and functions for C among them.
#[must_use]
pub fn lines(sources: &[Source]) -> Found {
    let mut found = Found::new();
    for source in sources {
        for function in functions(&source.file) {
            add(&mut found, &source.path, &function.name, function.lines);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exceptions::{Exception, wrong};
    use crate::sources::workspace;

    /// Functions that were too long when the rule was made. Take out what is mended; add nothing.
    const LISTED: [Exception; 50] = [
        ("crates/cell/src/cell/binding.rs", "bind", 113),
        ("crates/cell/src/cell/design_parameter.rs", "DesignParameters::of", 80),
        ("crates/cell/src/cell/draft.rs", "joints", 71),
        ("crates/cell/src/cell/draft.rs", "robots", 87),
        ("crates/cell/src/cell/file/robots.rs", "Checker::robot", 76),
        ("crates/cell/src/cell/file/validate.rs", "Checker::workcell", 103),
        ("crates/cell/src/cell/foreign/gltf.rs", "read", 71),
        ("crates/cell/src/cell/foreign/ssp/structure.rs", "connect", 78),
        ("crates/fmu-host/src/fmi/archive.rs", "check", 75),
        ("crates/fmu-host/src/host/selftest.rs", "stage", 71),
        ("crates/human/src/human/reach_tests.rs", "dropped_boxes", 78),
        ("crates/reachability/src/history_search.rs", "HistorySearch::judge", 94),
        ("crates/reachability/src/history_search.rs", "HistorySearch::try_poses", 83),
        ("crates/reachability/src/lib.rs", "ReachabilitySearch::on_cells_of", 76),
        ("crates/reachability/src/passes.rs", "ReachabilitySearch::search", 96),
        ("crates/reachability/src/reading_regions.rs", "ReadingRegions::with", 157),
        ("crates/record/src/advice.rs", "render", 89),
        ("crates/report/src/floorplan.rs", "legend", 74),
        ("crates/report/src/mcap.rs", "Recording::entities", 72),
        ("crates/report/src/survey_page.rs", "render", 78),
        ("crates/report/src/top_view.rs", "render", 124),
        ("crates/sequences/src/lib.rs", "Expander::advance", 75),
        ("crates/simulation/src/encounter.rs", "Encounter::arm_contact", 71),
        ("fmus/models/c_interface3_tests.rs", "a_whole_life_gives_the_bits_of_fmi_2", 72),
        ("fmus/models/interface/description.rs", "tests::each_place_in_a_table_is_the_one_its_constant_names", 80),
        ("fmus/models/interface/workcell.rs", "parameters", 103),
        ("src/cli/check.rs", "run", 95),
        ("src/cli/reachability.rs", "look", 84),
        ("src/scan/distance.rs", "Measured::safeguard", 90),
        ("src/scan/exhaustive.rs", "census", 106),
        ("src/scan/fallback.rs", "search_with_fallback", 101),
        ("src/scan/prepare.rs", "prepare_unplaced", 88),
        ("src/scan/probe.rs", "probed", 88),
        ("src/scan/reachability.rs", "AnalysisContext::part", 83),
        ("src/scan/reachability.rs", "analyse", 86),
        ("src/scan/reachability/fields.rs", "Fields::of", 71),
        ("src/scan/replay.rs", "record", 77),
        ("src/scan/risk_reduction.rs", "SearchContext::new", 81),
        ("src/scan/run.rs", "scan_alone", 84),
        ("tests/suite/anywhere_arms.rs", "look_at_sets", 78),
        ("tests/suite/anywhere_instants.rs", "look_at_poses", 87),
        ("tests/suite/anywhere_sets.rs", "whoever_walks_over_two_mats_is_in_the_sets_of_both_and_of_each", 93),
        ("tests/suite/clamping.rs", "head_trunk_and_legs_are_clamped_where_samples_say_so", 87),
        ("tests/suite/common/by_hand.rs", "ByHand::walk", 71),
        ("tests/suite/common/twin/clamp_scenes.rs", "around", 78),
        ("tests/suite/first_cell.rs", "check_tells_all_problems_at_once_and_draws_what_is_right", 79),
        ("tests/suite/pipelines.rs", "results_are_moved_with_their_cell_and_mailed_without_it", 78),
        ("tests/suite/ssp.rs", "outputs_are_those_that_fmpy_simulates", 84),
        ("tests/suite/ssp.rs", "what_is_not_supported_is_refused_by_element_and_line", 79),
        ("tests/suite/variants.rs", "tables_are_laid_by_key_and_entries_by_name", 128),
    ];

    #[test]
    fn no_function_is_longer_than_a_screen() {
        let found = lines(&workspace().unwrap());
        let wrong = wrong(&found, MOST, &LISTED);
        assert!(found.len() > 3000 && wrong.is_empty(), "{} functions, of which:\n{}", found.len(), wrong.join("\n"));
    }

    #[test]
    fn a_line_too_many_is_told_and_one_less_is_not() {
        let function =
            |inside: usize| format!("mod m {{\n    fn f() {{\n{}    }}\n}}\n", "        g(); // {\n".repeat(inside));
        let told = |inside| {
            let source = Source::new("a.rs", &function(inside)).unwrap();
            wrong(&lines(&[source]), MOST, &[])
        };
        assert!(told(68).is_empty());
        assert_eq!(told(69), ["a.rs m::f: 71, and at most 70 are allowed"]);
    }
}
