//! CPU time, repeated samples, and the peak performance of the machine.

pub mod clock;
mod machine;
mod samples;

pub use machine::{Machine, compiler};
pub use samples::{SampleSize, median, sample, samples};
