use super::linear_response::stiffness_solution;
use crate::equations::{EquationsOfMotion, State, Weights};
use crate::factor::Factor;
use crate::newton::{SolveError, SolveFailure};
use crate::sparse::SparseMatrix;

/// Rates of equilibria with respect to the load factor s: K dz/ds = −∂r/∂s.
#[derive(Debug)]
pub struct LoadRates {
    matrix: SparseMatrix,
    factor: Factor,
    state: State,
}

impl LoadRates {
    /// Allocates the factorisation of a matrix of the equations, for states of the size of `start`.
    ///
    /// # Errors
    /// If the memory does not suffice.
    pub fn new(matrix: SparseMatrix, start: &State) -> Result<Self, SolveError> {
        let factor = Factor::new(matrix.pattern()).map_err(|_| SolveError::at_start(SolveFailure::Memory))?;
        Ok(Self { matrix, factor, state: start.clone() })
    }

    /// Returns the equilibrium `s` with the velocities dq/ds; `None` if the stiffness is singular.
    pub fn evaluate(&mut self, eom: &dyn EquationsOfMotion, s: &State) -> Option<&State> {
        let Self { matrix, factor, state } = self;
        eom.tangent(s, Weights::STIFFNESS, matrix);
        factor.factorise(matrix).ok()?;
        let z = stiffness_solution(eom, s, (matrix, factor), &eom.load_force(s))?;
        state.copy_from(s);
        let n = state.v.len();
        state.v.copy_from_slice(&z[..n]);
        Some(state)
    }
}
