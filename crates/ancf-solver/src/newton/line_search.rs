use super::error::Failure;
use crate::equations::{EquationsOfMotion, State, Weights};
use crate::factor::Factor;
use crate::sparse::SparseMatrix;

/// A linear system that Newton's method has just solved: K z = −r.
pub(crate) struct Linear<'a> {
    pub(crate) eom: &'a dyn EquationsOfMotion,
    /// K.
    pub(crate) matrix: &'a SparseMatrix,
    /// Its factors.
    pub(crate) factor: &'a mut Factor,
    /// The residual r before the increment.
    pub(crate) r: &'a [f64],
    /// The increment z.
    pub(crate) z: &'a mut [f64],
}

/// How Newton's method moves a state by an increment.
pub(crate) trait Mover {
    /// Moves the state; `z` stays what a whole increment would be, for the stopping rule to judge.
    fn go(&mut self, at: Linear<'_>, s: &mut State, w: Weights) -> Result<(), Failure>;
}

/// By the whole increment.
pub(crate) struct Whole;

impl Mover for Whole {
    fn go(&mut self, at: Linear<'_>, s: &mut State, w: Weights) -> Result<(), Failure> {
        s.add(at.z, w);
        Ok(())
    }
}

/// By the part α ≤ 1 of the increment to which a line search leads.
///
/// G(α) = z·r(s + αz) vanishes where the energy is stationary along z. The increment is taken as a whole if
/// |G(1)| ≤ ρ|G(0)|; if not, α follows from the model G(0)(1 − α + cα²), which has the slope of Newton's method at 0 and
/// the work found at the last α. States that matter cannot be in, or whose residual is not finite, halve α.
///
/// Source: Crisfield (1982); Bonet & Wood (2008), section 9.6.2, with ρ = 0.8 and 0.5. See [`RATIO`] for why not here.
#[derive(Debug)]
pub(crate) struct LineSearch {
    trial: State,
    r: Vec<f64>,
    part: Vec<f64>,
}

/// ρ. The first increments of a slender beam bend it along straight tangents, which stretches its axis, and the next
/// ones take the stretch back: G grows by (δ/L)² EA L²/EI and falls again. A search that forbids the detour pays for it:
/// PL²/EI = 10 takes 19 iterations without it and 200 with ρ = 1. This one stops only what is beyond a wire of L/d = 1000.
const RATIO: f64 = 1e8;
/// The most values of α.
const TRIALS: u32 = 8;

impl LineSearch {
    pub(crate) fn new(s: &State) -> Self {
        let size = s.q.len() + s.lambda.len();
        Self { trial: s.clone(), r: vec![0.0; size], part: vec![0.0; size] }
    }

    /// Sets `part` to αz and the trial state to s + αz.
    fn try_part(&mut self, alpha: f64, z: &[f64], s: &State, w: Weights) {
        for (part, z) in self.part.iter_mut().zip(z) {
            *part = alpha * z;
        }
        self.trial.copy_from(s);
        self.trial.add(&self.part, w);
    }

    /// The work z·r in the trial state, if matter can be in it.
    fn work(&mut self, eom: &dyn EquationsOfMotion, z: &[f64]) -> Option<f64> {
        if eom.inadmissible(&self.trial).is_some() {
            return None;
        }
        eom.residual(&self.trial, &mut self.r);
        Some(dot(z, &self.r)).filter(|work| work.is_finite())
    }
}

impl Mover for LineSearch {
    fn go(&mut self, at: Linear<'_>, s: &mut State, w: Weights) -> Result<(), Failure> {
        let (start, mut alpha) = (dot(at.z, at.r), 1.0);
        self.try_part(alpha, at.z, s, w);
        for _ in 0..TRIALS {
            alpha = match self.work(at.eom, at.z) {
                Some(work) if work.abs() <= RATIO * start.abs() => break,
                Some(work) => stationary(alpha, work / start).clamp(0.1 * alpha, 0.5 * alpha),
                None => 0.5 * alpha,
            };
            self.try_part(alpha, at.z, s, w);
        }
        s.copy_from(&self.trial);
        Ok(())
    }
}

/// Where 1 − α + cα² vanishes first, or is least if it does not, with c such that it is `ratio` at `alpha`.
fn stationary(alpha: f64, ratio: f64) -> f64 {
    let c = (ratio - 1.0 + alpha) / (alpha * alpha);
    if c < 0.25 { 2.0 / (1.0 + (1.0 - 4.0 * c).sqrt()) } else { 0.5 / c }
}

/// x·y, in eight sums: one would wait for each addition.
pub(crate) fn dot(x: &[f64], y: &[f64]) -> f64 {
    let ((x, of_x), (y, of_y)) = (x.as_chunks::<8>(), y.as_chunks::<8>());
    let mut sums = [0.0; 8];
    for (x, y) in x.iter().zip(y) {
        (0..8).for_each(|i| sums[i] += x[i] * y[i]);
    }
    let rest: f64 = of_x.iter().zip(of_y).map(|(x, y)| x * y).sum();
    sums.iter().sum::<f64>() + rest
}
