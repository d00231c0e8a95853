//! Elements of beams, cables and shells.

mod batches;
mod cable;
mod continuum_energy;
mod formulations;
mod laminate_stresses;
mod laminates;
mod large_rotations;
mod properties;
mod shell_stresses;
mod shells;
mod thick_bending;
