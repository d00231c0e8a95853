use super::fast_motions::FastMotions;
use super::initial_conditions::{solve, solve_again};
use super::rates::{filter, start_rates};
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
/// a₀ = v̇₀ − c + (αm − αf) h x,   v₀ ← v₀ + C h² y.
///
/// The part c of v̇₀ in motions that are [much faster](FastMotions) than the step is removed. A sudden load near a joint starts such
/// motions. The scheme would carry their accelerations through many steps, and with them wrong constraint forces.
///
/// Source: Arnold, Brüls & Cardona (2015), on the order reduction of the first steps and perturbed start values.
pub(crate) fn start_values<E: EquationsOfMotion>(
    eom: &E,
    scheme: SchemeCoefficients,
    newton: &mut Newton,
    (s, before_jump): (&mut State, Option<&[f64]>),
    (auxiliary, start): (&mut [f64], &mut StartValues),
    h: f64,
) -> Result<(), SolveError> {
    let StartValues { acceleration, damping, auxiliary_damping } = start;
    let (n, w) = (s.q.len(), scheme.weights(h));
    eom.exchange(s, damping);
    let fast = FastMotions::at(eom, newton, (s, before_jump), damping, (h, w))?;
    s.a.iter_mut().zip(&fast.acceleration).for_each(|(a, fast)| *a -= fast);
    damping.iter_mut().zip(&fast.damping).for_each(|(force, fast)| *force -= fast);
    acceleration.copy_from_slice(&s.a);
    let rates = start_rates(eom, newton, s, (&fast, &damping[..n]), (scheme, h))?;
    auxiliary_damping.copy_from_slice(damping);
    start_damping(eom, newton, s, (auxiliary_damping, &rates.damping), (scheme, h))?;
    filter(eom, newton, s, &rates.acceleration, w)?;
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

/// Accelerations and damping forces of the scheme at a start.
#[derive(Clone, Debug)]
pub(crate) struct StartValues {
    /// True accelerations v̇₀ − c.
    pub(crate) acceleration: Vec<f64>,
    /// Damping forces F₀ without their share in M c.
    pub(crate) damping: Vec<f64>,
    /// Auxiliary damping forces φ₀.
    pub(crate) auxiliary_damping: Vec<f64>,
}

impl StartValues {
    pub(crate) fn new(coordinates: usize, multipliers: usize) -> Self {
        let damping = vec![0.0; coordinates + multipliers];
        Self { acceleration: vec![0.0; coordinates], auxiliary_damping: damping.clone(), damping }
    }
}

/// Computes the auxiliary damping forces at the start from F₀ and its rate Ḟ₀. They are the share of the damping forces
/// and of their constraint forces in −M a₀:
///
/// [S, Φ_qᵀ; Φ_q, 0] (x, μ) = (−Ḟ₀, 0),   φ₀ = F₀ − (αm − αf) h (M x + Φ_qᵀ μ).
fn start_damping<E: EquationsOfMotion>(
    eom: &E,
    newton: &mut Newton,
    s: &State,
    (damping, rate): (&mut [f64], &[f64]),
    (scheme, h): (SchemeCoefficients, f64),
) -> Result<(), SolveError> {
    if rate.iter().all(|rate| *rate == 0.0) {
        return Ok(());
    }
    let Newton { tangent, r, z, .. } = newton;
    let (matrix, factor) = tangent.lend();
    z.fill(0.0);
    z.iter_mut().zip(rate).for_each(|(z, rate)| *z = -rate);
    solve(eom, matrix, factor, s, scheme.weights(h), z)?;
    eom.tangent(s, Weights::MASS, matrix);
    matrix.multiply(z, r);
    for (damping, r) in damping.iter_mut().zip(&r[..s.q.len()]) {
        *damping -= scheme.lead() * h * r;
    }
    Ok(())
}
