//! Checks of model files with several analyses.

use ancf::Simulation;
use ancf::model::ModelErrors;
use ancf::reading::AnalysisSequence;

/// Errors of the models of a sequence that only their assembly shows.
pub fn check_stages(sequence: &AnalysisSequence, text: &str) -> Result<(), ModelErrors> {
    let wrong = sequence.stages.iter().filter_map(|stage| {
        let errors = Simulation::of_valid(&stage.model).err()?;
        Some(stage.with_places(errors, text).0)
    });
    let errors: Vec<_> = wrong.flatten().collect();
    if errors.is_empty() { Ok(()) } else { Err(ModelErrors(errors)) }
}
