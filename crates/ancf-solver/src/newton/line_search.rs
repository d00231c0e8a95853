use super::error::SolveFailure;
use crate::equations::{EquationsOfMotion, State, Weights};
use crate::factor::Factor;
use crate::sparse::SparseMatrix;
use crate::vectors::{dot, for_each_chunk};

/// Solved linear system of a Newton iteration, K z = −r.
pub(crate) struct LinearSolution<'a> {
    pub(crate) eom: &'a dyn EquationsOfMotion,
    /// Tangent K.
    pub(crate) matrix: &'a SparseMatrix,
    /// Factors of K.
    pub(crate) factor: &'a mut Factor,
    /// Residual r before the increment.
    pub(crate) r: &'a [f64],
    /// Increment z.
    pub(crate) z: &'a mut [f64],
}

/// Update of a state by a Newton increment.
pub(crate) trait StateUpdate {
    /// Updates the state. On return `z` is the full increment, which the stopping rule evaluates.
    fn apply(&mut self, at: LinearSolution<'_>, s: &mut State, w: Weights) -> Result<(), SolveFailure>;
}

/// Update by the full increment.
pub(crate) struct FullUpdate;

impl StateUpdate for FullUpdate {
    fn apply(&mut self, at: LinearSolution<'_>, s: &mut State, w: Weights) -> Result<(), SolveFailure> {
        s.add(at.z, w);
        Ok(())
    }
}

/// Update by a fraction α ≤ 1 of the increment, found by a line search.
///
/// G(α) = z·r(s + αz) vanishes where the energy is stationary along z. The full increment is accepted if |G(1)| ≤
/// ρ|G(0)|. Otherwise α follows from the model G(0)(1 − α + cα²). The model has the slope of Newton's method at 0 and
/// matches the work at the last α. Inadmissible states (det J ≤ 0) and states with a residual that is not finite halve
/// α.
///
/// Source: Crisfield (1982); Bonet & Wood (2008), section 9.6.2, with ρ = 0.8 and 0.5. The larger ρ is explained at
/// [`RATIO`].
#[derive(Debug)]
pub(crate) struct LineSearch {
    trial: State,
    r: Vec<f64>,
    part: Vec<f64>,
}

/// Acceptance ratio ρ of the line search.
///
/// The first increments of a slender beam bend it along straight tangents, which stretches its axis. The next
/// increments remove the stretch: G grows by (δ/L)² EA L²/EI and decreases again. A strict search slows this down
/// by a factor of ten. This value only affects beams more slender than L/d = 1000.
const RATIO: f64 = 1e8;
/// Maximum number of trial values of α.
const TRIALS: u32 = 8;

impl LineSearch {
    pub(crate) fn new(s: &State) -> Self {
        let size = s.q.len() + s.lambda.len();
        Self { trial: s.clone(), r: vec![0.0; size], part: vec![0.0; size] }
    }

    /// Sets `part` to αz and the trial state to s + αz.
    fn try_part(&mut self, alpha: f64, z: &[f64], s: &State, w: Weights) {
        for_each_chunk(&mut self.part, |range, part| {
            part.iter_mut().zip(&z[range]).for_each(|(part, z)| *part = alpha * z);
        });
        self.trial.copy_from(s);
        self.trial.add(&self.part, w);
    }

    /// Returns the work z·r in the trial state, or `None` if the state is inadmissible.
    fn work(&mut self, eom: &dyn EquationsOfMotion, z: &[f64]) -> Option<f64> {
        if eom.inadmissible(&self.trial).is_some() {
            return None;
        }
        eom.residual(&self.trial, &mut self.r);
        Some(dot(z, &self.r)).filter(|work| work.is_finite())
    }
}

impl StateUpdate for LineSearch {
    fn apply(&mut self, at: LinearSolution<'_>, s: &mut State, w: Weights) -> Result<(), SolveFailure> {
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

/// Returns the first zero of 1 − α + cα², or else its minimum. The coefficient c gives the value `ratio` at `alpha`.
fn stationary(alpha: f64, ratio: f64) -> f64 {
    let c = (ratio - 1.0 + alpha) / (alpha * alpha);
    if c < 0.25 { 2.0 / (1.0 + (1.0 - 4.0 * c).sqrt()) } else { 0.5 / c }
}
