//! `ancf view`: the results of a run in a browser, live.

use std::fs;
use std::io;
use std::path::PathBuf;
use std::sync::Arc;
use std::thread;
use std::time::{Duration, SystemTime};

use ancf_report::{BUDGET, SceneSource, Server};
use ancf_results::{Folder, Results};
use ancf_study::StudyRecord;
use anyhow::{Context, Result};
use clap::Args;

use super::run_folder::open_run;
use super::scene::scene_of;
#[cfg(feature = "figures")]
use super::study::LiveStudy;
use crate::terminal::{Ended, check_output, interrupt, print, print_status};

/// Arguments of `ancf view`.
#[derive(Debug, Args)]
pub struct ViewArguments {
    /// Results folder, also during the run, or folder of a study.
    folder: PathBuf,
    /// Port of this machine; a free port by default.
    #[arg(long, default_value_t = 0)]
    port: u16,
}

/// Examples of the help.
pub const VIEW_EXAMPLES: &str = "\
Examples:
  ancf view out                   while `ancf run ... -o out` runs in another terminal
  ancf view out --port 8000

The server accepts connections of this machine only, serves this folder only, and ends with Ctrl-C.";

impl ViewArguments {
    /// Serves the report until Ctrl-C.
    pub fn run(&self) -> Result<Ended> {
        let source: Arc<dyn SceneSource> = match StudyRecord::read(&self.folder)? {
            #[cfg(feature = "figures")]
            Some(_) => Arc::new(LiveStudy::of(self.folder.clone())),
            #[cfg(not(feature = "figures"))]
            Some(_) => return Ok(crate::terminal::reject_figures()),
            None => match open_run(&self.folder)? {
                Ok(_) => Arc::new(LiveFolder(self.folder.clone())),
                Err(ended) => return Ok(ended),
            },
        };
        let interrupt = interrupt()?;
        let server = Server::bind(self.port, &self.folder)
            .with_context(|| format!("cannot listen on port {} of this machine", self.port))?;
        print(&format!("{}\n", server.url()));
        // Without its address the server is useless. `main` reports the error.
        if check_output().is_err() {
            return Ok(Ended::Failed);
        }
        print_status("open this address in a browser; Ctrl-C stops the server");
        let stop = server.stop_flag();
        thread::scope(|scope| {
            scope.spawn(|| {
                while !interrupt.is_set() && !stop.is_set() {
                    thread::sleep(PAUSE);
                }
                stop.stop();
            });
            let served = server.serve(source);
            stop.stop();
            served
        })?;
        Ok(Ended::Done)
    }
}

/// Polling interval of the interrupt flag.
const PAUSE: Duration = Duration::from_millis(50);

/// Results in a folder that may be growing.
struct LiveFolder(PathBuf);

impl SceneSource for LiveFolder {
    /// Returns a hash of sizes and modification times of the files.
    fn version(&self) -> u64 {
        // A killed run changes no file.
        let mut version = u64::from(Folder::new(&self.0).is_busy());
        for folder in ["", "states.parquet.parts", "results.parquet.parts"] {
            for entry in fs::read_dir(self.0.join(folder)).into_iter().flatten().flatten() {
                let Ok(about) = entry.metadata() else { continue };
                let time =
                    about.modified().ok().and_then(|time| time.duration_since(SystemTime::UNIX_EPOCH).ok());
                let nanoseconds = time.map_or(0, |time| time.as_nanos() as u64);
                // Independent of the order of the files.
                version =
                    version.wrapping_add((about.len() ^ nanoseconds).wrapping_mul(0x9e37_79b9_7f4a_7c15));
            }
        }
        version
    }

    fn scene(&self) -> io::Result<Vec<u8>> {
        let results = Results::open(&self.0).map_err(io::Error::other)?;
        scene_of(&results, true, BUDGET).map_err(|error| io::Error::other(format!("{error:#}")))
    }
}
