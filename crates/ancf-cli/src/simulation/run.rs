//! `ancf run` and `ancf resume`: a model into a folder.

use std::collections::BTreeMap;
use std::io;
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::time::Instant;

use ancf::record::Sink;
use ancf::system::State;
use ancf::{Checkpoint, Model, Observer, Outcome, Simulation, Summary};
use ancf_results::{CheckpointError, Every, Folder, Recorder};
use anyhow::Result;
use clap::Args;
use serde::Serialize;

use crate::command::{Ended, refuse, reject};
use crate::conclusion::Conclusion;
use crate::past;
use crate::progress::Progress;
use crate::signal::interrupt;
use crate::speech::{self, answer, complain, print, say};

/// What `ancf run` is given.
#[derive(Debug, Args)]
pub struct Arguments {
    /// The model file (TOML).
    file: PathBuf,
    /// The folder for results.parquet, states.parquet, probes.csv and summary.json.
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// How often to write a checkpoint, from which `ancf resume` goes on: after so many steps (1000), or so much time (30s, 10min).
    #[arg(long, value_name = "EVERY", default_value = "5min", value_parser = every)]
    checkpoint: Every,
    /// Print one JSON object on standard output and nothing else.
    #[arg(long)]
    pub json: bool,
}

/// What `ancf resume` is given.
#[derive(Debug, Args)]
pub struct Resumption {
    /// The folder of a run that was stopped, failed or killed.
    folder: PathBuf,
    /// How often to write a checkpoint: after so many steps (1000), or so much time (30s, 10min).
    #[arg(long, value_name = "EVERY", default_value = "5min", value_parser = every)]
    checkpoint: Every,
    /// Print one JSON object on standard output and nothing else.
    #[arg(long)]
    pub json: bool,
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
  ancf run models/column.toml -o out              critical loads, also printed
  ancf run models/bow.toml -o out --json          how it ended, for scripts

Ctrl-C or SIGTERM ends it cleanly, with exit code 130 or 143; `ancf resume` goes on.";

impl Arguments {
    /// Runs the model.
    pub fn run(&self) -> Result<Ended> {
        if self.output.exists() && !self.output.is_dir() {
            return Ok(reject(&format!(
                "{} is a file, wanted a folder for the results",
                self.output.display()
            )));
        }
        let read = Model::read_text(&self.file).and_then(|text| {
            let model = Model::parse(&text)?;
            let simulation = Simulation::new(&model)?;
            Ok((text, model, simulation))
        });
        let (text, model, simulation) = match read {
            Ok(read) => read,
            Err(errors) => return Ok(refuse(&errors, &self.file)),
        };
        let simulation = simulation.heeding(interrupt()?);
        let name = self.file.display().to_string();
        let recorder = Recorder::new(Folder::new(&self.output), &name, &text, &model, &simulation);
        let recorder = recorder.with_checkpoints(self.checkpoint);
        record(&model, recorder, |followers| Ok(simulation.run(followers)?))
    }
}

/// Examples for the help.
pub const RESUME_EXAMPLES: &str = "\
Examples:
  ancf run models/bow.toml -o out --checkpoint 1000
  ancf resume out                                 goes on after Ctrl-C, kill -9 or a full disk

Results are to the last bit those of a run that was never stopped. Analyses other than motions are
run anew.";

impl Resumption {
    /// Goes on with the run in a folder.
    pub fn run(&self) -> Result<Ended> {
        let results = match past::open(&self.folder)? {
            Ok(results) => results,
            Err(ended) => return Ok(ended),
        };
        let is_finished = |done: &ancf_results::Conclusion| done.summary.outcome.is_finished();
        if let Some(done) = results.conclusion()?.filter(is_finished) {
            let (folder, columns) = (self.folder.display().to_string(), BTreeMap::new());
            let ancf_results::Conclusion { model, wall_seconds, summary, .. } = &done;
            answer(&Answer { folder, model, wall_seconds: *wall_seconds, summary, columns });
            say(&format!("{} is finished: there is nothing to do", self.folder.display()));
            return Ok(Ended::Done);
        }
        let (folder, text, model) = (results.folder().clone(), results.text(), results.model());
        let simulation = Simulation::new(model)?.heeding(interrupt()?);
        let resumed = match Recorder::resume(folder.clone(), text, model, &simulation) {
            Err(error @ CheckpointError::Damaged { .. }) => return Ok(reject(&error.to_string())),
            resumed => resumed?,
        };
        match resumed {
            Some((recorder, from)) => {
                say(&format!("going on from t = {}", from.time()));
                let recorder = recorder.with_checkpoints(self.checkpoint);
                record(model, recorder, |followers| simulation.resume(&from, followers))
            }
            None => {
                say("there is no checkpoint: beginning anew");
                let name = folder.model().display().to_string();
                let recorder = Recorder::new(folder, &name, text, model, &simulation);
                let recorder = recorder.with_checkpoints(self.checkpoint);
                record(model, recorder, |followers| Ok(simulation.run(followers)?))
            }
        }
    }
}

/// Carries a run out that is recorded, and says how it ended.
fn record(
    model: &Model,
    recorder: Recorder,
    run: impl FnOnce(&mut dyn Observer) -> Result<Summary, ancf::Error>,
) -> Result<Ended> {
    let clock = Instant::now();
    let progress = match model.analysis.dynamics() {
        Some(settings) if !speech::is_quiet() => Progress::until(settings.duration),
        _ => Progress::hidden(),
    };
    let conclusion = Conclusion::of(&model.analysis);
    let mut followers = Followers { recorder, conclusion, progress, is_begun: false };
    let summary = run(&mut followers);
    let Followers { mut recorder, conclusion, is_begun, .. } = followers;
    let folder = recorder.folder().path().display().to_string();
    if let Err(ancf::Error::Checkpoint(mismatch)) = &summary {
        let path = recorder.folder().checkpoint();
        return Ok(reject(&format!("{}: {mismatch}; if it is removed, the run begins anew", path.display())));
    }
    let summary = summary.map_err(|error| unwritten(error, is_begun.then_some(&folder)))?;
    let seconds = clock.elapsed().as_secs_f64();
    recorder.conclude(&summary, seconds)?;
    let redundant = summary.redundant.iter().map(|one| format!("redundant: {one}"));
    // What goes on but may be wrong is told to the quiet too.
    redundant.chain(summary.warnings.iter().cloned()).for_each(|one| complain(&format!("warning: {one}")));
    print(&conclusion.table());
    let (sentence, columns) = (conclusion.sentence(&summary, seconds, &folder), conclusion.columns());
    let model = recorder.name();
    answer(&Answer { folder, model, wall_seconds: seconds, summary: &summary, columns });
    Ok(match summary.outcome {
        Outcome::Finished => {
            say(&sentence);
            Ended::Done
        }
        Outcome::Stopped => {
            say(&sentence);
            Ended::Stopped
        }
        Outcome::Failed { .. } => {
            complain(&sentence);
            Ended::Failed
        }
    })
}

/// Why there are no results, or not all: those so far are in the folder, if there are any.
fn unwritten(error: ancf::Error, folder: Option<&String>) -> anyhow::Error {
    let error = anyhow::Error::from(error);
    match folder {
        Some(folder) => error.context(format!("the run broke off, with its results so far in {folder}")),
        None => error,
    }
}

/// The answer to those who want JSON: `summary.json`, with what was printed.
#[derive(Serialize)]
struct Answer<'a> {
    folder: String,
    model: &'a str,
    wall_seconds: f64,
    #[serde(flatten)]
    summary: &'a Summary,
    /// Of modes and critical loads.
    #[serde(flatten)]
    columns: BTreeMap<&'static str, Vec<f64>>,
}

/// All who follow a run.
struct Followers<'a> {
    recorder: Recorder,
    conclusion: Conclusion<'a>,
    progress: Progress,
    /// Whether there are files.
    is_begun: bool,
}

impl Observer for Followers<'_> {
    fn begin(&mut self, columns: &[String]) -> io::Result<()> {
        Sink::begin(&mut self.conclusion, columns)?;
        Sink::begin(&mut self.progress, columns)?;
        self.recorder.begin(columns)?;
        self.is_begun = true;
        Ok(())
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
