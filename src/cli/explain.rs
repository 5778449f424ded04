//! `fmi-hazard explain`: a hazard in plain words, its force with every number, and what would be enough against it.

use std::path::PathBuf;

use super::changes::ProgressPrinter;
use super::exit::{Failure, INTERRUPTED, NO_HAZARD};
use super::hosting::HostingArguments;
use super::output::Format;
use super::scan_arguments::{From, MOST_STATES, PRESSES, UNTIL, until};
use super::{earlier, output, stopping};
use crate::host::PlantError;
use crate::record::advice::RiskReduction;
use crate::record::hazard::Hazard;
use crate::report::verified::VerifiedOutcome;
use crate::scan::explain::explain;
use crate::scan::reachability::Until;
use crate::scan::risk_reduction::{
    ExhaustiveBudget, MILLIONS, ReachabilityBudget, RiskReductionBudget, STATES, risk_reductions,
};
use crate::scan::verify::Again;
use crate::scan::{Prepared, ScanError, StateChoice, replay};
use crate::stop::Stop;

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// A scan.json, or the folder with the results of a scan
    scan: PathBuf,
    /// Id of a hazard in it, or of a cause, which stands for its worst hazard
    id: String,
    #[command(flatten)]
    elsewhere: earlier::Elsewhere,
    /// Do not look for changes of the cell
    #[arg(long)]
    no_changes: bool,
    /// No complete searches: what is told of changes then rests on known sequences and quick searches only
    #[arg(long, conflicts_with_all = ["no_changes", "max_states", "max_memory", "max_work"])]
    quick: bool,
    /// Search each change that holds to its end, from the starts and from anywhere, within --max-memory and however long that takes;
    /// changes of what restarts by itself as far as a scan from anywhere follows them. Ctrl-C ends it and keeps what is known by then
    #[arg(long, conflicts_with_all = ["no_changes", "quick", "max_states", "max_work"])]
    complete: bool,
    /// Where people come from before a change is called enough: its starts alone say less [default: both]
    #[arg(long, value_enum)]
    from: Option<From>,
    /// From anywhere: how long after the start of the FMU [default: 4s]
    #[arg(long, value_name = "TIME", value_parser = until)]
    until: Option<Until>,
    /// Sequences of each quick search that tries out a change
    #[arg(long, default_value_t = 20, value_parser = clap::value_parser!(u32).range(1..))]
    iterations: u32,
    /// Most distinct states of all complete searches together
    #[arg(long, default_value_t = STATES, value_parser = clap::value_parser!(u32).range(1..))]
    max_states: u32,
    /// Most memory for the states of each complete search, MB
    #[arg(long, default_value_t = 2_000, value_parser = clap::value_parser!(u32).range(1..))]
    max_memory: u32,
    /// Most work of the arm searches in all complete searches together, millions of joint-angle boxes; one of them takes a
    /// third at most
    #[arg(long, default_value_t = MILLIONS)]
    max_work: u32,
    /// Threads (default: one a core); the result is the same
    #[arg(long)]
    workers: Option<usize>,
    /// How to print the result
    #[arg(long, value_enum, default_value_t)]
    format: Format,
    #[command(flatten)]
    hosting: HostingArguments,
}

