use std::f64::consts::FRAC_PI_2;

use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::damping_work::{DampingAttempt, DampingForces, PowerIntegral};
use super::energy_guard::EnergyRecord;
use super::errors::MotionErrors;
use super::predictor::Predictor;
use super::scheme::SchemeCoefficients;
use super::start::StartValues;
use super::step_change::{StepMemory, StepReference};
use super::step_report::StepReport;
use crate::equations::{ActiveGroup, Energy, EquationsOfMotion, Power, State};
use crate::newton::NewtonCheckpoint;
use crate::vectors::for_each_chunk;

/// Integration state that each accepted step advances.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct IntegrationState {
    pub(crate) state: State,
    /// Auxiliary acceleration aₙ of the scheme.
    pub(crate) auxiliary: Vec<f64>,
    /// Size of the last step; 0 at a start.
    pub(crate) h: f64,
    /// Step size to which the auxiliary acceleration and the velocities along constraints belong.
    pub(crate) adapted_h: f64,
    /// Quantities of the last longer step.
    pub(crate) reference: Option<Box<StepReference>>,
    /// True if the accelerations are consistent and there is no previous step.
    pub(crate) at_start: bool,
    /// Accelerations before the jump at a start within the motion.
    pub(crate) before_jump: Option<Vec<f64>>,
    /// Number of halvings at the start of the next step: one less than in the last step.
    pub(crate) halvings: u32,
    /// Divided step that is not complete.
    pub(crate) divided: Option<DividedStep>,
    pub(crate) predictor: Predictor,
    /// Energy of the state, powers without the damping forces, and exchanged energy since the start.
    pub(crate) energy: Energy,
    pub(crate) power: PowerIntegral,
    pub(crate) exchanged: Power,
    pub(crate) damping: DampingForces,
    pub(crate) record: EnergyRecord,
    pub(crate) errors: Option<Box<MotionErrors>>,
}

/// Remainder of a divided step: a number of substeps h up to a time.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(crate) struct DividedStep {
    pub(crate) to: f64,
    pub(crate) h: f64,
    pub(crate) left: u64,
    pub(crate) halvings: u32,
    /// Report of the completed substeps.
    pub(crate) report: StepReport,
}

/// Saved state of [`TimeStepper`](super::time_stepper::TimeStepper), without equations, scheme and rules.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct StepperCheckpoint {
    pub(crate) motion: IntegrationState,
    /// Contact groups included in the equations. They determine the order of elimination and hence the rounding.
    pub(crate) active: Vec<ActiveGroup>,
    pub(crate) newton: NewtonCheckpoint,
}

/// The saved state does not belong to this integration.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("the saved state is damaged or belongs to other equations or rules")]
pub struct CheckpointMismatch;

/// Largest ratio of steps by which the changes of powers are extrapolated. Those of vibrations have no limit.
const LARGEST_POWER_RATIO: f64 = 4.0;
/// Largest plausible count in a report. Larger counts indicate damaged data.
const MAX_COUNT: u32 = u32::MAX / 4;

impl IntegrationState {
    pub(crate) fn new(start: State, eom: &impl EquationsOfMotion) -> Self {
        let mut damping = vec![0.0; start.q.len() + start.lambda.len()];
        let power = PowerIntegral::new(eom.exchange(&start, &mut damping));
        let damping = DampingForces::new(start.q.len(), &damping);
        let energy = eom.energy(&start);
        Self {
            auxiliary: start.a.clone(),
            h: 0.0,
            adapted_h: 0.0,
            reference: None,
            at_start: false,
            before_jump: None,
            halvings: 0,
            divided: None,
            predictor: Predictor::new(start.q.len() + start.lambda.len()),
            energy,
            record: EnergyRecord::new(energy, eom.energy_size(&start)),
            errors: None,
            power,
            damping,
            exchanged: Power::default(),
            state: start,
        }
    }

    /// Computes powers at the end of an attempt, the work and dissipation with the impulses of the scheme, and the decrease of the
    /// dissipated energy, unless damping forces drive at an end.
    ///
    /// `start` are the values of a first step.
    pub(crate) fn exchange_of_step(
        &self,
        eom: &impl EquationsOfMotion,
        scheme: SchemeCoefficients,
        before: &State,
        start: &StartValues,
        damping: &mut DampingAttempt,
    ) -> (PowerIntegral, Power, f64) {
        let h = self.state.t - before.t;
        let power = eom.exchange(&self.state, &mut damping.force);
        let is_first = self.at_start && !scheme.is_newmark();
        let ratio = |last: f64| if last > 0.0 { h / last } else { 1.0 };
        let mut integral = self.power;
        let growth = (!is_first).then_some(ratio(self.h).min(LARGEST_POWER_RATIO));
        let mut exchange = integral.advance(scheme, growth, h, power);
        let (start, ratio) = (is_first.then_some(start), ratio(self.adapted_h));
        let ends = (before, &self.state);
        let work = self.damping.work(scheme, ends, (start, ratio), damping);
        exchange.dissipation += work;
        let is_passive = work >= 0.0 || self.damping.dissipate(ends, start, damping);
        (integral, exchange, if is_passive { -work } else { 0.0 })
    }

