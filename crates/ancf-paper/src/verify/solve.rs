//! All problems with known answers, solved on the user's machine and reported beside their references.
//!
//! ```text
//! problems -> verdicts -> lines on the terminal
//!                |    \-> JSON
//!              page, plots -> HTML
//! ```

mod page;
mod plot;
mod record;
mod verdict;

use std::panic;
use std::path::Path;
use std::sync::Mutex;
use std::time::Instant;

use ancf_verification::{Findings, Problem, problems};
use anyhow::Result;
use clap::builder::{PossibleValue, PossibleValuesParser};
use serde::Serialize;

use crate::report::Output;
use crate::speech::{answer, print, say};
use record::Record;
use verdict::Verdict;

/// Problems that are solved at once.
const THREADS: usize = 2;

/// The names of all problems as arguments: others are refused, with the nearest one as a suggestion.
pub fn names() -> PossibleValuesParser {
    let value = |problem: &Problem| PossibleValue::new(problem.name).help(problem.title);
    PossibleValuesParser::new(problems::ALL.iter().map(value))
}

/// Solves the problems of these names, or all if there are none, and writes a report into a folder; whether all hold.
///
/// # Errors
/// If the folder cannot be written.
pub fn verify(names: &[String], out: &Path) -> Result<bool> {
    let chosen = |problem: &&Problem| names.is_empty() || names.iter().any(|name| name == problem.name);
    let problems: Vec<Problem> = problems::ALL.iter().filter(chosen).copied().collect();
    let output = Output::create(out)?;
    let clock = Instant::now();
    let verdicts = solve_all(&problems);
    let record = Record::new(&verdicts, clock.elapsed().as_secs_f64());
    output.write("results.json", serde_json::to_string_pretty(&record)? + "\n")?;
    output.write("index.html", page::page(&verdicts, &record))?;
    let holding = verdicts.iter().filter(|verdict| verdict.holds()).count();
    say(&format!("{holding} of {} problems hold", verdicts.len()));
    let report = out.join("index.html").display().to_string();
    say(&format!("report in {report}"));
    answer(&Answer { report, record: &record });
    Ok(holding == verdicts.len())
}

/// The answer to those who want JSON.
#[derive(Serialize)]
struct Answer<'a> {
    report: String,
    #[serde(flatten)]
    record: &'a Record,
}

/// Solves problems, a few at a time, with a line for each as soon as it is done; in their order.
fn solve_all(problems: &[Problem]) -> Vec<Verdict> {
    let width = problems.iter().map(|problem| problem.name.len()).max().unwrap_or(0);
    let queue = Mutex::new(problems.iter().enumerate());
    let next = || queue.lock().ok()?.next();
    let worker = || {
        let mut done = Vec::new();
        while let Some((place, problem)) = next() {
            let verdict = solve(*problem);
            print(&format!("{}\n", verdict.line(width)));
            done.push((place, verdict));
        }
        done
    };
    let mut done = std::thread::scope(|scope| {
        let workers: Vec<_> = (0..THREADS).map(|_| scope.spawn(worker)).collect();
        workers.into_iter().flat_map(|worker| worker.join().unwrap_or_default()).collect::<Vec<_>>()
    });
    done.sort_by_key(|(place, _)| *place);
    done.into_iter().map(|(_, verdict)| verdict).collect()
}

/// Solves a problem; whatever goes wrong in it is its verdict.
fn solve(problem: Problem) -> Verdict {
    let clock = Instant::now();
    let findings: Result<Findings, String> = match panic::catch_unwind(problem.run) {
        Ok(run) => run.map_err(|error| error.to_string()),
        Err(_) => Err("it broke off: a mistake in the program".to_owned()),
    };
    Verdict { problem, findings, seconds: clock.elapsed().as_secs_f64() }
}
