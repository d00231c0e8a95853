//! Joints, couplings, drives and mechanisms.

mod combinations;
mod diagnosis;
mod drives;
mod force_laws;
mod friction_of_slips;
mod generic;
mod kinds;
mod law_states;
mod mechanisms;
mod overconstrained;
mod reaction_friction;
mod redundancy;
mod section_compliance;
mod signals;
mod skew_axes;
mod sliding;
mod springs;
mod stops;
mod unlike_clamps;
