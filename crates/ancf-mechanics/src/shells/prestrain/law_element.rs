use ancf_solver::equations::{LocalMatrix, LocalStep};
use nalgebra::{Matrix3, Vector3};

use super::element::StrainedElement;
use crate::shells::laminates::MembranePoints;

/// Shell element whose membrane forces may have a law that is not linear in the strains.
pub(crate) trait LawElement: StrainedElement {
    /// Law at the integration points; `None` for a linear one.
    fn law(&self) -> Option<&MembranePoints>;

    /// Number of integration points of the membrane.
    fn membrane_points(&self) -> usize;

    /// Returns the membrane strain at an integration point, in covariant components.
    fn membrane_at(&self, strains: &Self::Strains, point: usize) -> Vector3<f64>;

    /// Replaces the membrane stresses by those of contravariant forces at the integration points.
    fn set_forces(&self, stress: &mut Self::Strains, force: &dyn Fn(usize) -> Vector3<f64>);

    /// Adds the stiffness Bᵀ D B of the membrane strains with the stiffness D of each point.
    fn add_membrane_stiffness(
        &self,
        q: &[f64],
        stiffness: &dyn Fn(usize) -> Matrix3<f64>,
        k: &mut LocalMatrix<'_>,
    );

    /// Returns the strains of both ends of a step.
    fn strains_of_ends(&self, step: &LocalStep<'_>) -> [Self::Strains; 2] {
        [&step.from, &step.to].map(|at| self.strains_of(at.q))
    }
}
