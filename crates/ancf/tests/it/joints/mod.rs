//! Joints, couplings and the mechanisms that they form.

mod combinations;
mod diagnosis;
mod drives;
mod kinds;
mod mechanisms;
mod overconstrained;
mod redundancy;
mod sliding;
mod springs;
