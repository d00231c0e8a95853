use super::error::SolveFailure;
use crate::equations::{EquationsOfMotion, State, Weights};
use crate::factor::Factor;
use crate::sparse::SparseMatrix;
use crate::vectors::for_each_chunk;

/// Solved linear system of a Newton iteration, K z = −r.
pub(crate) struct LinearSolution<'a> {
    pub(crate) eom: &'a dyn EquationsOfMotion,
    /// Tangent K.
    pub(crate) matrix: &'a SparseMatrix,
    /// Factors of K.
    pub(crate) factor: &'a mut Factor,
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

/// Update by the largest of the parts 1, ½, ¼, .. of the increment that leads to an admissible state with a finite residual.
///
/// A search for the least energy along the increment is not made. The first increments of a slender beam bend it along straight tangents,
/// which stretches its axis, and the next ones remove the stretch: the work grows by (δ/L)² EA L²/EI and decreases again. A search slows
/// this down by a factor of ten.
#[derive(Debug)]
pub(crate) struct AdmissibleUpdate {
    trial: State,
    r: Vec<f64>,
    part: Vec<f64>,
}

/// Maximum number of halvings. The state after the last one is rejected by the next residual or at the end of the solution.
const HALVINGS: u32 = 8;

impl AdmissibleUpdate {
    pub(crate) fn new(s: &State) -> Self {
        let size = s.q.len() + s.lambda.len();
        Self { trial: s.clone(), r: vec![0.0; size], part: vec![0.0; size] }
    }

    /// Sets the trial state to s + αz.
    fn try_part(&mut self, alpha: f64, z: &[f64], s: &State, w: Weights) {
        for_each_chunk(&mut self.part, |range, part| {
            part.iter_mut().zip(&z[range]).for_each(|(part, z)| *part = alpha * z);
        });
        self.trial.copy_from(s);
        self.trial.add(&self.part, w);
    }

    /// Returns true if the trial state is admissible with a finite residual.
    fn is_admissible(&mut self, eom: &dyn EquationsOfMotion) -> bool {
        if eom.inadmissible(&self.trial).is_some() {
            return false;
        }
        eom.residual(&self.trial, &mut self.r);
        self.r.iter().all(|r| r.is_finite())
    }
}

impl StateUpdate for AdmissibleUpdate {
    fn apply(&mut self, at: LinearSolution<'_>, s: &mut State, w: Weights) -> Result<(), SolveFailure> {
        let mut alpha = 1.0;
        self.try_part(alpha, at.z, s, w);
        for _ in 0..HALVINGS {
            if self.is_admissible(at.eom) {
                break;
            }
            alpha *= 0.5;
            self.try_part(alpha, at.z, s, w);
        }
        s.copy_from(&self.trial);
        Ok(())
    }
}
