//! Stresses, energy and stiffness of shear-deformable shells whose membrane forces may have a law that is not linear in the strains.

use ancf_solver::equations::LocalMatrix;
use nalgebra::{Matrix3, SMatrix, Vector3};

use super::element::ShearElement;
use super::forms::{SURFACE, Strains};
use super::profile::ShearProfile;
use crate::shells::laminates::MembranePoints;
use crate::shells::prestrain::LawElement;

/// Returns the membrane strain at an integration point.
fn membrane<const S: usize>(strains: &Strains<S>, k: usize) -> Vector3<f64> {
    strains.fixed_rows::<3>(SURFACE * k).into()
}

impl<const V: usize, const S: usize> ShearProfile<V, S> {
    /// Replaces the membrane forces at the integration points if the section has a law of them.
    ///
    /// Such an element has no enhanced strains and its section no coupling, so that membrane forces depend on the membrane strains at
    /// their point only.
    fn with_forces(
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

impl<const V: usize, const S: usize, const C: usize> LawElement for ShearElement<V, S, C> {
    fn law(&self) -> Option<&MembranePoints> {
        self.profile.membrane.as_ref()
    }

    fn membrane_points(&self) -> usize {
        self.profile.shape.surface_points().len()
    }

    fn membrane_at(&self, strains: &Strains<S>, point: usize) -> Vector3<f64> {
        membrane(strains, point)
    }

    fn set_forces(&self, stress: &mut Strains<S>, force: &dyn Fn(usize) -> Vector3<f64>) {
        *stress = self.profile.with_forces(*stress, |_, k| force(k));
    }

    fn add_membrane_stiffness(
        &self,
        q: &[f64],
        stiffness: &dyn Fn(usize) -> Matrix3<f64>,
        k: &mut LocalMatrix<'_>,
    ) {
        let gradients = self.state(q).gradients;
        for point in 0..self.membrane_points() {
            let rows = gradients.fixed_rows::<3>(SURFACE * point);
            let matrix = rows.transpose() * (stiffness(point) * rows);
            for j in 0..C {
                let column = k.column_mut(j);
                (j..C).for_each(|i| column[i - j] += matrix[(i, j)]);
            }
        }
    }
}
