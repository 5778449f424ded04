//! `fmi-hazard inspect --self-test`: what an FMU's promises about its state are worth, for any FMU or system of FMUs.
//!
//! The FMU runs in workers, one for each stage: when it crashes or hangs in one of them, or damages its memory, that is a
//! finding about this stage.

use std::fmt::Write as _;

use super::Arguments;
use crate::cli::exit::{FMU_FAILED, Failure, NO_HAZARD};
use crate::cli::output::{self, Format};
use crate::cli::subject::Subject;
use crate::fmi::{Fmu, number};
use crate::host::PlantError;
use crate::host::activity::Activity;
use crate::host::isolation::{Examination, Habit, Launcher, Unpacked, affordable, examine, habits};
use crate::host::selftest::{Agreement, Motion, SelfTest, StateRestore, selftest};
use crate::scan::{Hosting, PrepareError};

/// Steps of a run unless told otherwise.
pub(super) const STEPS: usize = 80;

pub(super) fn run(arguments: &Arguments) -> Result<u8, Failure> {
    let subject = Subject::open(&arguments.path)?;
    let setup = subject.alone(arguments.step)?.setup;
    let _ = setup.order().map_err(PrepareError::from)?;
    let wanted = arguments.steps.and_then(|steps| usize::try_from(steps).ok());
    let within = subject.steps(wanted.unwrap_or(STEPS), setup.step_s);
    let steps = wanted.unwrap_or(within);
    let stop = number(subject.ends_s().unwrap_or_default());
    if steps > within {
        output::warning(&format!(
            "{steps} steps of {} s go beyond the stopTime of {stop} s that the FMU gives: nobody may have looked at what it \
             does then",
            number(setup.step_s)
        ));
    }
    let shortened = (steps < STEPS && wanted.is_none())
        .then(|| format!("{steps} steps instead of {STEPS}: the FMU gives a stopTime of {stop} s"));
    let failed = |e: PlantError| match e.not_loaded {
        true => Failure::unusable(e),
        false => Failure::running(format!("the FMU failed in its first plain run: {e}")),
    };
    let (result, habits) = match arguments.hosting.hosting()? {
        Hosting::InProcess(_) => {
            let slaves = subject.fmus().into_iter().map(Fmu::load).collect::<Result<Vec<_>, _>>()?;
            (selftest(&slaves, &setup, steps, &[], Activity::unseen()).map_err(failed)?, Vec::new())
        }
        Hosting::Workers { program, guard, limits } => {
            let launcher =
                Launcher::new(program, subject.fmus().into_iter().map(Unpacked::of).collect(), setup, guard, limits);
            // Who names a number means it, however long that takes.
            let steps = if wanted.is_some() { steps } else { affordable(&launcher, steps) };
            let Examination { result, launcher, missing, .. } = examine(&launcher, steps, &[]).map_err(failed)?;
            for missing in missing {
                output::warning(&format!("protection against the FMU: {missing}"));
            }
            let saves = matches!(result.restore, Agreement::Exact | Agreement::Differs { .. });
            let habits = habits(&launcher, steps, result.deterministic != Agreement::Exact, saves);
            let habits = habits.unwrap_or_else(|e| {
                output::warning(&format!("the FMU's habits could not be found out: {e}"));
                Vec::new()
            });
            (result, habits)
        }
    };
    if arguments.format == Format::Json {
        let states_by = result.repeatable().then(|| result.rung(false));
        let told = SelfTestOutput { result: &result, habits: &habits, states_by, shortened: shortened.as_deref() };
        output::json_of(&told)?;
    } else {
        output::result(&render(subject.name(), &result, &habits, shortened.as_deref()));
    }
    Ok(if result.repeatable() { NO_HAZARD } else { FMU_FAILED })
}

/// What is printed as JSON.
#[derive(serde::Serialize)]
struct SelfTestOutput<'a> {
    #[serde(flatten)]
    result: &'a SelfTest,
    habits: &'a [Habit],
    /// How a scan brings states back; nothing if it cannot.
    states_by: Option<StateRestore>,
    /// Why there were fewer steps than usual.
    #[serde(skip_serializing_if = "Option::is_none")]
    shortened: Option<&'a str>,
}

/// Whether it moves alike in half steps, and with Event Mode and without.
fn motions(r: &SelfTest) -> String {
    let mut text = String::new();
    let mode = if r.uses_event_mode { "without the Event Mode it runs with" } else { "with its Event Mode" };
    let halves = "nothing is shown: what it does depends on the step";
    let modes = "nothing is shown: which motion is its own is not known";
    // Without the mode that it is not run with nothing is lost.
    let lost = matches!(r.half_steps, Motion::Failed { .. });
    for (what, motion, otherwise, lost) in
        [("the same motion in half steps", &r.half_steps, halves, lost), (mode, &r.event_mode, modes, false)]
    {
        let _ = writeln!(text, "  {what:<38} {motion}");
        if lost || matches!(motion, Motion::Differs { .. }) {
            let _ = writeln!(text, "  {:<38} means for a scan: {otherwise}", "");
        }
    }
    for remark in &r.remarks {
        let _ = writeln!(text, "  {remark}");
    }
    text
}

fn render(name: &str, r: &SelfTest, habits: &[Habit], shortened: Option<&str>) -> String {
    let mut text = String::new();
    let _ = writeln!(
        text,
        "{name}: {} steps of {} s with {} moving inputs, {} outputs compared bit by bit",
        r.steps,
        number(r.step_s),
        r.inputs,
        r.outputs
    );
    if let Some(shortened) = shortened {
        let _ = writeln!(text, "  {shortened}");
    }
    for (what, result, otherwise) in [
        ("two fresh instances agree", &r.deterministic, "each run needs a fresh process"),
        (
            "a second instance beside it",
            &r.second_instance,
            "instances run one after the other, as they always do here",
        ),
        ("restored state, two held at once", &r.restore, "its saved states are not used"),
        ("two fresh processes agree", &r.fresh_process, "findings could not be replayed"),
        ("a copy of its process as a state", &r.fork, "copies are not used"),
        ("reset against a fresh instance", &r.reset, "nothing: a fresh instance is made instead"),
        (
            "serialised state in another instance",
            &r.serialize,
            "nothing: a state is brought back in the instance that saved it",
        ),
    ] {
        let _ = writeln!(text, "  {what:<38} {result}");
        if matches!(result, Agreement::Differs { .. } | Agreement::Failed { .. }) {
            let _ = writeln!(text, "  {:<38} means for a scan: {otherwise}", "");
        }
    }
    text += &motions(r);
    let bytes = r.bytes_per_state.map_or_else(|| "unknown".to_owned(), |b| b.to_string());
    let _ = writeln!(text, "  {:<38} {bytes}", "bytes in a state");
    let _ = writeln!(text, "  {:<38} {:.4}", "largest movement of an output", r.output_range);
    for habit in habits {
        let _ = writeln!(text, "  The FMU {habit}: {}", habit.means());
    }
    let conclusion = if r.repeatable() {
        format!("A scan brings states back by: {}", r.because(r.rung(false)))
    } else {
        "A scan is not possible: findings could not be replayed".to_owned()
    };
    let _ = writeln!(text, "{conclusion}");
    text
}