pub(super) fn run(arguments: &Arguments) -> Result<u8, Failure> {
    let mut recorded = earlier::read(&arguments.scan)?;
    earlier::hazard(&recorded, &arguments.id, &arguments.scan)?;
    let stop = Stop::default();
    let hosting = arguments.hosting.heeding(&stop)?;
    output::phase("running the hazard's sequences again");
    let prepared = earlier::prepare(&mut recorded, &arguments.elsewhere, &hosting)?;
    let prepared = earlier::as_plainly(prepared, &arguments.scan);
    let hazard = earlier::hazard(&recorded, &arguments.id, &arguments.scan)?;
    stopping::by_signals(&stop);
    match Again::new(&prepared, &recorded)?.verify(hazard)?.outcome {
        _ if stop.is_asked() => return Ok(INTERRUPTED),
        VerifiedOutcome::NotRun { cause } => return Err(Failure::running(format!("the FMU failed: {cause}"))),
        VerifiedOutcome::StillThere { body_region, robot_link, .. }
            if body_region == hazard.body_region.to_string() && robot_link == hazard.robot_link => {}
        other => return Err(gone(hazard, &prepared, other)),
    }
    let failed = |cause| Failure::from(ScanError { cause });
    let there = prepared.of_hazard(hazard)?;
    let mut simulation = there.simulation(StateChoice::Auto, false).map_err(failed)?;
    let watched = match replay::watch(&mut simulation, &there, hazard) {
        Err(error) if error.stopped => return Ok(INTERRUPTED),
        watched => watched.map_err(failed)?,
    };
    let Some(mut explanation) = explain(&there, hazard, &watched) else {
        return Err(Failure::unusable(format!("the cell has no link {}", hazard.robot_link)));
    };
    if arguments.format == Format::Table {
        output::result(&explanation.render_hazard());
    }
    if arguments.format == Format::Table
        && let Some(advice) = recorded.advice_for(&hazard.id)
    {
        output::note(&format!(" The scan found against its cause\n{}", advice.render()));
    }
    if !arguments.no_changes {
        output::note("  Trying changes of the cell. Ctrl-C ends that and keeps what is known by then");
        explanation.remedies = match changes(arguments, arguments.from, &prepared, hazard, &recorded.hazards) {
            Err(error) if error.stopped => Vec::new(),
            changes => changes.map_err(failed)?,
        };
    }
    match arguments.format {
        Format::Table => output::result(&explanation.render_changes()),
        Format::Json => {
            output::json_of(&explanation)?;
        }
    }
    if stop.is_asked() {
        output::note(" Stopped: changes that are not listed were not tried to their end");
        return Ok(INTERRUPTED);
    }
    Ok(NO_HAZARD)
}

/// That a hazard is not there any more, and why.
fn gone(hazard: &Hazard, prepared: &Prepared, outcome: VerifiedOutcome) -> Failure {
    let now = match outcome {
        VerifiedOutcome::StillThere { body_region, robot_link, .. } => {
            format!("its sequences lead to {body_region} <- {robot_link} now")
        }
        outcome => outcome.words(),
    };
    Failure::unusable_with_help(
        format!("{} is not there any more in {}: {now}", hazard.id, prepared.subject.path),
        "the cell or the FMU has changed since the scan: scan again, or name the cell that was scanned with --cell",
    )
}

/// Tries the changes; each that holds is told at once.
fn changes(
    arguments: &Arguments,
    from: Option<From>,
    prepared: &Prepared,
    hazard: &Hazard,
    known: &[Hazard],
) -> Result<Vec<RiskReduction>, PlantError> {
    let usual = RiskReductionBudget::usual();
    let everywhere = (from != Some(From::Start) && !arguments.quick).then(|| ReachabilityBudget {
        until: arguments.until.unwrap_or(UNTIL),
        presses: PRESSES,
        states: MOST_STATES,
        searches: if arguments.complete { u32::MAX } else { ReachabilityBudget::OF_ONE },
    });
    let within = RiskReductionBudget {
        everywhere,
        iterations: arguments.iterations,
        work: u64::from(arguments.max_work) * 1_000_000,
        states: if arguments.quick { 0 } else { arguments.max_states as usize },
        bytes: arguments.max_memory as usize * 1_000_000,
        workers: arguments.workers.unwrap_or(usual.workers),
        ..usual
    };
    let effort = if arguments.complete { within.without_end() } else { within };
    let telling = ProgressPrinter::new(true);
    risk_reductions(prepared, hazard, known, effort, &mut ExhaustiveBudget::new(&effort), &|told| telling.hear(&told))
}
