//! Redundant equations of joints: search, shared multipliers and contradictions.

mod contradictions;
mod redundant;
mod sharing;

pub(crate) use contradictions::contradictions;
pub use redundant::Redundant;
