//! Stresses, energy and stiffness of shear-deformable shells whose membrane forces may have a law that is not linear in the strains.

use nalgebra::{SMatrix, Vector3};

use super::forms::{SURFACE, Strains};
use super::profile::ShearProfile;
use crate::shells::laminates::MembranePoints;

/// Returns the membrane strain at an integration point.
pub(super) fn membrane<const S: usize>(strains: &Strains<S>, k: usize) -> Vector3<f64> {
    strains.fixed_rows::<3>(SURFACE * k).into()
}

impl<const V: usize, const S: usize> ShearProfile<V, S> {
    /// Replaces the membrane forces at the integration points if the section has a law of them.
    ///
    /// Such an element has no enhanced strains and its section no coupling, so that membrane forces depend on the membrane strains at
    /// their point only.
    pub(super) fn with_forces(
        &self,
        mut stress: Strains<S>,
        force: impl Fn(&MembranePoints, usize) -> Vector3<f64>,
    ) -> Strains<S> {
        if let Some(law) = &self.membrane {
            for k in 0..self.shape.surface_points().len() {
                stress.fixed_rows_mut::<3>(SURFACE * k).copy_from(&force(law, k));
            }
        }
        stress
    }

    /// Computes the stresses of strains by the linear law.
    pub(super) fn linear_stress(&self, strains: &Strains<S>) -> Strains<S> {
        *self.stiffness * strains
    }

    /// Computes the stresses of strains.
    pub(super) fn stress(&self, strains: &Strains<S>) -> Strains<S> {
        self.with_forces(self.linear_stress(strains), |law, k| law.force(k, &membrane(strains, k)))
    }

    /// Computes the strain energy.
    pub(super) fn strain_energy(&self, strains: &Strains<S>) -> f64 {
        let others = self.with_forces(self.linear_stress(strains), |_, _| Vector3::zeros());
        let energy = 0.5 * strains.dot(&others);
        let of_law = |law: &MembranePoints| -> f64 {
            (0..self.shape.surface_points().len()).map(|k| law.energy(k, &membrane(strains, k))).sum()
        };
        self.membrane.as_ref().map_or(energy, |law| energy + of_law(law))
    }

    /// Computes multiples of the stiffness of strains in a state and of the linear one.
    pub(super) fn state_stiffness(&self, strains: &Strains<S>, shares: [f64; 2]) -> SMatrix<f64, S, S> {
        let mut stiffness = *self.stiffness * (shares[0] + shares[1]);
        if let Some(law) = &self.membrane {
            for k in 0..self.shape.surface_points().len() {
                let own = law.stiffness(k, &membrane(strains, k), shares);
                stiffness.fixed_view_mut::<3, 3>(SURFACE * k, SURFACE * k).copy_from(&own);
            }
        }
        stiffness
    }

    /// Computes the change of the stresses in a state for a small change of the strains.
    pub(super) fn stress_change(&self, strains: &Strains<S>, change: &Strains<S>) -> Strains<S> {
        self.with_forces(self.linear_stress(change), |law, k| {
            law.stiffness(k, &membrane(strains, k), [1.0, 0.0]) * membrane(change, k)
        })
    }

    /// Computes the stresses that follow from those of a state by its stiffness, for a linear change of its strains, minus the stresses
    /// of another state.
    pub(super) fn predicted_stress(
        &self,
        (before, change): (&Strains<S>, &Strains<S>),
        now: &Strains<S>,
    ) -> Strains<S> {
        self.with_forces(self.linear_stress(&(before + change - now)), |law, k| {
            let [then, now] = [before, now].map(|strains| law.force(k, &membrane(strains, k)));
            then + law.stiffness(k, &membrane(before, k), [1.0, 0.0]) * membrane(change, k) - now
        })
    }

    /// Computes the stresses of strains between those at both ends of a step, with membrane forces that do the work of the energy on
    /// the change of the membrane strains.
    pub(super) fn step_stress(&self, strains: &Strains<S>, ends: [&Strains<S>; 2]) -> Strains<S> {
        self.with_forces(self.linear_stress(strains), |law, k| {
            law.force(k, &membrane(strains, k)) + law.correction(k, ends.map(|end| membrane(end, k)))
        })
    }
}
