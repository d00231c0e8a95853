use std::fs::File;
use std::io::{self, BufWriter, Write};

/// Writer of a table that collects its columns: thousands of a few kilobytes each, which Parquet flushes one by one.
pub(super) struct Collected<'a>(BufWriter<&'a File>);

/// Bytes that are written at once.
const CAPACITY: usize = 1 << 20;

impl<'a> Collected<'a> {
    pub(super) fn new(file: &'a File) -> Self {
        Self(BufWriter::with_capacity(CAPACITY, file))
    }

    /// Writes the rest.
    pub(super) fn finish(mut self) -> io::Result<()> {
        self.0.flush()
    }
}

impl Write for Collected<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.write(bytes)
    }

    /// Does nothing: [`finish`](Self::finish) flushes.
    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
