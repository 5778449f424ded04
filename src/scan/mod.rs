//! A whole scan: open, bind, self-test, search, confirm. What the commands call, and what a library user calls.
//!
//! - [`prepare`]: from a path to a cell that can be simulated
//! - `hosting`: where FMUs run; `prepare_error`: why a cell cannot be simulated
//! - `trial`: FMUs loaded and self-tested, for that
//! - [`probe`](mod@probe): what inputs do to the robots
//! - [`distance`]: how far safeguards stand from the robots, and have to by ISO 13855
//! - [`options`]: how to search, and what is told meanwhile
//! - [`run`]: one search with its findings grouped and confirmed
//! - [`exhaustive`]: all sequences, and what can be said after that
//! - [`portion`](mod@portion): a part of that, for other machines to share it
//! - `quick`: sequences chosen by a strategy
//! - `attempts`: a search, and the same again on the next rung
//! - `from_start`: what a search from a start knows of everything that its answer needs
//! - `searched`: what a search gives besides its groups
//! - `footing`: how states are brought back, and what comes next when that is found to be wrong
//! - [`causes`]: which hazards belong together
//! - [`minimise`]: the shortest sequence of a hazard, by trying
//! - [`residual`]: what the random sequences of a search say about hazards that are left
//! - `seeds`: many seeds of several strategies on all cores, for both
//! - [`picture`]: the top view of one hazard
//! - [`film`]: its replay, and what its FMU gets
//! - `arms`: the person's arms in it
//! - [`there`]: where and when a hazard begins, for whatever runs its sequence
//! - `cycle`: how often the robots repeat what they do while nobody comes
//! - `share`: how much of that a search from the start met
//! - `outline`: parts of a cell from above, for both
//! - [`verify`]: known hazards tried again
//! - [`explain`]: what there is to tell about a hazard
//! - [`remedy`]: the smallest change of a cell that removes a hazard
//! - [`advise`]: such changes for the causes of a scan
//! - [`anywhere`](mod@anywhere): people who come from where no sensor sees them, on any walk and at any moment

mod accepted_for;
pub mod advise;
pub mod anywhere;
mod arms;
mod attempts;
pub(crate) mod causes;
mod confirm;
mod contact_stop;
mod cycle;
pub(crate) mod distance;
pub(crate) mod exhaustive;
pub(crate) mod explain;
pub mod film;
mod footing;
mod from_start;
mod hosting;
pub(crate) mod minimise;
pub(crate) mod moved;
pub mod options;
mod outline;
pub(crate) mod picture;
pub(crate) mod portion;
pub mod prepare;
mod prepare_error;
pub mod probe;
mod quick;
pub mod remedy;
pub mod residual;
pub(crate) mod run;
mod searched;
pub mod seeds;
mod settings;
mod share;
pub mod speeds;
mod stop_time;
pub(crate) mod there;
mod trial;
pub(crate) mod verify;

pub use hosting::{Hosting, StateChoice};
pub use options::{Exhaustive, Method, Progress, ScanError, ScanOptions, StrategyName};
pub use prepare::Prepared;
pub(crate) use prepare_error::PrepareError;
pub use run::{Scanned, scan, scan_with};
