//! Advice to the user after a failure.

use ancf_solver::eigen::EigenError;
use ancf_solver::equations::Inadmissibility;
use ancf_solver::newton::SolveFailure;

use crate::model::{Analysis, Dynamics, Statics, Step};

const FOR_SINGULAR: &str = "`ancf check`, which lists redundant joints and unsupported motions; mass for coordinates \
                            without mass";
const FOR_MEMORY: &str = "fewer elements, or a machine with more memory";
/// Advice after an inadmissible state.
const fn for_state(reason: Inadmissibility) -> &'static str {
    match reason {
        Inadmissibility::InvertedElement => {
            "more elements there and smaller steps; smaller loads on the section"
        }
        Inadmissibility::InvertedBody => "smaller steps; ramps instead of jumps of loads and drives",
        Inadmissibility::HalfTurn => {
            "smaller steps; ramps instead of jumps of loads and drives; a hinge in place of a bushing that turns by more than half a turn"
        }
        Inadmissibility::SliderEnd => {
            "a longer beam, or loads and drives with which the slider remains on it"
        }
        Inadmissibility::CoincidentEnds => {
            "other places of the ends of the spring, since its force has no direction there"
        }
        Inadmissibility::PressedThrough => FOR_CROSSED,
        Inadmissibility::EmptyVolume => {
            "smaller steps; surfaces that enclose the gas during the whole motion, with contact where they could pass through each other"
        }
    }
}

const FOR_CROSSED: &str = "a larger `stiffness` of the contact, or more contact `points` where an obstacle fits between two \
                           points; in statics smaller loads, or \"dynamics\" with damping; in dynamics a smaller step";
const FOR_ENERGY: &str = "a shorter `analysis.step`; a smaller `spectral_radius` in `analysis.scheme`, such as 0.5, which is stable \
                          for fast rotations; a larger `analysis.energy_guard.gain` if this error is acceptable";
const FOR_TURNS: &str = "a shorter `analysis.step`; ramps instead of jumps of drives and moments";

/// Advice after a failed iteration.
pub(crate) fn advice_for_iteration(failure: SolveFailure, analysis: &Analysis) -> String {
    match (failure, analysis) {
        (SolveFailure::Singular, _) => FOR_SINGULAR.into(),
        (SolveFailure::Memory, _) => FOR_MEMORY.into(),
        (SolveFailure::Inadmissible(reason), _) => for_state(reason).into(),
        (SolveFailure::EnergyMade, _) => FOR_ENERGY.into(),
        (SolveFailure::AmbiguousTurns, _) => FOR_TURNS.into(),
        (SolveFailure::StepTooSmall, _) => {
            "a larger `step.tolerance`; ramps instead of jumps of loads and drives; softer or damped contacts; a \
             scheme with numerical damping, such as `scheme = { spectral_radius = 0.6 }`"
                .into()
        }
        (SolveFailure::Crossed, _) => FOR_CROSSED.into(),
        (SolveFailure::Unstable, Analysis::Statics(_)) => {
            "`unstable = \"leave\"` for the stable branch, or `unstable = \"follow\"` for the unstable one; an analysis of \
             kind \"buckling\" for the critical load"
                .into()
        }
        (_, Analysis::Dynamics(settings)) => for_steps(settings),
        (_, Analysis::Path(_)) => "a smaller `analysis.largest`, a smaller `analysis.first` if the first step fails, \
                                   or more `analysis.max_iterations`; a small imperfection where paths cross"
            .into(),
        _ => "an analysis of kind \"path\", which passes limit points, or \"dynamics\" with damping, which computes \
              the motion after snap-through; a smaller `analysis.first`; more `analysis.max_iterations` if there are few; more elements at the \
              largest curvature"
            .into(),
    }
}

/// Advice after a failed search for the equilibrium at the start of a motion.
pub(crate) fn advice_for_start(failure: SolveFailure) -> String {
    match failure {
        SolveFailure::Singular
        | SolveFailure::Memory
        | SolveFailure::Inadmissible(_)
        | SolveFailure::Crossed
        | SolveFailure::Unstable => advice_for_iteration(failure, &Analysis::Statics(Statics::default())),
        _ => "a smaller `initial.statics.first`; a start in the undeformed state with loads that increase slowly, and damping; \
              an analysis of kind \"statics\" of the same model, which records the equilibria up to the failure"
            .into(),
    }
}

/// Advice after time steps without convergence.
fn for_steps(settings: &Dynamics) -> String {
    let steps = match settings.step {
        Step::Fixed(_) => {
            "a shorter `analysis.step`, or steps by error control: `step = { tolerance = 1e-3 }` with \
                           `scheme = { spectral_radius = 0.8 }`"
        }
        Step::Adaptive { .. } => "a smaller `step.largest`, or steps of constant size",
    };
    format!(
        "{steps}; ramps instead of jumps of loads and drives; material damping; a check for a dead point of a linkage; \
         a check of the units, since loads far above the strength of a section have this effect"
    )
}

/// Advice after a failed eigenvalue search.
pub(crate) const fn advice_for_eigen(error: EigenError) -> &'static str {
    match error {
        EigenError::Singular => FOR_SINGULAR,
        EigenError::Indefinite => {
            "smaller loads, for which the reference state of the modes is stable, or `about = \"reference\"`"
        }
        EigenError::Nonconservative => {
            "modes with `about = \"equilibrium\"` under several loads: flutter begins where two frequencies meet; loads of \
             fixed direction have critical loads, and so has a constant pressure between held edges as a `gas` with `exponent = 0`; fewer \
             loads without a potential if this is an analysis of modes"
        }
        EigenError::Gyroscopic => "modes with `damped = true`, which include gyroscopic forces",
        EigenError::NotDifferentiable => {
            "a state away from the opening and closing of contacts, without dry friction, and forces of programs with a symmetric \
             derivative by the velocity"
        }
        EigenError::NotConverged => {
            "a smaller `analysis.count`; more elements, or fewer if the elements are thousands, since the rounding error \
             of the stiffness grows with the fourth power of their number"
        }
        EigenError::Unresolved => {
            "joints or springs that support the motion, such as the rotation of a rigid body about its axis; fewer elements if they are \
             thousands"
        }
        EigenError::Missed => "another `analysis.count`; fewer elements if the elements are thousands",
        EigenError::Interrupted => "nothing: the analysis was interrupted on request",
    }
}

/// Advice for models with unsupported motions.
pub(crate) const ADVICE_FOR_MECHANISMS: &str = "joints, springs or stiffness that support the motion (contacts alone do not, but with a \
     weak spring), or an analysis of kind \"dynamics\", which permits it; `ancf check` lists free motions";
/// Advice for models with unsupported motions that start from an equilibrium.
pub(crate) const ADVICE_FOR_MECHANISMS_AT_START: &str = "joints, springs or stiffness that support the motion (contacts alone do not, but with a \
     weak spring), or a start in the undeformed state; `ancf check` lists free motions";
