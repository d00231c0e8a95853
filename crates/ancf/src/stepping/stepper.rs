use std::cell::OnceCell;
use std::collections::HashMap;

use ancf_solver::dynamics::{AdaptiveStepper, StepReport, TimeStepper};
use ancf_solver::equations::{State, System};
use ancf_solver::newton::SolveError;
use serde::{Deserialize, Serialize};

use super::events::Events;
use super::step_error::{StepError, failure_message};
use crate::failure::{AlternationMonitor, RotationMonitor, RunFailure, find_cause};
use crate::results::{AngleRates, Rows};
use crate::simulate::{Simulation, Summary};

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

/// New value of an input, and duration of the linear transition to it in solver units.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Setting {
    pub(super) value: f64,
    pub(super) duration: f64,
}

impl Setting {
    pub(super) fn is_valid(self) -> bool {
        self.value.is_finite() && self.duration.is_finite() && self.duration >= 0.0
    }
}

/// Monitors of accepted steps.
#[derive(Debug)]
pub(super) struct Monitors {
    pub(super) rotations: RotationMonitor,
    pub(super) alternations: AlternationMonitor,
}

impl Monitors {
    pub(super) fn examine(&mut self, s: &State) {
        self.rotations.examine(s);
        self.alternations.examine(s);
    }
}

impl Stepper {
    /// Restarts at a time after a jump of loads or drives.
    pub(super) fn restart(&mut self, t: f64) -> Result<(), StepError> {
        self.is_row_current = false;
        self.dynamics.restart(t).map_err(|error| self.failed(error))?;
        self.restarted();
        Ok(())
    }

    /// Counts the turns after a restart, and examines its state.
    pub(super) fn restarted(&mut self) {
        let s = self.dynamics.state();
        self.rows.count_turns(s.t, s, AngleRates::Velocities);
        self.monitors.examine(s);
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
