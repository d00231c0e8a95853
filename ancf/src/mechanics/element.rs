use std::marker::PhantomData;
use std::sync::Arc;

use nalgebra::{Matrix3, Vector3};

use super::station::{Relative, Station, StrainEnergy};
use super::{BeamShape, Directors, Interpolation, QuadraticShape};
use crate::system::{Energy, Local, LocalMatrix, Term, Weights};

/// What congruent elements share: quadrature points with their elasticity, inertia and body force.
#[derive(Clone, Debug, PartialEq)]
pub struct Profile<const N: usize> {
    /// Length of the element.
    pub(super) length: f64,
    pub(super) stations: Vec<Station<N>>,
    /// M_ab = ∫ ρ S_a S_b dV; the mass matrix is M ⊗ I₃.
    pub(super) mass: [[f64; N]; N],
    /// ∫ ρ S_a dV.
    pub(super) first: [f64; N],
    pub(super) gravity: Vector3<f64>,
    /// Rate α of the mass-proportional damping α M v.
    pub(super) drag: f64,
}

impl<const N: usize> Profile<N> {
    /// The compact consistent mass matrix M_ab = ∫ ρ S_a S_b dV of one element.
    pub fn mass(&self) -> &[[f64; N]; N] {
        &self.mass
    }

    /// ∫ ρ S_a dV: the force of gravity on vector a is this times g.
    pub fn first_moments(&self) -> &[f64; N] {
        &self.first
    }
}

/// A beam element of N vectors r, ℓ r_x, ℓ r_y, ℓ r_z at its nodes, by the rule of an interpolation.
///
/// Coordinates are the components of the vectors less their reference values. Its energy is that of its stations'
/// laws; which strains are stiff in which way, the [`Profile`] says.
#[derive(Clone, Debug)]
pub struct Element<const N: usize, S> {
    coordinates: Vec<usize>,
    frame: Matrix3<f64>,
    profile: Arc<Profile<N>>,
    interpolation: PhantomData<S>,
}

/// The two-node, 24-coordinate, fully parameterised beam element.
///
/// Source: Yakoub & Shabana (2001); Garcia-Vallejo et al. (2007); Kim et al. (2017), section 2.
pub type Beam24 = Element<8, BeamShape>;

/// The three-node, 27-coordinate beam element without axial slopes.
///
/// Source: Nachbagauer, Gruber & Gerstmayr (2013).
pub type Beam27 = Element<9, QuadraticShape>;

impl<const N: usize, S: Interpolation<N>> Element<N, S> {
    /// An element on 3N coordinates, with the orthonormal `frame` (directions of x, y, z) in which its profile is stated.
    pub fn new(
        coordinates: impl IntoIterator<Item = usize>,
        frame: [Vector3<f64>; 3],
        profile: Arc<Profile<N>>,
    ) -> Self {
        let coordinates: Vec<usize> = coordinates.into_iter().collect();
        debug_assert_eq!(coordinates.len(), 3 * N, "three coordinates for each vector");
        Self { coordinates, frame: Matrix3::from_columns(&frame), profile, interpolation: PhantomData }
    }

    /// What it shares with congruent elements.
    pub fn profile(&self) -> &Profile<N> {
        &self.profile
    }

    /// Sum over the element of M_ab x_b.
    fn mass_times(&self, x: &[Vector3<f64>; N]) -> [Vector3<f64>; N] {
        std::array::from_fn(|a| {
            (0..N).filter(|&b| self.profile.mass[a][b] != 0.0).map(|b| x[b] * self.profile.mass[a][b]).sum()
        })
    }

    /// Strain energy by part, from the element's own coordinates.
    pub fn parts(&self, q: &[f64]) -> StrainEnergy {
        let q = Relative::new::<S>(&vectors(q));
        let mut sum = StrainEnergy::default();
        for (station, g0, u) in self.states(&q) {
            sum += station.parts(&g0, &u, self.profile.length) * station.weight;
        }
        sum
    }

    /// The stations with their reference directors and the increments of these.
    pub(super) fn states<'a>(
        &'a self,
        q: &'a Relative<N>,
    ) -> impl Iterator<Item = (&'a Station<N>, Directors, Directors)> + 'a {
        let of =
            |station: &'a Station<N>| (station, station.reference(&self.frame), station.directors::<S>(q));
        self.profile.stations.iter().map(of)
    }
}

/// The vectors of a slice of coordinates.
pub(super) fn vectors<const N: usize>(x: &[f64]) -> [Vector3<f64>; N] {
    std::array::from_fn(|i| Vector3::new(x[3 * i], x[3 * i + 1], x[3 * i + 2]))
}

