//! Measurement of times, files, references.

use maud::{Markup, html};

use super::context::PageContext;

/// References of the text.
const REFERENCES: [&str; 4] = [
    "K.-W. Kim, J.-W. Lee, J.-S. Jang, J.-Y. Oh, J.-H. Kang, H.-R. Kim, W.-S. Yoo: Efficiency of \
     non-dimensional analysis for absolute nodal coordinate formulation. Nonlinear Dynamics 87 (2017), doi \
     10.1007/s11071-016-3104-7.",
    "C. L. Bottasso, D. Dopico, L. Trainelli: On the optimal scaling of index three DAEs in multibody \
     dynamics. Multibody System Dynamics 19 (2008) 3-20.",
    "D. Negrut, R. Rampalli, G. Ottarsson, A. Sajdak: On an implementation of the Hilber-Hughes-Taylor \
     method in the context of index 3 differential-algebraic equations of multibody dynamics. Journal of \
     Computational and Nonlinear Dynamics 2 (2007) 73-85.",
    "D. Ruiz: A scaling algorithm to equilibrate both rows and columns norms in matrices. Rutherford \
     Appleton Laboratory, RAL-TR-2001-034 (2001).",
];

pub(super) fn section(context: &PageContext<'_>) -> Markup {
    html! {
        p { "Every time is that of one complete simulation on one thread: check and assembly of the model, all steps, \
            all columns in memory. The forms of a problem alternate, so that a drift of the machine affects all \
            equally; " (repeats(context)) ". Times below a tenth of a \
            second scatter by several tens of per cent on a busy machine." }
        p { "Every figure is available as SVG and PNG, every table as CSV in full precision; "
            a href="results.json" { "results.json" } " contains all numbers. The command "
            code { "ancf paper" } " writes them again." }
        ul.references { @for reference in REFERENCES { li { (reference) } } }
    }
}

fn repeats(context: &PageContext<'_>) -> String {
    match context.results.repeats {
        0 | 1 => "each ran once".to_owned(),
        repeats => format!("the median of {repeats} repetitions is shown"),
    }
}
