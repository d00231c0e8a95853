use std::marker::PhantomData;
use std::sync::Arc;

use ancf_solver::equations::{
    Energy, Inadmissibility, Local, LocalMatrix, LocalStep, ProductColumn, Term, Weights, velocity_forces,
};
use nalgebra::{Matrix3, Vector3};

use super::station::{BeamStation, RelativeVectors, StrainEnergy};
use super::station_products::StationBlocks;
use crate::kinematics::{BeamShape, Interpolation, QuadraticShape, relative_rotation};
use crate::sections::{DeformationFactors, NO_STIFFNESS};

/// Common data of congruent elements: quadrature points with their elasticity, inertia and body force.
#[derive(Clone, Debug, PartialEq)]
pub struct Profile<const N: usize> {
    pub(crate) stations: Vec<BeamStation<N>>,
    /// Compact mass matrix M_ab = ∫ ρ S_a S_b dV; the mass matrix is M ⊗ I₃.
    pub(crate) mass: [[f64; N]; N],
    /// First moments ∫ ρ S_a dV.
    pub(crate) first: [f64; N],
    pub(crate) gravity: Vector3<f64>,
    /// Rate α of the mass-proportional damping α M v.
    pub(crate) mass_damping: f64,
    /// Retardation times τ.
    pub(crate) retardation: DeformationFactors,
}

impl<const N: usize> Profile<N> {
    /// Returns the compact consistent mass matrix M_ab = ∫ ρ S_a S_b dV of one element.
    pub fn mass(&self) -> &[[f64; N]; N] {
        &self.mass
    }

    /// Returns the first moments ∫ ρ S_a dV. The force of gravity on vector a is this times g.
    pub fn first_moments(&self) -> &[f64; N] {
        &self.first
    }
}

/// ANCF beam element with N nodal vectors r, ℓ r_x, ℓ r_y, ℓ r_z according to an interpolation.
///
/// Coordinates are the components of the vectors minus their reference values. The strain energy is the sum over the
/// stations. The [`Profile`] defines the elastic law of each station.
#[derive(Clone, Debug)]
pub struct BeamElement<const N: usize, S> {
    /// Copies of the element share them.
    coordinates: Arc<[usize]>,
    pub(crate) frame: Matrix3<f64>,
    pub(crate) profile: Arc<Profile<N>>,
    interpolation: PhantomData<S>,
}

/// Two-node, 24-coordinate, fully parameterised beam element.
///
/// Source: Yakoub & Shabana (2001); Garcia-Vallejo et al. (2007); Kim et al. (2017), section 2.
pub type Beam24 = BeamElement<8, BeamShape>;

/// Three-node, 27-coordinate beam element without axial slopes.
///
/// Source: Nachbagauer, Gruber & Gerstmayr (2013).
pub type Beam27 = BeamElement<9, QuadraticShape>;

impl<const N: usize, S: Interpolation<N>> BeamElement<N, S> {
    /// Creates an element on 3N coordinates. The orthonormal `frame` contains the x, y and z directions of its profile.
    pub fn new(
        coordinates: impl IntoIterator<Item = usize>,
        frame: [Vector3<f64>; 3],
        profile: Arc<Profile<N>>,
    ) -> Self {
        let coordinates: Arc<[usize]> = coordinates.into_iter().collect();
        debug_assert_eq!(coordinates.len(), 3 * N, "three coordinates for each vector");
        Self { coordinates, frame: Matrix3::from_columns(&frame), profile, interpolation: PhantomData }
    }

    /// Returns the profile, which congruent elements share.
    pub fn profile(&self) -> &Profile<N> {
        &self.profile
    }

    /// Computes the sum of M_ab x_b over b.
    fn mass_times(&self, x: &[Vector3<f64>; N]) -> [Vector3<f64>; N] {
        std::array::from_fn(|a| {
            (0..N).filter(|&b| self.profile.mass[a][b] != 0.0).map(|b| x[b] * self.profile.mass[a][b]).sum()
        })
    }

    /// Computes the forces of inertia, of the mass-proportional damping and of gravity.
    fn inertia(&self, at: &Local<'_>) -> [Vector3<f64>; N] {
        let profile = &self.profile;
        let mut force = self.mass_times(&vectors(at.a));
        if profile.mass_damping != 0.0 {
            let momentum = self.mass_times(&vectors(at.v));
            force.iter_mut().zip(momentum).for_each(|(force, p)| *force += p * profile.mass_damping);
        }
        for (force, first) in force.iter_mut().zip(&profile.first) {
            *force -= profile.gravity * (at.load * first);
        }
        force
    }

    /// Adds the tangent of [`inertia`](Self::inertia) to the lower blocks.
    fn add_inertia(&self, w: Weights, blocks: &mut [[Matrix3<f64>; N]; N]) {
        let inertia = w.a + self.profile.mass_damping * w.v;
        for a in 0..N {
            for b in 0..=a {
                blocks[a][b] += Matrix3::from_diagonal_element(inertia * self.profile.mass[a][b]);
            }
        }
    }

