//! Runs and damaged files for several tests and for the fuzz target `results`.

pub mod anything;
