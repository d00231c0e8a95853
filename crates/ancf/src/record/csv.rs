use std::io::Write;
use std::ops::ControlFlow;
use std::{fmt, io};

use crate::record::Sink;

/// Writes comma-separated values: a line of names, then a line per row. The decimal numbers determine the binary ones exactly.
pub struct Csv<W: Write> {
    writer: csv::Writer<W>,
}

impl<W: Write> fmt::Debug for Csv<W> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Csv").finish_non_exhaustive()
    }
}

impl<W: Write> Csv<W> {
    /// Creates a buffered writer to `to`.
    pub fn new(to: W) -> Self {
        Self { writer: csv::Writer::from_writer(to) }
    }
}

impl<W: Write> Sink for Csv<W> {
    fn begin(&mut self, columns: &[String]) -> io::Result<()> {
        Ok(self.writer.write_record(columns)?)
    }

    fn record(&mut self, row: &[f64]) -> io::Result<ControlFlow<()>> {
        self.writer.serialize(row)?;
        Ok(ControlFlow::Continue(()))
    }

    fn finish(&mut self) -> io::Result<()> {
        self.writer.flush()
    }
}
