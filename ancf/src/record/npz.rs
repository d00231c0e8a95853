use std::fmt;
use std::io::{self, Seek, Write};
use std::ops::ControlFlow;

use ndarray::ArrayView1;
use ndarray_npy::NpzWriter;

use super::{Series, Sink};

/// NumPy's archive of arrays, one array of doubles per column; written when the run ends.
pub struct Npz<W: Write + Seek> {
    series: Series,
    to: Option<W>,
}

impl<W: Write + Seek> fmt::Debug for Npz<W> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Npz").finish_non_exhaustive()
    }
}

impl<W: Write + Seek> Npz<W> {
    /// Writes to `to`.
    pub fn new(to: W) -> Self {
        Self { series: Series::new(), to: Some(to) }
    }
}

impl<W: Write + Seek> Sink for Npz<W> {
    fn begin(&mut self, columns: &[String]) -> io::Result<()> {
        self.series.begin(columns)
    }

    fn record(&mut self, row: &[f64]) -> io::Result<ControlFlow<()>> {
        self.series.record(row)
    }

    fn finish(&mut self) -> io::Result<()> {
        let Some(to) = self.to.take() else { return Ok(()) };
        let mut archive = NpzWriter::new(to);
        for (name, values) in self.series.columns() {
            archive.add_array(name, &ArrayView1::from(values)).map_err(io::Error::other)?;
        }
        archive.finish().map_err(io::Error::other)?;
        Ok(())
    }
}
