//! Iterations and tolerances.

use maud::{Markup, html};

use super::{Report, table, unit};
use crate::paper::cases::{DENSITY, GRAVITY, LENGTH, YOUNG};
use crate::paper::published;
use crate::paper::results::area;
use crate::paper::study::MOST_ITERATIONS;
use crate::report::number::{fixed, scientific, significant};

impl Report<'_> {
    pub(super) fn iterations(&self) -> Markup {
        html! {
            p { "Figure 7 of the paper shows \u{201c}approximately " (published::FIGURE_7_ITERATIONS)
                "\u{201d} iterations in the initial steps of the dimensional form and one or two in the \
                non-dimensional one, and explains it by high frequencies that cancel. It does not state \
                when an iteration ends. The table tries absolute tolerances." }
            (table(&self.tables.tolerances, &html! {
                "Newton iterations of the revolute pendulum when every step must reach |r| ≤ the number \
                given, in the numbers of each form; last line: the default rule. A step stalls if "
                (MOST_ITERATIONS) " iterations do not end it."
            }))
            (rounding())
            (self.printed_times())
            p { "The default rule of this program ends when the energy of Newton's increment is negligible \
                or the residual is down to its own rounding error. It is blind to units, and gives both \
                forms about two iterations a step. The benefit the paper saw is real for programs with \
                absolute tolerances: non-dimensional numbers put the rounding error where the tolerance \
                does not meet it. It is a benefit of the tolerance, not of the equations. Where in time \
                the many iterations come depends on the tolerance and on the order of summation: in the \
                paper at the start, here as the pendulum gathers speed." }
        }
    }

    fn printed_times(&self) -> Markup {
        let table = &self.results.table6;
        let printed = |column: &Option<Vec<f64>>| column.iter().flatten().sum::<f64>();
        let (instants, seconds) = (&table.instants, &table.seconds);
        let revolute_dim = 1e3 * seconds.paper_seconds_dim / printed(&instants.paper_dim);
        let revolute_nondim = 1e3 * seconds.paper_seconds_nondim / printed(&instants.paper_nondim);
        let cantilever = [
            1e3 * published::TABLE_4_DIM[0] / instants.dim[0],
            1e3 * published::TABLE_4_NONDIM[0] / instants.nondim[0],
        ];
        html! {
            p { "The paper's times fit this reading. A step of its cantilever of one element took "
                (fixed(cantilever[0], 1)) " ms (DIM) and " (fixed(cantilever[1], 1)) " ms (Non-DIM); a \
                step of its revolute pendulum, with the same element, " (fixed(revolute_nondim, 1)) " ms \
                (Non-DIM), but " (fixed(revolute_dim, 1)) " ms (DIM): only this run has the many \
                iterations." }
        }
    }
}

/// Where the rounding error of the residual lies.
fn rounding() -> Markup {
    let stiffness = YOUNG * area();
    let weight = DENSITY * area() * LENGTH * GRAVITY;
    html! {
        p { "The residual of the dimensional form is a sum of forces as large as EA = "
            (scientific(stiffness, 2)) " N, so it carries a rounding error of about EA ε = "
            (scientific(stiffness * f64::EPSILON, 2)) " N. A tolerance well above it is met in one or \
            two iterations; one near it is met by luck, after erratic numbers of iterations; one below \
            it, never. The residual of the non-dimensional form is the same one divided by " (unit("F")) " \
            = " (significant(weight, 3)) " N (one element), so the same number is a tolerance "
            (significant(weight, 2)) " times looser." }
    }
}
