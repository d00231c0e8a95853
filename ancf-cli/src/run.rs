//! `ancf run` and `ancf resume`: a model into a folder.

use std::fs;
use std::io;
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::time::Instant;

use ancf::record::Sink;
use ancf::system::State;
use ancf::{Checkpoint, Model, Observer, Outcome, Simulation, Summary};
use ancf_results::{Every, Folder, Recorder};
use anyhow::{Context, Result};
use clap::Args;

use crate::command::{Ended, refuse};
use crate::conclusion::Conclusion;
use crate::progress::{Progress, ctrl_c, print, say};
use crate::view::opened;

/// What `ancf run` is given.
#[derive(Args)]
pub struct Arguments {
    /// The model file (TOML).
    file: PathBuf,
    /// The folder for results.parquet, states.parquet, probes.csv and summary.json.
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// How often to write a checkpoint, from which `ancf resume` goes on: after so many steps (1000), or so much time (30s, 10min).
    #[arg(long, value_name = "EVERY", default_value = "5min", value_parser = every)]
    checkpoint: Every,
    /// Show no progress.
    #[arg(short, long)]
    quiet: bool,
}

/// What `ancf resume` is given.
#[derive(Args)]
pub struct Resumption {
    /// The folder of a run that was stopped, failed or killed.
    folder: PathBuf,
    /// How often to write a checkpoint: after so many steps (1000), or so much time (30s, 10min).
    #[arg(long, value_name = "EVERY", default_value = "5min", value_parser = every)]
    checkpoint: Every,
    /// Show no progress.
    #[arg(short, long)]
    quiet: bool,
}

/// `1000` steps, or `10min`.
fn every(text: &str) -> Result<Every, String> {
    let wanted = || "a number of steps, such as 1000, or a time, such as 30s or 10min".to_owned();
    match text.parse::<u64>() {
        Ok(0) => Err(wanted()),
        Ok(steps) => Ok(Every::Steps(steps)),
        Err(_) => humantime::parse_duration(text).map(Every::Time).map_err(|_| wanted()),
    }
}

/// Examples for the help.
pub const EXAMPLES: &str = "\
Examples:
  ancf run models/cantilever.toml -o out          a motion
  ancf run models/elastica.toml -o out            an equilibrium
  ancf run models/lees_frame.toml -o out          a path through snap-through and snap-back
  ancf run models/tuning_fork.toml -o out         natural frequencies, also printed
  ancf run models/column.toml -o out              critical loads, also printed";

impl Arguments {
    /// Runs the model.
    pub fn run(&self) -> Result<Ended> {
        let model = match Model::read(&self.file) {
            Ok(model) => model,
            Err(errors) => return Ok(refuse(&errors, &self.file)),
        };
        let text = fs::read_to_string(&self.file)
            .with_context(|| format!("{} cannot be read", self.file.display()))?;
        let simulation = match Simulation::new(&model) {
            Ok(simulation) => simulation.heeding(ctrl_c()?),
            Err(errors) => return Ok(refuse(&errors, &self.file)),
        };
        let recorder = Recorder::new(Folder::new(&self.output), &text, &model, &simulation);
        let recorder = recorder.with_checkpoints(self.checkpoint);
        let name = self.file.display().to_string();
        record(&model, &name, recorder, self.quiet, |followers| Ok(simulation.run(followers)?))
    }
}

/// Examples for the help.
pub const RESUME_EXAMPLES: &str = "\
Examples:
  ancf run models/bow.toml -o out --checkpoint 1000
  ancf resume out                                 goes on after Ctrl-C, kill -9 or a full disk

Results are to the last bit those of a run that was never stopped. Analyses other than motions are run anew.";

impl Resumption {
    /// Goes on with the run in a folder.
    pub fn run(&self) -> Result<Ended> {
        let results = match opened(&self.folder)? {
            Ok(results) => results,
            Err(ended) => return Ok(ended),
        };
        let name = results.folder().model().display().to_string();
        if results.conclusion()?.is_some_and(|conclusion| conclusion.summary.outcome.is_finished()) {
            say(&format!("{} is finished: there is nothing to do", self.folder.display()));
            return Ok(Ended::Done);
        }
        let (folder, text, model) = (results.folder().clone(), results.text(), results.model());
        let simulation = Simulation::new(model)?.heeding(ctrl_c()?);
        match Recorder::resume(folder.clone(), text, model, &simulation)? {
            Some((recorder, from)) => {
                say(&format!("going on from t = {}", from.time()));
                let recorder = recorder.with_checkpoints(self.checkpoint);
                record(model, &name, recorder, self.quiet, |followers| simulation.resume(&from, followers))
            }
            None => {
                say("there is no checkpoint: beginning anew");
                let recorder = Recorder::new(folder, text, model, &simulation);
                let recorder = recorder.with_checkpoints(self.checkpoint);
                record(model, &name, recorder, self.quiet, |followers| Ok(simulation.run(followers)?))
            }
        }
    }
}

/// Carries a run out that is recorded, and says how it ended.
fn record(
    model: &Model,
    name: &str,
    recorder: Recorder,
    quiet: bool,
    run: impl FnOnce(&mut dyn Observer) -> Result<Summary, ancf::Error>,
) -> Result<Ended> {
    let clock = Instant::now();
    let progress = match model.analysis.dynamics() {
        Some(settings) if !quiet => Progress::until(settings.duration),
        _ => Progress::hidden(),
    };
    let mut followers = Followers { recorder, conclusion: Conclusion::of(&model.analysis), progress };
    let summary = run(&mut followers);
    let Followers { recorder, conclusion, .. } = followers;
    let folder = recorder.folder().path().display().to_string();
    let summary =
        summary.with_context(|| format!("results could not be written; those so far are in {folder}"))?;
    let seconds = clock.elapsed().as_secs_f64();
    recorder.conclude(&summary, name, seconds)?;
    summary.redundant.iter().for_each(|one| say(&format!("warning: redundant: {one}")));
    print(&conclusion.table());
    say(&conclusion.sentence(&summary, seconds, &folder));
    Ok(match summary.outcome {
        Outcome::Finished => Ended::Done,
        Outcome::Stopped => Ended::Stopped,
        Outcome::Failed { .. } => Ended::Failed,
    })
}

/// All who follow a run.
struct Followers<'a> {
    recorder: Recorder,
    conclusion: Conclusion<'a>,
    progress: Progress,
}

impl Observer for Followers<'_> {
    fn begin(&mut self, columns: &[String]) -> io::Result<()> {
        Sink::begin(&mut self.conclusion, columns)?;
        Sink::begin(&mut self.progress, columns)?;
        self.recorder.begin(columns)
    }

    fn record(&mut self, row: &[f64], state: &State) -> io::Result<ControlFlow<()>> {
        // Neither of these ends a run.
        let _ = Sink::record(&mut self.conclusion, row)?;
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
