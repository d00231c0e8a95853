use std::sync::Arc;

use ancf_solver::equations::{Local, LocalMatrix, Term, Weights, load_power};
use nalgebra::{DMatrix, Matrix3, Vector3};

use crate::functions::Function;
use crate::kinematics::NodalVector;

/// Rotation of the frame of reference about a fixed axis.
#[derive(Clone, Debug)]
pub struct FrameRotation {
    /// Angular velocity Ω₀, whose components are constant.
    pub velocity: Vector3<f64>,
    /// Point p of the axis.
    pub point: Vector3<f64>,
    /// Function f of time: Ω = f(t) Ω₀.
    pub function: Function,
}

impl FrameRotation {
    /// Returns Ω and Ω̇.
    fn at(&self, t: f64) -> [Vector3<f64>; 2] {
        let f = self.function.at(t);
        [self.velocity * f.value, self.velocity * f.rate]
    }
}

/// Forces of inertia of one element or rigid body in a rotating frame: centrifugal, Coriolis and Euler forces.
///
/// With the nodal vectors e_a relative to the point p of the axis, and the compact mass matrix M_ab,
///
/// f_a = −s Σ_b M_ab (Ω × (Ω × e_b) + 2 Ω × ė_b + Ω̇ × e_b),
///
/// with the load factor s. The forces are exact for all bodies whose positions are linear in the nodal vectors.
/// The Coriolis forces do no work. Those of the other forces is supplied work.
///
/// The tangent contains the centrifugal stiffness. The derivatives of the others are skew.
///
/// Source: Shabana (2020), section 3.4; Géradin & Rixen (2015), section 1.6.
#[derive(Clone, Debug)]
pub struct FrameInertia {
    coordinates: Vec<usize>,
    /// Nodal vectors in the reference state, relative to p.
    reference: Vec<Vector3<f64>>,
    mass: DMatrix<f64>,
    rotation: Arc<FrameRotation>,
}

impl FrameInertia {
    /// Creates the forces from the nodal vectors in the reference state and their compact mass matrix.
    pub fn new(
        vectors: &[NodalVector],
        mass: impl Fn(usize, usize) -> f64,
        rotation: Arc<FrameRotation>,
    ) -> Self {
        let relative = |vector: &NodalVector| {
            let origin = if vector.is_position() { rotation.point } else { Vector3::zeros() };
            vector.value - origin
        };
        Self {
            coordinates: vectors.iter().flat_map(|vector| vector.first..vector.first + 3).collect(),
            reference: vectors.iter().map(relative).collect(),
            mass: DMatrix::from_fn(vectors.len(), vectors.len(), mass),
            rotation,
        }
    }

    /// Returns the b-th nodal vector relative to p and its rate.
    fn vector(&self, at: &Local<'_>, b: usize) -> [Vector3<f64>; 2] {
        let of = |x: &[f64]| Vector3::from_column_slice(&x[3 * b..3 * b + 3]);
        [self.reference[b] + of(at.q), of(at.v)]
    }

    /// Visits the lower entries (i, j), i > j, of the matrix with the blocks M_ab H of a skew H.
    fn visit_skew(&self, h: &Matrix3<f64>, visit: &mut dyn FnMut(usize, usize, f64)) {
        let count = self.reference.len();
        for (a, b) in (0..count).flat_map(|a| (0..=a).map(move |b| (a, b))) {
            for (m, n) in [(0, 1), (0, 2), (1, 0), (1, 2), (2, 0), (2, 1)] {
                let (row, column, value) = (3 * a + m, 3 * b + n, self.mass[(a, b)] * h[(m, n)]);
                if row > column && value != 0.0 {
                    visit(row, column, value);
                }
            }
        }
    }
}

impl Term for FrameInertia {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        let [omega, rate] = self.rotation.at(at.t);
        for b in 0..self.reference.len() {
            let [e, v] = self.vector(at, b);
            let acceleration = omega.cross(&(omega.cross(&e) + v * 2.0)) + rate.cross(&e);
            for (a, rows) in r.chunks_exact_mut(3).enumerate().take(self.reference.len()) {
                let force = acceleration * (at.load * self.mass[(a, b)]);
                rows.iter_mut().zip(force.iter()).for_each(|(row, force)| *row += force);
            }
        }
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let [omega, rate] = self.rotation.at(at.t).map(|x| x.norm());
        for b in 0..self.reference.len() {
            let [e, v] = self.vector(at, b);
            let e = self.reference[b].norm() + e.norm();
            let error =
                8.0 * f64::EPSILON * at.load.abs() * ((omega * omega + rate) * e + 2.0 * omega * v.norm());
            for (a, rows) in floor.chunks_exact_mut(3).enumerate().take(self.reference.len()) {
                rows.iter_mut().for_each(|row| *row += self.mass[(a, b)].abs() * error);
            }
        }
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let factor = w.q * at.load;
        if factor == 0.0 {
            return;
        }
        let [omega, _] = self.rotation.at(at.t);
        let square =
            (omega * omega.transpose() - Matrix3::from_diagonal_element(omega.norm_squared())) * factor;
        let count = self.reference.len();
        for (a, b) in (0..count).flat_map(|a| (0..=a).map(move |b| (a, b))) {
            for (m, n) in (0..3).flat_map(|m| (0..3).map(move |n| (m, n))) {
                let (row, column) = (3 * a + m, 3 * b + n);
                if row >= column {
                    k.add(row, column, self.mass[(a, b)] * square[(m, n)]);
                }
            }
        }
    }

    /// Derivative of the Euler forces.
    fn skew_stiffness(&self, at: &Local<'_>, visit: &mut dyn FnMut(usize, usize, f64)) {
        let [_, rate] = self.rotation.at(at.t);
        self.visit_skew(&(rate * at.load).cross_matrix(), visit);
    }

    /// Derivative of the Coriolis forces.
    fn skew_damping(&self, at: &Local<'_>, visit: &mut dyn FnMut(usize, usize, f64)) {
        let [omega, _] = self.rotation.at(at.t);
        self.visit_skew(&(omega * (2.0 * at.load)).cross_matrix(), visit);
    }

    fn supplied_power(&self, at: &Local<'_>) -> f64 {
        load_power(self, at)
    }

    fn is_damped(&self) -> bool {
        false
    }
}
