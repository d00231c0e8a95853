use std::ops::{AddAssign, Mul};

use nalgebra::{Matrix3, Vector3};

use super::section::strain::{AA, AB, AC, AD, AE, BB, BC, BD, BE, CC, CD, CE, DD, DE, DH, EE, EH};

use super::section::{Directors, SectionLaw, Stiffness, Strains, sum};
use super::{Interpolation, Kind, NeoHookean};

/// The elastic law of a cross-section.
#[derive(Clone, Debug, PartialEq)]
pub enum Law {
    /// Quadratic in the section strains.
    Quadratic(SectionLaw),
    /// Compressible neo-Hookean.
    Hyperelastic(NeoHookean),
}

impl Law {
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

    fn rounding(&self, g0: &Directors, u: &Directors, du: &[f64; 6]) -> [f64; 6] {
        match self {
            Self::Quadratic(law) => law.rounding(g0, u, du),
            Self::Hyperelastic(law) => law.rounding(g0, u, du),
        }
    }
}

/// One quadrature point of the axis: where it is, what it weighs, what its section is made of.
#[derive(Clone, Debug, PartialEq)]
pub struct Station<const N: usize> {
    /// Where in the element, 0 ≤ ξ ≤ 1.
    pub(super) xi: f64,
    /// Gauss weight times the element's length.
    pub(super) weight: f64,
    /// Weights of the element's vectors in the two directors that each enters.
    pub(super) weights: [[f64; 2]; N],
    /// Directors of the reference state in the element's frame.
    pub(super) reference: Directors,
    /// Elasticity.
    pub(super) law: Law,
    /// Viscosity: resultants of strain rates.
    pub(super) viscosity: Option<SectionLaw>,
}

/// Strain energy by the strains that it belongs to; what couples two of them is shared between them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StrainEnergy {
    /// Stretch of the axis.
    pub axial: f64,
    /// Bending about both axes.
    pub bending: f64,
    /// Mean shear of the sections.
    pub shear: f64,
    /// Twist.
    pub torsion: f64,
    /// Change of the sections' size and shape.
    pub section: f64,
    /// All of it, of a law that has no such parts.
    pub volume: f64,
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

/// Adds to section strains at ξ what linked directors have besides ([`SectionLaw::linked`]).
pub(super) fn link(strains: &mut Strains, xi: f64, length: f64) {
    let (value, slope) = (xi - xi * xi, (1.0 - 2.0 * xi) / length);
    strains[AD] += value * strains[DH];
    strains[AE] += value * strains[EH];
    strains[AB] += slope * strains[DH];
    strains[AC] += slope * strains[EH];
}

/// The vectors of an element, each less the first of its kind, and these first ones of kind Y and Z: what depends on
/// differences only is then not spoilt by what all have in common.
pub(super) struct Relative<const N: usize> {
    difference: [Vector3<f64>; N],
    base: [Vector3<f64>; 2],
}

impl<const N: usize> Relative<N> {
    pub(super) fn new<S: Interpolation<N>>(q: &[Vector3<f64>; N]) -> Self {
        let first = |kind: Kind| S::KINDS.iter().position(|&k| k == kind).map_or(Vector3::zeros(), |i| q[i]);
        let [r, y, z] = [Kind::Position, Kind::Y, Kind::Z].map(first);
        let difference = std::array::from_fn(|i| match S::KINDS[i] {
            Kind::Position => q[i] - r,
            Kind::Slope => q[i],
            Kind::Y => q[i] - y,
            Kind::Z => q[i] - z,
        });
        Self { difference, base: [y, z] }
    }
}

impl<const N: usize> Station<N> {
    /// Increments of the directors.
    pub(super) fn directors<S: Interpolation<N>>(&self, q: &Relative<N>) -> Directors {
        Self::sum::<S>(&self.weights, q)
    }

    /// The directors that vectors make with given weights.
    pub(super) fn sum<S: Interpolation<N>>(weights: &[[f64; 2]; N], q: &Relative<N>) -> Directors {
        let mut u = [Vector3::zeros(); 6];
        let (mut d, mut e) = (0.0, 0.0);
        for i in 0..N {
            let [first, second] = S::KINDS[i].directors();
            u[first] += q.difference[i] * weights[i][0];
            u[second] += q.difference[i] * weights[i][1];
            match S::KINDS[i] {
                Kind::Y => d += weights[i][0],
                Kind::Z => e += weights[i][0],
                Kind::Position | Kind::Slope => {}
            }
        }
        u[3] += q.base[0] * d;
        u[4] += q.base[1] * e;
        u
    }

    /// Bounds of the rounding errors of [`directors`](Self::directors).
    fn uncertainty<S: Interpolation<N>>(&self, q: &[Vector3<f64>; N]) -> [f64; 6] {
        let mut du = [0.0; 6];
        for (i, q) in q.iter().enumerate() {
            for (director, weight) in S::KINDS[i].directors().into_iter().zip(self.weights[i]) {
                du[director] += f64::EPSILON * weight.abs() * q.norm();
            }
        }
        du
    }

    /// The reference directors in the global frame.
    pub(super) fn reference(&self, frame: &Matrix3<f64>) -> Directors {
        self.reference.map(|g| frame * g)
    }

    /// det J > 0 on the axis, and wherever its law wants it.
    pub(super) fn is_admissible(&self, g0: &Directors, u: &Directors) -> bool {
        let g = sum(g0, u);
        g[0].dot(&g[3].cross(&g[4])) > 0.0 && self.law.is_admissible(g0, u)
    }

