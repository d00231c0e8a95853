//! The box at the top.

use maud::{Markup, html};

use super::{Report, table};
use crate::paper::cases::GRAVITY;
use crate::paper::published;
use crate::paper::results::{Gain, Problem};
use crate::report::number::{fixed, scientific, significant};

impl Report<'_> {
    pub(super) fn summary(&self) -> Markup {
        let verdict = &self.results.verdict;
        let all = verdict.within() == verdict.numbers();
        html! {
            div class=(if all { "box good" } else { "box off" }) {
                p.headline { (self.headline()) }
                (self.machine())
            }
            (table(&self.tables.verdict, &html! {
                "The printed numbers that do not depend on the machine. Exact: equal in every printed \
                digit. Worst: the largest difference, beside the one allowed."
            }))
            h3 { "What came out" }
            (self.findings())
        }
    }

    fn headline(&self) -> String {
        let verdict = &self.results.verdict;
        let (numbers, within, exact) = (verdict.numbers(), verdict.within(), verdict.exact());
        let (who, off) = match numbers - within {
            0 => (format!("All {numbers}"), String::new()),
            off => (format!("{within} of {numbers}"), format!("; {off} are off")),
        };
        format!(
            "{who} printed numbers that do not depend on the machine are reproduced, {exact} of them to the \
             last printed digit{off}."
        )
    }

    fn machine(&self) -> Markup {
        let results = self.results;
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

    fn findings(&self) -> Markup {
        let results = self.results;
        let [cantilever, spherical] =
            [Problem::Cantilever, Problem::Spherical].map(|problem| self.largest(problem));
        let apart = results.gain.iter().map(|gain| gain.tip_difference).fold(0.0, f64::max);
        let equal = results.gain.iter().filter(|gain| gain.has_equal_iterations()).count();
        let blind = results.tolerances.last().map_or(0, |rule| rule.dim.most.max(rule.nondim.most));
        let most = results.tolerances.iter().map(|rule| rule.dim.most).max().unwrap_or(0);
        html! {
            ul {
                li { a href="#gain" { "Gain." } " The non-dimensional form is faster with many elements \
                    because it takes a longer physical step: at " (cantilever.n) " elements it does "
                    (fixed(cantilever.longer_step, 2)) " times fewer steps and is "
                    (fixed(cantilever.total, 2)) " times faster (cantilever). With the same physical step \
                    both forms give the same motion, to " (scientific(apart, 1)) " m, with as many \
                    iterations in " (equal) " of " (results.gain.len()) " cases." }
                li { a href="#iterations" { "Iterations." } " The many iterations of the dimensional form \
                    in Figure 7 belong to an absolute tolerance near its rounding error: there we count up \
                    to " (most) ". Under a rule that is blind to units neither form needs more than "
                    (blind) "." }
                li { a href="#spherical" { "Fourfold." } " The paper's \u{201c}more than fourfold\u{201d} \
                    gain of the spherical pendulum at " (spherical.n) " elements is "
                    @if spherical.total <= published::TABLE_7_CLAIM { "not " }
                    "found: we measure " (fixed(spherical.total, 2)) "." }
                li { a href="#condition-numbers" { "Conditioning." } " The non-dimensional writing improves the \
                    iteration matrix by a constant factor; symmetry and equilibration improve it far more, \
                    and make units irrelevant." }
                li { a href="#gravity" { "Gravity." } " The paper does not print g; its numbers belong to \
                    " (GRAVITY) " m/s², not to 9.81." }
            }
        }
    }

    /// The gain of a problem with the largest mesh.
    pub(super) fn largest(&self, problem: Problem) -> &Gain {
        let of_problem = self.results.gain.iter().filter(|gain| gain.problem == problem);
        // Every problem is in the study, so the first is there for the compiler only.
        of_problem.max_by_key(|gain| gain.n).unwrap_or(&self.results.gain[0])
    }
}
