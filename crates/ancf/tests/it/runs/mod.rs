//! Runs of models: observers, checkpoints, failures.

mod body_motion;
mod checkpoints;
mod extensions;
mod failures;
mod observers;
mod recorder;
mod turns;
