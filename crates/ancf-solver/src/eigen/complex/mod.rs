//! Eigenvalue problems that are not symmetric: loads without a potential, damping and gyroscopic forces.

mod arnoldi;
mod damped;
mod mass_ratios;
mod nonconservative;
mod quadratic_operator;
mod rigid_motions;
mod skew_operator;
mod skew_ratio;

pub use damped::{DampedMode, DampedModes, damped_modes};
pub use nonconservative::{ComplexMode, nonconservative_modes};
pub use skew_ratio::skew_ratio;
