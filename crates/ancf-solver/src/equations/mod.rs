//! Equations of motion as a sum of terms: states, local terms and the assembled system.

mod batch;
mod contact_pairs;
mod dependence;
mod energy;
mod motion_equations;
mod scatter;
mod state;
mod stiffness_products;
mod system;
mod term;
mod term_sums;
mod thread_parts;

pub use batch::{Batch, LANES, Lanes, LocalLanes};
pub use contact_pairs::{ActiveGroup, ActivePair, ContactGroup, ContactPair, ContactSearch, active_terms};
pub use dependence::{Dependence, REDUNDANCY_TOLERANCE, all_constraint_rows, constraint_rows, dependences};
pub use energy::{Energy, Level, Power};
pub use motion_equations::EquationsOfMotion;
pub use scatter::Scatter;
pub use state::{Inadmissibility, State, StepStates, Weights};
pub use stiffness_products::StiffnessProducts;
pub use system::System;
pub use term::{
    LOCAL, Local, LocalMatrix, LocalStep, Term, correct_work, discrete_residual, load_power, middle_residual,
    quadratic_constraints, velocity_forces,
};
pub use term_sums::Rotation;
