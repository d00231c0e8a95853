use std::cell::OnceCell;
use std::collections::HashMap;

use ancf_solver::dynamics::{StepReport, TimeStepper};
use ancf_solver::newton::SolveError;

use super::events::Events;
use super::step_error::{StepError, failure_message};
use super::stepper::{Monitors, Stepper};
use crate::errors::{ModelError, ModelErrors};
use crate::failure::{AlternationMonitor, RotationMonitor, RunFailure, find_cause};
use crate::initial::{InitialState, StartState};
use crate::model::{Dynamics, Model};
use crate::results::{AngleRates, Rows, TIME};
use crate::simulate::{COLUMNS, Simulation, Summary, TIME_TOLERANCE, error_control, newton_method, started};

impl Stepper {
    /// Checks and assembles a model, and computes consistent initial values of its dynamic analysis.
    ///
    /// # Errors
    /// If the model is not valid or has no dynamic analysis, or if there are no initial values.
    pub fn new(model: &Model) -> Result<Self, StepError> {
        Self::start(Simulation::new(model)?, None)
    }

    /// Starts a simulation at its start time, in its own initial state or in a given one.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn start(simulation: Simulation, given: Option<&StartState>) -> Result<Self, StepError> {
        let settings = settings_of(&simulation)?;
        let Simulation { scaled, assembly, interrupt, chosen, warnings, .. } = &simulation;
        let (scales, failed) = (simulation.scales(), |failure| failure_message(&simulation, failure));
        let mut rows = Rows::new(assembly, scales, TIME, &COLUMNS);
        let initial = InitialState::new((scaled, scales), assembly, (interrupt, given), &mut rows);
        let initial = initial.map_err(failed)?;
        let solve = |error: SolveError| {
            let cause = find_cause(assembly, &initial.state, 1.0, &error);
            failed(RunFailure::Solve(error, cause))
        };
        let newton = newton_method(assembly, &settings, interrupt.clone()).map_err(solve)?;
        let (scheme, start) = (settings.scheme.numbers(), initial.state.clone());
        let dynamics =
            TimeStepper::owning(assembly.system.clone(), scheme, newton, settings.max_halvings, start);
        let dynamics = started(dynamics, &settings).map_err(solve)?;
        let adaptive = error_control(scaled, &settings, assembly, &dynamics);
        let tolerance = TIME_TOLERANCE * settings.step.fixed().unwrap_or(settings.duration);
        let start = dynamics.state().t;
        let events = Events::new(assembly, [start, start + settings.duration], tolerance);
        let s = dynamics.state();
        rows.count_turns(s.t, s, AngleRates::Velocities);
        let monitors = Monitors {
            rotations: RotationMonitor::new(scaled, assembly, s.t),
            alternations: AlternationMonitor::new(scaled, s.a.len()),
        };
        let mut summary = Summary::new(assembly, chosen.clone());
        summary.warnings = warnings.iter().chain(&initial.warnings).cloned().collect();
        summary.initial = initial.report;
        let columns =
            rows.columns().into_iter().enumerate().map(|(i, name)| (name, i)).collect::<HashMap<_, _>>();
        let pending = vec![None; simulation.inputs.len()];
        let mut stepper = Self {
            step: settings.step.fixed(),
            dynamics,
            adaptive,
            events,
            pending,
            rows,
            is_row_current: false,
            columns,
            monitors,
            report: StepReport::default(),
            summary,
            fingerprint: OnceCell::new(),
            simulation,
        };
        // The energy balance begins with the first row.
        stepper.row();
        Ok(stepper)
    }
}

/// Settings of the dynamic analysis of a model that can be advanced step by step.
fn settings_of(simulation: &Simulation) -> Result<Dynamics, ModelErrors> {
    let wrong =
        |path: &str, found: &str, expected: &str| ModelErrors(vec![ModelError::new(path, found, expected)]);
    let Some(settings) = simulation.scaled.analysis.dynamics() else {
        return Err(wrong(
            "analysis.kind",
            "an analysis that is not a motion",
            "\"dynamics\", which is advanced step by step",
        ));
    };
    if simulation.scaled.output.errors {
        return Err(wrong(
            "output.errors",
            "true",
            "false for a motion that is advanced step by step; a run of the whole duration estimates errors",
        ));
    }
    if !settings.until.is_empty() {
        return Err(wrong(
            "analysis.until",
            "conditions",
            "none for a motion that is advanced step by step; the calling program ends it",
        ));
    }
    Ok(settings.clone())
}
