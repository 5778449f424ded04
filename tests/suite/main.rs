//! The integration tests, a file for what each is about. One program, because to build some forty takes longer than most of them
//! run, and because tests of different files run beside each other. `cargo test --all-features --test suite explain::` runs those of
//! one file.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod common;

mod abilities;
mod advice;
mod anywhere;
mod anywhere_arms;
mod anywhere_instants;
mod anywhere_presses;
mod anywhere_sets;
mod arm_speed;
mod bad_archives;
mod bad_descriptions;
mod bad_input;
mod before_and_after;
mod beginnings;
mod book;
mod campaign_engines;
mod campaigns;
mod causes;
mod clamping;
mod controls;
mod criteria;
mod criteria_cells;
mod distance;
mod doors;
mod evaluated;
mod every_scan_ends;
mod exhaustive;
mod exhaustive_planes;
mod explain;
mod exporter_zoo;
mod first_cell;
mod fmi3_fmus;
mod fmpy_agrees;
mod following;
mod held;
mod hostile_deeds;
mod hostile_fmus;
mod hostile_model;
mod hostile_scans;
mod interrupted_scans;
mod machine_formats;
#[cfg(feature = "mcap")]
mod mcap;
mod mutated_fmus;
mod obstacles;
mod pipelines;
mod python_package;
mod reflected_mass;
mod replays;
mod report_page;
mod residual;
mod robots;
mod roles;
mod rules_twice;
mod safeguards;
mod safety_fence;
mod scan_is_reproducible;
mod second_opinion;
mod speeds_and_motion;
mod ssp;
mod states_that_lie;
mod stepping;
mod strategies;
mod terminal;
mod two_people;
mod variants;
mod workcells;
mod worker_processes;
