use std::ops::Range;

use super::energy::{Energy, Level, Power};
use super::state::Weights;

/// The largest number of unknowns (coordinates and multipliers) of one term: local arrays live on the stack.
pub const LOCAL: usize = 64;

/// The part of a state that a term sees: its own coordinates and multipliers, in its own order.
#[derive(Clone, Copy, Debug)]
pub struct Local<'a> {
    /// Coordinates.
    pub q: &'a [f64],
    /// Velocities.
    pub v: &'a [f64],
    /// Accelerations.
    pub a: &'a [f64],
    /// Multipliers.
    pub lambda: &'a [f64],
    /// Time.
    pub t: f64,
    /// Load factor: a load acts so many times.
    pub load: f64,
}

/// A small symmetric matrix over the coordinates, then the multipliers, of a term: the lower triangle, i ≥ j, by columns.
#[derive(Debug)]
pub struct LocalMatrix<'a> {
    size: usize,
    values: &'a mut [f64],
}

impl<'a> LocalMatrix<'a> {
    /// A zero matrix of `size` rows in `storage`, which holds at least size (size + 1)/2 numbers.
    pub fn zero(size: usize, storage: &'a mut [f64]) -> Self {
        let values = &mut storage[..size * (size + 1) / 2];
        values.fill(0.0);
        Self { size, values }
    }

    /// Adds to entry (i, j), i ≥ j.
    pub fn add(&mut self, i: usize, j: usize, value: f64) {
        debug_assert!(i >= j && i < self.size, "only the lower triangle counts");
        self.values[self.at(i, j)] += value;
    }

    /// Entry (i, j), i ≥ j.
    pub fn get(&self, i: usize, j: usize) -> f64 {
        self.values[self.at(i, j)]
    }

    /// The lower triangle by columns.
    pub fn lower(&self) -> &[f64] {
        self.values
    }

    /// Where entry (i, j) is: column j ends with row n − 1 at (j + 1) n − j (j + 1)/2 − 1.
    const fn at(&self, i: usize, j: usize) -> usize {
        j * self.size - j * (j + 1) / 2 + i
    }

    /// Subtracts another matrix of its size.
    fn subtract(&mut self, other: &LocalMatrix<'_>) {
        self.values.iter_mut().zip(&*other.values).for_each(|(value, other)| *value -= other);
    }
}

/// One local share of the equations of motion: an element, one equation of a joint, a load.
///
/// A term is immutable; it adds nothing but depends on nothing beyond the coordinates and multipliers that it names.
/// What every term must obey (tangent = ∂residual, residual = ∂energy) is checked by `tests/it/terms/laws.rs`.
///
/// A spring between coordinate 3 and the ground, complete:
///
/// ```
/// use ancf::system::{Energy, Local, LocalMatrix, Term, Weights};
///
/// struct Spring {
///     stiffness: f64,
/// }
///
/// impl Term for Spring {
///     fn coordinates(&self) -> &[usize] {
///         &[3]
///     }
///     fn residual(&self, at: &Local, r: &mut [f64]) {
///         r[0] += self.stiffness * at.q[0];
///     }
///     fn rounding(&self, at: &Local, floor: &mut [f64]) {
///         floor[0] += f64::EPSILON * (self.stiffness * at.q[0]).abs();
///     }
///     fn tangent(&self, _: &Local, w: Weights, k: &mut LocalMatrix) {
///         k.add(0, 0, w.q * self.stiffness);
///     }
///     fn energy(&self, at: &Local) -> Energy {
///         Energy { strain: 0.5 * self.stiffness * at.q[0].powi(2), ..Energy::default() }
///     }
/// }
/// ```
pub trait Term: Send + Sync {
    /// Its coordinates, each once.
    fn coordinates(&self) -> &[usize];

    /// Its multipliers.
    fn multipliers(&self) -> Range<usize> {
        0..0
    }

