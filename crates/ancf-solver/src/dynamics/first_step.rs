use super::initial_conditions::{Factors, Projected, accelerations, project, solve, solve_again};
use super::scheme::SchemeCoefficients;
use crate::equations::{EquationsOfMotion, State, Weights};
use crate::newton::{Newton, SolveError};

/// Difference interval for the rate of the acceleration, relative to the step size.
const DIFFERENCE_INTERVAL: f64 = 1.0 / 16.0;
/// Projections of a state onto the constraints. The second step of Newton's method squares their small violation.
const PROJECTIONS: [Projected; 3] = [Projected::Positions, Projected::Positions, Projected::Velocities];

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
    let Rates { acceleration: mut rate, damping: damping_rate } =
        rates(eom, newton, s, damping, h * DIFFERENCE_INTERVAL)?;
    start_damping(eom, scheme, newton, s, (damping, &damping_rate), h)?;
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

/// Returns the state at a time d later on a parabola through a state.
fn ahead(s: &State, d: f64) -> State {
    let mut ahead = s.clone();
    for i in 0..s.q.len() {
        ahead.q[i] += d * (s.v[i] + 0.5 * d * s.a[i]);
        ahead.v[i] += d * s.a[i];
    }
    ahead.t += d;
    ahead
}

/// Rates of accelerations and damping forces at the start.
struct Rates {
    acceleration: Vec<f64>,
    damping: Vec<f64>,
}

/// Computes v̈ from consistent accelerations along a parabola through a state: [−3v̇(0) + 4v̇(δ) − v̇(2δ)]/(2δ), and the
/// rate of the damping forces in the same way.
///
/// The states on the parabola are projected onto the constraints of positions and velocities. The differences are
/// one-sided, since loads may jump at the start. Quadratic terms cancel, including the error of the parabola in v.
fn rates<E: EquationsOfMotion>(
    eom: &E,
    newton: &mut Newton,
    s: &State,
    damping: &[f64],
    delta: f64,
) -> Result<Rates, SolveError> {
    let start = |x: &[f64]| -> Vec<f64> { x.iter().map(|x| -1.5 / delta * x).collect() };
    let mut rates = Rates { acceleration: start(&s.a), damping: start(damping) };
    for (d, weight) in [(delta, 2.0 / delta), (2.0 * delta, -0.5 / delta)] {
        let mut ahead = ahead(s, d);
        let Newton { tangent, z, r, .. } = &mut *newton;
        let (matrix, factor) = tangent.lend();
        // Beside the constraints, accelerations depend on the form of their equations.
        let (mut projected, mut factors) = (ahead.clone(), Factors::OfOtherState);
        let mut is_projected = |part| {
            let done = project(eom, matrix, factor, &mut projected, part, z);
            done.is_ok_and(|of| {
                factors = of;
                true
            })
        };
        if PROJECTIONS.into_iter().all(&mut is_projected) {
            ahead = projected;
        } else {
            factors = Factors::OfOtherState;
        }
        accelerations(eom, matrix, factor, &mut ahead, z, factors)?;
        eom.exchange(&ahead, r);
        let add = |rate: &mut [f64], x: &[f64]| {
            rate.iter_mut().zip(x).for_each(|(rate, x)| *rate += weight * x);
        };
        add(&mut rates.acceleration, &ahead.a);
        add(&mut rates.damping, r);
    }
    Ok(rates)
}
