//! Runs of models: observers, checkpoints, failures.

mod checkpoints;
mod equilibrium_starts;
mod extensions;
mod failures;
mod given_states;
mod observers;
mod recorder;
mod turns;
