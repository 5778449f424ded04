//! Why a later question is narrower than an earlier one: what is not found then is neither fixed nor gone. In words, and for
//! programs.

use schemars::JsonSchema;
use serde::Serialize;

use fmi_hazard_criteria::Class;

/// What of a later question is narrower than in an earlier one.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, JsonSchema)]
#[serde(tag = "what", rename_all = "snake_case")]
pub enum Narrower {
    /// A record does not say where its person begins, or which body they have: an older version wrote it.
    NotRecorded,
    /// One question is about people from anywhere, the other about one beginning.
    FromElsewhere,
    /// The person begins at another place or time.
    Beginning,
    /// This sensor reports somebody already where the person begins, which it did not.
    SeenAtStart {
        /// The sensor.
        sensor: String,
    },
    /// The floor that people may be on is another, or where they come from.
    Floor,
    /// It ends earlier, or its sequences are shorter than the hazard's.
    Horizon,
    /// Contacts are looked for at longer intervals.
    Interval,
    /// A deeper contact may be missed.
    Tolerance,
    /// The edition of the limits is another.
    Edition,
    /// This criterion does not count.
    Criterion {
        /// The criterion.
        class: Class,
    },
    /// The force is made by another speed.
    Speed,
    /// Contacts count from a higher speed on.
    MovingContact,
    /// Robots are stated to go on less far after a contact.
    Travel,
    /// How small the surface of this link is that touches is not told.
    Surface {
        /// The link.
        link: String,
    },
    /// A term of the separation distance is smaller.
    Separation {
        /// Its key in the cell file.
        term: String,
    },
    /// The person has another body.
    Body,
    /// Arms are slower.
    Arms,
    /// The person does other things, is slower, or holds something else.
    Abilities,
    /// The second person is another one, begins elsewhere, or is not there.
    Second,
    /// This control is worked on the way, and is missing.
    ControlMissing {
        /// The control.
        control: String,
    },
    /// This control is worked on the way, and in another way, by fewer people, or for another time.
    ControlOtherwise {
        /// The control.
        control: String,
    },
    /// Controls are worked less often.
    Presses,
    /// It found others that may hide it: of those with which sequences do not end, each action tells the worst only.
    Hidden,
}

impl Narrower {
    /// As what "the changed cell" or "the later scan" does.
    #[must_use]
    pub fn words(&self) -> String {
        let plain = match self {
            Self::NotRecorded => {
                "is held against a record that does not say where the person began, or which body they had"
            }
            Self::FromElsewhere => "is about people from anywhere where the other is about one start, or the reverse",
            Self::Beginning => "begins at another place or time",
            Self::SeenAtStart { sensor } => return format!("begins where {sensor} reports somebody already"),
            Self::Floor => "is about another floor, or people who come from elsewhere",
            Self::Horizon => "ends earlier",
            Self::Interval => "looks for contacts at longer intervals",
            Self::Tolerance => "may miss deeper contacts",
            Self::Edition => "judges by another edition of the limits",
            Self::Criterion { class } => return format!("does not count {}", class.name().replace('_', " ")),
            Self::Speed => "judges the force by another speed, or not at all",
            Self::MovingContact => "counts contacts with a moving robot from a higher speed on",
            Self::Travel => "states that robots go on less far after a contact",
            Self::Surface { link } => return format!("does not say how small the surface of {link} is that touches"),
            Self::Separation { term } => return format!("has a smaller separation distance: {term}"),
            Self::Body => "has a person with another body",
            Self::Arms => "has slower arms",
            Self::Abilities => "has a person who does other things, runs at another speed, or holds something else",
            Self::Second => "has another second person, or none",
            Self::ControlMissing { control } => {
                return format!("lacks a control that is worked on the way: `{control}`");
            }
            Self::ControlOtherwise { control } => {
                return format!(
                    "has `{control}`, which is worked on the way, worked otherwise, by fewer, or for another time"
                );
            }
            Self::Presses => "has controls worked less often",
            Self::Hidden => "found other moving contacts or separation hazards, which may hide it",
        };
        plain.to_owned()
    }

    /// What to do about it.
    #[must_use]
    pub const fn help(&self) -> &'static str {
        match self {
            Self::NotRecorded => "scan the earlier cell again with this version",
            Self::FromElsewhere => "compare two scans from the same start, or two from anywhere",
            Self::Beginning => "scan from the earlier start too",
            Self::SeenAtStart { .. } => "scan from anywhere, or from a start outside it",
            Self::Floor => "set human.floor_m and human.start_region_m as they were",
            Self::Horizon => "set [search] actions, or --until, as high as they were",
            Self::Interval => "set time.step_s as it was",
            Self::Tolerance => "set [search] reach_tolerance_m as it was",
            Self::Edition => "scan the earlier cell again with this version",
            Self::Criterion { .. } | Self::Speed | Self::MovingContact | Self::Travel | Self::Separation { .. } => {
                "set [criteria] as it was"
            }
            Self::Surface { .. } => "set `contact` of the link",
            Self::Body | Self::Arms | Self::Abilities | Self::Second => "set [human] as it was",
            Self::ControlMissing { .. } | Self::ControlOtherwise { .. } => "set [[control]] as it was",
            Self::Presses => "set --presses as high as it was",
            Self::Hidden => "see whether it is left when those are gone",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every cause says something of its own, and what to do.
    #[test]
    fn each_has_words_of_its_own() {
        let name = || "x".to_owned();
        let all = [
            Narrower::NotRecorded,
            Narrower::FromElsewhere,
            Narrower::Beginning,
            Narrower::SeenAtStart { sensor: name() },
            Narrower::Floor,
            Narrower::Horizon,
            Narrower::Interval,
            Narrower::Tolerance,
            Narrower::Edition,
            Narrower::Criterion { class: Class::Pressure },
            Narrower::Speed,
            Narrower::MovingContact,
            Narrower::Travel,
            Narrower::Surface { link: name() },
            Narrower::Separation { term: name() },
            Narrower::Body,
            Narrower::Arms,
            Narrower::Abilities,
            Narrower::Second,
            Narrower::ControlMissing { control: name() },
            Narrower::ControlOtherwise { control: name() },
            Narrower::Presses,
            Narrower::Hidden,
        ];
        let words: std::collections::BTreeSet<String> = all.iter().map(Narrower::words).collect();
        assert_eq!(words.len(), all.len());
        assert!(all.iter().all(|one| !one.help().is_empty()));
    }
}
