use pulp::Simd;

use super::lane::{Lane, Number, Pass, added, dot, plus};
use super::plan::{Plan, part};
use super::relative::{Directors, Strains};
use crate::system::Lanes;

/// A director by its number, which is less than eight.
#[inline(always)]
pub(super) fn director<S: Simd>(g: &Directors<S>, number: u8) -> [Lane<S>; 3] {
    g[usize::from(number & 7)]
}

#[inline(always)]
pub(super) fn strain<S: Simd>(n: &Strains<S>, number: usize) -> Lane<S> {
    n[number & 31]
}

impl Plan {
    /// g_α·v_β + v_α·g_β and g_α·v_α.
    ///
    /// Of the directors g⁰ + ½u and the increment u these are the strains; of the directors and their rates, the rates of strain.
    #[inline(always)]
    pub fn strains<S: Simd>(&self, pass: Pass<S>, g: &Directors<S>, v: &Directors<S>) -> Strains<S> {
        let mut strains = [pass.zero(); 32];
        for (k, &i) in self.equal.iter().enumerate() {
            strains[k & 31] = dot(director(g, i), director(v, i));
        }
        let first = self.equal.len();
        for (k, &[i, j]) in self.mixed.iter().enumerate() {
            let ([gi, gj], [vi, vj]) = ([i, j].map(|i| director(g, i)), [i, j].map(|i| director(v, i)));
            let sum = gi[2].mul_add(vj[2], gi[1].mul_add(vj[1], gi[0] * vj[0]));
            let sum = vi[2].mul_add(gj[2], vi[1].mul_add(gj[1], vi[0].mul_add(gj[0], sum)));
            strains[(first + k) & 31] = sum;
        }
        strains
    }

    /// D ε times a factor.
    #[inline(always)]
    pub fn resultants<S: Simd, C: Number>(
        &self,
        pass: Pass<S>,
        d: &[C],
        strains: &Strains<S>,
        factor: f64,
    ) -> Strains<S> {
        let (mut n, factor) = ([pass.zero(); 32], pass.splat(factor));
        for (k, &range) in self.resultants.iter().enumerate() {
            let mut sum = pass.zero();
            for &(l, entry) in part(&self.coupled, range) {
                sum = d[usize::from(entry)].lane(pass).mul_add(strain(strains, usize::from(l)), sum);
            }
            n[k & 31] = sum * factor;
        }
        n
    }

    /// Σ_k n_k ∂ε_k/∂g_α.
    #[inline(always)]
    pub fn pulls<S: Simd>(&self, pass: Pass<S>, n: &Strains<S>, g: &Directors<S>) -> Directors<S> {
        let mut p = [pass.zeros(); 8];
        for (i, &range) in self.forces.iter().enumerate() {
            let mut sum = pass.zeros();
            for &(k, x) in part(&self.pulls, range) {
                sum = plus(sum, director(g, x), strain(n, usize::from(k)));
            }
            p[i & 7] = sum;
        }
        p
    }
}

/// Directors of a deformed section.
#[derive(Clone, Copy, Debug)]
pub(super) struct Deformed<S: Simd> {
    /// g = g⁰ + u.
    pub now: Directors<S>,
    /// g⁰ + ½u.
    pub middle: Directors<S>,
    /// u.
    pub increment: Directors<S>,
}

impl<S: Simd> Deformed<S> {
    /// From reference directors, as many as are wanted, and increments.
    #[inline(always)]
    pub fn new(pass: Pass<S>, reference: &[[Lanes; 3]; 7], increment: &Directors<S>, reach: usize) -> Self {
        let (mut now, mut middle, half) = (*increment, *increment, pass.splat(0.5));
        for i in 0..7 {
            if i < reach {
                let (g0, u) = (pass.vector(&reference[i]), increment[i]);
                now[i] = added(g0, u);
                middle[i] = plus(g0, u, half);
            }
        }
        Self { now, middle, increment: *increment }
    }
}
