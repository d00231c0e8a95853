use super::initial_conditions::{accelerations, solve};
use super::scheme::SchemeCoefficients;
use crate::equations::{EquationsOfMotion, State, Weights};
use crate::newton::{Newton, SolveError};

/// Difference interval for the rate of the acceleration, relative to the step size.
const DIFFERENCE_INTERVAL: f64 = 1.0 / 16.0;

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
    auxiliary: &mut [f64],
    h: f64,
) -> Result<(), SolveError> {
    let n = s.q.len();
    let mut rate = rate(eom, newton, s, h * DIFFERENCE_INTERVAL)?;
    rate.resize(newton.z.len(), 0.0);
    let Newton { tangent, r, z, .. } = newton;
    let (matrix, factor) = tangent.lend();
    eom.tangent(s, Weights::MASS, matrix);
    matrix.multiply(&rate, r);
    z.copy_from_slice(r);
    solve(eom, matrix, factor, s, scheme.weights(h), z)?;
    for i in 0..n {
        auxiliary[i] = s.a[i] + scheme.lead() * h * z[i];
    }
    z.copy_from_slice(r);
    z[..n].fill(0.0);
    solve(eom, matrix, factor, s, scheme.weights(h), z)?;
    for i in 0..n {
        s.v[i] += scheme.error_constant() * h * h * z[i];
    }
    Ok(())
}

/// Computes v̈ from consistent accelerations along a parabola through a state: [−3v̇(0) + 4v̇(δ) − v̇(2δ)]/(2δ).
///
/// The differences are one-sided, since loads may jump at the start. Quadratic terms cancel, including the error of the
/// parabola in v.
fn rate<E: EquationsOfMotion>(
    eom: &E,
    newton: &mut Newton,
    s: &State,
    delta: f64,
) -> Result<Vec<f64>, SolveError> {
    let mut rate: Vec<f64> = s.a.iter().map(|a| -1.5 / delta * a).collect();
    for (d, weight) in [(delta, 2.0 / delta), (2.0 * delta, -0.5 / delta)] {
        let mut ahead = s.clone();
        for i in 0..s.q.len() {
            ahead.q[i] += d * (s.v[i] + 0.5 * d * s.a[i]);
            ahead.v[i] += d * s.a[i];
        }
        ahead.t += d;
        let Newton { tangent, z, .. } = &mut *newton;
        let (matrix, factor) = tangent.lend();
        accelerations(eom, matrix, factor, &mut ahead, z)?;
        rate.iter_mut().zip(&ahead.a).for_each(|(rate, a)| *rate += weight * a);
    }
    Ok(rate)
}
