use ancf_solver::equations::State;
use ancf_solver::newton::Interrupt;

use super::outcome::finer_failure;
use super::simulation::Simulation;
use super::step_control::{StepControl, StepControlCheckpoint};
use crate::estimate::{FinerMesh, GIVEN_START, HalvedModel, MeshComparison, ValueError};
use crate::failure::RunFailure;
use crate::initial::InitialState;
use crate::model::Dynamics;
use crate::results::{Rows, TIME};
use crate::units::Scales;

/// Motion of a model with shells on a mesh with elements of half the size, in the same time steps.
pub(super) struct FinerMotion<'a> {
    comparison: MeshComparison<'a>,
    steps: Result<FinerSteps<'a>, String>,
}

struct FinerSteps<'a> {
    halved: &'a HalvedModel,
    control: StepControl<'a>,
}

/// State of the step control on the finer mesh, or the reason for which there is none.
pub(super) type FinerMotionCheckpoint = Result<StepControlCheckpoint, String>;

impl<'a> FinerMotion<'a> {
    /// Starts the motion, if the errors of a model with shells are to be estimated. `is_given` is true for a start in a given state.
    pub(super) fn new(simulation: &'a Simulation, settings: &Dynamics, is_given: bool) -> Option<Self> {
        let halved = simulation.halved()?;
        let scales = simulation.scales();
        let comparison = MeshComparison::new(&simulation.scaled, &simulation.assembly, scales);
        let steps = match (comparison.obstacle(), halved) {
            (Some(reason), _) => Err(reason.to_owned()),
            _ if is_given => Err(GIVEN_START.into()),
            (None, Err(reason)) => Err(reason.clone()),
            (None, Ok(halved)) => FinerSteps::new(halved, settings, scales),
        };
        Some(Self { comparison, steps })
    }

    /// Takes the step to an accepted state of the motion on the given mesh.
    pub(super) fn follow(&mut self, t: f64) {
        let Ok(FinerSteps { halved, control }) = &mut self.steps else { return };
        if let Err(error) = control.follow(t) {
            self.steps = Err(finer_failure(error.into(), halved, self.comparison.scales()));
        }
    }

    /// Errors of the values in the state that the motion has reached on the given mesh.
    ///
    /// # Errors
    /// The reason for which they are not known.
    pub(super) fn errors(&self, given: &State) -> Result<(Vec<ValueError>, FinerMesh), String> {
        let FinerSteps { halved, control } = self.steps.as_ref().map_err(String::clone)?;
        self.comparison.motion(given, halved, control.dynamics().state())
    }

    /// State after the last step.
    pub(super) fn checkpoint(&self) -> FinerMotionCheckpoint {
        self.steps.as_ref().map(|steps| steps.control.checkpoint()).map_err(String::clone)
    }

    /// Restores a state. Returns false if it belongs to another model.
    pub(super) fn restore(&mut self, checkpoint: &FinerMotionCheckpoint) -> bool {
        match (&mut self.steps, checkpoint) {
            (Ok(steps), Ok(checkpoint)) => steps.control.restore(checkpoint).is_ok(),
            (Err(_), Ok(_)) => false,
            (_, Err(reason)) => {
                self.steps = Err(reason.clone());
                true
            }
        }
    }
}

impl<'a> FinerSteps<'a> {
    /// Computes the consistent start. A stop request takes effect in the motion on the given mesh.
    fn new(halved: &'a HalvedModel, settings: &Dynamics, scales: Scales) -> Result<Self, String> {
        let HalvedModel { model, assembly } = halved;
        let failed = |failure: RunFailure| finer_failure(failure, halved, scales);
        let interrupt = Interrupt::default();
        let mut rows = Rows::new(assembly, scales, TIME, &[]);
        let start = InitialState::new((model, scales), assembly, (&interrupt, None), &mut rows);
        let start = start.map_err(failed)?.state;
        let control = StepControl::new(model, start, settings, assembly, interrupt);
        let control = control.map_err(|error| failed(error.into()))?.following();
        Ok(Self { halved, control })
    }
}
