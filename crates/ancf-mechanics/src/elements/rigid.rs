use ancf_solver::equations::{State, Term};
use nalgebra::{Matrix3, SymmetricEigen, Vector3};

use super::rigid_term::RigidTerm;
use crate::constraints::ConstantAngle;
use crate::kinematics::{Attachment, BodyVector, Directions, Marker, NodalVector, VectorKind};

/// Rigid body in natural coordinates: centre of mass r and three directors d₁, d₂, d₃, initially the global axes.
///
/// The point X relative to the centre has the position x = r + Σᵢ Xᵢ dᵢ. This map is linear, as in the elements, so
/// rigid and flexible bodies have the same joint equations. No orientation is singular. Six equations dᵢ·dⱼ = δᵢⱼ
/// constrain the body to be rigid. The mass matrix is constant. A point mass consists of r alone.
///
/// Source: de Jalón (2007), natural coordinates; Shabana (2014), the ANCF reference node.
#[derive(Clone, Debug)]
pub struct RigidBody {
    first: usize,
    multiplier: usize,
    centre: Vector3<f64>,
    mass: f64,
    /// Euler tensor E = ½ tr(J) I − J, or `None` for a point mass.
    euler: Option<Matrix3<f64>>,
    gravity: Vector3<f64>,
}

/// Smallest relative principal value of E. It keeps all pivots nonzero and is below the accuracy of the data.
const MIN_INERTIA_RATIO: f64 = 1e-8;

impl RigidBody {
    /// Creates a point mass on the three coordinates from `first`.
    pub fn point(first: usize, centre: Vector3<f64>, mass: f64, gravity: Vector3<f64>) -> Self {
        Self { first, multiplier: 0, centre, mass, euler: None, gravity }
    }

    /// Creates a body with the moments of inertia J about its centre, along the global axes.
    ///
    /// The body has the twelve coordinates from `first` and the six multipliers from `multiplier`. A plane body has a
    /// singular E, whose zero principal value is replaced by 10⁻⁸ of the largest one.
    pub fn new(
        [first, multiplier]: [usize; 2],
        centre: Vector3<f64>,
        mass: f64,
        inertia: Matrix3<f64>,
        gravity: Vector3<f64>,
    ) -> Self {
        let SymmetricEigen { eigenvectors, eigenvalues } = SymmetricEigen::new(euler_tensor(&inertia));
        let least = MIN_INERTIA_RATIO * eigenvalues.amax();
        let values = Matrix3::from_diagonal(&eigenvalues.map(|value| value.max(least)));
        let euler = Some(eigenvectors * values * eigenvectors.transpose());
        Self { first, multiplier, centre, mass, euler, gravity }
    }

    /// Returns the number of coordinates.
    pub const fn coordinates(&self) -> usize {
        if self.euler.is_some() { 12 } else { 3 }
    }

    /// Returns the number of multipliers of the rigidity constraints.
    pub const fn multipliers(&self) -> usize {
        if self.euler.is_some() { 6 } else { 0 }
    }

    /// Returns true if the body has directors.
    pub const fn has_directors(&self) -> bool {
        self.euler.is_some()
    }

    /// Returns the centre of mass in the reference state.
    pub const fn centre(&self) -> Vector3<f64> {
        self.centre
    }

    /// Returns the attachment of joints, loads and probes at a point of the reference state. For a point mass it is the
    /// centre.
    pub fn attachment(&self, point: Vector3<f64>) -> Attachment {
        let centre = BodyVector::from(self.centre_marker());
        if !self.has_directors() {
            return Attachment { point: centre, directions: Directions::None };
        }
        let directions = Directions::Rigid(self.directors());
        Attachment { point: centre, directions }.offset(point - self.centre)
    }

    fn centre_marker(&self) -> Marker {
        Marker::new([(self.first, 1.0)], self.centre)
    }

    /// Returns the mass times the position of the centre.
    pub(crate) fn mass_marker(&self) -> Marker {
        Marker::new([(self.first, self.mass)], self.centre * self.mass)
    }

    /// Returns the entry M_ab of the compact mass matrix over (r, d₁, d₂, d₃): the mass, and E for the directors.
    pub(crate) fn mass_entry(&self, a: usize, b: usize) -> f64 {
        match (a, b) {
            (0, 0) => self.mass,
            (0, _) | (_, 0) => 0.0,
            (a, b) => self.euler.map_or(0.0, |euler| euler[(a - 1, b - 1)]),
        }
    }

    fn directors(&self) -> [Marker; 3] {
        let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
        std::array::from_fn(|i| Marker::new([(self.first + 3 * (i + 1), 1.0)], axes[i]))
    }

    /// Returns inertia, weight and rigidity constraints as a term.
    pub fn term(&self) -> Box<dyn Term> {
        let (first, mass, weight) = (self.first, self.mass, self.gravity * self.mass);
        let Some(euler) = &self.euler else { return Box::new(RigidTerm::point(first, mass, weight)) };
        let d = self.directors();
        let pairs = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0)].into_iter().zip(self.multiplier..);
        let rows =
            pairs.filter_map(|((i, j), multiplier)| ConstantAngle::new(&d[i], &d[j], multiplier).grouped());
        Box::new(RigidTerm::new(first, (mass, euler), weight, rows.collect()))
    }

    /// Returns all nodal vectors of the body in a state.
    pub fn vectors<'a>(&'a self, s: &'a State) -> impl Iterator<Item = NodalVector> + 'a {
        let points = std::iter::once((VectorKind::Position, self.centre_marker()));
        let kinds = [VectorKind::Slope, VectorKind::Y, VectorKind::Z].into_iter().zip(self.directors());
        let directors = kinds.filter(|_| self.has_directors());
        points.chain(directors).enumerate().map(move |(k, (kind, marker))| NodalVector {
            first: self.first + 3 * k,
            kind,
            value: marker.value(s),
        })
    }

    /// Returns the kind of vector to which a coordinate belongs, if it is a coordinate of this body.
    pub fn locate_coordinate(&self, coordinate: usize) -> Option<VectorKind> {
        let place = coordinate.checked_sub(self.first).filter(|place| *place < self.coordinates())?;
        Some([VectorKind::Position, VectorKind::Slope, VectorKind::Y, VectorKind::Z][place / 3])
    }
}

/// Computes the Euler tensor E = ∫ρ X Xᵀ dV from the moments of inertia J.
fn euler_tensor(inertia: &Matrix3<f64>) -> Matrix3<f64> {
    Matrix3::identity() * (0.5 * inertia.trace()) - inertia
}

/// Returns true if the moments of inertia are physical: E has no negative principal value.
pub fn is_physical_inertia(inertia: &Matrix3<f64>) -> bool {
    let values = SymmetricEigen::new(euler_tensor(inertia)).eigenvalues;
    values.max() > 0.0 && values.min() >= -MIN_INERTIA_RATIO * values.max()
}
