//! `ancf report` and `ancf view`: a run to look at.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::thread;
use std::time::{Duration, SystemTime};

use ancf_report::{
    BUDGET, Ending, Recording, SceneSource, Server, Snapshot, page, scene, summary_rows, summary_warnings,
};
use ancf_results::{Conclusion, Folder, KILLED, Results, Status, whole};
use anyhow::{Context, Result};
use clap::Args;

use crate::command::Ended;
use crate::past;
use crate::signal::interrupt;
use crate::speech::{print, say};

/// What `ancf report` is given.
#[derive(Debug, Args)]
pub struct Report {
    /// The folder of a run.
    folder: PathBuf,
    /// The file; report.html in the folder if left out.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Megabytes of states to draw at most; beyond, stations and frames are thinned.
    #[arg(long, value_name = "MB", default_value_t = BUDGET >> 20, value_parser = clap::value_parser!(usize))]
    budget: usize,
}

/// What `ancf view` is given.
#[derive(Debug, Args)]
pub struct View {
    /// The folder of a run, which may be going on.
    folder: PathBuf,
    /// The port of this machine; any that is free if left out.
    #[arg(long, default_value_t = 0)]
    port: u16,
}

/// Examples for the help.
pub const REPORT_EXAMPLES: &str = "\
Examples:
  ancf run models/bow.toml -o out && ancf report out      writes out/report.html
  ancf report out -o bow.html --budget 100                finer, in a larger file

The file needs no network and opens in any browser. It can be made of a run that goes on or was killed too.";

/// Examples for the help.
pub const VIEW_EXAMPLES: &str = "\
Examples:
  ancf view out                   while `ancf run ... -o out` goes on in another terminal
  ancf view out --port 8000

It listens on this machine only, serves that folder only, and ends with Ctrl-C.";

impl Report {
    /// Writes the report.
    pub fn run(&self) -> Result<Ended> {
        let results = match past::open(&self.folder)? {
            Ok(results) => results,
            Err(ended) => return Ok(ended),
        };
        let path = self.output.clone().unwrap_or_else(|| self.folder.join("report.html"));
        let html = page(&scene_of(&results, false, self.budget.saturating_mul(1 << 20))?);
        whole(&path, |mut file| file.write_all(html.as_bytes()))
            .with_context(|| format!("cannot write {}", path.display()))?;
        print(&format!("{}\n", path.display()));
        Ok(Ended::Done)
    }
}

impl View {
    /// Serves the report until Ctrl-C.
    pub fn run(&self) -> Result<Ended> {
        if let Err(ended) = past::open(&self.folder)? {
            return Ok(ended);
        }
        let interrupt = interrupt()?;
        let server = Server::bind(self.port, &self.folder)
            .with_context(|| format!("cannot listen on port {} of this machine", self.port))?;
        print(&format!("{}\n", server.url()));
        say("open this address in a browser; Ctrl-C ends it");
        let stop = server.stop_flag();
        thread::scope(|scope| {
            scope.spawn(|| {
                while !interrupt.is_set() && !stop.is_set() {
                    thread::sleep(PAUSE);
                }
                stop.stop();
            });
            let served = server.serve(&Followed(&self.folder));
            stop.stop();
            served
        })?;
        Ok(Ended::Done)
    }
}

/// How often Ctrl-C is looked for.
const PAUSE: Duration = Duration::from_millis(50);

/// The scene of the results so far.
fn scene_of(results: &Results, live: bool, budget: usize) -> Result<Vec<u8>> {
    let status = results.status();
    let conclusion = results.conclusion()?;
    let summary = conclusion.as_ref().map(|conclusion| &conclusion.summary);
    let mut messages = summary.map(summary_warnings).unwrap_or_default();
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
        frames.push(Snapshot { value, state });
    }
    let series = results.columns()?;
    let output = results.model().output;
    if output.parquet && series.columns().all(|(_, values)| values.is_empty()) {
        messages.push("There are no rows of it on the disk.".to_owned());
    }
    if output.states > 0 && frames.is_empty() {
        messages.push("There are no states of it on the disk.".to_owned());
    }
    let title = past::title(results);
    let recording = Recording {
        frames,
        summary: conclusion.as_ref().map(rows).unwrap_or_default(),
        ending,
        messages,
        live: live && status == Status::Running,
        ..past::recording(results, &title, &series)
    };
    Ok(scene(&recording, budget))
}

/// Names and values of what a run did, and where.
fn rows(conclusion: &Conclusion) -> Vec<(String, String)> {
    let Conclusion { program, model, wall_seconds, summary } = conclusion;
    let own =
        [("model", model.clone()), ("program", program.clone()), ("seconds", format!("{wall_seconds:.3}"))];
    own.into_iter().map(|(name, value)| (name.to_owned(), value)).chain(summary_rows(summary)).collect()
}

/// The results in a folder that may be growing.
struct Followed<'a>(&'a Path);

impl SceneSource for Followed<'_> {
    /// Of what stands in the folder when: names, sizes and times.
    fn version(&self) -> u64 {
        // A run that is killed changes no file.
        let mut version = u64::from(Folder::new(self.0).is_busy());
        for folder in ["", "states.parquet.parts", "results.parquet.parts"] {
            for entry in fs::read_dir(self.0.join(folder)).into_iter().flatten().flatten() {
                let Ok(about) = entry.metadata() else { continue };
                let time =
                    about.modified().ok().and_then(|time| time.duration_since(SystemTime::UNIX_EPOCH).ok());
                let nanoseconds = time.map_or(0, |time| time.as_nanos() as u64);
                // Files come in any order.
                version =
                    version.wrapping_add((about.len() ^ nanoseconds).wrapping_mul(0x9e37_79b9_7f4a_7c15));
            }
        }
        version
    }

    fn scene(&self) -> io::Result<Vec<u8>> {
        let results = Results::open(self.0).map_err(io::Error::other)?;
        scene_of(&results, true, BUDGET).map_err(|error| io::Error::other(format!("{error:#}")))
    }
}
