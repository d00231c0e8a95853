use ancf_solver::dynamics::{
    AdaptiveCheckpoint, AdaptiveStepper, CheckpointMismatch, EnergyGuard, ErrorControl, StepReport,
    StepperCheckpoint, TimeStepper,
};
use ancf_solver::equations::{State, System};
use ancf_solver::newton::{Interrupt, Newton, SolveError};
use serde::{Deserialize, Serialize};

use crate::assembly::Assembly;
use crate::estimate::{coordinate_sizes, has_mesh};
use crate::model::{Dynamics, Model, NewtonMethod, Start, Step};

/// Step control of a dynamic analysis: step sizes, output times and load jumps.
pub(crate) struct StepControl<'a> {
    dynamics: TimeStepper<'a, System>,
    /// Time at the start.
    start: f64,
    duration: f64,
    /// Interval of the output times. `None` if each step is recorded.
    interval: Option<f64>,
    /// Number of output times reached, without the start.
    count: u64,
    /// True if the current state is due for output and not recorded yet.
    is_due: bool,
    /// Report of the steps since the last output.
    report: StepReport,
    size: StepSize,
    /// Times at which loads jump, in descending order.
    jumps: Vec<f64>,
    /// Tolerance within which two times are equal.
    tolerance: f64,
}

enum StepSize {
    /// Maximum size.
    Fixed(f64),
    /// Error control.
    Adaptive(Box<AdaptiveStepper>),
}

/// Tolerance of times, relative to the step.
pub(crate) const TIME_TOLERANCE: f64 = 1e-9;

/// Remainder of a duration, relative to the step, that is part of the last step.
pub(crate) const SMALL_REMAINDER: f64 = Dynamics::SMALL_REMAINDER;

/// Newton's method of an analysis.
pub(crate) fn newton_method(
    assembly: &Assembly,
    settings: &Dynamics,
    interrupt: Interrupt,
) -> Result<Newton, SolveError> {
    let newton = Newton::new(assembly.system.matrix(), settings.stop.into(), settings.max_iterations)?;
    let newton = newton.with_interrupt(interrupt);
    Ok(if settings.newton == NewtonMethod::Full { newton.with_new_tangents() } else { newton })
}

/// Time integration with consistent initial values.
pub(crate) fn started<'a>(
    dynamics: TimeStepper<'a, System>,
    settings: &Dynamics,
) -> Result<TimeStepper<'a, System>, SolveError> {
    let mut dynamics = dynamics.with_energy_guard(EnergyGuard { gain: settings.energy_guard.gain });
    dynamics.include_near_terms()?;
    match settings.start {
        Start::Consistent => dynamics.restart(dynamics.state().t)?,
        Start::Zero => dynamics.project_velocities()?,
    }
    Ok(dynamics)
}

/// Error control of an analysis; `None` for steps of a fixed size.
pub(crate) fn error_control(
    model: &Model,
    settings: &Dynamics,
    assembly: &Assembly,
    dynamics: &TimeStepper<'_, System>,
) -> Option<AdaptiveStepper> {
    let Step::Adaptive { tolerance, initial, largest } = settings.step else { return None };
    let duration = settings.duration;
    let control = ErrorControl {
        tolerance,
        length: model.length(),
        mass: model.mass(),
        duration,
        initial,
        largest: largest.unwrap_or(duration),
        smallest: ErrorControl::SMALLEST * duration,
    };
    let functions = assembly.inputs.step_functions(duration);
    Some(AdaptiveStepper::new(dynamics, control).with_functions(functions))
}

