//! Elements of beams, cables and shells.

mod batches;
mod bonds;
mod cable;
mod continuum_energy;
mod damping_stresses;
mod formulations;
mod laminate_stresses;
mod laminates;
mod large_rotations;
mod membranes;
mod mesh_seams;
mod properties;
mod redundant_edges;
mod seam_motions;
mod seams;
mod shear_membranes;
mod shear_shells;
mod shell_fields;
mod shell_stresses;
mod shells;
mod shells_on_bodies;
mod spline_shells;
mod thick_bending;
mod wrong_fields;
