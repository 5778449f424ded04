//! What a search covered, in sentences: certificate, residual figures, what was seen. The terminal and the page set them differently.

use crate::hazard::STANDSTILL_M_S;
use crate::human::arm::ArmModel;
use fmi_hazard_record::certificate::{Certificate, Residual, RunAgain, Unlisted};
use fmi_hazard_record::coverage::{Coverage, RobotCoverage};
use fmi_hazard_record::figures::{at_least, at_most, grouped, percent};
use fmi_hazard_record::model::{Settings, Spent};

/// How bounds are rounded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Bounds {
    /// To the nearest figure.
    Nearest,
    /// So that they hold as they are printed.
    Outwards,
}

impl Bounds {
    fn below(self, part: f64) -> String {
        if self == Self::Outwards { at_most(part) } else { percent(part) }
    }

    fn above(self, part: f64) -> String {
        if self == Self::Outwards { at_least(part) } else { percent(part) }
    }
}

/// So many of the sequences.
#[must_use]
pub(crate) fn sequences(c: &Certificate) -> String {
    format!("{} of {} sequences", grouped(&c.covered), grouped(&c.sequences))
}

/// Within which bounds that holds.
#[must_use]
pub(crate) fn within(c: &Certificate, settings: &Settings) -> String {
    let held = settings.held_m.map_or_else(String::new, |held_m| {
        let tolerance_m = ArmModel::holding(held_m).hand_tolerance_m(settings.reach_tolerance_m);
        format!(", {:.0} mm for what is held", tolerance_m * 1000.0)
    });
    format!(
        "{} actions, {} steps of {:.0} ms, contact checked every {:.0} ms, reach tolerance {:.0} mm{held}",
        c.actions,
        c.horizon,
        settings.action_s * 1000.0,
        settings.contact_check_interval_s * 1000.0,
        settings.reach_tolerance_m * 1000.0
    )
}

/// What became of them.
#[must_use]
pub(crate) fn fates(c: &Certificate) -> String {
    format!(
        "{} hazardous ({}), {} harmless, {} too far away to meet the robot any more",
        grouped(&c.hazardous),
        percent(c.hazardous_share),
        grouped(&c.harmless),
        grouped(&c.excluded)
    )
}

/// How many states were told apart, and how.
#[must_use]
pub(crate) fn states(c: &Certificate) -> String {
    let tried = match c.merged {
        0 => String::new(),
        of => {
            format!(" ({} histories merged, {} of the merges tried out)", grouped(&of.to_string()), c.merges_tried_out)
        }
    };
    let states = grouped(&c.states.to_string());
    format!("{states} distinct states; equal FMU states told by {}{tried}", c.merged_by)
}

/// What was run again plainly, if anything was.
#[must_use]
pub(crate) fn run_again(again: &RunAgain) -> Option<String> {
    let part = |done: u64, of: u64| match done == of {
        true => format!("all {}", grouped(&of.to_string())),
        false => format!("{} of {}", grouped(&done.to_string()), grouped(&of.to_string())),
    };
    let merges = match again.merges {
        0 => String::new(),
        of => format!(", and {} merges gone on with", part(again.merges_compared, of)),
    };
    let whole = (again.compared, again.merges_compared) == (again.transitions, again.merges);
    let sample = if whole { "" } else { " (a sample, chosen by a key)" };
    let compared = part(again.compared, again.transitions);
    (again.compared > 0).then(|| format!("{compared} FMU transitions run again from the start{merges}{sample}"))
}

/// What random search can expect, if it can find anything.
#[must_use]
pub(crate) fn random_search(c: &Certificate) -> Option<String> {
    let random = c.random_search.as_ref()?;
    let mean = random.iterations_to_hazard?;
    let mean = if mean < 10.0 { format!("{mean:.1}") } else { grouped(&format!("{mean:.0}")) };
    Some(format!(
        "one in {mean} random sequences is hazardous: random search needs {mean} iterations on average; within {} it \
         finds nothing in {} of runs",
        random.iterations,
        percent(random.miss_probability)
    ))
}

/// What random sequences say of all.
#[must_use]
pub(crate) fn share(r: &Residual, bounds: Bounds) -> String {
    let not_evaluated =
        if r.not_evaluated > 0 { format!(", {} not evaluated", r.not_evaluated) } else { String::new() };
    let share = match r.hazardous {
        0 => format!("below {}", bounds.below(r.hazardous_share_below)),
        _ => {
            let [low, high] = r.hazardous_share_interval;
            format!("{} to {}", bounds.above(low), bounds.below(high))
        }
    };
    format!(
        "{} of {} uniformly random sequences hazardous{not_evaluated}: of all sequences {share} are",
        r.hazardous, r.random_sequences
    )
}

/// What they say of hazards that are not listed.
#[must_use]
pub(crate) fn unlisted(u: &Unlisted, bounds: Bounds) -> String {
    format!(
        "one more ends in a hazard not listed here with a probability below {} ({} of {} later ones did)",
        bounds.below(u.probability_below),
        u.met_others,
        u.checked
    )
}

/// The same, estimated.
#[must_use]
pub(crate) fn estimate(u: &Unlisted) -> String {
    format!("Good-Turing estimate without the chosen sequences: {}", percent(u.good_turing_estimate))
}

/// How sure these figures are, and of what.
#[must_use]
pub(crate) fn confidence(r: &Residual) -> String {
    format!("95 % confidence each; for {}", r.holds_for)
}

/// What it cost; where all sequences were looked at, their number says nothing.
#[must_use]
pub(crate) fn spent(c: &Coverage, spent: &Spent, all: bool) -> String {
    let sequences = match all {
        true => String::new(),
        false => format!("{} sequences, {} not evaluated; ", spent.iterations, c.episodes_not_evaluated),
    };
    format!("{sequences}{} actions, {} FMU steps, {} contact checks", c.actions, spent.fmu_steps, c.contact_checks)
}

/// What the robot did, as a predicate.
#[must_use]
pub(crate) fn robot(c: &Coverage) -> String {
    format!(
        "moved at up to {:.2} m/s; closest approach of the body {}; robot within arm's reach at {} instants",
        c.robot_top_speed_m_s,
        approach(c.closest_approach_m),
        c.checks_with_robot_in_arm_reach
    )
}

/// What was seen of one of several robots, behind its name.
#[must_use]
pub(crate) fn of_robot(robot: &RobotCoverage) -> String {
    let moved = match (robot.moved, robot.top_speed_m_s) {
        (false, speed) if speed < STANDSTILL_M_S => "never moved".to_owned(),
        (_, speed) => format!("up to {speed:.2} m/s"),
    };
    let closest = match (robot.instants_in_reach, robot.closest_approach_m) {
        // Too slow to harm whenever somebody was near: its distance was not asked for.
        (1.., closest_m) if closest_m >= 1e6 => String::new(),
        (_, closest_m) => format!("closest approach {}; ", approach(closest_m)),
    };
    format!("{moved}; {closest}near enough to touch at {} instants", robot.instants_in_reach)
}

/// How near somebody came.
fn approach(closest_m: f64) -> String {
    if closest_m < 1e6 { format!("{closest_m:.2} m") } else { "never near".to_owned() }
}

/// What was met and is allowed.
#[must_use]
pub(crate) fn contacts(c: &Coverage) -> String {
    format!(
        "{} contacts within the limits (highest {:.2}x); obstacles stopped the person {} times",
        c.contacts_within_limits, c.highest_ratio_within_limits, c.walks_blocked
    )
}

/// Of a cell without sensors.
pub(crate) const NO_SENSORS: &str = "none in this cell: the safeguard is the guarding itself";
