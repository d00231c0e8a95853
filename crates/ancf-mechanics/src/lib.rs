//! Elements, constraints and forces of flexible multibody systems in the absolute nodal coordinate formulation (ANCF).
//!
//! Each of them is a [`Term`](ancf_solver::equations::Term) of the equations of motion. The crate `ancf` contains models,
//! units and results.

mod batch;
pub mod batches;
pub mod bodies;
pub mod constraints;
pub mod contact;
pub mod elements;
pub mod fluid;
pub mod forces;
pub mod functions;
pub mod inertia;
pub mod kinematics;
mod lanes;
pub mod laws;
pub mod rods;
pub mod sections;
pub mod shells;
