//! Sections 3.2 and 3.3 of the paper.

use maud::{Markup, html};

use super::context::PageContext;
use super::markup::table;
use crate::cases::{PaperCase, published};
use crate::page::number::fixed;

pub(super) fn revolute(context: &PageContext<'_>) -> Markup {
    html! {
        p { "The same rod as one element, hinged at one end and released from the horizontal. The number of \
            iterations in Table 6 of the paper is the number of instants, including the first." }
        (table(&context.tables.table6, &html! {
            strong { "Table 6." } " The revolute pendulum of one element."
        }))
        p { "Here the non-dimensional form is slower, because it has three times as many steps of equal work. In the \
            paper it is faster, because the dimensional form needed many iterations: see \
            " a href="#iterations" { "the meaning of the iteration counts" } "."
            }
        (context.figure("fig7", "Figure 7"))
        (context.figure("fig8a", "Figure 8a"))
        (context.figure("fig8b", "Figure 8b"))
        (context.figure("fig9", "Figure 9"))
    }
}

pub(super) fn spherical(context: &PageContext<'_>) -> Markup {
    html! {
        p { "The rod on a spherical joint, a thousand times softer, with equal gravity along −y and −z." }
        (table(&context.tables.table7, &html! {
            strong { "Table 7." }
            " Analysis time of the spherical pendulum. The paper does not print this table."
        }))
        (fourfold(context))
        (context.figure("fig11", "Figure 11"))
        (context.figure("fig12a", "Figure 12a"))
        (context.figure("fig12b", "Figure 12b"))
        (context.figure("fig13a", "Figure 13a"))
        (context.figure("fig13b", "Figure 13b"))
    }
}

fn fourfold(context: &PageContext<'_>) -> Markup {
    let gain = context.largest(PaperCase::Spherical);
    let found = gain.total > published::TABLE_7_CLAIM;
    html! {
        p { "The paper states that at " (gain.n) " elements the non-dimensional form is \u{201c}more \
            than fourfold\u{201d} faster. We measure " (fixed(gain.total, 2)) @if !found { ", which does not confirm \
            the claim" } ". The longer step explains a factor of " (fixed(gain.longer_step, 2))
            "; the rest of a fourfold gain would require "
            (fixed(published::TABLE_7_CLAIM / gain.longer_step, 1)) " times as many iterations in the dimensional \
                form. Under our stopping rule both forms need the same number. Under an \
            absolute tolerance that many are possible, as Figure 7 shows, but the paper does not state \
            its tolerance, so the claim can be neither confirmed nor refuted." }
        p { "The time of the non-dimensional form does not tend to a constant. The number of steps is proportional to \
            1/√n, the time per step to n: the time grows like √n." }
    }
}
