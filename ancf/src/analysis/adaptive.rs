use super::estimate::Estimate;
use super::{Dynamics, Failure, SolveError, StepReport};
use crate::system::EquationsOfMotion;

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
    /// The step that is to come.
    h: f64,
    /// x and h of the last accepted step.
    last: Option<(f64, f64)>,
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
        let h = control.initial.unwrap_or(own).max(control.smallest);
        Self { control, estimate, h, last: None }
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
        if dynamics.fresh {
            self.last = None;
            self.estimate.restart();
        }
        let from = dynamics.state().t;
        let mut failed = false;
        loop {
            // Equal parts of what is left, so that no sliver remains.
            let parts = ((to - from) / self.h.min(self.control.largest) * (1.0 - 1e-9)).ceil().max(1.0);
            let h = (to - from) / parts;
            let end = if parts == 1.0 { to } else { from + h };
            let failure = match self.attempt(dynamics, h, end, &mut report) {
                Ok(x) if x >= AIM => {
                    self.plan(x, h, failed);
                    return Ok(report);
                }
                Ok(x) => {
                    self.h = h * x.sqrt().max(FALL);
                    SolveError { worst: self.estimate.worst(), ..SolveError::at(end, Failure::StepTooSmall) }
                }
                Err(error) if error.is_final() => return Err(error),
                Err(error) => {
                    report.iterations += error.iterations;
                    self.h = FALL * h;
                    error
                }
            };
            if h <= self.control.smallest {
                return Err(failure);
            }
            self.h = self.h.max(self.control.smallest);
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

    /// The size of the next step.
    fn plan(&mut self, x: f64, h: f64, failed: bool) {
        let (x_before, h_before) = self.last.unwrap_or((x, h));
        let factor = (x * x_before).powf(FILTER.0) * (h / h_before).powf(-FILTER.1);
        let smooth = 1.0 + (factor - 1.0).atan(); // at most 2.6
        let next = h * if failed { smooth.min(1.0) } else { smooth };
        // A step that was cut short to end somewhere says nothing against the size it might have had.
        let cut = h < 0.9 * self.h && next >= h && !failed;
        self.h = next.max(if cut { self.h } else { self.control.smallest });
        self.last = Some((x, h));
    }
}
