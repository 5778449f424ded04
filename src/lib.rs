//! Adversarial search for hazards in robot workcells that come as FMUs.

pub mod cell;
pub mod cli;
pub mod examples;
pub mod fmi;
pub mod geometry;
pub mod hazard;
pub mod host;
pub mod human;
pub mod report;
pub mod search;
pub mod sim;
pub mod standards;
