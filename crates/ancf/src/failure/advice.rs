//! What to try after a failure.

use ancf_solver::eigen::EigenError;
use ancf_solver::newton::SolveFailure;

use crate::model::{Analysis, Dynamics, Step};

const OF_SINGULAR: &str = "`ancf check`, which lists joints that repeat each other and motions that nothing holds; mass for \
                           what moves without";
const OF_MEMORY: &str = "fewer elements, or a machine with more memory";
const OF_INVERTED: &str = "more elements there and smaller steps; loads that the section bears; for a slider, whether it \
                           reaches the end of its beam, for a spring, whether its ends meet";

/// What to try after an iteration failed.
pub(crate) fn after(failure: SolveFailure, analysis: &Analysis) -> String {
    match (failure, analysis) {
        (SolveFailure::Singular, _) => OF_SINGULAR.into(),
        (SolveFailure::Memory, _) => OF_MEMORY.into(),
        (SolveFailure::Inverted, _) => OF_INVERTED.into(),
        (SolveFailure::StepTooSmall, _) => "a larger `step.tolerance`; ramps in the place of jumps of loads and drives; softer \
                                       or damped contacts; a scheme that damps, such as `scheme = { spectral_radius = 0.6 }`"
            .into(),
        (_, Analysis::Dynamics(settings)) => of_motion(settings),
        (_, Analysis::Path(_)) => "a smaller `analysis.largest`, a smaller `analysis.first` if the path does not begin, \
                                   or more `analysis.max_iterations`; a small imperfection where paths cross"
            .into(),
        _ => "an analysis of kind \"path\", which goes through limit points, or \"dynamics\" with damping, which shows \
              where it jumps to; a smaller `analysis.first`; more elements where it bends most"
            .into(),
    }
}

/// After steps that do not converge.
fn of_motion(settings: &Dynamics) -> String {
    let steps = match settings.step {
        Step::Fixed(_) => {
            "a shorter `analysis.step`, or steps by error control: `step = { tolerance = 1e-3 }` with \
                           `scheme = { spectral_radius = 0.8 }`"
        }
        Step::Adaptive { .. } => "a smaller `step.largest`, or steps of one size",
    };
    format!(
        "{steps}; ramps in the place of jumps of loads and drives; damping of the material; a look whether a linkage \
         comes to a dead point, and at units: loads beyond what a section bears do this"
    )
}

/// What to try after a search for eigenvalues failed.
pub(crate) const fn after_search(error: EigenError) -> &'static str {
    match error {
        EigenError::Singular => OF_SINGULAR,
        EigenError::Indefinite => {
            "loads that do not buckle the state about which modes are found, or `about = \"reference\"`"
        }
        EigenError::NotConverged => "fewer of them (`analysis.count`), or more elements",
        EigenError::Interrupted => "nothing: it was asked to stop",
    }
}

/// What to try if nothing holds a motion.
pub(crate) const OF_MECHANISMS: &str = "joints, springs or stiffness that hold it, or an analysis of kind \"dynamics\", in \
                                        which it may move; `ancf check` lists what is free";
