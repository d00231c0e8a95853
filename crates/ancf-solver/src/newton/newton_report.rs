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
