use std::io;
use std::ops::ControlFlow;

use crate::record::Sink;

/// Passes every n-th row and the last row on to another sink.
#[derive(Debug)]
pub struct Every<S> {
    every: u32,
    count: u32,
    last: Option<Vec<f64>>,
    sink: S,
}

impl<S: Sink> Every<S> {
    /// Passes rows 0, n, 2n, ... and the last row on to `sink`.
    pub fn new(every: u32, sink: S) -> Self {
        Self { every: every.max(1), count: 0, last: None, sink }
    }
}

impl<S: Sink> Sink for Every<S> {
    fn begin(&mut self, columns: &[String]) -> io::Result<()> {
        self.sink.begin(columns)
    }

    fn record(&mut self, row: &[f64]) -> io::Result<ControlFlow<()>> {
        let due = self.count == 0;
        self.count = (self.count + 1) % self.every;
        if due {
            self.last = None;
            return self.sink.record(row);
        }
        let last = self.last.get_or_insert_default();
        last.clear();
        last.extend_from_slice(row);
        Ok(ControlFlow::Continue(()))
    }

    fn finish(&mut self) -> io::Result<()> {
        if let Some(last) = self.last.take() {
            // The run has ended, so a stop request has no effect.
            let _ = self.sink.record(&last)?;
        }
        self.sink.finish()
    }
}
