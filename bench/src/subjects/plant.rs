use ancf::Model;
use ancf::assembly::Assembly;
use ancf::model;
use ancf::solver::dynamics::{SchemeCoefficients, StepReport, TimeStepper};
use ancf::solver::equations::{EquationsOfMotion, State, System, Weights};
use ancf::solver::newton::Newton;
use ancf::solver::sparse::SparseMatrix;

use super::cantilever::{CantileverKind, STEP, cantilever};
use crate::Result;

/// Assembled model. It is leaked, so that subjects can refer to it without a lifetime.
#[derive(Debug)]
pub struct Plant {
    /// Equations and meshes.
    pub assembly: &'static Assembly,
    model: &'static Model,
    settings: model::Dynamics,
}

impl Plant {
    /// Assembles a cantilever.
    ///
    /// # Errors
    /// If the model is invalid.
    pub fn new(kind: CantileverKind, elements: u32) -> Result<Self> {
        Self::of_file(&cantilever(kind, elements, 1))
    }

    /// Assembles the model of a file, with a dynamic analysis.
    ///
    /// # Errors
    /// If the model is invalid.
    pub fn of_file(text: &str) -> Result<Self> {
        let model = Model::parse(text).map_err(|errors| errors.to_string())?;
        let assembly = model.assemble().map_err(|errors| errors.to_string())?;
        let settings = model.analysis.dynamics().ok_or("the analysis is dynamic")?.clone();
        Ok(Self { assembly: Box::leak(Box::new(assembly)), model: Box::leak(Box::new(model)), settings })
    }

    /// Equations of motion.
    pub fn system(&self) -> &'static System {
        &self.assembly.system
    }

    /// Weights of the tangent in a step.
    pub fn weights(&self) -> Weights {
        self.scheme().weights(STEP)
    }

    fn scheme(&self) -> SchemeCoefficients {
        self.settings.scheme.numbers()
    }

    /// Returns the time integration, started from rest.
    ///
    /// # Errors
    /// If memory does not suffice, or the mass matrix is singular.
    pub fn motion(&self) -> Result<TimeStepper<'static, System>> {
        let system = self.system();
        let newton = Newton::new(system.matrix(), self.settings.stop.into(), self.settings.max_iterations)
            .map_err(|error| error.to_string())?;
        let start = self.assembly.start(self.model);
        let mut motion = TimeStepper::new(system, self.scheme(), newton, self.settings.max_halvings, start);
        motion.include_near_terms().and_then(|()| motion.restart(0.0)).map_err(|error| error.to_string())?;
        Ok(motion)
    }

    /// Returns the state after a number of steps.
    ///
    /// # Errors
    /// If a step fails.
    pub fn after(&self, steps: u32) -> Result<State> {
        let mut motion = self.motion()?;
        for _ in 0..steps {
            step(&mut motion)?;
        }
        Ok(motion.state().clone())
    }

    /// Returns the tangent of a step.
    pub fn tangent(&self, state: &State) -> SparseMatrix {
        let mut matrix = self.system().matrix();
        self.system().tangent(state, self.weights(), &mut matrix);
        matrix
    }
}

/// Computes one step of 1 ms.
///
/// # Errors
/// If the step fails.
pub fn step(motion: &mut TimeStepper<'static, System>) -> Result<StepReport> {
    let to = motion.state().t + STEP;
    motion.advance(to).map_err(|error| error.to_string())
}
