use super::stability::unstable_directions;
use crate::equations::{Energy, EquationsOfMotion, Inadmissibility, Rotation, State, Weights};
use crate::newton::{Newton, NewtonReport, SolveError, SolveFailure, StateUpdate};

/// Report of an equilibrium solution.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Equilibrium {
    /// Number of Newton iterations, including failed attempts.
    pub iterations: u32,
    /// Number of attempted increments. It is 1 unless an attempt failed.
    pub attempts: u32,
    /// Euclidean norm of the last residual that was evaluated.
    pub residual: f64,
    /// Euclidean norm of the last increment of the coordinates.
    pub increment: f64,
    /// True if the iteration ended at the rounding error of the residual.
    pub floor: bool,
    /// Number of unstable directions, from the last factorised matrix.
    ///
    /// These are the negative eigenvalues of the stiffness on the motions permitted by the constraints. `None` if the
    /// factors do not provide the inertia, or if it is indefinite with loads without a potential.
    pub unstable: Option<usize>,
    /// Energies of the equilibrium.
    pub energy: Energy,
}

impl Equilibrium {
    /// Iterates a state to equilibrium. Rejects inadmissible states.
    pub(crate) fn find(
        newton: &mut Newton,
        update: &mut dyn StateUpdate,
        eom: &dyn EquationsOfMotion,
        s: &mut State,
    ) -> Result<Self, SolveError> {
        let mut report = newton.solve_with(update, eom, s, Weights::STIFFNESS)?;
        if report.iterations == 1 {
            // The first increment of a mechanism may have negligible energy compared with the state that it leads to.
            let repeated = newton.solve_with(update, eom, s, Weights::STIFFNESS)?;
            report = NewtonReport { iterations: 1 + repeated.iterations, ..repeated };
        }
        if let Some((worst, reason)) = eom.inadmissible(s) {
            return Err(SolveError::after(report, s.t, SolveFailure::Inadmissible(reason), worst));
        }
        let NewtonReport { iterations, residual, increment, floor } = report;
        let (matrix, factor) = newton.tangent.lend();
        let (unstable, energy) = (unstable_directions(eom, s, matrix, factor), eom.energy(s));
        Ok(Self { iterations, attempts: 1, residual, increment, floor, unstable, energy })
    }

    /// Creates the error that rejects this equilibrium.
    pub(crate) fn reject(&self, failure: SolveFailure, s: &State) -> SolveError {
        let Self { iterations, residual, increment, floor, .. } = *self;
        SolveError::after(NewtonReport { iterations, residual, increment, floor }, s.t, failure, 0)
    }

    /// Adds the cost of this attempt to that of the next one and returns the next one.
    pub(crate) fn followed_by(&self, last: Self) -> Self {
        Self {
            iterations: self.iterations + last.iterations,
            attempts: self.attempts + last.attempts,
            ..last
        }
    }

    /// Adds the cost of this solution to that of a repetition within the same attempt.
    pub(crate) fn repeated(&self, last: Self) -> Self {
        Self { iterations: self.iterations + last.iterations, ..last }
    }

    /// Adds the cost of a failed attempt.
    pub(crate) fn failed(&mut self, cause: &SolveError) {
        self.iterations += cause.iterations;
        self.attempts += 1;
    }
}

/// Rejects an equilibrium that is too far from the previous one. Returns the largest rotation relative to its limit.
///
/// The equations are also satisfied by a section that turned by whole turns, and beyond an obstacle.
pub(crate) fn check_change(
    eom: &dyn EquationsOfMotion,
    found: &Equilibrium,
    from: &State,
    to: &State,
) -> Result<f64, SolveError> {
    let reject = |failure, at| SolveError { worst: Some(at), ..found.reject(failure, to) };
    let Rotation { size, at } = eom.rotation(from, to);
    if size > 1.0 {
        return Err(reject(SolveFailure::Rotated, at));
    }
    if let Some(at) = eom.half_turn(from, to) {
        return Err(reject(SolveFailure::Inadmissible(Inadmissibility::HalfTurn), at));
    }
    eom.crossing(from, to).map_or(Ok(size), |at| Err(reject(SolveFailure::Crossed, at)))
}
