//! Functions of FMI 2.0 for co-simulation.

#![expect(unsafe_code, reason = "symbols of the standard")]

mod create;
mod other;
mod step;
