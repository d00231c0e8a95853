//! Summary at the top of the page.

use maud::{Markup, html};

use super::context::PageContext;
use super::markup::table;
use crate::cases::models::GRAVITY;
use crate::cases::{PaperCase, published};
use crate::page::number::{fixed, scientific, significant};

pub(super) fn section(context: &PageContext<'_>) -> Markup {
    let verdict = &context.results.verdict;
    let all = verdict.within() == verdict.numbers();
    html! {
        div class=(if all { "box good" } else { "box off" }) {
            p.headline { (headline(context)) }
            (machine(context))
        }
        (table(&context.tables.verdict, &html! {
            "Printed numbers that do not depend on the machine. Exact: equal in every printed digit. Worst: the \
             largest difference."
        }))
        h3 { "Results" }
        (findings(context))
    }
}

fn headline(context: &PageContext<'_>) -> String {
    let verdict = &context.results.verdict;
    let (numbers, within, exact) = (verdict.numbers(), verdict.within(), verdict.exact());
    let (who, off) = match numbers - within {
        0 => (format!("All {numbers}"), String::new()),
        off => (format!("{within} of {numbers}"), format!("; {off} are not")),
    };
    format!(
        "{who} printed numbers that do not depend on the machine are reproduced, {exact} of them to the \
         last printed digit{off}."
    )
}

fn machine(context: &PageContext<'_>) -> Markup {
    let results = context.results;
    html! {
        dl {
            (results.machine.entries())
            dt { "Times" } dd {
                @if results.repeats > 1 { "medians of " (results.repeats) " runs" }
                @else { "one run each" }
                ", one thread, without writing files"
            }
            dt { "Study" } dd { (significant(results.seconds, 2)) " s in all" }
        }
    }
}

fn findings(context: &PageContext<'_>) -> Markup {
    let results = context.results;
    let [cantilever, spherical] =
        [PaperCase::Cantilever, PaperCase::Spherical].map(|problem| context.largest(problem));
    let apart = results.gain.iter().map(|gain| gain.tip_difference).fold(0.0, f64::max);
    let equal = results.gain.iter().filter(|gain| gain.has_equal_iterations()).count();
    let blind = results.tolerances.last().map_or(0, |rule| rule.dim.max.max(rule.nondim.max));
    let most = results.tolerances.iter().map(|rule| rule.dim.max).max().unwrap_or(0);
    html! {
        ul {
            li { a href="#gain" { "Gain." } " The non-dimensional form is faster with many elements \
                because it takes a longer physical step: at " (cantilever.n) " elements it does "
                (fixed(cantilever.longer_step, 2)) " times fewer steps and is "
                (fixed(cantilever.total, 2)) " times faster (cantilever). With the same physical step \
                both forms give the same motion, to " (scientific(apart, 1)) " m, with as many \
                iterations in " (equal) " of " (results.gain.len()) " cases." }
            li { a href="#iterations" { "Iterations." } " The many iterations of the dimensional form in Figure 7 are \
                due to an absolute tolerance near its rounding error: up to " (most) " here. Under a rule that is \
                independent of units neither form needs more than "
                (blind) "." }
            li { a href="#spherical" { "Fourfold." } " The paper's \u{201c}more than fourfold\u{201d} \
                gain of the spherical pendulum at " (spherical.n) " elements is "
                @if spherical.total <= published::TABLE_7_CLAIM { "not " }
                "found: the measured value is " (fixed(spherical.total, 2)) "." }
            li { a href="#condition-numbers" { "Conditioning." } " The non-dimensional form improves the condition \
                number by a constant factor. Symmetry and equilibration improve it far more and make it independent \
                of units." }
            li { a href="#gravity" { "Gravity." } " The paper does not print g; its numbers correspond to \
                " (GRAVITY) " m/s², not to 9.81." }
        }
    }
}
