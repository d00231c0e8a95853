use super::arc_metric::solve_force;
use crate::equations::{EquationsOfMotion, State};
use crate::newton::{ActiveSet, Newton};
use crate::vectors::norm;

/// Maximum number of iterations for the unsymmetric part of the stiffness.
const ITERATIONS: u32 = 30;
/// Relative change at which they end.
const TOLERANCE: f64 = 1e-6;

/// Equilibrium with the factors of its last increment.
#[derive(Debug)]
pub struct EquilibriumResponse<'a, E: EquationsOfMotion + ?Sized> {
    eom: ActiveSet<'a, E>,
    newton: Newton,
    state: State,
}

impl<'a, E: EquationsOfMotion> EquilibriumResponse<'a, E> {
    pub(super) fn new(eom: ActiveSet<'a, E>, newton: Newton, state: State) -> Self {
        Self { eom, newton, state }
    }

    /// Returns the equilibrium and its linear response z = K⁻¹ f of the coordinates and multipliers to small additional forces f, with
    /// the factors of its last increment; `None` if they are not accurate.
    ///
    /// The unsymmetric part of the stiffness, of loads without a potential, is included by iteration.
    pub fn parts(&mut self) -> (&State, impl FnMut(&[f64]) -> Option<Vec<f64>>) {
        let Self { newton, eom, state } = self;
        let state = &*state;
        (state, move |force: &[f64]| linear_response(newton, &**eom, state, force))
    }
}

/// Solves K z = f with the last factors of `newton`; `None` if the solution is not accurate.
///
/// With an unsymmetric part S of the stiffness the iteration is (K − S) zᵢ₊₁ = f − S zᵢ. It ends without a solution if it does not
/// converge, as near critical loads.
pub(crate) fn linear_response(
    newton: &mut Newton,
    eom: &dyn EquationsOfMotion,
    s: &State,
    force: &[f64],
) -> Option<Vec<f64>> {
    let mut solve = |right: Vec<f64>| {
        let z = solve_force(newton, right).ok()?;
        z.iter().all(|x| x.is_finite()).then_some(z)
    };
    let mut z = solve(force.to_vec())?;
    let skew = eom.skew_stiffness(s);
    if skew.is_empty() {
        return Some(z);
    }
    for _ in 0..ITERATIONS {
        let mut right = force.to_vec();
        for &(i, j, value) in &skew {
            right[i] -= value * z[j];
            right[j] += value * z[i];
        }
        let next = solve(right)?;
        let change: Vec<f64> = next.iter().zip(&z).map(|(next, z)| next - z).collect();
        let is_done = norm(&change) <= TOLERANCE * norm(&next);
        z = next;
        if is_done {
            return Some(z);
        }
    }
    None
}
