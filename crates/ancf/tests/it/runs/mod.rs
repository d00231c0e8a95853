//! Runs of models: observers, checkpoints, failures.

mod checkpoints;
mod failures;
mod observers;
mod recorder;
