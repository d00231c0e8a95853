//! Resolution of functions of time by steps: unresolved variations, and times at which formulas jump or have a kink.

mod peak;
mod step_resolution;
mod switches;
