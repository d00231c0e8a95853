//! Joints, couplings, drives and mechanisms.

mod combinations;
mod diagnosis;
mod drives;
mod kinds;
mod mechanisms;
mod overconstrained;
mod redundancy;
mod sliding;
mod springs;
