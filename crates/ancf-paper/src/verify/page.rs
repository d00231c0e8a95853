//! HTML page of the verification.

use ancf_verification::Comparison;
use maud::{Markup, html};

use super::plot;
use super::record::VerificationRecord;
use super::verdict::ProblemVerdict;
use crate::page::number::{fixed, scientific, significant};
use crate::page::{HtmlPage, PageSection, figure};

/// Maximum number of rows of a table that is not collapsed, if all rows hold.
const MAX_ROWS: usize = 16;

/// Returns the page as HTML.
pub fn page(verdicts: &[ProblemVerdict], record: &VerificationRecord) -> String {
    let mut sections = vec![PageSection::new("summary", "Summary", summary(verdicts, record))];
    sections.extend(verdicts.iter().map(section));
    let subtitle = html! {
        "Closed forms, independent solutions and published numbers, computed on this machine by "
        code { "ancf verify" } "."
    };
    HtmlPage { title: "Problems with known answers", subtitle, sections }.into_text()
}

fn summary(verdicts: &[ProblemVerdict], record: &VerificationRecord) -> Markup {
    let numbers: usize = verdicts.iter().map(|verdict| verdict.comparisons().len()).sum();
    html! {
        div class=(if record.holds { "box good" } else { "box off" }) {
            p.headline { (headline(verdicts)) }
            dl {
                (record.machine.entries())
                dt { "Compared" } dd { (numbers) " numbers in " (significant(record.seconds, 2)) " s" }
            }
        }
        div.table tabindex="0" role="region" aria-label="All problems" {
            table.wide {
                caption { span {
                    "Worst comparison of each problem: the largest ratio of error to tolerance. Ratio: estimated errors of \
                     meshes, relative to the true ones. "
                    span.files { a href="results.json" { "JSON" } }
                } }
                thead { tr {
                    th.text scope="col" { "Problem" } th.text scope="col" { "Source" }
                    th scope="col" { "Numbers" } th scope="col" { "Worst error" }
                    th scope="col" { "Tolerance" } th scope="col" { "Ratio" }
                    th.text scope="col" { "Verdict" }
                    th scope="col" { "Time (s)" }
                } }
                tbody { @for verdict in verdicts { (line(verdict)) } }
            }
        }
    }
}

fn headline(verdicts: &[ProblemVerdict]) -> String {
    let holding = verdicts.iter().filter(|verdict| verdict.holds()).count();
    match (verdicts.len(), holding) {
        (1, 1) => "The problem passed.".to_owned(),
        (all, holding) if all == holding => format!("All {all} problems passed."),
        (all, holding) => format!("{holding} of {all} problems passed; {} failed.", all - holding),
    }
}

/// Returns the row of a problem in the summary.
fn line(verdict: &ProblemVerdict) -> Markup {
    let problem = verdict.problem;
    html! {
        tr {
            th.text.title scope="row" { a href={ "#" (problem.name) } { (problem.title) } }
            td.text.source { (problem.source) }
            td { (verdict.comparisons().len()) }
            @match verdict.worst() {
                Some(worst) => { td { (error(worst)) } td { (tolerance(worst)) } }
                None => { td { "–" } td { "–" } }
            }
            td { (verdict.effectivity_range()) }
            td.text { (word(verdict.holds())) }
            td { (fixed(verdict.seconds, 2)) }
        }
    }
}

fn section(verdict: &ProblemVerdict) -> PageSection {
    let problem = verdict.problem;
    let plots = verdict.findings.iter().flat_map(|findings| &findings.plots).enumerate();
    let body = html! {
        p { (problem.goal) "." }
        pre.sketch role="img" aria-label={ "Sketch: " (problem.title) } { (sketch(problem.sketch)) }
        p.source { "Reference: " (problem.source) "." }
        @match verdict.reason() {
            Some(reason) => { div.box.off { p.headline { "Could not be solved" } p { (reason) } } }
            None => { (compared(verdict)) }
        }
        @if !verdict.effectivities().is_empty() { (effectivities(verdict)) }
        @for (k, plot) in plots {
            (figure(&format!("{}-{}", problem.name, k + 1), plot::figure(plot).svg(), &html! { (plot.title) "." }))
        }
    };
    PageSection::new(problem.name, problem.title, body)
}

/// Returns the estimated errors of the mesh with the true ones.
fn effectivities(verdict: &ProblemVerdict) -> Markup {
    html! {
        div.table tabindex="0" role="region" aria-label={ "Estimated errors: " (verdict.problem.title) } {
            table {
                caption { "Errors of the mesh: estimate of the program, and difference to the reference." }
                thead { tr {
                    th.text scope="col" { "Quantity" } th scope="col" { "Elements" } th scope="col" { "Estimate" }
                    th scope="col" { "Error" } th scope="col" { "Ratio" } th.text scope="col" { "Verdict" }
                } }
                tbody { @for each in verdict.effectivities() { tr {
                    th.text scope="row" { (each.what) }
                    td { (each.level) } td { (scientific(each.estimate, 2)) } td { (scientific(each.error, 2)) }
                    td { (fixed(each.ratio(), 2)) } td.text { (word(each.holds())) }
                } } }
            }
        }
    }
}

