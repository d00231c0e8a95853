use std::sync::Arc;

use nalgebra::{Matrix3, Vector3};

use super::{BeamShape, Directors, Lame, Moments, SectionLaw, gauss};
use crate::system::{Energy, Local, LocalMatrix, Term, Weights};

/// Vectors of an element that shape the axis (r₁, ℓ r_x₁, r₂, ℓ r_x₂).
const AXIS: [usize; 4] = [0, 1, 4, 5];
/// Vectors of an element that shape its section along y (ℓ r_y₁, ℓ r_y₂), then along z.
const SECTION: [[usize; 2]; 2] = [[2, 6], [3, 7]];

/// Weights of the element's vectors in the directors of one Gauss point of the axis.
#[derive(Clone, Copy, Debug)]
struct Station {
    /// Gauss weight times the element's length.
    weight: f64,
    /// In a = r_x, over [`AXIS`].
    axis: [f64; 4],
    /// In d = r_y and e = r_z, over [`SECTION`].
    section: [f64; 2],
    /// In b = ∂r_y/∂x and c = ∂r_z/∂x, over [`SECTION`].
    twist: [f64; 2],
}

/// What all elements of a straight prismatic beam share: shape, elasticity, inertia and body force.
#[derive(Clone, Debug)]
pub struct Profile {
    shape: BeamShape,
    stations: [Station; 5],
    law: SectionLaw,
    /// M_ab = ∫ ρ S_a S_b dV; the mass matrix is M ⊗ I₃.
    mass: [[f64; 8]; 8],
    /// ∫ ρ S_a dV.
    first: [f64; 8],
    gravity: Vector3<f64>,
}

impl Profile {
    /// Elements of the given shape, material (Lamé's constants and density), section and acceleration of gravity.
    pub fn new(shape: BeamShape, lame: Lame, density: f64, moments: Moments, gravity: Vector3<f64>) -> Self {
        let (mut mass, mut first) = ([[0.0; 8]; 8], [0.0; 8]);
        let twist = shape.section_gradient();
        let stations = gauss().map(|(xi, w)| {
            let (weight, values, section) = (w * shape.length, shape.axis(xi), shape.section(xi));
            for (i, &a) in AXIS.iter().enumerate() {
                first[a] += weight * density * moments.area * values[i];
                for (j, &b) in AXIS.iter().enumerate() {
                    mass[a][b] += weight * density * moments.area * values[i] * values[j];
                }
            }
            for (vectors, second) in SECTION.iter().zip([moments.yy, moments.zz]) {
                for (i, &a) in vectors.iter().enumerate() {
                    for (j, &b) in vectors.iter().enumerate() {
                        mass[a][b] += weight * density * second * section[i] * section[j];
                    }
                }
            }
            Station { weight, axis: shape.axis_gradient(xi), section, twist }
        });
        Self { shape, stations, law: SectionLaw::new(lame, moments), mass, first, gravity }
    }

    /// The shape functions.
    pub fn shape(&self) -> BeamShape {
        self.shape
    }

    /// The compact consistent mass matrix M_ab = ∫ ρ S_a S_b dV of one element.
    pub fn mass(&self) -> &[[f64; 8]; 8] {
        &self.mass
    }

    /// ∫ ρ S_a dV: the force of gravity on vector a is this times g.
    pub fn first_moments(&self) -> &[f64; 8] {
        &self.first
    }
}

/// The two-node, 24-coordinate, fully parameterised ANCF beam element; straight in its reference configuration.
///
/// Its strain energy is that of three-dimensional St. Venant-Kirchhoff elasticity, integrated exactly: over the section
/// by moments of area ([`SectionLaw`]), along the axis by five Gauss points. Coordinates are the eight vectors
/// (r, ℓ r_x, ℓ r_y, ℓ r_z) of node 1, then of node 2, less their reference values.
///
/// With ν > 0 the element locks in bending, (λ+2G) I instead of E I; torsion has the polar moment of area.
///
/// Source: Yakoub & Shabana (2001); Garcia-Vallejo et al. (2007); Kim et al. (2017), section 2.
#[derive(Clone, Debug)]
pub struct Beam24 {
    coordinates: [usize; 24],
    reference: Directors,
    profile: Arc<Profile>,
}

