use ancf_solver::equations::{Local, LocalMatrix, Power, Term, Weights, supplied};
use nalgebra::{Matrix3, Vector3};

use crate::functions::ForceFunction;
use crate::kinematics::{Marker, add_symmetric, visit_skew};

/// User-defined force on a point, computed from time, position and velocity: adds −w s F(t, x, v) with the load factor
/// s.
///
/// The force has no known potential. Its work counts as supplied work, whatever its sign. The derivatives by x and v
/// are central differences. For smooth F their error is about 10⁻¹⁰ of F per model length and per speed. The tangent
/// contains their symmetric part.
///
/// The difference steps are ∛ε times a reference value, where truncation and rounding errors balance. The reference of
/// x is the model length. The reference of v is the speed, at least the speed that passes the model length in a
/// thousand time steps.
#[derive(Clone, Debug)]
pub struct ExternalForce {
    point: Marker,
    coordinates: Vec<usize>,
    function: ForceFunction,
    length: f64,
}

/// Relative difference step ∛ε.
const STEP: f64 = 6.055e-6;
/// Smallest reference speed, in model lengths per time step.
const MIN_REFERENCE_SPEED: f64 = 1e-3;

impl ExternalForce {
    /// Creates the force on a point marker. `length` is the length of the model.
    pub fn new(point: &Marker, function: ForceFunction, length: f64) -> Self {
        let coordinates: Vec<usize> = point.coordinates().collect();
        Self { point: point.within(&coordinates), coordinates, function, length }
    }

    /// Returns position and velocity of the point.
    fn motion(&self, at: &Local<'_>) -> [Vector3<f64>; 2] {
        [self.point.reference() + self.point.sum(at.q), self.point.sum(at.v)]
    }

    fn force(&self, at: &Local<'_>, [x, v]: [Vector3<f64>; 2]) -> Vector3<f64> {
        Vector3::from(self.function.at(at.t, x.into(), v.into())) * at.load
    }

    /// Computes ∂F/∂x.
    fn position_derivative(&self, at: &Local<'_>) -> Matrix3<f64> {
        let [x, v] = self.motion(at);
        slope(x, STEP * self.length, |x| self.force(at, [x, v]))
    }

    /// Computes ∂F/∂v with difference steps for a reference speed.
    fn velocity_derivative(&self, at: &Local<'_>, speed: f64) -> Matrix3<f64> {
        let [x, v] = self.motion(at);
        slope(v, STEP * speed, |v| self.force(at, [x, v]))
    }
}

/// Computes the derivative of a function by central differences.
fn slope(x: Vector3<f64>, step: f64, f: impl Fn(Vector3<f64>) -> Vector3<f64>) -> Matrix3<f64> {
    let columns = [0, 1, 2].map(|k| {
        let (mut ahead, mut back) = (x, x);
        // Far from the origin, a step must exceed the rounding error of x.
        let step = step.max(8.0 * f64::EPSILON * x[k].abs());
        ahead[k] += step;
        back[k] -= step;
        (f(ahead) - f(back)) / (ahead[k] - back[k])
    });
    Matrix3::from_columns(&columns)
}

/// Relative skew part of a derivative by differences that counts as their error.
const DIFFERENCE_ERROR: f64 = 1e-4;

impl Term for ExternalForce {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        self.point.add(-self.force(at, self.motion(at)), r);
    }

    /// Rounding errors of the arguments, and one rounding of the result.
    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let (place, speed) = (self.point.size(at.q), self.point.sum_of_sizes(at.v));
        let mut error =
            4.0 * self.force(at, self.motion(at)).norm() + self.position_derivative(at).norm() * place;
        if speed > 0.0 {
            error += self.velocity_derivative(at, speed).norm() * speed;
        }
        for &(first, w) in self.point.parts() {
            floor[first..first + 3].iter_mut().for_each(|row| *row += 2.0 * f64::EPSILON * error * w.abs());
        }
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        if at.load == 0.0 {
            return;
        }
        let mut slope = Matrix3::zeros();
        if w.q != 0.0 {
            slope += self.position_derivative(at) * w.q;
        }
        if w.v != 0.0 {
            let rate = if w.q == 0.0 { 1.0 } else { (w.v / w.q).abs() };
            let speed = self.point.sum(at.v).norm().max(MIN_REFERENCE_SPEED * self.length * rate);
            slope += self.velocity_derivative(at, speed) * w.v;
        }
        add_symmetric(&[&self.point], &slope, -1.0, k);
    }

    fn skew_stiffness(&self, at: &Local<'_>, visit: &mut dyn FnMut(usize, usize, f64)) {
        if at.load == 0.0 {
            return;
        }
        let slope = self.position_derivative(at);
        let skew = (slope - slope.transpose()) * 0.5;
        if skew.norm() > DIFFERENCE_ERROR * slope.norm() {
            visit_skew(&[&self.point], &slope, -1.0, visit);
        }
    }

    fn power(&self, at: &Local<'_>) -> Power {
        supplied(self, at)
    }
}
