use std::io::{BufWriter, Write};
use std::ops::ControlFlow;
use std::{fmt, io};

use crate::record::Sink;

/// Writes comma-separated values: a line of names, then a line per row. The decimal numbers determine the binary ones exactly.
pub struct Csv<W: Write> {
    to: BufWriter<W>,
    /// Text of a row.
    line: Vec<u8>,
}

/// Bytes of the buffer of a file: a full disk is detected after a few rows.
const BUFFER: usize = 1 << 13;

impl<W: Write> fmt::Debug for Csv<W> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Csv").finish_non_exhaustive()
    }
}

impl<W: Write> Csv<W> {
    /// Creates a buffered writer to `to`.
    pub fn new(to: W) -> Self {
        Self { to: BufWriter::with_capacity(BUFFER, to), line: Vec::new() }
    }

    /// Writes all buffered text and returns the underlying writer.
    ///
    /// # Errors
    /// If the text cannot be written.
    pub fn into_inner(self) -> io::Result<W> {
        self.to.into_inner().map_err(io::IntoInnerError::into_error)
    }
}

impl<W: Write> Sink for Csv<W> {
    /// Names may require quotes, numbers do not.
    fn begin(&mut self, columns: &[String]) -> io::Result<()> {
        let mut names = csv::Writer::from_writer(&mut self.to);
        names.write_record(columns)?;
        names.flush()
    }

    fn record(&mut self, row: &[f64]) -> io::Result<ControlFlow<()>> {
        let mut decimal = zmij::Buffer::new();
        self.line.clear();
        for (number, &x) in row.iter().enumerate() {
            if number > 0 {
                self.line.push(b',');
            }
            self.line.extend_from_slice(decimal.format(x).as_bytes());
        }
        self.line.push(b'\n');
        self.to.write_all(&self.line)?;
        Ok(ControlFlow::Continue(()))
    }

    fn finish(&mut self) -> io::Result<()> {
        self.to.flush()
    }
}
