//! Redundant equations of joints, and contradictions between them.

mod constraints;
mod redundant;

pub(super) use constraints::{APART, Constraints, Owner};
pub(super) use redundant::Redundancy;
pub use redundant::Redundant;
