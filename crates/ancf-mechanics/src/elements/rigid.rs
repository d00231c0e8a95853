use ancf_solver::equations::{Energy, Local, LocalMatrix, Power, State, Term, Weights};
use nalgebra::{Matrix3, Matrix4, SymmetricEigen, Vector3};

use crate::constraints::Perpendicular;
use crate::kinematics::{Attachment, Directions, Kind, Marker, NodalVector};

/// A rigid body in natural coordinates: its centre of mass r and three directors d₁, d₂, d₃, at first the global axes.
///
/// x = r + Σᵢ Xᵢ dᵢ for the point X from the centre: linear, as in the elements, so that joints are the same equations for rigid
/// and flexible bodies and no orientation is singular. Six equations dᵢ·dⱼ = δᵢⱼ keep the body rigid; the mass matrix is
/// constant. A point mass is r alone.
///
/// Source: de Jalón (2007), natural coordinates; Shabana (2014), the ANCF reference node.
#[derive(Clone, Debug)]
pub struct RigidBody {
    first: usize,
    multiplier: usize,
    centre: Vector3<f64>,
    mass: f64,
    /// E = ½ tr(J) I − J; none of a point mass.
    euler: Option<Matrix3<f64>>,
    gravity: Vector3<f64>,
}

/// The least part of the largest principal value of E: so little breaks no pivot and changes nothing that is known of a body.
const FLAT: f64 = 1e-8;

impl RigidBody {
    /// A point mass on the three coordinates from `first` on.
    pub fn point(first: usize, centre: Vector3<f64>, mass: f64, gravity: Vector3<f64>) -> Self {
        Self { first, multiplier: 0, centre, mass, euler: None, gravity }
    }

    /// A body with the moments of inertia J about its centre, along the global axes, on the twelve coordinates from `first` on
    /// and the six multipliers from `multiplier` on.
    ///
    /// Of a plane body E is singular; a part of 10⁻⁸ of its largest principal value is put in that place.
    pub fn new(
        [first, multiplier]: [usize; 2],
        centre: Vector3<f64>,
        mass: f64,
        inertia: Matrix3<f64>,
        gravity: Vector3<f64>,
    ) -> Self {
        let SymmetricEigen { eigenvectors, eigenvalues } = SymmetricEigen::new(euler(&inertia));
        let least = FLAT * eigenvalues.amax();
        let values = Matrix3::from_diagonal(&eigenvalues.map(|value| value.max(least)));
        let euler = Some(eigenvectors * values * eigenvectors.transpose());
        Self { first, multiplier, centre, mass, euler, gravity }
    }

    /// Number of coordinates.
    pub const fn coordinates(&self) -> usize {
        if self.euler.is_some() { 12 } else { 3 }
    }

    /// Number of multipliers that keep it rigid.
    pub const fn multipliers(&self) -> usize {
        if self.euler.is_some() { 6 } else { 0 }
    }

    /// Whether it has directors.
    pub const fn has_directors(&self) -> bool {
        self.euler.is_some()
    }

    /// Centre of mass in the reference state.
    pub const fn centre(&self) -> Vector3<f64> {
        self.centre
    }

    /// What joints, loads and probes hold on to at a point of the reference state; of a point mass, its centre.
    pub fn attachment(&self, point: Vector3<f64>) -> Attachment {
        let centre = Marker::new([(self.first, 1.0)], self.centre);
        if !self.has_directors() {
            return Attachment { point: centre, directions: Directions::None };
        }
        let directions = Directions::Rigid(self.directors());
        Attachment { point: centre, directions }.offset(point - self.centre)
    }

    /// Its mass times the position of its centre.
    pub(crate) fn mass_marker(&self) -> Marker {
        Marker::new([(self.first, self.mass)], self.centre * self.mass)
    }

    fn directors(&self) -> [Marker; 3] {
        let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
        std::array::from_fn(|i| Marker::new([(self.first + 3 * (i + 1), 1.0)], axes[i]))
    }

