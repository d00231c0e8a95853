use super::function_value::FunctionValue;

/// Piecewise linear function through points in time, constant before the first and after the last point.
///
/// Two points at the same time define a jump.
#[derive(Clone, Debug, PartialEq)]
pub struct TimeTable {
    points: Vec<[f64; 2]>,
}

impl TimeTable {
    /// Creates the table through points (t, f) in ascending order of time.
    pub fn new(points: impl IntoIterator<Item = [f64; 2]>) -> Self {
        Self { points: points.into_iter().collect() }
    }

    /// Returns value and slope, and 0 for a table without points.
    pub(crate) fn at(&self, t: f64) -> FunctionValue {
        let next = self.points.partition_point(|[time, _]| *time <= t);
        let before = next.checked_sub(1).map(|last| self.points[last]);
        let held = |value| FunctionValue { value, ..FunctionValue::default() };
        match (before, self.points.get(next)) {
            (Some([t0, f0]), Some([t1, f1])) => {
                let slope = (f1 - f0) / (t1 - t0);
                FunctionValue { value: f0 + slope * (t - t0), rate: slope, acceleration: 0.0 }
            }
            (Some([_, value]), None) => held(value),
            (None, Some([_, value])) => held(*value),
            (None, None) => FunctionValue::default(),
        }
    }

    /// Returns the points (t, f).
    pub(crate) fn points(&self) -> &[[f64; 2]] {
        &self.points
    }

    /// Returns the times of the points.
    pub(crate) fn breaks(&self) -> Vec<f64> {
        let mut times: Vec<f64> = self.points.iter().map(|[time, _]| *time).collect();
        times.dedup();
        times
    }
}
