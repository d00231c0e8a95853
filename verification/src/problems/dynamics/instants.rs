//! Rows of a motion by their time.

use crate::{Error, Solved};

/// The row that was recorded at a time, within rounding.
pub(super) fn row_at(solved: &Solved, t: f64) -> Result<usize, Error> {
    let near = |time: &f64| (time - t).abs() <= 1e-9 * t.abs().max(1e-3);
    solved.column("t")?.iter().position(near).ok_or_else(|| Error::Missing(format!("row at t = {t}")))
}
