//! Beam and cable elements.

mod batches;
mod cable;
mod continuum_energy;
mod formulations;
mod large_rotations;
mod properties;
mod thick_bending;
