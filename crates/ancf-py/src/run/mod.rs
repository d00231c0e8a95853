//! Simulations, and the states of their runs.

mod frames;
mod gradients;
mod keep;
mod linear;
pub(crate) mod load;
pub(crate) mod pickle;
mod recorder;
mod simulation;
mod states;
mod station_quantity;
mod stepper;

pub(crate) use simulation::Simulation;
pub(crate) use states::{FIELD_MEMORY, States, checked_parts};
pub(crate) use stepper::Stepper;
