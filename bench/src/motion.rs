//! A model in motion, stepped directly.

use ancf::Model;
use ancf::analysis::{Dynamics, Newton, Scheme, StepReport};
use ancf::model::{self, Assembly};
use ancf::system::{EquationsOfMotion, SparseMatrix, State, System, Weights};

use crate::measure::Result;
use crate::model::{Kind, STEP, read};

/// An assembled cantilever; it lives as long as the program, which spares a measurement all borrowing.
#[derive(Debug)]
pub struct Plant {
    /// Its equations and meshes.
    pub assembly: &'static Assembly,
    model: &'static Model,
    settings: model::Dynamics,
}

impl Plant {
    /// A cantilever of so many elements.
    ///
    /// # Errors
    /// If the library does not take it.
    pub fn new(kind: Kind, elements: u32) -> Result<Self> {
        let model = read(kind, elements, 1).map_err(|errors| errors.to_string())?;
        let assembly = model.assemble().map_err(|errors| errors.to_string())?;
        let settings = model.analysis.dynamics().ok_or("a cantilever moves")?.clone();
        Ok(Self { assembly: Box::leak(Box::new(assembly)), model: Box::leak(Box::new(model)), settings })
    }

    /// Its equations of motion.
    pub fn system(&self) -> &'static System {
        &self.assembly.system
    }

    /// What moves the state in a step.
    pub fn weights(&self) -> Weights {
        self.scheme().weights(STEP)
    }

    fn scheme(&self) -> Scheme {
        self.settings.scheme.numbers()
    }

    /// Its motion from rest.
    ///
    /// # Errors
    /// If memory does not suffice, or the mass matrix is singular.
    pub fn motion(&self) -> Result<Dynamics<'static, System>> {
        let system = self.system();
        let newton = Newton::new(system.matrix(), self.settings.stop.into(), self.settings.max_iterations)
            .map_err(|error| error.to_string())?;
        let start = self.assembly.start(self.model);
        let mut motion = Dynamics::new(system, self.scheme(), newton, self.settings.max_halvings, start);
        motion.take_in().and_then(|()| motion.restart(0.0)).map_err(|error| error.to_string())?;
        Ok(motion)
    }

    /// Its state after so many steps.
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

    /// The matrix of a step.
    pub fn tangent(&self, state: &State) -> SparseMatrix {
        let mut matrix = self.system().matrix();
        self.system().tangent(state, self.weights(), &mut matrix);
        matrix
    }
}

/// One step of 1 ms.
///
/// # Errors
/// If it fails.
pub fn step(motion: &mut Dynamics<'static, System>) -> Result<StepReport> {
    let to = motion.state().t + STEP;
    motion.advance(to).map_err(|error| error.to_string())
}
