use ancf_solver::dynamics::StepReport;
use ancf_solver::equations::State;
use ancf_solver::newton::SolveError;

use super::step_error::{StepError, argument};
use super::stepper::Stepper;
use crate::results::AngleRates;
use crate::simulate::{SMALL_REMAINDER, Simulation};

/// Smallest step relative to the time, a multiple of its rounding error.
const SMALLEST_STEP: f64 = 1e-12;

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

    /// Advances to the time `until` in steps of the model: the last one is shorter, or up to 1 % longer.
    ///
    /// The report has the sum of the counts, and the norms of the last step.
    ///
    /// # Errors
    /// If the time is before the present one, or as [`step`](Self::step).
    pub fn advance(&mut self, until: f64) -> Result<StepReport, StepError> {
        let end = until / self.simulation.scales().time;
        let from = self.dynamics.state().t;
        if !(until.is_finite() && end >= from) {
            let expected = format!("a time from the present one, {}, on", self.time());
            return Err(argument("until", until, &expected));
        }
        let mut total = StepReport::default();
        if end == from {
            return Ok(total);
        }
        self.apply_inputs()?;
        let Some(h) = self.step else {
            self.report = self.integrate_to(end, None)?;
            return Ok(self.report);
        };
        // Multiples of the step, or equal steps from the present time.
        let count = (from / h).round();
        let (origin, first) =
            if (from - count * h).abs() <= self.events.tolerance() { (0.0, count) } else { (from, 0.0) };
        let last = ((end - origin) / h - SMALL_REMAINDER).floor();
        let mut next = first + 1.0;
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

    /// Advances to a time, through all events, in steps of a largest size.
    fn integrate_to(&mut self, to: f64, largest: Option<f64>) -> Result<StepReport, StepError> {
        self.is_row_current = false;
        let (mut total, tolerance) = (StepReport::default(), self.events.tolerance());
        while self.dynamics.state().t < to {
            let (Simulation { assembly, inputs, .. }, now) = (&self.simulation, self.dynamics.state().t);
            let event = self.events.next(assembly, inputs, [now, to]);
            let end = event.map_or(to, |event| event.min(to).next_down());
            if self.dynamics.state().t < end {
                let report = self.substep(end, largest).map_err(|error| self.failed(error))?;
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

    /// Takes one step towards a time.
    fn substep(&mut self, to: f64, largest: Option<f64>) -> Result<StepReport, SolveError> {
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
