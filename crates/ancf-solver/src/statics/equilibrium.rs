use crate::equations::{Energy, EquationsOfMotion, State, Weights};
use crate::newton::{Failure, Mover, Newton, Report, SolveError};

/// How an equilibrium was found.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Equilibrium {
    /// Newton iterations, those of failed attempts included.
    pub iterations: u32,
    /// Increments that were tried, 1 unless some failed.
    pub attempts: u32,
    /// Euclidean norm of the last residual that was evaluated.
    pub residual: f64,
    /// Euclidean norm of the last increment of the coordinates.
    pub increment: f64,
    /// Whether the rounding error of the residual ended the iteration.
    pub floor: bool,
    /// Number of independent directions in which it is unstable: negative eigenvalues of the stiffness on the motions
    /// that the constraints leave, of the last matrix that was factorised. `None` if its factors do not tell.
    pub unstable: Option<usize>,
    /// Its energies.
    pub energy: Energy,
}

impl Equilibrium {
    /// Iterates a state to equilibrium and refuses one with an element inside out.
    pub(crate) fn find(
        newton: &mut Newton,
        mover: &mut dyn Mover,
        eom: &dyn EquationsOfMotion,
        s: &mut State,
    ) -> Result<Self, SolveError> {
        let mut report = newton.solve_by(mover, eom, s, Weights::STIFFNESS)?;
        if report.iterations == 1 {
            // A mechanism can fly off by an increment whose energy is nothing beside that of the state it leads to.
            let again = newton.solve_by(mover, eom, s, Weights::STIFFNESS)?;
            report = Report { iterations: 1 + again.iterations, ..again };
        }
        if let Some(worst) = eom.inadmissible(s) {
            return Err(SolveError::after(report, s.t, Failure::Inverted, worst));
        }
        let Report { iterations, residual, increment, floor } = report;
        let (unstable, energy) = (newton.unstable(eom), eom.energy(s));
        Ok(Self { iterations, attempts: 1, residual, increment, floor, unstable, energy })
    }

    /// The error that refuses this equilibrium.
    pub(crate) fn refuse(&self, failure: Failure, s: &State) -> SolveError {
        let Self { iterations, residual, increment, floor, .. } = *self;
        SolveError::after(Report { iterations, residual, increment, floor }, s.t, failure, 0)
    }

    /// Takes over the last attempt and adds up its cost.
    pub(crate) fn after(&self, last: Self) -> Self {
        Self {
            iterations: self.iterations + last.iterations,
            attempts: self.attempts + last.attempts,
            ..last
        }
    }

    /// Takes over another solution of the same attempt and adds up its cost.
    pub(crate) fn again(&self, last: Self) -> Self {
        Self { iterations: self.iterations + last.iterations, ..last }
    }

    /// Adds up the cost of an attempt that failed.
    pub(crate) fn failed(&mut self, cause: &SolveError) {
        self.iterations += cause.iterations;
        self.attempts += 1;
    }
}
