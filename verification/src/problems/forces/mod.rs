//! Contact, damping, fluids and transient loads.

mod contact;
mod resistance;
mod transient;

use crate::Problem;

/// Problems of forces.
pub(super) const FAMILIES: [&[Problem]; 3] = [contact::PROBLEMS, resistance::PROBLEMS, transient::PROBLEMS];
