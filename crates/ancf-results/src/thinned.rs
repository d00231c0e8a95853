use serde::{Deserialize, Serialize};

/// Which rows are written: 0, n, 2n, ... and the last.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Thinned {
    every: u32,
    /// Rows so far.
    rows: u64,
    /// The last one, if it was not due.
    last: Vec<f64>,
}

impl Thinned {
    pub(crate) fn new(every: u32) -> Self {
        Self { every: every.max(1), rows: 0, last: Vec::new() }
    }

    /// Whether a row is due.
    pub(crate) fn is_due(&mut self, row: &[f64]) -> bool {
        let due = self.rows.is_multiple_of(u64::from(self.every));
        self.rows += 1;
        self.last.clear();
        if !due {
            self.last.extend_from_slice(row);
        }
        due
    }

    /// The last row, unless it was due.
    pub(crate) fn left(&mut self) -> Option<Vec<f64>> {
        Some(std::mem::take(&mut self.last)).filter(|row| !row.is_empty())
    }
}
