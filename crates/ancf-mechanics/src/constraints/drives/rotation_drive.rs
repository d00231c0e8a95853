use std::ops::Range;

use ancf_solver::equations::{Local, LocalMatrix, State, Term, Weights};
use nalgebra::Vector3;

use crate::constraints::Wrench;
use crate::constraints::coincidence::{AXES, direction};
use crate::functions::{Function, FunctionValue};
use crate::kinematics::{Marker, relative_driven_rotation};

/// Three linear equations that prescribe a direction by rotation of its reference value about an axis.
///
/// Φ = (a − a₀) + c, c = −(R(k, θ) − I) a₀ = −sin θ k × a₀ − (1 − cos θ) k × (k × a₀), with the angle θ = s α f(t). f
/// is a function of time and s the load factor, which differs from 1 in statics only. Φ_qᵀ λ applies λ to a.
///
/// Units: none for the direction; λ is a moment, α an angle in radians.
#[derive(Clone, Debug)]
pub struct RotationDrive {
    global: Marker,
    a: Marker,
    coordinates: Vec<usize>,
    first: usize,
    /// k × a₀ and k × (k × a₀).
    cross_products: [Vector3<f64>; 2],
    angle: f64,
    function: Function,
}

impl RotationDrive {
    /// Rotates a direction about a unit vector by an angle times a function of time. Uses the three multipliers from
    /// `first`.
    pub fn new(a: &Marker, axis: Vector3<f64>, angle: f64, function: Function, first: usize) -> Self {
        let coordinates: Vec<usize> = a.coordinates().collect();
        let once = axis.cross(&a.reference());
        let cross_products = [once, axis.cross(&once)];
        Self {
            global: a.clone(),
            a: a.within(&coordinates),
            coordinates,
            first,
            cross_products,
            angle,
            function,
        }
    }

    /// Returns the contribution to the reaction of the drive on the body: the moment a × (−λ).
    pub fn reaction(&self, s: &State) -> Wrench {
        let force = -Vector3::from_column_slice(&s.lambda[self.first..self.first + 3]);
        Wrench { moment: self.global.value(s).cross(&force), ..Wrench::default() }
    }

    /// Returns the prescribed angle θ.
    fn prescribed(&self, at: &Local<'_>) -> f64 {
        at.load * self.angle * self.function.value(at.t)
    }

    /// Computes (R − I) a₀, with 1 − cos θ free of cancellation.
    fn turned(&self, at: &Local<'_>) -> Vector3<f64> {
        let angle = self.prescribed(at);
        self.cross_products[0] * angle.sin() + self.cross_products[1] * (2.0 * (0.5 * angle).sin().powi(2))
    }
}

impl Term for RotationDrive {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn multipliers(&self) -> Range<usize> {
        self.first..self.first + 3
    }

    fn is_damped(&self) -> bool {
        false
    }

    fn constraint_name(&self, k: usize) -> String {
        format!("driven {} along {}", direction(self.global.reference()), AXES[k])
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        let (rows, equations) = r.split_at_mut(at.q.len());
        self.a.add(Vector3::from_column_slice(at.lambda), rows);
        let apart = self.a.sum(at.q) - self.turned(at);
        for (row, apart) in equations.iter_mut().zip(&apart) {
            *row += apart;
        }
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let (rows, equations) = floor.split_at_mut(at.q.len());
        let angle = self.prescribed(at);
        for k in 0..3 {
            // The rounding error of an angle of many turns is ε times its value.
            let size = self.cross_products[0][k].abs() + self.cross_products[1][k].abs();
            equations[k] += f64::EPSILON * size * (1.0 + angle.abs());
        }
        for &(first, w) in self.a.parts() {
            for k in 0..3 {
                rows[first + k] += f64::EPSILON * (w * at.lambda[k]).abs();
                equations[k] += f64::EPSILON * (w * at.q[first + k]).abs();
            }
        }
    }

    fn tangent(&self, at: &Local<'_>, _: Weights, k: &mut LocalMatrix<'_>) {
        let n = at.q.len();
        for &(first, w) in self.a.parts() {
            for i in 0..3 {
                k.add(n + i, first + i, w);
            }
        }
    }

    fn rotation(&self, from: &Local<'_>, to: &Local<'_>) -> f64 {
        relative_driven_rotation(self.prescribed(to) - self.prescribed(from))
    }

    fn drive(&self, t: f64, rates: &mut [f64], accelerations: &mut [f64]) {
        let FunctionValue { value, rate, acceleration } = self.function.at(t);
        let [angle, omega, alpha] = [value, rate, acceleration].map(|x| self.angle * x);
        let (sin, cos) = angle.sin_cos();
        let first = self.cross_products[0] * cos + self.cross_products[1] * sin;
        let second = self.cross_products[1] * cos - self.cross_products[0] * sin;
        for k in 0..3 {
            rates[k] -= omega * first[k];
            accelerations[k] -= alpha * first[k] + omega * omega * second[k];
        }
    }
}
