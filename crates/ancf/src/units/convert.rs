use super::scales::{Dimension, Scales};

/// Converts a number of a dimension into the units of `scales`.
pub(crate) fn number(x: f64, of: Dimension, scales: &Scales) -> f64 {
    x / scales.unit(of)
}

/// Converts a vector of a dimension into the units of `scales`.
pub(crate) fn vector(x: [f64; 3], of: Dimension, scales: &Scales) -> [f64; 3] {
    x.map(|x| number(x, of, scales))
}
