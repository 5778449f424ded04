//! What the page says of the search: certificate, residual figures, what was seen, faults.

use serde::Serialize;

use super::{Row, Told};
use crate::covered::{self, Bounds, NO_SENSORS};
use fmi_hazard_record::certificate::{Certificate, Residual};
use fmi_hazard_record::figures::{grouped, plural};
use fmi_hazard_record::reachability::REACHABILITY;

/// One part.
#[derive(Serialize)]
pub(super) struct Part {
    /// Which: `certificate`, `residual`, `seen` or `faults`.
    id: &'static str,
    title: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    says: Option<String>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    rows: Vec<Row>,
}

/// All that there are.
pub(super) fn parts(told: &Told) -> Vec<Part> {
    let residual = told.residual.as_ref().map(residual);
    let seen = if is_from_anywhere(told) { cost(told) } else { seen(told) };
    let seen = Part { id: "seen", title: "Coverage", says: None, rows: seen };
    [Some(certificate(told)), residual, Some(seen), Some(faults(told))].into_iter().flatten().collect()
}

fn is_from_anywhere(told: &Told) -> bool {
    told.settings.strategy == REACHABILITY
}

/// Rows of those that are there.
fn rows<const N: usize>(all: [(&str, Option<String>); N]) -> Vec<Row> {
    all.into_iter().filter_map(|(term, text)| Some((term.to_owned(), text?))).collect()
}

fn certificate(told: &Told) -> Part {
    let part = |title, says, rows| Part { id: "certificate", title, says, rows };
    if is_from_anywhere(told) {
        return part("From anywhere", Some(told.headline.covers.clone()), Vec::new());
    }
    let Some(c) = &told.certificate else {
        let says = "There is no certificate of completeness: not every sequence of actions was looked at, so there may be \
                    hazards that are not listed. --strategy exhaustive looks at all of them.";
        return part("Not complete", Some(says.to_owned()), Vec::new());
    };
    let title = if c.complete { "Certificate: complete" } else { "Not complete" };
    let beginnings = (!c.complete && c.complete_for_actions < c.horizon).then(|| {
        format!(
            "Only the beginnings of {} of {} actions were all looked at; hazards that need more actions may be missing.",
            c.complete_for_actions, c.horizon
        )
    });
    part(title, beginnings, certified(told, c))
}

fn certified(told: &Told, c: &Certificate) -> Vec<Row> {
    let not_evaluated = (c.not_evaluated != "0")
        .then(|| format!("{} sequences: the FMU could not finish them", grouped(&c.not_evaluated)));
    rows([
        ("within", Some(covered::within(c, &told.settings))),
        ("accounted for", Some(covered::sequences(c))),
        ("of these", Some(covered::fates(c))),
        ("not evaluated", not_evaluated),
        ("states", Some(covered::states(c))),
        ("run again", covered::run_again(&c.run_again)),
        ("random search", covered::random_search(c)),
    ])
}

fn residual(r: &Residual) -> Part {
    let unlisted = r.unlisted.as_ref();
    let rows = rows([
        ("random sequences", Some(covered::share(r, Bounds::Outwards))),
        ("not listed here", unlisted.map(|u| covered::unlisted(u, Bounds::Outwards))),
        ("estimated", unlisted.map(covered::estimate)),
        ("how sure", Some(covered::confidence(r))),
    ]);
    Part { id: "residual", title: "Residual: what is left, by random sequences alone", says: None, rows }
}

/// What a search from anywhere cost.
fn cost(told: &Told) -> Vec<Row> {
    let spent = &told.spent;
    let number = |n: u64| grouped(&n.to_string());
    let text = format!(
        "{} FMU steps, {} FMU states, {} sets of poses, {} arm searches",
        number(spent.fmu_steps),
        grouped(&spent.fmu_states.to_string()),
        number(spent.contact_checks),
        number(spent.arm_checks)
    );
    vec![("spent".to_owned(), text)]
}

fn seen(told: &Told) -> Vec<Row> {
    let c = &told.coverage;
    let early = match c.arm_checks_incomplete {
        0 => String::new(),
        n => format!(" ({n} ended early)"),
    };
    let unfinished = match c.arm_runs_not_evaluated {
        0 => String::new(),
        n => format!("; {n} runs in which a plane tells of an arm could not be finished by the FMU"),
    };
    let spent = covered::spent(c, &told.spent, told.certificate.is_some());
    let (states, arms) = (told.spent.fmu_states, c.arm_checks);
    let overlap = if c.closest_approach_m < 0.0 { "; where it is below 0, shapes overlap" } else { "" };
    let mut all = rows([
        ("spent", Some(format!("{spent}; {states} FMU states, {arms} arm searches{early}{unfinished}"))),
        ("robot", Some(format!("{}{overlap}", covered::robot(c)))),
    ]);
    if c.robots.len() > 1 {
        all.extend(c.robots.iter().map(|robot| (robot.name.clone(), covered::of_robot(robot))));
    }
    all.extend(rows([("people", Some(covered::contacts(c))), ("sensors", Some(sensors(told)))]));
    all
}

/// In how many actions each reported the person.
fn sensors(told: &Told) -> String {
    let actions = &told.coverage.sensor_actions;
    if actions.is_empty() {
        return NO_SENSORS.to_owned();
    }
    let one = |(name, n): (&String, &u64)| {
        format!("{name} in {} action{}", grouped(&n.to_string()), if *n == 1 { "" } else { "s" })
    };
    let all: Vec<String> = told.sensors.iter().zip(actions).map(one).collect();
    format!("reported the person: {}", all.join(", "))
}

fn faults(told: &Told) -> Part {
    let says = match told.faults.len() {
        0 => "None: the FMU finished every action that it was asked for.".to_owned(),
        n => format!("{} could not be finished; what would come after is not evaluated.", plural(n, "action")),
    };
    Part { id: "faults", title: "Faults of the FMU", says: Some(says), rows: Vec::new() }
}
