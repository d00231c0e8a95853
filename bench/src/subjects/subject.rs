use crate::Result;

/// Steps from rest after which elements and matrices are evaluated. The beam is then bent and in motion.
pub(super) const ESTABLISHED: u32 = 50;
/// Evaluations of elements in one run, so that the resolution of the clock has no influence.
pub(super) const REPEATS: usize = 1000;

/// Work that can be repeated identically.
pub trait Subject {
    /// Number of elements times repetitions within one run, by which the time of a run is divided.
    fn count(&self) -> f64;

    /// Prepares a run. The preparation is not measured.
    ///
    /// # Errors
    /// If the preparation fails.
    fn prepare(&mut self) -> Result<()> {
        Ok(())
    }

    /// Runs the work.
    ///
    /// # Errors
    /// If the work fails.
    fn run(&mut self) -> Result<()>;
}

/// Kind of evaluation of elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Evaluation {
    /// Residual.
    Residual,
    /// Tangent.
    Tangent,
    /// Residual and tangent.
    Both,
}
