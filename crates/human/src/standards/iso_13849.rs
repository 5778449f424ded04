//! ISO 13849-1, Annex A: the performance level that a safety function needs, by severity, exposure and avoidance.

use super::provenance::Table;

/// What stands behind the data of this file.
pub(super) const TABLES: [Table; 1] = [Table {
    id: "iso_13849_1_risk_graph",
    title: "ISO 13849-1:2023, Annex A: risk graph for the required performance level",
    source: "public secondary sources that print the graph",
    confidence: "its three parameters in two independent public sources; the levels as commonly printed",
    verified: false,
}];

/// The required performance level, `a` to `e`, where all three are chosen: severity `S1` or `S2`, exposure `F1` or `F2`,
/// avoidance `P1` or `P2`. Each choice of the second kind outweighs all that come after it.
#[must_use]
pub fn required_performance_level(severity: &str, exposure: &str, avoidance: &str) -> Option<char> {
    let second = |text: &str, [one, two]: [&str; 2]| match text {
        text if text == one => Some(0),
        text if text == two => Some(1),
        _ => None,
    };
    let [s, f, p] =
        [second(severity, ["S1", "S2"])?, second(exposure, ["F1", "F2"])?, second(avoidance, ["P1", "P2"])?];
    ['a', 'b', 'c', 'd', 'e'].get(2 * s + f + p).copied()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The graph leaf by leaf, as printed.
    #[test]
    fn leaves_of_the_graph() {
        for (choices, level) in [
            (["S1", "F1", "P1"], 'a'),
            (["S1", "F1", "P2"], 'b'),
            (["S1", "F2", "P1"], 'b'),
            (["S1", "F2", "P2"], 'c'),
            (["S2", "F1", "P1"], 'c'),
            (["S2", "F1", "P2"], 'd'),
            (["S2", "F2", "P1"], 'd'),
            (["S2", "F2", "P2"], 'e'),
        ] {
            let [s, f, p] = choices;
            assert_eq!(required_performance_level(s, f, p), Some(level), "{choices:?}");
        }
        assert_eq!(required_performance_level("S2", "", "P1"), None);
    }
}