impl<'a> StepControl<'a> {
    /// Computes consistent initial values of an analysis from its initial state.
    pub(crate) fn new(
        model: &Model,
        start: State,
        settings: &Dynamics,
        assembly: &'a Assembly,
        interrupt: Interrupt,
    ) -> Result<Self, SolveError> {
        let (begin, duration) = (start.t, settings.duration);
        let newton = newton_method(assembly, settings, interrupt)?;
        let (system, scheme) = (&assembly.system, settings.scheme.numbers());
        let mut dynamics = TimeStepper::new(system, scheme, newton, settings.max_halvings, start);
        if model.output.errors {
            let has_gaps = has_mesh(assembly) && !model.has_shells();
            dynamics = dynamics.with_errors(coordinate_sizes(model, assembly), has_gaps);
        }
        let dynamics = started(dynamics, settings)?;
        let (size, every) = match error_control(model, settings, assembly, &dynamics) {
            Some(adaptive) => (StepSize::Adaptive(Box::new(adaptive)), None),
            None => (StepSize::Fixed(settings.step.fixed().unwrap_or(duration)), settings.step.fixed()),
        };
        let time_tolerance = TIME_TOLERANCE * settings.step.fixed().unwrap_or(duration);
        let mut jumps = assembly.breaks().to_vec();
        jumps.retain(|t| *t > begin + time_tolerance && *t < begin + duration + time_tolerance);
        jumps.sort_by(|a, b| b.total_cmp(a));
        jumps.dedup_by(|a, b| (*a - *b).abs() <= time_tolerance);
        Ok(Self {
            dynamics,
            start: begin,
            duration,
            interval: model.output.interval.or(every),
            count: 0,
            is_due: true,
            report: StepReport::default(),
            size,
            jumps,
            tolerance: time_tolerance,
        })
    }

    /// Step control of a motion that takes the steps of another one.
    pub(crate) fn following(self) -> Self {
        Self { size: StepSize::Fixed(f64::INFINITY), interval: None, ..self }
    }

    /// Takes one step to the time of the motion that is followed, with restarts at jumps.
    pub(crate) fn follow(&mut self, to: f64) -> Result<(), SolveError> {
        while self.dynamics.state().t < to {
            self.advance_to(to, |_| (), |_| ())?;
        }
        Ok(())
    }

    /// Time integration, to set the forces of the errors of the mesh.
    pub(crate) fn dynamics_mut(&mut self) -> &mut TimeStepper<'a, System> {
        &mut self.dynamics
    }

    pub(crate) fn dynamics(&self) -> &TimeStepper<'a, System> {
        &self.dynamics
    }

    /// Next output time; the end if each step is recorded. `None` at the end.
    fn next_output(&self) -> Option<f64> {
        self.output_after(self.count, self.dynamics.state().t)
    }

    /// Output time after number `count`, at the time `now`.
    fn output_after(&self, count: u64, now: f64) -> Option<f64> {
        let end = Some(self.end()).filter(|end| now < *end);
        let Some(interval) = self.interval else { return end };
        let next = (count + 1) as f64;
        if next <= self.inner_outputs(interval) {
            return Some(self.start + next * interval);
        }
        end
    }

    /// Time at the end.
    fn end(&self) -> f64 {
        self.start + self.duration
    }

    /// Number of output times between the start and the end, which a small remainder of the duration does not follow.
    fn inner_outputs(&self, interval: f64) -> f64 {
        let step = if let StepSize::Fixed(step) = self.size { step.min(interval) } else { interval };
        ((self.duration - SMALL_REMAINDER * step) / interval).floor().max(0.0)
    }

    /// True at the end of the duration.
    pub(crate) fn is_finished(&self) -> bool {
        self.next_output().is_none()
    }

    /// Report of the steps up to the current state, if the state is due for output.
    pub(crate) fn due_report(&self) -> Option<StepReport> {
        self.is_due.then_some(self.report)
    }

    /// Marks the current state as recorded.
    pub(crate) fn mark_recorded(&mut self) {
        (self.is_due, self.report) = (false, StepReport::default());
    }

    /// Takes one step towards the next output time and passes its report to `count`. `accepted` receives the states after each
    /// accepted substep and after a restart. Returns false at the end of the duration.
    pub(crate) fn advance(
        &mut self,
        accepted: impl FnMut(&State),
        count: impl FnOnce(&StepReport),
    ) -> Result<bool, SolveError> {
        let Some(to) = self.next_output() else { return Ok(false) };
        self.advance_to(to, accepted, count)?;
        if self.interval.is_none() || self.dynamics.state().t >= to {
            self.count += 1;
            self.is_due = true;
        }
        Ok(true)
    }

    /// Takes one step towards a time, and restarts if it ends at a jump.
    fn advance_to(
        &mut self,
        to: f64,
        mut accepted: impl FnMut(&State),
        count: impl FnOnce(&StepReport),
    ) -> Result<(), SolveError> {
        let jump = self.jumps.last().copied().filter(|jump| *jump <= to + self.tolerance);
        // The step ends just before the jump. A jump within rounding of the output time coincides with it.
        let end = jump.map_or(to, |jump| jump.min(to).next_down());
        // Equal if the restart after the jump failed and is repeated.
        if self.dynamics.state().t < end {
            let step = self.step(end, &mut accepted)?;
            count(&step);
            self.report = self.report.then(&step);
        }
        if let Some(jump) = jump.filter(|_| self.dynamics.state().t == end) {
            let near = (to - jump).abs() <= self.tolerance;
            self.dynamics.restart(if near { jump.max(to) } else { jump })?;
            accepted(self.dynamics.state());
            self.jumps.pop();
        }
        Ok(())
    }

    /// Takes one step towards a time.
    fn step(&mut self, to: f64, accepted: &mut impl FnMut(&State)) -> Result<StepReport, SolveError> {
        match &mut self.size {
            StepSize::Adaptive(adaptive) => {
                let report = adaptive.step(&mut self.dynamics, to)?;
                accepted(self.dynamics.state());
                Ok(report)
            }
            StepSize::Fixed(h) => {
                if let Some(to) = self.dynamics.pending_time() {
                    return self.dynamics.advance_with(to, accepted);
                }
                let (now, left) = (self.dynamics.state().t, to - self.dynamics.state().t);
                let parts = (left / *h - SMALL_REMAINDER).ceil();
                self.dynamics.advance_with(if parts > 1.0 { now + left / parts } else { to }, accepted)
            }
        }
    }
}

