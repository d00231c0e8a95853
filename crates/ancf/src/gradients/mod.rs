//! Derivatives of results with respect to numbers of the model.

mod critical_factors;
mod differences;
mod differentiation;
mod eigenvalue_groups;
mod equilibrium;
mod error;
mod frequencies;
mod gradient_table;
mod parameter;
mod varied_models;

pub use differentiation::gradients;
pub use error::GradientError;
pub use gradient_table::Gradients;
pub use parameter::Parameter;
