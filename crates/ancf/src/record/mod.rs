//! Results as rows of numbers under named columns, and the sinks that receive them.

mod csv;
mod every;
mod series;

use std::io;
use std::ops::ControlFlow;

pub use csv::Csv;
pub use every::Every;
pub use series::Series;

/// Receiver of the rows of a run: a file, memory, a progress bar.
///
/// ```
/// use std::io;
/// use std::ops::ControlFlow;
///
/// use ancf::record::Sink;
///
/// /// Stops a run after a number of rows.
/// struct Limit(usize);
///
/// impl Sink for Limit {
///     fn record(&mut self, _row: &[f64]) -> io::Result<ControlFlow<()>> {
///         self.0 -= 1;
///         Ok(if self.0 == 0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) })
///     }
/// }
/// ```
pub trait Sink {
    /// Receives the names of the columns, once, before any row.
    ///
    /// # Errors
    /// If the names cannot be written; the run does not start.
    fn begin(&mut self, _columns: &[String]) -> io::Result<()> {
        Ok(())
    }

    /// Receives one row, in the user's units. `Break` stops the run and keeps the results.
    ///
    /// # Errors
    /// If the row cannot be written; the run ends.
    fn record(&mut self, row: &[f64]) -> io::Result<ControlFlow<()>>;

    /// Completes the record; called after any end of the run.
    ///
    /// # Errors
    /// If the remaining data cannot be written.
    fn finish(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Passes rows on to several sinks. Each of them can stop the run.
impl Sink for Vec<Box<dyn Sink + '_>> {
    fn begin(&mut self, columns: &[String]) -> io::Result<()> {
        self.iter_mut().try_for_each(|sink| sink.begin(columns))
    }

    fn record(&mut self, row: &[f64]) -> io::Result<ControlFlow<()>> {
        let mut flow = ControlFlow::Continue(());
        for sink in self.iter_mut() {
            if sink.record(row)?.is_break() {
                flow = ControlFlow::Break(());
            }
        }
        Ok(flow)
    }

    fn finish(&mut self) -> io::Result<()> {
        // All sinks complete their records even if one fails.
        let ends: Vec<_> = self.iter_mut().map(|sink| sink.finish()).collect();
        ends.into_iter().collect()
    }
}
