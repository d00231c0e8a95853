//! HTML page of a study.

use std::path::Path;

use ancf::errors::short;
use ancf_paper::{HtmlPage, PageSection, figure};
use ancf_study::{CaseOutcome, ObjectiveRange, RecordedColumn, StudyRecord, convergence, sensitivity};
use maud::{Markup, html};

use super::figures::{dependence, error_over_size, histogram};

/// Largest number of cases in the table of the page. The Parquet file has all.
const MAX_CASES: usize = 500;
/// Smallest number of cases of a histogram.
const MIN_HISTOGRAM: usize = 20;

/// Returns the page of the study in a folder as HTML.
pub fn study_page(folder: &Path, record: &StudyRecord) -> String {
    let finished = record.finished();
    let name = folder.file_name().unwrap_or(folder.as_os_str()).to_string_lossy();
    let mut sections = vec![PageSection::new("summary", "Summary", summary(record, &finished))];
    for objective in &finished.objectives {
        let body = html! {
            @for parameter in finished.varying() {
                (figure(&format!("{}-{}", objective.name, parameter.name), dependence(parameter, objective).svg(),
                    &html! { (objective.name) " against " (parameter.name) "." }))
            }
            (converging(&finished, objective))
            @if let Some(plot) = histogram(objective).filter(|_| finished.cases.len() >= MIN_HISTOGRAM) {
                (figure(&format!("{}-histogram", objective.name), plot.svg(),
                    &html! { "Distribution of " (objective.name) " over " (finished.cases.len()) " cases." }))
            }
            (sensitivities(&finished, objective))
        };
        sections.push(PageSection::new(objective.name.clone(), objective.name.clone(), body));
    }
    if record.cases.len() > finished.cases.len() {
        sections.push(PageSection::new(
            "failures",
            "Cases without result",
            messages(record, |k| record.outcomes[k] != CaseOutcome::Finished),
        ));
    }
    let is_warned = |k: usize| !finished.messages[k].is_empty();
    if (0..finished.cases.len()).any(is_warned) {
        sections.push(PageSection::new(
            "warnings",
            "Warnings of finished cases",
            messages(&finished, is_warned),
        ));
    }
    sections.push(PageSection::new("cases", "Cases", cases(record)));
    if !record.text.is_empty() {
        let text = html! { pre tabindex="0" { (record.text) } };
        sections.push(PageSection::new("study", "Study file", text));
    }
    let title = format!("Study {name}");
    HtmlPage { title: &title, subtitle: html! { "Written by " code { "ancf report" } "." }, sections }
        .into_text()
}

fn summary(record: &StudyRecord, finished: &StudyRecord) -> Markup {
    let (all, done) = (record.cases.len(), finished.cases.len());
    let count = |outcome: CaseOutcome| (outcome.word(), record.count(outcome));
    let others = [CaseOutcome::Failed, CaseOutcome::Invalid, CaseOutcome::Stopped].map(count);
    html! {
        div class=(if all == done { "box good" } else { "box off" }) {
            p.headline { (done) " of " (all) " cases finished"
                @for (word, count) in others.iter().filter(|(_, count)| *count > 0) { ", " (count) " " (word) }
                "."
            }
            dl {
                dt { "Parameters" } dd { (record.parameters.iter().map(|one| one.name.as_str()).collect::<Vec<_>>().join(", ")) }
                dt { "CPU time" } dd { (time(record.seconds.iter().filter(|x| x.is_finite()).sum())) " s" }
            }
        }
        @if !finished.objectives.is_empty() && done > 0 {
            div.table tabindex="0" role="region" aria-label="Objectives" { table {
                caption { "Objectives of the finished cases." }
                thead { tr {
                    th.text scope="col" { "Objective" }
                    @for head in ["Least", "Mean", "Largest", "Standard deviation"] { th scope="col" { (head) } }
                } }
                tbody { @for objective in &finished.objectives { tr {
                    th.text scope="row" { (objective.name) }
                    @for value in statistics(objective) { td { (value) } }
                } } }
            } }
        }
    }
}

/// Time with three decimals.
fn time(seconds: f64) -> String {
    format!("{seconds:.3}")
}

