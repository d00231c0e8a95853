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
