//! `fmi-hazard-research step`: a cell that another program steps, a line of JSON for each question and each answer.
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

use std::error::Error;
use std::io::BufRead as _;
use std::path::PathBuf;

use fmi_hazard::scan::StateChoice;
use fmi_hazard::scan::prepare::prepare;
use serde::{Deserialize, Serialize};

use crate::stepping::{Description, Observation, Stepping, SteppingError, Taken};
use crate::tell;

#[derive(Debug, clap::Args)]
pub(crate) struct Arguments {
    /// A cell file (.toml), or an FMU with a cell file beside it or inside it
    path: PathBuf,
    /// How FMU states are brought back
    #[arg(long, value_enum, default_value_t)]
    state: StateChoice,
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

/// Answers until the input ends, at the first of the cell's initial conditions.
///
/// # Errors
/// When the cell cannot be read, or its FMU cannot be started.
pub(crate) fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let prepared = prepare(&arguments.path, None)?.beginning(0)?;
    let mut stepping = Stepping::new(&prepared, arguments.state)?;
    for line in std::io::stdin().lock().lines() {
        let line = line?;
        if line.trim().is_empty() {
            continue;
        }
        let answer = match serde_json::from_str::<Question>(&line) {
            Ok(question) => answered(&mut stepping, &question),
            Err(error) => Err(SteppingError::Asked(format!("not a question: {error}"))),
        };
        let answer = answer.unwrap_or_else(|error| Answer::Error { error: error.to_string() });
        tell(&(serde_json::to_string(&answer)? + "\n"));
    }
    Ok(())
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
