//! Condition numbers.

use maud::{Markup, html};

use super::{Report, table};
use crate::paper::conditioning::Row;
use crate::report::number::{scientific, significant};

/// The step at which writings are compared in words, s.
const STEP: f64 = 1e-3;

impl Report<'_> {
    pub(super) fn conditioning(&self) -> Markup {
        let all = &self.tables.conditioning;
        let stiff = self.results.conditioning.stiff.len();
        // Captions tell the modulus of the first column.
        let part = |rows| all.part(rows, 1..all.columns.len());
        html! {
            p { "The condition number of the matrix of a Newton step bounds the loss of digits in solving \
                for the increment. Below it is given for the beam on a ball joint, straight and at rest, \
                in the writings that have been proposed for equations of index 3." }
            (self.writings())
            (table(&part(0..stiff), &html! { "Condition numbers in the 2-norm, E = 193×10⁹ Pa." }))
            (table(&part(stiff..all.rows.len()), &html! {
                "Condition numbers in the 2-norm, E = 193×10⁶ Pa as in section 3.3."
            }))
            (self.figure("conditioning", "Beyond the paper"))
        }
    }

    /// A line on each writing, with the factors at h = 1 ms.
    fn writings(&self) -> Markup {
        let at = |n: u32| self.results.conditioning.stiff.iter().find(|row| row.n == n && row.h == STEP);
        let (Some(one), Some(many)) = (at(1), at(20)) else { return html! {} };
        let better = |row: &Row, i: usize| significant(row.condition[0] / row.condition[i], 2);
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
                dd { "The paper's: " (better(one, 2)) " times better with one element, " (better(many, 2))
                    " with twenty. It helps by a constant factor and not against small steps: it grows \
                    like h⁻² as well." }
                dt { "Symmetric" }
                dd { "Constraint rows divided by βh² (Negrut et al. 2007): " (better(one, 3)) " and "
                    (better(many, 3)) " times better than DIM, and bounded as h → 0. It helps the more the \
                    smaller the step, but not at h = 10 ms with twenty elements, where the paper's writing \
                    is better." }
                dt { "Displacement" }
                dd { "Displacements as unknowns without scaling: the worst throughout, and up to h⁻⁴." }
                dt { "Bottasso" }
                dd { "That, scaled from both sides by powers of h (Bottasso, Dopico & Trainelli 2008): the \
                    symmetric matrix again, in other unknowns." }
                dt { "Equilibrated" }
                dd { "The symmetric one with a diagonal on both sides (Ruiz 2001): " (better(one, 6)) " \
                    and " (better(many, 6)) " times better than DIM; the same for every choice of units \
                    and slopes. The factorisation of this program is one whose rounding such a diagonal \
                    does not touch, so it is spared the choice." }
            }
        }
    }
}