    /// Strain energy per length.
    pub(super) fn energy(&self, g0: &Directors, u: &Directors) -> f64 {
        self.law.energy(g0, u)
    }

    /// Strain energy per length by part ([`StrainEnergy`]).
    pub(super) fn parts(&self, g0: &Directors, u: &Directors, length: f64) -> StrainEnergy {
        let Law::Quadratic(law) = &self.law else {
            return StrainEnergy { volume: self.law.energy(g0, u), ..StrainEnergy::default() };
        };
        let mut strains = SectionLaw::strains(g0, u);
        let n = law.resultants(&strains);
        if self.weights[0][1] != 0.0 {
            link(&mut strains, self.xi, length);
        }
        let sum = |of: &[usize]| 0.5 * of.iter().map(|&k| n[k] * strains[k]).sum::<f64>();
        StrainEnergy {
            axial: sum(&[AA]),
            bending: sum(&[AB, AC, BB, BC, CC]),
            shear: sum(&[AD, AE]),
            torsion: sum(&[BE, CD]),
            section: sum(&[BD, CE, DD, DE, EE]),
            volume: 0.0,
        }
    }

    /// Stress resultants of the viscosity, if there is any.
    fn viscous(&self, g: &Directors, v: &Directors) -> Option<Strains> {
        self.viscosity.as_ref().map(|law| law.resultants(&SectionLaw::rates(g, v)))
    }

    /// Elastic and viscous forces of the directors, per length; `v` are the rates of the directors.
    pub(super) fn forces(&self, g0: &Directors, u: &Directors, v: &Directors) -> Directors {
        let mut p = self.law.forces(g0, u);
        let g = sum(g0, u);
        if let Some(n) = self.viscous(&g, v) {
            let viscous = SectionLaw::of_resultants(&n, &g);
            p.iter_mut().zip(viscous).for_each(|(p, viscous)| *p += viscous);
        }
        p
    }

    /// A bound of the rounding errors of the forces at vectors q, for each component.
    pub(super) fn rounding<S: Interpolation<N>>(
        &self,
        g0: &Directors,
        u: &Directors,
        v: &Directors,
        q: &[Vector3<f64>; N],
    ) -> [f64; 6] {
        let mut bound = self.law.rounding(g0, u, &self.uncertainty::<S>(q));
        let g = sum(g0, u);
        if let Some(n) = self.viscous(&g, v) {
            let sizes = SectionLaw::of_resultants(&n.map(f64::abs), &g.map(|g| g.abs()));
            bound.iter_mut().zip(sizes).for_each(|(bound, size)| *bound += 4.0 * f64::EPSILON * size.norm());
        }
        bound
    }

    /// Derivatives of the forces, w_q by the directors and w_v by their rates; of the unsymmetric part that viscosity has,
    /// w_q B(g)ᵀ D B(v), the symmetric part.
    pub(super) fn stiffness(
        &self,
        g0: &Directors,
        u: &Directors,
        v: &Directors,
        [wq, wv]: [f64; 2],
    ) -> Stiffness {
        let mut h = [[Matrix3::zeros(); 6]; 6];
        if wq != 0.0 {
            self.law.add_stiffness(g0, u, wq, &mut h);
        }
        if let Some(viscosity) = &self.viscosity {
            let g = sum(g0, u);
            let n = viscosity.resultants(&SectionLaw::rates(&g, v));
            SectionLaw::add_geometric(&n, wq, &mut h);
            viscosity.add_products(&g, &g, wv, &mut h);
            viscosity.add_products(&g, v, 0.5 * wq, &mut h);
            viscosity.add_products(v, &g, 0.5 * wq, &mut h);
        }
        h
    }

    /// The stiffness of the elastic stresses that the increment `du` of the directors causes in first order.
    pub(super) fn stress_stiffness(&self, g0: &Directors, u: &Directors, du: &Directors) -> Stiffness {
        let mut h = [[Matrix3::zeros(); 6]; 6];
        self.law.add_stress_stiffness(g0, u, du, &mut h);
        h
    }

    /// Adds p to the vectors that the directors are made of.
    pub(super) fn spread<S: Interpolation<N>>(&self, p: &Directors, force: &mut [Vector3<f64>; N]) {
        for (i, force) in force.iter_mut().enumerate() {
            let [first, second] = S::KINDS[i].directors();
            *force += (p[first] * self.weights[i][0] + p[second] * self.weights[i][1]) * self.weight;
        }
    }

    /// Adds H to the lower blocks of the element's matrix.
    pub(super) fn spread_stiffness<S: Interpolation<N>>(
        &self,
        h: &Stiffness,
        k: &mut [[Matrix3<f64>; N]; N],
    ) {
        let of = |i: usize, j: usize| if i >= j { h[i][j] } else { h[j][i].transpose() };
        for a in 0..N {
            let [first, second] = S::KINDS[a].directors();
            let [x, y] = self.weights[a].map(|w| w * self.weight);
            let row =
                |j: usize| if y == 0.0 { of(first, j) * x } else { of(first, j) * x + of(second, j) * y };
            // The directors of axis vectors, of y vectors and of z vectors: the row is the same for all of a kind.
            let rows: [Matrix3<f64>; 6] = std::array::from_fn(row);
            for b in 0..=a {
                let [first, second] = S::KINDS[b].directors();
                let [x, y] = self.weights[b];
                k[a][b] += rows[first] * x;
                if y != 0.0 {
                    k[a][b] += rows[second] * y;
                }
            }
        }
    }
}
