use ancf_solver::equations::{LOCAL, Local, LocalMatrix, Term, Weights, load_power};
use nalgebra::{Matrix3, Vector3};

use crate::constraints::add_outer;
use crate::functions::ForceFunction;
use crate::kinematics::BodyVector;

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
    point: BodyVector,
    coordinates: Vec<usize>,
    function: ForceFunction,
    length: f64,
}

/// Relative difference step ∛ε.
const STEP: f64 = 6.055e-6;
/// Smallest reference speed, in model lengths per time step.
const MIN_REFERENCE_SPEED: f64 = 1e-3;

impl ExternalForce {
    /// Creates the force on a point. `length` is the length of the model.
    pub fn new(point: impl Into<BodyVector>, function: ForceFunction, length: f64) -> Self {
        let point = point.into();
        let coordinates = BodyVector::union_coordinates([&point]);
        Self { point: point.within(&coordinates), coordinates, function, length }
    }

    /// Returns position and velocity of the point.
    fn motion(&self, at: &Local<'_>) -> [Vector3<f64>; 2] {
        [self.point.at(at.q), self.point.rate(at.q, at.v)]
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

impl ExternalForce {
    /// Adds the change of the velocity with the coordinates, for a point at an arm of a section.
    fn add_turning(&self, at: &Local<'_>, by_velocity: &Matrix3<f64>, k: &mut LocalMatrix<'_>) {
        if self.point.is_linear() {
            return;
        }
        let n = at.q.len();
        for axis in 0..3 {
            let (mut forces, mut slopes) = ([0.0; LOCAL], [0.0; LOCAL]);
            let unit = Vector3::from_fn(|i, _| if i == axis { 1.0 } else { 0.0 });
            self.point.add(at.q, by_velocity.column(axis).into_owned(), &mut forces[..n]);
            self.point.add_slope(at.q, at.v, unit, &mut slopes[..n]);
            add_outer(&forces, &slopes, -1.0, n, k);
        }
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

    fn has_kinks(&self) -> bool {
        true
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        self.point.add(at.q, -self.force(at, self.motion(at)), r);
    }

    /// Rounding errors of the arguments, and one rounding of the result.
    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let (place, speed) = (self.point.size(at.q), self.point.rate_size(at.q, at.v));
        let mut error =
            4.0 * self.force(at, self.motion(at)).norm() + self.position_derivative(at).norm() * place;
        if speed > 0.0 {
            error += self.velocity_derivative(at, speed).norm() * speed;
        }
        let Some(point) = self.point.marker() else {
            return self.point.add_errors(at.q, error, 2.0 * f64::EPSILON * error, floor);
        };
        for &(first, w) in point.parts() {
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
            let speed = self.point.rate(at.q, at.v).norm().max(MIN_REFERENCE_SPEED * self.length * rate);
            let by_velocity = self.velocity_derivative(at, speed);
            slope += by_velocity * w.v;
            self.add_turning(at, &(by_velocity * w.q), k);
        }
        self.point.add_quadratic(at.q, &-slope, k);
        if !self.point.is_linear() {
            self.point.add_curvature(at.q, self.force(at, self.motion(at)) * -w.q, k);
        }
    }

    fn skew_stiffness(&self, at: &Local<'_>, visit: &mut dyn FnMut(usize, usize, f64)) {
        if at.load == 0.0 {
            return;
        }
        let slope = self.position_derivative(at);
        let skew = (slope - slope.transpose()) * 0.5;
        if skew.norm() > DIFFERENCE_ERROR * slope.norm() {
            self.point.visit_skew(&self.point, at.q, &-slope, visit);
        }
    }

    fn supplied_power(&self, at: &Local<'_>) -> f64 {
        load_power(self, at)
    }

    fn is_damped(&self) -> bool {
        false
    }
}
