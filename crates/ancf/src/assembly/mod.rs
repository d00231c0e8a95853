//! Assembly of a model into equations of motion.

mod assemble;
mod assembled;
mod bodies;
mod contacts;
mod contradictions;
mod gap_closing;
mod inputs;
mod joints;
mod loads;
mod redundant;
mod sharing;
mod start;

pub use assembled::{Assembly, RecordedQuantity};
pub(crate) use contradictions::contradictions;
pub use redundant::Redundant;
