//! FMUs in a process of their own: whatever they do there, it costs one action.
//!
//! - `channel`: memory shared between the program and a worker
//! - `message`: what they say to each other
//! - `process`: forks, ends and signals
//! - `sandbox`: what the worker must not do
//! - `worker`: the worker's side
//! - `launch`: starting and ending a worker, and asking it
//! - `printed`: what FMUs print
//! - `near`: both on one processor
//! - `isolated`: the program's side, a [`Plant`](super::Plant)
//! - `examine`: the self-test in a worker
//! - `habits`: what an FMU does to its process

mod channel;
mod examine;
mod habits;
mod isolated;
mod launch;
mod message;
mod near;
mod printed;
mod process;
mod sandbox;
mod worker;

pub use examine::{Examination, affordable, examine};
pub use habits::{Habit, habits};
pub use isolated::{Checkpoint, Isolated, WorkerRestore};
pub use launch::{Guard, Launcher, Limits};
pub use message::Unpacked;
pub use printed::LastLines;
pub use worker::serve;
