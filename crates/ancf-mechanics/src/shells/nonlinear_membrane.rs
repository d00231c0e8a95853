//! Membrane forces of thin shells by a law that is not linear in the strains.

use nalgebra::{Matrix3, SMatrix, Vector3};

use super::laminates::{MembraneLaw, MembraneState, to_orthonormal};
use super::profile::{
    BendingPoint, MEMBRANE, MembraneStiffness, POINTS, ShellProfile, ShellTables, integration_points,
};
use super::surface_state::ShellStrains;

/// Law of the membrane forces at the integration points of an element.
#[derive(Clone, Debug)]
pub(crate) struct NonlinearMembrane {
    law: MembraneLaw,
    /// Matrix from covariant components of strains to an orthonormal basis, and the area of each point times its relative thickness.
    points: Vec<(Matrix3<f64>, f64)>,
}

/// Multiple of the rounding error of the work of a step below which no correction is made.
const ROUNDING: f64 = 8.0;

impl NonlinearMembrane {
    /// Creates the law at the points of an element; `None` for a linear one.
    pub(crate) fn new(profile: &ShellProfile) -> Option<Self> {
        let law = profile.medium.section.law?;
        let of = |(k, (point, (_, weight))): (usize, (&BendingPoint, ([f64; 2], f64)))| {
            let [t, s, ..] = &point.reference;
            (to_orthonormal([t, s], t), weight * point.area * profile.scale(k))
        };
        Some(Self {
            law,
            points: profile.points.iter().zip(integration_points()).enumerate().map(of).collect(),
        })
    }

    /// Returns the state at a point with a covariant strain.
    fn state(&self, k: usize, strain: &Vector3<f64>) -> MembraneState {
        self.law.state(&(self.points[k].0 * strain))
    }

    /// Computes the stresses of an element, integrated with the weights of the points.
    pub(crate) fn stress(
        &self,
        (tables, profile): (&ShellTables, &ShellProfile),
        strains: &ShellStrains,
    ) -> ShellStrains {
        let mut stress = profile.moments(strains);
        for (k, (to_local, area)) in self.points.iter().enumerate() {
            let state = self.state(k, &tables.membrane_strain(k, &strains.membrane));
            tables.add_membrane_force(k, &(to_local.transpose() * state.force * *area), &mut stress.membrane);
        }
        stress
    }

    /// Computes the strain energy of an element.
    pub(crate) fn strain_energy(
        &self,
        (tables, profile): (&ShellTables, &ShellProfile),
        strains: &ShellStrains,
    ) -> f64 {
        let of_point =
            |k: usize| self.points[k].1 * self.state(k, &tables.membrane_strain(k, &strains.membrane)).energy;
        0.5 * profile.moments(strains).product(strains) + (0..POINTS).map(of_point).sum::<f64>()
    }

    /// Computes multiples of the stiffness of the membrane strains in a state and of the linear one.
    pub(crate) fn stiffness(
        &self,
        (tables, profile): (&ShellTables, &ShellProfile),
        strains: &ShellStrains,
        [of_state, of_linear]: [f64; 2],
    ) -> MembraneStiffness {
        let mut sum = SMatrix::<f64, MEMBRANE, MEMBRANE>::zeros();
        let linear = profile.medium.section.membrane;
        for (k, (to_local, area)) in self.points.iter().enumerate() {
            let state = self.state(k, &tables.membrane_strain(k, &strains.membrane));
            let local = state.stiffness * of_state + linear * of_linear;
            tables.add_membrane_stiffness(k, &(to_local.transpose() * local * to_local * *area), &mut sum);
        }
        MembraneStiffness::new(&sum)
    }

    /// Computes the stresses of strains between those at both ends of a step, with membrane forces that do the work of the energy on the
    /// change of the membrane strains.
    ///
    /// The forces n of the mean strains get the correction Δε (ΔW − n·Δε)/(Δε·Δε) at each point.
    ///
    /// Source: Gonzalez (2000), discrete derivatives in the strains: momenta are preserved.
    pub(crate) fn step_stress(
        &self,
        (tables, profile): (&ShellTables, &ShellProfile),
        strains: &ShellStrains,
        [before, after]: [&ShellStrains; 2],
    ) -> ShellStrains {
        let mut stress = self.stress((tables, profile), strains);
        for (k, (to_local, area)) in self.points.iter().enumerate() {
            let [from, to] = [before, after].map(|ends| to_local * tables.membrane_strain(k, &ends.membrane));
            let [start, middle, end] = [from, (from + to) * 0.5, to].map(|strain| self.law.state(&strain));
            let moved = to - from;
            let missed = end.energy - start.energy - middle.force.dot(&moved);
            let bound =
                f64::EPSILON * (end.energy.abs() + start.energy.abs() + middle.force.norm() * moved.norm());
            if missed.abs() > ROUNDING * bound && moved != Vector3::zeros() {
                let force = moved * (missed / moved.norm_squared());
                tables.add_membrane_force(k, &(to_local.transpose() * force * *area), &mut stress.membrane);
            }
        }
        stress
    }
}
