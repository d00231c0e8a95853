//! Invariance of results: units, scales, frames of reference, order of bodies, threads.

mod chains;
mod order;
mod random_models;
mod reference_length;
mod threads;
mod units_and_frames;
