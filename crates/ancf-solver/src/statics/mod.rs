//! Static equilibrium: load increments and arc-length continuation.

mod arc_length;
mod arc_metric;
mod equilibrium;
mod leave;
mod linear_response;
mod load_rates;
mod load_stepper;
mod path_point;
mod regularised;
mod stability;

pub use arc_length::ArcLength;
pub use equilibrium::Equilibrium;
pub use linear_response::{EquilibriumResponse, stiffness_solution};
pub use load_rates::LoadRates;
pub use load_stepper::{LoadIncrements, LoadStepper, Response, UnstablePolicy};
pub use path_point::{ArcLengthSteps, EndConditions, EndReason, LimitPoint, PathPoint};
pub use regularised::{load_rate, solve_regularised};
pub use stability::Stability;