    /// Adds its share of the residual: rows of its coordinates, then of its multipliers.
    fn residual(&self, at: &Local<'_>, r: &mut [f64]);

    /// Adds a bound of the rounding error in its share of the residual.
    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]);

    /// Adds its share of the tangent, the lower triangle.
    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>);

    /// Those of its coordinates that have no mass and that its multipliers determine, as they do the position of a slider.
    ///
    /// They are eliminated after these multipliers, whose other coordinates must have mass or stiffness.
    fn massless(&self) -> &[usize] {
        &[]
    }

    /// Adds ċ(t) and c̈(t) of constraints A(q) + c(t) that depend on time, one for each of its multipliers.
    ///
    /// The residual holds c(t) itself.
    fn drive(&self, _t: f64, _rates: &mut [f64], _accelerations: &mut [f64]) {}

    /// Adds its constraints Φ = A(q) + c(t) at a level, one for each of its multipliers.
    ///
    /// By default A is taken to be at most quadratic, so that its derivatives along v are exactly its differences:
    /// A_q v = ½ [A(q + v) − A(q − v)], (A_q v)_q v = A(q + v) − 2A(q) + A(q − v). Other constraints tell their own.
    fn constraints(&self, at: &Local<'_>, level: Level, phi: &mut [f64]) {
        let m = at.lambda.len();
        let (mut rates, mut accelerations) = ([0.0; LOCAL], [0.0; LOCAL]);
        self.drive(at.t, &mut rates[..m], &mut accelerations[..m]);
        let here = |sign| constraints_ahead(self, at, sign);
        match level {
            Level::Position => {
                let here = here(0.0);
                (0..m).for_each(|k| phi[k] += here[k]);
            }
            Level::Velocity => {
                let (ahead, back) = (here(1.0), here(-1.0));
                (0..m).for_each(|k| phi[k] += 0.5 * (ahead[k] - back[k]) + rates[k]);
            }
            Level::Acceleration => {
                let (ahead, here, back) = (here(1.0), here(0.0), here(-1.0));
                (0..m).for_each(|k| phi[k] += ahead[k] - 2.0 * here[k] + back[k] + accelerations[k]);
            }
        }
    }

    /// What its k-th constraint ties, in words: "position along x".
    fn tie(&self, k: usize) -> String {
        format!("equation {}", k + 1)
    }

    /// Whether matter can be in this state: not turned inside out, not off the beam on which it slides.
    fn is_admissible(&self, _at: &Local<'_>) -> bool {
        true
    }

    /// Adds the stiffness of initial stresses, the lower triangle: of those stresses, multipliers and loads that come in first
    /// order with the increment `by` of the state's q, λ and load factor, at the configuration of the state.
    ///
    /// With stresses n = ∂U/∂ε of strains ε(q) the entries are Σ n₁ ∂²ε/∂q², n₁ = ∂n/∂ε ∂ε/∂q q₁; with multipliers
    /// Σ λ₁ ∂²Φ/∂q²; with loads their own stiffness, times the increment of the load factor. What a displacement changes
    /// besides, Σ ∂ε/∂q ∂n/∂ε ∂²ε/∂q² q₁, has no part in it.
    ///
    /// A term that has strain energy of strains not linear in q tells its own. By default, that of multipliers and loads:
    /// the tangent is affine in them, and its part without them is subtracted.
    fn stress_stiffness(&self, at: &Local<'_>, by: &Local<'_>, k: &mut LocalMatrix<'_>) {
        let (zeros, mut storage) = ([0.0; LOCAL], [0.0; LOCAL * LOCAL]);
        let mut rest = LocalMatrix::zero(at.q.len() + at.lambda.len(), &mut storage);
        let lambda = &zeros[..at.lambda.len()];
        self.tangent(&Local { lambda, load: 0.0, ..*at }, Weights::STIFFNESS, &mut rest);
        self.tangent(&Local { lambda: by.lambda, load: by.load, ..*at }, Weights::STIFFNESS, k);
        k.subtract(&rest);
    }

    /// Its energies.
    fn energy(&self, _at: &Local<'_>) -> Energy {
        Energy::default()
    }

    /// The power that it supplies without having it in its potential, and the power that it dissipates.
    ///
    /// By default prescribed motions supply λ·ċ(t), and what depends on the velocities dissipates: v·[f(q, v) − f(q, 0)].
    fn power(&self, at: &Local<'_>) -> Power {
        Power { work: driven(self, at), dissipation: dissipated(self, at) }
    }
}

/// The power of its prescribed motions: Φ_qᵀ λ does the work −λ·Φ_q v = λ·ċ on the bodies.
fn driven<T: Term + ?Sized>(term: &T, at: &Local<'_>) -> f64 {
    let (mut rates, mut accelerations) = ([0.0; LOCAL], [0.0; LOCAL]);
    let m = at.lambda.len();
    term.drive(at.t, &mut rates[..m], &mut accelerations[..m]);
    at.lambda.iter().zip(rates).map(|(lambda, rate)| lambda * rate).sum()
}

/// The power of forces that depend on the velocities, v·[f(q, v) − f(q, 0)].
pub fn dissipated<T: Term + ?Sized>(term: &T, at: &Local<'_>) -> f64 {
    let (zeros, n, m) = ([0.0; LOCAL], at.q.len(), at.lambda.len());
    let (mut moving, mut still) = ([0.0; LOCAL], [0.0; LOCAL]);
    term.residual(&Local { a: &zeros[..n], ..*at }, &mut moving[..n + m]);
    term.residual(&Local { v: &zeros[..n], a: &zeros[..n], ..*at }, &mut still[..n + m]);
    (0..n).map(|i| at.v[i] * (moving[i] - still[i])).sum()
}

/// What a load supplies that has no potential: −v·f.
pub fn supplied<T: Term + ?Sized>(load: &T, at: &Local<'_>) -> Power {
    let (zeros, mut r, n) = ([0.0; LOCAL], [0.0; LOCAL], at.q.len());
    load.residual(&Local { a: &zeros[..n], ..*at }, &mut r[..n]);
    Power { work: -at.v.iter().zip(r).map(|(v, r)| v * r).sum::<f64>(), dissipation: 0.0 }
}

/// Rows of a term's multipliers at q + sign × v.
fn constraints_ahead<T: Term + ?Sized>(term: &T, at: &Local<'_>, sign: f64) -> [f64; LOCAL] {
    let (mut q, mut rows) = ([0.0; LOCAL], [0.0; LOCAL]);
    let (n, m) = (at.q.len(), at.lambda.len());
    for i in 0..n {
        q[i] = at.q[i] + sign * at.v[i];
    }
    term.residual(&Local { q: &q[..n], ..*at }, &mut rows[..n + m]);
    rows.copy_within(n..n + m, 0);
    rows
}
