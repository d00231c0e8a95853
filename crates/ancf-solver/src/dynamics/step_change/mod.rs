//! Changes of the step size within a motion.

mod adaptation;
mod auxiliary;
mod memory;
mod reference;

pub(crate) use adaptation::adapt;
pub(crate) use auxiliary::Auxiliary;
pub(crate) use memory::{SavedMemory, StepMemory};
pub(crate) use reference::StepReference;

/// Relative difference of step sizes up to which they count as equal.
pub(crate) const SAME: f64 = 0.01;
/// Ratio of step sizes above which quantities of the last step are not extrapolated: they contain vibrations that a longer step does not
/// resolve.
pub(crate) const LARGEST_RATIO: f64 = 4.0;
