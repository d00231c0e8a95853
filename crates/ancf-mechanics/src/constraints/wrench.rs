use std::iter::Sum;

use nalgebra::Vector3;

/// Force and moment.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wrench {
    /// Force.
    pub force: Vector3<f64>,
    /// Moment about the point of the joint.
    pub moment: Vector3<f64>,
}

impl Wrench {
    /// Returns the components along three orthonormal axes.
    #[must_use]
    pub fn seen_from(&self, axes: &[Vector3<f64>; 3]) -> Self {
        let seen = |x: &Vector3<f64>| Vector3::from(axes.map(|axis| axis.dot(x)));
        Self { force: seen(&self.force), moment: seen(&self.moment) }
    }
}

impl Sum for Wrench {
    fn sum<I: Iterator<Item = Self>>(parts: I) -> Self {
        parts.fold(Self::default(), |sum, part| Self {
            force: sum.force + part.force,
            moment: sum.moment + part.moment,
        })
    }
}
