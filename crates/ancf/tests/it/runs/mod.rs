//! Runs of models: observers, checkpoints, failures.

mod alignments;
mod body_motion;
pub(crate) mod checkpoints;
mod continued_motions;
mod equilibrium_starts;
mod extensions;
mod failures;
pub(crate) mod given_states;
mod observers;
pub(crate) mod recorder;
mod resting_states;
mod sensors;
mod sequences;
mod turns;
