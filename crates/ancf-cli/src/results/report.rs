//! `ancf report`: the results of a run as one HTML file.

use std::io::Write;
use std::path::PathBuf;

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
        let results = match open_run(&self.folder)? {
            Ok(results) => results,
            Err(ended) => return Ok(ended),
        };
        let path = self.output.clone().unwrap_or_else(|| self.folder.join("report.html"));
        let html = page(&scene_of(&results, false, self.budget.saturating_mul(1 << 20))?);
        write_atomically(&path, |mut file| file.write_all(html.as_bytes()))
            .with_context(|| format!("cannot write {}", path.display()))?;
        print(&format!("{}\n", path.display()));
        Ok(Ended::Done)
    }
}
