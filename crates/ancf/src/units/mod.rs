//! Units of length, time and force, and the choice of solver units.

mod choice;
mod names;
mod scales;

pub use choice::{Chosen, ScaleChoice};
pub use names::Units;
pub use scales::{Dimension, Scales};
