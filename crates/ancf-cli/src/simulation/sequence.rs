//! Runs of model files with several analyses.

use std::fs;
use std::path::Path;

use ancf::Simulation;
use ancf::reading::{AnalysisSequence, SequenceStage, ValidModel};
use ancf::solver::newton::Interrupt;
use ancf_results::{CheckpointInterval, Folder, Recorder, Results};
use ancf_surface::BodySurfaces;
use anyhow::{Context, Result};
use serde::Serialize;

use super::continuation::resume;
use super::recording::{Command, Recorded, record, run_from};
use crate::model::start_of;
use crate::terminal::{Ended, print_json, print_status, report_argument_error};

/// Run of a sequence of analyses, each into a folder of its own.
pub struct SequenceRun<'a> {
    /// Model file.
    pub file: &'a Path,
    /// Results folder of the sequence.
    pub folder: &'a Path,
    /// Surfaces of the bodies.
    pub surfaces: BodySurfaces,
    /// Interval of checkpoints.
    pub checkpoint: CheckpointInterval,
    pub interrupt: Interrupt,
}

/// JSON output of a sequence.
#[derive(Serialize)]
struct SequenceJson {
    folder: String,
    /// JSON output of each analysis that was run.
    analyses: Vec<serde_json::Value>,
}

impl SequenceRun<'_> {
    /// Runs the analyses in their order up to the first one that does not end. `resume` skips those that are finished.
    pub fn run(&self, sequence: &AnalysisSequence, resume: bool) -> Result<Ended> {
        let count = sequence.stages.len();
        let (mut ended, mut time, mut analyses) = (Ended::Done, 0.0, Vec::new());
        for (number, stage) in sequence.stages.iter().enumerate() {
            print_status(&format!("analysis {} of {count}: `{}`", number + 1, stage.name));
            let recorded = self.run_stage(stage, time, resume)?;
            ended = recorded.ended;
            analyses.push(recorded.json);
            if ended != Ended::Done {
                break;
            }
            if stage.model.analysis.dynamics().is_some() {
                time = recorded.time;
            }
        }
        print_json(&SequenceJson { folder: self.folder.display().to_string(), analyses });
        Ok(ended)
    }

    fn run_stage(&self, stage: &SequenceStage, time: f64, is_resumed: bool) -> Result<Recorded> {
        let folder = self.folder.join(&stage.folder);
        let text = stage.text(time);
        if is_resumed && let Ok(results) = Results::open(&folder) {
            let of_same = results.text() == text;
            let done = results.summary_file()?.filter(|done| of_same && done.summary.outcome.is_finished());
            if let Some(done) = done {
                print_status(&format!("{} is finished", folder.display()));
                let json = serde_json::to_value(&done.summary)?;
                return Ok(Recorded { ended: Ended::Done, time: done.summary.time, json });
            }
            if of_same {
                return resume(Command::Sequence, &results, self.checkpoint, &self.interrupt);
            }
        }
        // The path of the results before is relative to this folder.
        fs::create_dir_all(&folder).with_context(|| folder.display().to_string())?;
        self.record(stage, &text, &folder)
    }

    fn record(&self, stage: &SequenceStage, text: &str, folder: &Path) -> Result<Recorded> {
        let prepared = ValidModel::parse(text).and_then(|model| {
            let simulation = Simulation::of_valid(&model)?;
            let start = start_of(&model, &simulation, text, &folder.join("model.toml"))?;
            Ok((model, simulation, start))
        });
        let (model, simulation, start) = match prepared {
            Ok(prepared) => prepared,
            Err(errors) => {
                let message = format!("{}: analysis `{}`: {errors}", self.file.display(), stage.name);
                return Ok(Recorded::rejected(report_argument_error(&message)));
            }
        };
        let simulation = simulation.with_interrupt(self.interrupt.clone());
        let name = format!("{}, analysis `{}`", self.file.display(), stage.name);
        let recorder = Recorder::new(Folder::new(folder), &name, text, &model, &simulation);
        let recorder = recorder.with_checkpoints(self.checkpoint).with_display(self.surfaces.files()?);
        record(Command::Sequence, &model, recorder, |observer| {
            run_from(&simulation, start.as_ref(), observer)
        })
    }
}
