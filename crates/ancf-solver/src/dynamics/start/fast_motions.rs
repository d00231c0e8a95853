use super::initial_conditions::{factorise, solve_again};
use super::rates::{ahead, difference, magnitudes, multiply};
use crate::equations::{EquationsOfMotion, State, Weights};
use crate::newton::{Newton, SolveError};

/// Largest difference of the parts of two intervals, relative to the part, and smallest part, relative to all accelerations.
const AGREE: f64 = 0.02;
const NEGLIGIBLE: f64 = 1e-6;
/// First interval of the differences, relative to the step, factor between intervals, and their largest number. Rounding errors grow with
/// the square of the factor.
const FIRST: f64 = 1.0 / 16.0;
const REFINEMENT: f64 = 0.25;
const INTERVALS: i32 = 11;
/// Number of factors of the filter.
const FACTORS: usize = 3;

/// Part c of the accelerations v̇ at a start in motions that are much faster than the first step, and of the damping forces.
///
/// With the iteration matrix S of the step and its weights,
///
/// [S, Φ_qᵀ; Φ_q, 0] (e, ·) = (w_q f̈ + w_v Ḟ, 0),   c = (1 − U)² e,   [S, Φ_qᵀ; Φ_q, 0] (U x, ·) = (M x, 0).
///
/// F are the damping forces, and f is the residual without them at the accelerations and multipliers of the state. f̈ and Ḟ are
/// derivatives along a parabola through the state. In a linear mode of frequency ω and decay rate ζω, f̈ = M ω² v̇ and Ḟ = 2ζω M v̇.
/// Hence c = [y/(1 + y)]³ v̇ with y = w_q ω² + 2ζω w_v: all of v̇ if the motion is much faster than the step, and an error of the order
/// h⁶ (h³ with damping) if the step resolves it. In a rotating body f̈ contains the change of the strains only, so its centripetal
/// accelerations are no part of c.
///
/// At a jump within a motion c is the part of the change of the accelerations. Vibrations that the scheme carries remain. There and at
/// rest, w_q f̈ + w_v Ḟ = (S − M) v̇ without differences.
///
/// The interval of the differences is reduced until two results agree. Where the forces are not smooth, as before an impact or with
/// dry friction, none agree with a part below the acceleration, and c is zero.
pub(super) struct FastMotions {
    /// Part c of the accelerations.
    pub(super) acceleration: Vec<f64>,
    /// Part of the damping forces.
    pub(super) damping: Vec<f64>,
}

impl FastMotions {
    /// Computes the parts for a first step h with the weights `w`; `None` if they are negligible or unknown. `before_jump` are the
    /// accelerations before a jump within a motion.
    pub(super) fn at<E: EquationsOfMotion>(
        eom: &E,
        newton: &mut Newton,
        (s, before_jump): (&State, Option<&[f64]>),
        damping: &[f64],
        (h, w): (f64, Weights),
    ) -> Result<Option<Self>, SolveError> {
        let change = before_jump.map_or_else(|| s.a.clone(), |before| difference(&s.a, before));
        let [whole, all] = magnitudes(eom, newton, s, [&change, &s.a]);
        if whole <= NEGLIGIBLE * all {
            return Ok(None);
        }
        let (matrix, factor) = newton.tangent.lend();
        factorise(eom, matrix, factor, s, w)?;
        let is_linear = before_jump.is_some() || s.v.iter().all(|v| *v == 0.0);
        let part = if is_linear {
            let part = part_of_change(eom, newton, s, &change, w)?;
            let [size] = magnitudes(eom, newton, s, [&part]);
            (size > NEGLIGIBLE * all && size <= (1.0 + AGREE) * whole).then_some(part)
        } else {
            part_of_differences(eom, newton, s, whole, (h, w))?
        };
        let Some(acceleration) = part else { return Ok(None) };
        let damping = fast_damping(eom, newton, s, (&acceleration, damping), w)?;
        Ok(Some(Self { acceleration, damping }))
    }
}

/// Returns c of a change of the accelerations, or of all accelerations at rest: w_q f̈ + w_v Ḟ = (S − M) v̇.
fn part_of_change<E: EquationsOfMotion>(
    eom: &E,
    newton: &mut Newton,
    s: &State,
    change: &[f64],
    w: Weights,
) -> Result<Vec<f64>, SolveError> {
    multiply(newton, change);
    let mut forces = newton.r.clone();
    forces[change.len()..].fill(0.0);
    inertia(eom, newton, s, change);
    forces.iter_mut().zip(&newton.z).for_each(|(force, inertia)| *force -= inertia);
    fast_part(eom, newton, s, &forces, w)
}

/// Returns c of the accelerations of a moving system, of the size `whole`, from differences along a parabola; `None` if it is negligible
/// or the forces are not smooth.
fn part_of_differences<E: EquationsOfMotion>(
    eom: &E,
    newton: &mut Newton,
    s: &State,
    whole: f64,
    (h, w): (f64, Weights),
) -> Result<Option<Vec<f64>>, SolveError> {
    let mut last: Option<Vec<f64>> = None;
    for k in 0..INTERVALS {
        let forces = force_changes(eom, s, h * FIRST * REFINEMENT.powi(k), w);
        if forces.iter().any(|force| !force.is_finite()) {
            continue;
        }
        let part = fast_part(eom, newton, s, &forces, w)?;
        let apart = last.as_ref().map(|last| difference(&part, last)).unwrap_or_default();
        let [size, apart] = magnitudes(eom, newton, s, [&part, &apart]);
        if size <= NEGLIGIBLE * whole {
            return Ok(None);
        }
        if last.is_some() && apart <= AGREE * size && size <= (1.0 + AGREE) * whole {
            return Ok(Some(part));
        }
        last = Some(part);
    }
    Ok(None)
}

/// Computes w_q f̈ + w_v Ḟ from one-sided differences of the interval `delta`.
fn force_changes<E: EquationsOfMotion>(eom: &E, s: &State, delta: f64, w: Weights) -> Vec<f64> {
    let [mut sum, mut residual, mut damping] = [(); 3].map(|()| vec![0.0; s.q.len() + s.lambda.len()]);
    let [second, first] = [w.q / (delta * delta), w.v / (2.0 * delta)];
    for (steps, of) in [(0.0, [1.0, -3.0]), (1.0, [-2.0, 4.0]), (2.0, [1.0, -1.0])] {
        let ahead = ahead(s, steps * delta);
        eom.residual(&ahead, &mut residual);
        eom.exchange(&ahead, &mut damping);
        for (i, sum) in sum[..s.q.len()].iter_mut().enumerate() {
            *sum += of[0] * second * (residual[i] - damping[i]) + of[1] * first * damping[i];
        }
    }
    sum
}

/// Returns c for the forces (w_q f̈ + w_v Ḟ, 0).
fn fast_part<E: EquationsOfMotion>(
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
fn fast_damping<E: EquationsOfMotion>(
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
