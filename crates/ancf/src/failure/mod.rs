//! Causes of failed iterations, loss of stability, and advice to the user.

mod advice;
mod alternation_monitor;
mod cause;
mod equilibrium_stability;
mod prebuckling;
mod rotation_monitor;
mod run_failure;
mod stability;
mod stability_monitor;
mod unsupported;

pub(crate) use advice::{
    ADVICE_FOR_MECHANISMS, ADVICE_FOR_MECHANISMS_AT_START, advice_for_eigen, advice_for_iteration,
    advice_for_start,
};
pub(crate) use alternation_monitor::{AlternationHistory, AlternationMonitor};
pub(crate) use cause::{FailureCause, FailurePlace, find_cause};
pub(crate) use equilibrium_stability::EquilibriumStability;
pub(crate) use prebuckling::prebuckling_warning;
pub(crate) use rotation_monitor::{RotationHistory, RotationMonitor};
pub(crate) use run_failure::RunFailure;
pub(crate) use stability::{instability, unloaded};
pub(crate) use stability_monitor::StabilityMonitor;
pub(crate) use unsupported::require_support;
