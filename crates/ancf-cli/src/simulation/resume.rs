//! `ancf resume`: resumes a run from its last checkpoint.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use ancf::Model;
use ancf::reading::AnalysisSequence;
use ancf_results::{CheckpointInterval, sequence_file};
use ancf_surface::BodySurfaces;
use anyhow::Result;
use clap::Args;

use super::continuation::resume;
use super::recording::{Command, RunJson, checkpoint_interval};
use super::sequence::SequenceRun;
use crate::results::open_run;
use crate::terminal::{
    Ended, interrupt, print_json, print_status, report_argument_error, report_model_errors,
};

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
            Ok(None) => {
                return Ok(report_argument_error(&format!("{} has no list of analyses", file.display())));
            }
            Err(errors) => return Ok(report_model_errors(&errors, file)),
        };
        let (folder, checkpoint) = (self.folder.as_path(), self.checkpoint);
        let first = &sequence.stages[0];
        let (surfaces, _) = BodySurfaces::of_run(&first.model, &folder.join(&first.folder));
        SequenceRun { file, folder, surfaces, checkpoint, interrupt: interrupt()? }.run(&sequence, true)
    }
}
