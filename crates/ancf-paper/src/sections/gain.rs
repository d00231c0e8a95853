//! The gain and its factors.

use maud::{Markup, html};

use super::{Report, between, table, unit};
use crate::paper::cases::time_unit;
use crate::paper::published;
use crate::paper::results::{Gain, Problem};
use crate::report::number::{fixed, scientific};

impl Report<'_> {
    pub(super) fn gain(&self) -> Markup {
        html! {
            (self.own_step())
            (table(&self.tables.gain, &html! {
                "Each form with 0.001 of its own unit of time: total = number of steps × iterations per \
                step × time per iteration."
            }))
            (self.printed_factors())
            (self.same_step())
            (table(&self.tables.same_step, &html! { "Both forms with a physical step of 1 ms." }))
            p { "The longer step is no privilege of the non-dimensional form: a user of the dimensional \
                one may ask for it. It has its price in accuracy, since the scheme is of first order." }
        }
    }

    fn own_step(&self) -> Markup {
        let gain = self.largest(Problem::Cantilever);
        html! {
            p { "Both forms take a step of 0.001 in their own time. For the dimensional form that is 1 ms; \
                for the non-dimensional one it is 0.001 " (unit("T")) " = 0.001 √(L n/g): "
                (fixed(time_unit(1), 2)) " ms with one element, " (fixed(time_unit(gain.n), 2)) " ms with \
                " (gain.n) ". So with " (gain.n) " elements it does " (fixed(gain.longer_step, 2)) " times \
                fewer steps, with one element " (fixed(1.0 / time_unit(1), 2)) " times more. A longer step \
                needs slightly more iterations, which takes part of the gain back." }
        }
    }

    fn printed_factors(&self) -> Markup {
        let gain = self.largest(Problem::Cantilever);
        let total = self.printed_gain();
        let first = published::TABLE_4_DIM[0] / published::TABLE_4_NONDIM[0];
        html! {
            p { "The paper's own times hold the same factor: at " (gain.n) " elements its gain of "
                (fixed(total, 2)) " is " (fixed(gain.longer_step, 2)) " from the step and "
                (fixed(total / gain.longer_step, 2)) " from everything else; at one element a step cost it \
                " (fixed(time_unit(1) / first, 2)) " times as much in the non-dimensional form as in the \
                dimensional one." }
        }
    }

    fn same_step(&self) -> Markup {
        let gains = &self.results.gain;
        let apart = gains.iter().map(|gain| gain.tip_difference).fold(0.0, f64::max);
        let equal = gains.iter().filter(|gain| gain.has_equal_iterations()).count();
        let mut ratios: Vec<f64> = gains.iter().map(|gain: &Gain| gain.same_step_total).collect();
        ratios.sort_by(f64::total_cmp);
        let middle = ratios.get(ratios.len() / 2).copied().unwrap_or(f64::NAN);
        html! {
            p { "With the same physical step of 1 ms the two forms are the same computation in other \
                numbers. Their tips are at most " (scientific(apart, 1)) " m apart at any instant of any \
                run, the total of iterations is equal in " (equal) " of " (gains.len()) " cases, and the \
                ratio of their times is " (between(ratios.iter().copied(), |x| fixed(x, 2))) ", "
                (fixed(middle, 2)) " in the middle: the scatter of the clock about 1." }
        }
    }
}
