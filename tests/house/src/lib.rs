//! The rules of the house as tests: they read the sources of this workspace and tell what breaks a rule.
//!
//! A file a rule, with its limit, its exceptions and its test. An exception is what broke the rule when the rule was made, with the
//! figure it had. It may get smaller, not larger, and leaves the list when it no longer breaks the rule: so the lists only shrink.
//!
//! - `circles`: no files of a crate that use each other in a circle; `modules` and `arrows` find out which uses which
//! - `long_functions`, `long_files` and `parameters`: how large something may be; `functions` reads them
//! - `first_lines`: every file begins by saying what it is for
//! - `named`: CONTRIBUTING.md names every crate and its folders
//! - `no_sentence_twice`: what the viewer says the program does not say as well; `strings` reads both
//!
//! `sources` reads the files, `paths` the paths in them; `exceptions` compares what is found with a list.

pub mod arrows;
pub mod circles;
pub mod exceptions;
pub mod first_lines;
pub mod functions;
pub mod long_files;
pub mod long_functions;
pub mod modules;
pub mod named;
pub mod no_sentence_twice;
pub mod parameters;
pub mod paths;
pub mod sources;
pub mod strings;
