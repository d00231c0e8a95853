//! Execution of a run with recorder, progress bar and summary.

use std::collections::BTreeMap;
use std::io;
use std::ops::ControlFlow;
use std::time::Instant;

use ancf::errors::short;
use ancf::estimate::DiscretisationErrors;
use ancf::record::Sink;
use ancf::solver::equations::State;
use ancf::{Checkpoint, Model, Observer, Outcome, Simulation, StartState, Summary, can_refine};
use ancf_results::{CheckpointInterval, Recorder};
use anyhow::Result;
use serde::Serialize;

use super::run_summary::RunSummary;
use crate::terminal::{
    Ended, RunProgress, print, print_error, print_json, print_status, report_argument_error,
};

/// Parses the interval of checkpoints: `1000` steps, or `10min`.
pub fn checkpoint_interval(text: &str) -> Result<CheckpointInterval, String> {
    let expected = || "expected a number of steps, such as 1000, or a time, such as 30s or 10min".to_owned();
    match text.parse::<u64>() {
        Ok(0) => Err(expected()),
        Ok(steps) => Ok(CheckpointInterval::Steps(steps)),
        Err(_) => humantime::parse_duration(text).map(CheckpointInterval::Time).map_err(|_| expected()),
    }
}

/// Size of result files in bytes above which a run announces it.
const LARGE: f64 = 50e6;

/// Recorded run.
pub struct Recorded {
    pub ended: Ended,
    /// Time reached; in statics, the load factor.
    pub time: f64,
    /// JSON output of the run.
    pub json: serde_json::Value,
}

impl Recorded {
    /// Run that did not begin.
    pub const fn rejected(ended: Ended) -> Self {
        Self { ended, time: 0.0, json: serde_json::Value::Null }
    }
}

/// Command whose output is that of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Command {
    /// The command runs one analysis, whose JSON output is printed.
    Single,
    /// The command runs a sequence of analyses, and prints their JSON output.
    Sequence,
}

/// Runs and records a simulation, and reports its outcome.
pub fn record(
    command: Command,
    model: &Model,
    recorder: Recorder,
    run: impl FnOnce(&mut dyn Observer) -> Result<Summary, ancf::Error>,
) -> Result<Recorded> {
    let clock = Instant::now();
    let progress = RunProgress::of(model);
    let size = recorder.expected_size(model);
    if size.total() > LARGE {
        print_error(&format!("warning: {size}"));
    }
    let values = RunSummary::new(&model.analysis);
    let mut observer = RunObserver { recorder, values, progress, is_begun: false };
    let summary = run(&mut observer);
    let RunObserver { mut recorder, values, is_begun, .. } = observer;
    let folder = recorder.folder().path().display().to_string();
    if let Err(ancf::Error::Checkpoint(mismatch)) = &summary {
        let path = recorder.folder().checkpoint();
        return Ok(Recorded::rejected(report_argument_error(&format!(
            "{}: {mismatch}; without this file the run starts from the beginning",
            path.display()
        ))));
    }
    let summary = summary.map_err(|error| with_folder(error, is_begun.then_some(&folder)))?;
    let seconds = clock.elapsed().as_secs_f64();
    recorder.write_summary(&summary, seconds)?;
    let redundant = summary.redundant.iter().map(|one| format!("redundant: {one}"));
    // Warnings are printed even with `--quiet`.
    redundant.chain(summary.warnings.iter().cloned()).for_each(|one| print_error(&format!("warning: {one}")));
    for (name, value) in &summary.inputs {
        print_status(&format!("input `{name}`: {} throughout, as declared", short(*value)));
    }
    summary.initial.iter().for_each(|initial| print_status(&format!("start: {}", initial.sentence())));
    print(&values.table());
    let (sentence, columns) = (values.sentence(&summary, seconds, &folder), values.columns());
    let hint = hint_on_errors(model, &summary);
    let model = recorder.name();
    let output = RunJson { folder, model, wall_seconds: seconds, summary: &summary, columns };
    let (time, json) = (summary.time, serde_json::to_value(&output)?);
    if command == Command::Single {
        print_json(&output);
    }
    let ended = report(&summary, &sentence, hint);
    Ok(Recorded { ended, time, json })
}

