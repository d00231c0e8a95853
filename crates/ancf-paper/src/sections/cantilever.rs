//! Section 3.1 of the paper.

use maud::{Markup, html};

use super::{Report, table, unit};
use crate::paper::results::Problem;
use crate::paper::{peers, published};
use crate::report::number::{fixed, significant};

impl Report<'_> {
    pub(super) fn cantilever(&self) -> Markup {
        html! {
            p { "A steel rod, 1 m long and 20 mm thick, is clamped at one end and dropped from straight. \
                It is divided into n fully parameterised elements of 24 coordinates, and followed for 2 s \
                by Newmark's scheme with β = 0.36 and γ = 0.70. " b { "DIM" } " is the dimensional form in \
                metres, kilograms and seconds, with steps of 1 ms. " b { "Non-DIM" } " is the \
                non-dimensional form in units " (unit("L")) " = 1 m, " (unit("F")) " = the weight of one \
                element, and " (unit("T")) " = √(L n/g), with steps of 0.001 " (unit("T")) "." }
            (table(&self.tables.table3, &html! {
                strong { "Table 3." } " " (unit("T")) ", the unit of time of the non-dimensional form."
            }))
            (table(&self.tables.table4, &html! { strong { "Table 4." } " Analysis time of the cantilever." }))
            (self.speed())
            (table(&self.tables.peers, &html! {
                "The dimensional form, steps of 1 ms, by other programs. Only " b { "ancf" } " ran for this \
                report, on the machine named above; the others did not."
            }))
            (conditions())
            (self.figure("fig3", "Figure 3"))
            (self.means())
            (table(&self.tables.table5, &html! {
                strong { "Table 5." } " Mean over all instants of the tip deflection."
            }))
            (self.figure("fig4", "Figure 4"))
            (self.figure("fig5", "Figure 5"))
        }
    }

    fn speed(&self) -> Markup {
        let times = &self.results.table4;
        let last = |column: &[f64]| column.last().copied().unwrap_or(f64::NAN);
        let (ours, paper) = (last(&times.dim), last(times.paper_dim.as_deref().unwrap_or_default()));
        let gain = self.largest(Problem::Cantilever);
        html! {
            p { "Times depend on machine and language. The paper's " (fixed(paper, 2)) " s at 20 elements \
                were taken by " (published::MACHINE) "; ours take " (significant(ours, 2)) " s in a \
                compiled program on " (self.results.machine.processor) ", " (significant(paper / ours, 2))
                " times less. That says nothing about the formulation. What can be compared is the ratio \
                of the two forms: it crosses 1 near ten elements, where " (unit("T")) " = 1 s, and at \
                twenty the paper has " (fixed(self.printed_gain(), 2)) ", we " (fixed(gain.total, 2)) "." }
        }
    }

    /// DIM / Non-DIM of the paper with the largest mesh.
    pub(super) fn printed_gain(&self) -> f64 {
        let last = |column: [f64; 6]| column[column.len() - 1];
        last(published::TABLE_4_DIM) / last(published::TABLE_4_NONDIM)
    }

    fn means(&self) -> Markup {
        let static_value = self.results.equation34;
        html! {
            p { "Eq. (34) gives the static deflection q L⁴/(8 E I) = " (fixed(static_value.value, 4)) " \
                mm; the paper prints " (fixed(static_value.paper, 3)) " mm. The means of Table 5 approach \
                it from above as locking fades." }
        }
    }
}

/// Under which conditions the other programs ran.
fn conditions() -> Markup {
    html! {
        p { "Paper: " (published::MACHINE) ". Chrono: " (peers::CHRONO_CONDITIONS) "; its fully \
            parameterised beam of 24 coordinates, HHT with α = 0, 4 iterations a step. EXUDYN: "
            (peers::EXUDYN_CONDITIONS) "; a cable of 12 coordinates without shear and torsion, which is half \
            the unknowns, Newmark's scheme as here, a modified Newton method with a relative tolerance of \
            10⁻⁵ of the residual, tuned for speed. Both: one thread, time of the processor, no files. \
            Ours: the full Newton method, as the paper's; the modified one, the default elsewhere, takes half \
            of the time at 20 elements." }
    }
}
