use std::any::Any;
use std::io;
use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicUsize, Ordering};

use ancf::record::{Series, Sink};
use ancf::solver::newton::Interrupt;
use ancf::{Model, Outcome, Simulation, Summary};

use super::record::{Record, Run, Verdict};

/// Rows after which a run is stopped.
const MOST_ROWS: usize = 4000;
/// Product of iterations and coordinates after which a run is stopped, instead of a time, which depends on the machine.
const MOST_WORK: usize = 2_000_000;
/// Iterations after which a run of a small model is stopped.
const MOST_ITERATIONS: usize = 20_000;

/// Runs a model. Panics are verdicts.
pub fn run(model: &Model) -> Run {
    guarded(|| of_model(model))
}

/// Runs a model on a number of threads.
pub fn run_in(model: &Model, threads: usize) -> Run {
    match rayon::ThreadPoolBuilder::new().num_threads(threads).build() {
        Ok(pool) => pool.install(|| run(model)),
        Err(error) => Run::empty(Verdict::Failed(error.to_string())),
    }
}

/// Runs a function and converts a panic into a verdict.
pub(super) fn guarded(of: impl FnOnce() -> Run) -> Run {
    let message = |panic: Box<dyn Any + Send>| {
        let text = panic.downcast_ref::<&str>().map(|text| (*text).to_owned());
        text.or_else(|| panic.downcast_ref::<String>().cloned()).unwrap_or_default()
    };
    catch_unwind(AssertUnwindSafe(of)).unwrap_or_else(|panic| Run::empty(Verdict::Panicked(message(panic))))
}

fn of_model(model: &Model) -> Run {
    let simulation = match Simulation::new(model) {
        Ok(simulation) => {
            let limit = limit(simulation.assembly().rest().q.len());
            simulation.with_interrupt(limit)
        }
        Err(errors) => return Run::empty(Verdict::Rejected(errors.to_string())),
    };
    let mut rows = Limited::new();
    let summary = simulation.run(&mut (&mut rows as &mut dyn Sink));
    completed(&simulation, rows.series, summary)
}

/// Interrupt after a number of iterations, on any machine the same.
fn limit(coordinates: usize) -> Interrupt {
    let (asked, most) = (AtomicUsize::new(0), (MOST_WORK / coordinates.max(1)).min(MOST_ITERATIONS));
    Interrupt::new(move || asked.fetch_add(1, Ordering::Relaxed) > most)
}

/// Combines the columns, the rows and the summary of a run.
pub(super) fn completed(simulation: &Simulation, series: Series, summary: io::Result<Summary>) -> Run {
    let summary = match summary {
        Ok(summary) => summary,
        Err(error) => return Run::empty(Verdict::Failed(error.to_string())),
    };
    let dimensions = simulation.columns();
    let dimension = |name: &str| dimensions.iter().find(|column| column.name == name)?.dimension;
    let column = |(name, values): (&str, &[f64])| Record {
        name: name.to_owned(),
        dimension: dimension(name),
        values: values.to_vec(),
    };
    let verdict = match summary.outcome {
        Outcome::Finished => Verdict::Finished,
        Outcome::Stopped => Verdict::Stopped,
        Outcome::Failed { reason, .. } => Verdict::Failed(reason),
    };
    Run {
        verdict,
        columns: series.columns().map(column).collect(),
        errors: summary.errors,
        motion_errors: summary.motion_errors,
        warnings: summary.warnings,
        is_redundant: !summary.redundant.is_empty(),
        is_divided: summary.divided_steps + summary.rejected_steps > 0,
    }
}

/// Rows in memory, limited in number.
pub(super) struct Limited {
    pub(super) series: Series,
    rows: usize,
}

impl Limited {
    pub(super) fn new() -> Self {
        Self { series: Series::new(), rows: 0 }
    }
}

impl Sink for Limited {
    fn begin(&mut self, columns: &[String]) -> io::Result<()> {
        self.series.begin(columns)
    }

    fn record(&mut self, row: &[f64]) -> io::Result<ControlFlow<()>> {
        self.rows += 1;
        let _ = self.series.record(row)?;
        Ok(if self.rows >= MOST_ROWS { ControlFlow::Break(()) } else { ControlFlow::Continue(()) })
    }
}
