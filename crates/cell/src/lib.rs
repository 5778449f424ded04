//! A robot cell as its file says: people, robots, sensors, controls, obstacles, and how all of that is bound to the variables of an FMU.
//!
//! | floor | what it is |
//! |---|---|
//! | [`cell`] | the cell file, what it draws in (URDF, meshes, SSP), plausibility, binding of FMU variables |
//! | [`hazard`] | what is unsafe, a hazard's identity, what is one cause |

pub mod cell;
pub mod hazard;

use fmi_hazard_human::{geometry, human, standards};
use fmi_hazard_outcome as obligations;
use fmi_hazard_stop as stop;
use fmu_host::{fmi, host};
