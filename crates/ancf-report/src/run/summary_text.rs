use ancf::{Scales, Summary};

/// Returns names and values of a summary for [`Recording::summary`](crate::Recording::summary).
pub fn summary_rows(summary: &Summary) -> Vec<(String, String)> {
    let Scales { length, time, force } = summary.scales;
    let rows = [
        ("steps", summary.steps.to_string()),
        ("divided steps", summary.divided_steps.to_string()),
        ("rejected steps", summary.rejected_steps.to_string()),
        ("Newton iterations", summary.iterations.to_string()),
        ("maximum iterations per step", summary.most_iterations.to_string()),
        ("coordinates", summary.coordinates.to_string()),
        ("multipliers", summary.multipliers.to_string()),
        ("units of the solver", format!("length {length}, time {time}, force {force}")),
    ]
    .map(|(name, value)| (name.to_owned(), value));
    let initial = summary.initial.iter().map(|initial| ("start".to_owned(), initial.sentence()));
    let errors = summary
        .errors
        .iter()
        .map(|errors| ("error of the mesh".to_owned(), errors.sentence().replacen("mesh: ", "", 1)));
    let motion = summary.motion_errors.iter();
    let errors = errors.chain(motion.map(|errors| ("estimated errors".to_owned(), errors.sentence())));
    let meshes = summary.meshes.iter().enumerate();
    let meshes = meshes.map(|(number, mesh)| (format!("mesh {}", number + 1), mesh.to_string()));
    rows.into_iter().chain(initial).chain(errors).chain(meshes).collect()
}

/// Returns the warnings of a run for [`Recording::messages`](crate::Recording::messages).
pub fn summary_warnings(summary: &Summary) -> Vec<String> {
    let redundant = summary.redundant.iter().map(|one| format!("redundant: {one}"));
    summary.warnings.iter().cloned().chain(redundant).collect()
}
