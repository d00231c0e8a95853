use std::ops::Range;

use ancf_solver::equations::{Local, LocalMatrix, State, Term, Weights};
use nalgebra::Vector3;

use super::wrench::Wrench;
use crate::kinematics::Marker;

/// Nodal vector with the direction along which its displacement counts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConstrainedVector {
    /// First coordinate.
    pub first: usize,
    /// Reference value.
    pub reference: Vector3<f64>,
    /// Direction, times a factor.
    pub direction: Vector3<f64>,
    /// True for a position, on which a force acts.
    pub is_position: bool,
}

/// Linear equation of displacements of nodal vectors: Φ = Σ d_a · q_a.
///
/// Supports of shells consist of such equations.
///
/// Units: those of the nodal vectors; λ is energy per unit of Φ.
#[derive(Clone, Debug)]
pub struct LinearConstraint {
    vectors: Vec<ConstrainedVector>,
    coordinates: Vec<usize>,
    factors: Vec<f64>,
    multiplier: usize,
    about: Marker,
    name: &'static str,
}

/// Returns the coordinates of a vector with their factors.
fn entries(v: &ConstrainedVector) -> impl Iterator<Item = (usize, f64)> + use<> {
    let (first, direction) = (v.first, v.direction);
    (0..3).filter(move |&i| direction[i] != 0.0).map(move |i| (first + i, direction[i]))
}

impl LinearConstraint {
    /// Creates an equation over distinct nodal vectors. Moments of the reaction refer to the point `about`.
    pub fn new(
        vectors: Vec<ConstrainedVector>,
        about: &Marker,
        multiplier: usize,
        name: &'static str,
    ) -> Self {
        let (coordinates, factors) = vectors.iter().flat_map(entries).unzip();
        Self { coordinates, factors, vectors, multiplier, about: about.clone(), name }
    }

    /// Adds nodal vectors of other bodies, on which the reaction acts in the opposite direction.
    #[must_use]
    pub fn with_others(mut self, others: Vec<ConstrainedVector>) -> Self {
        for (coordinate, factor) in others.iter().flat_map(entries) {
            self.coordinates.push(coordinate);
            self.factors.push(factor);
        }
        self
    }

    /// Returns the coordinates with their factors.
    pub fn entries(&self) -> impl Iterator<Item = (usize, f64)> {
        self.coordinates.iter().copied().zip(self.factors.iter().copied())
    }

    /// Returns force and moment on the body, about the point of the joint.
    pub fn reaction(&self, s: &State) -> Wrench {
        let (mut wrench, lambda) = (Wrench::default(), s.lambda[self.multiplier]);
        for v in &self.vectors {
            let force = v.direction * -lambda;
            let value = v.reference + Vector3::from_column_slice(&s.q[v.first..v.first + 3]);
            wrench.moment += value.cross(&force);
            if v.is_position {
                wrench.force += force;
            }
        }
        wrench.moment -= self.about.value(s).cross(&wrench.force);
        wrench
    }
}

impl Term for LinearConstraint {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn multipliers(&self) -> Range<usize> {
        self.multiplier..self.multiplier + 1
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        for (i, factor) in self.factors.iter().enumerate() {
            r[i] += factor * at.lambda[0];
            r[at.q.len()] += factor * at.q[i];
        }
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        for (i, factor) in self.factors.iter().enumerate() {
            floor[i] += f64::EPSILON * (factor * at.lambda[0]).abs();
            floor[at.q.len()] += 2.0 * f64::EPSILON * (factor * at.q[i]).abs();
        }
    }

    fn tangent(&self, at: &Local<'_>, _: Weights, k: &mut LocalMatrix<'_>) {
        self.factors.iter().enumerate().for_each(|(i, factor)| k.add(at.q.len(), i, *factor));
    }

    fn constraint_name(&self, _: usize) -> String {
        self.name.to_owned()
    }

    fn is_damped(&self) -> bool {
        false
    }
}
