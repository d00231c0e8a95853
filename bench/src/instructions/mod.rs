//! Instruction counts of fixed work, and their comparison with recorded counts.

mod counts;
mod record;

pub use counts::{WORK, count, run_work};
pub use record::{InstructionRecord, record_file};