    /// Returns the quantities that depend on the size of the last step.
    pub(crate) fn memory(&mut self) -> StepMemory<'_> {
        let Self { state, auxiliary, damping, adapted_h, reference, .. } = self;
        StepMemory { state, auxiliary, damping: damping.auxiliary(), h: adapted_h, reference }
    }

    /// Includes the accepted step in the reference, or discards it.
    pub(crate) fn record_reference(&mut self) {
        let Self { reference, auxiliary, damping, h, .. } = self;
        let damping = damping.auxiliary();
        if reference.as_mut().is_some_and(|reference| !reference.record(*h, auxiliary, damping.auxiliary)) {
            *reference = None;
        }
    }

    /// Restarts the scheme from consistent accelerations.
    pub(crate) fn restart_scheme(&mut self) {
        self.auxiliary.copy_from_slice(&self.state.a);
        (self.h, self.adapted_h, self.reference) = (0.0, 0.0, None);
        self.at_start = true;
    }

    /// Restarts the quadrature of the errors with accelerations that satisfy the equations of motion or do not.
    pub(crate) fn restart_errors(&mut self, is_consistent: bool) {
        if let Some(errors) = &mut self.errors {
            errors.restart(is_consistent);
        }
    }

    /// Returns an angle whose number of turns is ambiguous: its prediction from the state before is off by a quarter.
    pub(crate) fn ambiguous_angle(&self, before: &State, angles: &[usize]) -> Option<usize> {
        let (s, h) = (&self.state, self.state.t - before.t);
        angles.iter().copied().find(|&c| (s.q[c] - before.q[c] - h * before.v[c]).abs() > FRAC_PI_2)
    }

    /// Scales a − v̇ of the auxiliary accelerations for a step h, to which it is proportional (Brüls & Arnold 2008).
    pub(crate) fn scale_auxiliary(&self, h: f64, scaled: &mut [f64]) {
        let ratio = if self.adapted_h == 0.0 { 1.0 } else { h / self.adapted_h };
        for_each_chunk(scaled, |range, scaled| {
            let pairs = self.auxiliary[range.clone()].iter().zip(&self.state.a[range]);
            scaled
                .iter_mut()
                .zip(pairs)
                .for_each(|(scaled, (auxiliary, a))| *scaled = a + ratio * (auxiliary - a));
        });
    }

    /// Returns true if the state has the given sizes and is plausible.
    pub(crate) fn is_valid(&self, coordinates: usize, multipliers: usize, max_halvings: u32) -> bool {
        let Self { energy, power, exchanged, h, .. } = self;
        let energies = [energy.kinetic, energy.strain, energy.potential];
        let powers = [exchanged.work, exchanged.dissipation];
        self.state.is_valid(coordinates, multipliers)
            && self.auxiliary.len() == coordinates
            && self
                .before_jump
                .as_ref()
                .is_none_or(|a| a.len() == coordinates && a.iter().all(|x| x.is_finite()))
            && self.auxiliary.iter().chain(&energies).chain(&powers).all(|x| x.is_finite())
            && h.is_finite()
            && *h >= 0.0
            && self.adapted_h.is_finite()
            && self.adapted_h >= 0.0
            && self.reference.as_ref().is_none_or(|reference| reference.is_valid(coordinates))
            && self.halvings <= max_halvings
            && self.divided.is_none_or(|divided| divided.is_valid(self.state.t, max_halvings))
            && power.is_valid()
            && self.record.is_valid()
            && self.damping.is_valid(coordinates)
            && self.errors.as_ref().is_none_or(|errors| errors.is_valid(coordinates, multipliers))
            && self.predictor.is_valid(coordinates + multipliers)
    }
}

impl DividedStep {
    fn is_valid(&self, t: f64, max_halvings: u32) -> bool {
        let Self { to, h, left, halvings, report } = *self;
        halvings <= max_halvings
            && (1..1_u64 << halvings).contains(&left)
            && t < to
            && (0.0..=to).contains(&h)
            && report.is_valid()
    }
}

impl StepReport {
    /// Returns true if the counts can be summed without overflow.
    pub fn is_valid(&self) -> bool {
        [self.iterations, self.substeps, self.rejected].iter().all(|count| *count <= MAX_COUNT)
    }
}

impl StepperCheckpoint {
    /// Returns the time of the state.
    pub fn time(&self) -> f64 {
        self.motion.state.t
    }

    /// Returns the end time of a divided step that is not complete.
    pub fn pending_time(&self) -> Option<f64> {
        self.motion.divided.map(|divided| divided.to)
    }
}
