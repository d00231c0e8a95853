use std::ops::Range;

use ancf_solver::equations::{Local, LocalMatrix, State, Term, Weights};
use nalgebra::{Matrix3, Vector3};

use super::bilinear_row::{BilinearRow, QuadraticConstraint};
use super::constraint_group::GroupedConstraint;
use super::wrench::Wrench;
use crate::kinematics::Marker;

/// Bilinear equation that keeps the angle of the directions a and b: a·b = a₀·b₀.
///
/// Φ = a·b − a₀·b₀, evaluated without cancellation. Φ_qᵀ λ applies λ b to a and λ a to b.
///
/// Units: none for directions; λ is a moment.
#[derive(Clone, Debug)]
pub struct ConstantAngle {
    global: [Marker; 2],
    a: Marker,
    b: Marker,
    coordinates: Vec<usize>,
    multiplier: usize,
    name: &'static str,
}

impl ConstantAngle {
    /// Keeps the angle of two directions with the given multiplier.
    pub fn new(a: &Marker, b: &Marker, multiplier: usize) -> Self {
        let coordinates = Marker::union_coordinates([a, b]);
        let (local_a, local_b) = (a.within(&coordinates), b.within(&coordinates));
        let (global, name) = ([a.clone(), b.clone()], "angle of directions");
        Self { global, a: local_a, b: local_b, coordinates, multiplier, name }
    }

    /// Sets the description of the constraint.
    #[must_use]
    pub fn named(self, name: &'static str) -> Self {
        Self { name, ..self }
    }

    /// Returns the contribution to the joint reaction on the body of marker a: the moment a × (−λ b).
    pub fn reaction(&self, s: &State) -> Wrench {
        let [a, b] = self.global.each_ref().map(|marker| marker.value(s));
        Wrench { moment: a.cross(&(b * -s.lambda[self.multiplier])), ..Wrench::default() }
    }

    /// Copies the constraint as a part of a group.
    pub fn grouped(&self) -> Option<GroupedConstraint> {
        GroupedConstraint::new(self)
    }

    fn values(&self, q: &[f64]) -> [Vector3<f64>; 2] {
        [self.a.reference() + self.a.sum(q), self.b.reference() + self.b.sum(q)]
    }
}

impl QuadraticConstraint for ConstantAngle {
    fn rows(&self) -> Option<Vec<BilinearRow>> {
        let product = (1.0, [self.a.clone(), self.b.clone()]);
        Some(vec![BilinearRow { products: vec![product], ..BilinearRow::default() }])
    }
}

impl Term for ConstantAngle {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn multipliers(&self) -> Range<usize> {
        self.multiplier..self.multiplier + 1
    }

    fn is_damped(&self) -> bool {
        false
    }

    fn constraint_name(&self, _: usize) -> String {
        self.name.to_owned()
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        let n = at.q.len();
        let [a, b] = self.values(at.q);
        self.a.add(b * at.lambda[0], &mut r[..n]);
        self.b.add(a * at.lambda[0], &mut r[..n]);
        let (ua, ub) = (self.a.sum(at.q), self.b.sum(at.q));
        r[n] += self.a.reference().dot(&ub) + ua.dot(&self.b.reference()) + ua.dot(&ub);
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let n = at.q.len();
        let sizes = [self.a.size(at.q), self.b.size(at.q)];
        for (marker, other) in [(&self.a, sizes[1]), (&self.b, sizes[0])] {
            for &(first, w) in marker.parts() {
                for k in 0..3 {
                    floor[first + k] += f64::EPSILON * (w * at.lambda[0]).abs() * other;
                    floor[n] += f64::EPSILON * (w * at.q[first + k]).abs() * other;
                }
            }
        }
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let n = at.q.len();
        let [a, b] = self.values(at.q);
        for (marker, other) in [(&self.a, b), (&self.b, a)] {
            for &(first, weight) in marker.parts() {
                for i in 0..3 {
                    k.add(n, first + i, weight * other[i]);
                }
            }
        }
        let curvature = Matrix3::from_diagonal_element(w.q * at.lambda[0]);
        let mut add = |i: usize, j: usize, value: f64| {
            if i >= j {
                k.add(i, j, value);
            }
        };
        self.a.product(&self.b, &curvature, &mut add);
        self.b.product(&self.a, &curvature, &mut add);
    }
}
