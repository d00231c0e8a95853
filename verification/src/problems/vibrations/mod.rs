//! Natural frequencies of beams, shafts and cables, damped modes of rotors.

mod beams;
mod rotors;
mod shafts;

use crate::Problem;

/// Problems of vibrations.
pub(super) const FAMILIES: [&[Problem]; 3] = [beams::PROBLEMS, shafts::PROBLEMS, rotors::PROBLEMS];
