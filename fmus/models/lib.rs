//! Example workcells as FMI 2.0 and FMI 3.0 co-simulation units, and deliberately bad ones.
//!
//! One shared library holds all models and both interfaces; the instantiation picks the model by its GUID. The crate
//! has no dependencies: the build script beside it compiles it with nothing but the compiler and packs it, once
//! under each model's name, with the modelDescription.xml made from the same tables.
//!
//! From the outside in: [`fmi2`] and [`fmi3`] are the C interfaces and, with their common `pointers`, the only unsafe
//! code; `component` keeps the rules of FMI; `types3` adds the types of variables that only FMI 3.0 has; `model` is
//! what they ask of a cell, `any_model` which one runs; `cells` are the models, made from `path` (the robot's programme), `drive` (the
//! safety controller) and `kinematics`; [`interface`] holds the cells as data and the tables of variables. `trig` and
//! `bytes` serve all. The FMU that does harm on purpose is not here but in `hostile/`, in C.

mod any_model;
mod bytes;
#[cfg(test)]
mod c_interface3_tests;
#[cfg(test)]
mod c_interface_tests;
mod cells;
mod component;
mod drive;
pub mod fmi2;
pub mod fmi3;
pub mod interface;
mod kinematics;
mod model;
mod path;
mod pointers;
mod trig;
mod types3;
