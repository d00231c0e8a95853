use super::equilibrium::Equilibrium;
use crate::equations::{EquationsOfMotion, State, Weights};
use crate::factor::negative_eigenvalues;
use crate::newton::{ActiveSet, AdmissibleUpdate, Newton, SolveError, SolveFailure};
use crate::vectors::PseudoRandom;

/// First and largest rotation of an iteration, relative to the largest rotation of a load increment.
const ROTATIONS: [f64; 2] = [1e-3, 0.1];
/// First displacement where nothing rotates, in solver units, in which the model length is about one.
const DISPLACEMENT: f64 = 1e-6;
/// Rotation below which Newton's method takes over.
const CLOSE: f64 = 1e-2;
/// Maximum number of iterations.
const ITERATIONS: u32 = 400;
/// Smallest shift ω², relative to the largest K_ii/M_ii.
const SMALLEST_SHIFT: f64 = 1e-14;

/// Moves an unstable equilibrium to a stable one under the same load.
///
/// The motion starts in an unstable direction, which a pseudo-random load excites, and descends in energy. Its
/// iterations are implicit steps of M q̇ = −r, with K + ω²M for the smallest ω² = 4ᵏ that makes the matrix stable.
/// Stable motions decay in them and unstable motions grow. They are Newton's iterations (ω = 0) once K is stable.
pub(super) fn leave<E: EquationsOfMotion>(
    eom: &mut ActiveSet<'_, E>,
    newton: &mut Newton,
    update: &mut AdmissibleUpdate,
    s: &mut State,
) -> Result<Equilibrium, SolveError> {
    let failed = |s: &State| SolveError::at(s.t, SolveFailure::Unstable);
    let mut z = excitation(&**eom, s);
    let mut shift = 0.0;
    for iteration in 0..ITERATIONS {
        eom.include_near_terms(newton, s)?;
        if iteration > 0 {
            eom.residual(s, &mut z);
            z.iter_mut().for_each(|r| *r = -*r);
        }
        shift = solve(&**eom, newton, s, shift, &mut z).ok_or_else(|| failed(s))?;
        let rotation = advance(&**eom, s, &z, iteration == 0).ok_or_else(|| failed(s))?;
        if iteration > 0 && shift == 0.0 && rotation < CLOSE {
            let mut end = s.clone();
            let found = Equilibrium::find(newton, update, &**eom, &mut end)?;
            let is_complete = eom.with_active_terms(&end).is_none();
            if is_complete && found.unstable == Some(0) && eom.rotation(s, &end).size < ROTATIONS[1] {
                s.copy_from(&end);
                return Ok(Equilibrium { iterations: found.iterations + iteration, ..found });
            }
        }
    }
    Err(failed(s))
}

/// Returns a load with components along all motions, in proportion to the root of the mass and the stiffness.
fn excitation<E: EquationsOfMotion>(eom: &E, s: &State) -> Vec<f64> {
    let (n, m) = (eom.coordinates(), eom.multipliers());
    let mut load = vec![0.0; n + m];
    eom.rounding(s, &mut load);
    let largest = load[..n].iter().copied().fold(f64::MIN_POSITIVE, f64::max);
    let mut random = PseudoRandom(23);
    load[..n].iter_mut().for_each(|load| *load = random.number() * (1.0 + *load / largest));
    load[n..].fill(0.0);
    load
}

/// Solves (K + ω²M) z = b in place for the smallest stable ω², at least a quarter of the last one. Returns ω².
fn solve<E: EquationsOfMotion>(
    eom: &E,
    newton: &mut Newton,
    s: &State,
    last: f64,
    z: &mut [f64],
) -> Option<f64> {
    let (matrix, factor) = newton.tangent.lend();
    eom.tangent(s, Weights::MASS, matrix);
    let mass: Vec<f64> = (0..eom.coordinates()).map(|i| matrix.diagonal_of(i)).collect();
    let mut shift = 0.0;
    // 4¹⁰⁰ exceeds any spectrum.
    for _ in 0..100 {
        eom.tangent(s, Weights { a: shift, ..Weights::STIFFNESS }, matrix);
        if factor.factorise(matrix).is_ok()
            && factor.solve_increment(matrix, &mut z.to_vec(), &s.lambda).is_ok()
        {
            let negative = negative_eigenvalues(matrix, factor);
            if negative.is_some_and(|negative| negative <= eom.multipliers()) {
                return factor.solve_increment(matrix, z, &s.lambda).ok().map(|()| shift);
            }
        }
        if shift == 0.0 {
            let ratio =
                |(i, mass): (usize, &f64)| if *mass > 0.0 { matrix.diagonal_of(i).abs() / mass } else { 0.0 };
            let highest = mass.iter().enumerate().map(ratio).fold(0.0, f64::max);
            shift = (0.25 * last).max(SMALLEST_SHIFT * if highest > 0.0 { highest } else { 1.0 });
        } else {
            shift *= 4.0;
        }
    }
    None
}

/// Moves a state along z up to the largest rotation and up to the next contact partner. Returns the rotation.
fn advance<E: EquationsOfMotion>(eom: &E, s: &mut State, z: &[f64], first: bool) -> Option<f64> {
    let mut trial = s.clone();
    let mut attempt = |alpha: f64, s: &State| {
        let part: Vec<f64> = z.iter().map(|z| alpha * z).collect();
        trial.copy_from(s);
        trial.add(&part, Weights::STIFFNESS);
        trial.clone()
    };
    let largest = z[..s.q.len()].iter().fold(0.0_f64, |largest, z| largest.max(z.abs()));
    let mut alpha = if first { DISPLACEMENT / largest } else { 1.0 };
    if !alpha.is_finite() {
        return None;
    }
    let limit = if first { ROTATIONS[0] } else { ROTATIONS[1] };
    for _ in 0..40 {
        let next = attempt(alpha, s);
        let rotation = eom.rotation(s, &next).size;
        if rotation <= limit && eom.inadmissible(&next).is_none() && eom.crossing(s, &next).is_none() {
            s.copy_from(&next);
            return Some(rotation);
        }
        alpha *= if rotation > limit { (0.9 * limit / rotation).max(1e-3) } else { 0.5 };
    }
    None
}
