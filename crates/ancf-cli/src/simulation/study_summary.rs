//! Summary of a study, for the terminal and as JSON.

use std::collections::BTreeMap;

use ancf::errors::short;
use ancf_study::{CaseOutcome, CaseRow, ObjectiveRange, StudyOutcome, StudyResults};
use serde::Serialize;

use crate::terminal::count;

/// Maximum number of printed messages. All messages are in the table.
const MAX_MESSAGES: usize = 3;

/// Returns smallest value, mean, largest value and standard deviation of each objective as aligned lines.
pub fn ranges(results: &StudyResults) -> String {
    let mut lines = vec![["objective", "least", "mean", "largest", "deviation"].map(str::to_owned)];
    for (k, name) in results.objectives().keys().enumerate() {
        let ObjectiveRange { least, mean, largest, deviation } = results.range(k);
        let [least, mean, largest, deviation] =
            [least, mean, largest, deviation].map(|x| x.map_or_else(|| "-".to_owned(), short));
        lines.push([name.clone(), least, mean, largest, deviation]);
    }
    if lines.len() == 1 {
        return String::new();
    }
    let width = lines.iter().map(|[name, ..]| name.chars().count()).max().unwrap_or(0);
    let line = |[name, least, mean, most, deviation]: &[String; 5]| {
        format!("{name:width$}  {least:>13}  {mean:>13}  {most:>13}  {deviation:>13}\n")
    };
    lines.iter().map(line).collect()
}

/// JSON output of a study.
#[derive(Serialize)]
pub struct StudyJson<'a> {
    results: String,
    outcome: &'static str,
    cases: usize,
    taken_over: usize,
    finished: usize,
    failed: usize,
    invalid: usize,
    stopped: usize,
    /// Finished cases with warnings or missing objectives.
    warned: usize,
    wall_seconds: f64,
    objectives: BTreeMap<&'a str, ObjectiveRange>,
    failures: Vec<CaseMessage<'a>>,
    warnings: Vec<CaseMessage<'a>>,
}

/// Message of a case that failed or was invalid, or that finished with warnings.
#[derive(Serialize)]
struct CaseMessage<'a> {
    case: usize,
    status: &'static str,
    message: &'a str,
}

/// Returns the JSON output of a study.
pub fn json<'a>(results: &'a StudyResults, seconds: f64) -> StudyJson<'a> {
    let count = |outcome| results.count(outcome);
    let objectives = results.objectives().keys().enumerate();
    let message = |(case, row): (usize, &'a CaseRow)| CaseMessage {
        case,
        status: row.outcome.word(),
        message: row.message.as_deref().unwrap_or_default(),
    };
    StudyJson {
        results: results.path().display().to_string(),
        outcome: if results.outcome() == StudyOutcome::Stopped { "stopped" } else { "finished" },
        cases: results.requested(),
        taken_over: results.taken_over(),
        finished: count(CaseOutcome::Finished),
        failed: count(CaseOutcome::Failed),
        invalid: count(CaseOutcome::Invalid),
        stopped: count(CaseOutcome::Stopped),
        warned: cases_with(results, is_warned).count(),
        wall_seconds: seconds,
        objectives: objectives.map(|(k, name)| (name.as_str(), results.range(k))).collect(),
        failures: cases_with(results, is_failure).map(message).collect(),
        warnings: cases_with(results, is_warned).map(message).collect(),
    }
}

const fn is_failure(row: &CaseRow) -> bool {
    matches!(row.outcome, CaseOutcome::Failed | CaseOutcome::Invalid)
}

/// True for finished cases with warnings or missing objectives.
fn is_warned(row: &CaseRow) -> bool {
    row.outcome == CaseOutcome::Finished && row.message.is_some()
}

/// Cases whose rows have a property.
fn cases_with(
    results: &StudyResults,
    has: impl Fn(&CaseRow) -> bool,
) -> impl Iterator<Item = (usize, &CaseRow)> {
    results.rows().filter(move |(_, row)| has(row))
}

/// Returns the first messages of cases that failed or were invalid, then those of finished cases with warnings.
pub fn messages(results: &StudyResults) -> Vec<String> {
    let failed = first_messages(results, is_failure);
    failed.into_iter().chain(first_messages(results, is_warned)).collect()
}

fn first_messages(results: &StudyResults, is_shown: impl Fn(&CaseRow) -> bool) -> Vec<String> {
    let shown: Vec<_> = cases_with(results, is_shown).collect();
    let line = |(case, row): &(usize, &CaseRow)| {
        let message = row.message.as_deref().unwrap_or_default();
        let message = message.replace('\n', "\n  ");
        let kind = if row.outcome == CaseOutcome::Invalid { "invalid: " } else { "" };
        format!("case {case}: {kind}{message}")
    };
    let mut lines: Vec<_> = shown.iter().take(MAX_MESSAGES).map(line).collect();
    if shown.len() > MAX_MESSAGES {
        lines.push(format!("{} more messages are in the column `message`", shown.len() - MAX_MESSAGES));
    }
    lines
}

/// Returns the numbers of cases that failed or were invalid, if any.
pub fn failure_counts(results: &StudyResults) -> String {
    let words = [CaseOutcome::Failed, CaseOutcome::Invalid].map(|outcome| match results.count(outcome) {
        0 => String::new(),
        count => format!("{count} {}", outcome.word()),
    });
    words.into_iter().filter(|word| !word.is_empty()).collect::<Vec<_>>().join(", ")
}

/// Returns outcome and extent of the study.
pub fn sentence(results: &StudyResults, seconds: f64) -> String {
    let stopped = results.count(CaseOutcome::Stopped);
    let done = (results.done() - stopped) as u64;
    let (word, cases) = match results.outcome() {
        StudyOutcome::Stopped => {
            ("stopped", format!("{done} of {}", count(results.requested() as u64, "case")))
        }
        _ => ("done", count(done, "case")),
    };
    let taken_over = match results.taken_over() {
        0 => String::new(),
        count => format!(" ({count} taken over)"),
    };
    let failures = match failure_counts(results) {
        none if none.is_empty() => none,
        counts => format!(", {counts}"),
    };
    let warned = match cases_with(results, is_warned).count() {
        0 => String::new(),
        count => format!(", {count} with warnings"),
    };
    format!(
        "{word}: {cases}{taken_over}{failures}{warned}, {seconds:.3} s; results in {}",
        results.path().display()
    )
}
