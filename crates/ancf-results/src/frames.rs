use ancf::Simulation;
use ancf::model::Analysis;
use ancf::system::{EquationsOfMotion, State};
use serde::{Deserialize, Serialize};

use crate::layout::Layout;

/// Which states are kept: of motions the first of each of so many equal times, and the last; of all else every one.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Frames {
    /// Time between two of them; of every row if there is none.
    interval: Option<f64>,
    kept: u64,
    /// Rows so far.
    rows: u64,
    /// Whether the last row is among them.
    has_last: bool,
}

/// Numbers of all states that are kept of a motion: 1 GB.
const NUMBERS: usize = 1 << 27;

impl Frames {
    /// About so many; fewer if the states are large.
    pub(crate) fn new(simulation: &Simulation, analysis: &Analysis, count: u32) -> Self {
        let most = (NUMBERS / layout(simulation).width()).max(2);
        let count = usize::try_from(count).unwrap_or(usize::MAX).min(most);
        let interval = analysis.dynamics().map(|dynamics| dynamics.duration / (count.max(2) - 1) as f64);
        let interval = interval.filter(|interval| *interval > 0.0);
        Self { interval, kept: 0, rows: 0, has_last: false }
    }

    /// Whether the state of a row, which begins with this number, is kept.
    pub(crate) fn is_due(&mut self, first: f64) -> bool {
        // Of instants that but for rounding are at the time, none is missed.
        let times = self.interval.map(|h| first / h + 1e-6);
        self.has_last = times.is_none_or(|times| times >= self.kept as f64);
        if let (true, Some(times)) = (self.has_last, times) {
            self.kept = times as u64 + 1;
        }
        self.rows += 1;
        self.has_last
    }

    /// The number of the last row.
    pub(crate) fn row(&self) -> u64 {
        self.rows.saturating_sub(1)
    }

    /// Whether the last row is still to be kept.
    pub(crate) fn lack_last(&self) -> bool {
        self.rows > 0 && !self.has_last
    }
}

/// The columns of states.
pub(crate) fn layout(simulation: &Simulation) -> Layout {
    let system = &simulation.assembly().system;
    let coordinates = |name: &str| (name.to_owned(), system.coordinates());
    let lists = ["q", "v", "a"].map(coordinates).into_iter();
    let numbers = ["row", "value", "load"].map(str::to_owned).to_vec();
    Layout::new(numbers, lists.chain([("lambda".to_owned(), system.multipliers())]).collect())
}

/// The numbers of a state, in order.
pub(crate) fn numbers(s: &State) -> [&[f64]; 4] {
    [&s.q, &s.v, &s.a, &s.lambda]
}
