//! Random states of one term, and the evaluation of the term at them.

use ancf::solver::equations::{Energy, LOCAL, Local, LocalMatrix, Term, Weights};
use nalgebra::{DMatrix, DVector};

use super::random::Random;

/// Unknowns of one term.
#[derive(Clone)]
pub(crate) struct Sample {
    pub(crate) q: DVector<f64>,
    pub(crate) v: DVector<f64>,
    pub(crate) a: DVector<f64>,
    pub(crate) lambda: DVector<f64>,
}

impl Sample {
    /// Random unknowns.
    pub(crate) fn random(term: &dyn Term, random: &mut Random) -> Self {
        let (n, m) = sizes(term);
        Self { q: random.vector(n), v: random.vector(n), a: random.vector(n), lambda: random.vector(m) }
    }

    /// Undeformed state at rest.
    pub(crate) fn rest(term: &dyn Term) -> Self {
        let (n, m) = sizes(term);
        Self { q: DVector::zeros(n), v: DVector::zeros(n), a: DVector::zeros(n), lambda: DVector::zeros(m) }
    }

    /// View for the evaluation of a term, at t = 0.3 and load factor 0.7.
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

    /// State moved by h (dz, dλ), with dz weighted for q, v and a.
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

/// Returns the numbers of coordinates and multipliers.
pub(crate) fn sizes(term: &dyn Term) -> (usize, usize) {
    (term.coordinates().len(), term.multipliers().len())
}

/// Evaluates the residual.
pub(crate) fn residual(term: &dyn Term, at: &Sample) -> DVector<f64> {
    let mut r = DVector::zeros(at.q.len() + at.lambda.len());
    term.residual(&at.local(), r.as_mut_slice());
    r
}

/// Evaluates the rounding bound of the residual.
pub(crate) fn rounding(term: &dyn Term, at: &Sample) -> DVector<f64> {
    let mut floor = DVector::zeros(at.q.len() + at.lambda.len());
    term.rounding(&at.local(), floor.as_mut_slice());
    floor
}

/// Evaluates the tangent matrix.
pub(crate) fn tangent(term: &dyn Term, at: &Sample, w: Weights) -> DMatrix<f64> {
    let size = at.q.len() + at.lambda.len();
    let mut storage = [0.0; LOCAL * LOCAL];
    let mut k = LocalMatrix::zero(size, &mut storage);
    term.tangent(&at.local(), w, &mut k);
    DMatrix::from_fn(size, size, |i, j| k.get(i.max(j), i.min(j)))
}

/// Evaluates the change of the stiffness by the stresses that a linear system at another state predicts.
pub(crate) fn stress_prediction(term: &dyn Term, at: &Sample, from: &Sample) -> DMatrix<f64> {
    let size = at.q.len() + at.lambda.len();
    let mut storage = [0.0; LOCAL * LOCAL];
    let mut k = LocalMatrix::zero(size, &mut storage);
    term.stress_prediction(&at.local(), &from.local(), &mut k);
    DMatrix::from_fn(size, size, |i, j| k.get(i.max(j), i.min(j)))
}

/// Evaluates the stiffness caused by the stresses of an increment z = (dq, dλ) and of a load increment.
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

/// Evaluates the energy.
pub(crate) fn energy(term: &dyn Term, at: &Sample) -> Energy {
    term.energy(&at.local())
}

/// Returns the derivative f'(0) of a polynomial of degree four at most, exact to rounding.
pub(crate) fn derivative(f: impl Fn(f64) -> DVector<f64>) -> DVector<f64> {
    let difference = |h: f64| f(h) - f(-h);
    (difference(0.5) * 8.0 - difference(1.0)) / 6.0
}

/// Returns the derivative f'(0) of a smooth function: central differences with five steps from 1/50 to 1/800, extrapolated to zero.
///
/// The relative error is 10⁻¹³ if the next singularity of f is at a distance of 0.1. Source: Richardson (1911).
pub(crate) fn extrapolated_derivative(f: impl Fn(f64) -> DVector<f64>) -> DVector<f64> {
    let difference = |h: f64| (f(h) - f(-h)) / (2.0 * h);
    let mut row: Vec<_> = (0..5).map(|k| difference(0.02 / f64::from(1 << k))).collect();
    for order in 1..5 {
        let power = f64::from(1 << (2 * order));
        row = row.windows(2).map(|pair| (&pair[1] * power - &pair[0]) / (power - 1.0)).collect();
    }
    row.remove(0)
}
