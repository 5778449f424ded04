//! A whole scan: open, bind, self-test, search, confirm. What the commands call, and what a library user calls.
//!
//! - [`prepare`]: from a path to a cell that can be simulated
//! - `hosting`: where FMUs run; `prepare_error`: why a cell cannot be simulated
//! - `loaded`: FMUs loaded and self-tested, for that
//! - [`probe`](mod@probe): what inputs do to the robots
//! - [`distance`]: how far safeguards stand from the robots, and have to by ISO 13855
//! - [`options`]: how to search, and what is told meanwhile
//! - [`run`]: one search with its findings grouped and confirmed
//! - [`exhaustive`]: all sequences, and what can be said after that
//! - [`portion`](mod@portion): a part of that, for other machines to share it
//! - `quick`: sequences chosen by a strategy
//! - `fallback`: a search, and the same again with the next, plainer state-restore strategy
//! - `from_start`: what a search from a start knows of everything that its answer needs
//! - `searched`: what a search gives besides its groups
//! - `execution`: how states are restored and merged, and what comes next when that is found to be wrong
//! - [`causes`]: which hazards belong together
//! - [`minimise`]: the shortest sequence of a hazard, by trying
//! - [`residual`]: what the random sequences of a search say about hazards that are left
//! - `seeds`: many seeds of several strategies on all cores, for both
//! - [`top_view_data`]: what the top views of a cell and of a hazard show
//! - [`replay`]: the replay of a hazard, and what its FMU gets
//! - `arms`: the person's arms in it
//! - [`initial_condition`]: where and when a hazard begins, for whatever runs its sequence
//! - `cycle`: how often the robots repeat what they do while nobody comes
//! - `share`: how much of that a search from the start met
//! - `footprint`: parts of a cell from above, for both
//! - [`verify`]: known hazards tried again
//! - [`explain`]: what there is to tell about a hazard
//! - [`risk_reduction`]: the smallest change of a cell that removes a hazard
//! - [`advise`]: such changes for the causes of a scan
//! - [`reachability`](mod@reachability): people who come from where no sensor detects them, on any walk and at any moment

mod accepted_for;
pub mod advise;
mod arms;
pub(crate) mod causes;
mod confirm;
mod contact_stop;
mod cycle;
pub(crate) mod distance;
mod execution;
pub(crate) mod exhaustive;
pub(crate) mod explain;
mod fallback;
mod footprint;
mod from_start;
mod hosting;
pub(crate) mod initial_condition;
mod loaded;
pub(crate) mod minimise;
pub(crate) mod moved;
pub mod options;
pub(crate) mod portion;
pub mod prepare;
mod prepare_error;
pub mod probe;
mod quick;
pub mod reachability;
pub mod replay;
pub mod residual;
pub mod risk_reduction;
pub(crate) mod run;
mod searched;
pub mod seeds;
mod settings;
mod share;
pub mod speeds;
mod stop_time;
pub(crate) mod top_view_data;
pub(crate) mod verify;

pub use hosting::{Hosting, StateChoice};
pub use options::{Exhaustive, Method, Progress, ScanError, ScanOptions, StrategyName};
pub use prepare::Prepared;
pub(crate) use prepare_error::PrepareError;
pub use run::{Scanned, scan, scan_with};
