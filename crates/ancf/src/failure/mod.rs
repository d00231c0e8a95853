//! Causes of failed iterations, loss of stability, and advice to the user.

mod advice;
mod alternation_monitor;
mod cause;
mod equilibrium_stability;
mod prebuckling;
mod rotation_monitor;
mod stability;
mod stability_monitor;

pub(crate) use advice::{ADVICE_FOR_MECHANISMS, advice_for_eigen, advice_for_iteration};
pub(crate) use alternation_monitor::{AlternationHistory, AlternationMonitor};
pub(crate) use cause::{FailureCause, FailurePlace, find_cause};
pub(crate) use equilibrium_stability::EquilibriumStability;
pub(crate) use prebuckling::prebuckling_warning;
pub(crate) use rotation_monitor::{RotationHistory, RotationMonitor};
pub(crate) use stability::unloaded;
pub(crate) use stability_monitor::StabilityMonitor;
