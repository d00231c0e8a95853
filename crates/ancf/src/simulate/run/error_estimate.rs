use ancf_solver::equations::State;
use serde::{Deserialize, Serialize};

use super::finer_motion::{FinerMotion, FinerMotionCheckpoint};
use super::simulation::Simulation;
use super::step_control::StepControl;
use crate::estimate::{EstimateHistory, MotionErrors, MotionEstimate};
use crate::initial::{InitialReport, InitialState};
use crate::model::Dynamics;
use crate::results::Rows;

/// Estimate of the errors of a motion during its integration.
pub(crate) struct ErrorEstimate<'a> {
    estimate: MotionEstimate<'a>,
    /// Motion on a finer mesh, with shells.
    finer: Option<FinerMotion<'a>>,
}

/// State of the estimate of the errors.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct ErrorEstimateCheckpoint {
    history: EstimateHistory,
    finer: Option<FinerMotionCheckpoint>,
}

impl<'a> ErrorEstimate<'a> {
    /// Creates the estimate at the start of a motion, if it is requested.
    pub(crate) fn new(
        simulation: &'a Simulation,
        settings: &Dynamics,
        initial: &InitialState,
    ) -> Option<Self> {
        let Simulation { scaled, assembly, .. } = simulation;
        scaled.output.errors.then(|| {
            let is_given = matches!(initial.report, Some(InitialReport::Given { .. }));
            Self {
                estimate: MotionEstimate::new(scaled, assembly, simulation.scales()),
                finer: FinerMotion::new(simulation, settings, is_given),
            }
        })
    }

    /// Takes an accepted step of the motion on the finer mesh.
    pub(crate) fn follow(&mut self, accepted: &State) {
        self.finer.iter_mut().for_each(|finer| finer.follow(accepted.t));
    }

    /// Estimates the errors of the current state, and sets those of the next row if it is to be recorded.
    pub(crate) fn update(&mut self, control: &mut StepControl<'_>, rows: &mut Rows) {
        let is_recorded = control.due_report().is_some();
        let errors = match &self.finer {
            None => self.estimate.advance(control.dynamics_mut(), is_recorded),
            Some(_) if !is_recorded => None,
            Some(finer) => {
                let of_mesh = finer.errors(control.dynamics().state());
                Some(self.estimate.compare(control.dynamics(), of_mesh))
            }
        };
        if let Some(errors) = errors {
            rows.set_errors(errors.iter().map(|value| (value.column.as_str(), value.error)));
        }
    }

    /// Errors so far.
    pub(crate) fn errors(&self) -> &MotionErrors {
        self.estimate.errors()
    }

    /// State after the last step.
    pub(super) fn checkpoint(&self) -> ErrorEstimateCheckpoint {
        let finer = self.finer.as_ref().map(FinerMotion::checkpoint);
        ErrorEstimateCheckpoint { history: self.estimate.history().clone(), finer }
    }

    /// Restores a state. Returns false if it belongs to another model.
    pub(super) fn restore(&mut self, checkpoint: &ErrorEstimateCheckpoint) -> bool {
        let is_finer_restored = match (&mut self.finer, &checkpoint.finer) {
            (Some(finer), Some(checkpoint)) => finer.restore(checkpoint),
            (None, None) => true,
            _ => false,
        };
        is_finer_restored && self.estimate.restore(&checkpoint.history)
    }
}
