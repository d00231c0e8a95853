//! Rows of a motion by time.

use crate::{SolvedModel, VerificationError};

/// Returns the row recorded at a time, up to rounding.
pub(super) fn row_at(solved: &SolvedModel, t: f64) -> Result<usize, VerificationError> {
    let near = |time: &f64| (time - t).abs() <= 1e-9 * t.abs().max(1e-3);
    solved
        .column("t")?
        .iter()
        .position(near)
        .ok_or_else(|| VerificationError::Missing(format!("row at t = {t}")))
}
