//! Properties of all terms of the equations of motion.

mod cases;
mod constraints;
mod contacts;
mod frames;
mod gases;
mod immersed;
mod joint_terms;
mod kind;
mod laws;
mod magnet;
mod omitted;
mod shear_shells;
mod shell_prestrains;
mod shells;
mod steps;
mod stress_prediction;
mod stress_stiffness;
mod surface_flows;
