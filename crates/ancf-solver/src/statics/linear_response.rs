use crate::equations::{EquationsOfMotion, State, Weights};
use crate::factor::{Factor, add_skew_product, solve_with_skew_part};
use crate::newton::{ActiveSet, Newton, NewtonTangent, SolveFailure};
use crate::sparse::SparseMatrix;

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

/// Solves K z = f with the last factors of `newton`, as [`stiffness_solution`].
pub(crate) fn linear_response(
    newton: &mut Newton,
    eom: &dyn EquationsOfMotion,
    s: &State,
    force: &[f64],
) -> Option<Vec<f64>> {
    let NewtonTangent { matrix, factor, .. } = &mut newton.tangent;
    stiffness_solution(eom, s, (matrix, factor), force)
}

/// Solves K z = f with the factors of K; `None` if the solution is not accurate.
///
/// The skew part of the stiffness, of loads without a potential, is included.
pub fn stiffness_solution(
    eom: &dyn EquationsOfMotion,
    s: &State,
    (matrix, factor): (&SparseMatrix, &mut Factor),
    force: &[f64],
) -> Option<Vec<f64>> {
    let mut z = force.to_vec();
    let solve = &mut |x: &mut [f64]| factor.solve(matrix, x);
    let is_solved = solve_with_skew_part(&eom.skew_stiffness(s), &mut z, solve).ok()?;
    (is_solved && z.iter().all(|x| x.is_finite())).then_some(z)
}

/// Solves dz/ds = −K⁻¹ ∂r/∂s at an equilibrium with new factors of K.
pub(crate) fn load_response(
    newton: &mut Newton,
    eom: &dyn EquationsOfMotion,
    s: &State,
) -> Result<Vec<f64>, SolveFailure> {
    newton.tangent.prepare(eom, s, Weights::STIFFNESS)?;
    linear_response(newton, eom, s, &eom.load_force(s)).ok_or(SolveFailure::Singular)
}

/// Solves as [`load_response`], and once more with a further step of refinement.
pub(crate) fn refined_load_response(
    newton: &mut Newton,
    eom: &dyn EquationsOfMotion,
    s: &State,
) -> Result<[Vec<f64>; 2], SolveFailure> {
    let response = load_response(newton, eom, s)?;
    let mut product = newton.tangent.matrix.times(&response);
    add_skew_product(&eom.skew_stiffness(s), &response, &mut product);
    let rest: Vec<f64> =
        eom.load_force(s).iter().zip(product).map(|(force, product)| force - product).collect();
    let correction = linear_response(newton, eom, s, &rest).ok_or(SolveFailure::Singular)?;
    let refined = response.iter().zip(&correction).map(|(x, correction)| x + correction).collect();
    Ok([response, refined])
}
