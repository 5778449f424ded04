//! A robot cell as its file says: people, robots, sensors, controls, obstacles, and how all of that is bound to the variables of an FMU.
//!
//! | floor | what it is |
//! |---|---|
//! | [`cell`] | the cell file, what it draws in (URDF, meshes, SSP), plausibility, binding of FMU variables |

pub mod cell;

use fmi_hazard_criteria as hazard;
use fmi_hazard_human::{geometry, human, standards};
use fmi_hazard_outcome as obligations;
use fmi_hazard_stop as stop;
use fmu_host::{fmi, host};
