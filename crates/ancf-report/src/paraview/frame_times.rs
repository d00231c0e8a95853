use ancf::model::Analysis;

use crate::charts::positions_on_abscissa;
use crate::run::Recording;

/// Times of frames.
#[derive(Debug)]
pub(super) struct FrameTimes {
    /// Value and time of each row of a path; `None` if values are times.
    rows: Option<Vec<(f64, f64)>>,
    next: usize,
}

impl FrameTimes {
    /// Times of a recording. Those of a path are arc lengths, because its load factor may decrease.
    pub fn new(recording: &Recording<'_>) -> Self {
        let is_path = matches!(recording.model.analysis, Analysis::Path(_));
        let first = recording.series.columns().next().filter(|_| is_path);
        let rows = first.and_then(|(_, first)| {
            let positions = positions_on_abscissa(recording, first)?;
            Some(first.iter().copied().zip(positions).collect())
        });
        Self { rows, next: 0 }
    }

    /// Time of the next frame, given the first number of its row.
    pub fn time(&mut self, value: f64) -> f64 {
        let Some(rows) = &self.rows else { return value };
        let found = rows.iter().enumerate().skip(self.next).find(|(_, (first, _))| *first == value);
        // In a running analysis, frames may be ahead of rows.
        let (row, time) = found.map_or((self.next, self.next as f64), |(row, (_, time))| (row, *time));
        self.next = row + 1;
        time
    }
}
