use ancf_solver::newton::Interrupt;

use crate::assembly::Assembly;
use crate::errors::ModelErrors;
use crate::model::Model;
use crate::units::{Chosen, Scales};

/// A model that is ready to run: checked, scaled, assembled.
#[derive(Debug)]
pub struct Simulation {
    pub(crate) scaled: Model,
    pub(crate) chosen: Chosen,
    pub(crate) assembly: Assembly,
    pub(crate) interrupt: Interrupt,
}

impl Simulation {
    /// Checks, scales and assembles a model.
    ///
    /// # Errors
    /// All that is wrong with the model.
    pub fn new(model: &Model) -> Result<Self, ModelErrors> {
        model.check()?;
        let chosen = model.scales();
        let scaled = model.scaled(&chosen.scales);
        let moves = scaled.analysis.dynamics().is_some();
        let assembly = if moves { scaled.assemble()? } else { scaled.assemble_static()? };
        Ok(Self { scaled, chosen, assembly, interrupt: Interrupt::default() })
    }

    /// The same, heeding what may end it; such a run has [stopped](Outcome::Stopped).
    #[must_use]
    pub fn heeding(self, interrupt: Interrupt) -> Self {
        Self { interrupt, ..self }
    }

    /// The equations of motion, and what reads their states.
    pub fn assembly(&self) -> &Assembly {
        &self.assembly
    }

    /// The units in which the equations are solved.
    pub fn scales(&self) -> Scales {
        self.chosen.scales
    }
}