/// Least, mean, largest value and standard deviation.
fn statistics(column: &RecordedColumn) -> [String; 4] {
    let ObjectiveRange { least, mean, largest, deviation } =
        ObjectiveRange::of(column.numbers.iter().copied());
    [least, mean, largest, deviation].map(|x| x.map_or_else(|| "-".to_owned(), short))
}

/// Observed orders, if only one numeric parameter varies.
fn converging(finished: &StudyRecord, objective: &RecordedColumn) -> Markup {
    let others_vary =
        finished.parameters.iter().filter(|one| one.texts.windows(2).any(|pair| pair[0] != pair[1])).count()
            > 1;
    let varying = finished.varying();
    let [parameter] = varying.as_slice() else { return html! {} };
    let found = convergence(parameter, objective).filter(|found| found.limit.is_some() && !others_vary);
    let Some((found, plot)) =
        found.and_then(|found| error_over_size(&found, parameter, objective).map(|plot| (found, plot)))
    else {
        return html! {};
    };
    html! {
        (figure(&format!("{}-convergence", objective.name), plot.svg(), &html! {
            "Difference to the extrapolated limit " (short(found.limit.unwrap_or(f64::NAN))) " (Richardson 1911)."
        }))
        div.table tabindex="0" role="region" aria-label="Convergence" { table {
            thead { tr { th scope="col" { (if parameter.is_integer { format!("1/{}", parameter.name) } else { parameter.name.clone() }) }
                th scope="col" { (objective.name) } th scope="col" { "Observed order" } } }
            tbody { @for (k, size) in found.sizes.iter().enumerate() { tr {
                td { (short(*size)) } td { (short(found.values[k])) }
                td { (if found.orders[k].is_finite() { format!("{:.2}", found.orders[k]) } else { "-".to_owned() }) }
            } } }
        } }
    }
}

/// Regression and rank correlation, if at least two parameters vary.
fn sensitivities(finished: &StudyRecord, objective: &RecordedColumn) -> Markup {
    let varying = finished.varying();
    let Some(found) = sensitivity(&varying, objective).filter(|_| varying.len() > 1) else { return html! {} };
    html! {
        div.table tabindex="0" role="region" aria-label="Sensitivity" { table {
            caption {
                "Sensitivity: standardised coefficients of a linear regression, which explains "
                (format!("{:.1}", 100.0 * found.explained)) " % of the variance, and rank correlations (Spearman 1904)."
            }
            thead { tr { th.text scope="col" { "Parameter" } th scope="col" { "Regression" } th scope="col" { "Rank" } } }
            tbody { @for one in &found.parameters { tr {
                th.text scope="row" { (one.name) }
                td { (format!("{:.3}", one.regression)) } td { (format!("{:.3}", one.rank)) }
            } } }
        } }
    }
}

/// Messages of the cases of a record that `is_listed` selects.
fn messages(record: &StudyRecord, is_listed: impl Fn(usize) -> bool) -> Markup {
    html! {
        ul { @for k in (0..record.cases.len()).filter(|k| is_listed(*k)).take(MAX_CASES) {
            li style="white-space: pre-line" {
                "Case " (record.cases[k]) ", " (record.outcomes[k].word()) ": " (record.messages[k])
            }
        } }
    }
}

fn cases(record: &StudyRecord) -> Markup {
    let columns: Vec<&RecordedColumn> = record.parameters.iter().chain(&record.objectives).collect();
    let count = record.cases.len();
    let text = |column: &RecordedColumn, k: usize| {
        let number = column.numbers[k];
        if number.is_finite() { short(number) } else { column.texts[k].clone() }
    };
    html! {
        @if count > MAX_CASES { p { "The first " (MAX_CASES) " of " (count) " cases. The Parquet file has all." } }
        div.table.long tabindex="0" role="region" aria-label="Cases" { table.wide {
            thead { tr {
                th scope="col" { "Case" }
                @for column in &columns { th scope="col" { (column.name) } }
                th.text scope="col" { "Outcome" } th scope="col" { "Time (s)" }
            } }
            tbody { @for k in 0..count.min(MAX_CASES) { tr {
                td { (record.cases[k]) }
                @for column in &columns { td { (text(column, k)) } }
                td.text { (record.outcomes[k].word()) } td { (time(record.seconds[k])) }
            } } }
        } }
    }
}
