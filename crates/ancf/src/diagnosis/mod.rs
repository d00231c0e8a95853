//! Diagnosis of a model: degrees of freedom, redundant constraints, free motions, locking, clamps at corners.

mod corners;
mod locking;
mod mechanism;
mod summary;

pub(crate) use corners::corner_warnings;
pub(crate) use locking::locking_warnings;
pub use mechanism::{FreeMotion, RigidMotion};
pub use summary::Diagnosis;
