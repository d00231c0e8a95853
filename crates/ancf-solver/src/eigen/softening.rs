//! Geometric stiffness of the loads of linear buckling.

use super::operator::EigenError;
use crate::equations::{EquationsOfMotion, State, Weights};
use crate::factor::{DETERMINED, Factor};
use crate::sparse::SparseMatrix;

/// Smallest significant work of the loads, relative to the sum of their work on isolated coordinates.
const MIN_WORK: f64 = 1e-12;

/// Computes −K_g, with zeros in place of rounding errors: entries that change by their own size in a further step of refinement
/// of the response. Second, the response of the coordinates and multipliers.
pub fn softening(
    eom: &dyn EquationsOfMotion,
    s: &State,
    stiffness: &SparseMatrix,
    factor: &mut Factor,
) -> Result<(SparseMatrix, Vec<f64>), EigenError> {
    let force = eom.load_force(s);
    let mut response = force.clone();
    factor.solve(stiffness, &mut response)?;
    let refined = factor.refined(stiffness, &force, &response)?;
    let of_response = |response: &[f64]| {
        let mut softening = stiffness.clone();
        eom.stress_stiffness(s, &first_order(eom, &force, response, stiffness), &mut softening);
        softening
    };
    let (mut softening, refined) = (of_response(&response), of_response(&refined));
    for (value, refined) in softening.values_mut().iter_mut().zip(refined.values()) {
        let is_determined = (*value - refined).abs() <= DETERMINED * value.abs();
        *value = if is_determined { -*value } else { 0.0 };
    }
    Ok((softening, response))
}

/// Returns the first-order response (q₁, λ₁) to loads and prescribed displacements. Where joints carry all loads, q₁ is zero.
fn first_order(
    eom: &dyn EquationsOfMotion,
    force: &[f64],
    response: &[f64],
    stiffness: &SparseMatrix,
) -> State {
    let (n, m) = (eom.coordinates(), eom.multipliers());
    // The stiffness of a rigid body may consist of rounding errors.
    let least = stiffness.diagonal_rounding();
    let held = |i: usize| match stiffness.diagonal_of(i).abs() {
        stiffness if stiffness <= least => 0.0,
        stiffness => force[i].powi(2) / stiffness,
    };
    let work: f64 = (0..n).map(|i| force[i] * response[i]).sum();
    let mut increment = State::rest(n, m);
    increment.add(response, Weights::STIFFNESS);
    let is_prescribed = force[n..].iter().any(|x| *x != 0.0);
    if !is_prescribed && work.abs() <= MIN_WORK * (0..n).map(held).sum::<f64>() {
        // Joints carry the loads. The displacements are rounding errors.
        increment.q.fill(0.0);
    }
    increment
}
