use std::io;
use std::ops::ControlFlow;

use ancf_solver::equations::State;

use super::checkpoint::Checkpoint;
use crate::record::Sink;

/// Whoever follows a run: receives each of its rows together with the state that it is about.
///
/// A [`Sink`] is an observer that looks at the rows only.
pub trait Observer {
    /// Receives the names of the columns, once, before any row.
    ///
    /// # Errors
    /// If they cannot be recorded; the run does not start.
    fn begin(&mut self, columns: &[String]) -> io::Result<()>;

    /// Receives a row, in the user's units, and its state, in those of the solver; `Break` ends the run in good order.
    ///
    /// A mode or a shape of buckling is the velocity of its state, such that the velocity in the user's units is the shape with
    /// xᵀ M x = 1 (modes); coordinates are those of the state about which it is one.
    ///
    /// # Errors
    /// If the row cannot be recorded; the run ends.
    fn record(&mut self, row: &[f64], state: &State) -> io::Result<ControlFlow<()>>;

    /// May keep where a motion is, after each step and the row that belongs to it: `take` makes a [`Checkpoint`] of it, from which
    /// [`Simulation::resume`](super::Simulation::resume) goes on. Whether and when they are taken changes no bit of the results.
    ///
    /// # Errors
    /// If it cannot be kept; the run ends.
    fn checkpoint(&mut self, _take: &dyn Fn() -> Checkpoint) -> io::Result<()> {
        Ok(())
    }

    /// May keep where a motion ended that stopped or failed: as of the last accepted step, from which it may be tried again.
    ///
    /// # Errors
    /// If it cannot be kept.
    fn last_checkpoint(&mut self, take: &dyn Fn() -> Checkpoint) -> io::Result<()> {
        self.checkpoint(take)
    }

    /// Completes the record, however the run ended.
    ///
    /// # Errors
    /// If what is left cannot be recorded.
    fn finish(&mut self) -> io::Result<()>;
}

impl<S: Sink + ?Sized> Observer for S {
    fn begin(&mut self, columns: &[String]) -> io::Result<()> {
        Sink::begin(self, columns)
    }

    fn record(&mut self, row: &[f64], _: &State) -> io::Result<ControlFlow<()>> {
        Sink::record(self, row)
    }

    fn finish(&mut self) -> io::Result<()> {
        Sink::finish(self)
    }
}
