use std::ops::{AddAssign, Mul};

use nalgebra::{Matrix3, Vector3};

use crate::kinematics::{Interpolation, VectorKind};
use crate::sections::{
    AA, AB, AC, AD, AE, AH, BB, BC, BD, BE, BK, CC, CD, CE, CK, DD, DE, DH, DIRECTORS, Directors, EE, EH, HH,
    KK, NO_STIFFNESS, NeoHookean, SectionLaw, Stiffness, Strains, add, sum,
};

/// Elastic law of a cross-section.
#[derive(Clone, Debug, PartialEq)]
pub enum StationLaw {
    /// Quadratic in the section strains.
    Quadratic(SectionLaw),
    /// Compressible neo-Hookean.
    Hyperelastic(NeoHookean),
}

impl StationLaw {
    fn is_admissible(&self, g0: &Directors, u: &Directors) -> bool {
        match self {
            Self::Quadratic(_) => true,
            Self::Hyperelastic(law) => law.is_admissible(g0, u),
        }
    }

    fn energy(&self, g0: &Directors, u: &Directors) -> f64 {
        match self {
            Self::Quadratic(law) => law.energy(g0, u),
            Self::Hyperelastic(law) => law.energy(g0, u),
        }
    }

    fn forces(&self, g0: &Directors, u: &Directors) -> Directors {
        match self {
            Self::Quadratic(law) => law.forces(g0, u),
            Self::Hyperelastic(law) => law.forces(g0, u),
        }
    }

    fn add_stiffness(&self, g0: &Directors, u: &Directors, factor: f64, h: &mut Stiffness) {
        match self {
            Self::Quadratic(law) => law.add_stiffness(g0, u, factor, h),
            Self::Hyperelastic(law) => law.add_stiffness(g0, u, factor, h),
        }
    }

    fn add_stress_stiffness(&self, g0: &Directors, u: &Directors, du: &Directors, h: &mut Stiffness) {
        match self {
            Self::Quadratic(law) => law.add_stress_stiffness(g0, u, du, h),
            Self::Hyperelastic(law) => law.add_stress_stiffness(g0, u, du, h),
        }
    }

    /// Returns the number of directors that the law depends on.
    pub(super) fn reach(&self) -> usize {
        match self {
            Self::Quadratic(law) => law.reach(),
            Self::Hyperelastic(_) => 5,
        }
    }

    fn rounding(&self, g0: &Directors, u: &Directors, du: &[f64; DIRECTORS]) -> [f64; DIRECTORS] {
        match self {
            Self::Quadratic(law) => law.rounding(g0, u, du),
            Self::Hyperelastic(law) => law.rounding(g0, u, du),
        }
    }
}

/// Quadrature point of the axis with its weight, reference directors and elastic law.
#[derive(Clone, Debug, PartialEq)]
pub struct BeamStation<const N: usize> {
    /// Place ξ in [0, 1].
    pub(crate) xi: f64,
    /// Gauss weight times the length of the element.
    pub(crate) weight: f64,
    /// Weights of the vectors of the element in the directors.
    pub(crate) parts: [DirectorWeights; N],
    /// Directors of the reference state in the frame of the element.
    pub(crate) reference: Directors,
    /// Elastic law.
    pub(crate) law: StationLaw,
    /// Viscous law: resultants of strain rates.
    pub(crate) viscosity: Option<SectionLaw>,
}

/// Strain energy by kind of strain. Coupling terms are divided equally.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StrainEnergy {
    /// Axial stretch.
    pub axial: f64,
    /// Bending about both axes.
    pub bending: f64,
    /// Mean shear of the sections.
    pub shear: f64,
    /// Torsion.
    pub torsion: f64,
    /// Deformation of the sections.
    pub section: f64,
    /// Total energy of a law without such parts.
    pub volume: f64,
}

impl StrainEnergy {
    /// Creates the energy of the parts from the energies of the section strains.
    pub(crate) fn of_shares(shares: &Strains) -> Self {
        let sum = |of: &[usize]| of.iter().map(|&k| shares[k]).sum::<f64>();
        Self {
            axial: sum(&[AA, AH, HH, KK]),
            bending: sum(&[AB, AC, BB, BC, CC, DH, EH, BK, CK]),
            shear: sum(&[AD, AE]),
            torsion: sum(&[BE, CD]),
            section: sum(&[BD, CE, DD, DE, EE]),
            volume: 0.0,
        }
    }

    /// Returns the sum of the parts.
    pub fn total(&self) -> f64 {
        self.axial + self.bending + self.shear + self.torsion + self.section + self.volume
    }
}

impl AddAssign for StrainEnergy {
    fn add_assign(&mut self, other: Self) {
        let Self { axial, bending, shear, torsion, section, volume } = other;
        self.axial += axial;
        self.bending += bending;
        self.shear += shear;
        self.torsion += torsion;
        self.section += section;
        self.volume += volume;
    }
}

