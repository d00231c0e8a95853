//! `ancf resume`: resumes a run from its last checkpoint.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use ancf::reading::AnalysisSequence;
use ancf::solver::newton::Interrupt;
use ancf::{Model, Simulation};
use ancf_results::{CheckpointError, CheckpointInterval, Recorder, Results, sequence_file};
use ancf_surface::BodySurfaces;
use anyhow::Result;
use clap::Args;

use super::recording::{Command, Recorded, RunJson, checkpoint_interval, record};
use super::sequence::SequenceRun;
use crate::model::start_of;
use crate::results::open_run;
use crate::terminal::{Ended, interrupt, print_json, print_status, refuse, reject};

/// Arguments of `ancf resume`.
#[derive(Debug, Args)]
pub struct ResumeArguments {
    /// Results folder of the run that was stopped, failed or killed.
    folder: PathBuf,
    /// Interval of checkpoints: a number of steps (1000) or a time (30s, 10min).
    #[arg(long, value_name = "EVERY", default_value = "5min", value_parser = checkpoint_interval)]
    checkpoint: CheckpointInterval,
    /// Print one JSON object on standard output and nothing else.
    #[arg(long)]
    pub json: bool,
}

/// Examples of the help.
pub const RESUME_EXAMPLES: &str = "\
Examples:
  ancf run models/bow.toml -o out --checkpoint 1000
  ancf resume out                                 after Ctrl-C, kill -9 or a full disk

The results are bit-identical to those of a run that was not stopped. Analyses other than dynamics
start from the beginning. Of a list of analyses, those that are finished are skipped.";

impl ResumeArguments {
    /// Resumes the run or the sequence of analyses in the folder.
    pub fn run(&self) -> Result<Ended> {
        let sequence = sequence_file(&self.folder);
        if sequence.is_file() {
            return self.resume_sequence(&sequence);
        }
        let results = match open_run(&self.folder)? {
            Ok(results) => results,
            Err(ended) => return Ok(ended),
        };
        let is_finished = |done: &ancf_results::SummaryFile| done.summary.outcome.is_finished();
        if let Some(done) = results.summary_file()?.filter(is_finished) {
            let (folder, columns) = (self.folder.display().to_string(), BTreeMap::new());
            let ancf_results::SummaryFile { model, wall_seconds, summary, .. } = &done;
            print_json(&RunJson { folder, model, wall_seconds: *wall_seconds, summary, columns });
            print_status(&format!("{} is finished: there is nothing to do", self.folder.display()));
            return Ok(Ended::Done);
        }
        Ok(resume(Command::Single, &results, self.checkpoint, &interrupt()?)?.ended)
    }

    fn resume_sequence(&self, file: &Path) -> Result<Ended> {
        let sequence = Model::read_text(file).and_then(|text| AnalysisSequence::parse(&text));
        let sequence = match sequence {
            Ok(Some(sequence)) => sequence,
            Ok(None) => return Ok(reject(&format!("{} has no list of analyses", file.display()))),
            Err(errors) => return Ok(refuse(&errors, file)),
        };
        let (folder, checkpoint) = (self.folder.as_path(), self.checkpoint);
        let first = &sequence.stages[0];
        let (surfaces, _) = BodySurfaces::of_run(&first.model, &folder.join(&first.folder));
        SequenceRun { file, folder, surfaces, checkpoint, interrupt: interrupt()? }.run(&sequence, true)
    }
}

/// Resumes a run from its last checkpoint, or from the beginning if there is none.
pub fn resume(
    command: Command,
    results: &Results,
    interval: CheckpointInterval,
    interrupt: &Interrupt,
) -> Result<Recorded> {
    let (folder, text, model) = (results.folder().clone(), results.text(), results.model());
    let simulation = Simulation::new(model)?.with_interrupt(interrupt.clone());
    let resumed = match Recorder::resume(folder.clone(), text, model, &simulation) {
        Err(error @ CheckpointError::Damaged { .. }) => {
            return Ok(Recorded::rejected(reject(&error.to_string())));
        }
        resumed => resumed?,
    };
    if let Some((recorder, from)) = resumed {
        print_status(&format!("resuming from t = {}", from.time()));
        let recorder = recorder.with_checkpoints(interval);
        return record(command, model, recorder, |observer| simulation.resume(&from, observer));
    }
    print_status("no checkpoint found: starting from the beginning");
    let file = folder.model();
    let start = match start_of(model, &simulation, text, &file) {
        Ok(start) => start,
        Err(errors) => return Ok(Recorded::rejected(refuse(&errors, &file))),
    };
    let (surfaces, _) = BodySurfaces::of_run(model, folder.path());
    let recorder = Recorder::new(folder, &file.display().to_string(), text, model, &simulation);
    let recorder = recorder.with_checkpoints(interval).with_display(surfaces.files()?);
    record(command, model, recorder, |observer| match &start {
        Some(start) => Ok(simulation.run_from(start, observer)?),
        None => Ok(simulation.run(observer)?),
    })
}
