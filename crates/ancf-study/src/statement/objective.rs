//! Objectives: the numbers that are kept of each case.

use std::collections::BTreeMap;
use std::io;
use std::ops::ControlFlow;

use ancf::record::Sink;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A number kept of each case.
#[derive(Clone, Debug, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Objective {
    /// A column of the results of the model, such as `tip.y`.
    pub column: String,
    /// What is taken of the column; its last value by default.
    #[serde(default)]
    pub take: Option<Take>,
    /// The row whose value is taken, from 0, instead of `take`.
    #[serde(default)]
    pub row: Option<u32>,
}

/// What is taken of a column.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Take {
    /// The first value.
    First,
    /// The last value.
    #[default]
    Last,
    /// The mean of all rows.
    Mean,
    /// The least value.
    Min,
    /// The largest value.
    Max,
    /// Half the difference of the largest and the least value.
    Amplitude,
    /// The root of the mean square.
    Rms,
}

/// Objectives by name.
pub type Objectives = BTreeMap<String, Objective>;

/// Measures the objectives while a case runs.
pub struct Gauges<'a> {
    objectives: &'a Objectives,
    /// Of each objective, the place of its column in a row.
    places: Vec<usize>,
    gauges: Vec<Gauge>,
}

impl<'a> Gauges<'a> {
    /// Nothing measured yet.
    pub fn of(objectives: &'a Objectives) -> Self {
        Self { objectives, places: Vec::new(), gauges: vec![Gauge::default(); objectives.len()] }
    }

    /// Values of the objectives; what there was no row for is missing and told.
    pub fn values(&self) -> (Vec<Option<f64>>, Vec<String>) {
        let mut told = Vec::new();
        let value = |((name, objective), gauge): ((&String, &Objective), &Gauge)| {
            let value = gauge.value(objective);
            if value.is_none() {
                let row = objective.row.map_or_else(|| "row".to_owned(), |row| format!("row {row}"));
                told.push(format!("objectives.{name}: no {row} among {}", gauge.count));
            }
            value
        };
        let values = self.objectives.iter().zip(&self.gauges).map(value).collect();
        (values, told)
    }
}

impl Sink for Gauges<'_> {
    fn begin(&mut self, columns: &[String]) -> io::Result<()> {
        let place = |(name, objective): (&String, &Objective)| {
            let place = columns.iter().position(|column| *column == objective.column);
            place.ok_or_else(|| {
                io::Error::other(format!("objectives.{name}: there is no column {:?}", objective.column))
            })
        };
        self.places = self.objectives.iter().map(place).collect::<Result<_, _>>()?;
        Ok(())
    }

    fn record(&mut self, row: &[f64]) -> io::Result<ControlFlow<()>> {
        for ((gauge, &place), objective) in
            self.gauges.iter_mut().zip(&self.places).zip(self.objectives.values())
        {
            gauge.read(row[place], objective.row);
        }
        Ok(ControlFlow::Continue(()))
    }
}

/// What is known of a column so far.
#[derive(Clone, Copy, Debug, Default)]
struct Gauge {
    count: u32,
    first: f64,
    last: f64,
    least: f64,
    most: f64,
    sum: f64,
    squares: f64,
    /// The value of the row that is asked for.
    asked: Option<f64>,
}

impl Gauge {
    fn read(&mut self, x: f64, row: Option<u32>) {
        if self.count == 0 {
            (self.first, self.least, self.most) = (x, x, x);
        }
        if row == Some(self.count) {
            self.asked = Some(x);
        }
        self.count += 1;
        self.last = x;
        self.sum += x;
        self.squares += x * x;
        // What is not a number stays that, as in the sum.
        let worse = |best: f64, is_better: bool| if is_better || x.is_nan() { x } else { best };
        self.least = worse(self.least, x < self.least);
        self.most = worse(self.most, x > self.most);
    }

    fn value(&self, objective: &Objective) -> Option<f64> {
        if objective.row.is_some() {
            return self.asked;
        }
        let count = f64::from(self.count);
        (self.count > 0).then(|| match objective.take.unwrap_or_default() {
            Take::First => self.first,
            Take::Last => self.last,
            Take::Mean => self.sum / count,
            Take::Min => self.least,
            Take::Max => self.most,
            Take::Amplitude => 0.5 * (self.most - self.least),
            Take::Rms => (self.squares / count).sqrt(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn taken(column: &[f64], take: Option<Take>, row: Option<u32>) -> Option<f64> {
        let objectives = Objectives::from([("x".to_owned(), Objective { column: "b".into(), take, row })]);
        let mut gauges = Gauges::of(&objectives);
        gauges.begin(&["a".into(), "b".into()]).unwrap();
        column.iter().for_each(|&x| _ = gauges.record(&[7.0, x]).unwrap());
        gauges.values().0[0]
    }

    #[test]
    fn takes_are_what_they_say() {
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
            assert_eq!(taken(&column, Some(take), None), Some(value), "{take:?}");
            assert_eq!(taken(&[], Some(take), None), None);
        }
        assert_eq!(taken(&column, None, None), Some(4.0));
        assert_eq!(taken(&column, None, Some(1)), Some(-3.0));
        assert_eq!(taken(&column, None, Some(4)), None);
    }

    /// A frequency of an unstable mode is no number, and neither is what is taken of it.
    #[test]
    fn what_is_no_number_stays_that() {
        for column in [[1.0, f64::NAN, 2.0], [f64::NAN, 1.0, 2.0]] {
            for take in [Take::Mean, Take::Min, Take::Max, Take::Amplitude, Take::Rms] {
                assert!(taken(&column, Some(take), None).unwrap().is_nan(), "{take:?}");
            }
            assert_eq!(taken(&column, None, None), Some(2.0));
        }
    }
}
