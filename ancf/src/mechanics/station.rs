use nalgebra::{Matrix3, Vector3};

use super::section::{DIRECTORS, Directors, SectionLaw, Stiffness, sum};
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

    fn rounding(&self, g0: &Directors, u: &Directors, du: &[f64; DIRECTORS]) -> [f64; DIRECTORS] {
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
    /// Weights of the element's vectors in the directors that each enters.
    pub(super) weights: [[f64; 3]; N],
    /// Directors of the reference state in the element's frame.
    pub(super) reference: Directors,
    /// Elasticity.
    pub(super) law: Law,
    /// Viscosity: resultants of strain rates.
    pub(super) viscosity: Option<SectionLaw>,
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
    pub(super) fn sum<S: Interpolation<N>>(weights: &[[f64; 3]; N], q: &Relative<N>) -> Directors {
        let mut u = [Vector3::zeros(); DIRECTORS];
        let (mut d, mut e) = (0.0, 0.0);
        for i in 0..N {
            for (director, weight) in S::KINDS[i].directors().into_iter().zip(weights[i]) {
                if weight != 0.0 {
                    u[director] += q.difference[i] * weight;
                }
            }
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
    fn uncertainty<S: Interpolation<N>>(&self, q: &[Vector3<f64>; N]) -> [f64; DIRECTORS] {
        let mut du = [0.0; DIRECTORS];
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

    /// Elastic and viscous forces of the directors, per length, with velocities `v` of the vectors.
    pub(super) fn forces<S: Interpolation<N>>(
        &self,
        g0: &Directors,
        u: &Directors,
        v: &Relative<N>,
    ) -> Directors {
        let mut p = self.law.forces(g0, u);
        if let Some(law) = &self.viscosity {
            let g = sum(g0, u);
            let viscous = law.of_resultants(&law.viscous(&g, &self.directors::<S>(v)), &g);
            p.iter_mut().zip(viscous).for_each(|(p, viscous)| *p += viscous);
        }
        p
    }

    /// A bound of the rounding errors of the forces at vectors q, for each component.
    pub(super) fn rounding<S: Interpolation<N>>(
        &self,
        g0: &Directors,
        u: &Directors,
        v: &Relative<N>,
        q: &[Vector3<f64>; N],
    ) -> [f64; DIRECTORS] {
        let mut bound = self.law.rounding(g0, u, &self.uncertainty::<S>(q));
        if let Some(law) = &self.viscosity {
            let g = sum(g0, u);
            let n = law.viscous(&g, &self.directors::<S>(v)).map(f64::abs);
            let sizes = law.of_resultants(&n, &g.map(|g| g.abs()));
            bound.iter_mut().zip(sizes).for_each(|(bound, size)| *bound += 4.0 * f64::EPSILON * size.norm());
        }
        bound
    }

    /// Derivatives of the forces, w_q by the directors and w_v by their rates; of the unsymmetric part that viscosity has,
    /// w_q B(g)ᵀ D B(v), the symmetric part.
    pub(super) fn stiffness<S: Interpolation<N>>(
        &self,
        g0: &Directors,
        u: &Directors,
        v: &Relative<N>,
        [wq, wv]: [f64; 2],
    ) -> Stiffness {
        let mut h = [[Matrix3::zeros(); DIRECTORS]; DIRECTORS];
        if wq != 0.0 {
            self.law.add_stiffness(g0, u, wq, &mut h);
        }
        if let Some(law) = &self.viscosity {
            let (g, v) = (sum(g0, u), self.directors::<S>(v));
            law.add_geometric(&law.viscous(&g, &v), wq, &mut h);
            law.add_products(&g, &g, wv, &mut h);
            law.add_products(&g, &v, wq, &mut h);
        }
        h
    }

    /// Adds p to the vectors that the directors are made of.
    pub(super) fn spread<S: Interpolation<N>>(&self, p: &Directors, force: &mut [Vector3<f64>; N]) {
        for (i, force) in force.iter_mut().enumerate() {
            for (director, weight) in S::KINDS[i].directors().into_iter().zip(self.weights[i]) {
                if weight != 0.0 {
                    *force += p[director] * (weight * self.weight);
                }
            }
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
            // Rows of the vector against the directors, for those that the station has.
            let mut rows = [Matrix3::zeros(); DIRECTORS];
            for (director, weight) in S::KINDS[a].directors().into_iter().zip(self.weights[a]) {
                if weight != 0.0 {
                    for j in 0..DIRECTORS {
                        rows[j] += of(director, j) * (weight * self.weight);
                    }
                }
            }
            for b in 0..=a {
                for (director, weight) in S::KINDS[b].directors().into_iter().zip(self.weights[b]) {
                    if weight != 0.0 {
                        k[a][b] += rows[director] * weight;
                    }
                }
            }
        }
    }
}
