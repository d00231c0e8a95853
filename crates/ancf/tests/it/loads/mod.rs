//! Loads and functions of time.

mod base_rotation;
mod fluid;
mod functions;
mod line_loads;
mod moments;
mod prestrain;
mod supplied;
mod variations;
