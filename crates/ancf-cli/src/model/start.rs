//! Start of a motion in the state of another run.

use std::path::Path;

use ancf::model::ModelErrors;
use ancf::reading::with_places;
use ancf::{Model, Simulation, StartState};
use ancf_results::given_state;

/// Reads the state of another run in which the motion of a model file with some text starts. The results folder is relative to the
/// folder of the file.
///
/// # Errors
/// If the folder has no such state, or the state of another structure.
pub fn start_of(
    model: &Model,
    simulation: &Simulation,
    text: &str,
    file: &Path,
) -> Result<Option<StartState>, ModelErrors> {
    let given = given_state(model, file.parent().unwrap_or(Path::new("")));
    let start = given.and_then(|given| given.map(|given| simulation.start_from(&given)).transpose());
    start.map_err(|errors| with_places(errors, text))
}
