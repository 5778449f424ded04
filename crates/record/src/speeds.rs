//! Speeds that an FMU tells and that are not those of its motion, in words.

use schemars::JsonSchema;
use serde::Serialize;

/// A speed that the FMU tells and that is not the speed of the motion.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SpeedRecord {
    /// The robot.
    pub robot: String,
    /// The joint or frame.
    pub part: String,
    /// The outputs that are named as its speed.
    pub variables: Vec<String>,
    /// Unit of the speeds here: m/s or rad/s.
    pub unit: &'static str,
    /// When the two differ most, from the person's beginning, s.
    pub time_s: f64,
    /// Speed of the motion then: the way of the step before by its time.
    pub motion: f64,
    /// Speed that is told then.
    pub told: f64,
    /// Whether it is anywhere told slower than it is: forces then come out too low.
    pub slower_than_it_is: bool,
    /// Steps of a run at which the two differ in some run.
    pub steps: usize,
    /// Steps of a run.
    pub of_steps: usize,
    /// The likely cause, where it can be recognised.
    pub cause: Option<String>,
}

impl SpeedRecord {
    /// What moves: "joint `a` of robot `r`".
    #[must_use]
    pub fn whose(&self) -> String {
        format!("{} of robot `{}`", self.part, self.robot)
    }

    /// What is wrong, without advice.
    #[must_use]
    pub fn message(&self) -> String {
        let unit = self.unit;
        format!(
            "the speed of {} is not that of its motion: at {:.2} s it moves at {:.3} {unit}, and {} says {:.3} {unit}; the \
             two differ at {} of {} steps",
            self.whose(),
            self.time_s,
            self.motion,
            self.named(),
            self.told,
            self.steps,
            self.of_steps
        )
    }

    fn named(&self) -> String {
        self.variables.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(" with ")
    }

    /// What it means and what to do.
    #[must_use]
    pub fn advice(&self) -> String {
        let meaning = if self.slower_than_it_is {
            "The robot is faster than it says, so forces come out too low"
        } else {
            "The robot is not faster than it says, but one of the two is wrong"
        };
        match &self.cause {
            Some(cause) => format!("{cause}. {meaning}"),
            None => format!(
                "{meaning}. Look at the variables of position and speed, their signs and their units; without a speed in the \
                 cell file it is differentiated from the position"
            ),
        }
    }

    /// Both.
    #[must_use]
    pub fn sentence(&self) -> String {
        format!("{}. {}", self.message(), self.advice())
    }
}