/// Removes empty lines around a text drawing, and the margin common to all lines.
fn sketch(text: &str) -> String {
    let lines: Vec<&str> = text.lines().map(str::trim_end).collect();
    let full = |line: &&str| !line.is_empty();
    let margin = |line: &&str| line.len() - line.trim_start_matches(' ').len();
    let margin = lines.iter().copied().filter(full).map(|line| margin(&line)).min().unwrap_or(0);
    let lines: Vec<&str> = lines.iter().map(|line| line.get(margin..).unwrap_or_default()).collect();
    lines.join("\n").trim_matches('\n').to_owned()
}

/// Returns the comparisons, collapsed if there are many and all hold.
fn compared(verdict: &ProblemVerdict) -> Markup {
    let count = verdict.comparisons().len();
    let off = verdict.comparisons().iter().filter(|comparison| !comparison.holds()).count();
    html! {
        @if count > MAX_ROWS && off == 0 {
            details {
                summary { "All " (count) " numbers passed" @if let Some(worst) = verdict.worst() {
                    "; the worst is " (worst.what) ", " (error(worst)) " off, where " (tolerance(worst)) " is allowed"
                } "." }
                (table(verdict))
            }
        } @else { (table(verdict)) }
    }
}

fn table(verdict: &ProblemVerdict) -> Markup {
    html! {
        div.table tabindex="0" role="region" aria-label={ "Numbers of " (verdict.problem.title) } {
            table {
                thead { tr {
                    th.text scope="col" { "Quantity" } th scope="col" { "Computed" } th scope="col" { "Reference" }
                    th scope="col" { "Error" } th scope="col" { "Tolerance" } th.text scope="col" { "Verdict" }
                } }
                tbody { @for comparison in verdict.comparisons() { (row(comparison)) } }
            }
        }
    }
}

fn row(comparison: &Comparison) -> Markup {
    html! {
        tr {
            th.text scope="row" { (comparison.what) }
            td { (value(comparison, comparison.ours)) }
            td { (value(comparison, comparison.reference)) }
            td { (error(comparison)) }
            td { (tolerance(comparison)) }
            td.text { (word(comparison.holds())) }
        }
    }
}

fn word(holds: bool) -> Markup {
    html! { @if holds { span.good { "passed" } } @else { strong.off { "failed" } } }
}

/// Formats a number of a comparison with two digits beyond its tolerance.
fn value(comparison: &Comparison, x: f64) -> String {
    let allowed = comparison.tolerance * comparison.scale;
    if !(x.is_finite() && allowed > 0.0 && allowed.is_finite()) || x == 0.0 {
        return significant(x, 6);
    }
    let beyond = (x.abs() / allowed).log10().ceil() + 2.0;
    significant(x, beyond.clamp(2.0, 14.0) as usize)
}

fn error(comparison: &Comparison) -> String {
    relative(comparison.error())
}

fn tolerance(comparison: &Comparison) -> String {
    relative(comparison.tolerance)
}

/// Formats a relative number with at most two digits.
fn relative(x: f64) -> String {
    let two = scientific(x, 2);
    match x {
        _ if x == 0.0 || (0.1..100.0).contains(&x) => significant(x, 2),
        _ if two.contains(".0") => scientific(x, 1),
        _ => two,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_significant_digits() {
        let mut findings = ancf_verification::Findings::default();
        findings.compare("x", 0.943_566_763, 0.943_566_123, 1.0, 1e-5);
        findings.compare("y", 3e-13, 0.0, 2.0, 2.5e-6);
        let [x, y] = &findings.comparisons[..] else { panic!("two") };
        assert_eq!([value(x, x.ours), error(x), tolerance(x)], ["0.9435668", "6.4×10⁻⁷", "10⁻⁵"]);
        assert_eq!([2.0, 0.25, 1e-3, 2e-8, f64::NAN].map(relative), ["2.0", "0.25", "10⁻³", "2×10⁻⁸", "NaN"]);
        assert_eq!([value(y, y.ours), value(y, 0.0), tolerance(y)], ["3.0×10⁻¹³", "0", "2.5×10⁻⁶"]);
    }

    #[test]
    fn sketches_lose_their_margin() {
        assert_eq!(sketch("\n    a--\n     \\ π\n\n"), "a--\n \\ π");
    }
}
