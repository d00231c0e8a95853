//! Start of a motion: consistent accelerations and multipliers, and the start values of the first step.

mod fast_motions;
mod fast_part;
mod first_step;
mod initial_conditions;
mod products;
mod rates;

pub(crate) use first_step::{StartValues, start_values};
pub(crate) use initial_conditions::{Factors, Projected, accelerations, project, solve, solve_again};
pub use initial_conditions::{
    consistent_accelerations, consistent_positions, consistent_velocities, remove_velocity_error,
};
