use ancf_solver::equations::Lanes;
use pulp::Simd;

use super::lane::{Number, Pass, Vector, added, dot, dot_add, plus};
use super::plan::{Plan, part};
use super::relative::{Directors, Strains};
use crate::sections::STRAINS;

/// A director by its number, which is less than eight.
#[inline(always)]
pub(crate) fn director<S: Simd>(g: &Directors<S>, number: u8) -> Vector<S> {
    g[usize::from(number & 7)]
}

impl Plan {
    /// Sets g_α·v_β + v_α·g_β and g_α·v_α, or adds them to what is there.
    ///
    /// Of the directors g⁰ + ½u and the increment u these are the strains; of the directors and their rates, the rates of strain.
    #[inline(always)]
    pub fn strains<S: Simd>(
        &self,
        pass: Pass<S>,
        [g, v]: [&Directors<S>; 2],
        adding: bool,
        strains: &mut Strains<S>,
    ) {
        for (strain, &i) in strains.iter_mut().zip(&self.equal) {
            let start = if adding { *strain } else { pass.zero() };
            *strain = dot_add(director(g, i), director(v, i), start);
        }
        for (strain, &[i, j]) in strains[self.equal.len()..].iter_mut().zip(&self.mixed) {
            let start = if adding { *strain } else { pass.zero() };
            // Two sums that do not wait for each other.
            let sum = dot_add(director(g, i), director(v, j), start);
            *strain = sum + dot(director(v, i), director(g, j));
        }
    }

    /// D ε times a factor.
    #[inline(always)]
    pub fn resultants<S: Simd, C: Number>(
        &self,
        pass: Pass<S>,
        d: &[C],
        strains: &Strains<S>,
        factor: f64,
        n: &mut Strains<S>,
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

    /// Σ_k n_k ∂ε_k/∂g_α.
    #[inline(always)]
    pub fn pulls<S: Simd>(&self, pass: Pass<S>, n: &Strains<S>, g: &Directors<S>, p: &mut Directors<S>) {
        for (i, &range) in self.forces.iter().enumerate() {
            let mut sum = pass.zeros();
            for &(k, x) in part(&self.pulls, range) {
                sum = plus(sum, director(g, x), n[usize::from(k)]);
            }
            p[i & 7] = sum;
        }
    }
}

/// A deformed section: its directors, and what follows from them. Made once, and filled at each station.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(crate) struct Section<S: Simd> {
    /// g = g⁰ + u.
    pub now: Directors<S>,
    /// g⁰ + ½u.
    pub middle: Directors<S>,
    /// u.
    pub increment: Directors<S>,
    /// What is made of the directors in between: their rates, their forces, or multiples of them.
    pub made: Directors<S>,
    pub strains: Strains<S>,
    /// Stress resultants.
    pub n: Strains<S>,
}

impl<S: Simd> Section<S> {
    #[inline(always)]
    pub fn new(pass: Pass<S>) -> Self {
        let (none, zero) = ([pass.zeros(); 8], [pass.zero(); STRAINS]);
        Self { now: none, middle: none, increment: none, made: none, strains: zero, n: zero }
    }

    /// From reference directors, as many as are wanted, and increments.
    #[inline(always)]
    pub fn deform(
        &mut self,
        pass: Pass<S>,
        reference: &[[Lanes; 3]; 7],
        increment: &Directors<S>,
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
