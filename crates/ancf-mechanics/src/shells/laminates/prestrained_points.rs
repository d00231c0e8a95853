//! Changes of the membrane forces at integration points by prescribed strains.

use nalgebra::{Matrix3, Vector3};

use super::membrane_points::MembranePoints;

/// Differences between strains with prescribed ones and the same strains without: an element has the latter.
impl MembranePoints {
    /// Returns the change of the energy at a point.
    pub(crate) fn energy_change(&self, k: usize, strains: [&Vector3<f64>; 2]) -> f64 {
        let [strain, prescribed] = self.local(k, strains);
        let [with, without] =
            [self.law.strained_state([&strain, &prescribed]), self.law.state(&strain)].map(|of| of.energy);
        self.points[k].1 * (with - without)
    }

    /// Returns the forces with and without the prescribed strains at a point, contravariant.
    pub(crate) fn forces(&self, k: usize, strains: [&Vector3<f64>; 2]) -> [Vector3<f64>; 2] {
        let [strain, prescribed] = self.local(k, strains);
        [self.law.strained_state([&strain, &prescribed]), self.law.state(&strain)]
            .map(|state| self.contravariant(k, &state.force))
    }

    /// Returns the change of the stiffness at a point.
    pub(crate) fn stiffness_change(&self, k: usize, strains: [&Vector3<f64>; 2]) -> Matrix3<f64> {
        let [strain, prescribed] = self.local(k, strains);
        let (to_local, area) = &self.points[k];
        let change =
            self.law.strained_state([&strain, &prescribed]).stiffness - self.law.state(&strain).stiffness;
        to_local.transpose() * change * to_local * *area
    }

    /// Returns the force −∂W/∂ε⁰ on the prescribed strains at a point, contravariant.
    pub(crate) fn prescribed_force(&self, k: usize, strains: [&Vector3<f64>; 2]) -> Vector3<f64> {
        let [strain, prescribed] = self.local(k, strains);
        self.contravariant(k, &self.law.prescribed_force([&strain, &prescribed]))
    }

    /// Returns the change of the forces at a point for small changes of both strains, less that without prescribed strains.
    pub(crate) fn rate_change(
        &self,
        k: usize,
        strains: [&Vector3<f64>; 2],
        rates: [&Vector3<f64>; 2],
    ) -> Vector3<f64> {
        let [strain, prescribed] = self.local(k, strains);
        let [rate, of_prescribed] = self.local(k, rates);
        let change = self.law.force_change([&strain, &prescribed], [&rate, &of_prescribed])
            - self.law.state(&strain).stiffness * rate;
        self.contravariant(k, &change)
    }

    /// Returns the change of the [correction](Self::correction) of the force of a step at a point.
    pub(crate) fn correction_change(
        &self,
        k: usize,
        ends: [Vector3<f64>; 2],
        prescribed: &Vector3<f64>,
    ) -> Vector3<f64> {
        self.correction_from(k, ends, prescribed) - self.correction(k, ends)
    }

    fn local(&self, k: usize, strains: [&Vector3<f64>; 2]) -> [Vector3<f64>; 2] {
        strains.map(|strain| self.points[k].0 * strain)
    }

    fn contravariant(&self, k: usize, force: &Vector3<f64>) -> Vector3<f64> {
        let (to_local, area) = &self.points[k];
        to_local.transpose() * force * *area
    }
}
