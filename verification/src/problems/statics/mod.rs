//! Equilibria of beams and cables.

pub(super) mod bathe_bolourchi;
pub(super) mod beams;
pub(super) mod catenary;
pub(super) mod curved;
pub(super) mod elastica;
pub(super) mod gerstmayr_irschik;
pub(super) mod heavy_elastica;
pub(super) mod invariance;
pub(super) mod princeton;
pub(super) mod roll_up;
