use std::ops::{Add, Mul, Neg, Sub};

use ancf_solver::equations::{LANES, Lanes};
use pulp::{Arch, Simd, WithSimd};

/// As many terms of a batch as the machine takes at once: one pass over it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pass<S> {
    simd: S,
    number: usize,
}

impl<S: Simd> Pass<S> {
    /// The passes that so many terms need.
    #[inline(always)]
    pub fn all(simd: S, count: usize) -> impl Iterator<Item = Self> {
        (0..count.div_ceil(S::F64_LANES)).map(move |number| Self { simd, number })
    }

    /// Which numbers of [`Lanes`] it takes; told so that it is known to be within them.
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

    /// The same number in each lane.
    #[inline(always)]
    pub fn splat(self, x: f64) -> Lane<S> {
        Lane { simd: self.simd, x: self.simd.splat_f64s(x) }
    }

    #[inline(always)]
    pub fn zero(self) -> Lane<S> {
        self.splat(0.0)
    }

    #[inline(always)]
    pub fn zeros(self) -> Vector<S> {
        [self.zero(); 3]
    }

    #[inline(always)]
    pub fn vector(self, from: &[Lanes]) -> Vector<S> {
        [self.load(&from[0]), self.load(&from[1]), self.load(&from[2])]
    }
}

/// One number of each term of a pass.
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
    fn of(self, x: S::f64s) -> Self {
        Self { simd: self.simd, x }
    }

    /// self × factor + sum, rounded once where the machine can.
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

/// A vector in space of each term of a pass.
pub(crate) type Vector<S> = [Lane<S>; 3];

/// sum + x × factor.
#[inline(always)]
pub(crate) fn plus<S: Simd>(sum: Vector<S>, x: Vector<S>, factor: Lane<S>) -> Vector<S> {
    [x[0].mul_add(factor, sum[0]), x[1].mul_add(factor, sum[1]), x[2].mul_add(factor, sum[2])]
}

#[inline(always)]
pub(crate) fn scaled<S: Simd>(x: Vector<S>, factor: Lane<S>) -> Vector<S> {
    [x[0] * factor, x[1] * factor, x[2] * factor]
}

#[inline(always)]
pub(crate) fn added<S: Simd>(x: Vector<S>, y: Vector<S>) -> Vector<S> {
    [x[0] + y[0], x[1] + y[1], x[2] + y[2]]
}

#[inline(always)]
pub(crate) fn less<S: Simd>(x: Vector<S>, y: Vector<S>) -> Vector<S> {
    [x[0] - y[0], x[1] - y[1], x[2] - y[2]]
}

#[inline(always)]
pub(crate) fn dot<S: Simd>(x: Vector<S>, y: Vector<S>) -> Lane<S> {
    x[2].mul_add(y[2], x[1].mul_add(y[1], x[0] * y[0]))
}

/// sum + x·y.
#[inline(always)]
pub(crate) fn dot_add<S: Simd>(x: Vector<S>, y: Vector<S>, sum: Lane<S>) -> Lane<S> {
    x[2].mul_add(y[2], x[1].mul_add(y[1], x[0].mul_add(y[0], sum)))
}

/// A number that terms have in common, or one for each.
pub(crate) trait Number: Copy + Send + Sync + 'static {
    fn lane<S: Simd>(&self, pass: Pass<S>) -> Lane<S>;

    /// From the number of each term; the last one again where there are no more.
    fn of(terms: &[f64]) -> Self;
}

impl Number for f64 {
    #[inline(always)]
    fn lane<S: Simd>(&self, pass: Pass<S>) -> Lane<S> {
        pass.splat(*self)
    }

    fn of(terms: &[f64]) -> Self {
        terms[0]
    }
}

impl Number for Lanes {
    #[inline(always)]
    fn lane<S: Simd>(&self, pass: Pass<S>) -> Lane<S> {
        pass.load(self)
    }

    fn of(terms: &[f64]) -> Self {
        Self(std::array::from_fn(|lane| terms[lane.min(terms.len() - 1)]))
    }
}

/// The sum of the numbers of so many terms.
pub(crate) fn total(lanes: &Lanes, count: usize) -> f64 {
    lanes.0[..count].iter().sum()
}

/// What is done in each pass over a batch.
pub(crate) trait Job {
    fn run<S: Simd>(&mut self, pass: Pass<S>);
}

struct Passes<'a, J> {
    job: &'a mut J,
    count: usize,
}

impl<J: Job> WithSimd for Passes<'_, J> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        for pass in Pass::all(simd, self.count) {
            self.job.run(pass);
        }
    }
}

/// Does a job for so many terms by the best instructions that this machine has.
pub(crate) fn run<J: Job>(count: usize, mut job: J) {
    Arch::new().dispatch(Passes { job: &mut job, count });
}
