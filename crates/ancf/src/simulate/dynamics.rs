use std::cell::OnceCell;
use std::io;
use std::ops::ControlFlow;

use ancf_solver::dynamics::{StepReport, TimeStepper};
use ancf_solver::equations::{State, System};
use ancf_solver::newton::SolveError;

use super::error::Error;
use super::run::{
    AnalysisRun, Checkpoint, EndConditions, ErrorEstimate, ResumeError, RunResult, Simulation, StepControl,
    Summary, fingerprint, turn_warning,
};
use crate::failure::{AlternationMonitor, RotationMonitor, RunFailure, StabilityMonitor, find_cause};
use crate::initial::{InitialState, StartState};
use crate::model::{Dynamics, Model};
use crate::results::{AngleRates, Rows, TIME};

/// Columns of the solver in dynamics.
pub(crate) const COLUMNS: [&str; 5] = ["iterations", "residual", "increment", "drift", "violation"];

/// Warning of conditions that were not met.
const NOT_MET: &str =
    "no condition of `analysis.until` was met at a recorded time: the motion ends with its duration";

/// State of a running dynamic analysis.
pub(crate) struct DynamicRun<'a> {
    simulation: &'a Simulation,
    rows: Rows,
    control: StepControl<'a>,
    conditions: EndConditions,
    rotations: RotationMonitor,
    alternations: AlternationMonitor,
    /// State before the projection of its velocities.
    initial: InitialState,
    /// Estimate of the errors, on request.
    estimate: Option<ErrorEstimate<'a>>,
    /// Computed with the first checkpoint.
    fingerprint: OnceCell<u64>,
}

impl<'a> DynamicRun<'a> {
    fn new(
        simulation: &'a Simulation,
        settings: &Dynamics,
        initial: InitialState,
        mut rows: Rows,
    ) -> Result<Self, SolveError> {
        let Simulation { scaled, assembly, interrupt, .. } = simulation;
        let start = initial.state.clone();
        let mut control = StepControl::new(scaled, start, settings, assembly, interrupt.clone())?;
        let start = control.dynamics().state();
        rows.count_turns(start.t, start, AngleRates::Velocities);
        let rotations = RotationMonitor::new(scaled, assembly, start.t);
        let alternations = AlternationMonitor::new(scaled, control.dynamics().state().a.len());
        let mut estimate = ErrorEstimate::new(simulation, settings, &initial);
        estimate.iter_mut().for_each(|estimate| estimate.update(&mut control, &mut rows));
        let fingerprint = OnceCell::new();
        let conditions = EndConditions::new(&settings.until, &simulation.columns());
        Ok(Self {
            simulation,
            rows,
            control,
            conditions,
            rotations,
            alternations,
            initial,
            estimate,
            fingerprint,
        })
    }

    fn checkpoint(&self, summary: &Summary, monitor: &StabilityMonitor) -> Checkpoint {
        let model = *self.fingerprint.get_or_init(|| fingerprint(self.simulation));
        Checkpoint::new(
            model,
            summary,
            (monitor, &self.rotations, &self.alternations),
            (&self.rows, self.estimate.as_ref()),
            &self.initial,
            &self.control,
        )
    }
}

fn rows(simulation: &Simulation) -> Rows {
    Rows::new(&simulation.assembly, simulation.scales(), TIME, &COLUMNS)
}

/// Warnings if steps made energy, also at a start from rest, or if the scheme has lost a large part of the exchanged energy.
///
/// `scaled` is the model in solver units.
pub(crate) fn energy_warnings(
    own: &Dynamics,
    scaled: &Model,
    dynamics: &TimeStepper<'_, System>,
) -> Vec<String> {
    let mut warnings = Vec::new();
    let (guard, is_fixed) = (&own.energy_guard, own.step.fixed().is_some());
    let (record, rounding) = dynamics.energy_record();
    // The work of rounding errors is evaluated only for energies that exceed the other limits.
    let exceeds =
        |energy: f64, limit: f64| energy > limit && energy > limit + dynamics.rounding_work(scaled.length());
    let (lost, reference) = (record.lost(), record.reference());
    let created = record.created() + if is_fixed { record.hidden() } else { 0.0 };
    if record.rejected() > 0 && is_fixed {
        warnings.push(format!(
            "{} steps made energy (column `balance`) and were halved: the energy may be wrong by the permitted share \
             `energy_guard.gain`; use smaller steps or a smaller `spectral_radius`",
            record.rejected()
        ));
    }
    if exceeds(created, guard.gain * reference + rounding) {
        warnings.push(format!(
            "the steps do not resolve the motion: the integration has made {:.2} % of the exchanged energy (column `balance`); use \
             smaller steps; `energy_guard = {{ gain = 1 }}` accepts the gain",
            100.0 * created / reference
        ));
    }
    if exceeds(lost, guard.loss * reference + rounding) {
        warnings.push(format!(
            "the numerical damping of the scheme has removed {:.2} % of the exchanged energy (column `balance`): use smaller steps, \
             a scheme of second order, or a larger `spectral_radius`; `energy_guard = {{ loss = 1 }}` accepts the loss",
            100.0 * lost / reference
        ));
    }
    warnings
}

