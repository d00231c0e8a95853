//! Static equilibria and their paths.

mod load_increments;
mod paths;
mod truss;
