//! Range of an objective.

use serde::Serialize;

/// Smallest, mean and largest value of an objective, and its standard deviation; `None` without enough values.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ObjectiveRange {
    /// Smallest value.
    pub least: Option<f64>,
    /// Mean.
    pub mean: Option<f64>,
    /// Largest value.
    pub largest: Option<f64>,
    /// Sample standard deviation √(Σ(x − mean)²/(n − 1)); `None` for fewer than two values.
    pub deviation: Option<f64>,
}

impl ObjectiveRange {
    /// Returns the range of the finite values.
    pub fn of(values: impl IntoIterator<Item = f64>) -> Self {
        let values: Vec<f64> = values.into_iter().filter(|x| x.is_finite()).collect();
        let bound = |better: fn(f64, f64) -> f64| values.iter().copied().reduce(better);
        let count = values.len() as f64;
        let mean = (!values.is_empty()).then(|| values.iter().sum::<f64>() / count);
        let deviation = mean.filter(|_| values.len() > 1).map(|mean| {
            let squares: f64 = values.iter().map(|x| (x - mean).powi(2)).sum();
            (squares / (count - 1.0)).sqrt()
        });
        Self { least: bound(f64::min), mean, largest: bound(f64::max), deviation }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn range_of_values() {
        let range = ObjectiveRange::of([2.0, f64::NAN, 4.0, 9.0]);
        assert_eq!((range.least, range.mean, range.largest), (Some(2.0), Some(5.0), Some(9.0)));
        // (9 + 1 + 16)/2 = 13
        assert_eq!(range.deviation, Some(13.0_f64.sqrt()));
    }

    #[test]
    fn one_value_has_no_deviation_and_no_value_no_range() {
        let one = ObjectiveRange::of([3.0]);
        assert_eq!((one.mean, one.deviation), (Some(3.0), None));
        let none = ObjectiveRange::of([f64::NAN]);
        assert_eq!((none.least, none.mean, none.largest, none.deviation), (None, None, None, None));
    }
}