impl Beam24 {
    /// An element on the given coordinates, with the orthonormal `frame` (directions of x, y, z) as its reference.
    pub fn new(coordinates: [usize; 24], frame: [Vector3<f64>; 3], profile: Arc<Profile>) -> Self {
        let zero = Vector3::zeros();
        Self { coordinates, reference: [frame[0], zero, zero, frame[1], frame[2]], profile }
    }

    /// Sum over the element of M_ab x_b.
    fn mass_times(&self, x: &[Vector3<f64>; 8]) -> [Vector3<f64>; 8] {
        let mut product = [Vector3::zeros(); 8];
        for vectors in [AXIS.as_slice(), &SECTION[0], &SECTION[1]] {
            for &a in vectors {
                product[a] = vectors.iter().map(|&b| x[b] * self.profile.mass[a][b]).sum();
            }
        }
        product
    }
}

fn vectors(x: &[f64]) -> [Vector3<f64>; 8] {
    std::array::from_fn(|i| Vector3::new(x[3 * i], x[3 * i + 1], x[3 * i + 2]))
}

impl Station {
    /// Increments of the directors for increments q of the element's vectors; r enters by its difference only.
    fn directors(&self, q: &[Vector3<f64>; 8]) -> Directors {
        let pair = |w: [f64; 2], v: [usize; 2]| q[v[0]] * w[0] + q[v[1]] * w[1];
        [
            (q[4] - q[0]) * self.axis[2] + q[1] * self.axis[1] + q[5] * self.axis[3],
            (q[6] - q[2]) * self.twist[1],
            (q[7] - q[3]) * self.twist[1],
            pair(self.section, SECTION[0]),
            pair(self.section, SECTION[1]),
        ]
    }

    /// Bounds of the rounding errors of [`directors`](Self::directors).
    fn rounding(&self, q: &[Vector3<f64>; 8]) -> [f64; 5] {
        let size: [f64; 8] = std::array::from_fn(|i| f64::EPSILON * q[i].norm());
        let pair = |w: [f64; 2], v: [usize; 2]| w[0].abs() * size[v[0]] + w[1].abs() * size[v[1]];
        [
            (0..4).map(|i| self.axis[i].abs() * size[AXIS[i]]).sum(),
            pair(self.twist, SECTION[0]),
            pair(self.twist, SECTION[1]),
            pair(self.section, SECTION[0]),
            pair(self.section, SECTION[1]),
        ]
    }

    /// For each vector of the element the directors that it enters and its weights there.
    fn weights(&self) -> [([usize; 2], [f64; 2]); 8] {
        let axis = |i: usize| ([0, 0], [self.axis[i], 0.0]);
        let section = |side: usize, i: usize| ([1 + side, 3 + side], [self.twist[i], self.section[i]]);
        [axis(0), axis(1), section(0, 0), section(1, 0), axis(2), axis(3), section(0, 1), section(1, 1)]
    }
}

