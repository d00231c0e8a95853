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
    z: Vec<f64>,
}

impl LoadRates {
    /// Allocates the factorisation of a matrix of the equations, for states of the size of `start`.
    ///
    /// # Errors
    /// If the memory does not suffice.
    pub fn new(matrix: SparseMatrix, start: &State) -> Result<Self, SolveError> {
        let factor = Factor::new(matrix.pattern()).map_err(|_| SolveError::at_start(SolveFailure::Memory))?;
        let z = vec![0.0; matrix.pattern().size()];
        Ok(Self { matrix, factor, state: start.clone(), z })
    }

    /// Returns the equilibrium `s` with the velocities dq/ds. They are zero if the stiffness is singular.
    pub fn evaluate(&mut self, eom: &dyn EquationsOfMotion, s: &State) -> &State {
        let Self { matrix, factor, state, z } = self;
        state.copy_from(s);
        *z = eom.load_force(s);
        eom.tangent(state, Weights::STIFFNESS, matrix);
        let solved = factor.factorise(matrix).and_then(|()| factor.solve(matrix, z));
        let is_regular = solved.is_ok() && z.iter().all(|z| z.is_finite());
        for (v, z) in state.v.iter_mut().zip(&*z) {
            *v = if is_regular { *z } else { 0.0 };
        }
        state
    }
}
