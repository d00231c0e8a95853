//! Condition numbers.

use maud::{Markup, html};

use super::context::PageContext;
use super::markup::table;
use crate::cases::ConditionRow;
use crate::page::number::{scientific, significant};

/// Step of the comparison in the text, s.
const STEP: f64 = 1e-3;

pub(super) fn section(context: &PageContext<'_>) -> Markup {
    let all = &context.tables.conditioning;
    let stiff = context.results.conditioning.stiff.len();
    // The caption states the modulus of the first column.
    let part = |rows| all.part(rows, 1..all.columns.len());
    html! {
        p { "The condition number of the iteration matrix bounds the loss of digits in the Newton increment. It is \
            given for the beam on a spherical joint, straight and at rest, in the forms that have been proposed for \
            equations of index 3." }
        (forms(context))
        (table(&part(0..stiff), &html! { "Condition numbers in the 2-norm, E = 193×10⁹ Pa." }))
        (table(&part(stiff..all.rows.len()), &html! {
            "Condition numbers in the 2-norm, E = 193×10⁶ Pa as in section 3.3."
        }))
        (context.figure("conditioning", "Beyond the paper"))
    }
}

/// Describes each form, with the factors at h = 1 ms.
fn forms(context: &PageContext<'_>) -> Markup {
    let at = |n: u32| context.results.conditioning.stiff.iter().find(|row| row.n == n && row.h == STEP);
    let (Some(one), Some(many)) = (at(1), at(20)) else { return html! {} };
    let better = |row: &ConditionRow, i: usize| significant(row.condition[0] / row.condition[i], 2);
    html! {
        dl.writings {
            dt { "Eq. (37), DIM" }
            dd { "Coordinates (r, r" sub { "x" } ", r" sub { "y" } ", r" sub { "z" } "), constraint \
                rows times βh². At h = 1 ms " (scientific(one.condition[0], 2)) " with one element and \
                " (scientific(many.condition[0], 2)) " with twenty; it grows like h⁻² as h → 0." }
            dt { "Eq. (37), DIM, slopes × l" }
            dd { "Slopes as lengths, as in eq. (10), but no other units: " (better(many, 1)) " times \
                better with twenty elements, the same with one, where l = L = 1 m." }
            dt { "Eq. (37), Non-DIM" }
            dd { "Form of the paper: " (better(one, 2)) " times better with one element, " (better(many, 2))
                " with twenty. The improvement is a constant factor, independent of the step: the number grows like \
                 h⁻² as well." }
            dt { "Symmetric" }
            dd { "Constraint rows divided by βh² (Negrut et al. 2007): " (better(one, 3)) " and "
                (better(many, 3)) " times better than DIM, and bounded as h → 0. The improvement increases with \
                    smaller steps. At h = 10 ms with twenty elements the form of the paper is better." }
            dt { "Displacement" }
            dd { "Displacements as unknowns without scaling: the largest numbers, and growth up to h⁻⁴." }
            dt { "Bottasso" }
            dd { "Displacement form, scaled from both sides by powers of h (Bottasso, Dopico & Trainelli 2008): equal \
                to the symmetric matrix in other unknowns." }
            dt { "Equilibrated" }
            dd { "Symmetric form with a diagonal on both sides (Ruiz 2001): " (better(one, 6)) " \
                and " (better(many, 6)) " times better than DIM; independent of the choice of units and slopes. Such \
                a diagonal does not change the rounding errors of the factorisation of this program." }
        }
    }
}
