//! Runs of models: observers, checkpoints, failures.

mod body_motion;
pub(crate) mod checkpoints;
mod equilibrium_starts;
mod extensions;
mod failures;
mod given_states;
mod observers;
pub(crate) mod recorder;
mod sensors;
mod turns;
