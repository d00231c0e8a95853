//! `ancf report`: the results of a run as one HTML file.

use std::io::Write;
use std::path::{Path, PathBuf};

use ancf_report::{BUDGET, page};
use ancf_results::write_atomically;
use ancf_study::StudyRecord;
use anyhow::{Context, Result};
use clap::Args;

use super::run_folder::open_run;
use super::scene::scene_of;
use crate::terminal::{Ended, print};

/// Arguments of `ancf report`.
#[derive(Debug, Args)]
pub struct ReportArguments {
    /// Results folder, or folder of a study.
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

/// Name of the report in a results folder.
pub const REPORT: &str = "report.html";

/// Page of a study.
#[cfg(feature = "figures")]
#[expect(clippy::unnecessary_wraps, reason = "a program without figures has no page")]
fn page_of_study(folder: &Path, study: &StudyRecord) -> Result<String, Ended> {
    Ok(super::study::study_page(folder, study))
}

/// Rejects the command: this program has no figures.
#[cfg(not(feature = "figures"))]
fn page_of_study(_: &Path, _: &StudyRecord) -> Result<String, Ended> {
    Err(crate::terminal::reject_figures())
}

/// Writes the report of the run or the study in a folder with about `budget` bytes of states. Returns an end if the folder has no run.
///
/// # Errors
/// If results cannot be read or the report cannot be written.
pub fn write_report(folder: &Path, path: &Path, budget: usize) -> Result<Option<Ended>> {
    let html = match StudyRecord::read(folder)? {
        Some(study) => match page_of_study(folder, &study) {
            Ok(html) => html,
            Err(ended) => return Ok(Some(ended)),
        },
        None => match open_run(folder)? {
            Ok(results) => page(&scene_of(&results, false, budget)?),
            Err(ended) => return Ok(Some(ended)),
        },
    };
    write_atomically(path, |mut file| file.write_all(html.as_bytes()))
        .with_context(|| format!("cannot write {}", path.display()))?;
    Ok(None)
}
