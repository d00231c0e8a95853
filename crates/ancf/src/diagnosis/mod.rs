//! Diagnosis of a model: degrees of freedom, redundant constraints, free motions, locking, clamps at corners.

mod corners;
mod free_motion;
mod locking;
mod mechanism;
mod summary;
mod time_resolution;

pub(crate) use corners::corner_warnings;
pub(crate) use free_motion::MAX_LISTED;
pub use free_motion::{FreeMotion, RigidMotion};
pub(crate) use locking::locking_warnings;
pub use summary::Diagnosis;
pub(crate) use time_resolution::time_warnings;
