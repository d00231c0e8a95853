use ancf_solver::equations::{LocalMatrix, LocalStep, Term};

use super::source::StrainField;

/// Shell element whose stresses are linear in its strains, D ε + τ D ε̇.
pub(crate) trait StrainedElement: Term + Clone {
    /// Strains or stresses at the points of the element; stresses contain the weights of the points.
    type Strains: Clone + Send + Sync;

    /// Strains of zero.
    fn zero() -> Self::Strains;

    /// Adds a multiple of other strains.
    fn add(sum: &mut Self::Strains, factor: f64, other: &Self::Strains);

    /// Returns a multiple of strains.
    fn scaled(factor: f64, strains: &Self::Strains) -> Self::Strains {
        let mut scaled = Self::zero();
        Self::add(&mut scaled, factor, strains);
        scaled
    }

    /// Returns Σ σ ε.
    fn product(stress: &Self::Strains, strains: &Self::Strains) -> f64;

    /// Retardation time τ.
    fn retardation(&self) -> f64;

    /// Samples a field of strains at the points of the element.
    fn sampled(&self, field: StrainField<'_>) -> Self::Strains;

    /// Returns the stresses D ε.
    fn stress_of(&self, strains: &Self::Strains) -> Self::Strains;

    /// Returns the strains of displacements.
    fn strains_of(&self, q: &[f64]) -> Self::Strains;

    /// Returns the rates of the strains.
    fn rates_of(&self, q: &[f64], v: &[f64]) -> Self::Strains;

    /// Adds the forces of stresses.
    fn add_forces_of(&self, q: &[f64], stress: &Self::Strains, r: &mut [f64]);

    /// Adds bounds of the rounding errors of the forces of stresses.
    fn add_rounding_of(&self, q: &[f64], stress: &Self::Strains, floor: &mut [f64]);

    /// Adds the stiffness of stresses.
    fn add_stiffness_of(&self, q: &[f64], stress: &Self::Strains, k: &mut LocalMatrix<'_>);

    /// Returns constant stresses with corrections by which their forces in the middle of a step do the work of the stresses on the
    /// changes of the strains.
    ///
    /// By default the stresses: the forces of the middle do the work of strains that are quadratic in the coordinates.
    fn exact_work(&self, stress: Self::Strains, _step: &LocalStep<'_>) -> Self::Strains {
        stress
    }
}