    /// Returns the vectors at the start, in the middle and at the end of a step.
    fn directors_of_step(&self, step: &LocalStep<'_>) -> [RelativeVectors<N>; 3] {
        [step.from, step.middle, step.to].map(|at| RelativeVectors::new::<S>(&vectors(at.q)))
    }

    /// Returns the strain energy by part, from the coordinates of the element.
    pub fn parts(&self, q: &[f64]) -> StrainEnergy {
        let q = RelativeVectors::new::<S>(&vectors(q));
        let mut sum = StrainEnergy::default();
        for station in &self.profile.stations {
            let (g0, u) = (station.reference(&self.frame), station.directors::<S>(&q));
            sum += station.strain_energy(&g0, &u) * station.weight;
        }
        sum
    }

    /// Returns the velocities of the vectors if the element has viscosity.
    pub(super) fn moving(&self, at: &Local<'_>) -> Option<RelativeVectors<N>> {
        let viscous = self.profile.stations.iter().any(|station| station.viscosity.is_some());
        viscous.then(|| RelativeVectors::new::<S>(&vectors(at.v)))
    }
}

/// Returns the vectors of a slice of coordinates.
pub(crate) fn vectors<const N: usize>(x: &[f64]) -> [Vector3<f64>; N] {
    std::array::from_fn(|i| Vector3::new(x[3 * i], x[3 * i + 1], x[3 * i + 2]))
}

