use serde::{Deserialize, Serialize};

use super::damping_work::PowerIntegral;
use super::time_stepper::TimeStepper;
use crate::equations::{Energy, EquationsOfMotion, Power};
use crate::newton::{NewtonReport, SolveError, SolveFailure};

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
/// The reference is the exchanged energy: the largest sum of kinetic and strain energy, plus the magnitudes of the work
/// and of the dissipation of all steps. Energy that the integration makes does not count.
///
/// At a start from rest the exchanged energy is that of a few steps, and its relative error does not decrease with the
/// step. Gains are therefore counted only while half of the reference is older than about twenty steps.
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub struct EnergyRecord {
    /// Energy made since the start; negative if energy was lost.
    made: f64,
    /// Smallest value so far.
    least: f64,
    /// Largest sum of kinetic and strain energy, and largest magnitude of an energy.
    largest: f64,
    magnitude: f64,
    /// Sum of the magnitudes of work and dissipation.
    exchanged: f64,
    /// Delayed reference.
    delayed: f64,
    /// Number of attempted steps that made too much energy.
    refused: u32,
}

/// Share of a step in the delayed reference.
const DELAY: f64 = 0.05;
/// Smallest ratio of the delayed reference to the reference for which gains are counted.
const SETTLED: f64 = 0.5;
/// Gain that counts as rounding, relative to the largest energy.
const ROUNDING: f64 = 1e-9;

impl EnergyGuard {
    /// Default of the gain.
    pub const GAIN: f64 = 0.05;

    /// Returns true if a step to the record `now` is permitted.
    pub(crate) fn permits(&self, now: &EnergyRecord) -> bool {
        now.made - now.least <= self.gain * now.reference() + ROUNDING * now.magnitude
    }
}

impl EnergyRecord {
    pub(crate) fn new(start: Energy) -> Self {
        let largest = start.kinetic + start.strain;
        Self { largest, magnitude: start.largest(), delayed: largest, ..Self::default() }
    }

    /// Returns the exchanged energy, to which gain and loss are relative.
    pub fn reference(&self) -> f64 {
        (self.largest + self.exchanged - (self.made - self.least)).max(0.0)
    }

    /// Returns the energy lost by the integration since the start; negative if energy was made.
    pub fn lost(&self) -> f64 {
        -self.made
    }

    /// Returns the number of attempted steps that made too much energy and were refused.
    pub fn refused(&self) -> u32 {
        self.refused
    }

    /// Returns the record after a step.
    pub(crate) fn after(self, (before, now): (Energy, Energy), exchange: Power) -> Self {
        let made = self.made + (now.total() - before.total()) - exchange.work + exchange.dissipation;
        let next = Self {
            made,
            least: self.least.min(made),
            largest: self.largest.max(now.kinetic + now.strain),
            magnitude: self.magnitude.max(now.largest()),
            exchanged: self.exchanged + exchange.work.abs() + exchange.dissipation.abs(),
            ..self
        };
        let reference = next.reference();
        let least = if self.delayed < SETTLED * reference { made } else { next.least };
        Self { least, delayed: self.delayed + DELAY * (reference - self.delayed), ..next }
    }

    /// Returns true if the energies are finite.
    pub(crate) fn is_valid(&self) -> bool {
        [self.made, self.least, self.largest, self.magnitude, self.exchanged, self.delayed]
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
}

impl<E: EquationsOfMotion> TimeStepper<'_, E> {
    /// Computes energies, work and dissipation at the end of an attempt. Reverts it if it made too much energy.
    pub(crate) fn check_energy(&mut self, done: NewtonReport, to: f64) -> Result<NewtonReport, SolveError> {
        let (integral, exchange) = match self.scheme.averaging {
            None => self.exchange_of_step(),
            Some(_) => {
                let Self { eom, motion, before, damping, .. } = self;
                self.middle.exchange(&**eom, (before, &motion.state), &mut damping.force)
            }
        };
        let energy = self.eom.energy(&self.motion.state);
        let record = self.motion.record.after((self.motion.energy, energy), exchange);
        self.energies = EnergyAttempt { energy, power: integral, exchange, record };
        if self.guard.permits(&record) {
            return Ok(done);
        }
        self.motion.record.refused = self.motion.record.refused.saturating_add(1);
        let worst = self.fastest_change();
        self.revert();
        Err(SolveError::after(done, to, SolveFailure::EnergyMade, worst))
    }

    /// Computes powers at the end of an attempt, and the work and dissipation with the impulses of the scheme.
    fn exchange_of_step(&mut self) -> (PowerIntegral, Power) {
        let Self { motion, scheme, damping, before, .. } = self;
        let h = motion.state.t - before.t;
        let power = self.eom.exchange(&motion.state, &mut damping.force);
        let is_first = motion.at_start && !scheme.is_newmark();
        let ratio = if motion.h > 0.0 { h / motion.h } else { 1.0 };
        let mut integral = motion.power;
        let mut exchange = integral.advance(*scheme, (!is_first).then_some(ratio), h, power);
        let start = is_first.then_some(self.start_damping.as_slice());
        exchange.dissipation +=
            motion.damping.work(*scheme, (before, &motion.state), (start, ratio), damping);
        (integral, exchange)
    }

    /// Returns the coordinate with the largest change of velocity in the attempt, measured as energy.
    fn fastest_change(&self) -> usize {
        let (now, before) = (&self.motion.state.v, &self.before.v);
        let factor = &self.newton.tangent.factor;
        let change = |i: usize| ((now[i] - before[i]) / factor.scale(i)).abs();
        (0..now.len()).max_by(|i, j| change(*i).total_cmp(&change(*j))).unwrap_or(0)
    }
}
