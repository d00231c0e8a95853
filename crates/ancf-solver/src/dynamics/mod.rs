//! Time integration: schemes, fixed and controlled step sizes, initial conditions.

mod advance;
mod control;
mod damping_work;
mod energy_guard;
mod energy_momentum;
mod errors;
mod given_state;
mod integration_state;
mod predictor;
mod resume;
mod scheme;
mod start;
mod step_change;
mod step_report;
mod step_start;
mod time_stepper;
mod with_errors;

pub use control::{AdaptiveCheckpoint, AdaptiveStepper, ErrorControl, TimeFunctions, UnseenVariation};
pub use energy_guard::{EnergyGuard, EnergyRecord};
pub use errors::MotionErrors;
pub use integration_state::{CheckpointMismatch, StepperCheckpoint};
pub use scheme::SchemeCoefficients;
pub use start::{
    consistent_accelerations, consistent_positions, consistent_velocities, remove_velocity_error,
};
pub use step_report::StepReport;
pub use time_stepper::TimeStepper;
