//! `ancf resume`: resumes a run from its last checkpoint.

use std::collections::BTreeMap;
use std::path::PathBuf;

use ancf::Simulation;
use ancf_results::{CheckpointError, CheckpointInterval, Recorder};
use ancf_surface::BodySurfaces;
use anyhow::Result;
use clap::Args;

use super::recording::{RunJson, checkpoint_interval, record};
use crate::results::open_run;
use crate::terminal::{Ended, interrupt, print_json, print_status, reject};

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
start from the beginning.";

impl ResumeArguments {
    /// Resumes the run in the folder.
    pub fn run(&self) -> Result<Ended> {
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
        let (folder, text, model) = (results.folder().clone(), results.text(), results.model());
        let simulation = Simulation::new(model)?.with_interrupt(interrupt()?);
        let resumed = match Recorder::resume(folder.clone(), text, model, &simulation) {
            Err(error @ CheckpointError::Damaged { .. }) => return Ok(reject(&error.to_string())),
            resumed => resumed?,
        };
        match resumed {
            Some((recorder, from)) => {
                print_status(&format!("resuming from t = {}", from.time()));
                let recorder = recorder.with_checkpoints(self.checkpoint);
                record(model, recorder, |observer| simulation.resume(&from, observer))
            }
            None => {
                print_status("no checkpoint found: starting from the beginning");
                let name = folder.model().display().to_string();
                let recorder = Recorder::new(folder, &name, text, model, &simulation);
                let (surfaces, _) = BodySurfaces::of_run(model, &self.folder);
                let recorder = recorder.with_checkpoints(self.checkpoint).with_display(surfaces.files()?);
                record(model, recorder, |observer| Ok(simulation.run(observer)?))
            }
        }
    }
}
