//! Diagnosis of a model: degrees of freedom, redundant constraints, free motions, locking.

mod locking;
mod mechanism;
mod summary;
mod time_resolution;

pub(crate) use locking::locking_warnings;
pub use mechanism::{FreeMotion, RigidMotion};
pub use summary::Diagnosis;
pub(crate) use time_resolution::time_warnings;
