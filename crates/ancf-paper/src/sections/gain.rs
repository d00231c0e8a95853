//! Gain and its factors.

use maud::{Markup, html};

use super::context::PageContext;
use super::markup::{between, table, unit};
use crate::cases::models::time_unit;
use crate::cases::{PaperCase, published};
use crate::page::number::{fixed, scientific};
use crate::results::Gain;

pub(super) fn section(context: &PageContext<'_>) -> Markup {
    html! {
        (own_step(context))
        (table(&context.tables.gain, &html! {
            "Each form with a step of 0.001 of its unit of time: total = number of steps × iterations per \
            step × time per iteration."
        }))
        (printed_factors(context))
        (same_step(context))
        (table(&context.tables.same_step, &html! { "Both forms with a physical step of 1 ms." }))
        p { "The longer step is not specific to the non-dimensional form: a user of the dimensional \
            one can choose it too. It reduces the accuracy, because the scheme is of first order." }
    }
}

fn own_step(context: &PageContext<'_>) -> Markup {
    let gain = context.largest(PaperCase::Cantilever);
    html! {
        p { "Both forms have a step of 0.001 in their own unit of time. For the dimensional form that is 1 ms; \
            for the non-dimensional one it is 0.001 " (unit("T")) " = 0.001 √(L n/g): "
            (fixed(time_unit(1), 2)) " ms with one element, " (fixed(time_unit(gain.n), 2)) " ms with \
            " (gain.n) ". So with " (gain.n) " elements it does " (fixed(gain.longer_step, 2)) " times \
            fewer steps, with one element " (fixed(1.0 / time_unit(1), 2)) " times more. A longer step \
            needs slightly more iterations, which reduces the gain." }
    }
}

fn printed_factors(context: &PageContext<'_>) -> Markup {
    let gain = context.largest(PaperCase::Cantilever);
    let total = published::printed_gain();
    let first = published::TABLE_4_DIM[0] / published::TABLE_4_NONDIM[0];
    html! {
        p { "The printed times contain the same factor: at " (gain.n) " elements its gain of "
            (fixed(total, 2)) " is " (fixed(gain.longer_step, 2)) " due to the step and "
            (fixed(total / gain.longer_step, 2)) " due to other causes; at one element a step took \
            " (fixed(time_unit(1) / first, 2)) " times as much in the non-dimensional form as in the \
            dimensional one." }
    }
}

fn same_step(context: &PageContext<'_>) -> Markup {
    let gains = &context.results.gain;
    let apart = gains.iter().map(|gain| gain.tip_difference).fold(0.0, f64::max);
    let equal = gains.iter().filter(|gain| gain.has_equal_iterations()).count();
    let mut ratios: Vec<f64> = gains.iter().map(|gain: &Gain| gain.same_step_total).collect();
    ratios.sort_by(f64::total_cmp);
    let middle = ratios.get(ratios.len() / 2).copied().unwrap_or(f64::NAN);
    html! {
        p { "With the same physical step of 1 ms the two forms are the same computation in other units. Their tips \
            differ by at most " (scientific(apart, 1)) " m at any instant of any run, the total number of iterations \
            is equal in " (equal) " of " (gains.len()) " cases, and the \
            ratio of their times is " (between(ratios.iter().copied(), |x| fixed(x, 2))) ", "
            (fixed(middle, 2)) " in the median: the scatter of the measurement about 1." }
    }
}
