use crate::equations::{EquationsOfMotion, State, Weights};
use crate::newton::{LinearSolution, Newton, NewtonReport, SolveError, SolveFailure, StateUpdate};
use crate::sparse::SparseMatrix;

/// Stagnation limit for increments of slowly decreasing energy.
const STAGNATION_LIMIT: u32 = 100;

/// Update of coordinates only: the mass in the matrix causes no accelerations.
struct CoordinateUpdate;

impl StateUpdate for CoordinateUpdate {
    fn apply(&mut self, at: LinearSolution<'_>, s: &mut State, _: Weights) -> Result<(), SolveFailure> {
        s.add(at.z, Weights::STIFFNESS);
        Ok(())
    }
}

/// Estimates the circular frequency √(a/L) of the motions that loads stabilise over a length L, by the mean acceleration a of free
/// masses under the forces of a state. The largest frequency of several groups of coordinates, such as those of bodies, counts.
///
/// a² = Σ fᵢ²/Mᵢᵢ / Σ Mᵢᵢ. `matrix` is any matrix of the pattern of `eom`.
pub fn load_rate(
    eom: &dyn EquationsOfMotion,
    matrix: &mut SparseMatrix,
    s: &State,
    length: f64,
    groups: impl Iterator<Item = Vec<usize>>,
) -> f64 {
    eom.tangent(s, Weights::MASS, matrix);
    let mut residual = vec![0.0; s.q.len() + s.lambda.len()];
    eom.residual(s, &mut residual);
    let squared = |group: Vec<usize>| {
        let (mut squares, mut masses) = (0.0, 0.0);
        for i in group {
            let mass = matrix.diagonal_of(i);
            if mass > 0.0 {
                squares += residual[i] * residual[i] / mass;
                masses += mass;
            }
        }
        if masses > 0.0 { (squares / masses).sqrt() / length } else { 0.0 }
    };
    groups.map(squared).fold(0.0, f64::max).sqrt()
}

/// Iterates a state to an equilibrium that only the load stabilises, such as that of a pendulum.
///
/// Newton's method uses K + ω² M, since the stiffness K of the unloaded system is singular. Motions much slower than
/// the circular frequency `rate` converge slowly along the load, and all others within one iteration.
///
/// # Errors
/// If there is no equilibrium, such as for a falling body.
pub fn solve_regularised(
    eom: &dyn EquationsOfMotion,
    newton: &mut Newton,
    s: &mut State,
    rate: f64,
) -> Result<NewtonReport, SolveError> {
    let weights = Weights { a: rate * rate, ..Weights::STIFFNESS };
    newton.set_stagnation_limit(STAGNATION_LIMIT);
    let report = newton.solve_with(&mut CoordinateUpdate, eom, s, weights)?;
    eom.inadmissible(s).map_or(Ok(report), |(worst, reason)| {
        Err(SolveError::after(report, s.t, SolveFailure::Inadmissible(reason), worst))
    })
}
