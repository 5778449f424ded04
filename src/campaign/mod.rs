//! Many scans as one piece of work: what is to be done, each part of it by itself on any machine, and all of it put together.
//!
//! - [`description`]: the campaign file, and what is wrong with it
//! - [`values`]: the values of a sweep, and the little arithmetic that cells are changed with
//! - [`variants`]: the cell files that follow from it
//! - [`manifest`]: all scans, each with what its result depends on as a hash
//! - [`plan`](mod@plan): from the one to the other
//! - [`sealed`]: a result on disk, whole or not there
//! - [`part`]: one task
//! - [`run`](mod@run): the tasks of a shard
//! - [`status`]: what is there and what is missing
//! - [`merge`](mod@merge): all results together
//! - [`error`]: what can go wrong, and whose fault it is
//!
//! It knows nothing of what hands its tasks to machines: a shard is a number out of so many, a task has a name, and files are in one
//! folder. Any queue can work with that.

pub(crate) mod description;
pub(crate) mod error;
pub(crate) mod manifest;
pub(crate) mod merge;
pub(crate) mod part;
pub(crate) mod plan;
pub(crate) mod run;
pub(crate) mod sealed;
pub(crate) mod status;
pub(crate) mod values;
pub(crate) mod variants;

pub(crate) use error::CampaignError;
pub(crate) use manifest::Manifest;
