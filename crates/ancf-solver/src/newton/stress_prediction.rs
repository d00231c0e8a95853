use crate::equations::{EquationsOfMotion, State, Weights};
use crate::factor::{Factor, inertia};
use crate::sparse::SparseMatrix;

/// Stresses of the tangent in statics: those that the last linear system predicted, in place of those of the iterate.
///
/// An increment along straight tangents stretches the axis of a slender body by the square of its rotation. The stress of this
/// stretch, 16 (L/d)² times that of bending, is not that of an equilibrium, but it dominates the stiffness at the iterate: the
/// next increments are small, and the number of iterations grows with L/d. The stress n(q₀) + ∂n/∂q (q − q₀) that the linear system
/// at the last iterate q₀ predicted is in equilibrium with the loads to first order. This is Newton's method for stresses
/// and displacements as independent unknowns, without the stresses in the equations. The residual remains that of the displacements,
/// and near a solution both tangents agree to the second order of the increment.
///
/// The predicted stresses may be compressive in slack bodies. If the matrix is then indefinite, the iteration uses the stresses of
/// the iterate.
///
/// Source: Magisano, Leonetti & Garcea (2017), mixed integration points.
#[derive(Debug)]
pub(crate) struct StressPrediction {
    /// Last iterate, or the equilibrium before the prediction of the first one.
    from: State,
    is_active: bool,
}

impl StressPrediction {
    /// Storage for states of the size of `s`.
    pub(super) fn new(s: &State) -> Self {
        Self { from: s.clone(), is_active: false }
    }

    /// Starts a solution from an equilibrium.
    pub(super) fn start(&mut self, from: &State) {
        self.from.copy_from(from);
        self.is_active = true;
    }

    /// Ends a solution.
    pub(super) fn end(&mut self) {
        self.is_active = false;
    }

    /// Computes and factorises the tangent with the predicted stresses. Returns false if they are not used.
    pub(super) fn factorise(
        &mut self,
        eom: &dyn EquationsOfMotion,
        s: &State,
        (matrix, factor): (&mut SparseMatrix, &mut Factor),
    ) -> bool {
        if !self.is_active || self.from.q == s.q {
            return false;
        }
        eom.tangent(s, Weights::STIFFNESS, matrix);
        eom.add_stress_prediction(s, &self.from, matrix);
        self.from.copy_from(s);
        let is_factorised = factor.factorise(matrix).is_ok();
        is_factorised && factor.negative_pivots().or_else(|| inertia(matrix)) == Some(eom.multipliers())
    }
}
