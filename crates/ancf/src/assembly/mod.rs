//! Assembly of a model into equations of motion.

mod assemble;
mod bodies;
mod distributed;
mod freedom;
mod gap_closing;
mod inputs;
mod joint_builder;
mod joint_links;
mod measures;
mod redundant;

pub use assemble::{Assembly, Measure};
pub use freedom::Freedom;
pub use gap_closing::Closed;
pub use redundant::Redundant;
pub(crate) use redundant::contradictions;
