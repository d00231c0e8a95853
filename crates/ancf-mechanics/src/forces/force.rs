use ancf_solver::equations::{Energy, Local, LocalMatrix, Term, Weights, load_power};
use nalgebra::Vector3;

use crate::functions::Function;
use crate::kinematics::Marker;

/// Force on a point, of constant direction; magnitude scaled by f(t).
///
/// Adds −w f(t) F to the residual. A constant force has the potential −f F·(x − x₀), zero in the reference
/// configuration. The work of a time-dependent force counts as supplied work.
#[derive(Clone, Debug)]
pub struct Force {
    point: Marker,
    coordinates: Vec<usize>,
    force: Vector3<f64>,
    function: Function,
}

impl Force {
    /// Creates a constant force on a point marker.
    pub fn new(point: &Marker, force: Vector3<f64>) -> Self {
        Self::varying(point, force, Function::ONE)
    }

    /// Creates a force on a point marker, times a function of time.
    pub fn varying(point: &Marker, force: Vector3<f64>, function: Function) -> Self {
        let coordinates: Vec<usize> = point.coordinates().collect();
        Self { point: point.within(&coordinates), coordinates, force, function }
    }

    fn now(&self, at: &Local<'_>) -> Vector3<f64> {
        self.force * (at.load * self.function.value(at.t))
    }
}

impl Term for Force {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        self.point.add(-self.now(at), r);
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let force = self.now(at);
        for &(first, w) in self.point.parts() {
            for k in 0..3 {
                floor[first + k] += f64::EPSILON * (w * force[k]).abs();
            }
        }
    }

    fn tangent(&self, _: &Local<'_>, _: Weights, _: &mut LocalMatrix<'_>) {}

    fn energy(&self, at: &Local<'_>) -> Energy {
        if !self.function.is_constant() {
            return Energy::default();
        }
        Energy { potential: -self.now(at).dot(&self.point.sum(at.q)), ..Energy::default() }
    }

    fn supplied_power(&self, at: &Local<'_>) -> f64 {
        if self.function.is_constant() { 0.0 } else { load_power(self, at) }
    }

    fn damping_forces(&self, _: &Local<'_>, _: &mut [f64]) {}
}
