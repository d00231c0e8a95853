use nalgebra::{Matrix3, Vector3};

use super::membrane_law::{MembraneLaw, MembraneState};
use super::section::ShellSection;

/// Bound of the rounding error of the change of the energy, in roundings of its terms.
const ROUNDING: f64 = 8.0;
/// Place √(3/5) and half of the weight 5/9 of the outer points of the Gauss rule of three points.
const GAUSS: f64 = 0.774_596_669_241_483_4;
const WEIGHT: f64 = 5.0 / 18.0;

/// Law of the membrane forces at the integration points of an element, for covariant strains (ξξ, ηη, 2 ξη).
///
/// Energies, forces and stiffness are multiplied by the areas of the points times their relative thicknesses.
#[derive(Clone, Debug)]
pub(crate) struct MembranePoints {
    pub(super) law: MembraneLaw,
    /// Linear stiffness A of the section.
    linear: Matrix3<f64>,
    /// Matrix from covariant components of strains to an orthonormal basis, and the area of each point times its relative thickness.
    pub(super) points: Vec<(Matrix3<f64>, f64)>,
}

impl MembranePoints {
    /// Creates the law at points with their matrices to an orthonormal basis and their areas times relative thicknesses; `None` for a linear law.
    pub(crate) fn new(
        section: &ShellSection,
        points: impl IntoIterator<Item = (Matrix3<f64>, f64)>,
    ) -> Option<Self> {
        let (law, linear) = (section.law?, section.membrane);
        Some(Self { law, linear, points: points.into_iter().collect() })
    }

    fn state(&self, k: usize, strain: &Vector3<f64>) -> MembraneState {
        self.law.state(&(self.points[k].0 * strain))
    }

    /// Returns the energy at a point.
    pub(crate) fn energy(&self, k: usize, strain: &Vector3<f64>) -> f64 {
        self.points[k].1 * self.state(k, strain).energy
    }

    /// Returns the force at a point, contravariant.
    pub(crate) fn force(&self, k: usize, strain: &Vector3<f64>) -> Vector3<f64> {
        let (to_local, area) = &self.points[k];
        to_local.transpose() * self.state(k, strain).force * *area
    }

    /// Returns multiples of the stiffness in a state and of the linear one at a point.
    pub(crate) fn stiffness(
        &self,
        k: usize,
        strain: &Vector3<f64>,
        [of_state, of_linear]: [f64; 2],
    ) -> Matrix3<f64> {
        let (to_local, area) = &self.points[k];
        let local = self.state(k, strain).stiffness * of_state + self.linear * of_linear;
        to_local.transpose() * local * to_local * *area
    }

    /// Returns the correction of the force of the mean strain of a step, with which it does the work of the energy on the change of
    /// the strain: Δε (ΔW − n·Δε)/(Δε·Δε).
    ///
    /// The difference of energies has a rounding error, which small steps divide by Δε. Where the integral of the forces by the Gauss rule
    /// of three points agrees with it, the integral is used, which has none.
    ///
    /// Source: Gonzalez (2000), discrete derivatives in the strains: momenta are preserved.
    pub(crate) fn correction(&self, k: usize, ends: [Vector3<f64>; 2]) -> Vector3<f64> {
        self.correction_from(k, ends, &Vector3::zeros())
    }

    /// Returns the [correction](Self::correction) with constant prescribed strains.
    pub(super) fn correction_from(
        &self,
        k: usize,
        [before, after]: [Vector3<f64>; 2],
        prescribed: &Vector3<f64>,
    ) -> Vector3<f64> {
        let (to_local, area) = &self.points[k];
        let [from, to, free] = [before, after, *prescribed].map(|strain| to_local * strain);
        let (mean, moved) = ((from + to) * 0.5, to - from);
        if moved == Vector3::zeros() {
            return Vector3::zeros();
        }
        let state = |strain: Vector3<f64>| self.law.strained_state([&strain, &free]);
        let [start, middle, end] = [from, mean, to].map(state);
        let difference = end.energy - start.energy - middle.force.dot(&moved);
        let bound = ROUNDING
            * f64::EPSILON
            * (end.energy.abs() + start.energy.abs() + middle.force.norm() * moved.norm());
        let [first, last] = [-GAUSS, GAUSS].map(|place| state(mean + moved * (0.5 * place)).force);
        let integral = (first + last - middle.force * 2.0).dot(&moved) * WEIGHT;
        let missed = if (difference - integral).abs() <= bound { integral } else { difference };
        to_local.transpose() * moved * (missed / moved.norm_squared() * area)
    }
}
