//! Example workcells as FMUs.
