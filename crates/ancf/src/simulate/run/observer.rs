use std::io;
use std::ops::ControlFlow;

use ancf_solver::equations::State;

use super::checkpoint::Checkpoint;
use crate::record::Sink;

/// Receiver of the rows of a run and of their states.
///
/// A [`Sink`] is an observer of the rows only.
pub trait Observer {
    /// Receives the names of the columns, once, before any row.
    ///
    /// # Errors
    /// If the names cannot be recorded; the run does not start.
    fn begin(&mut self, columns: &[String]) -> io::Result<()>;

    /// Receives a row, in the user's units, and its state, in solver units. `Break` stops the run and keeps the results.
    ///
    /// For modes and buckling modes, the velocity of the state is the shape, and the acceleration the imaginary part of the shape of a
    /// damped mode, whose motion is Re(x e^{λt}). In the user's units, modes have xᵀ M x = 1. The coordinates are those of the state
    /// about which the model is linearised.
    ///
    /// # Errors
    /// If the row cannot be recorded; the run ends.
    fn record(&mut self, row: &[f64], state: &State) -> io::Result<ControlFlow<()>>;

    /// Offers a checkpoint of a dynamic analysis, after each step and its row.
    ///
    /// `take` returns the [`Checkpoint`], from which [`Simulation::resume`](super::Simulation::resume) continues. Results are
    /// bit-identical with and without checkpoints.
    ///
    /// # Errors
    /// If the checkpoint cannot be stored; the run ends.
    fn checkpoint(&mut self, _take: &dyn Fn() -> Checkpoint) -> io::Result<()> {
        Ok(())
    }

    /// Offers the checkpoint of the last accepted step of a dynamic analysis that was stopped or failed.
    ///
    /// # Errors
    /// If the checkpoint cannot be stored.
    fn last_checkpoint(&mut self, take: &dyn Fn() -> Checkpoint) -> io::Result<()> {
        self.checkpoint(take)
    }

    /// Completes the record; called after any end of the run.
    ///
    /// # Errors
    /// If the remaining data cannot be recorded.
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