impl Mul<f64> for StrainEnergy {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        let Self { axial, bending, shear, torsion, section, volume } = self;
        Self {
            axial: axial * factor,
            bending: bending * factor,
            shear: shear * factor,
            torsion: torsion * factor,
            section: section * factor,
            volume: volume * factor,
        }
    }
}

/// Directors that depend on a vector, each with its weight.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct DirectorWeights {
    count: usize,
    items: [(usize, f64); 3],
}

impl DirectorWeights {
    /// Selects the directors below `reach` with nonzero weights.
    pub(crate) fn new(directors: [usize; 3], weights: [f64; 3], reach: usize) -> Self {
        let mut parts = Self::default();
        for part in directors.into_iter().zip(weights).filter(|&(i, weight)| i < reach && weight != 0.0) {
            parts.items[parts.count] = part;
            parts.count += 1;
        }
        parts
    }

    /// Returns pairs of director and weight.
    pub(crate) fn as_slice(&self) -> &[(usize, f64)] {
        &self.items[..self.count]
    }
}

/// Vectors of an element relative to the first vector of each kind, and the first vectors of the kinds Y and Z.
///
/// Quantities that depend only on differences are then free of cancellation.
pub(crate) struct RelativeVectors<const N: usize> {
    difference: [Vector3<f64>; N],
    base: [Vector3<f64>; 2],
}

impl<const N: usize> RelativeVectors<N> {
    pub(crate) fn new<S: Interpolation<N>>(q: &[Vector3<f64>; N]) -> Self {
        let first =
            |kind: VectorKind| S::KINDS.iter().position(|&k| k == kind).map_or(Vector3::zeros(), |i| q[i]);
        let [r, y, z] = [VectorKind::Position, VectorKind::Y, VectorKind::Z].map(first);
        let difference = std::array::from_fn(|i| match S::KINDS[i] {
            VectorKind::Position => q[i] - r,
            VectorKind::Slope | VectorKind::Twist => q[i],
            VectorKind::Y => q[i] - y,
            VectorKind::Z => q[i] - z,
        });
        Self { difference, base: [y, z] }
    }

    /// Computes the directors from the vectors.
    pub(crate) fn directors<S: Interpolation<N>>(&self, parts: &[DirectorWeights; N]) -> Directors {
        let mut u = [Vector3::zeros(); DIRECTORS];
        let (mut d, mut e) = (0.0, 0.0);
        for i in 0..N {
            for &(director, weight) in parts[i].as_slice() {
                u[director] += self.difference[i] * weight;
                match (S::KINDS[i], director) {
                    (VectorKind::Y, 3) => d += weight,
                    (VectorKind::Z, 4) => e += weight,
                    _ => {}
                }
            }
        }
        u[3] += self.base[0] * d;
        u[4] += self.base[1] * e;
        u
    }
}

impl<const N: usize> BeamStation<N> {
    /// Computes the increments of the directors.
    pub(crate) fn directors<S: Interpolation<N>>(&self, q: &RelativeVectors<N>) -> Directors {
        q.directors::<S>(&self.parts)
    }

    /// Bounds the rounding errors of [`directors`](Self::directors), given the norms of the vectors.
    pub(super) fn director_rounding(&self, sizes: &[f64; N]) -> [f64; DIRECTORS] {
        let mut du = [0.0; DIRECTORS];
        for (i, size) in sizes.iter().enumerate() {
            for &(director, weight) in self.parts[i].as_slice() {
                du[director] += f64::EPSILON * weight.abs() * size;
            }
        }
        du
    }

    /// Returns the number of directors that the law depends on.
    pub(super) fn reach(&self) -> usize {
        self.law.reach()
    }

    /// Returns the reference directors in the global frame.
    pub(crate) fn reference(&self, frame: &Matrix3<f64>) -> Directors {
        let mut g0 = self.reference;
        for g in g0.iter_mut().filter(|g| **g != Vector3::zeros()) {
            *g = frame * *g;
        }
        g0
    }

    /// Requires det J > 0 on the axis, and at the points of the elastic law.
    pub(crate) fn is_admissible(&self, g0: &Directors, u: &Directors) -> bool {
        let g = sum(g0, u);
        g[0].dot(&g[3].cross(&g[4])) > 0.0 && self.law.is_admissible(g0, u)
    }

    /// Returns the strain energy per length.
    pub(crate) fn energy(&self, g0: &Directors, u: &Directors) -> f64 {
        self.law.energy(g0, u)
    }

    /// Returns the strain energy per length by part.
    pub(crate) fn strain_energy(&self, g0: &Directors, u: &Directors) -> StrainEnergy {
        let StationLaw::Quadratic(law) = &self.law else {
            return StrainEnergy { volume: self.law.energy(g0, u), ..StrainEnergy::default() };
        };
        StrainEnergy::of_shares(&law.shares(g0, u))
    }

