//! Other frames of reference: rotations, reflections, translations of a model and of its results.

mod frame;
mod model;
mod results;

pub use frame::Frame;
pub(crate) use results::{align, scale};
