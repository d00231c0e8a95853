use std::ops::{Add, Mul, Neg, Sub};

use ancf_solver::equations::{LANES, Lanes};
use pulp::{Arch, Simd, WithSimd};

/// Pass over a batch: as many terms as fit into a vector register.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pass<S> {
    simd: S,
    number: usize,
}

impl<S: Simd> Pass<S> {
    /// Returns the passes for the given number of terms.
    #[inline(always)]
    pub fn all(simd: S, count: usize) -> impl Iterator<Item = Self> {
        (0..count.div_ceil(S::F64_LANES)).map(move |number| Self { simd, number })
    }

    /// Returns the index of the pass in [`Lanes`], bounded such that the compiler can omit bounds checks.
    #[inline(always)]
    fn place(self) -> usize {
        self.number % (LANES / S::F64_LANES)
    }

    #[inline(always)]
    pub fn load(self, from: &Lanes) -> Lane<S> {
        Lane { simd: self.simd, x: S::as_simd_f64s(&from.0).0[self.place()] }
    }

    #[inline(always)]
    pub fn store(self, to: &mut Lanes, lane: Lane<S>) {
        S::as_mut_simd_f64s(&mut to.0).0[self.place()] = lane.x;
    }

    /// Returns a lane with equal numbers.
    #[inline(always)]
    pub fn splat(self, x: f64) -> Lane<S> {
        Lane { simd: self.simd, x: self.simd.splat_f64s(x) }
    }

    #[inline(always)]
    pub fn zero(self) -> Lane<S> {
        self.splat(0.0)
    }

    #[inline(always)]
    pub fn zeros(self) -> VectorLanes<S> {
        [self.zero(); 3]
    }

    #[inline(always)]
    pub fn vector(self, from: &[Lanes]) -> VectorLanes<S> {
        [self.load(&from[0]), self.load(&from[1]), self.load(&from[2])]
    }
}

/// One number for each term of a pass.
#[derive(Debug)]
pub(crate) struct Lane<S: Simd> {
    simd: S,
    x: S::f64s,
}

impl<S: Simd> Copy for Lane<S> {}

impl<S: Simd> Clone for Lane<S> {
    #[inline(always)]
    fn clone(&self) -> Self {
        *self
    }
}

impl<S: Simd> Lane<S> {
    #[inline(always)]
    pub fn new(simd: S, x: S::f64s) -> Self {
        Self { simd, x }
    }

    /// Returns a lane with equal numbers.
    #[inline(always)]
    pub fn splat(simd: S, x: f64) -> Self {
        Self::new(simd, simd.splat_f64s(x))
    }

    #[inline(always)]
    pub fn register(self) -> S::f64s {
        self.x
    }

    #[inline(always)]
    fn of(self, x: S::f64s) -> Self {
        Self { simd: self.simd, x }
    }

    /// Computes self × factor + sum, with a single rounding where the hardware supports it.
    #[inline(always)]
    pub fn mul_add(self, factor: Self, sum: Self) -> Self {
        self.of(self.simd.mul_add_e_f64s(self.x, factor.x, sum.x))
    }

    #[inline(always)]
    pub fn sqrt(self) -> Self {
        self.of(self.simd.sqrt_f64s(self.x))
    }

    #[inline(always)]
    pub fn over(self, divisor: Self) -> Self {
        self.of(self.simd.div_f64s(self.x, divisor.x))
    }
}

impl<S: Simd> Add for Lane<S> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.of(self.simd.add_f64s(self.x, other.x))
    }
}

impl<S: Simd> Sub for Lane<S> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.of(self.simd.sub_f64s(self.x, other.x))
    }
}

impl<S: Simd> Mul for Lane<S> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.of(self.simd.mul_f64s(self.x, other.x))
    }
}

impl<S: Simd> Neg for Lane<S> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        self.of(self.simd.neg_f64s(self.x))
    }
}

/// Vector in space for each term of a pass.
pub(crate) type VectorLanes<S> = [Lane<S>; 3];

/// Computes sum + x × factor.
#[inline(always)]
pub(crate) fn plus<S: Simd>(sum: VectorLanes<S>, x: VectorLanes<S>, factor: Lane<S>) -> VectorLanes<S> {
    [x[0].mul_add(factor, sum[0]), x[1].mul_add(factor, sum[1]), x[2].mul_add(factor, sum[2])]
}

#[inline(always)]
pub(crate) fn scaled<S: Simd>(x: VectorLanes<S>, factor: Lane<S>) -> VectorLanes<S> {
    [x[0] * factor, x[1] * factor, x[2] * factor]
}

#[inline(always)]
pub(crate) fn added<S: Simd>(x: VectorLanes<S>, y: VectorLanes<S>) -> VectorLanes<S> {
    [x[0] + y[0], x[1] + y[1], x[2] + y[2]]
}

#[inline(always)]
pub(crate) fn minus<S: Simd>(x: VectorLanes<S>, y: VectorLanes<S>) -> VectorLanes<S> {
    [x[0] - y[0], x[1] - y[1], x[2] - y[2]]
}

#[inline(always)]
pub(crate) fn dot<S: Simd>(x: VectorLanes<S>, y: VectorLanes<S>) -> Lane<S> {
    x[2].mul_add(y[2], x[1].mul_add(y[1], x[0] * y[0]))
}

#[inline(always)]
pub(crate) fn cross<S: Simd>(x: VectorLanes<S>, y: VectorLanes<S>) -> VectorLanes<S> {
    let of = |i: usize, j: usize| x[i].mul_add(y[j], -(x[j] * y[i]));
    [of(1, 2), of(2, 0), of(0, 1)]
}

/// Computes sum + x·y.
#[inline(always)]
pub(crate) fn dot_add<S: Simd>(x: VectorLanes<S>, y: VectorLanes<S>, sum: Lane<S>) -> Lane<S> {
    x[2].mul_add(y[2], x[1].mul_add(y[1], x[0].mul_add(y[0], sum)))
}

/// Number that terms share, or one number per term.
pub(crate) trait LaneNumber: Copy + Send + Sync + 'static {
    fn lane<S: Simd>(&self, pass: Pass<S>) -> Lane<S>;

    /// Packs the numbers of the terms. The last number fills the remaining lanes.
    fn of(terms: &[f64]) -> Self;
}

impl LaneNumber for f64 {
    #[inline(always)]
    fn lane<S: Simd>(&self, pass: Pass<S>) -> Lane<S> {
        pass.splat(*self)
    }

    fn of(terms: &[f64]) -> Self {
        terms[0]
    }
}

impl LaneNumber for Lanes {
    #[inline(always)]
    fn lane<S: Simd>(&self, pass: Pass<S>) -> Lane<S> {
        pass.load(self)
    }

    fn of(terms: &[f64]) -> Self {
        Self(std::array::from_fn(|lane| terms[lane.min(terms.len() - 1)]))
    }
}

/// Returns the sum over the given number of terms.
pub(crate) fn total(lanes: &Lanes, count: usize) -> f64 {
    lanes.0[..count].iter().sum()
}

/// Computation in each pass over a batch.
pub(crate) trait PassJob {
    fn run<S: Simd>(&mut self, pass: Pass<S>);
}

struct Passes<'a, J> {
    job: &'a mut J,
    count: usize,
}

impl<J: PassJob> WithSimd for Passes<'_, J> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        for pass in Pass::all(simd, self.count) {
            self.job.run(pass);
        }
    }
}

/// Runs a job for the given number of terms with the best available instruction set.
pub(crate) fn run<J: PassJob>(count: usize, mut job: J) {
    Arch::new().dispatch(Passes { job: &mut job, count });
}
