//! Diagnosis of a model: degrees of freedom, redundant constraints, free motions, locking, clamps at corners,
//! thick shells, numbers in mixed units.

mod connections;
mod contacts;
mod corners;
mod free_motion;
mod locking;
mod mechanism;
mod plausibility;
mod prestrained_modes;
mod shells;
mod summary;
mod time_resolution;
mod warnings;

pub(crate) use free_motion::MAX_LISTED;
pub use free_motion::{FreeMotion, RigidMotion};
pub use summary::Diagnosis;
pub(crate) use summary::projection_warning;
pub(crate) use warnings::model_warnings;