/// Runs a simulation from a given state, or from the state of its model.
pub fn run_from(
    simulation: &Simulation,
    start: Option<&StartState>,
    observer: &mut dyn Observer,
) -> Result<Summary, ancf::Error> {
    Ok(match start {
        Some(start) => simulation.run_from(start, observer)?,
        None => simulation.run(observer)?,
    })
}

/// Statement that the errors of a run are not estimated, and of the means to estimate them.
fn hint_on_errors(model: &Model, summary: &Summary) -> Option<&'static str> {
    let is_motion = model.analysis.dynamics().is_some();
    match model.has_shells() {
        _ if summary.errors.is_some() || summary.motion_errors.is_some() => None,
        true if can_refine(&model.analysis) => Some(
            "errors: not estimated for shells; `--errors` states those of the mesh by a second solution with four times the elements",
        ),
        true if is_motion && model.starts_from().is_none() => Some(
            "errors: not estimated; `--errors` states those of the time steps, and those of the mesh by a second motion with four times the \
             elements",
        ),
        true => Some("errors: not estimated for shells; compare with a finer mesh"),
        false if is_motion && summary.initial.is_none() => {
            Some("errors: not estimated; `--errors` states those of the time steps and of the mesh")
        }
        false => None,
    }
}

/// Reports the end of a run: its errors or a hint on them, and a sentence with its outcome.
fn report(summary: &Summary, sentence: &str, hint: Option<&str>) -> Ended {
    match summary.outcome {
        Outcome::Finished => {
            // An unresolved mesh and a failed second solution are among the warnings.
            let errors = summary.errors.iter().map(DiscretisationErrors::sentence);
            errors
                .filter(|errors| !summary.warnings.contains(errors))
                .for_each(|errors| print_status(&errors));
            summary.motion_errors.iter().for_each(|errors| print_status(&errors.sentence()));
            hint.iter().for_each(|hint| print_status(hint));
            summary.ended_by.iter().for_each(|why| print_status(&format!("ended: {why}")));
            print_status(sentence);
            Ended::Done
        }
        Outcome::Stopped => {
            print_status(sentence);
            Ended::Stopped
        }
        Outcome::Failed { .. } => {
            print_error(sentence);
            Ended::Failed
        }
    }
}

/// Adds the folder of the results so far, if any, to an error.
fn with_folder(error: ancf::Error, folder: Option<&String>) -> anyhow::Error {
    let error = anyhow::Error::from(error);
    match folder {
        Some(folder) => error.context(format!("the run failed; results so far in {folder}")),
        None => error,
    }
}

/// JSON output of a run: `summary.json` and the printed table.
#[derive(Serialize)]
pub struct RunJson<'a> {
    /// Folder of the results.
    pub folder: String,
    /// Model file.
    pub model: &'a str,
    /// Wall-clock time, s.
    pub wall_seconds: f64,
    /// Summary of the run.
    #[serde(flatten)]
    pub summary: &'a Summary,
    /// Columns of modes and critical loads.
    #[serde(flatten)]
    pub columns: BTreeMap<&'static str, Vec<f64>>,
}

/// Recorder, summary and progress bar of a run.
struct RunObserver<'a> {
    recorder: Recorder,
    values: RunSummary<'a>,
    progress: RunProgress,
    /// True if files were created.
    is_begun: bool,
}

impl Observer for RunObserver<'_> {
    fn begin(&mut self, columns: &[String]) -> io::Result<()> {
        Sink::begin(&mut self.values, columns)?;
        Sink::begin(&mut self.progress, columns)?;
        self.recorder.begin(columns)?;
        self.is_begun = true;
        Ok(())
    }

    fn record(&mut self, row: &[f64], state: &State) -> io::Result<ControlFlow<()>> {
        // Neither of these stops a run.
        let _ = Sink::record(&mut self.values, row)?;
        let _ = Sink::record(&mut self.progress, row)?;
        self.recorder.record(row, state)
    }

    fn checkpoint(&mut self, take: &dyn Fn() -> Checkpoint) -> io::Result<()> {
        self.recorder.checkpoint(take)
    }

    fn last_checkpoint(&mut self, take: &dyn Fn() -> Checkpoint) -> io::Result<()> {
        self.recorder.last_checkpoint(take)
    }

    fn finish(&mut self) -> io::Result<()> {
        Sink::finish(&mut self.progress)?;
        self.recorder.finish()
    }
}
