//! Contact pairs of a model.

mod surface;

pub use surface::{Against, Contact};