    /// Computes elastic and viscous forces of the directors per length. `v` are the velocities of the vectors, if
    /// viscous.
    pub(crate) fn forces<S: Interpolation<N>>(
        &self,
        g0: &Directors,
        u: &Directors,
        v: Option<&RelativeVectors<N>>,
    ) -> Directors {
        let mut p = self.law.forces(g0, u);
        if let (Some(law), Some(v)) = (&self.viscosity, v) {
            let g = sum(g0, u);
            let viscous = law.of_resultants(&law.viscous(&g, &self.directors::<S>(v)), &g);
            p.iter_mut().zip(viscous).for_each(|(p, viscous)| *p += viscous);
        }
        p
    }

    /// Bounds the rounding errors of the forces for each component, given the norms of the vectors.
    pub(crate) fn rounding<S: Interpolation<N>>(
        &self,
        g0: &Directors,
        u: &Directors,
        v: Option<&RelativeVectors<N>>,
        sizes: &[f64; N],
    ) -> [f64; DIRECTORS] {
        let mut bound = self.law.rounding(g0, u, &self.director_rounding(sizes));
        if let (Some(law), Some(v)) = (&self.viscosity, v) {
            let g = sum(g0, u);
            let n = law.viscous(&g, &self.directors::<S>(v)).map(f64::abs);
            let sizes = law.of_resultants(&n, &g.map(|g| g.abs()));
            bound.iter_mut().zip(sizes).for_each(|(bound, size)| *bound += 4.0 * f64::EPSILON * size.norm());
        }
        bound
    }

    /// Computes all blocks of the derivatives of the forces, w_q by the directors and w_v by their rates.
    ///
    /// The term w_q B(g)ᵀ D B(v), the effect of displacements on the strain rates, is omitted. It is not symmetric, and
    /// its symmetric part slows Newton's method down.
    pub(crate) fn stiffness<S: Interpolation<N>>(
        &self,
        g0: &Directors,
        u: &Directors,
        v: Option<&RelativeVectors<N>>,
        [wq, wv]: [f64; 2],
        h: &mut Stiffness,
    ) {
        let reach = self.law.reach();
        for i in 0..reach {
            h[i][..=i].fill(Matrix3::zeros());
        }
        if wq != 0.0 {
            self.law.add_stiffness(g0, u, wq, h);
        }
        if let (Some(law), Some(v)) = (&self.viscosity, v) {
            let (g, v) = (sum(g0, u), self.directors::<S>(v));
            law.add_geometric(&law.viscous(&g, &v), wq, h);
            law.add_squares(&g, wv, h);
        }
        mirror(h, reach);
    }

    /// Computes all blocks of the initial stress stiffness, for first-order stresses of the increment `du` of the
    /// directors.
    pub(crate) fn stress_stiffness(&self, g0: &Directors, u: &Directors, du: &Directors) -> Stiffness {
        let mut h = NO_STIFFNESS;
        self.law.add_stress_stiffness(g0, u, du, &mut h);
        mirror(&mut h, DIRECTORS);
        h
    }

    /// Computes all blocks of the stress prediction for an increment `du` of the directors; `None` for hyperelastic laws, whose
    /// strains have no parts of second order that dominate.
    pub(crate) fn stress_prediction(&self, du: &Directors) -> Option<Stiffness> {
        let StationLaw::Quadratic(law) = &self.law else { return None };
        let mut h = NO_STIFFNESS;
        law.add_stress_prediction(du, &mut h);
        mirror(&mut h, DIRECTORS);
        Some(h)
    }

    /// Distributes the forces p of the directors to the vectors.
    pub(crate) fn distribute(&self, p: &Directors, force: &mut [Vector3<f64>; N]) {
        for (force, parts) in force.iter_mut().zip(&self.parts) {
            for &(director, weight) in parts.as_slice() {
                *force += p[director] * (weight * self.weight);
            }
        }
    }

    /// Distributes the stiffness H of the directors to the lower blocks of the element matrix.
    pub(crate) fn distribute_stiffness(&self, h: &Stiffness, k: &mut [[Matrix3<f64>; N]; N]) {
        let reach = self.law.reach();
        for a in 0..N {
            if let [(director, own)] = *self.parts[a].as_slice() {
                for b in 0..=a {
                    for &(other, weight) in self.parts[b].as_slice() {
                        add(&mut k[a][b], &h[director][other], own * weight * self.weight);
                    }
                }
                continue;
            }
            // Row of the vector with respect to the directors.
            let mut row = [Matrix3::zeros(); DIRECTORS];
            for &(director, weight) in self.parts[a].as_slice() {
                for j in 0..reach {
                    add(&mut row[j], &h[director][j], weight * self.weight);
                }
            }
            for b in 0..=a {
                for &(director, weight) in self.parts[b].as_slice() {
                    add(&mut k[a][b], &row[director], weight);
                }
            }
        }
    }
}

/// Sets the upper blocks of the first `reach` directors from the lower ones.
pub(super) fn mirror(h: &mut Stiffness, reach: usize) {
    for i in 0..reach {
        for j in 0..i {
            h[j][i] = h[i][j].transpose();
        }
    }
}
