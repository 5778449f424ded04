//! The virtual human: what it does, where it stands, what space its body takes, and how far its arms reach.
//!
//! | floor | what it is |
//! |---|---|
//! | [`human`] | actions, exact places, body, arms and their reach; floor on which people can be |
//! | [`standards`] | numbers of standards, each once, with its clause and source |
//! | [`geometry`] | shapes, distances, kinematic trees |
//!
//! Knows obstacles, and nothing of robots' programmes, sensors or FMUs.

pub mod geometry;
pub mod human;
pub mod standards;

use fmi_hazard_stop as stop;
#[cfg(test)]
use {fmi_hazard_sample as sample, fmi_hazard_search as search};
