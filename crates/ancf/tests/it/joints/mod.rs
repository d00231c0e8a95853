//! Joints, couplings, drives and mechanisms.

mod combinations;
mod diagnosis;
mod drives;
mod kinds;
mod mechanisms;
mod overconstrained;
mod redundancy;
mod section_compliance;
mod skew_axes;
mod sliding;
mod springs;
mod unlike_clamps;
