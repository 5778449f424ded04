//! `fmi-hazard step`: a cell that another program steps, a line of JSON for each question and each answer.
//!
//! | question | answer |
//! |---|---|
//! | `{"do": "describe"}` | names of actions, sensors and links; how long an episode is |
//! | `{"do": "reset"}` | `observation` at the start |
//! | `{"do": "step", "action": 7}` | `observation`, `reward`, `end`, `hazard` |
//! | `{"do": "save"}` | `state`, a number |
//! | `{"do": "restore", "state": 1}` | `observation` there |
//! | `{"do": "forget", "state": 1}` | nothing |
//!
//! What cannot be done is answered with `error`; the conversation goes on. It ends with the input.

use std::io::BufRead as _;
use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use super::exit::{Failure, NO_HAZARD};
use super::hosting::HostingArguments;
use super::{output, stopping};
use crate::scan::StateChoice;
use crate::scan::prepare::prepare_in;
use crate::scan::stepping::{Description, Observation, Stepping, SteppingError, Taken};
use crate::stop::Stop;

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// A cell file (.toml), or an FMU with a cell file beside it or inside it
    path: PathBuf,
    /// The cell file of an FMU that has none of its own
    #[arg(long)]
    cell: Option<PathBuf>,
    /// The cell's beginning to start from, when it has several
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..))]
    begin: u32,
    /// How FMU states are brought back
    #[arg(long, value_enum, default_value_t)]
    state: StateChoice,
    #[command(flatten)]
    hosting: HostingArguments,
}

/// A question.
#[derive(Debug, Deserialize)]
#[serde(tag = "do", rename_all = "snake_case", deny_unknown_fields)]
enum Question {
    Describe,
    Reset,
    Step { action: usize },
    Save,
    Restore { state: u64 },
    Forget { state: u64 },
}

/// An answer.
#[derive(Debug, Serialize)]
#[serde(untagged)]
enum Answer {
    Description(Description),
    There { observation: Observation },
    Taken(Taken),
    Saved { state: u64 },
    Nothing {},
    Error { error: String },
}

pub(super) fn run(arguments: &Arguments) -> Result<u8, Failure> {
    let stop = Stop::default();
    let prepared = prepare_in(&arguments.path, arguments.cell.as_deref(), &arguments.hosting.heeding(&stop)?)?;
    let count = prepared.cell.beginnings.len();
    if arguments.begin as usize > count {
        return Err(Failure::unusable_with_help(
            format!("the cell has no beginning {}", arguments.begin),
            format!("it has {count}: give one of them with --begin"),
        ));
    }
    let there = prepared.beginning(arguments.begin as usize - 1)?;
    stopping::by_signals(&stop);
    let mut stepping = Stepping::new(&there, arguments.state)
        .map_err(|error| Failure::running(format!("the FMU failed at its start: {error}")))?;
    for line in std::io::stdin().lock().lines() {
        let Ok(line) = line else { break };
        if stop.is_asked() {
            break;
        }
        if line.trim().is_empty() {
            continue;
        }
        let answer = match serde_json::from_str::<Question>(&line) {
            Ok(question) => answered(&mut stepping, &question),
            Err(error) => Err(SteppingError::Asked(format!("not a question: {error}"))),
        };
        let answer = answer.unwrap_or_else(|error| Answer::Error { error: error.to_string() });
        output::json_line(&answer)?;
    }
    Ok(NO_HAZARD)
}

fn answered(stepping: &mut Stepping, question: &Question) -> Result<Answer, SteppingError> {
    Ok(match *question {
        Question::Describe => Answer::Description(stepping.description().clone()),
        Question::Reset => Answer::There { observation: stepping.reset()? },
        Question::Step { action } => Answer::Taken(stepping.step(action)?),
        Question::Save => Answer::Saved { state: stepping.save()? },
        Question::Restore { state } => Answer::There { observation: stepping.restore(state)? },
        Question::Forget { state } => {
            stepping.forget(state);
            Answer::Nothing {}
        }
    })
}
