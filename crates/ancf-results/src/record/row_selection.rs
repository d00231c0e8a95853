use serde::{Deserialize, Serialize};

/// Selects the rows that are written: 0, n, 2n, ... and the last one.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct RowSelection {
    every: u32,
    /// Number of rows.
    rows: u64,
    /// Last row, if it was not selected.
    last: Vec<f64>,
}

impl RowSelection {
    pub(super) fn new(every: u32) -> Self {
        Self { every: every.max(1), rows: 0, last: Vec::new() }
    }

    /// Counts a row. Returns true if the row is selected.
    pub(super) fn is_due(&mut self, row: &[f64]) -> bool {
        let due = self.rows.is_multiple_of(u64::from(self.every));
        self.rows += 1;
        self.last.clear();
        if !due {
            self.last.extend_from_slice(row);
        }
        due
    }

    /// Takes the last row, unless it was selected.
    pub(super) fn take_last(&mut self) -> Option<Vec<f64>> {
        Some(std::mem::take(&mut self.last)).filter(|row| !row.is_empty())
    }
}
