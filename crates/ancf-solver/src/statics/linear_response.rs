use crate::equations::{EquationsOfMotion, State};
use crate::factor::solve_with_skew_part;
use crate::newton::{ActiveSet, Newton, NewtonTangent};

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
    /// The skew part of the stiffness, of loads without a potential, is included by iteration.
    pub fn parts(&mut self) -> (&State, impl FnMut(&[f64]) -> Option<Vec<f64>>) {
        let Self { newton, eom, state } = self;
        let state = &*state;
        (state, move |force: &[f64]| linear_response(newton, &**eom, state, force))
    }
}

/// Solves K z = f with the last factors of `newton`; `None` if the solution is not accurate.
///
/// The skew part of the stiffness, of loads without a potential, is included.
pub(crate) fn linear_response(
    newton: &mut Newton,
    eom: &dyn EquationsOfMotion,
    s: &State,
    force: &[f64],
) -> Option<Vec<f64>> {
    let (mut z, NewtonTangent { matrix, factor, .. }) = (force.to_vec(), &mut newton.tangent);
    let solve = &mut |x: &mut [f64]| factor.solve(matrix, x);
    let is_solved = solve_with_skew_part(&eom.skew_stiffness(s), &mut z, solve).ok()?;
    (is_solved && z.iter().all(|x| x.is_finite())).then_some(z)
}
