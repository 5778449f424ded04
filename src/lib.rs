//! Adversarial search for hazards in robot workcells that come as FMUs.
//!
//! One sentence: a black-box FMU and a virtual human share one simulation; a search over human actions drives it; every
//! unsafe state it finds becomes a confirmed, replayable, explained hazard.
//!
//! # The method on one page
//!
//! After Huck, Ledermann and Kroeger, *Virtual Adversarial Humans finding Hazards in Robot Workplaces* (ICRA 2021).
//! A person takes actions of 200 ms: one of six ways to walk (1.6 m/s, ISO 13855) times one of six ways to bend. Arms
//! are not actions: at every instant all arm poses are searched for one that touches the robot and is free of
//! obstacles. A state is unsafe when person and robot touch and the potential collision force
//! `F = v sqrt(mu k)`, `mu = (1/m_H + 1/m_R)^-1`, exceeds the limit of the body region (ISO/TS 15066 Annex A), or when a
//! moving robot touches the head; clamping, pressure, any contact with a moving robot and separation count where a cell says so.
//! Monte Carlo tree search with double progressive widening looks for action
//! sequences that reach such a state; states of the FMU are saved and restored, and every finding is confirmed by a
//! fresh instance without any restore.
//!
//! # The house
//!
//! Each floor may use only the floors below it.
//!
//! | floor | what it is |
//! |---|---|
//! | [`cli`] | the commands, thin |
//! | [`campaign`] | many scans: planned, done in parts anywhere, put together |
//! | [`strategies`] | many seeds of several strategies side by side, and beside the paper |
//! | [`scan`] | a whole scan: open, bind, self-test, search, confirm |
//! | [`report`] | what people and programs read |
//! | [`record`] | results as plain records |
//! | [`search`] | strategies over an abstract environment; knows nothing of FMUs or geometry |
//! | [`sequences`] | all actions from many states of a cell at once |
//! | [`reachability`] | where people may be who come from anywhere, and whether they are hit there |
//! | [`sim`] | plant + person + sensors + contact as one environment with snapshots |
//! | [`hazard`] | what is unsafe, danger level, findings and their identity |
//! | [`obligations`] | what an answer rests on, and the verdict that follows; nothing else makes a clean one |
//! | [`cell`] | the cell file and its binding to FMU variables |
//! | [`human`] | actions, exact place, body, arms and their reach |
//! | [`host`] | where an FMU runs, and how its state is brought back |
//! | [`geometry`] | shapes, distances, kinematic trees |
//! | [`fmi`] | open an FMU safely, read it, call it; useful alone |
//! | [`standards`] | the numbers, with their sources |
//! | [`stop`] | when work has to end; every floor may look |
//!
//! `sim` implements the trait of `search`, and nothing else of it is used below.
//!
//! # Example
//!
//! ```
//! use std::ops::ControlFlow;
//! use fmi_hazard::scan::{Method, ScanOptions, StateChoice, StrategyName, prepare::prepare, scan};
//!
//! # let dir = tempfile::tempdir()?;
//! fmi_hazard::examples::export(dir.path())?;
//! let cell = prepare(&dir.path().join("safety-fence/cell.toml"), None)?;
//! let options = ScanOptions {
//!     method: Method::Strategy(StrategyName::MctsDpw),
//!     seed: 1,
//!     iterations: 320,
//!     stop_at_first: true,
//!     posture_sweep: true,
//!     state: StateChoice::Auto,
//! };
//! let report = scan(&cell, options, &mut |_| ControlFlow::Continue(()))?.report;
//! let hazard = &report.hazards[0];
//! assert_eq!(hazard.confirmed, Some(true));
//! assert!(hazard.force_n > hazard.limit_n);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub(crate) mod campaign;
pub mod cli;
pub mod scan;
pub mod strategies;

pub use fmi_hazard_cell::cell;
pub use fmi_hazard_criteria as hazard;
pub use fmi_hazard_examples as examples;
pub use fmi_hazard_human::{geometry, human, standards};
pub use fmi_hazard_outcome as obligations;
pub use fmi_hazard_reachability as reachability;
pub use fmi_hazard_record as record;
pub use fmi_hazard_report as report;
pub use fmi_hazard_search as search;
pub use fmi_hazard_sequences as sequences;
pub use fmi_hazard_simulation as sim;
pub use fmi_hazard_stop as stop;
pub use fmu_host::{fmi, host};
