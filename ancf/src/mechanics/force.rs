use nalgebra::Vector3;

use super::Marker;
use crate::system::{Energy, Local, LocalMatrix, Term, Weights};

/// A force on a point, constant in size and direction.
///
/// Adds −w F to the residual; its potential −F·(x − x₀) is zero in the reference configuration.
#[derive(Clone, Debug)]
pub struct Force {
    point: Marker,
    coordinates: Vec<usize>,
    force: Vector3<f64>,
}

impl Force {
    /// The force on a point marker.
    pub fn new(point: &Marker, force: Vector3<f64>) -> Self {
        let coordinates: Vec<usize> = point.coordinates().collect();
        Self { point: point.within(&coordinates), coordinates, force }
    }
}

impl Term for Force {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        self.point.add(-self.force * at.load, r);
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        for &(first, w) in self.point.parts() {
            for k in 0..3 {
                floor[first + k] += f64::EPSILON * (w * at.load * self.force[k]).abs();
            }
        }
    }

    fn tangent(&self, _: &Local<'_>, _: Weights, _: &mut LocalMatrix<'_>) {}

    fn energy(&self, at: &Local<'_>) -> Energy {
        Energy { potential: -at.load * self.force.dot(&self.point.sum(at.q)), ..Energy::default() }
    }
}
