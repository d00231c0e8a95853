//! Diagnosis of a model: degrees of freedom, redundant constraints, free motions.

mod mechanism;
mod summary;

pub use mechanism::{FreeMotion, RigidMotion};
pub use summary::Diagnosis;
