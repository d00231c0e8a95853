use ancf_solver::equations::{
    Energy, Local, LocalMatrix, LocalStep, Term, Weights, discrete_residual, load_power, middle_residual,
};
use nalgebra::Vector3;

use crate::functions::Function;
use crate::kinematics::BodyVector;

/// Force on a point, of constant direction; magnitude scaled by f(t).
///
/// Adds −w f(t) F to the residual. At an arm of a section the force acts as a force and a moment on its frame. A constant force has the potential −f F·(x − x₀), zero in the reference
/// configuration. The work of a time-dependent force counts as supplied work.
#[derive(Clone, Debug)]
pub struct Force {
    point: BodyVector,
    coordinates: Vec<usize>,
    force: Vector3<f64>,
    function: Function,
}

impl Force {
    /// Creates a constant force on a point.
    pub fn new(point: impl Into<BodyVector>, force: Vector3<f64>) -> Self {
        Self::varying(point, force, Function::ONE)
    }

    /// Creates a force on a point, times a function of time.
    pub fn varying(point: impl Into<BodyVector>, force: Vector3<f64>, function: Function) -> Self {
        let point = point.into();
        let coordinates = BodyVector::union_coordinates([&point]);
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
        self.point.add(at.q, -self.now(at), r);
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let force = self.now(at);
        let Some(point) = self.point.marker() else {
            return self.point.add_errors(at.q, force.norm(), 0.0, floor);
        };
        for &(first, w) in point.parts() {
            for k in 0..3 {
                floor[first + k] += f64::EPSILON * (w * force[k]).abs();
            }
        }
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        if !self.point.is_linear() {
            self.point.add_curvature(at.q, self.now(at) * -w.q, k);
        }
    }

    fn average_residual(&self, step: &LocalStep<'_>, r: &mut [f64]) {
        if self.point.is_linear() || !self.function.is_constant() {
            return middle_residual(self, step, r);
        }
        discrete_residual(self, step, r);
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        if !self.function.is_constant() {
            return Energy::default();
        }
        Energy { potential: -self.now(at).dot(&self.point.change(at.q)), ..Energy::default() }
    }

    fn supplied_power(&self, at: &Local<'_>) -> f64 {
        if self.function.is_constant() { 0.0 } else { load_power(self, at) }
    }

    fn is_damped(&self) -> bool {
        false
    }
}
