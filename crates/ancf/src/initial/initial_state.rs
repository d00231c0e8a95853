use ancf_solver::equations::{EquationsOfMotion, State};
use serde::{Deserialize, Serialize};

use super::report::InitialReport;
use crate::assembly::Assembly;
use crate::model::Model;

/// State from which a motion starts, before its velocities are projected onto the constraints.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct InitialState {
    pub(crate) state: State,
    /// Origin of the state; `None` for the undeformed state.
    pub(crate) report: Option<InitialReport>,
    pub(crate) warnings: Vec<String>,
}

impl InitialState {
    /// Undeformed state with the velocities of the model.
    pub(crate) fn undeformed(model: &Model, assembly: &Assembly) -> Self {
        Self { state: assembly.start(model), report: None, warnings: Vec::new() }
    }

    /// True if the state can be that of a model with this assembly.
    pub(crate) fn is_valid(&self, assembly: &Assembly) -> bool {
        let system = &assembly.system;
        self.state.is_valid(system.coordinates(), system.multipliers())
    }
}
