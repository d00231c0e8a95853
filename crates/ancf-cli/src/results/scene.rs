//! Scene of a run for the browser.

use ancf_report::{Ending, Recording, Snapshot, scene, summary_rows, summary_warnings};
use ancf_results::{KILLED, Results, RunStatus, SummaryFile};
use ancf_surface::BodySurfaces;
use anyhow::Result;

use super::run_folder::{recording, title};

/// Returns the scene of the results so far.
pub fn scene_of(results: &Results, live: bool, budget: usize) -> Result<Vec<u8>> {
    let status = results.status();
    let conclusion = results.summary_file()?;
    let summary = conclusion.as_ref().map(|conclusion| &conclusion.summary);
    let mut messages = summary.map(summary_warnings).unwrap_or_default();
    let ending = match (status, summary) {
        (RunStatus::Running, _) => Ending::Running,
        (_, Some(summary)) => Ending::new(&summary.outcome, &results.model().analysis),
        (_, None) => {
            messages.push(KILLED.to_owned());
            Ending::Stopped
        }
    };
    let mut frames = Vec::new();
    for frame in results.frames() {
        let ancf_results::StoredState { value, state, .. } = frame?;
        frames.push(Snapshot { value, state });
    }
    let series = results.columns()?;
    let output = results.model().output;
    if !output.parquet {
        messages.push("The run recorded no rows (`output.parquet = false`): there are no charts.".to_owned());
    } else if series.columns().all(|(_, values)| values.is_empty()) {
        messages.push("There are no rows on the disk.".to_owned());
    }
    if output.states > 0 && frames.is_empty() {
        messages.push("There are no states on the disk.".to_owned());
    }
    let (surfaces, missing) = BodySurfaces::of_run(results.model(), results.folder().path());
    messages.extend(missing);
    let title = title(results);
    let run = Recording {
        frames,
        summary: conclusion.as_ref().map(rows).unwrap_or_default(),
        body_errors: conclusion.as_ref().map_or_else(Vec::new, |found| found.summary.body_errors().to_vec()),
        ending,
        messages,
        live: live && status == RunStatus::Running,
        ..recording(results, &title, &series, &surfaces)
    };
    Ok(scene(&run, budget))
}

/// Returns names and values of the summary of a run.
fn rows(conclusion: &SummaryFile) -> Vec<(String, String)> {
    let SummaryFile { program, model, wall_seconds, summary } = conclusion;
    let own =
        [("model", model.clone()), ("program", program.clone()), ("seconds", format!("{wall_seconds:.3}"))];
    own.into_iter().map(|(name, value)| (name.to_owned(), value)).chain(summary_rows(summary)).collect()
}
