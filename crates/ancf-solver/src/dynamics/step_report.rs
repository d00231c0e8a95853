use serde::{Deserialize, Serialize};

/// How a step went.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct StepReport {
    /// Newton iterations, those of failed attempts included.
    pub iterations: u32,
    /// Steps that were taken, 1 unless the step had to be divided.
    pub substeps: u32,
    /// Steps that were tried but found too inaccurate; none without error control.
    pub rejected: u32,
    /// Euclidean norm of the last residual that was evaluated.
    pub residual: f64,
    /// Euclidean norm of the last increment of the coordinates.
    pub increment: f64,
    /// The largest |Φ_q v + Φ_t| of a constraint: what the velocities violate, while Φ = 0 is solved for. In the numbers of
    /// the solver, length/time for points and 1/time for directions. Second order in h, it need not grow.
    pub drift: f64,
    /// The largest |Φ| of a constraint, in the numbers of the solver, length for points and 1 for directions.
    pub violation: f64,
    /// Whether the rounding error of the residual ended an iteration.
    pub floor: bool,
}

impl StepReport {
    /// This report and that of the step after it, as one: counts of both, norms of the later.
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
