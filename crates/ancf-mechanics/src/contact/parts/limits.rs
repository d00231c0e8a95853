//! Limits of distances and displacements, relative to the sum of the radii.

/// Smallest distance of a point from an axis, a surface or the centre of an obstacle. A contact force at smaller distances is
/// close to its reversal.
pub(in crate::contact) const SMALLEST_DISTANCE: f64 = 0.5;
/// Largest spacing of positions that are checked.
pub(in crate::contact) const SPACING: f64 = 0.25;
/// Largest number of states that are checked between two states. A step with more of them counts as a crossing.
pub(in crate::contact) const MAX_SAMPLES: f64 = 1e4;
/// Overlap in the reference state above which two parts count as joined.
pub(in crate::contact) const JOINED_OVERLAP: f64 = 0.01;
