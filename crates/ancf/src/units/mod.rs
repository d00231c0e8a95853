//! Units of length, time and force, and the choice of solver units.

mod choice;
mod convert;
mod names;
mod scales;

pub use choice::{Chosen, ScaleChoice};
pub(crate) use convert::{number, vector};
pub use names::Units;
pub use scales::{Dimension, Scales};
