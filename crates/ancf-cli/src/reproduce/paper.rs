//! `ancf paper`: tables and figures of Kim et al. (2017).

use std::path::PathBuf;

use anyhow::Result;
use clap::Args;

use crate::terminal::Ended;

/// Arguments of `ancf paper`.
#[derive(Debug, Args)]
pub struct PaperArguments {
    /// Folder for index.html, figures, tables and results.json.
    #[arg(short, long, value_name = "DIR", default_value = "out/paper")]
    output: PathBuf,
    /// Timed repetitions of each run; times are their medians.
    #[arg(long, value_name = "N", default_value_t = 3)]
    repeats: usize,
}

/// Examples of the help.
pub const PAPER_EXAMPLES: &str = "\
Examples:
  ancf paper                          some minutes; report in out/paper/index.html
  ancf paper --repeats 1 -o look      less accurate times";

#[cfg(feature = "figures")]
impl PaperArguments {
    /// Runs all problems of the paper and writes the report.
    pub fn run(&self) -> Result<Ended> {
        use std::time::Instant;

        use ancf_paper::{PaperRuns, ReportFolder, write_paper};

        use crate::terminal::{print_status, spinner};

        let folder = ReportFolder::create(&self.output)?;
        let clock = Instant::now();
        print_status("running the problems of the paper: about half a minute");
        let progress = spinner();
        let runs = PaperRuns::run(self.repeats, |next| progress.set_message(next.to_owned()));
        progress.finish_and_clear();
        let results = write_paper(&folder, &runs?, clock.elapsed().as_secs_f64())?;
        let verdict = &results.verdict;
        print_status(&format!("{} of {} printed numbers reproduced", verdict.within(), verdict.numbers()));
        print_status(&format!("report in {}", self.output.join("index.html").display()));
        Ok(Ended::Done)
    }
}

#[cfg(not(feature = "figures"))]
impl PaperArguments {
    /// Rejects the command: this program has no figures.
    pub fn run(&self) -> Result<Ended> {
        Ok(crate::terminal::reject_figures())
    }
}
