use std::cell::OnceCell;
use std::collections::HashMap;

use ancf_solver::dynamics::{AdaptiveStepper, StepReport, TimeStepper};
use ancf_solver::equations::{State, System};
use ancf_solver::newton::SolveError;

use super::events::Events;
use super::inputs::Setting;
use super::step_error::{StepError, argument, failure_message};
use crate::failure::{AlternationMonitor, RotationMonitor, RunFailure, find_cause};
use crate::results::{AngleRates, Rows};
use crate::simulate::{SMALL_REMAINDER, Simulation, Summary};

/// Dynamic analysis of a model that a program advances step by step. All arguments and values are in the user's units.
///
/// The steps are those of a run: same scheme, Newton iteration, halving of steps, error control, and ends of steps at jumps of loads
/// and drives. Up to the duration of the analysis in one call of [`advance`](Self::advance), all states are bit-identical to those of
/// a run. The duration does not limit the motion. Two steppers share nothing, and a stepper may move between threads.
///
/// Not examined, in contrast to runs: the stability of the states, and the errors of the results.
///
/// ```
/// use ancf::{Model, Stepper};
///
/// let model = Model::parse(
///     r#"
///     bodies = [{ kind = "mass", name = "cart", center = [0, 0, 0], mass = 2 }]
///     inputs = [{ name = "thrust" }]
///     probes = [{ name = "cart", on = { body = "cart", at = "center" } }]
///
///     [[loads]]
///     kind = "force"
///     on = { body = "cart", at = "center" }
///     force = [1, 0, 0]
///     time = { kind = "input", name = "thrust" }
///
///     [analysis]
///     kind = "dynamics"
///     duration = 1
///     step = 0.01
///     scheme = "average_acceleration"
///     "#,
/// )?;
/// let mut stepper = Stepper::new(&model)?;
/// stepper.set("thrust", 4.0)?;
/// stepper.advance(0.5)?;
/// stepper.set("thrust", 0.0)?;
/// stepper.step(0.25)?;
/// assert!((stepper.read("cart.x")? - 0.5).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Stepper {
    pub(super) simulation: Simulation,
    pub(super) dynamics: TimeStepper<'static, System>,
    pub(super) adaptive: Option<AdaptiveStepper>,
    /// Step of a fixed size, in solver units.
    pub(super) step: Option<f64>,
    pub(super) events: Events,
    /// Settings of the inputs that the next step applies.
    pub(super) pending: Vec<Option<Setting>>,
    pub(super) rows: Rows,
    /// True if the last row belongs to the present state.
    pub(super) is_row_current: bool,
    /// Numbers of the columns by name.
    pub(super) columns: HashMap<String, usize>,
    pub(super) monitors: Monitors,
    /// Report of the last step.
    pub(super) report: StepReport,
    pub(super) summary: Summary,
    pub(super) fingerprint: OnceCell<u64>,
}

/// Monitors of accepted steps.
#[derive(Debug)]
pub(super) struct Monitors {
    pub(super) rotations: RotationMonitor,
    pub(super) alternations: AlternationMonitor,
}

impl Monitors {
    fn examine(&mut self, s: &State) {
        self.rotations.examine(s);
        self.alternations.examine(s);
    }
}

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

    /// Restarts at a time after a jump of loads or drives.
    pub(super) fn restart(&mut self, t: f64) -> Result<(), StepError> {
        self.is_row_current = false;
        self.dynamics.restart(t).map_err(|error| self.failed(error))?;
        let s = self.dynamics.state();
        self.rows.count_turns(s.t, s, AngleRates::Velocities);
        self.monitors.examine(s);
        Ok(())
    }

    /// Error of a failed computation, with its cause.
    pub(super) fn failed(&self, error: SolveError) -> StepError {
        let s = self.dynamics.state();
        let cause = find_cause(&self.simulation.assembly, s, s.load, &error);
        failure_message(&self.simulation, RunFailure::Solve(error, cause))
    }

    /// Time.
    pub fn time(&self) -> f64 {
        self.dynamics.state().t * self.simulation.scales().time
    }

    /// Present state, in solver units.
    pub fn solver_state(&self) -> &State {
        self.dynamics.state()
    }

    /// Simulation that is advanced.
    pub fn simulation(&self) -> &Simulation {
        &self.simulation
    }

    /// Report of the last step.
    pub fn report(&self) -> StepReport {
        self.report
    }
}
