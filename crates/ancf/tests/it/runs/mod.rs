//! Runs of whole models: observers, checkpoints and failures.

mod checkpoints;
mod failures;
mod observers;
mod recorder;
