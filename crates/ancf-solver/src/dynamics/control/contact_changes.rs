use crate::equations::{ActivePair, EquationsOfMotion, State, Weights};
use crate::factor::Factor;
use crate::newton::{SolveError, SolveFailure};
use crate::sparse::SparseMatrix;

/// Contacts that open or close within a step.
///
/// The filter of [`ErrorEstimate`](super::error_estimate::ErrorEstimate) takes contacts for stiff springs, whose
/// vibrations a step need not resolve. An impact, however, changes the velocities for good. The forces of the pairs that
/// act at one end of the step only, or only between its ends, are therefore unfiltered:
///
/// [S₀, Φ_qᵀ; Φ_q, 0] (x, ·) = (ΔC, 0),   e = ½ h² ‖x‖,
///
/// where ΔC is the change of their forces, and the matrix S₀ does not contain these pairs. A force that sets in within
/// the step has at most this error in position, with a velocity error of h ‖x‖.
pub(super) struct ContactChanges<E> {
    /// Equations without the pairs that change, and those with all pairs that act in the middle and in passing.
    without: E,
    between: Vec<(f64, State, Option<E>)>,
    matrix: SparseMatrix,
}

impl<E: EquationsOfMotion> ContactChanges<E> {
    /// Finds the changes between two states of a step h, or returns `None` if there are none.
    pub(super) fn new(eom: &E, from: &State, to: &State) -> Result<Option<Self>, SolveError> {
        let (Some(before), Some(after)) = (eom.acting_pairs(from), eom.acting_pairs(to)) else {
            return Ok(None);
        };
        let lasting: Vec<ActivePair> =
            before.iter().filter(|pair| after.binary_search(pair).is_ok()).copied().collect();
        let mut is_changed = before != after;
        let mut between = Vec::new();
        let passing = eom.passing(from, to).map(|part| (part, on_line(from, to, part)));
        for (part, state) in [(0.5, State::middle_of_step(from, to))].into_iter().chain(passing) {
            let extended = eom.with_active_terms(&state).map(|(extended, _)| extended);
            let acting = extended.as_ref().unwrap_or(eom).acting_pairs(&state).unwrap_or_default();
            if acting.iter().any(|pair| lasting.binary_search(pair).is_err()) {
                is_changed = true;
                between.push((part, state, extended));
            }
        }
        if !is_changed {
            return Ok(None);
        }
        let Some((without, matrix)) = eom.with_pairs(&lasting) else { return Ok(None) };
        Ok(Some(Self { without, between, matrix }))
    }

    /// Calls `visit` with the acceleration x of each force change.
    pub(super) fn accelerations(
        &mut self,
        eom: &E,
        [from, to]: [&State; 2],
        w: Weights,
        mut visit: impl FnMut(&[f64]),
    ) -> Result<(), SolveError> {
        let n = to.q.len();
        let ends = [from, to].map(|s| self.forces(eom, s));
        let mut changes: Vec<Vec<f64>> = vec![difference(&ends[1], &ends[0])];
        for (part, state, extended) in &self.between {
            let line: Vec<f64> = ends[0].iter().zip(&ends[1]).map(|(a, b)| a + part * (b - a)).collect();
            changes.push(difference(&self.forces(extended.as_ref().unwrap_or(eom), state), &line));
        }
        self.without.tangent(to, w, &mut self.matrix);
        changes.iter_mut().for_each(|change| change.truncate(n));
        unfiltered_accelerations(&self.matrix, to, changes, &mut visit)
    }

    /// Returns the forces of the pairs that change.
    fn forces(&self, eom: &E, s: &State) -> Vec<f64> {
        let mut all = vec![0.0; s.q.len() + s.lambda.len()];
        let mut others = all.clone();
        eom.residual(s, &mut all);
        self.without.residual(s, &mut others);
        difference(&all, &others)
    }
}

/// Calls `visit` with the accelerations by force changes at a state, with an iteration matrix that does not contain their
/// terms.
pub(super) fn unfiltered_accelerations(
    matrix: &SparseMatrix,
    s: &State,
    changes: impl IntoIterator<Item = Vec<f64>>,
    visit: &mut impl FnMut(&[f64]),
) -> Result<(), SolveError> {
    let failed = |failure| SolveError::at(s.t, failure);
    let mut factor = Factor::new(matrix.pattern()).map_err(|_| failed(SolveFailure::Memory))?;
    factor.factorise(matrix).map_err(|_| failed(SolveFailure::Singular))?;
    let n = s.q.len();
    for mut x in changes {
        x.resize(n + s.lambda.len(), 0.0);
        factor.solve(matrix, &mut x).map_err(|_| failed(SolveFailure::Singular))?;
        visit(&x[..n]);
    }
    Ok(())
}

fn difference(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

/// Returns a state on the straight line between two states.
fn on_line(from: &State, to: &State, part: f64) -> State {
    let mut s = to.clone();
    for i in 0..s.q.len() {
        s.q[i] = from.q[i] + part * (to.q[i] - from.q[i]);
        s.v[i] = from.v[i] + part * (to.v[i] - from.v[i]);
    }
    s.t = from.t + part * (to.t - from.t);
    s
}