impl<'a> AnalysisRun<'a> {
    /// Runs a dynamic analysis.
    pub(crate) fn dynamics(
        &mut self,
        simulation: &'a Simulation,
        settings: &Dynamics,
        given: Option<&StartState>,
    ) -> RunResult {
        let mut rows = rows(simulation);
        self.observer.begin(&rows.columns())?;
        let Simulation { scaled, assembly, interrupt, .. } = simulation;
        let initial =
            InitialState::new((scaled, simulation.scales()), assembly, (interrupt, given), &mut rows);
        let initial = match initial {
            Ok(initial) => initial,
            Err(failure) => return Ok(Err(failure)),
        };
        let start = initial.state.clone();
        match DynamicRun::new(simulation, settings, initial, rows) {
            Ok(motion) => self.integrate(motion),
            Err(error) => {
                let cause = find_cause(self.assembly, &start, 1.0, &error);
                Ok(Err(RunFailure::Solve(error, cause)))
            }
        }
    }

    /// Creates the dynamic analysis of a checkpoint and restores its state.
    pub(crate) fn restored(
        &mut self,
        simulation: &'a Simulation,
        settings: &Dynamics,
        from: &Checkpoint,
    ) -> Result<DynamicRun<'a>, Error> {
        from.check(simulation)?;
        let initial = from.initial(simulation);
        let motion = DynamicRun::new(simulation, settings, initial, rows(simulation));
        let mut motion = motion.map_err(|_| ResumeError::Damaged)?;
        let DynamicRun { rows, control, rotations, alternations, estimate, .. } = &mut motion;
        let monitors = (&mut self.monitor, rotations, alternations);
        from.restore(&mut self.summary, monitors, (rows, estimate.as_mut()), control)?;
        Ok(motion)
    }

    /// Continues a restored dynamic analysis.
    pub(crate) fn continue_dynamics(&mut self, motion: DynamicRun<'a>) -> RunResult {
        self.observer.begin(&motion.rows.columns())?;
        self.integrate(motion)
    }

    fn integrate(&mut self, mut motion: DynamicRun<'a>) -> RunResult {
        self.summary.initial.clone_from(&motion.initial.report);
        self.summary.warnings.extend(motion.initial.warnings.iter().cloned());
        let result = self.step_to_end(&mut motion)?;
        if !matches!(result, Ok(ControlFlow::Continue(()))) {
            let Self { observer, summary, monitor, .. } = self;
            observer.last_checkpoint(&|| motion.checkpoint(summary, monitor))?;
        }
        self.summary.warnings.extend(turn_warning(&motion.rows, "t", self.summary.scales.time));
        self.summary.warnings.extend(motion.rotations.warning(self.assembly, self.summary.scales));
        self.summary.warnings.extend(motion.alternations.warning(self.summary.scales));
        if let Some(own) = motion.simulation.scaled.analysis.dynamics() {
            self.summary.warnings.extend(energy_warnings(
                own,
                &motion.simulation.scaled,
                motion.control.dynamics(),
            ));
        }
        if result.as_ref().is_ok_and(ControlFlow::is_continue)
            && self.summary.ended_by.is_none()
            && !motion.conditions.is_empty()
        {
            self.summary.warnings.push(NOT_MET.to_owned());
        }
        self.summary.motion_errors = motion.estimate.map(|estimate| estimate.errors().clone());
        Ok(result)
    }

    fn step_to_end(&mut self, motion: &mut DynamicRun<'a>) -> RunResult {
        loop {
            let flow = match motion.control.due_report() {
                Some(report) => {
                    let flow = self.record(motion, &report)?;
                    let steps = self.summary.steps;
                    self.monitor.examine(self.assembly, motion.control.dynamics().state(), steps);
                    if self.summary.ended_by.is_some() {
                        return Ok(Ok(ControlFlow::Continue(())));
                    }
                    flow
                }
                None => ControlFlow::Continue(()),
            };
            let Self { observer, summary, monitor, .. } = self;
            observer.checkpoint(&|| motion.checkpoint(summary, monitor))?;
            let DynamicRun { rows, control, rotations, alternations, estimate, .. } = &mut *motion;
            if flow.is_break() {
                // A stop request at the last row has no effect.
                return Ok(Ok(if control.is_finished() { ControlFlow::Continue(()) } else { flow }));
            }
            let accepted = |s: &State| {
                rows.count_turns(s.t, s, AngleRates::Velocities);
                rotations.examine(s);
                alternations.examine(s);
                estimate.iter_mut().for_each(|estimate| estimate.follow(s));
            };
            let advanced = control.advance(accepted, |step| summary.count(step));
            summary.time = control.dynamics().state().t;
            match advanced {
                Ok(true) => estimate.iter_mut().for_each(|estimate| estimate.update(control, rows)),
                Ok(false) => return Ok(Ok(ControlFlow::Continue(()))),
                Err(error) => {
                    let s = control.dynamics().state();
                    let cause = find_cause(self.assembly, s, s.load, &error);
                    return Ok(Err(RunFailure::Solve(error, cause)));
                }
            }
        }
    }

    fn record(&mut self, motion: &mut DynamicRun<'a>, report: &StepReport) -> io::Result<ControlFlow<()>> {
        let DynamicRun { rows, control, conditions, .. } = motion;
        let StepReport { iterations, residual, increment, drift, violation, .. } = *report;
        let values = [f64::from(iterations), residual, increment, drift, violation];
        let dynamics = control.dynamics();
        let s = dynamics.state();
        let (t, energy) = (s.t * self.summary.scales.time, dynamics.energy());
        rows.set_step_start(dynamics.step_start());
        let row = rows.fill(self.assembly, s, t, &values, energy, Some(dynamics.energy_exchange()));
        self.summary.ended_by = conditions.met(row, self.summary.scales);
        let flow = self.observer.record(row, s)?;
        control.mark_recorded();
        Ok(flow)
    }
}
