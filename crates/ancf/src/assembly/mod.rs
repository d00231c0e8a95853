//! Assembly of a model into equations of motion.

mod assemble;
mod assembled;
mod bodies;
mod contacts;
mod contradictions;
mod gap_closing;
mod gases;
mod inputs;
mod joints;
mod loads;
mod redundancy;
mod sharing;
mod start;

pub use assembled::{Assembly, RecordedQuantity};
pub(crate) use contacts::MutualGeometry;
pub(crate) use contradictions::contradictions;
pub(crate) use gases::{enclosures, gas_warnings};
pub use redundancy::Redundant;
