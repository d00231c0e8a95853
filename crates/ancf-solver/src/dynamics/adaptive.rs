use serde::{Deserialize, Serialize};

use super::estimate::{Estimate, Past};
use super::motion::Unknown;
use super::step_report::StepReport;
use super::time_stepper::Dynamics;
use crate::equations::EquationsOfMotion;
use crate::newton::{Failure, SolveError};

/// What steps of variable size are to achieve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Control {
    /// The error that the motion may gather over the duration: a root mean square displacement over the mass, relative
    /// to `length`.
    pub tolerance: f64,
    /// A length of the model, such as that of its longest body.
    pub length: f64,
    /// The mass of the model.
    pub mass: f64,
    /// The time over which errors gather.
    pub duration: f64,
    /// The first step; by the first acceleration if left out.
    pub initial: Option<f64>,
    /// The largest step.
    pub largest: f64,
    /// The smallest step.
    pub smallest: f64,
}

impl Control {
    /// The smallest step as a part of the duration, unless something else is wanted.
    pub const SMALLEST: f64 = 1e-9;
}

/// Steps of [`Dynamics`] as large as a tolerance permits, for schemes of second order.
///
/// The error of each step is estimated as a displacement e. Errors gather, so each step may have its share of the tolerance:
/// e/h ≤ tolerance × length / duration. A step aims at a part of that; its size follows from the errors of two steps,
/// smoothly, since each change of the step disturbs the multipliers:
///
/// hₙ₊₁ = hₙ (xₙ xₙ₋₁)^(1/bk) (hₙ/hₙ₋₁)^(−1/b),   x = aimed error / error,  k = 2,  b = 4.
///
/// What the tolerance promises is proven for vibrations only; a motion that is unstable loses more.
///
/// Source: Söderlind (2003), the digital filter H211b.
#[derive(Debug)]
pub struct Adaptive {
    control: Control,
    estimate: Estimate,
    sizes: Sizes,
}

/// Sizes of steps.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
struct Sizes {
    /// The step that is to come.
    next: f64,
    /// x and h of the last accepted step.
    last: Option<(f64, f64)>,
}

/// All on which the further control depends; of [`Adaptive`].
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct AdaptiveMemory {
    sizes: Sizes,
    past: Past,
}

/// The part of its share at which a step aims.
const AIM: f64 = 0.4;
/// 1/bk and 1/b.
const FILTER: (f64, f64) = (0.125, 0.25);
/// To this part of itself a step falls when Newton's method fails, and at most when it is too inaccurate.
const FALL: f64 = 0.25;

impl Adaptive {
    /// Control of the dynamics.
    pub fn new<E: EquationsOfMotion>(dynamics: &Dynamics<'_, E>, control: Control) -> Self {
        let mut estimate = Estimate::new(dynamics, control.mass);
        let a = estimate.norm(&dynamics.state().a);
        // In this step the acceleration moves the system by a hundredth of the tolerance or so.
        let own = 0.1 * (control.tolerance * control.length / a).sqrt().min(control.duration);
        let next = control.initial.unwrap_or(own).max(control.smallest);
        Self { control, estimate, sizes: Sizes { next, last: None } }
    }

    /// Does one step of a size that the tolerance permits towards the time `to`, where the last of them ends exactly.
    ///
    /// # Errors
    /// If the smallest step fails or is too inaccurate; the state is then that of the last accepted step.
    pub fn step<E: EquationsOfMotion>(
        &mut self,
        dynamics: &mut Dynamics<'_, E>,
        to: f64,
    ) -> Result<StepReport, SolveError> {
        let mut report = StepReport::default();
        if dynamics.motion.fresh {
            self.sizes.last = None;
            self.estimate.restart();
        }
        let from = dynamics.state().t;
        let (mut size, mut failed) = (self.sizes.next, false);
        loop {
            // Equal parts of what is left, so that no sliver remains.
            let parts = ((to - from) / size.min(self.control.largest) * (1.0 - 1e-9)).ceil().max(1.0);
            let h = (to - from) / parts;
            let end = if parts == 1.0 { to } else { from + h };
            let failure = match self.attempt(dynamics, h, end, &mut report) {
                Ok(x) if x >= AIM => {
                    self.plan(x, h, (size, failed));
                    return Ok(report);
                }
                Ok(x) => {
                    size = h * x.sqrt().max(FALL);
                    SolveError { worst: self.estimate.worst(), ..SolveError::at(end, Failure::StepTooSmall) }
                }
                Err(error) if error.is_final() => return Err(error),
                Err(error) => {
                    report.iterations += error.iterations;
                    size = FALL * h;
                    error
                }
            };
            if h <= self.control.smallest {
                return Err(failure);
            }
            size = size.max(self.control.smallest);
            failed = true;
        }
    }

    /// Tries a step; accepts it if x, the quotient of aimed and estimated error, is at least [`AIM`].
    fn attempt<E: EquationsOfMotion>(
        &mut self,
        dynamics: &mut Dynamics<'_, E>,
        h: f64,
        end: f64,
        report: &mut StepReport,
    ) -> Result<f64, SolveError> {
        // The estimate filters by it.
        dynamics.newton.tangent.renew();
        let done = dynamics.attempt(h, end)?;
        let error = self.estimate.error(dynamics, &done, h);
        let error = error.inspect_err(|_| dynamics.take_back())?;
        let share = self.control.tolerance * self.control.length * h / self.control.duration;
        let x = AIM * share / error.max(f64::MIN_POSITIVE);
        if x >= AIM {
            dynamics.accept(&done, report);
            self.estimate.accept(h);
        } else {
            dynamics.take_back();
            report.iterations += done.iterations;
            report.rejected += 1;
        }
        Ok(x)
    }

    /// The size of the next step, after one that was to have a size, before which others may have failed.
    fn plan(&mut self, x: f64, h: f64, (size, failed): (f64, bool)) {
        let (x_before, h_before) = self.sizes.last.unwrap_or((x, h));
        let factor = (x * x_before).powf(FILTER.0) * (h / h_before).powf(-FILTER.1);
        let smooth = 1.0 + (factor - 1.0).atan(); // at most 2.6
        let next = h * if failed { smooth.min(1.0) } else { smooth };
        // A step that was cut short to end somewhere says nothing against the size it might have had.
        let cut = h < 0.9 * size && next >= h && !failed;
        let next = next.max(if cut { size } else { self.control.smallest });
        self.sizes = Sizes { next, last: Some((x, h)) };
    }

    /// All on which the further control depends, as of the last accepted step.
    pub fn memory(&self) -> AdaptiveMemory {
        AdaptiveMemory { sizes: self.sizes, past: self.estimate.past.clone() }
    }

    /// Goes on from a memory.
    ///
    /// # Errors
    /// If it is no memory of such a control.
    pub fn recall(&mut self, memory: &AdaptiveMemory) -> Result<(), Unknown> {
        let AdaptiveMemory { sizes: Sizes { next, last }, past } = memory;
        let is_size = |h: f64| h >= self.control.smallest && h.is_finite();
        // No error at all makes x infinite.
        let were_sizes = last.is_none_or(|(x, h)| x > 0.0 && h > 0.0 && h.is_finite());
        if !is_size(*next) || !were_sizes || !past.is_sound(self.estimate.past.size()) {
            return Err(Unknown);
        }
        (self.sizes, self.estimate.past) = (memory.sizes, past.clone());
        Ok(())
    }
}
