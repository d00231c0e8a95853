//! Loads and functions of time.

mod base_rotation;
mod ends_of_motions;
mod fluid;
mod functions;
mod gases;
mod line_loads;
mod moments;
mod prestrain;
mod shell_fluids;
mod shell_prestrains;
mod skew_ratios;
mod strained_membranes;
mod supplied;
mod variations;
mod warm_curved_shells;
