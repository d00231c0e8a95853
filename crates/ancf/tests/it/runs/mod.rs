//! Runs of models: observers, checkpoints, failures.

mod body_motion;
mod checkpoints;
mod equilibrium_starts;
mod extensions;
mod failures;
mod given_states;
mod observers;
mod recorder;
mod turns;
