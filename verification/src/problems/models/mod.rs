//! Models that several problems share.

mod blocks;
mod cantilever;
mod study;

pub(super) use blocks::{
    ROD, Rod, cantilever, clamp, clamped, clamped_section, end_probe, hinge, joint, tip_load,
};
pub(super) use cantilever::{Cantilever, KIM, KIM_AREA, KIM_BENDING, KIM_BY_NUMBERS};
pub(super) use study::{Convergence, study};
