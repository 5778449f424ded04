//! The rules of the page `docs/src/method.md`, written a second time from that page alone, by plain enumeration.
//!
//! Nothing here uses the program but its way to run an FMU (`fmi_hazard::fmi`): geometry, body, arms, sensors, planes and
//! forces are its own. Every history of inputs runs on a fresh instance from the start; no state is saved. Two states are
//! taken for one only if all their samples of sensors and their integer places are equal.
//!
//! | file | what it is |
//! |---|---|
//! | [`geometry`] | vectors, segments, boxes and half-spaces |
//! | [`cell`] | the keys of a cell file that are needed here |
//! | [`body`] | place, walk, posture, capsules and regions |
//! | [`cells`] | the cells that are looked at |
//! | [`force`] | limits, which speed decides, forces, unsafe contacts |
//! | [`robot`] | runs of the FMU, and where the links are then |
//! | [`arm`] | poses of arms: certain, uncertain or none |
//! | [`planes`] | sensors, and which run and depth an arm gets behind a plane |
//! | [`clamp`] | what is clamped, by samples of every surface |
//! | [`clamp_asked`] | the program asked about such a scene |
//! | [`clamp_scenes`] | random scenes for that |
//! | [`enumerate`] | all sequences, and what a single one meets |
//!
//! Arms: the program promises to find what stays a contact above the limit when the arm moves by its tolerance of 20 mm, and
//! to tell of nothing that is none. So the answer here has three values, and a count two ends.

#![allow(dead_code, reason = "tests use different parts")]

pub mod arm;
pub mod body;
pub mod cell;
pub mod cells;
pub mod clamp;
pub mod clamp_asked;
pub mod clamp_scenes;
pub mod enumerate;
pub mod force;
pub mod geometry;
pub mod planes;
pub mod robot;
