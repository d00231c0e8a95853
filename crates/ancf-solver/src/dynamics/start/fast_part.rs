use super::initial_conditions::solve_again;
use super::products::multiply;
use crate::equations::{EquationsOfMotion, State, Weights};
use crate::newton::{Newton, SolveError};

/// Number of factors of the filter.
const FACTORS: usize = 3;

/// Computes (S − M) x, with S the last computed matrix.
pub(super) fn linear_forces<E: EquationsOfMotion>(
    eom: &E,
    newton: &mut Newton,
    s: &State,
    x: &[f64],
) -> Vec<f64> {
    multiply(newton, x);
    let mut forces = newton.r.clone();
    forces[x.len()..].fill(0.0);
    inertia(eom, newton, s, x);
    forces.iter_mut().zip(&newton.z).for_each(|(force, inertia)| *force -= inertia);
    forces
}

/// Returns c for the forces (w_q f̈ + w_v Ḟ, 0).
pub(super) fn fast_part<E: EquationsOfMotion>(
    eom: &E,
    newton: &mut Newton,
    s: &State,
    forces: &[f64],
    w: Weights,
) -> Result<Vec<f64>, SolveError> {
    newton.z.copy_from_slice(forces);
    solve_with_factors(eom, newton, s, w)?;
    let mut part = newton.z[..s.q.len()].to_vec();
    for _ in 1..FACTORS {
        inertia(eom, newton, s, &part);
        solve_with_factors(eom, newton, s, w)?;
        part.iter_mut().zip(&newton.z).for_each(|(c, x)| *c -= x);
    }
    Ok(part)
}

/// Returns the damping forces that cause c: θ M c, with −1 ≤ θ ≤ 0 such that the power of the remaining forces on S⁻¹ M c is least.
///
/// Other damping forces are in equilibrium with elastic forces, such as those of a belt that sticks.
pub(super) fn fast_damping<E: EquationsOfMotion>(
    eom: &E,
    newton: &mut Newton,
    s: &State,
    (part, damping): (&[f64], &[f64]),
    w: Weights,
) -> Result<Vec<f64>, SolveError> {
    let n = s.q.len();
    if damping.iter().all(|force| *force == 0.0) {
        return Ok(vec![0.0; n]);
    }
    inertia(eom, newton, s, part);
    let inertia = newton.z[..n].to_vec();
    solve_with_factors(eom, newton, s, w)?;
    let power = |force: &[f64]| force.iter().zip(&newton.z[..n]).map(|(force, x)| force * x).sum::<f64>();
    let [own, total] = [power(&inertia), power(&damping[..n])];
    let share = if own > 0.0 { (total / own).clamp(-1.0, 0.0) } else { 0.0 };
    Ok(inertia.into_iter().map(|force| share * force).collect())
}

/// Computes (M x, 0) into `newton.z`.
fn inertia<E: EquationsOfMotion>(eom: &E, newton: &mut Newton, s: &State, x: &[f64]) {
    eom.tangent(s, Weights::MASS, newton.tangent.lend().0);
    multiply(newton, x);
    let Newton { r, z, .. } = newton;
    z[..x.len()].copy_from_slice(&r[..x.len()]);
}

/// Solves [S, Φ_qᵀ; Φ_q, 0] for `newton.z` with the factors of this matrix.
fn solve_with_factors<E: EquationsOfMotion>(
    eom: &E,
    newton: &mut Newton,
    s: &State,
    w: Weights,
) -> Result<(), SolveError> {
    let Newton { tangent, z, .. } = newton;
    let (matrix, factor) = tangent.lend();
    eom.tangent(s, w, matrix);
    solve_again(matrix, factor, s, z)
}
