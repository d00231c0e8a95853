//! Results do not depend on units, frames, order or threads.

mod chains;
mod order;
mod random_models;
mod threads;
mod units_and_frames;
