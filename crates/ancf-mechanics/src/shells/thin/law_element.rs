//! Prescribed strains of thin shell elements with a law of the membrane forces.

use ancf_solver::equations::LocalMatrix;
use nalgebra::{Matrix3, SMatrix, Vector3};

use super::element::Shell48;
use super::hermite::VECTORS;
use super::surface_state::ShellStrains;
use super::tables::{MEMBRANE, POINTS};
use crate::shells::laminates::MembranePoints;
use crate::shells::prestrain::LawElement;

/// Number of coordinates of an element.
const COORDINATES: usize = 3 * VECTORS;

impl LawElement for Shell48 {
    fn law(&self) -> Option<&MembranePoints> {
        self.nonlinear.as_ref().map(|membrane| &membrane.0)
    }

    fn membrane_points(&self) -> usize {
        POINTS
    }

    fn membrane_at(&self, strains: &ShellStrains, point: usize) -> Vector3<f64> {
        self.data().0.membrane_strain(point, &strains.membrane)
    }

    fn set_forces(&self, stress: &mut ShellStrains, force: &dyn Fn(usize) -> Vector3<f64>) {
        stress.membrane = [0.0; MEMBRANE];
        for k in 0..POINTS {
            self.data().0.add_membrane_force(k, &force(k), &mut stress.membrane);
        }
    }

    fn add_membrane_stiffness(
        &self,
        q: &[f64],
        stiffness: &dyn Fn(usize) -> Matrix3<f64>,
        k: &mut LocalMatrix<'_>,
    ) {
        let (tables, _) = self.data();
        let mut sum = SMatrix::<f64, MEMBRANE, MEMBRANE>::zeros();
        for point in 0..POINTS {
            tables.add_membrane_stiffness(point, &stiffness(point), &mut sum);
        }
        let rows = self.state(q).membrane_rows(tables);
        let gradients = SMatrix::<f64, MEMBRANE, COORDINATES>::from_fn(|t, i| rows[t][i % 3].0[i / 3]);
        let matrix = gradients.transpose() * (sum * gradients);
        k.add_lower(COORDINATES, |i, j| matrix[(i, j)]);
    }
}
