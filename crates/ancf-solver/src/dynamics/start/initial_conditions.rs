use crate::dynamics::scheme::SchemeCoefficients;
use crate::equations::{EquationsOfMotion, Level, State, Weights};
use crate::factor::Factor;
use crate::newton::{SolveError, SolveFailure};
use crate::sparse::SparseMatrix;

/// Computes the accelerations and multipliers that satisfy the equations of motion at given q and v.
///
/// [M, Φ_qᵀ; Φ_q, 0] (v̇, λ) = −(f, (Φ_q v)_q v + Φ_tt).
///
/// # Errors
/// If the matrix is singular.
pub fn consistent_accelerations<E: EquationsOfMotion>(
    eom: &E,
    matrix: &mut SparseMatrix,
    s: &mut State,
) -> Result<(), SolveError> {
    let (mut factor, mut rhs) = storage(matrix)?;
    accelerations(eom, matrix, &mut factor, s, &mut rhs, Factors::OfOtherState)
}

/// Projects the velocities onto Φ_q v + Φ_t = 0 in the norm of the kinetic energy.
///
/// [M, Φ_qᵀ; Φ_q, 0] (Δv, μ) = −(0, Φ_q v + Φ_t). Consistent velocities remain unchanged.
///
/// # Errors
/// If the matrix is singular.
pub fn consistent_velocities<E: EquationsOfMotion>(
    eom: &E,
    matrix: &mut SparseMatrix,
    s: &mut State,
) -> Result<(), SolveError> {
    let (mut factor, mut rhs) = storage(matrix)?;
    project(eom, matrix, &mut factor, s, Projected::Velocities, &mut rhs).map(|_| ())
}

/// Removes the error of order h² of the velocities along constraints at the end of steps h of a scheme.
///
/// [S, Φ_qᵀ; Φ_q, 0] (Δv, ·) = −(0, Φ_q v + Φ_t) with the iteration matrix S of the steps. A projection in the norm of the kinetic
/// energy would change light coordinates, such as slopes, and with them the strain rates of damped sections.
///
/// # Errors
/// If the matrix is singular. The state is then unchanged.
pub fn remove_velocity_error<E: EquationsOfMotion>(
    eom: &E,
    matrix: &mut SparseMatrix,
    s: &mut State,
    (scheme, h): (SchemeCoefficients, f64),
) -> Result<(), SolveError> {
    let (mut factor, mut rhs) = storage(matrix)?;
    let part = Projected::SlowVelocities(scheme.weights(h));
    project(eom, matrix, &mut factor, s, part, &mut rhs).map(|_| ())
}

/// Largest number of iterations of a projection of positions.
const MAX_PROJECTIONS: u32 = 30;
/// Change at which a projection ends, and change below which a slow decrease is one of rounding errors, relative to the length.
const PROJECTED: f64 = 1e-13;
const ROUGH: f64 = 1e-9;

/// Projects the positions onto Φ = 0 in the norm of the kinetic energy, by Newton's method.
///
/// The iteration ends at changes that are small relative to `length`, or at rounding errors.
///
/// # Errors
/// If the matrix is singular, or the iteration does not converge.
pub fn consistent_positions<E: EquationsOfMotion>(
    eom: &E,
    matrix: &mut SparseMatrix,
    s: &mut State,
    length: f64,
) -> Result<(), SolveError> {
    let (mut factor, mut rhs) = storage(matrix)?;
    let mut last = f64::INFINITY;
    for _ in 0..MAX_PROJECTIONS {
        project(eom, matrix, &mut factor, s, Projected::Positions, &mut rhs)?;
        let change = rhs[..s.q.len()].iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
        let is_rounding = change < ROUGH * length && change >= 0.5 * last;
        if change <= PROJECTED * length || is_rounding {
            return Ok(());
        }
        last = change;
    }
    Err(SolveError::at(s.t, SolveFailure::NotConverged))
}

/// Allocates a factorisation and a right-hand side.
fn storage(matrix: &SparseMatrix) -> Result<(Factor, Vec<f64>), SolveError> {
    let factor = Factor::new(matrix.pattern()).map_err(|_| SolveError::at_start(SolveFailure::Memory))?;
    Ok((factor, vec![0.0; matrix.pattern().size()]))
}

/// Computes consistent accelerations as [`consistent_accelerations`], in given working storage.
pub(crate) fn accelerations<E: EquationsOfMotion + ?Sized>(
    eom: &E,
    matrix: &mut SparseMatrix,
    factor: &mut Factor,
    s: &mut State,
    rhs: &mut [f64],
    factors: Factors,
) -> Result<(), SolveError> {
    let n = s.q.len();
    s.a.fill(0.0);
    s.lambda.fill(0.0);
    eom.residual(s, rhs);
    eom.constraints(s, Level::Acceleration, &mut rhs[n..]);
    rhs.iter_mut().for_each(|x| *x = -*x);
    match factors {
        Factors::OfState => solve_again(matrix, factor, s, rhs)?,
        Factors::OfOtherState => solve(eom, matrix, factor, s, Weights::MASS, rhs)?,
    }
    s.a.copy_from_slice(&rhs[..n]);
    s.lambda.copy_from_slice(&rhs[n..]);
    if eom.observes_multipliers() {
        correct_observed(eom, matrix, factor, s, rhs)?;
    }
    Ok(())
}

