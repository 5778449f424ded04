//! What answers need: a closed list. Each engine replies to each.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Something that "nobody is hit" needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Need {
    /// All that the question is about was looked at.
    Searched,
    /// The FMU finished every step that it was asked for.
    Finished,
    /// Whether an arm can get there was answered each time.
    ArmSearches,
    /// Nobody is hit between two communication steps, either.
    BetweenSteps,
    /// What looks like a hazard is one, by a run of its own.
    Confirmed,
    /// The FMU does the same again.
    Repeatable,
    /// Its motion does not depend on how it is stepped.
    Steps,
    /// The speeds that it tells are those of its motion.
    Speeds,
    /// Each robot moves.
    Moves,
    /// Each robot comes near where the person can be.
    Near,
    /// Some sensor reports the person.
    Reported,
    /// Whoever comes and goes again, as often as they like.
    Changes,
    /// Controls, worked as often as people like.
    Presses,
    /// Who works a control lets go of others.
    HandsOfControls,
    /// Doors, closed and open.
    Doors,
    /// What the person does besides walking, bending and reaching.
    Abilities,
    /// Hands of somebody low, and hands behind several planes.
    HandsThroughPlanes,
    /// What follows the FMU's outputs.
    Following,
    /// By the speed of approach.
    Approach,
    /// By other criteria than the transient force.
    Criteria,
    /// How small the surface is that touches.
    Pressure,
    /// How far robots go on after a contact.
    Travel,
    /// People of whom sensors report the same are treated alike.
    PeopleAlike,
    /// A robot that is looked at by itself heeds no other sensor.
    Heeds,
    /// Sensors inside the FMU report the same at any time.
    ReportsLater,
    /// Sensors inside the FMU, while controls are worked.
    ReportsWhileWorked,
}

impl Need {
    /// All of them, in the order in which they are told.
    pub(crate) const ALL: [Self; 26] = [
        Self::Searched,
        Self::Finished,
        Self::ArmSearches,
        Self::BetweenSteps,
        Self::Confirmed,
        Self::Repeatable,
        Self::Steps,
        Self::Speeds,
        Self::Moves,
        Self::Near,
        Self::Reported,
        Self::Changes,
        Self::Presses,
        Self::HandsOfControls,
        Self::Doors,
        Self::Abilities,
        Self::HandsThroughPlanes,
        Self::Following,
        Self::Approach,
        Self::Criteria,
        Self::Pressure,
        Self::Travel,
        Self::PeopleAlike,
        Self::Heeds,
        Self::ReportsLater,
        Self::ReportsWhileWorked,
    ];

    /// As the head of a line.
    #[must_use]
    pub(crate) const fn words(self) -> &'static str {
        match self {
            Self::Searched => "Everything was looked at",
            Self::Finished => "The FMU finished every step",
            Self::ArmSearches => "Every arm search came to an end",
            Self::BetweenSteps => "Nothing happens between two steps",
            Self::Confirmed => "What was met is confirmed",
            Self::Repeatable => "The FMU does the same again",
            Self::Steps => "The motion does not depend on the step",
            Self::Speeds => "The speeds are those of the motion",
            Self::Moves => "The robot moves",
            Self::Near => "The robot comes near people",
            Self::Reported => "Sensors report people",
            Self::Changes => "People come and go as often as they like",
            Self::Presses => "Controls are worked as often as people like",
            Self::HandsOfControls => "Who works one control lets go of others",
            Self::Doors => "Doors are open or closed",
            Self::Abilities => "What else people do",
            Self::HandsThroughPlanes => "Hands through light curtains and doors",
            Self::Following => "What follows the FMU",
            Self::Approach => "The speed of approach",
            Self::Criteria => "All criteria of the cell file",
            Self::Pressure => "How small surfaces are",
            Self::Travel => "How far robots go on after a contact",
            Self::PeopleAlike => "People who are reported alike are treated alike",
            Self::Heeds => "Which sensors a robot heeds",
            Self::ReportsLater => "Sensors inside the FMU see the same at any time",
            Self::ReportsWhileWorked => "Sensors inside the FMU while controls are worked",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The order of `ALL` is that of the variants, so that none is left out of it.
    #[test]
    fn none_is_left_out() {
        let numbers: Vec<usize> = Need::ALL.iter().map(|need| *need as usize).collect();
        assert_eq!(numbers, (0..=Need::ReportsWhileWorked as usize).collect::<Vec<_>>());
    }
}
