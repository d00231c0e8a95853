//! Prescribed strains of shear-deformable shell elements with a law of the membrane forces.

use ancf_solver::equations::LocalMatrix;
use nalgebra::{Matrix3, SMatrix, Vector3};

use super::element::ShearElement;
use super::membrane::membrane;
use super::strains::{SURFACE, Strains};
use crate::shells::laminates::MembranePoints;
use crate::shells::prestrain::LawElement;

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
        let gradients = self.gradients(&self.state(q));
        for point in 0..self.membrane_points() {
            let rows = SMatrix::<f64, 3, C>::from_fn(|i, j| gradients[SURFACE * point + i][j]);
            let matrix = rows.transpose() * (stiffness(point) * rows);
            k.add_lower(C, |i, j| matrix[(i, j)]);
        }
    }
}
