//! Motions that a program advances step by step.

mod inputs;
mod linear_models;
mod states;
mod steps;
mod varying_steps;
