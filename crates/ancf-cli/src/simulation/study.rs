//! `ancf study`: runs a parameter study.

use std::path::PathBuf;
use std::time::Instant;

use ancf_study::{StudyError, StudyOutcome, StudyPart, StudyRun, StudySettings, StudySource};
use anyhow::Result;
use clap::Args;

use super::study_summary;
use crate::terminal::{
    Ended, case_bar, interrupt, print, print_error, print_json, print_status, report_model_errors,
};

/// Arguments of `ancf study`.
#[derive(Debug, Args)]
pub struct StudyArguments {
    /// Study file (TOML).
    file: PathBuf,
    /// Folder for cases.parquet.
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// Number of cases that run simultaneously; the number of cores by default.
    #[arg(short, long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    jobs: Option<u32>,
    /// Run cases again that failed or were invalid.
    #[arg(long)]
    retry: bool,
    /// Run part K of N only, K from 1, and write cases-K-of-N.parquet.
    #[arg(long, value_name = "K/N")]
    index: Option<StudyPart>,
    /// Print one JSON object on standard output and nothing else.
    #[arg(long)]
    pub json: bool,
}

/// Examples of the help.
pub const STUDY_EXAMPLES: &str = "\
Examples:
  ancf study models/studies/convergence.toml -o out     on all cores
  ancf study models/studies/young.toml -o out -j 1      one case at a time

Cases in DIR/cases*.parquet are not run again. A job array runs parts of a study; the last line
merges them:
  #SBATCH --array=1-10
  ancf study study.toml -o out --index $SLURM_ARRAY_TASK_ID/10
  ancf study study.toml -o out

Exit code 0 if all cases finished, 1 if some failed or were invalid (rows with a message),
2 bad input, 130 or 143 stopped by Ctrl-C or SIGTERM; finished cases are kept.";

impl StudyArguments {
    /// Runs the study.
    pub fn run(&self) -> Result<Ended> {
        match StudySource::read(&self.file) {
            Ok(source) => self.run_cases(source),
            Err(StudyError::Invalid { path, errors }) => Ok(report_model_errors(&errors, &path)),
            Err(error) => Err(error.into()),
        }
    }

    fn run_cases(&self, source: StudySource) -> Result<Ended> {
        let clock = Instant::now();
        let settings = StudySettings { folder: self.output.clone(), part: self.index, retry: self.retry };
        let mut study = StudyRun::prepare(source, &settings)?;
        let bar = case_bar(study.results().requested() as u64);
        // Not before: the preparation does not check the interrupt flag.
        let interrupt = interrupt()?;
        study.execute(self.jobs(), &interrupt, |results| {
            bar.set_position(results.done() as u64);
            bar.set_message(study_summary::failure_counts(results));
        })?;
        bar.finish_and_clear();
        let results = study.results();
        print(&study_summary::ranges(results));
        study_summary::messages(results).iter().for_each(|line| print_error(line));
        let seconds = clock.elapsed().as_secs_f64();
        print_status(&study_summary::sentence(results, seconds));
        print_json(&study_summary::json(results, seconds));
        Ok(match results.outcome() {
            StudyOutcome::Finished => Ended::Done,
            StudyOutcome::Failed => Ended::Failed,
            StudyOutcome::Stopped => Ended::Stopped,
        })
    }

    fn jobs(&self) -> usize {
        self.jobs.map_or_else(rayon::current_num_threads, |jobs| jobs as usize)
    }
}
