//! Results as rows of numbers under named columns, and the sinks that receive them.

mod csv;
mod every;
mod series;

use std::io;
use std::ops::ControlFlow;

pub use csv::Csv;
pub use every::Every;
pub use series::Series;

/// Whoever receives the rows of a run: a file, memory, a progress bar.
///
/// ```
/// use std::io;
/// use std::ops::ControlFlow;
///
/// use ancf::record::Sink;
///
/// /// Ends a run after so many rows.
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

    /// Receives one instant; `Break` ends the run in good order.
    ///
    /// # Errors
    /// If the row cannot be written; the run ends.
    fn record(&mut self, row: &[f64]) -> io::Result<ControlFlow<()>>;

    /// Completes the record, however the run ended.
    ///
    /// # Errors
    /// If what is left cannot be written.
    fn finish(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Several sinks at once; any of them may end the run.
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
        // All of them complete their record even if one fails.
        let ends: Vec<_> = self.iter_mut().map(|sink| sink.finish()).collect();
        ends.into_iter().collect()
    }
}
