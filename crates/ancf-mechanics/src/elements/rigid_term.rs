use std::ops::Range;

use ancf_solver::equations::{Energy, Inadmissibility, Local, LocalMatrix, Term, Weights};
use nalgebra::{Matrix3, Matrix4, Vector3};

use crate::constraints::{BilinearRow, ConstraintGroup, GroupedConstraint};
use crate::kinematics::relative_rotation;

/// Inertia, weight and rigidity constraints of a rigid body or a point mass: M a − m g + Φ_qᵀ λ with constant M.
#[derive(Debug)]
pub(crate) struct RigidTerm {
    coordinates: Vec<usize>,
    /// Mass matrix over the vectors r, d₁, d₂, d₃, each times I₃.
    mass: Matrix4<f64>,
    weight: Vector3<f64>,
    /// Rigidity constraints, or `None` for a point mass.
    rigidity: Option<ConstraintGroup>,
}

impl RigidTerm {
    /// Creates the term of a point mass with the three coordinates from `first`.
    pub(super) fn point(first: usize, mass: f64, weight: Vector3<f64>) -> Self {
        let (mut matrix, coordinates) = (Matrix4::zeros(), (first..first + 3).collect());
        matrix[(0, 0)] = mass;
        Self { coordinates, mass: matrix, weight, rigidity: None }
    }

    /// Creates the term of a body with the twelve coordinates from `first`, a mass and an Euler tensor.
    pub(super) fn new(
        first: usize,
        (mass, euler): (f64, &Matrix3<f64>),
        weight: Vector3<f64>,
        rigidity: Vec<GroupedConstraint>,
    ) -> Self {
        let (mut matrix, coordinates) = (Matrix4::zeros(), (first..first + 12).collect::<Vec<_>>());
        matrix[(0, 0)] = mass;
        matrix.fixed_view_mut::<3, 3>(1, 1).copy_from(euler);
        let rigidity = Some(ConstraintGroup::over(coordinates.clone(), rigidity));
        Self { coordinates, mass: matrix, weight, rigidity }
    }

    /// Returns the number of vectors: the position and the directors.
    pub(crate) fn vectors(&self) -> usize {
        self.coordinates.len() / 3
    }

    /// Returns the entry of the mass matrix of two vectors.
    pub(crate) fn mass(&self, a: usize, b: usize) -> f64 {
        self.mass[(a, b)]
    }

    /// Returns the weight m g.
    pub(crate) fn weight(&self) -> Vector3<f64> {
        self.weight
    }

    /// Returns the rows of the rigidity constraints.
    pub(crate) fn rows(&self) -> Vec<BilinearRow> {
        self.rigidity.as_ref().map_or_else(Vec::new, ConstraintGroup::rows)
    }

    /// Calls `visit` with (i, j, M_ij) over the coordinates.
    fn visit(&self, mut visit: impl FnMut(usize, usize, f64)) {
        for a in 0..self.vectors() {
            for b in (0..self.vectors()).filter(|&b| self.mass[(a, b)] != 0.0) {
                (0..3).for_each(|k| visit(3 * a + k, 3 * b + k, self.mass[(a, b)]));
            }
        }
    }
}

/// Returns the director i = 1, 2, 3 for the coordinates of a body.
fn director(q: &[f64], i: usize) -> Vector3<f64> {
    Vector3::ith(i - 1, 1.0) + Vector3::from_column_slice(&q[3 * i..3 * i + 3])
}

impl Term for RigidTerm {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn multipliers(&self) -> Range<usize> {
        self.rigidity.as_ref().map_or(0..0, Term::multipliers)
    }

    fn constraint_name(&self, k: usize) -> String {
        self.rigidity.as_ref().map_or_else(String::new, |rigidity| rigidity.constraint_name(k))
    }

    fn constraint_entries(&self) -> Vec<[usize; 2]> {
        self.rigidity.as_ref().map_or_else(Vec::new, Term::constraint_entries)
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        self.visit(|i, j, mass| r[i] += mass * at.a[j]);
        (0..3).for_each(|k| r[k] -= at.load * self.weight[k]);
        self.rigidity.iter().for_each(|rigidity| rigidity.residual(at, r));
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        self.visit(|i, j, mass| floor[i] += f64::EPSILON * (mass * at.a[j]).abs());
        (0..3).for_each(|k| floor[k] += f64::EPSILON * (at.load * self.weight[k]).abs());
        self.rigidity.iter().for_each(|rigidity| rigidity.rounding(at, floor));
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        self.visit(|i, j, mass| {
            if i >= j {
                k.add(i, j, w.a * mass);
            }
        });
        self.rigidity.iter().for_each(|rigidity| rigidity.tangent(at, w, k));
    }

    /// The rigidity constraints also hold for the mirror image of the body, to which the iteration of a large step may converge.
    fn inadmissibility(&self, at: &Local<'_>) -> Option<Inadmissibility> {
        let is_admissible =
            self.vectors() < 4 || director(at.q, 1).dot(&director(at.q, 2).cross(&director(at.q, 3))) > 0.0;
        (!is_admissible).then_some(Inadmissibility::InvertedBody)
    }

    fn rotation(&self, from: &Local<'_>, to: &Local<'_>) -> f64 {
        relative_rotation((1..self.vectors()).map(|i| [from, to].map(|at| director(at.q, i))))
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let mut kinetic = 0.0;
        self.visit(|i, j, mass| kinetic += 0.5 * at.v[i] * mass * at.v[j]);
        let moved = Vector3::new(at.q[0], at.q[1], at.q[2]);
        Energy { kinetic, strain: 0.0, potential: -at.load * self.weight.dot(&moved) }
    }

    // The only velocity-dependent forces are those of inertia.
    fn is_damped(&self) -> bool {
        false
    }
}
