//! Membrane forces of thin shells by a law that is not linear in the strains.

use nalgebra::{SMatrix, Vector3};

use super::membrane_stiffness::MembraneStiffness;
use super::profile::ShellProfile;
use super::surface_state::ShellStrains;
use super::tables::{MEMBRANE, POINTS, ShellTables, integration_points};
use crate::shells::laminates::{MembranePoints, to_orthonormal};

/// Law of the membrane forces at the integration points of an element.
#[derive(Clone, Debug)]
pub(crate) struct NonlinearMembrane(pub(super) MembranePoints);

impl NonlinearMembrane {
    /// Creates the law at the points of an element; `None` for a linear one.
    pub(crate) fn new(profile: &ShellProfile) -> Option<Self> {
        let of = |(k, (_, weight)): (usize, ([f64; 2], f64))| {
            let point = profile.points.at(k);
            let [t, s, ..] = &point.reference;
            (to_orthonormal([t, s], t), weight * point.area * profile.scale(k))
        };
        let points = integration_points().into_iter().enumerate().map(of);
        MembranePoints::new(&profile.medium.section, points).map(Self)
    }

    /// Computes the stresses of an element, integrated with the weights of the points.
    pub(crate) fn stress(
        &self,
        (tables, profile): (&ShellTables, &ShellProfile),
        strains: &ShellStrains,
    ) -> ShellStrains {
        let mut stress = profile.moments(strains);
        for k in 0..POINTS {
            let force = self.0.force(k, &tables.membrane_strain(k, &strains.membrane));
            tables.add_membrane_force(k, &force, &mut stress.membrane);
        }
        stress
    }

    /// Computes the strain energy of an element.
    pub(crate) fn strain_energy(
        &self,
        (tables, profile): (&ShellTables, &ShellProfile),
        strains: &ShellStrains,
    ) -> f64 {
        let of_point = |k: usize| self.0.energy(k, &tables.membrane_strain(k, &strains.membrane));
        0.5 * profile.moments(strains).product(strains) + (0..POINTS).map(of_point).sum::<f64>()
    }

    /// Computes multiples of the stiffness of the membrane strains in a state and of the linear one.
    pub(crate) fn stiffness(
        &self,
        tables: &ShellTables,
        strains: &ShellStrains,
        shares: [f64; 2],
    ) -> MembraneStiffness {
        let mut sum = SMatrix::<f64, MEMBRANE, MEMBRANE>::zeros();
        for k in 0..POINTS {
            let stiffness = self.0.stiffness(k, &tables.membrane_strain(k, &strains.membrane), shares);
            tables.add_membrane_stiffness(k, &stiffness, &mut sum);
        }
        MembraneStiffness::new(&sum)
    }

    /// Computes the stresses of strains between those at both ends of a step, with membrane forces that do the work of the energy on the
    /// change of the membrane strains.
    pub(crate) fn step_stress(
        &self,
        (tables, profile): (&ShellTables, &ShellProfile),
        strains: &ShellStrains,
        ends: [&ShellStrains; 2],
    ) -> ShellStrains {
        let mut stress = self.stress((tables, profile), strains);
        for k in 0..POINTS {
            let correction = self.0.correction(k, ends.map(|end| tables.membrane_strain(k, &end.membrane)));
            if correction != Vector3::zeros() {
                tables.add_membrane_force(k, &correction, &mut stress.membrane);
            }
        }
        stress
    }
}
