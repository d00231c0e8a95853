use serde::{Deserialize, Serialize};

use super::SAME;
use super::auxiliary::{Auxiliary, AuxiliaryReference};
use crate::sparse::SparseMatrix;

/// Quantities of the last step before shorter ones, from which a longer step starts again.
///
/// In short steps, flexible bodies perform vibrations that longer steps do not resolve. Their accelerations would multiply the
/// velocities of a longer step.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct StepReference {
    /// Size H of that step.
    h: f64,
    /// Time since that step.
    age: f64,
    pub(super) acceleration: AuxiliaryReference,
    pub(super) damping: AuxiliaryReference,
    /// Velocities w with Φ_q w = u, the velocities along constraints. They are proportional to the square of the step.
    drift: Vec<f64>,
}

/// Smallest growth that starts from a reference of at most [`NEAR`] new steps, and from a longer one. Smaller growths start from
/// the last step: they multiply vibrations less, and the last step is more recent.
const GROWTH: [f64; 2] = [1.5, 2.1];
/// Size of a reference up to which it is near, in new steps.
const NEAR: f64 = 3.0;
/// Age, in steps H, up to which a − v̇ and the velocities along constraints are those of a smooth motion, with errors of second order.
const RECENT: f64 = 4.0;

impl StepReference {
    /// Creates the reference of a step H.
    pub(super) fn new(h: f64, acceleration: &Auxiliary<'_>, damping: &Auxiliary<'_>) -> Self {
        let drift = vec![0.0; acceleration.actual.len()];
        let [acceleration, damping] = [acceleration, damping].map(AuxiliaryReference::new);
        Self { h, age: 0.0, drift, acceleration, damping }
    }

    /// Sets the velocities along constraints.
    pub(super) fn set_drift(&mut self, drift: impl Iterator<Item = f64>) {
        self.drift.iter_mut().zip(drift).for_each(|(own, drift)| *own = drift);
    }

    /// Returns Φ_q v of the velocities v along constraints for a step with the given ratio to that of the reference.
    ///
    /// `matrix` has the rows Φ_q; the other arguments are working storage.
    pub(super) fn constraint_velocities(
        &self,
        matrix: &SparseMatrix,
        ratio: f64,
        z: &mut [f64],
        r: &mut [f64],
    ) -> Vec<f64> {
        let n = self.drift.len();
        z.fill(0.0);
        z[..n].copy_from_slice(&self.drift);
        matrix.multiply(z, r);
        r[n..].iter().map(|u| ratio * ratio * u).collect()
    }

    /// Returns true if a − v̇ and the velocities along constraints are recent.
    pub(super) fn is_recent(&self) -> bool {
        self.age <= RECENT * self.h
    }

    /// Returns true if the last step, before a shorter one, replaces the reference.
    pub(super) fn is_replaced_by(&self, last: f64) -> bool {
        !self.is_recent() || NEAR * last >= self.h
    }

    /// Returns the size of a new step relative to the reference, if it starts from there. `growth` is relative to the last step.
    pub(super) fn ratio(&self, h: f64, growth: f64) -> Option<f64> {
        let [near, far] = GROWTH;
        let least = if self.h <= NEAR * h { near } else { far };
        (growth > least).then_some(h / self.h)
    }

    /// Includes an accepted step h with its auxiliary accelerations and damping forces. Returns false if it is as long as that of the
    /// reference.
    pub(crate) fn record(&mut self, h: f64, acceleration: &[f64], damping: &[f64]) -> bool {
        self.age += h;
        let share = -(-h / self.h).exp_m1();
        self.acceleration.record(share, acceleration);
        self.damping.record(share, damping);
        h < (1.0 - SAME) * self.h
    }

    /// Returns true if the reference has the given size and is finite.
    pub(crate) fn is_valid(&self, coordinates: usize) -> bool {
        let Self { h, age, acceleration, damping, drift } = self;
        let mut vectors =
            [acceleration, damping].into_iter().flat_map(AuxiliaryReference::vectors).chain([drift]);
        *h > 0.0
            && *age >= 0.0
            && [h, age].iter().all(|x| x.is_finite())
            && vectors.all(|x| x.len() == coordinates && x.iter().all(|x| x.is_finite()))
    }
}
