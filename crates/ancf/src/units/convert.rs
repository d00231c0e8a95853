use super::scales::{Dimension, Scales};

/// Converts a number of a dimension into the units of `scales`.
pub(crate) fn number(x: f64, of: Dimension, scales: &Scales) -> f64 {
    x / scales.unit(of)
}

/// Quantities of one dimension: numbers, and arrays and options of numbers.
pub trait Convert {
    /// Converts the quantity into the units of `scales`.
    fn converted(self, dimension: Dimension, scales: &Scales) -> Self;
}

impl Convert for f64 {
    fn converted(self, dimension: Dimension, scales: &Scales) -> Self {
        number(self, dimension, scales)
    }
}

impl<T: Convert, const N: usize> Convert for [T; N] {
    fn converted(self, dimension: Dimension, scales: &Scales) -> Self {
        self.map(|x| x.converted(dimension, scales))
    }
}

impl<T: Convert> Convert for Option<T> {
    fn converted(self, dimension: Dimension, scales: &Scales) -> Self {
        self.map(|x| x.converted(dimension, scales))
    }
}

impl<T: Convert> Convert for Vec<T> {
    fn converted(self, dimension: Dimension, scales: &Scales) -> Self {
        self.into_iter().map(|x| x.converted(dimension, scales)).collect()
    }
}
