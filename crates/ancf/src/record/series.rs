use std::io;
use std::ops::ControlFlow;

use crate::record::Sink;

/// Rows in memory, stored by columns.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Series {
    columns: Vec<(String, Vec<f64>)>,
}

impl Series {
    /// Creates an empty series.
    pub fn new() -> Self {
        Self::default()
    }

    /// Names of the columns.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.columns.iter().map(|(name, _)| name.as_str())
    }

    /// Values of a column; `None` if there is no such column.
    pub fn column(&self, name: &str) -> Option<&[f64]> {
        self.columns.iter().find(|(n, _)| n == name).map(|(_, values)| values.as_slice())
    }

    /// Names and values of all columns.
    pub fn columns(&self) -> impl Iterator<Item = (&str, &[f64])> {
        self.columns.iter().map(|(name, values)| (name.as_str(), values.as_slice()))
    }
}

impl Sink for Series {
    fn begin(&mut self, columns: &[String]) -> io::Result<()> {
        self.columns = columns.iter().map(|name| (name.clone(), Vec::new())).collect();
        Ok(())
    }

    fn record(&mut self, row: &[f64]) -> io::Result<ControlFlow<()>> {
        for ((_, values), &x) in self.columns.iter_mut().zip(row) {
            values.push(x);
        }
        Ok(ControlFlow::Continue(()))
    }
}

/// Passes rows on to a sink that the caller owns.
impl<S: Sink + ?Sized> Sink for &mut S {
    fn begin(&mut self, columns: &[String]) -> io::Result<()> {
        (**self).begin(columns)
    }

    fn record(&mut self, row: &[f64]) -> io::Result<ControlFlow<()>> {
        (**self).record(row)
    }

    fn finish(&mut self) -> io::Result<()> {
        (**self).finish()
    }
}
