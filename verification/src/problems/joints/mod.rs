//! Each kind of joint, drive, spring, friction and coupling.

mod elastic;
mod rotation;
mod translation;
mod transmission;

use crate::Problem;

/// Problems of joints.
pub(super) const FAMILIES: [&[Problem]; 4] =
    [rotation::PROBLEMS, translation::PROBLEMS, elastic::PROBLEMS, transmission::PROBLEMS];
