//! Iterations and tolerances.

use maud::{Markup, html};

use super::context::PageContext;
use super::markup::{table, unit};
use crate::cases::models::{DENSITY, GRAVITY, LENGTH, YOUNG, area};
use crate::cases::{MAX_ITERATIONS, published};
use crate::page::number::{fixed, scientific, significant};

pub(super) fn section(context: &PageContext<'_>) -> Markup {
    html! {
        p { "Figure 7 of the paper shows \u{201c}approximately " (published::FIGURE_7_ITERATIONS)
            "\u{201d} iterations in the initial steps of the dimensional form and one or two in the \
            non-dimensional one, and explains it by high frequencies that cancel. The stopping rule is not stated. \
            The table compares absolute tolerances." }
        (table(&context.tables.tolerances, &html! {
            "Newton iterations of the revolute pendulum if every step must reach |r| ≤ the given tolerance, in the \
             units of each form; last line: the default rule. A step stalls if "
            (MAX_ITERATIONS) " iterations do not suffice."
        }))
        (rounding())
        (printed_times(context))
        p { "The default rule of this program stops if the energy of the Newton increment is negligible or the \
            residual is at its rounding error. It is independent of units: both forms need about two iterations per \
            step. The benefit in the paper is real for programs with absolute tolerances: in non-dimensional units \
            the rounding error is far below the tolerance. It is a property of the tolerance, not of the equations. \
            The time of the steps with many iterations depends on the tolerance and on the order of summation: in the \
            paper at the start, here at higher speeds of the pendulum." }
    }
}

fn printed_times(context: &PageContext<'_>) -> Markup {
    let table = &context.results.table6;
    let printed = |column: &Option<Vec<f64>>| column.iter().flatten().sum::<f64>();
    let (instants, seconds) = (&table.instants, &table.seconds);
    let revolute_dim = 1e3 * seconds.paper_seconds_dim / printed(&instants.paper_dim);
    let revolute_nondim = 1e3 * seconds.paper_seconds_nondim / printed(&instants.paper_nondim);
    let cantilever = [
        1e3 * published::TABLE_4_DIM[0] / instants.dim[0],
        1e3 * published::TABLE_4_NONDIM[0] / instants.nondim[0],
    ];
    html! {
        p { "The printed times agree with this explanation. A step of the cantilever of one element took "
            (fixed(cantilever[0], 1)) " ms (DIM) and " (fixed(cantilever[1], 1)) " ms (Non-DIM); a \
            step of the revolute pendulum, with the same element, " (fixed(revolute_nondim, 1)) " ms \
            (Non-DIM), but " (fixed(revolute_dim, 1)) " ms (DIM): only this run needs many iterations." }
    }
}

/// Describes the rounding error of the residual.
fn rounding() -> Markup {
    let stiffness = YOUNG * area();
    let weight = DENSITY * area() * LENGTH * GRAVITY;
    html! {
        p { "The residual of the dimensional form is a sum of forces as large as EA = "
            (scientific(stiffness, 2)) " N, so it has a rounding error of about EA ε = "
            (scientific(stiffness * f64::EPSILON, 2)) " N. A tolerance well above it is reached in one or two \
                iterations; one near it by chance, after erratic numbers of iterations; one below it, never. The \
                residual of the non-dimensional form is divided by " (unit("F")) " \
            = " (significant(weight, 3)) " N (one element), so the same number is a tolerance "
            (significant(weight, 2)) " times looser." }
    }
}
