//! Motions, natural frequencies and integration schemes.

pub(super) mod compound_pendulum;
pub(super) mod flying_spaghetti;
pub(super) mod frequencies;
mod instants;
pub(super) mod integrators;
mod motion;
pub(super) mod right_angle_frame;
pub(super) mod slider_crank;
pub(super) mod spin_up;
pub(super) mod spinning_rod;
