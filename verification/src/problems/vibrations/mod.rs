//! Natural frequencies of beams, shafts and cables.

mod beams;
mod shafts;

use crate::Problem;

/// Problems of vibrations.
pub(super) const FAMILIES: [&[Problem]; 2] = [beams::PROBLEMS, shafts::PROBLEMS];
