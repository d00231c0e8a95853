use ancf::model::Model;
use serde::{Deserialize, Serialize};

/// Selects the states that are written.
///
/// In dynamics, these are the first state of each of a number of equal intervals, and the last state. In other analyses, all
/// states are selected.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct StateSelection {
    /// Time at the start of a motion.
    start: f64,
    /// Time between two states; `None` selects all.
    interval: Option<f64>,
    /// Number of the next interval without a state.
    next: u64,
    /// Number of rows.
    rows: u64,
    /// True if the state of the last row was selected.
    has_last: bool,
}

/// Maximum number of values of all states of a motion: 1 GB.
const MAX_VALUES: usize = 1 << 27;

impl StateSelection {
    /// Selection of the number of states that a model requests; fewer if the states, of `width` values, are large.
    pub(super) fn new(width: usize, model: &Model) -> Self {
        let most = (MAX_VALUES / width).max(2);
        let (count, analysis) = (model.output.states, &model.analysis);
        let count = usize::try_from(count).unwrap_or(usize::MAX).min(most);
        let interval = analysis.dynamics().map(|dynamics| dynamics.duration / (count.max(2) - 1) as f64);
        let interval = interval.filter(|interval| *interval > 0.0);
        Self { start: model.initial.start_time, interval, next: 0, rows: 0, has_last: false }
    }

    /// Expected number of states of a motion.
    pub(super) fn expected(&self, model: &Model) -> f64 {
        let duration = model.analysis.dynamics().map(|dynamics| dynamics.duration);
        match (self.interval, duration) {
            (Some(interval), Some(duration)) if model.output.states > 0 => duration / interval + 1.0,
            _ => 0.0,
        }
    }

    /// Counts a row, given its first number. Returns true if its state is selected.
    pub(super) fn is_due(&mut self, first: f64) -> bool {
        // The tolerance selects instants that are at the limit of an interval except for rounding.
        let intervals = self.interval.map(|h| (first - self.start) / h + 1e-6);
        self.has_last = intervals.is_none_or(|intervals| intervals >= self.next as f64);
        if let (true, Some(intervals)) = (self.has_last, intervals) {
            self.next = intervals as u64 + 1;
        }
        self.rows += 1;
        self.has_last
    }

    /// Number of the last row.
    pub(super) fn row(&self) -> u64 {
        self.rows.saturating_sub(1)
    }

    /// True if the state of the last row was not selected.
    pub(super) fn lacks_last(&self) -> bool {
        self.rows > 0 && !self.has_last
    }
}
