//! Estimated errors of a motion: those of the time steps and those of the mesh.

mod error_motion;
mod motion_errors;
mod quadrature;

pub use motion_errors::MotionErrors;
