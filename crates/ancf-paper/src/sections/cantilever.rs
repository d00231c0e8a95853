//! Section 3.1 of the paper.

use maud::{Markup, html};

use super::context::PageContext;
use super::markup::{table, unit};
use crate::cases::{PaperCase, peers, published};
use crate::page::number::{fixed, significant};

pub(super) fn section(context: &PageContext<'_>) -> Markup {
    html! {
        p { "A steel rod, 1 m long and 20 mm thick, is clamped at one end and released from the straight state. It \
            has n fully parameterised elements of 24 coordinates. The motion of 2 s is computed by Newmark's scheme \
            with β = 0.36 and γ = 0.70. " b { "DIM" } " is the dimensional form in \
            metres, kilograms and seconds, with steps of 1 ms. " b { "Non-DIM" } " is the \
            non-dimensional form in units " (unit("L")) " = 1 m, " (unit("F")) " = the weight of one \
            element, and " (unit("T")) " = √(L n/g), with steps of 0.001 " (unit("T")) "." }
        (table(&context.tables.table3, &html! {
            strong { "Table 3." } " " (unit("T")) ", the unit of time of the non-dimensional form."
        }))
        (table(&context.tables.table4, &html! { strong { "Table 4." } " Analysis time of the cantilever." }))
        (speed(context))
        (table(&context.tables.peers, &html! {
            "The dimensional form, steps of 1 ms, by other programs. Only " b { "ancf" } " was measured for this \
             report, on the machine named above."
        }))
        (conditions())
        (context.figure("fig3", "Figure 3"))
        (means(context))
        (table(&context.tables.table5, &html! {
            strong { "Table 5." } " Mean over all instants of the tip deflection."
        }))
        (context.figure("fig4", "Figure 4"))
        (context.figure("fig5", "Figure 5"))
    }
}

fn speed(context: &PageContext<'_>) -> Markup {
    let times = &context.results.table4;
    let last = |column: &[f64]| column.last().copied().unwrap_or(f64::NAN);
    let (own, paper) = (last(&times.dim), last(times.paper_dim.as_deref().unwrap_or_default()));
    let gain = context.largest(PaperCase::Cantilever);
    html! {
        p { "Times depend on machine and language. The paper's " (fixed(paper, 2)) " s at 20 elements \
            were taken by " (published::MACHINE) "; those of this program take " (significant(own, 2)) " s in a \
            compiled program on " (context.results.machine.processor) ", " (significant(paper / own, 2))
            " times less. This is not a property of the formulation. The ratio of the two forms can be compared: it \
             crosses 1 near ten elements, where " (unit("T")) " = 1 s, and at \
            twenty the paper has " (fixed(published::printed_gain(), 2)) ", this program " (fixed(gain.total, 2)) "." }
    }
}

fn means(context: &PageContext<'_>) -> Markup {
    let static_value = context.results.equation34;
    html! {
        p { "Eq. (34) gives the static deflection q L⁴/(8 E I) = " (fixed(static_value.value, 4)) " \
            mm; the paper prints " (fixed(static_value.paper, 3)) " mm. The means of Table 5 approach \
            it from above as locking fades." }
    }
}

/// Returns the conditions of the runs of other programs.
fn conditions() -> Markup {
    html! {
        p { "Paper: " (published::MACHINE) ". Chrono: " (peers::CHRONO_CONDITIONS) "; its fully \
            parameterised beam of 24 coordinates, HHT with α = 0, 4 iterations a step. EXUDYN: "
            (peers::EXUDYN_CONDITIONS) "; a cable of 12 coordinates without shear and torsion, which is half \
            the unknowns, Newmark's scheme as here, a modified Newton method with a relative tolerance of \
            10⁻⁵ of the residual, tuned for speed. Both: one thread, time of the processor, no files. \
            ancf: the full Newton method, as the paper's; the modified one, the default elsewhere, takes half \
            of the time at 20 elements." }
    }
}
