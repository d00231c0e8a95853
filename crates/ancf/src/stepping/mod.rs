//! Motions that a program advances step by step, with inputs that it sets.

mod advance;
mod events;
mod inputs;
mod linear;
mod read;
mod snapshot;
mod start;
mod step_error;
mod stepper;
mod vector;

pub use inputs::InputUse;
pub use linear::{DescriptorForm, LinearModel};
pub use step_error::StepError;
pub use stepper::Stepper;
pub use vector::{BodyLayout, CompleteState, Projection};
