//! Errors of motions: those of the time steps and those of the mesh.

mod motion_errors;
mod motion_estimate;

pub use motion_errors::{MotionErrors, ProbeErrors};
pub(crate) use motion_estimate::{EstimateHistory, MotionEstimate, has_mesh};
