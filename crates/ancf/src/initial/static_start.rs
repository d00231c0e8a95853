use std::borrow::Cow;

use ancf_solver::equations::{State, System};

use super::start_state::StartState;
use crate::assembly::Assembly;
use crate::failure::{RunFailure, unloaded};
use crate::model::{Model, Origin};

/// Start of load increments: a state at the load factor 0, and the equations with this state as equilibrium.
pub(crate) struct StaticStart<'a> {
    pub(crate) state: State,
    pub(crate) system: Cow<'a, System>,
}

impl<'a> StaticStart<'a> {
    /// Start from a given state, which is released in proportion to the load factor up to `load`, or from the undeformed state.
    ///
    /// # Errors
    /// If the model states a results folder, and no state is given.
    pub(crate) fn new(
        (model, load): (&Model, f64),
        assembly: &'a Assembly,
        given: Option<&StartState>,
    ) -> Result<Self, RunFailure> {
        match (given, &model.initial.from) {
            (None, Origin::Folder(folder)) => Err(RunFailure::NoState(folder.clone())),
            (None, _) => Ok(Self { state: unloaded(assembly), system: Cow::Borrowed(&assembly.system) }),
            (Some(given), _) => {
                let state = given.at_rest();
                let system = Cow::Owned(assembly.system.released_from(&state, load, &assembly.held_rows()));
                Ok(Self { state, system })
            }
        }
    }
}
