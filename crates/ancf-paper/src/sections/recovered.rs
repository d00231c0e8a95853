//! Values that the paper does not state, and misprints.

use maud::{Markup, html};

use super::context::PageContext;
use super::markup::{table, unit};
use crate::cases::models::{DIAMETER, GRAVITY};
use crate::page::number::fixed;
use crate::results::Agreement;

pub(super) fn gravity(context: &PageContext<'_>) -> Markup {
    let gravity = &context.results.gravity;
    let [low, high] = gravity.interval.map(|g| fixed(g, 4));
    html! {
        p { "The paper does not print g. The 6263 instants of Table 6 are 2 s in steps of 0.001 √(L/g), which is true \
            for g from " (low) " to " (high) " m/s² only. With " (GRAVITY) " m/s², \
            eq. (34) gives −2.040 mm as printed; with 9.81 it would print −2.041." }
        (table(&context.tables.gravity, &html! {
            "Results for candidates of g. The paper prints 6263 instants and −2.040 mm."
        }))
        p { "Table 5 does not determine g: " (agreement(gravity.agreement)) " with " (GRAVITY) " m/s², "
            (agreement(gravity.agreement_with_981)) " with 9.81." }
        (table(&context.tables.table5_gravity, &html! {
            "Table 5 with two values of g: mean tip deflection."
        }))
    }
}

pub(super) fn recovered() -> Markup {
    html! {
        p { "Values that the paper does not state or misprints, determined by calculation and confirmed by its \
            printed numbers:" }
        ul {
            li { "Diameter " (DIAMETER) " m; Table 2 prints 0.20 m, with which eq. (34) would give \
                −0.0204 mm." }
            li { "Poisson's ratio 0; with 0.3 the cantilever locks at −1.515 mm." }
            li { (unit("F")) " is the weight of one element, and " (unit("L")) " = L: then " (unit("T"))
                " = √(L n/g) is Table 3 to its last digit." }
            li { "The step of the non-dimensional form is 0.001 in its own unit of time." }
            li { "Runs start from rest with zero accelerations, although gravity acts; the clamp fixes all twelve \
                coordinates of its node." }
        }
        p { "Misprints:" }
        ul {
            li { "Eqs. (5), (12): S₂ ends with ξ³, not 3ξ³. Eq. (12): Ŝ₆ = ξ³ − ξ², without the length." }
            li { "Eqs. (18), (19): M* lacks the factor 1/A*, A* = A/" (unit("L")) "²." }
            li { "Eqs. (27), (28): λ cross terms twice, shear terms 4G; eq. (31) is right. Eq. (24): \
                σ" sub { "ii" } ", not σ" sub { "ij" } "." }
            li { "Eq. (36): h times the old velocity, not the new one." }
            li { "The table of schemes in the appendix has the number 7 of the table of section 3.3, which is missing." }
        }
        p { "docs/paper.md of the repository lists each with its evidence and a test that fails with the printed form." }
    }
}

fn agreement(agreement: Agreement) -> String {
    let Agreement { exact, numbers, worst } = agreement;
    format!(
        "{exact} of its {numbers} numbers agree to the last digit, with a largest difference of {} mm",
        fixed(worst, 4)
    )
}
