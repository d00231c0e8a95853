//! Motions that a program advances step by step.

mod inputs;
mod states;
mod steps;
