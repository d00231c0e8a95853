use crate::equations::{EquationsOfMotion, State, Weights};
use crate::factor::Factor;
use crate::newton::{SolveError, SolveFailure};
use crate::sparse::SparseMatrix;

/// Change of the load factor for the difference of residuals. Prescribed rotations are not linear in the load factor.
const DIFFERENCE: f64 = 1e-5;

/// Rates of equilibria with respect to the load factor s: K dz/ds = −∂r/∂s.
#[derive(Debug)]
pub struct LoadRates {
    matrix: SparseMatrix,
    factor: Factor,
    state: State,
    r: Vec<f64>,
    z: Vec<f64>,
}

impl LoadRates {
    /// Allocates the factorisation of a matrix of the equations, for states of the size of `start`.
    ///
    /// # Errors
    /// If the memory does not suffice.
    pub fn new(matrix: SparseMatrix, start: &State) -> Result<Self, SolveError> {
        let factor = Factor::new(matrix.pattern()).map_err(|_| SolveError::at_start(SolveFailure::Memory))?;
        let zeros = vec![0.0; matrix.pattern().size()];
        Ok(Self { matrix, factor, state: start.clone(), r: zeros.clone(), z: zeros })
    }

    /// Returns the equilibrium `s` with the velocities dq/ds. They are zero if the stiffness is singular.
    pub fn evaluate(&mut self, eom: &dyn EquationsOfMotion, s: &State) -> &State {
        let Self { matrix, factor, state, r, z } = self;
        state.copy_from(s);
        state.load = s.load - DIFFERENCE;
        eom.residual(state, r);
        state.load = s.load + DIFFERENCE;
        eom.residual(state, z);
        state.load = s.load;
        for (z, r) in z.iter_mut().zip(&*r) {
            *z = (*r - *z) / (2.0 * DIFFERENCE);
        }
        eom.tangent(state, Weights::STIFFNESS, matrix);
        let solved = factor.factorise(matrix).and_then(|()| factor.solve(matrix, z));
        let is_regular = solved.is_ok() && z.iter().all(|z| z.is_finite());
        for (v, z) in state.v.iter_mut().zip(&*z) {
            *v = if is_regular { *z } else { 0.0 };
        }
        state
    }
}
