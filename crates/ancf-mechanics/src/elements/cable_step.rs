//! Forces of cables in steps of the energy-momentum scheme.

use ancf_solver::equations::{LocalStep, Weights};
use nalgebra::{Matrix3, Vector3};

use super::cable_profile::{CableDamping, CableProfile, CableStation};
use crate::kinematics::{AxialStretch, Bend};

/// Step of one cable element with its data.
pub(super) struct CableStep<'a> {
    pub(super) profile: &'a CableProfile,
    pub(super) direction: &'a Vector3<f64>,
    pub(super) step: &'a LocalStep<'a>,
}

/// Returns the vectors of a slice of coordinates.
pub(super) fn vectors(x: &[f64]) -> [Vector3<f64>; 4] {
    std::array::from_fn(|i| Vector3::new(x[3 * i], x[3 * i + 1], x[3 * i + 2]))
}

impl CableStep<'_> {
    /// Adds the forces of a step: elastic ones with discrete derivatives, and viscous ones in its middle.
    pub(super) fn add_forces(&self, force: &mut [Vector3<f64>; 4]) {
        let (profile, step) = (self.profile, self.step);
        let CableDamping { stretch: stretching, bending, .. } = profile.damping();
        let (q, v) = (vectors(step.middle.q), vectors(step.middle.v));
        for station in profile.axial() {
            let (n, stretch) = self.stretch_of_step(station);
            let mut of_a = stretch.tangent * n;
            if stretching != 0.0 {
                let tangent = AxialStretch::new(self.direction, &station.first(&q)).tangent;
                of_a += tangent * (stretching * profile.section().axial * tangent.dot(&station.first(&v)));
            }
            for (force, s) in force.iter_mut().zip(station.first) {
                *force += of_a * (station.weight * s);
            }
        }
        for station in profile.bending() {
            let [mut of_a, mut of_b] = self.bending_of_step(station);
            if bending != 0.0 {
                let bend = Bend::new(self.direction + station.first(&q), station.second(&q));
                let [a, b] =
                    bend.force(&(bend.rate(&station.both(&v)) * (bending * profile.section().bending)));
                (of_a, of_b) = (of_a + a, of_b + b);
            }
            for (i, force) in force.iter_mut().enumerate() {
                *force += (of_a * station.first[i] + of_b * station.second[i]) * station.weight;
            }
        }
    }

    /// Returns the axial force of a step, and the stretch with the mean length and the direction 2 r′_m/(|r′₀| + |r′₁|).
    ///
    /// With ε = |r′| − 1, the change Δε is exactly this direction times Δr′.
    fn stretch_of_step(&self, station: &CableStation) -> (f64, AxialStretch) {
        let [from, to] = [self.step.from, self.step.to]
            .map(|at| AxialStretch::new(self.direction, &station.first(&vectors(at.q))));
        let [start, end] = self.step.shares();
        let (strain, length) = (start * from.strain + end * to.strain, 0.5 * (from.length + to.length));
        let a = self.direction + station.first(&vectors(self.step.middle.q));
        (self.profile.section().axial * strain, AxialStretch { strain, length, tangent: a / length })
    }

    /// Returns a symmetric tangent of the axial force of a step by r′.
    pub(super) fn axial_stiffness(&self, station: &CableStation, w: Weights) -> Matrix3<f64> {
        let (rigidity, tau) = (self.profile.section().axial, self.profile.damping().stretch);
        let (n, stretch) = self.stretch_of_step(station);
        let stretch = AxialStretch { tangent: stretch.tangent.normalize(), ..stretch };
        let retarded = tau * rigidity * stretch.tangent.dot(&station.first(&vectors(self.step.middle.v)));
        stretch.stiffness(rigidity * (2.0 * self.step.shares()[1] * w.q + w.v * tau), w.q * (n + retarded))
    }

    /// Returns the forces of bending on r′ and r″ in a step.
    ///
    /// With the products A = a·a, C = a·b, B = b·b of a = r′ and b = r″, K² = x − y² with x = B/A, y = C/A. From
    /// ΔB = x̄ ΔA + Ā Δx and ΔC = ȳ ΔA + Ā Δy, with means of both ends,
    ///
    /// Ā ΔK² = ΔB − 2ȳ ΔC + (2ȳ² − x̄) ΔA
    ///
    /// exactly, and ΔA = 2 a_m·Δa, ΔB = 2 b_m·Δb, ΔC = a_m·Δb + b_m·Δa. The numerical damping multiplies the forces by
    /// 1 + χ ΔK²/(K₀² + K₁²).
    fn bending_of_step(&self, station: &CableStation) -> [Vector3<f64>; 2] {
        let [from, middle, to] = [self.step.from, self.step.middle, self.step.to].map(|at| {
            let [u, b] = station.both(&vectors(at.q));
            [self.direction + u, b]
        });
        let ratios = |[a, b]: &[Vector3<f64>; 2]| {
            let aa = a.dot(a);
            [aa, b.dot(b) / aa, a.dot(b) / aa]
        };
        let (ends, [a, b]) = ([ratios(&from), ratios(&to)], middle);
        let [aa, x, y] = std::array::from_fn(|i| 0.5 * (ends[0][i] + ends[1][i]));
        let [before, now] = ends.map(|[_, x, y]| x - y * y);
        let damping =
            if before + now > 0.0 { self.step.damping * (now - before) / (before + now) } else { 0.0 };
        let factor = self.profile.section().bending * (1.0 + damping) / aa;
        [(a * (2.0 * y * y - x) - b * y) * factor, (b - a * y) * factor]
    }
}
