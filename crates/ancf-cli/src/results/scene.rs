//! Scene of a run for the browser.

use ancf_report::{Ending, Frame, Recording, numbers, scene, warnings};
use ancf_results::{Conclusion, KILLED, Results, Status};
use anyhow::Result;

use super::run_folder::{recording, title};

/// Returns the scene of the results so far.
pub fn scene_of(results: &Results, live: bool, budget: usize) -> Result<Vec<u8>> {
    let status = results.status();
    let conclusion = results.conclusion()?;
    let summary = conclusion.as_ref().map(|conclusion| &conclusion.summary);
    let mut messages = summary.map(warnings).unwrap_or_default();
    let ending = match (status, summary) {
        (Status::Running, _) => Ending::Running,
        (_, Some(summary)) => Ending::new(&summary.outcome, &results.model().analysis),
        (_, None) => {
            messages.push(KILLED.to_owned());
            Ending::Stopped
        }
    };
    let mut frames = Vec::new();
    for frame in results.frames() {
        let ancf_results::Frame { value, state, .. } = frame?;
        frames.push(Frame { value, state });
    }
    let series = results.columns()?;
    let output = results.model().output;
    if output.parquet && series.columns().all(|(_, values)| values.is_empty()) {
        messages.push("There are no rows on the disk.".to_owned());
    }
    if output.states > 0 && frames.is_empty() {
        messages.push("There are no states on the disk.".to_owned());
    }
    let title = title(results);
    let run = Recording {
        frames,
        summary: conclusion.as_ref().map(rows).unwrap_or_default(),
        ending,
        messages,
        live: live && status == Status::Running,
        ..recording(results, &title, &series)
    };
    Ok(scene(&run, budget))
}

/// Returns names and values of the summary of a run.
fn rows(conclusion: &Conclusion) -> Vec<(String, String)> {
    let Conclusion { program, model, wall_seconds, summary } = conclusion;
    let own =
        [("model", model.clone()), ("program", program.clone()), ("seconds", format!("{wall_seconds:.3}"))];
    own.into_iter().map(|(name, value)| (name.to_owned(), value)).chain(numbers(summary)).collect()
}
