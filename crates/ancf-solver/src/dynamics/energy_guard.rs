use serde::{Deserialize, Serialize};

use super::damping_work::PowerIntegral;
use crate::equations::{Energy, Power, State};
use crate::factor::Factor;

/// Limits of the error of the energy balance, relative to the exchanged energy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EnergyGuard {
    /// Largest rise of the energy without supply, above any earlier state.
    pub gain: f64,
}

impl Default for EnergyGuard {
    fn default() -> Self {
        Self { gain: Self::GAIN }
    }
}

/// Energy that the integration itself makes or loses: the change of the energies less work plus dissipation.
///
/// The reference is the exchanged energy: the largest sum of kinetic energy and magnitude of the strain energy, plus the magnitudes of the work
/// and of the dissipation of all steps. Energy that the integration makes is not included.
///
/// At a start from rest the exchanged energy is that of a few steps, and its relative error does not decrease with the
/// step. Gains are therefore counted only while half of the reference is older than about twenty steps.
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub struct EnergyRecord {
    /// Energy made since the start; negative if energy was lost.
    made: f64,
    /// Smallest and largest value so far.
    least: f64,
    most: f64,
    /// Largest sum of kinetic and strain energy, and largest magnitude of an energy and of the sum of the parts of energies.
    largest: f64,
    magnitude: f64,
    /// Sum of the magnitudes of work and dissipation.
    exchanged: f64,
    /// Delayed reference.
    delayed: f64,
    /// Decrease of the dissipated energy since its largest value, by damping forces that dissipate at both ends of a step in which the
    /// energy rises, and its largest value. It is energy that the integration made, which the work of the damping forces hides.
    decrease: f64,
    most_decrease: f64,
    /// Number of attempted steps that made too much energy.
    pub(crate) rejected: u32,
}

/// Share of a step in the delayed reference.
const DELAY: f64 = 0.05;
/// Smallest ratio of the delayed reference to the reference for which gains are counted.
const SETTLED: f64 = 0.5;
/// Gain that counts as rounding, relative to the largest energy.
const ROUNDING: f64 = 1e-9;
/// Rounding error of positions, relative to a length.
pub(super) const POSITION_ROUNDING: f64 = 8.0 * f64::EPSILON;

impl EnergyGuard {
    /// Default of the gain.
    pub const GAIN: f64 = 0.05;

    /// Returns true if a step to the record `now` is permitted. `rounding` computes the energy of rounding errors.
    pub(crate) fn permits(&self, now: &EnergyRecord, rounding: impl FnOnce() -> f64) -> bool {
        let limit = self.gain * now.reference() + now.rounding();
        now.gain() <= limit || now.gain() <= limit + rounding()
    }
}

impl EnergyRecord {
    /// Creates the record of a start with its energies, and the sum of the magnitudes of their parts.
    pub(crate) fn new(start: Energy, size: f64) -> Self {
        let largest = start.kinetic + start.strain.abs();
        Self { largest, magnitude: start.largest().max(size), delayed: largest, ..Self::default() }
    }

    /// Includes the sum of the magnitudes of the parts of energies, which may cancel.
    pub(crate) fn include_size(&mut self, size: f64) {
        self.magnitude = self.magnitude.max(size);
    }

    /// Returns the energy of rounding errors, relative to the largest energy.
    pub fn rounding(&self) -> f64 {
        ROUNDING * self.magnitude
    }

    /// Returns the exchanged energy, to which gain and loss are relative.
    pub fn reference(&self) -> f64 {
        (self.largest + self.exchanged - self.gain()).max(0.0)
    }

    /// Returns the energy made since the smallest value.
    fn gain(&self) -> f64 {
        self.made - self.least
    }

    /// Returns the energy lost by the integration since the start; negative if energy was made.
    pub fn lost(&self) -> f64 {
        -self.made
    }

    /// Returns the largest energy that the integration made since the start, with the gains of a start from rest.
    pub fn created(&self) -> f64 {
        self.most
    }

    /// Returns the largest decrease of the dissipated energy by damping forces that dissipate at both ends of a step. In steps of a fixed
    /// size it is energy that the integration made; a growing step changes the velocities that damping forces act on.
    pub fn hidden(&self) -> f64 {
        self.most_decrease
    }

    /// Returns the number of attempted steps that made too much energy and were rejected.
    pub fn rejected(&self) -> u32 {
        self.rejected
    }

    /// Returns the record after a step, in which the dissipated energy decreases by `decrease` without a reason.
    pub(crate) fn after(self, (before, now): (Energy, Energy), exchange: Power, decrease: f64) -> Self {
        let rise = now.total() - before.total() - exchange.work;
        let decrease = (self.decrease + decrease.min(rise.max(0.0))).max(0.0);
        let made = self.made + rise + exchange.dissipation;
        let next = Self {
            made,
            least: self.least.min(made),
            most: self.most.max(made),
            largest: self.largest.max(now.kinetic + now.strain.abs()),
            magnitude: self.magnitude.max(now.largest()),
            exchanged: self.exchanged + exchange.work.abs() + exchange.dissipation.abs(),
            decrease,
            most_decrease: self.most_decrease.max(decrease),
            ..self
        };
        let reference = next.reference();
        let least = if self.delayed <= SETTLED * reference { made } else { next.least };
        Self { least, delayed: self.delayed + DELAY * (reference - self.delayed), ..next }
    }

    /// Returns true if the energies are finite.
    pub(crate) fn is_valid(&self) -> bool {
        let Self {
            made, least, most, largest, magnitude, exchanged, delayed, decrease, most_decrease, ..
        } = self;
        [made, least, most, largest, magnitude, exchanged, delayed, decrease, most_decrease]
            .iter()
            .all(|x| x.is_finite())
    }
}

/// Energies at the end of an attempted step.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct EnergyAttempt {
    pub(crate) energy: Energy,
    pub(crate) power: PowerIntegral,
    pub(crate) exchange: Power,
    pub(crate) record: EnergyRecord,
    /// Number of attempts since the last accepted step that made too much energy.
    pub(crate) rejected: u32,
}

/// Returns the coordinate with the largest change of velocity, measured as energy.
pub(crate) fn fastest_change(now: &State, before: &State, factor: &Factor) -> usize {
    let change = |i: usize| ((now.v[i] - before.v[i]) / factor.scale(i)).abs();
    (0..now.v.len()).max_by(|i, j| change(*i).total_cmp(&change(*j))).unwrap_or(0)
}
