//! States of one term, at random, and what the term makes of them.

use ancf::system::{Energy, LOCAL, Local, LocalMatrix, Term, Weights};
use nalgebra::{DMatrix, DVector, Vector3};

/// Numbers in [−1, 1), the same in every run (SplitMix64; Steele, Lea & Flood 2014).
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((mixed ^ (mixed >> 31)) >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    pub(crate) fn vector(&mut self, size: usize) -> DVector<f64> {
        DVector::from_fn(size, |_, _| self.number())
    }

    pub(crate) fn vector3(&mut self) -> Vector3<f64> {
        Vector3::from_fn(|_, _| self.number())
    }
}

/// The unknowns of one term.
#[derive(Clone)]
pub(crate) struct Sample {
    pub(crate) q: DVector<f64>,
    pub(crate) v: DVector<f64>,
    pub(crate) a: DVector<f64>,
    pub(crate) lambda: DVector<f64>,
}

impl Sample {
    pub(crate) fn random(term: &dyn Term, random: &mut Random) -> Self {
        let (n, m) = sizes(term);
        Self { q: random.vector(n), v: random.vector(n), a: random.vector(n), lambda: random.vector(m) }
    }

    pub(crate) fn rest(term: &dyn Term) -> Self {
        let (n, m) = sizes(term);
        Self { q: DVector::zeros(n), v: DVector::zeros(n), a: DVector::zeros(n), lambda: DVector::zeros(m) }
    }

    pub(crate) fn local(&self) -> Local<'_> {
        let Self { q, v, a, lambda } = self;
        Local {
            q: q.as_slice(),
            v: v.as_slice(),
            a: a.as_slice(),
            lambda: lambda.as_slice(),
            t: 0.3,
            load: 0.7,
        }
    }

    /// Moved by h (dz, dλ), as weights have it.
    pub(crate) fn moved(&self, z: &DVector<f64>, h: f64, w: Weights) -> Self {
        let (dz, dlambda) = (z.rows(0, self.q.len()) * h, z.rows(self.q.len(), self.lambda.len()) * h);
        Self {
            q: &self.q + &dz * w.q,
            v: &self.v + &dz * w.v,
            a: &self.a + dz * w.a,
            lambda: &self.lambda + dlambda,
        }
    }
}

pub(crate) fn sizes(term: &dyn Term) -> (usize, usize) {
    (term.coordinates().len(), term.multipliers().len())
}

pub(crate) fn residual(term: &dyn Term, at: &Sample) -> DVector<f64> {
    let mut r = DVector::zeros(at.q.len() + at.lambda.len());
    term.residual(&at.local(), r.as_mut_slice());
    r
}

pub(crate) fn rounding(term: &dyn Term, at: &Sample) -> DVector<f64> {
    let mut floor = DVector::zeros(at.q.len() + at.lambda.len());
    term.rounding(&at.local(), floor.as_mut_slice());
    floor
}

pub(crate) fn tangent(term: &dyn Term, at: &Sample, w: Weights) -> DMatrix<f64> {
    let size = at.q.len() + at.lambda.len();
    let mut storage = [0.0; LOCAL * LOCAL];
    let mut k = LocalMatrix::zero(size, &mut storage);
    term.tangent(&at.local(), w, &mut k);
    DMatrix::from_fn(size, size, |i, j| k.get(i.max(j), i.min(j)))
}

/// The stiffness of what the increment z = (dq, dλ) causes, and of so much more load.
pub(crate) fn stress_stiffness(term: &dyn Term, at: &Sample, z: &DVector<f64>, load: f64) -> DMatrix<f64> {
    let (n, size) = (at.q.len(), z.len());
    let zeros = DVector::zeros(n);
    let (q, lambda) = z.as_slice().split_at(n);
    let by = Local { q, v: zeros.as_slice(), a: zeros.as_slice(), lambda, t: 0.0, load };
    let mut storage = [0.0; LOCAL * LOCAL];
    let mut k = LocalMatrix::zero(size, &mut storage);
    term.stress_stiffness(&at.local(), &by, &mut k);
    DMatrix::from_fn(size, size, |i, j| k.get(i.max(j), i.min(j)))
}

pub(crate) fn energy(term: &dyn Term, at: &Sample) -> Energy {
    term.energy(&at.local())
}

/// f'(0) of a polynomial of degree four at most, exact but for rounding.
pub(crate) fn derivative(f: impl Fn(f64) -> DVector<f64>) -> DVector<f64> {
    let difference = |h: f64| f(h) - f(-h);
    (difference(0.5) * 8.0 - difference(1.0)) / 6.0
}

/// f'(0) of a smooth function: central differences of five steps, from 1/50 down to 1/800, extrapolated to step zero.
/// With the next singularity of f at a distance of 0.1, the error is 10⁻¹³ of f, like that of rounding. Source: Richardson (1911).
pub(crate) fn extrapolated_derivative(f: impl Fn(f64) -> DVector<f64>) -> DVector<f64> {
    let difference = |h: f64| (f(h) - f(-h)) / (2.0 * h);
    let mut row: Vec<_> = (0..5).map(|k| difference(0.02 / f64::from(1 << k))).collect();
    for order in 1..5 {
        let power = f64::from(1 << (2 * order));
        row = row.windows(2).map(|pair| (&pair[1] * power - &pair[0]) / (power - 1.0)).collect();
    }
    row.remove(0)
}