/// Adds lower blocks, one for each pair of vectors.
pub(super) fn add_blocks<const N: usize>(blocks: &[[Matrix3<f64>; N]; N], k: &mut LocalMatrix<'_>) {
    for (a, row) in blocks.iter().enumerate() {
        for (b, block) in row[..=a].iter().enumerate() {
            for i in 0..3 {
                for j in 0..if a == b { i + 1 } else { 3 } {
                    k.add(3 * a + i, 3 * b + j, block[(i, j)]);
                }
            }
        }
    }
}

impl<const N: usize, S: Interpolation<N> + Send + Sync> Term for Element<N, S> {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        let (v, profile) = (vectors::<N>(at.v), &self.profile);
        let mut force = self.mass_times(&vectors(at.a));
        if profile.drag != 0.0 {
            let drag = self.mass_times(&v);
            force.iter_mut().zip(drag).for_each(|(force, drag)| *force += drag * profile.drag);
        }
        for (force, first) in force.iter_mut().zip(&profile.first) {
            *force -= profile.gravity * (at.load * first);
        }
        let (q, v) = (Relative::new::<S>(&vectors(at.q)), Relative::new::<S>(&v));
        for (station, g0, u) in self.states(&q) {
            let p = station.forces(&g0, &u, &station.directors::<S>(&v));
            station.spread::<S>(&p, &mut force);
        }
        for (row, force) in r.iter_mut().zip(force.iter().flatten()) {
            *row += force;
        }
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let profile = &self.profile;
        let (vectors_q, v) = (vectors::<N>(at.q), vectors::<N>(at.v));
        let moved = vectors::<N>(at.a).map(|a| a.norm());
        let mut bound: [f64; N] = std::array::from_fn(|a| {
            let of = |b: usize| profile.mass[a][b].abs() * (moved[b] + profile.drag * v[b].norm());
            let weight = (at.load * profile.first[a]).abs() * profile.gravity.norm();
            f64::EPSILON * ((0..N).map(of).sum::<f64>() + weight)
        });
        let (q, v) = (Relative::new::<S>(&vectors_q), Relative::new::<S>(&v));
        for (station, g0, u) in self.states(&q) {
            let p = station.rounding::<S>(&g0, &u, &station.directors::<S>(&v), &vectors_q);
            for (i, bound) in bound.iter_mut().enumerate() {
                let [first, second] = S::KINDS[i].directors();
                let [x, y] = station.weights[i];
                *bound += station.weight * (p[first] * x.abs() + p[second] * y.abs());
            }
        }
        for (row, floor) in floor.iter_mut().enumerate() {
            *floor += bound[row / 3];
        }
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let mut blocks = [[Matrix3::zeros(); N]; N];
        if w.q != 0.0 || w.v != 0.0 {
            let (q, v) = (Relative::new::<S>(&vectors(at.q)), Relative::new::<S>(&vectors(at.v)));
            for (station, g0, u) in self.states(&q) {
                let h = station.stiffness(&g0, &u, &station.directors::<S>(&v), [w.q, w.v]);
                station.spread_stiffness::<S>(&h, &mut blocks);
            }
        }
        let inertia = w.a + self.profile.drag * w.v;
        for (a, row) in blocks.iter_mut().enumerate() {
            for (block, mass) in row[..=a].iter_mut().zip(&self.profile.mass[a]) {
                *block += Matrix3::from_diagonal_element(inertia * mass);
            }
        }
        add_blocks(&blocks, k);
    }

    fn stress_stiffness(&self, at: &Local<'_>, by: &Local<'_>, k: &mut LocalMatrix<'_>) {
        let (q, dq) = (Relative::new::<S>(&vectors(at.q)), Relative::new::<S>(&vectors(by.q)));
        let mut blocks = [[Matrix3::zeros(); N]; N];
        for (station, g0, u) in self.states(&q) {
            let h = station.stress_stiffness(&g0, &u, &station.directors::<S>(&dq));
            station.spread_stiffness::<S>(&h, &mut blocks);
        }
        add_blocks(&blocks, k);
    }

    /// det J > 0 on the axis. St. Venant-Kirchhoff energy has equilibria of elements that are turned inside out.
    fn is_admissible(&self, at: &Local<'_>) -> bool {
        let q = Relative::new::<S>(&vectors(at.q));
        self.states(&q).all(|(station, g0, u)| station.is_admissible(&g0, &u))
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let (q, v) = (vectors::<N>(at.q), vectors::<N>(at.v));
        let momentum = self.mass_times(&v);
        let moved: Vector3<f64> = q.iter().zip(&self.profile.first).map(|(q, m)| q * *m).sum();
        let relative = Relative::new::<S>(&q);
        let strain = self.states(&relative).map(|(s, g0, u)| s.weight * s.energy(&g0, &u)).sum();
        Energy {
            kinetic: 0.5 * momentum.iter().zip(&v).map(|(p, v)| p.dot(v)).sum::<f64>(),
            strain,
            potential: -at.load * self.profile.gravity.dot(&moved),
        }
    }
}
