use ancf_solver::equations::Lanes;
use pulp::Simd;

use super::plan::{Plan, StiffnessBlock, part};
use super::relative::{DirectorLanes, StrainLanes};
use super::strain::{SectionLanes, director};
use crate::lanes::{Lane, LaneNumber, Pass, VectorLanes, plus, scaled};

/// 3 × 3 block for each term of a pass, by rows.
pub(crate) type MatrixLanes<S> = [Lane<S>; 9];

/// Lower blocks of the stiffness of the directors of all terms, by rows.
pub(crate) type StiffnessLanes = [[Lanes; 9]];

/// Returns the index of block (i, j), i ≥ j.
#[inline(always)]
pub(crate) const fn at(i: usize, j: usize) -> usize {
    i * (i + 1) / 2 + j
}

impl Plan {
    /// Computes the blocks H_αβ = n_αβ I + Σ D ∂ε/∂g_α (∂ε/∂g_β)ᵀ, with `scaled` directors in the left factor.
    #[inline(always)]
    pub fn stiffness<S: Simd, C: LaneNumber>(
        &self,
        pass: Pass<S>,
        d: &[C],
        section: &mut SectionLanes<S>,
        factor: f64,
        h: &mut StiffnessLanes,
    ) {
        let (SectionLanes { n, now: g, scratch: left, .. }, factor) = (section, pass.splat(factor));
        for i in 0..7 {
            left[i] = scaled(g[i], factor);
        }
        for (i, block) in self.diagonal.iter().enumerate() {
            let mut sum = diagonal(pass, block, n);
            for group in part(&self.groups, block.groups) {
                let (x, y) = (self.product(pass, d, left, group.products), director(g, group.y));
                sum[0] = x[0].mul_add(y[0], sum[0]);
                sum[3] = x[1].mul_add(y[0], sum[3]);
                sum[4] = x[1].mul_add(y[1], sum[4]);
                sum[6] = x[2].mul_add(y[0], sum[6]);
                sum[7] = x[2].mul_add(y[1], sum[7]);
                sum[8] = x[2].mul_add(y[2], sum[8]);
            }
            (sum[1], sum[2], sum[5]) = (sum[3], sum[6], sum[7]);
            store(pass, &mut h[at(i, i)], &sum);
        }
        let (mut i, mut j) = (1, 0);
        for block in &self.below {
            let mut sum = diagonal(pass, block, n);
            for group in part(&self.groups, block.groups) {
                let (x, y) = (self.product(pass, d, left, group.products), director(g, group.y));
                add_outer(&mut sum, x, y);
            }
            store(pass, &mut h[at(i, j)], &sum);
            (i, j) = if j + 1 == i { (i + 1, 0) } else { (i, j + 1) };
        }
    }

    /// Computes Σ D g_x.
    #[inline(always)]
    fn product<S: Simd, C: LaneNumber>(
        &self,
        pass: Pass<S>,
        d: &[C],
        g: &DirectorLanes<S>,
        products: (u16, u16),
    ) -> VectorLanes<S> {
        let mut sum = pass.zeros();
        for &(x, entry) in part(&self.products, products) {
            sum = plus(sum, director(g, x), d[usize::from(entry)].lane(pass));
        }
        sum
    }
}

#[inline(always)]
fn diagonal<S: Simd>(pass: Pass<S>, block: &StiffnessBlock, n: &StrainLanes<S>) -> MatrixLanes<S> {
    let mut sum = [pass.zero(); 9];
    if let Some(k) = block.stress {
        let n = n[usize::from(k)];
        (sum[0], sum[4], sum[8]) = (n, n, n);
    }
    sum
}

#[inline(always)]
fn add_outer<S: Simd>(sum: &mut MatrixLanes<S>, x: VectorLanes<S>, y: VectorLanes<S>) {
    for r in 0..3 {
        for c in 0..3 {
            sum[3 * r + c] = x[r].mul_add(y[c], sum[3 * r + c]);
        }
    }
}

#[inline(always)]
fn store<S: Simd>(pass: Pass<S>, to: &mut [Lanes; 9], block: &MatrixLanes<S>) {
    for e in 0..9 {
        pass.store(&mut to[e], block[e]);
    }
}

#[inline(always)]
pub(crate) fn load<S: Simd>(pass: Pass<S>, from: &[Lanes; 9]) -> MatrixLanes<S> {
    let mut block = [pass.zero(); 9];
    for e in 0..9 {
        block[e] = pass.load(&from[e]);
    }
    block
}

/// Computes sum += factor × block.
#[inline(always)]
pub(crate) fn add<S: Simd>(sum: &mut MatrixLanes<S>, block: &MatrixLanes<S>, factor: Lane<S>) {
    for e in 0..9 {
        sum[e] = block[e].mul_add(factor, sum[e]);
    }
}

/// Computes sum −= block.
#[inline(always)]
pub(crate) fn subtract<S: Simd>(sum: &mut MatrixLanes<S>, block: &MatrixLanes<S>) {
    for e in 0..9 {
        sum[e] = sum[e] - block[e];
    }
}

#[inline(always)]
pub(crate) fn times<S: Simd>(block: &MatrixLanes<S>, factor: Lane<S>) -> MatrixLanes<S> {
    let mut product = *block;
    for e in 0..9 {
        product[e] = block[e] * factor;
    }
    product
}

#[inline(always)]
pub(crate) fn transposed<S: Simd>(b: &MatrixLanes<S>) -> MatrixLanes<S> {
    [b[0], b[3], b[6], b[1], b[4], b[7], b[2], b[5], b[8]]
}
