use ancf_solver::equations::Lanes;
use pulp::Simd;

use super::plan::{Plan, part};
use super::relative::{DirectorLanes, StrainLanes};
use crate::lanes::{LaneNumber, Pass, VectorLanes, added, dot, dot_add, plus};
use crate::sections::STRAINS;

/// Returns a director by its index below eight.
#[inline(always)]
pub(crate) fn director<S: Simd>(g: &DirectorLanes<S>, number: u8) -> VectorLanes<S> {
    g[usize::from(number & 7)]
}

impl Plan {
    /// Computes g_α·v_β + v_α·g_β and g_α·v_α, or adds them to the present values.
    ///
    /// For the directors g⁰ + ½u and the increment u these are the strains. For the directors and their rates they are
    /// the strain rates.
    #[inline(always)]
    pub fn strains<S: Simd>(
        &self,
        pass: Pass<S>,
        [g, v]: [&DirectorLanes<S>; 2],
        adding: bool,
        strains: &mut StrainLanes<S>,
    ) {
        for (strain, &i) in strains.iter_mut().zip(&self.equal) {
            let start = if adding { *strain } else { pass.zero() };
            *strain = dot_add(director(g, i), director(v, i), start);
        }
        for (strain, &[i, j]) in strains[self.equal.len()..].iter_mut().zip(&self.mixed) {
            let start = if adding { *strain } else { pass.zero() };
            // Two independent sums avoid a latency chain.
            let sum = dot_add(director(g, i), director(v, j), start);
            *strain = sum + dot(director(v, i), director(g, j));
        }
    }

    /// Computes D ε times a factor.
    #[inline(always)]
    pub fn resultants<S: Simd, C: LaneNumber>(
        &self,
        pass: Pass<S>,
        d: &[C],
        strains: &StrainLanes<S>,
        factor: f64,
        n: &mut StrainLanes<S>,
    ) {
        let factor = pass.splat(factor);
        for (n, &range) in n.iter_mut().zip(&self.resultants) {
            let mut sum = pass.zero();
            for &(l, entry) in part(&self.coupled, range) {
                sum = d[usize::from(entry)].lane(pass).mul_add(strains[usize::from(l)], sum);
            }
            *n = sum * factor;
        }
    }

    /// Computes Σ_k n_k ∂ε_k/∂g_α.
    #[inline(always)]
    pub fn force_terms<S: Simd>(
        &self,
        pass: Pass<S>,
        n: &StrainLanes<S>,
        g: &DirectorLanes<S>,
        p: &mut DirectorLanes<S>,
    ) {
        for (i, &range) in self.forces.iter().enumerate() {
            let mut sum = pass.zeros();
            for &(k, x) in part(&self.force_terms, range) {
                sum = plus(sum, director(g, x), n[usize::from(k)]);
            }
            p[i & 7] = sum;
        }
    }
}

/// Working storage of a deformed section, allocated once and filled at each station.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(crate) struct SectionLanes<S: Simd> {
    /// Directors g = g⁰ + u.
    pub now: DirectorLanes<S>,
    /// Midpoint directors g⁰ + ½u.
    pub middle: DirectorLanes<S>,
    /// Increment u.
    pub increment: DirectorLanes<S>,
    /// Intermediate results: rates, forces or multiples of the directors.
    pub scratch: DirectorLanes<S>,
    pub strains: StrainLanes<S>,
    /// Stress resultants.
    pub n: StrainLanes<S>,
}

impl<S: Simd> SectionLanes<S> {
    #[inline(always)]
    pub fn new(pass: Pass<S>) -> Self {
        let (none, zero) = ([pass.zeros(); 8], [pass.zero(); STRAINS]);
        Self { now: none, middle: none, increment: none, scratch: none, strains: zero, n: zero }
    }

    /// Computes the directors from reference directors, as many as required, and increments.
    #[inline(always)]
    pub fn deform(
        &mut self,
        pass: Pass<S>,
        reference: &[[Lanes; 3]; 7],
        increment: &DirectorLanes<S>,
        reach: usize,
    ) {
        let half = pass.splat(0.5);
        for i in 0..7 {
            if i < 5 || reach > 5 {
                let (g0, u) = (pass.vector(&reference[i]), increment[i]);
                self.now[i] = added(g0, u);
                self.middle[i] = plus(g0, u, half);
                self.increment[i] = u;
            }
        }
    }
}
