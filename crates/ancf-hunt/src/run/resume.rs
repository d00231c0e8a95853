use std::io;
use std::ops::ControlFlow;

use ancf::record::{Series, Sink};
use ancf::solver::equations::State;
use ancf::{Checkpoint, Model, Observer, Simulation};

use super::record::{Run, Verdict};
use super::runner::{completed, guarded};

/// Runs a dynamic model, stops it after a number of rows, and resumes it from the checkpoint there.
///
/// The columns are those of the whole run.
pub fn resumed(model: &Model, rows: usize) -> Run {
    guarded(|| in_two_parts(model, rows))
}

fn in_two_parts(model: &Model, rows: usize) -> Run {
    let simulation = match Simulation::new(model) {
        Ok(simulation) => simulation,
        Err(errors) => return Run::empty(Verdict::Rejected(errors.to_string())),
    };
    let mut first = FirstPart { series: Series::new(), left: rows, checkpoint: None };
    let summary = simulation.run(&mut first);
    let (Some(checkpoint), true) = (first.checkpoint, first.left == 0) else {
        return completed(&simulation, first.series, summary);
    };
    let mut second = SecondPart { series: first.series, skip: 0 };
    let recorded = second.series.columns().next().map_or(0, |(_, values)| values.len());
    second.skip = recorded.saturating_sub(checkpoint.rows() as usize);
    // A new simulation, as in a new process.
    let again = match Simulation::new(model) {
        Ok(simulation) => simulation,
        Err(errors) => return Run::empty(Verdict::Rejected(errors.to_string())),
    };
    let end = again.resume(&checkpoint, &mut (&mut second as &mut dyn Sink));
    completed(&again, second.series, end.map_err(io::Error::other))
}

/// Observer that stops after a number of rows and keeps the last checkpoint.
struct FirstPart {
    series: Series,
    left: usize,
    checkpoint: Option<Checkpoint>,
}

impl Observer for FirstPart {
    fn begin(&mut self, columns: &[String]) -> io::Result<()> {
        Sink::begin(&mut self.series, columns)
    }

    fn record(&mut self, row: &[f64], _: &State) -> io::Result<ControlFlow<()>> {
        let _ = Sink::record(&mut self.series, row)?;
        self.left = self.left.saturating_sub(1);
        Ok(if self.left == 0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) })
    }

    fn last_checkpoint(&mut self, take: &dyn Fn() -> Checkpoint) -> io::Result<()> {
        self.checkpoint = Some(take());
        Ok(())
    }

    fn finish(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Sink that appends rows, without those that the first part recorded.
struct SecondPart {
    series: Series,
    skip: usize,
}

impl Sink for SecondPart {
    fn record(&mut self, row: &[f64]) -> io::Result<ControlFlow<()>> {
        if self.skip > 0 {
            self.skip -= 1;
            return Ok(ControlFlow::Continue(()));
        }
        Sink::record(&mut self.series, row)
    }
}
