use ancf_solver::dynamics::{AdaptiveStepper, StepReport};
use ancf_solver::equations::State;
use ancf_solver::newton::SolveError;

use super::step_error::{StepError, argument};
use super::stepper::Stepper;
use crate::results::AngleRates;
use crate::simulate::{SMALL_REMAINDER, Simulation};

/// Smallest step relative to the time, a multiple of its rounding error.
const SMALLEST_STEP: f64 = 1e-12;
/// Distances, relative to the step of the model, below which rounding errors of a step are large: in velocities and
/// accelerations, and in accelerations only.
const TINY_STEPS: [f64; 2] = [1e-6, 1e-3];

impl Stepper {
    /// Performs one step of the size h > 0.
    ///
    /// The step is divided where a load or a drive jumps, and halved if Newton's method fails, up to `max_halvings` times; the
    /// report has the number of substeps. With error control it is divided as the tolerance requires.
    ///
    /// # Errors
    /// If h is not above 0, or if the smallest substep fails: the state is then that of the last accepted substep.
    pub fn step(&mut self, h: f64) -> Result<StepReport, StepError> {
        if !(h.is_finite() && h > 0.0) {
            return Err(argument("h", h, "a finite step above 0"));
        }
        let own = h / self.simulation.scales().time;
        let from = self.dynamics.state().t;
        if own < SMALLEST_STEP * from || !own.is_normal() {
            return Err(argument("h", h, "a step above the rounding error of the time"));
        }
        self.apply_inputs()?;
        self.report = self.integrate_to(from + own, None)?;
        Ok(self.report)
    }

    /// Advances to the time `until` in steps of the model, up to 1 % longer. From a time, or to a time, that is no multiple of the step,
    /// the steps are equal parts of the interval. In the first call the last one is shorter instead, as in a run.
    ///
    /// The report has the sum of the counts, and the norms of the last step. A time that differs from the present one by its rounding
    /// error has no step.
    ///
    /// # Errors
    /// If the time is before the present one, or as [`step`](Self::step).
    pub fn advance(&mut self, until: f64) -> Result<StepReport, StepError> {
        let end = until / self.simulation.scales().time;
        let from = self.dynamics.state().t;
        if !(until.is_finite() && end >= from - self.events.tolerance()) {
            let expected = format!("a time from the present one, {}, on", self.time());
            return Err(argument("until", until, &expected));
        }
        let mut total = StepReport::default();
        if end <= from {
            return Ok(total);
        }
        self.apply_inputs()?;
        let Some(h) = self.step else {
            self.report = self.integrate_to(end, None)?;
            return Ok(self.report);
        };
        let (origin, h) = self.equal_steps(end, h);
        let last = ((end - origin) / h - SMALL_REMAINDER).floor();
        let mut next = ((from - origin) / h).round() + 1.0;
        while self.dynamics.state().t < end {
            let to = if next <= last { origin + next * h } else { end };
            if to > self.dynamics.state().t {
                self.report = self.integrate_to(to, Some(h))?;
                total = total.then(&self.report);
            }
            next += 1.0;
        }
        Ok(total)
    }

    /// Origin and size of the steps to a time: multiples of the step of the model, if both ends are multiples or the motion starts, or
    /// equal parts of the interval.
    fn equal_steps(&self, end: f64, h: f64) -> (f64, f64) {
        let (from, tolerance) = (self.dynamics.state().t, self.events.tolerance());
        let is_multiple = |t: f64| (t - (t / h).round() * h).abs() <= tolerance;
        let starts = from <= self.simulation.scaled.initial.start_time;
        if is_multiple(from) && (is_multiple(end) || starts) {
            return (0.0, h);
        }
        let parts = ((end - from) / h - SMALL_REMAINDER).ceil().max(1.0);
        (from, (end - from) / parts)
    }

    /// Advances to a time, through all events, in steps of a largest size.
    fn integrate_to(&mut self, to: f64, largest: Option<f64>) -> Result<StepReport, StepError> {
        self.is_row_current = false;
        let (mut total, tolerance) = (StepReport::default(), self.events.tolerance());
        while self.dynamics.state().t < to {
            let (Simulation { assembly, inputs, .. }, now) = (&self.simulation, self.dynamics.state().t);
            let event = self.events.next(assembly, inputs, [now, to]);
            let end = event.map_or(to, |event| event.min(to).next_down());
            if self.dynamics.state().t < end {
                let report = self.substep(end, largest)?;
                self.summary.count(&report);
                total = total.then(&report);
            }
            if let Some(event) = event.filter(|_| self.dynamics.state().t == end) {
                let near = (to - event).abs() <= tolerance;
                self.restart(if near { event.max(to) } else { event })?;
                self.events.pass(event);
            }
        }
        Ok(total)
    }

    /// Takes one step towards a time. After a tiny step, the accelerations are those of the equations of motion.
    fn substep(&mut self, to: f64, largest: Option<f64>) -> Result<StepReport, StepError> {
        let [tiniest, tiny] = TINY_STEPS.map(|part| part * self.nominal_step());
        let left = to - self.dynamics.state().t;
        if left < tiniest && self.dynamics.pending_time().is_none() {
            let done = self.dynamics.extrapolate(to);
            done.map_err(|error| self.failed(error))?;
            self.restarted();
            return Ok(StepReport::default());
        }
        let report = self.integrate_step(to, largest).map_err(|error| self.failed(error))?;
        if left < tiny {
            let done = self.dynamics.renew_accelerations();
            done.map_err(|error| self.failed(error))?;
            self.restarted();
        }
        Ok(report)
    }

    /// Step of the model, or the present one with error control.
    fn nominal_step(&self) -> f64 {
        self.step.unwrap_or_else(|| self.adaptive.as_ref().map_or(0.0, AdaptiveStepper::step_size))
    }

    /// Integrates one step towards a time.
    fn integrate_step(&mut self, to: f64, largest: Option<f64>) -> Result<StepReport, SolveError> {
        let Self { dynamics, adaptive, rows, monitors, .. } = self;
        let mut accepted = |s: &State| {
            rows.count_turns(s.t, s, AngleRates::Velocities);
            monitors.examine(s);
        };
        if let Some(adaptive) = adaptive {
            let report = adaptive.step(dynamics, to)?;
            accepted(dynamics.state());
            return Ok(report);
        }
        if let Some(pending) = dynamics.pending_time().filter(|pending| *pending <= to) {
            return dynamics.advance_with(pending, accepted);
        }
        let (now, left) = (dynamics.state().t, to - dynamics.state().t);
        let parts = largest.map_or(1.0, |h| (left / h - SMALL_REMAINDER).ceil());
        dynamics.advance_with(if parts > 1.0 { now + left / parts } else { to }, accepted)
    }
}
