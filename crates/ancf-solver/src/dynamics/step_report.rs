use serde::{Deserialize, Serialize};

/// Report of a time step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct StepReport {
    /// Number of Newton iterations, including failed attempts.
    pub iterations: u32,
    /// Number of substeps. It is 1 unless the step was divided.
    pub substeps: u32,
    /// Number of steps rejected by the error control.
    pub rejected: u32,
    /// Euclidean norm of the last residual that was evaluated.
    pub residual: f64,
    /// Euclidean norm of the last increment of the coordinates.
    pub increment: f64,
    /// Velocity drift: the largest |Φ_q v + Φ_t| of a constraint, while Φ = 0 is solved.
    ///
    /// The units are solver units: length/time for points, 1/time for directions. The drift is of second order in h and
    /// need not grow.
    pub drift: f64,
    /// Constraint violation: the largest |Φ|, in solver units of length for points and 1 for directions.
    pub violation: f64,
    /// True if an iteration ended at the rounding error of the residual.
    pub floor: bool,
}

impl StepReport {
    /// Combines this report with that of the next step: the sum of the counts and the norms of the next step.
    #[must_use]
    pub fn then(self, next: &Self) -> Self {
        Self {
            iterations: self.iterations + next.iterations,
            substeps: self.substeps + next.substeps,
            rejected: self.rejected + next.rejected,
            floor: self.floor || next.floor,
            ..*next
        }
    }
}
