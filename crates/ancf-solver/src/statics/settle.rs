use crate::equations::{EquationsOfMotion, State, Weights};
use crate::newton::{Failure, Linear, Mover, Newton, SolveError};

/// Iterations that may gain less than a half each.
const PATIENCE: u32 = 100;

/// Moves coordinates only: the mass in the matrix brings no accelerations.
struct AtRest;

impl Mover for AtRest {
    fn go(&mut self, at: Linear<'_>, s: &mut State, _: Weights) -> Result<(), Failure> {
        s.add(at.z, Weights::STIFFNESS);
        Ok(())
    }
}

/// Iterates a state to an equilibrium under its load that only the load may hold, such as that of a pendulum.
///
/// Newton's method with K + ω² M for the stiffness K, which is singular as long as nothing is loaded: motions that are much
/// slower than the circular frequency `rate` creep to where the load leads, the others arrive at once.
///
/// # Errors
/// If it finds none, such as that of a body that falls.
pub fn settle(
    eom: &dyn EquationsOfMotion,
    newton: &mut Newton,
    s: &mut State,
    rate: f64,
) -> Result<(), SolveError> {
    let weights = Weights { a: rate * rate, ..Weights::STIFFNESS };
    newton.bear(PATIENCE);
    let report = newton.solve_by(&mut AtRest, eom, s, weights)?;
    eom.inadmissible(s).map_or(Ok(()), |worst| Err(SolveError::after(report, s.t, Failure::Inverted, worst)))
}
