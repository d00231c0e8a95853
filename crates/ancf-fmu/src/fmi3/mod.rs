//! Functions of FMI 3.0 for co-simulation.

#![expect(unsafe_code, reason = "symbols of the standard")]

mod create;
mod state;
mod step;
mod typed;
mod unsupported;
