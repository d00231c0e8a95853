use super::initial_conditions::{solve, solve_again};
use super::rates::{Rates, filter, start_rates};
use crate::dynamics::scheme::SchemeCoefficients;
use crate::equations::{EquationsOfMotion, State, Weights};
use crate::newton::{Newton, SolveError};

/// Computes start values of the generalized-α scheme for a first step h: the auxiliary acceleration and a velocity
/// change.
///
/// The state is consistent. The auxiliary acceleration approximates a₀ = v̇₀ + (αm − αf) h v̈₀. The positions satisfy
/// Φ(q₁) = 0 in spite of the local error C h³ v̈. This requires Φ_q v = C h² Φ_q v̈, as in all later steps. Exact
/// velocities would cause errors of O(h) in the first accelerations and multipliers, which decay slowly. The iteration
/// matrix S = M + w_q K filters both corrections, so motions faster than the step remain unchanged:
///
/// [S, Φ_qᵀ; Φ_q, 0] (x, ·) = (M v̈₀, Φ_q v̈₀),   [S, Φ_qᵀ; Φ_q, 0] (y, ·) = (0, Φ_q v̈₀),
/// a₀ = v̇₀ + (αm − αf) h x,   v₀ ← v₀ + C h² y.
///
/// Source: Arnold, Brüls & Cardona (2015), on the order reduction of the first steps and perturbed start values.
pub(crate) fn start_values<E: EquationsOfMotion>(
    eom: &E,
    scheme: SchemeCoefficients,
    newton: &mut Newton,
    s: &mut State,
    start: StartValues<'_>,
    h: f64,
) -> Result<(), SolveError> {
    let (n, StartValues { auxiliary, damping }) = (s.q.len(), start);
    eom.exchange(s, damping);
    let Rates { acceleration: rate, damping: damping_rate, .. } =
        start_rates(eom, newton, s, damping, (scheme, h))?;
    start_damping(eom, scheme, newton, s, (damping, &damping_rate), h)?;
    filter(eom, newton, s, &rate, scheme.weights(h))?;
    let Newton { tangent, r, z, .. } = newton;
    let (matrix, factor) = tangent.lend();
    for i in 0..n {
        auxiliary[i] = s.a[i] + scheme.lead() * h * z[i];
    }
    z.copy_from_slice(r);
    z[..n].fill(0.0);
    solve_again(matrix, factor, s, z)?;
    for i in 0..n {
        s.v[i] += scheme.error_constant() * h * h * z[i];
    }
    Ok(())
}

/// Start values of the first step.
pub(crate) struct StartValues<'a> {
    /// Auxiliary acceleration a₀.
    pub(crate) auxiliary: &'a mut [f64],
    /// Auxiliary damping forces φ₀.
    pub(crate) damping: &'a mut [f64],
}

/// Computes the auxiliary damping forces at the start from F₀ and its rate Ḟ₀. They are the share of the damping forces
/// and of their constraint forces in −M a₀:
///
/// [S, Φ_qᵀ; Φ_q, 0] (x, μ) = (−Ḟ₀, 0),   φ₀ = F₀ − (αm − αf) h (M x + Φ_qᵀ μ).
fn start_damping<E: EquationsOfMotion>(
    eom: &E,
    scheme: SchemeCoefficients,
    newton: &mut Newton,
    s: &State,
    (damping, rate): (&mut [f64], &[f64]),
    h: f64,
) -> Result<(), SolveError> {
    if rate.iter().all(|rate| *rate == 0.0) {
        return Ok(());
    }
    let Newton { tangent, r, z, .. } = newton;
    let (matrix, factor) = tangent.lend();
    z.iter_mut().zip(rate).for_each(|(z, rate)| *z = -rate);
    solve(eom, matrix, factor, s, scheme.weights(h), z)?;
    eom.tangent(s, Weights::MASS, matrix);
    matrix.multiply(z, r);
    for (damping, r) in damping.iter_mut().zip(&r[..s.q.len()]) {
        *damping -= scheme.lead() * h * r;
    }
    Ok(())
}
