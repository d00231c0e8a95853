//! Units of length, time and force, and the choice of solver units.

mod choice;
mod convert;
mod names;
mod scaled;
mod scales;
mod unit_tree;

pub use ancf_derive::Scaled;
pub use choice::{ChosenScales, ScaleChoice};
pub use convert::Convert;
pub(crate) use convert::number;
pub use names::{UnitQuantity, Units};
pub use scaled::Scaled;
pub use scales::{Dimension, Scales};
pub use unit_tree::UnitTree;
