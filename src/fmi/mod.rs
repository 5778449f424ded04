//! fmi
