//! Assembly of a model into equations of motion.

mod assemble;
mod assembled;
mod bodies;
mod contacts;
mod gap_closing;
mod gases;
mod inputs;
mod joints;
mod loads;
mod redundancy;
mod start;

pub use assembled::{Assembly, RecordedQuantity};
pub(crate) use gases::{enclosures, gas_warnings};
pub use redundancy::Redundant;
pub(crate) use redundancy::contradictions;
