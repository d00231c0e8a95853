//! Changes of the step size within a motion.

mod adaptation;
mod auxiliary;
mod memory;
mod reference;

pub(crate) use adaptation::adapt;
pub(crate) use auxiliary::Auxiliary;
pub(crate) use memory::{SavedMemory, StepMemory};
pub(crate) use reference::StepReference;

/// Relative difference of step sizes up to which they count as equal. It is between 1/98 and 1/97: equal parts of an interval differ by
/// such ratios, and rounding errors would decide.
pub(crate) const SAME: f64 = 0.01025;
/// Largest ratio of step sizes by which quantities of the last step are scaled. Larger ratios would scale rounding errors.
const LARGEST_RATIO: f64 = 100.0;
