//! Batches of the terms of a system ([`Batch`](ancf_solver::equations::Batch)): elements, rigid bodies and joints.

mod bilinear_lanes;
mod entry_list;
mod joint_batch;
mod rigid_batch;
mod term_batches;

pub use term_batches::term_batches;