impl Term for Beam24 {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        let q = vectors(at.q);
        let mut force = self.mass_times(&vectors(at.a));
        for (a, force) in force.iter_mut().enumerate() {
            *force -= self.profile.gravity * (at.load * self.profile.first[a]);
        }
        for station in &self.profile.stations {
            let p =
                self.profile.law.forces(&self.reference, &station.directors(&q)).map(|p| p * station.weight);
            for (i, &a) in AXIS.iter().enumerate() {
                force[a] += p[0] * station.axis[i];
            }
            for (side, vectors) in SECTION.iter().enumerate() {
                for (i, &a) in vectors.iter().enumerate() {
                    force[a] += p[1 + side] * station.twist[i] + p[3 + side] * station.section[i];
                }
            }
        }
        for (row, force) in r.iter_mut().zip(force.iter().flatten()) {
            *row += force;
        }
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let (q, acceleration) = (vectors(at.q), vectors(at.a).map(|a| a.norm()));
        let mut bound: [f64; 8] = std::array::from_fn(|a| {
            let inertia: f64 = (0..8).map(|b| self.profile.mass[a][b].abs() * acceleration[b]).sum();
            f64::EPSILON * (inertia + (at.load * self.profile.first[a]).abs() * self.profile.gravity.norm())
        });
        for station in &self.profile.stations {
            let (u, du) = (station.directors(&q), station.rounding(&q));
            let p = self.profile.law.rounding(&self.reference, &u, &du);
            for (bound, (directors, weights)) in bound.iter_mut().zip(station.weights()) {
                let sum = p[directors[0]] * weights[0].abs() + p[directors[1]] * weights[1].abs();
                *bound += station.weight * sum;
            }
        }
        for (row, floor) in floor.iter_mut().enumerate() {
            *floor += bound[row / 3];
        }
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let q = vectors(at.q);
        let mut blocks = [[Matrix3::zeros(); 8]; 8];
        for station in &self.profile.stations {
            let h = self.profile.law.stiffness(&self.reference, &station.directors(&q));
            station.add_stiffness(&h, w.q * station.weight, &mut blocks);
        }
        for a in 0..8 {
            for b in 0..=a {
                let inertia = w.a * self.profile.mass[a][b];
                for i in 0..3 {
                    let columns = if a == b { 0..=i } else { 0..=2 };
                    for j in columns {
                        let inertia = if i == j { inertia } else { 0.0 };
                        k.add(3 * a + i, 3 * b + j, blocks[a][b][(i, j)] + inertia);
                    }
                }
            }
        }
    }

    /// det J > 0 on the axis. St. Venant-Kirchhoff energy has equilibria of elements that are turned inside out.
    fn is_admissible(&self, at: &Local<'_>) -> bool {
        let q = vectors(at.q);
        self.profile.stations.iter().all(|station| {
            let u = station.directors(&q);
            let [x, _, _, y, z] = std::array::from_fn(|i| self.reference[i] + u[i]);
            x.dot(&y.cross(&z)) > 0.0
        })
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let (q, v) = (vectors(at.q), vectors(at.v));
        let (law, reference) = (&self.profile.law, &self.reference);
        let momentum = self.mass_times(&v);
        let moved: Vector3<f64> = q.iter().zip(&self.profile.first).map(|(q, m)| q * *m).sum();
        Energy {
            kinetic: 0.5 * momentum.iter().zip(&v).map(|(p, v)| p.dot(v)).sum::<f64>(),
            strain: self
                .profile
                .stations
                .iter()
                .map(|s| s.weight * law.energy(reference, &s.directors(&q)))
                .sum(),
            potential: -at.load * self.profile.gravity.dot(&moved),
        }
    }
}

impl Station {
    /// Adds Bᵀ H B times `factor` to the lower blocks of the element's stiffness.
    fn add_stiffness(&self, h: &[[Matrix3<f64>; 5]; 5], factor: f64, k: &mut [[Matrix3<f64>; 8]; 8]) {
        let of = |i: usize, j: usize| if i >= j { h[i][j] } else { h[j][i].transpose() };
        for (i, &a) in AXIS.iter().enumerate() {
            for (j, &b) in AXIS.iter().enumerate().take(i + 1) {
                k[a][b] += h[0][0] * (factor * self.axis[i] * self.axis[j]);
            }
        }
        for side in 0..2 {
            // Rows of the section's vectors against the axis, with Σ over the two directors that they enter.
            for i in 0..2 {
                let a = SECTION[side][i];
                let row =
                    of(1 + side, 0) * (factor * self.twist[i]) + of(3 + side, 0) * (factor * self.section[i]);
                for (j, &b) in AXIS.iter().enumerate() {
                    if a > b {
                        k[a][b] += row * self.axis[j];
                    } else {
                        k[b][a] += row.transpose() * self.axis[j];
                    }
                }
            }
            for other in 0..=side {
                self.add_section_stiffness([side, other], &of, factor, k);
            }
        }
    }

    /// Rows of one section side against those of another (or of itself).
    fn add_section_stiffness(
        &self,
        [side, other]: [usize; 2],
        of: &impl Fn(usize, usize) -> Matrix3<f64>,
        factor: f64,
        k: &mut [[Matrix3<f64>; 8]; 8],
    ) {
        let h = [
            [of(1 + side, 1 + other), of(1 + side, 3 + other)],
            [of(3 + side, 1 + other), of(3 + side, 3 + other)],
        ];
        for i in 0..2 {
            let (twist, section) = (factor * self.twist[i], factor * self.section[i]);
            let rows = [h[0][0] * twist + h[1][0] * section, h[0][1] * twist + h[1][1] * section];
            for j in 0..2 {
                let (a, b) = (SECTION[side][i], SECTION[other][j]);
                let block = rows[0] * self.twist[j] + rows[1] * self.section[j];
                if a >= b {
                    k[a][b] += block;
                } else if side != other {
                    k[b][a] += block.transpose();
                }
            }
        }
    }
}
