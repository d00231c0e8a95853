/// Stopping rule of a Newton iteration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StopRule {
    /// Energy of the increment: |Δq·r| + |Δλ·Φ| ≤ tolerance² × the largest energy so far, or residual at its rounding
    /// error.
    ///
    /// The products are independent of units, slope coordinates and frame of reference, and so is the number of
    /// iterations. Newton's method converges quadratically, so the remaining error is far below the tolerance. The
    /// tolerance is relative to the size of the motion in the energy norm. With a reused tangent the increments
    /// decrease by a rate θ. The estimated remainder, θ/(1 − θ) times the last increment, must then be at most 1e-4 of the
    /// tolerance, and 2e-5 of the first increment. Remainders of successive steps with the same tangent have the same
    /// sign, so they accumulate as the errors of the scheme do. The first increment is the error of the extrapolated start
    /// value, some twenty times the error of the scheme in this step.
    Energy(f64),
    /// Residual: |r|₂ is at most this number, with forces and constraints in one norm. Depends on units.
    Residual(f64),
    /// Increment: |Δq|₂ is at most this number. Depends on units.
    Increment(f64),
}

/// Report of a Newton iteration.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct NewtonReport {
    /// Number of linear solutions.
    pub iterations: u32,
    /// Euclidean norm of the last residual that was evaluated.
    pub residual: f64,
    /// Euclidean norm of the last increment of the coordinates.
    pub increment: f64,
    /// True if the iteration ended at the rounding error of the residual.
    pub floor: bool,
}

/// Estimated remainder of the increments, relative to the tolerance, at which a reused tangent counts as converged.
pub(super) const REMAINDER: f64 = 1e-4;
/// Estimated remainder of the increments, relative to the first increment. Far below a hundredth of the error of a step.
const REDUCTION: f64 = 2e-5;
/// Smallest target of the remainder, relative to the tolerance.
const LEAST_REMAINDER: f64 = 1e-7;
/// Smallest target of the remainder, relative to the size of the motion. It is at the rounding error.
const ROUNDING: f64 = 1e-15;

/// Returns the remainder of the increments at which a reused tangent counts as converged, for increments that are `expected` to be
/// small, a first increment and the size of the motion, as roots of energies.
pub(super) fn remainder_target(expected: f64, first: f64, motion: f64) -> f64 {
    let least = (LEAST_REMAINDER * expected).max(ROUNDING * motion);
    (REDUCTION * first).min(REMAINDER * expected).max(least)
}