/// State of the step control after an accepted step. A state that is due for output has been recorded.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct StepControlCheckpoint {
    count: u64,
    report: StepReport,
    /// Number of remaining load jumps.
    jumps: usize,
    dynamics: StepperCheckpoint,
    adaptive: Option<AdaptiveCheckpoint>,
}

impl StepControlCheckpoint {
    /// Number of recorded rows, including the start.
    pub(crate) fn rows(&self) -> u64 {
        self.count.saturating_add(1)
    }

    pub(crate) fn time(&self) -> f64 {
        self.dynamics.time()
    }
}

/// Upper limit on counts. Larger counts indicate a damaged checkpoint.
pub(crate) const MAX_COUNT: u64 = 1 << 53;

impl StepControl<'_> {
    /// State after the last accepted step.
    pub(crate) fn checkpoint(&self) -> StepControlCheckpoint {
        let adaptive = match &self.size {
            StepSize::Fixed(_) => None,
            StepSize::Adaptive(adaptive) => Some(adaptive.checkpoint()),
        };
        StepControlCheckpoint {
            count: self.count,
            report: self.report,
            jumps: self.jumps.len(),
            dynamics: self.dynamics.checkpoint(),
            adaptive,
        }
    }

    /// Restores a state.
    pub(crate) fn restore(&mut self, checkpoint: &StepControlCheckpoint) -> Result<(), CheckpointMismatch> {
        if !self.admits(checkpoint) {
            return Err(CheckpointMismatch);
        }
        match (&mut self.size, &checkpoint.adaptive) {
            (StepSize::Fixed(_), None) => {}
            (StepSize::Adaptive(adaptive), Some(checkpoint)) => adaptive.restore(checkpoint)?,
            _ => return Err(CheckpointMismatch),
        }
        (self.count, self.is_due, self.report) = (checkpoint.count, false, checkpoint.report);
        self.jumps.truncate(checkpoint.jumps);
        self.dynamics.restore(&checkpoint.dynamics)
    }

    /// True if time and counts of a checkpoint are possible in this analysis.
    fn admits(&self, checkpoint: &StepControlCheckpoint) -> bool {
        let StepControlCheckpoint { count, report, jumps, dynamics, .. } = checkpoint;
        let (t, count) = (dynamics.time(), *count);
        if !(self.start..=self.end() + self.tolerance).contains(&t)
            || count > MAX_COUNT
            || *jumps > self.jumps.len()
        {
            return false;
        }
        let is_before = |end: f64| t <= end + self.tolerance;
        let is_in_order = self.interval.is_none_or(|interval| {
            let (now, inner) = (count as f64, self.inner_outputs(interval));
            let reached = if now <= inner { self.start + now * interval } else { self.end() };
            now <= inner + 1.0 && t >= reached && self.output_after(count, t).is_none_or(is_before)
        });
        let is_before_jumps = self.jumps[..*jumps].last().is_none_or(|jump| t < *jump);
        is_in_order
            && is_before_jumps
            && report.is_valid()
            && dynamics.pending_time().is_none_or(|to| to <= self.end() + self.tolerance)
    }
}