/// Largest number of corrections by forces that depend on multipliers, and their relative size at the end.
const MAX_CORRECTIONS: u32 = 100;
const CORRECTED: f64 = 1e-14;

/// Corrects accelerations and multipliers until they agree with the forces that depend on the multipliers.
///
/// The corrections decrease by a constant factor. They end where they increase, as in a joint that is self-locking.
fn correct_observed<E: EquationsOfMotion + ?Sized>(
    eom: &E,
    matrix: &SparseMatrix,
    factor: &mut Factor,
    s: &mut State,
    rhs: &mut [f64],
) -> Result<(), SolveError> {
    let n = s.q.len();
    let largest = |x: &[f64]| x.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
    let mut last = f64::INFINITY;
    for _ in 0..MAX_CORRECTIONS {
        eom.residual(s, rhs);
        rhs[n..].fill(0.0);
        rhs.iter_mut().for_each(|x| *x = -*x);
        solve_again(matrix, factor, s, rhs)?;
        let change = largest(&rhs[n..]);
        if change >= last {
            break;
        }
        s.a.iter_mut().zip(&rhs[..n]).for_each(|(a, by)| *a += by);
        s.lambda.iter_mut().zip(&rhs[n..]).for_each(|(lambda, by)| *lambda += by);
        if change <= CORRECTED * largest(&s.lambda) {
            break;
        }
        last = change;
    }
    Ok(())
}

/// State of the factorised mass matrix with its constraints, which depends on the coordinates only.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Factors {
    OfState,
    OfOtherState,
}

/// Part of a state that is projected onto its constraints.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Projected {
    /// Positions onto Φ = 0, by one step of Newton's method.
    Positions,
    /// Positions onto Φ = 0, with the factors of the last projection of positions.
    PositionsByLastFactors,
    /// Velocities onto Φ_q v + Φ_t = 0.
    Velocities,
    /// Velocities onto Φ_q v + Φ_t = 0, with the iteration matrix of these weights in place of the mass matrix.
    SlowVelocities(Weights),
}

/// Projects a part of a state in the norm of the kinetic energy and in given working storage:
///
/// [M, Φ_qᵀ; Φ_q, 0] (Δ, ·) = −(0, Φ).
///
/// An iteration matrix in place of M avoids changes in motions that are faster than the step, whose damping forces are large.
/// States if the factors are those of the projected state.
pub(crate) fn project<E: EquationsOfMotion + ?Sized>(
    eom: &E,
    matrix: &mut SparseMatrix,
    factor: &mut Factor,
    s: &mut State,
    part: Projected,
    rhs: &mut [f64],
) -> Result<Factors, SolveError> {
    let n = s.q.len();
    let level = match part {
        Projected::Positions | Projected::PositionsByLastFactors => Level::Position,
        Projected::Velocities | Projected::SlowVelocities(_) => Level::Velocity,
    };
    rhs[..n].fill(0.0);
    eom.constraints(s, level, &mut rhs[n..]);
    if rhs.iter().all(|x| *x == 0.0) {
        return Ok(Factors::OfOtherState);
    }
    rhs.iter_mut().for_each(|x| *x = -*x);
    match part {
        Projected::Positions | Projected::Velocities => solve(eom, matrix, factor, s, Weights::MASS, rhs)?,
        Projected::PositionsByLastFactors => solve_again(matrix, factor, s, rhs)?,
        Projected::SlowVelocities(w) => solve(eom, matrix, factor, s, w, rhs)?,
    }
    let (projected, factors) = match level {
        Level::Velocity if matches!(part, Projected::Velocities) => (&mut s.v, Factors::OfState),
        Level::Velocity => (&mut s.v, Factors::OfOtherState),
        _ => (&mut s.q, Factors::OfOtherState),
    };
    projected.iter_mut().zip(&*rhs).for_each(|(x, change)| *x += change);
    Ok(factors)
}

/// Assembles and factorises the tangent of a state and solves with it.
pub(crate) fn solve<E: EquationsOfMotion + ?Sized>(
    eom: &E,
    matrix: &mut SparseMatrix,
    factor: &mut Factor,
    s: &State,
    w: Weights,
    rhs: &mut [f64],
) -> Result<(), SolveError> {
    factorise(eom, matrix, factor, s, w)?;
    solve_again(matrix, factor, s, rhs)
}

/// Computes and factorises [S, Φ_qᵀ; Φ_q, 0] with the weights `w`.
pub(crate) fn factorise<E: EquationsOfMotion + ?Sized>(
    eom: &E,
    matrix: &mut SparseMatrix,
    factor: &mut Factor,
    s: &State,
    w: Weights,
) -> Result<(), SolveError> {
    eom.tangent(s, w, matrix);
    factor.factorise(matrix).map_err(|_| SolveError::at(s.t, SolveFailure::Singular))
}

/// Solves with the matrix and the factors of the last [`solve`].
pub(crate) fn solve_again(
    matrix: &SparseMatrix,
    factor: &mut Factor,
    s: &State,
    rhs: &mut [f64],
) -> Result<(), SolveError> {
    factor.solve(matrix, rhs).map_err(|_| SolveError::at(s.t, SolveFailure::Singular))
}
