//! Objectives of a running case.

use std::io;
use std::ops::ControlFlow;

use ancf::record::Sink;

use crate::statement::{Objective, Objectives, Take};

/// Computes the objectives while a case runs.
#[derive(Clone, Debug)]
pub struct ObjectiveGauges<'a> {
    objectives: &'a Objectives,
    /// Index of the column of each objective.
    columns: Vec<usize>,
    gauges: Vec<Gauge>,
}

impl<'a> ObjectiveGauges<'a> {
    /// Creates empty gauges.
    pub fn new(objectives: &'a Objectives) -> Self {
        Self { objectives, columns: Vec::new(), gauges: vec![Gauge::default(); objectives.len()] }
    }

    /// Returns the values of the objectives and a message for each value without a row.
    pub fn values(&self) -> (Vec<Option<f64>>, Vec<String>) {
        let mut messages = Vec::new();
        let value = |((name, objective), gauge): ((&String, &Objective), &Gauge)| {
            let value = gauge.value(objective);
            match value {
                None => {
                    let row = objective.row.map_or_else(|| "row".to_owned(), |row| format!("row {row}"));
                    messages.push(format!("objectives.{name}: no {row} among {}", gauge.count));
                }
                Some(value) if !value.is_finite() => messages.push(format!(
                    "objectives.{name}: a row of {:?} has no finite number, select another `row`",
                    objective.column
                )),
                Some(_) => {}
            }
            value
        };
        let values = self.objectives.iter().zip(&self.gauges).map(value).collect();
        (values, messages)
    }
}

impl Sink for ObjectiveGauges<'_> {
    fn begin(&mut self, columns: &[String]) -> io::Result<()> {
        let index = |(name, objective): (&String, &Objective)| {
            let index = columns.iter().position(|column| *column == objective.column);
            index.ok_or_else(|| {
                io::Error::other(format!("objectives.{name}: there is no column {:?}", objective.column))
            })
        };
        self.columns = self.objectives.iter().map(index).collect::<Result<_, _>>()?;
        Ok(())
    }

    fn record(&mut self, row: &[f64]) -> io::Result<ControlFlow<()>> {
        for ((gauge, &column), objective) in
            self.gauges.iter_mut().zip(&self.columns).zip(self.objectives.values())
        {
            gauge.add(row[column], objective.row);
        }
        Ok(ControlFlow::Continue(()))
    }
}

/// Reduces a column to one number. Returns `None` for an empty column.
pub fn reduce_column(column: impl IntoIterator<Item = f64>, take: Take) -> Option<f64> {
    let mut gauge = Gauge::default();
    column.into_iter().for_each(|x| gauge.add(x, None));
    gauge.reduced(take)
}

/// Running statistics of a column.
#[derive(Clone, Copy, Debug, Default)]
struct Gauge {
    count: u32,
    first: f64,
    last: f64,
    smallest: f64,
    largest: f64,
    sum: f64,
    squares: f64,
    /// Value of the requested row.
    requested: Option<f64>,
}

impl Gauge {
    fn add(&mut self, x: f64, row: Option<u32>) {
        if self.count == 0 {
            (self.first, self.smallest, self.largest) = (x, x, x);
        }
        if row == Some(self.count) {
            self.requested = Some(x);
        }
        self.count += 1;
        self.last = x;
        self.sum += x;
        self.squares += x * x;
        // NaN persists, as in the sum.
        let update = |bound: f64, is_beyond: bool| if is_beyond || x.is_nan() { x } else { bound };
        self.smallest = update(self.smallest, x < self.smallest);
        self.largest = update(self.largest, x > self.largest);
    }

    fn value(&self, objective: &Objective) -> Option<f64> {
        if objective.row.is_some() {
            return self.requested;
        }
        self.reduced(objective.take.unwrap_or_default())
    }

    fn reduced(&self, take: Take) -> Option<f64> {
        let count = f64::from(self.count);
        (self.count > 0).then(|| match take {
            Take::First => self.first,
            Take::Last => self.last,
            Take::Mean => self.sum / count,
            Take::Min => self.smallest,
            Take::Max => self.largest,
            Take::Amplitude => 0.5 * (self.largest - self.smallest),
            Take::Rms => (self.squares / count).sqrt(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn reduced(column: &[f64], take: Option<Take>, row: Option<u32>) -> Option<f64> {
        let objectives = Objectives::from([("x".to_owned(), Objective { column: "b".into(), take, row })]);
        let mut gauges = ObjectiveGauges::new(&objectives);
        gauges.begin(&["a".into(), "b".into()]).unwrap();
        column.iter().for_each(|&x| _ = gauges.record(&[7.0, x]).unwrap());
        gauges.values().0[0]
    }

    #[test]
    fn reductions_of_a_column() {
        let column = [1.0, -3.0, 2.0, 4.0];
        for (take, value) in [
            (Take::First, 1.0),
            (Take::Last, 4.0),
            (Take::Mean, 1.0),
            (Take::Min, -3.0),
            (Take::Max, 4.0),
            (Take::Amplitude, 3.5),
            (Take::Rms, 7.5_f64.sqrt()),
        ] {
            assert_eq!(reduced(&column, Some(take), None), Some(value), "{take:?}");
            assert_eq!(reduced(&[], Some(take), None), None);
        }
        assert_eq!(reduced(&column, None, None), Some(4.0));
        assert_eq!(reduced(&column, None, Some(1)), Some(-3.0));
        assert_eq!(reduced(&column, None, Some(4)), None);
    }

    /// The frequency of an unstable mode is NaN, and so is every reduction that includes it.
    #[test]
    fn nan_persists() {
        for column in [[1.0, f64::NAN, 2.0], [f64::NAN, 1.0, 2.0]] {
            for take in [Take::Mean, Take::Min, Take::Max, Take::Amplitude, Take::Rms] {
                assert!(reduced(&column, Some(take), None).unwrap().is_nan(), "{take:?}");
            }
            assert_eq!(reduced(&column, None, None), Some(2.0));
        }
    }
}
