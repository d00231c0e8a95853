//! Estimated and true error of a quantity.

/// Estimated and true error of a quantity.
#[derive(Clone, Debug, PartialEq)]
pub struct Effectivity {
    /// Name of the quantity.
    pub what: String,
    /// Level of refinement, such as the number of elements.
    pub level: u32,
    /// Estimate of the exact value less the computed one.
    pub estimate: f64,
    /// Reference less the computed value.
    pub error: f64,
    /// Permitted range of their ratio.
    pub range: [f64; 2],
}

impl Effectivity {
    /// Returns the ratio of the estimated and the true error.
    pub fn ratio(&self) -> f64 {
        self.estimate / self.error
    }

    /// True if the ratio is in its range. NaN is not.
    pub fn holds(&self) -> bool {
        (self.range[0]..=self.range[1]).contains(&self.ratio())
    }
}
