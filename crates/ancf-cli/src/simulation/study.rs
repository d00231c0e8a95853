//! Parameter studies: a model in many cases, on all cores, into a table.

mod design;
mod distribution;
mod objective;
mod places;
mod results;
mod row;
mod sample;
mod statement;
mod summary;
mod table;
mod workers;

use std::fs;
use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::time::Instant;

use ancf::{Model, ModelError};
use anyhow::{Context, Result};
use clap::Args;
use toml::Value;

use crate::command::{Ended, refuse};
use crate::progress;
use crate::signal::interrupt;
use crate::speech::{self, answer, complain, print, say};
use design::Design;
use results::Results;
use row::Row;
use statement::Study;
use table::Table;

/// What `ancf study` is asked.
#[derive(Debug, Args)]
pub struct Arguments {
    /// The study file (TOML).
    file: PathBuf,
    /// The folder for cases.parquet.
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// How many cases run at a time; as many as there are cores by default.
    #[arg(short, long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    jobs: Option<u32>,
    /// Run cases again that failed or were invalid.
    #[arg(long)]
    retry: bool,
    /// Run part K of N only, K from 1, and write cases-K-of-N.parquet.
    #[arg(long, value_name = "K/N")]
    index: Option<Part>,
    /// Print one JSON object on standard output and nothing else.
    #[arg(long)]
    pub json: bool,
}

pub const EXAMPLES: &str = "\
Examples:
  ancf study models/studies/convergence.toml -o out     on all cores
  ancf study models/studies/young.toml -o out -j 1      one case at a time

Cases that are in DIR/cases*.parquet already are not run again. A job array shares a study out;
the last line puts it together:
  #SBATCH --array=1-10
  ancf study study.toml -o out --index $SLURM_ARRAY_TASK_ID/10
  ancf study study.toml -o out

Exit code 0 if all cases finished, 1 if some failed or were invalid (they are rows with a message),
2 bad input, 130 or 143 stopped by Ctrl-C or SIGTERM, with all cases kept that had finished.";

/// Part k of n, k from 1: every n-th case.
#[derive(Clone, Copy, Debug)]
struct Part {
    k: usize,
    n: usize,
}

impl FromStr for Part {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parts =
            text.split_once('/').and_then(|(k, n)| Some((k.trim().parse().ok()?, n.trim().parse().ok()?)));
        match parts {
            Some((k, n)) if 1 <= k && k <= n => Ok(Self { k, n }),
            _ => Err("wanted K/N with K from 1 to N, such as 3/10".into()),
        }
    }
}

impl Part {
    const WHOLE: Self = Self { k: 1, n: 1 };

    /// The file of its results, another one for every division.
    fn file(self) -> String {
        format!("cases-{}-of-{}.parquet", self.k, self.n)
    }

    /// The cases of this part.
    fn of(self, cases: usize) -> Vec<usize> {
        (self.k - 1..cases).step_by(self.n).collect()
    }
}

impl Arguments {
    /// Runs the study.
    pub fn run(&self) -> Result<Ended> {
        let text = match fs::read_to_string(&self.file) {
            Ok(text) => text,
            Err(error) => {
                let error = ModelError::new("", statement::why(&error), "a study file");
                return Ok(refuse(&[error], &self.file));
            }
        };
        let folder = self.file.parent().unwrap_or(Path::new(""));
        let study = match Study::parse(&text, folder) {
            Ok(study) => study,
            Err(errors) => return Ok(refuse(&errors, &self.file)),
        };
        let model = folder.join(&study.model);
        if let Err(errors) = Model::read(&model) {
            return Ok(refuse(&errors, &model));
        }
        let base = fs::read_to_string(&model)?.parse::<toml::Table>().map(Value::Table)?;
        self.run_cases(&study, &text, &base)
    }

    fn run_cases(&self, study: &Study, text: &str, base: &Value) -> Result<Ended> {
        let clock = Instant::now();
        let design = Design::of(study).context("there are more cases than can be counted")?;
        let cases = self.index.unwrap_or(Part::WHOLE).of(design.cases());
        let objectives = &study.objectives;
        fs::create_dir_all(&self.output)
            .with_context(|| format!("cannot create {}", self.output.display()))?;
        let file = self.index.map_or_else(|| "cases.parquet".into(), Part::file);
        let table = Table { axes: design.axes(), objectives, text };
        let keys = cases.iter().map(|&case| (case, design.key(base, objectives, case)));
        let mut results = Results::new(table, self.output.join(file), keys.collect());
        results.take_over(table::rows_in(&self.output, objectives)?, self.retry);
        let bar = if speech::is_quiet() { progress::no_bar() } else { progress::cases(cases.len() as u64) };
        let todo = results.missing();
        // Not before: what comes until here asks nobody whether it is to end.
        let interrupt = interrupt()?;
        let work = |case| Row::of(case, &design, base, objectives, &interrupt);
        workers::run(&todo, self.jobs(), &interrupt, work, |row| {
            if let Some((case, row)) = row {
                results.add(case, row);
                bar.set_position(results.done() as u64);
                bar.set_message(summary::trouble(&results));
            }
            results.write_when_due()
        })?;
        results.write()?;
        bar.finish_and_clear();
        print(&summary::ranges(&results));
        summary::failures(&results).iter().for_each(|line| complain(line));
        let seconds = clock.elapsed().as_secs_f64();
        say(&summary::sentence(&results, seconds));
        answer(&summary::answer(&results, seconds));
        Ok(results.ended())
    }

    fn jobs(&self) -> usize {
        self.jobs.map_or_else(rayon::current_num_threads, |jobs| jobs as usize)
    }
}
