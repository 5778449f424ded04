//! Distances between shapes.