    /// Inertia and weight, and what keeps it rigid, as terms.
    pub fn terms(&self) -> Vec<Box<dyn Term>> {
        let mut terms: Vec<Box<dyn Term>> = vec![Box::new(Inertia::new(self))];
        if self.has_directors() {
            let d = self.directors();
            let pairs = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0)];
            let rows = pairs.iter().enumerate();
            terms.extend(rows.map(|(k, &(i, j))| {
                Box::new(Perpendicular::new(&d[i], &d[j], self.multiplier + k)) as Box<dyn Term>
            }));
        }
        terms
    }

    /// All vectors that its coordinates are, in a state.
    pub fn vectors<'a>(&'a self, s: &'a State) -> impl Iterator<Item = NodalVector> + 'a {
        let centre = Attachment { point: self.attachment(self.centre).point, directions: Directions::None };
        let points = std::iter::once((Kind::Position, centre.point));
        let kinds = [Kind::Slope, Kind::Y, Kind::Z].into_iter().zip(self.directors());
        let directors = kinds.filter(|_| self.has_directors());
        points.chain(directors).enumerate().map(move |(k, (kind, marker))| NodalVector {
            first: self.first + 3 * k,
            kind,
            value: marker.value(s),
        })
    }

    /// The vector that a coordinate belongs to, if it is one of this body.
    pub fn place_of(&self, coordinate: usize) -> Option<Kind> {
        let place = coordinate.checked_sub(self.first).filter(|place| *place < self.coordinates())?;
        Some([Kind::Position, Kind::Slope, Kind::Y, Kind::Z][place / 3])
    }
}

/// E = ∫ρ X Xᵀ dV of moments of inertia J.
fn euler(inertia: &Matrix3<f64>) -> Matrix3<f64> {
    Matrix3::identity() * (0.5 * inertia.trace()) - inertia
}

/// Whether moments of inertia are those of some body: E has no negative principal value.
pub fn is_inertia(inertia: &Matrix3<f64>) -> bool {
    let values = SymmetricEigen::new(euler(inertia)).eigenvalues;
    values.max() > 0.0 && values.min() >= -FLAT * values.max()
}

/// Inertia and weight of a rigid body or a point mass: M a − m g, M constant.
#[derive(Clone, Debug)]
struct Inertia {
    coordinates: Vec<usize>,
    /// Over the vectors r, d₁, d₂, d₃, each times I₃.
    mass: Matrix4<f64>,
    weight: Vector3<f64>,
}

impl Inertia {
    fn new(body: &RigidBody) -> Self {
        let mut mass = Matrix4::zeros();
        mass[(0, 0)] = body.mass;
        if let Some(euler) = &body.euler {
            mass.fixed_view_mut::<3, 3>(1, 1).copy_from(euler);
        }
        let coordinates = (body.first..body.first + body.coordinates()).collect();
        Self { coordinates, mass, weight: body.gravity * body.mass }
    }

    /// Visits (i, j, M_ij) over the coordinates.
    fn visit(&self, mut visit: impl FnMut(usize, usize, f64)) {
        let vectors = self.coordinates.len() / 3;
        for a in 0..vectors {
            for b in (0..vectors).filter(|&b| self.mass[(a, b)] != 0.0) {
                (0..3).for_each(|k| visit(3 * a + k, 3 * b + k, self.mass[(a, b)]));
            }
        }
    }
}

impl Term for Inertia {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        self.visit(|i, j, mass| r[i] += mass * at.a[j]);
        (0..3).for_each(|k| r[k] -= at.load * self.weight[k]);
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        self.visit(|i, j, mass| floor[i] += f64::EPSILON * (mass * at.a[j]).abs());
        (0..3).for_each(|k| floor[k] += f64::EPSILON * (at.load * self.weight[k]).abs());
    }

    fn tangent(&self, _: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        self.visit(|i, j, mass| {
            if i >= j {
                k.add(i, j, w.a * mass);
            }
        });
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let mut kinetic = 0.0;
        self.visit(|i, j, mass| kinetic += 0.5 * at.v[i] * mass * at.v[j]);
        let moved = Vector3::new(at.q[0], at.q[1], at.q[2]);
        Energy { kinetic, strain: 0.0, potential: -at.load * self.weight.dot(&moved) }
    }

    fn power(&self, _: &Local<'_>) -> Power {
        Power::default()
    }
}
