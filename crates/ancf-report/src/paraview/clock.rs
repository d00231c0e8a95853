use ancf::model::Analysis;

use crate::Recording;
use crate::chart::places_on;

/// What tells the times of frames.
#[derive(Debug)]
pub(super) struct Clock {
    /// First numbers of the rows and their places, if these are not the same.
    rows: Option<Vec<(f64, f64)>>,
    next: usize,
}

impl Clock {
    /// Of a path, whose load factors go up and down, times are the places of rows along it.
    pub fn new(recording: &Recording<'_>) -> Self {
        let of_path = matches!(recording.model.analysis, Analysis::Path(_));
        let first = recording.series.columns().next().filter(|_| of_path);
        let rows = first.and_then(|(_, first)| {
            let places = places_on(recording, first)?;
            Some(first.iter().copied().zip(places).collect())
        });
        Self { rows, next: 0 }
    }

    /// The time of the next frame, by the first number of its row.
    pub fn time(&mut self, value: f64) -> f64 {
        let Some(rows) = &self.rows else { return value };
        let found = rows.iter().enumerate().skip(self.next).find(|(_, (first, _))| *first == value);
        // Rows may be behind the frames of a run that goes on.
        let (row, time) = found.map_or((self.next, self.next as f64), |(row, (_, place))| (row, *place));
        self.next = row + 1;
        time
    }
}
