//! `ancf report`: the results of a run as one HTML file.

use std::io::Write;
use std::path::{Path, PathBuf};

use ancf_report::{BUDGET, page};
use ancf_results::write_atomically;
use anyhow::{Context, Result};
use clap::Args;

use super::run_folder::open_run;
use super::scene::scene_of;
use crate::terminal::{Ended, print};

/// Arguments of `ancf report`.
#[derive(Debug, Args)]
pub struct ReportArguments {
    /// Folder of a run.
    folder: PathBuf,
    /// HTML file; report.html in the folder by default.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Maximum size of the drawn states in megabytes; larger results are decimated.
    #[arg(long, value_name = "MB", default_value_t = BUDGET >> 20, value_parser = clap::value_parser!(usize))]
    budget: usize,
}

/// Examples of the help.
pub const REPORT_EXAMPLES: &str = "\
Examples:
  ancf run models/bow.toml -o out && ancf report out      writes out/report.html
  ancf report out -o bow.html --budget 100                less decimation, larger file

The file needs no network and opens in any browser. The run may still be running, or may have been
killed.";

impl ReportArguments {
    /// Writes the report.
    pub fn run(&self) -> Result<Ended> {
        let path = self.output.clone().unwrap_or_else(|| self.folder.join(REPORT));
        let written = write_report(&self.folder, &path, self.budget.saturating_mul(1 << 20))?;
        if written.is_none() {
            print(&format!("{}\n", path.display()));
        }
        Ok(written.unwrap_or(Ended::Done))
    }
}

/// Name of the report in the folder of a run.
pub const REPORT: &str = "report.html";

/// Writes the report of the run in a folder with about `budget` bytes of states. Returns an end if the folder has no run.
///
/// # Errors
/// If results cannot be read or the report cannot be written.
pub fn write_report(folder: &Path, path: &Path, budget: usize) -> Result<Option<Ended>> {
    let results = match open_run(folder)? {
        Ok(results) => results,
        Err(ended) => return Ok(Some(ended)),
    };
    let html = page(&scene_of(&results, false, budget)?);
    write_atomically(path, |mut file| file.write_all(html.as_bytes()))
        .with_context(|| format!("cannot write {}", path.display()))?;
    Ok(None)
}
