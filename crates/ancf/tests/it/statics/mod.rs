//! Static equilibria under load increments and along paths.

mod drives;
mod followers;
mod hanging_chains;
mod load_increments;
mod loads_on_joints;
mod paths;
mod pretensioned_lines;
mod rigid_bodies;
mod rigid_ends;
mod rotations;
mod slender;
mod truss;
mod unstable;
