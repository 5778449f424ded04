//! How much of the robots' cycle a search from the start met: a hazard that comes later in the cycle was not looked for.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The time in which people were followed, and what the robots repeat while somebody stands at the start and does nothing. Times count from
/// the FMU's own start.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct CycleShare {
    /// The robots repeat what they do every so many seconds; nothing if that was not seen.
    pub cycle_s: Option<f64>,
    /// From this time on, s; what they do before it comes once. At the earliest the time at which the person begins: what is before that
    /// was not watched.
    pub repeats_from_s: Option<f64>,
    /// People begin then, s.
    pub from_s: f64,
    /// Their sequences end then, s.
    pub until_s: f64,
    /// So long the robots were watched, s. They are watched for 64 s or 3200 communication steps, whichever is less, not beyond the FMU's
    /// stopTime, and no longer than they need to show the cycle twice. 0: the FMU could not finish the first 8 s.
    pub watched_s: f64,
    /// Whether any robot went anywhere meanwhile.
    pub moves: bool,
}

impl CycleShare {
    /// Which part of the cycle was met, from 0 to 1; nothing if the cycle is not known. What robots do before they repeat themselves is no
    /// part of it.
    #[must_use]
    pub(crate) fn part(&self) -> Option<f64> {
        let (cycle_s, repeats_from_s) = (self.cycle_s?, self.repeats_from_s?);
        Some(((self.until_s - self.from_s.max(repeats_from_s)) / cycle_s).clamp(0.0, 1.0))
    }

    /// How much was met, for people: it stands behind "from the start in the cell file," in a sentence.
    #[must_use]
    pub(crate) fn words(&self) -> String {
        let length = seconds(self.until_s - self.from_s);
        let begins = match self.from_s > 0.0 {
            true => format!("from {} after the FMU's start", seconds(self.from_s)),
            false => "from the FMU's start".to_owned(),
        };
        let (Some(cycle_s), Some(repeats_from_s), Some(part)) = (self.cycle_s, self.repeats_from_s, self.part()) else {
            let why = match (self.moves, self.watched_s > 0.0) {
                (_, false) => "the FMU did not run long enough to see what the robots repeat".to_owned(),
                (true, true) => {
                    format!("the robots did not repeat what they do within {}", seconds(self.watched_s))
                }
                (false, true) => format!("the robots stood still for {} while nobody came", seconds(self.watched_s)),
            };
            return format!("in {length} {begins}; {why}");
        };
        let cycle = seconds(cycle_s);
        if self.until_s <= repeats_from_s {
            let later = seconds(repeats_from_s);
            return format!("in {length} {begins}, before a cycle of {cycle} that the robots repeat from {later} on");
        }
        if part >= 1.0 {
            return format!("in {length}, all of a cycle of {cycle}, {begins}");
        }
        if self.from_s <= 0.0 && repeats_from_s <= 0.0 {
            return format!("in the first {length} of a cycle of {cycle}");
        }
        format!("in {length}, {} of a cycle of {cycle}, {begins}", percent(part))
    }
}

/// Seconds with the digits that are there, up to hundredths.
fn seconds(time_s: f64) -> String {
    let text = format!("{time_s:.2}");
    format!("{} s", text.strip_suffix('0').unwrap_or(&text))
}

/// A share below all, rounded down: nothing is called more than it is.
fn percent(part: f64) -> String {
    if part < 0.01 { "less than 1 %".to_owned() } else { format!("{:.0} %", (100.0 * part).floor()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn share(cycle: Option<(f64, f64)>, from_s: f64, until_s: f64) -> CycleShare {
        let (cycle_s, repeats_from_s) = cycle.unzip();
        CycleShare { cycle_s, repeats_from_s, from_s, until_s, watched_s: 64.0, moves: true }
    }

    #[test]
    fn words_say_how_much_of_the_cycle_was_met() {
        for (share, part, words) in [
            (share(Some((6.8, 0.0)), 0.0, 1.6), Some(1.6 / 6.8), "in the first 1.6 s of a cycle of 6.8 s"),
            (
                share(Some((6.8, 3.0)), 3.0, 4.6),
                Some(1.6 / 6.8),
                "in 1.6 s, 23 % of a cycle of 6.8 s, from 3.0 s after the FMU's start",
            ),
            // Of 1.6 s one is before what is repeated.
            (
                share(Some((6.8, 1.0)), 0.0, 1.6),
                Some(0.6 / 6.8),
                "in 1.6 s, 8 % of a cycle of 6.8 s, from the FMU's start",
            ),
            (
                share(Some((0.65, 2.0)), 0.0, 1.6),
                Some(0.0),
                "in 1.6 s from the FMU's start, before a cycle of 0.65 s that the robots repeat from 2.0 s on",
            ),
            (share(Some((1.25, 0.0)), 0.0, 1.6), Some(1.0), "in 1.6 s, all of a cycle of 1.25 s, from the FMU's start"),
            (
                share(None, 0.5, 2.1),
                None,
                "in 1.6 s from 0.5 s after the FMU's start; the robots did not repeat what they do within 64.0 s",
            ),
            (
                CycleShare { moves: false, watched_s: 10.0, ..share(None, 0.0, 1.6) },
                None,
                "in 1.6 s from the FMU's start; the robots stood still for 10.0 s while nobody came",
            ),
            (
                CycleShare { moves: false, watched_s: 0.0, ..share(None, 0.0, 1.6) },
                None,
                "in 1.6 s from the FMU's start; the FMU did not run long enough to see what the robots repeat",
            ),
        ] {
            assert_eq!(share.words(), words);
            let near = |a: f64, b: f64| (a - b).abs() < 1e-12;
            assert!(share.part().zip(part).map_or(share.part() == part, |(a, b)| near(a, b)), "{words}");
        }
        // Less than all is never called all, nor more than it is.
        assert!(share(Some((6.8, 3.0)), 3.0, 9.79).words().contains(" 99 % "));
        assert!(share(Some((640.0, 3.0)), 3.0, 4.6).words().contains("less than 1 %"));
    }
}