impl<const N: usize, S: Interpolation<N> + Send + Sync> Term for BeamElement<N, S> {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    /// Adds the stiffness of each station times the directors of the columns, without the large stiffness of the vectors.
    fn stiffness_products(&self, at: &Local<'_>, columns: &mut [ProductColumn]) {
        let (q, v) = (RelativeVectors::new::<S>(&vectors(at.q)), self.moving(at));
        let relative: Vec<_> = columns.iter().map(|column| vectors::<N>(&column.x)).collect();
        let mut h = NO_STIFFNESS;
        for station in &self.profile.stations {
            let g0 = station.reference(&self.frame);
            let u = station.directors::<S>(&q);
            station.stiffness::<S>(&g0, &u, v.as_ref(), [1.0, 0.0], &mut h);
            let blocks = StationBlocks::new(station, &h);
            for (column, x) in columns.iter_mut().zip(&relative) {
                blocks.add_product::<N, S>(station, x, column);
            }
        }
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        let (profile, mut force) = (&self.profile, self.inertia(at));
        let (q, v) = (RelativeVectors::new::<S>(&vectors(at.q)), self.moving(at));
        for station in &profile.stations {
            let g0 = station.reference(&self.frame);
            let u = station.directors::<S>(&q);
            let p = station.forces::<S>(&g0, &u, v.as_ref());
            station.distribute(&p, &mut force);
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
            let of = |b: usize| profile.mass[a][b].abs() * (moved[b] + profile.mass_damping * v[b].norm());
            let weight = (at.load * profile.first[a]).abs() * profile.gravity.norm();
            f64::EPSILON * ((0..N).map(of).sum::<f64>() + weight)
        });
        let (q, v, sizes) =
            (RelativeVectors::new::<S>(&vectors_q), self.moving(at), vectors_q.map(|q| q.norm()));
        for station in &profile.stations {
            let g0 = station.reference(&self.frame);
            let u = station.directors::<S>(&q);
            let p = station.rounding::<S>(&g0, &u, v.as_ref(), &sizes);
            for (i, bound) in bound.iter_mut().enumerate() {
                for &(director, weight) in station.parts[i].as_slice() {
                    *bound += station.weight * p[director] * weight.abs();
                }
            }
        }
        for (row, floor) in floor.iter_mut().enumerate() {
            *floor += bound[row / 3];
        }
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let mut blocks = [[Matrix3::zeros(); N]; N];
        if w.q != 0.0 || w.v != 0.0 {
            let (q, v) = (RelativeVectors::new::<S>(&vectors(at.q)), self.moving(at));
            let mut h = NO_STIFFNESS;
            for station in &self.profile.stations {
                let g0 = station.reference(&self.frame);
                let u = station.directors::<S>(&q);
                station.stiffness::<S>(&g0, &u, v.as_ref(), [w.q, w.v], &mut h);
                station.distribute_stiffness(&h, &mut blocks);
            }
        }
        self.add_inertia(w, &mut blocks);
        add_blocks(&blocks, k);
    }

    fn average_residual(&self, step: &LocalStep<'_>, r: &mut [f64]) {
        let (mut force, v) = (self.inertia(&step.middle), self.moving(&step.middle));
        let ends = self.directors_of_step(step);
        for station in &self.profile.stations {
            let g0 = station.reference(&self.frame);
            let u = ends.each_ref().map(|q| station.directors::<S>(q));
            let p = station.average_forces::<S>(&g0, u.each_ref(), step.shares(), v.as_ref());
            station.distribute(&p, &mut force);
        }
        for (row, force) in r.iter_mut().zip(force.iter().flatten()) {
            *row += force;
        }
    }

    fn average_tangent(&self, step: &LocalStep<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let (mut blocks, mut h) = ([[Matrix3::zeros(); N]; N], NO_STIFFNESS);
        let (ends, v) = (self.directors_of_step(step), self.moving(&step.middle));
        for station in &self.profile.stations {
            let g0 = station.reference(&self.frame);
            let u = ends.each_ref().map(|q| station.directors::<S>(q));
            station.average_stiffness::<S>(&g0, u.each_ref(), step.shares(), v.as_ref(), [w.q, w.v], &mut h);
            station.distribute_stiffness(&h, &mut blocks);
        }
        self.add_inertia(w, &mut blocks);
        add_blocks(&blocks, k);
    }

    fn has_stress_prediction(&self) -> bool {
        true
    }

    fn stress_prediction(&self, at: &Local<'_>, from: &Local<'_>, k: &mut LocalMatrix<'_>) {
        let (now, before) = (vectors::<N>(at.q), vectors::<N>(from.q));
        let dq = RelativeVectors::new::<S>(&std::array::from_fn(|i| now[i] - before[i]));
        let mut blocks = [[Matrix3::zeros(); N]; N];
        for station in &self.profile.stations {
            if let Some(h) = station.stress_prediction(&station.directors::<S>(&dq)) {
                station.distribute_stiffness(&h, &mut blocks);
            }
        }
        add_blocks(&blocks, k);
    }

    fn stress_stiffness(&self, at: &Local<'_>, by: &Local<'_>, k: &mut LocalMatrix<'_>) {
        let (q, dq) = (RelativeVectors::new::<S>(&vectors(at.q)), RelativeVectors::new::<S>(&vectors(by.q)));
        let mut blocks = [[Matrix3::zeros(); N]; N];
        for station in &self.profile.stations {
            let (g0, u) = (station.reference(&self.frame), station.directors::<S>(&q));
            let h = station.stress_stiffness(&g0, &u, &station.directors::<S>(&dq));
            station.distribute_stiffness(&h, &mut blocks);
        }
        add_blocks(&blocks, k);
    }

    /// Requires det J > 0 on the axis. St. Venant-Kirchhoff energy also has equilibria with inverted elements.
    fn inadmissibility(&self, at: &Local<'_>) -> Option<Inadmissibility> {
        let q = RelativeVectors::new::<S>(&vectors(at.q));
        let is_admissible = self
            .profile
            .stations
            .iter()
            .all(|s| s.is_admissible(&s.reference(&self.frame), &s.directors::<S>(&q)));
        (!is_admissible).then_some(Inadmissibility::InvertedElement)
    }

    fn rotation(&self, from: &Local<'_>, to: &Local<'_>) -> f64 {
        let [from, to] = [from, to].map(|at| RelativeVectors::new::<S>(&vectors(at.q)));
        let of = |station: &BeamStation<N>| {
            let g0 = station.reference(&self.frame);
            let [before, after] = [&from, &to].map(|q| station.directors::<S>(q));
            // Directors r_x, r_y and r_z.
            relative_rotation([0, 3, 4].map(|i| [g0[i] + before[i], g0[i] + after[i]]))
        };
        self.profile.stations.iter().map(of).fold(0.0, f64::max)
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let (q, v) = (vectors::<N>(at.q), vectors::<N>(at.v));
        let momentum = self.mass_times(&v);
        let moved: Vector3<f64> = q.iter().zip(&self.profile.first).map(|(q, m)| q * *m).sum();
        let relative = RelativeVectors::new::<S>(&q);
        let of =
            |s: &BeamStation<N>| s.weight * s.energy(&s.reference(&self.frame), &s.directors::<S>(&relative));
        let strain = self.profile.stations.iter().map(of).sum();
        Energy {
            kinetic: 0.5 * momentum.iter().zip(&v).map(|(p, v)| p.dot(v)).sum::<f64>(),
            strain,
            potential: -at.load * self.profile.gravity.dot(&moved),
        }
    }

    fn damping_forces(&self, at: &Local<'_>, r: &mut [f64]) {
        if self.profile.mass_damping != 0.0 || self.moving(at).is_some() {
            velocity_forces(self, at, r);
        }
    }
}

/// Adds the lower blocks to a matrix.
pub(crate) fn add_blocks<const N: usize>(blocks: &[[Matrix3<f64>; N]; N], k: &mut LocalMatrix<'_>) {
    for a in 0..N {
        for b in 0..=a {
            for i in 0..3 {
                let columns = if a == b { 0..=i } else { 0..=2 };
                for j in columns {
                    k.add(3 * a + i, 3 * b + j, blocks[a][b][(i, j)]);
                }
            }
        }
    }
}
