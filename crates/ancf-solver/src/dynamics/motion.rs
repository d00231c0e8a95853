use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::predictor::Trend;
use super::step_report::StepReport;
use crate::equations::{Energy, EquationsOfMotion, Met, Power, State};
use crate::newton::NewtonMemory;

/// Where a motion is: what moves on with each accepted step.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Motion {
    pub(crate) state: State,
    /// The scheme's auxiliary acceleration aₙ, for the step `h` that led here.
    pub(crate) auxiliary: Vec<f64>,
    pub(crate) h: f64,
    /// Whether accelerations are consistent and there is no step before.
    pub(crate) fresh: bool,
    /// By how many halvings the next step begins: one less than the last one needed.
    pub(crate) halvings: u32,
    /// A step that is not completed yet.
    pub(crate) divided: Option<Divided>,
    pub(crate) trend: Trend,
    /// Energy and power of the state.
    pub(crate) energy: Energy,
    pub(crate) power: Power,
    pub(crate) exchanged: Power,
}

/// What is left of a step that was divided: so many parts h up to a time.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(crate) struct Divided {
    pub(crate) to: f64,
    pub(crate) h: f64,
    pub(crate) left: u64,
    pub(crate) halvings: u32,
    /// On the parts done.
    pub(crate) report: StepReport,
}

/// All on which the rest of a motion depends besides equations, scheme and rules; of [`Dynamics`](super::time_stepper::Dynamics).
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct DynamicsMemory {
    pub(crate) motion: Motion,
    /// The pairs whose terms are among the equations: the order of elimination, and so rounding, depends on them.
    pub(crate) met: Vec<Met>,
    pub(crate) newton: NewtonMemory,
}

/// A memory is not one of these dynamics.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("the memory is not one of these equations and rules, or damaged")]
pub struct Unknown;

/// Reports of more iterations than this are damaged.
const MOST: u32 = u32::MAX / 4;

impl Motion {
    pub(crate) fn new(start: State, eom: &impl EquationsOfMotion) -> Self {
        Self {
            auxiliary: start.a.clone(),
            h: 0.0,
            fresh: false,
            halvings: 0,
            divided: None,
            trend: Trend::new(start.q.len() + start.lambda.len()),
            energy: eom.energy(&start),
            power: eom.power(&start),
            exchanged: Power::default(),
            state: start,
        }
    }

    /// Whether it is one of so many unknowns, and makes sense.
    pub(crate) fn is_sound(&self, coordinates: usize, multipliers: usize, max_halvings: u32) -> bool {
        let Self { energy, power, exchanged, h, .. } = self;
        let energies = [energy.kinetic, energy.strain, energy.potential];
        let powers = [power.work, power.dissipation, exchanged.work, exchanged.dissipation];
        self.state.is_sound(coordinates, multipliers)
            && self.auxiliary.len() == coordinates
            && self.auxiliary.iter().chain(&energies).chain(&powers).all(|x| x.is_finite())
            && h.is_finite()
            && *h >= 0.0
            && self.halvings <= max_halvings
            && self.divided.is_none_or(|divided| divided.is_sound(self.state.t, max_halvings))
            && self.trend.is_sound(coordinates + multipliers)
    }
}

impl Divided {
    fn is_sound(&self, t: f64, max_halvings: u32) -> bool {
        let Self { to, h, left, halvings, report } = *self;
        halvings <= max_halvings
            && (1..1_u64 << halvings).contains(&left)
            && t < to
            && (0.0..=to).contains(&h)
            && report.is_sound()
    }
}

impl StepReport {
    /// Whether its counts can be added to.
    pub fn is_sound(&self) -> bool {
        [self.iterations, self.substeps, self.rejected].iter().all(|count| *count <= MOST)
    }
}

impl DynamicsMemory {
    /// The time of the state.
    pub fn time(&self) -> f64 {
        self.motion.state.t
    }

    /// The time to which a step leads that was divided and not completed.
    pub fn under_way(&self) -> Option<f64> {
        self.motion.divided.map(|divided| divided.to)
    }
}
