use std::fmt;

use ancf::model::{Analysis, Model, Step};

/// Bytes per number in `probes.csv` and in Parquet files, measured on the example models.
const CSV_BYTES: f64 = 15.0;
const PARQUET_BYTES: f64 = 6.0;

/// Expected sizes of the result files of a motion, in bytes. Statics, paths, modes and buckling have small files.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ExpectedSize {
    /// Number of rows.
    pub rows: f64,
    /// Number of columns.
    pub columns: usize,
    /// Bytes of `probes.csv`.
    pub csv: f64,
    /// Bytes of `results.parquet`.
    pub results: f64,
    /// Bytes of `states.parquet`.
    pub states: f64,
}

impl ExpectedSize {
    /// Estimates the sizes for a number of columns, and a number of values per state. With error control, the number of rows is
    /// known only if the model states an interval or a largest step.
    pub(super) fn new(model: &Model, columns: usize, state_values: usize, states: f64) -> Self {
        let Analysis::Dynamics(settings) = &model.analysis else { return Self::default() };
        let output = &model.output;
        let step = match settings.step {
            Step::Fixed(step) => Some(step),
            Step::Adaptive { largest, .. } => largest,
        };
        let instants = output.interval.or(step).map_or(0.0, |interval| settings.duration / interval);
        let rows = (instants / f64::from(output.every)).ceil() + 1.0;
        // There are not more states than rows, whose number is unknown if it depends on the sizes of the steps.
        let states = if instants > 0.0 { states.min(rows) } else { states };
        let numbers = rows * columns as f64;
        let of = |is_written: bool, bytes: f64| if is_written { bytes } else { 0.0 };
        Self {
            rows,
            columns,
            csv: of(output.csv, CSV_BYTES * numbers),
            results: of(output.parquet, PARQUET_BYTES * numbers),
            states: PARQUET_BYTES * states * state_values as f64,
        }
    }

    /// Bytes of all files.
    pub fn total(&self) -> f64 {
        self.csv + self.results + self.states
    }
}

impl fmt::Display for ExpectedSize {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { rows, columns, csv, states, .. } = self;
        let is_large = |bytes: f64| bytes > 0.1 * self.total();
        let size = |bytes: f64| {
            if bytes < 1e9 { format!("{:.0} MB", bytes / 1e6) } else { format!("{:.1} GB", bytes / 1e9) }
        };
        write!(f, "the results will have about {}: {rows} rows of {columns} columns", size(self.total()))?;
        write!(f, "; `output.every` or `output.interval` records fewer rows")?;
        if is_large(*csv) {
            write!(f, ", and `output.csv = false` omits the text file of {}", size(*csv))?;
        }
        if is_large(*states) {
            write!(f, "; the states have {}; `output.states` records fewer", size(*states))?;
        }
        Ok(())
    }
}
