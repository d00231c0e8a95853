//! What a study came to, for the terminal.

use std::collections::BTreeMap;

use serde::Serialize;

use super::results::Results;
use super::row::Ending;
use crate::command::Ended;
use crate::conclusion::{count, short};

/// Messages that are shown; the others are in the table.
const SHOWN: usize = 3;

/// Least value, mean and largest value of each objective over the cases that have it, as aligned lines.
pub fn ranges(results: &Results<'_>) -> String {
    let mut lines = vec![["objective", "least", "mean", "largest"].map(str::to_owned)];
    for (k, name) in results.objectives().keys().enumerate() {
        let Range { least, mean, largest } = range(results, k);
        let shown = |x: Option<f64>| x.map_or_else(|| "-".to_owned(), short);
        lines.push([name.clone(), shown(least), shown(mean), shown(largest)]);
    }
    if lines.len() == 1 {
        return String::new();
    }
    let width = lines.iter().map(|[name, ..]| name.chars().count()).max().unwrap_or(0);
    let line = |[name, least, mean, most]: &[String; 4]| {
        format!("{name:width$}  {least:>13}  {mean:>13}  {most:>13}\n")
    };
    lines.iter().map(line).collect()
}

/// The answer to those who want JSON.
#[derive(Serialize)]
pub struct Answer<'a> {
    results: String,
    outcome: &'static str,
    cases: usize,
    taken_over: usize,
    finished: usize,
    failed: usize,
    invalid: usize,
    stopped: usize,
    wall_seconds: f64,
    objectives: BTreeMap<&'a str, Range>,
    failures: Vec<Failure<'a>>,
}

/// Of the cases that have the objective; null if none has.
#[derive(Serialize)]
struct Range {
    least: Option<f64>,
    mean: Option<f64>,
    largest: Option<f64>,
}

/// A case that failed or was invalid.
#[derive(Serialize)]
struct Failure<'a> {
    case: usize,
    status: &'static str,
    message: &'a str,
}

/// What a study came to.
pub fn answer<'a>(results: &'a Results<'_>, seconds: f64) -> Answer<'a> {
    let count = |ending| results.count(ending);
    let objectives = results.objectives().keys().enumerate();
    let failure = |(case, row): (usize, &'a super::row::Row)| Failure {
        case,
        status: row.ending.word(),
        message: row.message.as_deref().unwrap_or_default(),
    };
    Answer {
        results: results.path().display().to_string(),
        outcome: if results.ended() == Ended::Stopped { "stopped" } else { "finished" },
        cases: results.wanted(),
        taken_over: results.taken_over(),
        finished: count(Ending::Finished),
        failed: count(Ending::Failed),
        invalid: count(Ending::Invalid),
        stopped: count(Ending::Stopped),
        wall_seconds: seconds,
        objectives: objectives.map(|(k, name)| (name.as_str(), range(results, k))).collect(),
        failures: results.rows().filter(|(_, row)| is_failure(row.ending)).map(failure).collect(),
    }
}

fn range(results: &Results<'_>, objective: usize) -> Range {
    let values: Vec<f64> = results.rows().filter_map(|(_, row)| row.objectives[objective]).collect();
    let bound = |better: fn(f64, f64) -> f64| values.iter().copied().reduce(better);
    let mean = (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64);
    Range { least: bound(f64::min), mean, largest: bound(f64::max) }
}

const fn is_failure(ending: Ending) -> bool {
    matches!(ending, Ending::Failed | Ending::Invalid)
}

/// The first messages of cases that failed or were invalid.
pub fn failures(results: &Results<'_>) -> Vec<String> {
    let failed: Vec<_> = results.rows().filter(|(_, row)| is_failure(row.ending)).collect();
    let line = |(case, row): &(usize, &super::row::Row)| {
        let message = row.message.as_deref().unwrap_or_default();
        let message = message.replace('\n', "\n  ");
        let kind = if row.ending == Ending::Invalid { "invalid: " } else { "" };
        format!("case {case}: {kind}{message}")
    };
    let mut lines: Vec<_> = failed.iter().take(SHOWN).map(line).collect();
    if failed.len() > SHOWN {
        lines.push(format!("and {} more: see the column `message`", failed.len() - SHOWN));
    }
    lines
}

/// How many cases failed or were invalid, if any.
pub fn trouble(results: &Results<'_>) -> String {
    let words = [Ending::Failed, Ending::Invalid].map(|ending| match results.count(ending) {
        0 => String::new(),
        count => format!("{count} {}", ending.word()),
    });
    words.into_iter().filter(|word| !word.is_empty()).collect::<Vec<_>>().join(", ")
}

/// How the study ended.
pub fn sentence(results: &Results<'_>, seconds: f64) -> String {
    let stopped = results.count(Ending::Stopped);
    let done = (results.done() - stopped) as u64;
    let (word, cases) = match results.ended() {
        Ended::Stopped => ("stopped", format!("{done} of {}", count(results.wanted() as u64, "case"))),
        _ => ("done", count(done, "case")),
    };
    let taken_over = match results.taken_over() {
        0 => String::new(),
        count => format!(" ({count} taken over)"),
    };
    let trouble = match trouble(results) {
        none if none.is_empty() => none,
        trouble => format!(", {trouble}"),
    };
    format!("{word}: {cases}{taken_over}{trouble}, {seconds:.3} s; results in {}", results.path().display())
}
