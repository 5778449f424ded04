//! Example workcells as FMI 2.0 co-simulation units, and a deliberately bad one.
//!
//! One shared library holds all models; `fmi2Instantiate` picks the one whose GUID it is given. The crate has no
//! dependencies: the build script of `fmi-hazard` compiles it with nothing but the compiler and packs it, once under
//! each model's name, with the modelDescription.xml made from the same tables.
//!
//! From the outside in: [`fmi2`] is the C interface and the only unsafe code; `component` keeps the rules of FMI;
//! `model` is what they both ask of a cell; `cells` are the models, made from `path` (the robot's programme), `drive`
//! (the safety controller) and `kinematics`; [`interface`] holds the cells as data and the tables of variables. `trig`
//! and `bytes` serve all.

mod bytes;
mod cells;
mod component;
mod drive;
pub mod fmi2;
pub mod interface;
mod kinematics;
mod model;
mod path;

mod trig;
